/* SPDX-License-Identifier: MIT */
/* temporary.c - a signal's handler reads the paths, so each stands in an atomic pointer. */
#include "temporary.h"
#include "sepax.h"

#include <errno.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { TICKETS = 256 };

static _Atomic(char *) under_way[TICKETS];

int sepax__temporary_add(const char *path) {
  size_t bytes = strlen(path) + 1;
  char *copy = sepax_allocate(bytes);
  if (copy != NULL) {
    memcpy(copy, path, bytes);
  }
  for (int i = 0; copy != NULL && i < TICKETS; i++) {
    char *none = NULL;
    if (atomic_compare_exchange_strong(&under_way[i], &none, copy)) {
      return i;
    }
  }
  sepax_release(copy);
  return -1;
}

static const int ends[] = {SIGINT, SIGTERM, SIGHUP};
enum { ENDS = sizeof ends / sizeof ends[0] };

FILE *sepax__temporary_create(const char *path, int *ticket) {
  sigset_t block;
  sigset_t before;
  sigemptyset(&block);
  for (int i = 0; i < ENDS; i++) {
    sigaddset(&block, ends[i]);
  }
  pthread_sigmask(SIG_BLOCK, &block, &before);
  FILE *out = fopen(path, "wbx");
  int reason = errno;
  *ticket = out != NULL ? sepax__temporary_add(path) : -1;
  pthread_sigmask(SIG_SETMASK, &before, NULL);
  errno = reason;
  return out;
}

void sepax__temporary_drop(int ticket) {
  if (ticket >= 0) {
    sepax_release(atomic_exchange(&under_way[ticket], NULL));
  }
}

static void remove_and_end(int number) {
  for (int i = 0; i < TICKETS; i++) {
    const char *path = atomic_load(&under_way[i]);
    if (path != NULL) {
      unlink(path);
    }
  }
  signal(number, SIG_DFL); /* not by SA_RESETHAND: a second one would end a handler that begins */
  raise(number);
}

void sepax__temporary_remove_on_signals(void) {
  signal(SIGXFSZ, SIG_IGN); /* a file beyond `ulimit -f` is an error of its write, which is told */
  for (int i = 0; i < ENDS; i++) {
    struct sigaction was;
    struct sigaction action = {.sa_handler = remove_and_end};
    sigemptyset(&action.sa_mask);
    for (int k = 0; k < ENDS; k++) {
      sigaddset(&action.sa_mask, ends[k]);
    }
    if (sigaction(ends[i], NULL, &was) == 0 && was.sa_handler != SIG_IGN) {
      sigaction(ends[i], &action, NULL);
    }
  }
}
