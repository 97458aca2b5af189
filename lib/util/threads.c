/* SPDX-License-Identifier: MIT */
/* threads.c - one job in parts, for threads that take them. */
#include "util/threads.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <unistd.h>

enum { MOST_THREADS = 256 };

typedef struct {
  void (*work)(void *context, size_t part);
  void *context;
  size_t parts;
  atomic_size_t next;
} job;

static void *take_parts(void *argument) {
  job *j = argument;
  for (size_t part = atomic_fetch_add(&j->next, 1); part < j->parts;
       part = atomic_fetch_add(&j->next, 1)) {
    j->work(j->context, part);
  }
  return NULL;
}

void sepax__threads_run(size_t threads, size_t parts, void (*work)(void *context, size_t part),
                        void *context) {
  pthread_t beside[MOST_THREADS];
  size_t started = 0;
  size_t most = threads < parts ? threads : parts;
  size_t others = most > MOST_THREADS ? MOST_THREADS : most > 0 ? most - 1 : 0;
  job j = {.work = work, .context = context, .parts = parts};
  atomic_init(&j.next, 1);
  while (started < others && pthread_create(&beside[started], NULL, take_parts, &j) == 0) {
    started++;
  }
  if (parts > 0) {
    work(context, 0);
  }
  take_parts(&j);
  for (size_t k = 0; k < started; k++) {
    pthread_join(beside[k], NULL);
  }
}

size_t sepax__threads_here(void) {
  long here = sysconf(_SC_NPROCESSORS_ONLN);
  return here > 0 ? (size_t)here : 1;
}
