/* confined.c - readers that hang, crash or take all memory end in one line. */
#include "formats/confined.h"
#include "files.h"
#include "util/error.h"

#include <signal.h>
#include <stdio.h>
#include <sys/resource.h>

static bool give_facet(sepax_soup *mesh, const char *at, sepax_error *error) {
  (void)at;
  (void)error;
  mesh->facet = calloc(2, sizeof *mesh->facet);
  mesh->count = mesh->facet != NULL ? 2 : 0;
  if (mesh->facet != NULL) {
    mesh->facet[1].v[2][1] = 7;
  }
  return mesh->facet != NULL;
}

static bool give_nothing(sepax_soup *mesh, const char *at, sepax_error *error) {
  (void)mesh;
  fputs("this is not to be seen\n", stderr);
  return sepax_fail(error, SEPAX_ERROR_FORMAT, "%s: not this one", at);
}

/* Where it is given five seconds, it runs for one, without an end. */
static bool run_forever(sepax_soup *mesh, const char *at, sepax_error *error) {
  volatile size_t turns = 0;
  struct rlimit given;
  (void)at;
  (void)error;
  if (getrlimit(RLIMIT_CPU, &given) != 0 || given.rlim_cur != 5) {
    return true;
  }
  given.rlim_cur = 1;
  setrlimit(RLIMIT_CPU, &given);
  while (mesh->count == 0) {
    turns = turns + 1;
  }
  return true;
}

static bool crash(sepax_soup *mesh, const char *at, sepax_error *error) {
  (void)mesh;
  (void)at;
  (void)error;
  return raise(SIGKILL) != 0;
}

#if !defined(__SANITIZE_ADDRESS__)
static bool take_all(sepax_soup *mesh, const char *at, sepax_error *error) {
  (void)error;
  for (size_t n = 0; n < 64; n++) {
    char *part = malloc((size_t)1 << 30);
    if (part == NULL) {
      abort();
    }
    part[strlen(at)] = 1;
    mesh->count += (size_t)part[strlen(at)];
  }
  return false;
}
#endif

CASE(test_confined) {
  sepax_soup mesh;
  const char *file = put_file("p.obj", "v 0 0 0\n");
  assert_works(confined_read(&mesh, file, give_facet, &fault));
  assert_int_equal(mesh.count, 2);
  assert_true(mesh.facet[1].v[2][1] == 7);
  sepax_soup_free(&mesh);
  assert_fault(confined_read(&mesh, file, give_nothing, &fault), "p.obj: not this one");
  assert_fault(confined_read(&mesh, file, crash, &fault), "p.obj: its reader took too long");
  assert_fault(confined_read(&mesh, file, run_forever, &fault), "p.obj: its reader took too long");
#if !defined(__SANITIZE_ADDRESS__)
  assert_fault(confined_read(&mesh, file, take_all, &fault), "too much memory");
#endif
  assert_fault(confined_read(&mesh, folder, give_facet, &fault), "no file, or empty");
  assert_null(mesh.facet);
}
