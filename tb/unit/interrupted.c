/* SPDX-License-Identifier: MIT */
/* interrupted.c - a signal that ends a program leaves no half-written file. */
#include "harness.h"
#include "util/temporary.h"
#include "util/write_file.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

/* Write something and be interrupted: by a signal, or not by 0. */
static bool write_half(FILE *out, const void *context) {
  const int *number = context;
  fputs("half", out);
  fflush(out);
  if (*number != 0) {
    raise(*number);
  }
  return true;
}

/* How a process ends that is interrupted while it writes. */
static int end_of(int number, bool program) {
  pid_t child = fork();
  assert_true(child >= 0);
  if (child == 0) {
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    for (int i = 0; i < 3; i++) { /* a process in the background begins with some ignored */
      signal(signals[i], SIG_DFL);
    }
    if (program) {
      sepax__temporary_remove_on_signals();
    }
    _exit(sepax_write_file(path, write_half, &number, &fault) ? 0 : 1);
  }
  int status = 0;
  assert_int_equal(waitpid(child, &status, 0), child);
  char command[PATH_BYTES + 50];
  snprintf(command, sizeof command, "ls %s.tmp.%ld.* > /dev/null 2>&1", path, (long)child);
  assert_int_equal(system(command) == 0, number != 0 && !program);
  return status;
}

CASE(test_signals) {
  static const int number[] = {SIGINT, SIGTERM, SIGHUP};
  for (int i = 0; i < 3; i++) {
    int status = end_of(number[i], true);
    assert_true(WIFSIGNALED(status));
    assert_int_equal(WTERMSIG(status), number[i]);
    assert_int_equal(access(path, F_OK), -1);
  }
  end_of(SIGTERM, false); /* the library leaves signals alone */
  assert_int_equal(end_of(0, true), 0);
  assert_int_equal(access(path, F_OK), 0);
}

/* A second signal, as `timeout` and an impatient user send it, comes when the first is on its way:
 * on another processor than the program's, at any time in what the first does. */
CASE(test_two_signals) {
  for (int round = 0; round < FEWER(4000); round++) {
    int ready[2];
    unlink(path);
    assert_int_equal(pipe(ready), 0);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
      signal(SIGINT, SIG_DFL);
      sepax__temporary_remove_on_signals();
      int ticket;
      FILE *out = sepax__temporary_create(path, &ticket);
      if (out == NULL || write(ready[1], "", 1) != 1) {
        _exit(1);
      }
      for (volatile int busy = 0;; busy++) {}
    }
    char byte;
    close(ready[1]);
    assert_int_equal(read(ready[0], &byte, 1), 1);
    close(ready[0]);
    for (volatile int wait = 0; wait < round % 1000; wait++) {}
    assert_int_equal(kill(child, SIGINT), 0);
    kill(child, SIGINT);
    int status = 0;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status));
    assert_int_equal(WTERMSIG(status), SIGINT);
    assert_int_equal(access(path, F_OK), -1);
  }
}

/* More files than tickets are still written. */
CASE(test_tickets) {
  int ticket[300];
  for (int i = 0; i < 300; i++) {
    ticket[i] = sepax__temporary_add("build/test/no-such-file");
  }
  assert_int_equal(ticket[0], 0);
  assert_int_equal(ticket[299], -1);
  for (int i = 0; i < 300; i++) {
    sepax__temporary_drop(ticket[i]);
  }
  assert_int_equal(sepax__temporary_add("build/test/no-such-file"), 0);
  sepax__temporary_drop(0);
}
