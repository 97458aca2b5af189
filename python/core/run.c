/* SPDX-License-Identifier: MIT */
/* run.c - answers many questions by threads, without the lock of Python. */
#include "core.h"
#include "util/clock.h"
#include "util/threads.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

/* A call looks for signals after this time, and then goes on. */
#define SECONDS_BETWEEN_SIGNALS 0.2

typedef struct {
  const core_batch *batch;
  unsigned char *done; /* of each chunk: 1 if it is answered */
  size_t from;         /* all chunks before are done */
  double deadline;
  pthread_mutex_t lock; /* of what follows */
  size_t failed;        /* the first bad question, or SIZE_MAX */
  sepax_error error;
} running;

static void answer_chunk(void *context, size_t part) {
  running *r = context;
  const core_batch *b = r->batch;
  const size_t chunk = r->from + part;
  if (r->done[chunk] || seconds_now() > r->deadline) {
    return;
  }
  const size_t first = chunk * b->chunk;
  const size_t end = b->count - first < b->chunk ? b->count : first + b->chunk;
  size_t at = first;
  sepax_error error = {0};
  const bool ok = b->answer(b, first, end, &at, &error);
  r->done[chunk] = 1;
  if (!ok) {
    pthread_mutex_lock(&r->lock);
    if (at < r->failed) { /* the same one, whichever thread fails first */
      r->failed = at;
      r->error = error;
    }
    pthread_mutex_unlock(&r->lock);
  }
}

static bool run_chunks(running *r, size_t chunks) {
  size_t threads = r->batch->threads;
  if (threads == 0) { /* to count the processors takes longer than a question */
    threads = chunks == 1 ? 1 : sepax__threads_here();
  }
  while (r->from < chunks && r->failed == SIZE_MAX) {
    Py_BEGIN_ALLOW_THREADS;
    r->deadline = seconds_now() + SECONDS_BETWEEN_SIGNALS;
    sepax__threads_run(threads, chunks - r->from, answer_chunk, r);
    while (r->from < chunks && r->done[r->from]) {
      r->from++;
    }
    Py_END_ALLOW_THREADS;
    if (PyErr_CheckSignals() != 0) {
      return false;
    }
  }
  return true;
}

bool core_run(const core_batch *batch, const char *named) {
  if (batch->count == 0) {
    return true;
  }
  const size_t chunks = (batch->count - 1) / batch->chunk + 1;
  running r = {.batch = batch, .failed = SIZE_MAX, .lock = PTHREAD_MUTEX_INITIALIZER};
  r.done = calloc(chunks, 1);
  if (r.done == NULL) {
    PyErr_NoMemory();
    return false;
  }
  bool ok = run_chunks(&r, chunks);
  free(r.done);
  if (ok && r.failed != SIZE_MAX) {
    char before[64] = "";
    if (batch->count > 1) {
      snprintf(before, sizeof before, "%s %zu: ", named, r.failed);
    }
    core_failed_at(before, &r.error);
    ok = false;
  }
  return ok;
}
