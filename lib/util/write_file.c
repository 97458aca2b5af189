/* SPDX-License-Identifier: MIT */
/* write_file.c - files that are whole or not there. */
#include "write_file.h"

#include "error.h"
#include "temporary.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Create a new file beside `path`, with the permissions of any new file; its name
 * is left in aside[size]. */
static FILE *open_aside(char *aside, size_t size, const char *path, int *ticket) {
  FILE *out = NULL;
  errno = EEXIST;
  for (int i = 0; out == NULL && errno == EEXIST && i < 1000; i++) {
    snprintf(aside, size, "%s.tmp.%ld.%d", path, (long)getpid(), i);
    out = sepax__temporary_create(aside, ticket);
  }
  return out;
}

/* On failure errno tells why. */
static bool finish(FILE *out, bool ok, const char *aside, const char *path) {
  ok = ok && fflush(out) == 0;
  int reason = errno;
  bool closed = fclose(out) == 0;
  if (ok) {
    ok = closed && rename(aside, path) == 0;
    reason = errno;
  }
  if (!ok) {
    unlink(aside);
  }
  errno = reason;
  return ok;
}

static bool fail_writing(const char *path, sepax_error *error) {
  return sepax_fail(error, SEPAX_ERROR_FILE,
                    "%.300s: not written: %s; check the folder and its free space", path,
                    strerror(errno));
}

/* What stands in its place is a file, or nothing. */
static bool is_free(const char *path, sepax_error *error) {
  struct stat status;
  return stat(path, &status) != 0 || S_ISREG(status.st_mode) ||
         sepax_fail(error, SEPAX_ERROR_FILE,
                    "%.300s: not written: exists and is no file; name another", path);
}

/* Without `write` the file aside is made and removed. */
static bool write_aside(const char *path, bool (*write)(FILE *out, const void *context),
                        const void *context, sepax_error *error) {
  if (!is_free(path, error)) {
    return false;
  }
  size_t size = strlen(path) + 64;
  char *aside = sepax_allocate(size);
  int ticket = -1;
  FILE *out = aside == NULL ? NULL : open_aside(aside, size, path, &ticket);
  bool ok = out != NULL;
  if (ok && write == NULL) {
    fclose(out);
    unlink(aside);
  } else if (ok) {
    ok = finish(out, write(out, context), aside, path);
  }
  int reason = errno;
  sepax__temporary_drop(ticket);
  errno = reason;
  if (!ok) {
    fail_writing(path, error);
  }
  sepax_release(aside);
  return ok;
}

bool sepax__write_file_possible(const char *path, sepax_error *error) {
  return write_aside(path, NULL, NULL, error);
}

bool sepax_write_file(const char *path, bool (*write)(FILE *out, const void *context),
                      const void *context, sepax_error *error) {
  return write_aside(path, write, context, error);
}
