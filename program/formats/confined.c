/* confined.c - readers in a process of their own, of limited memory and time. */
#include "formats/confined.h"
#include "util/error.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* What the process leaves in its file, in front of the facets. */
typedef struct {
  size_t count; /* 0: it failed, and why is in the error */
  sepax_error error;
} result;

bool confined_size(const char *path, size_t *bytes, sepax_error *error) {
  struct stat s;
  if (stat(path, &s) != 0) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: %s; give a readable file", path,
                      strerror(errno));
  }
  if (!S_ISREG(s.st_mode) || s.st_size == 0) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.300s: no file, or empty; give a mesh", path);
  }
  *bytes = (size_t)s.st_size;
  return *bytes <= CONFINED_BYTES_MOST ||
         sepax_fail(error, SEPAX_ERROR_FORMAT, "%.300s: longer than 1 GiB; simplify the mesh",
                    path);
}

/* Five seconds and two for each MiB; 2 GiB and 100 bytes for each byte. A sanitizer maps more. */
static void confine(size_t bytes) {
  rlim_t seconds = 5 + 2 * (rlim_t)(bytes >> 20);
  struct rlimit time = {seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &time);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(UNLIMITED)
  rlim_t space = ((rlim_t)2 << 30) + 100 * (rlim_t)bytes;
  struct rlimit memory = {space, space};
  setrlimit(RLIMIT_AS, &memory);
#endif
  struct rlimit none = {0, 0};
  setrlimit(RLIMIT_CORE, &none);
}

static bool put_result(FILE *channel, const result *r, const sepax_soup *mesh) {
  return fwrite(r, sizeof *r, 1, channel) == 1 &&
         (r->count == 0 ||
          fwrite(mesh->facet, sizeof *mesh->facet, r->count, channel) == r->count) &&
         fflush(channel) == 0;
}

static bool take_result(FILE *channel, const char *path, sepax_soup *mesh, sepax_error *error) {
  result r;
  rewind(channel);
  if (fread(&r, sizeof r, 1, channel) != 1) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.300s: its reader left nothing; export it again",
                      path);
  }
  if (r.count == 0) {
    *error = r.error;
    return false;
  }
  mesh->facet = sepax_allocate(r.count * sizeof *mesh->facet);
  if (mesh->facet == NULL || fread(mesh->facet, sizeof *mesh->facet, r.count, channel) != r.count) {
    sepax_soup_free(mesh);
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "%.300s: no memory for %zu triangles", path,
                      r.count);
  }
  mesh->count = r.count;
  return true;
}

bool confined_read(sepax_soup *mesh, const char *path,
                   bool (*read)(sepax_soup *mesh, const char *path, sepax_error *error),
                   sepax_error *error) {
  size_t bytes = 0;
  *mesh = (sepax_soup){0};
  if (!confined_size(path, &bytes, error)) {
    return false;
  }
  FILE *channel = tmpfile();
  fflush(stdout);
  pid_t child = channel != NULL ? fork() : -1;
  if (child == 0) {
    result r = {.count = 0};
    confine(bytes);
    bool silent =
        freopen("/dev/null", "w", stderr) != NULL; /* what the reader has to say to itself */
    r.count = silent && read(mesh, path, &r.error) ? mesh->count : 0;
    _exit(put_result(channel, &r, mesh) ? 0 : 1);
  }
  int status = 0;
  bool ended = child > 0;
  while (ended && waitpid(child, &status, 0) < 0) {
    ended = errno == EINTR;
  }
  bool ok = ended ? (WIFEXITED(status) && WEXITSTATUS(status) == 0) ||
                        sepax_fail(error, SEPAX_ERROR_FORMAT,
                                   "%.300s: its reader took too long, or too much memory, or "
                                   "failed; export it again",
                                   path)
                  : sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: no process to read it: %s", path,
                               strerror(errno));
  ok = ok && take_result(channel, path, mesh, error);
  if (channel != NULL) {
    fclose(channel);
  }
  return ok;
}
