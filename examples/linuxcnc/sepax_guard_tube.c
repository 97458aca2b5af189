/* SPDX-License-Identifier: MIT */
/* sepax_guard_tube.c - gives a tube to the guard in a running LinuxCNC:
 *   sepax_guard_tube PART.tube     from now on the program may move in this tube
 *   sepax_guard_tube --none        there is no tube
 * Exit status 0; or 2 after one line of why, and the guard then has no tube. */
#include "tube.h"

#include <hal.h>
#include <rtapi.h>
#include <stdio.h>
#include <string.h>

static int component, memory = -1;

static int finish(int status) {
  if (memory >= 0) {
    rtapi_shmem_delete(memory, component);
  }
  if (component >= 0) {
    hal_exit(component);
  }
  return status;
}

static int complain(const char *text) {
  fprintf(stderr, "sepax_guard_tube: %s\n", text);
  return finish(2);
}

int main(int count, char **argument) {
  char text[TUBE_TEXT] = "";
  void *at = NULL;
  tube *t;
  if (count != 2 || strcmp(argument[1], "--help") == 0) {
    fputs("Usage: sepax_guard_tube PART.tube (a file of sepax path --tube), or --none\n", stderr);
    return 2;
  }
  component = hal_init("sepax_guard_tube");
  if (component < 0) {
    return complain("LinuxCNC does not run");
  }
  hal_ready(component);
  memory = rtapi_shmem_new(TUBE_KEY, component, sizeof *t);
  if (memory < 0 || rtapi_shmem_getptr(memory, &at) < 0) {
    return complain("the guard's memory cannot be reached; is this the user of LinuxCNC?");
  }
  t = at;
  if (t->magic != TUBE_MAGIC) {
    return complain("sepax_guard is not loaded, or with tube_rows=0");
  }
  if (strcmp(argument[1], "--none") == 0) {
    tube_clear(t);
    puts("no tube");
    return finish(0);
  }
  if (!tube_read(t, argument[1], text)) {
    return complain(text);
  }
  printf("%s: %llu rows, clearance %g mm\n", argument[1], (unsigned long long)t->rows,
         t->free_of * 1e3);
  return finish(0);
}
