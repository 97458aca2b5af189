/* engine.c - golden model of the object engine: which pairs it finds, in which order, and
 * about when (docs/engine.md). */
#include "util/error.h"
#include "sepax_design.h"

#include <stdlib.h>

typedef struct {
  int64_t low[3], high[3];
} box;

static box box_of(const sepax_tri *t, const int32_t move[3]) {
  box b = {{INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}};
  for (int k = 0; k < 3; k++) {
    const int64_t c[3] = {(int64_t)t->v[k].x + move[0], (int64_t)t->v[k].y + move[1],
                          (int64_t)t->v[k].z + move[2]};
    for (int i = 0; i < 3; i++) {
      b.low[i] = c[i] < b.low[i] ? c[i] : b.low[i];
      b.high[i] = c[i] > b.high[i] ? c[i] : b.high[i];
    }
  }
  return b;
}

/* Boxes that are no more than a margin apart. */
static bool meet(const box *a, const box *b, int64_t margin) {
  for (int i = 0; i < 3; i++) {
    if (a->high[i] + margin < b->low[i] || b->high[i] + margin < a->low[i]) {
      return false;
    }
  }
  return true;
}

static bool within(const box *b, int word) {
  for (int i = 0; i < 3; i++) {
    if (b->low[i] < sepax_word_min(word) || b->high[i] > sepax_word_max(word)) {
      return false;
    }
  }
  return true;
}

/* The lowest bits of a coordinate: itself, if it fits. */
static int32_t wrapped(int64_t c, int word) {
  uint64_t high = UINT64_C(1) << (word - 1);
  uint64_t low = (uint64_t)c & (2 * high - 1);
  return (int32_t)((int64_t)(low ^ high) - (int64_t)high);
}

/* As the cores see it. */
static sepax_tri moved(const sepax_tri *t, const int32_t move[3], int word) {
  sepax_tri m;
  for (int k = 0; k < 3; k++) {
    m.v[k] = (sepax_vec){wrapped((int64_t)t->v[k].x + move[0], word),
                         wrapped((int64_t)t->v[k].y + move[1], word),
                         wrapped((int64_t)t->v[k].z + move[2], word)};
  }
  return m;
}

/* What is between lanes and cores as time goes by: a queue of masks, how many pairs each of
 * them owes, the mask that is taken apart, and the pairs that were fetched. */
enum { PLACES = 16, KEPT_FREE = 6, FETCHED = 2 };
typedef struct {
  uint64_t owed[PLACES];
  int first, count;
  uint64_t picked;
  int fetched;
  uint64_t now, last_taken;
  uint64_t ii, cores;
  uint64_t free_at[8]; /* each core */
} pace;

static void tick(pace *p) {
  p->now++;
  uint64_t *free_at = &p->free_at[0];
  for (uint64_t k = 1; k < p->cores; k++) {
    free_at = p->free_at[k] < *free_at ? &p->free_at[k] : free_at;
  }
  if (p->fetched > 0 && p->now >= *free_at) {
    *free_at = p->now + p->ii;
    p->last_taken = p->now;
    p->fetched--;
  }
  if (p->picked > 0 && p->fetched < FETCHED) {
    p->picked--;
    p->fetched++;
  }
  if (p->picked == 0 && p->count > 0) {
    p->picked = p->owed[p->first];
    p->first = (p->first + 1) % PLACES;
    p->count--;
  }
}

static void step(pace *p, uint64_t pairs) {
  while (p->count > PLACES - KEPT_FREE) {
    tick(p);
  }
  if (pairs > 0) {
    p->owed[(p->first + p->count++) % PLACES] = pairs;
  }
  tick(p);
}

/* A pair whose six vertices are on one line as seen along z goes through the core twice. */
static bool goes_round(const sepax_pair *pair) {
  const sepax_vec *v[6] = {&pair->a.v[0], &pair->a.v[1], &pair->a.v[2],
                           &pair->b.v[0], &pair->b.v[1], &pair->b.v[2]};
  __int128 dx = 0;
  __int128 dy = 0;
  for (int i = 1; i < 6; i++) {
    __int128 x = (__int128)v[i]->x - v[0]->x;
    __int128 y = (__int128)v[i]->y - v[0]->y;
    if (dx * y != dy * x) {
      return false;
    }
    if (dx == 0 && dy == 0) {
      dx = x;
      dy = y;
    }
  }
  return true;
}

typedef struct {
  const sepax_design *design;
  const sepax_tri *a, *b;
  const box *box_a, *box_b;
  const int32_t *move;
  sepax_engine_run *run;
  size_t room;
  sepax_error *error;
} walk;

/* A pair whose boxes meet. */
static bool judge(walk *w, size_t i, size_t j) {
  sepax_engine_run *run = w->run;
  const sepax_config *c = &w->design->config;
  const sepax_pair pair = {.a = w->a[i], .b = moved(&w->b[j], w->move, c->word)};
  sepax_verdict v = sepax_judge(w->design, &pair);
  bool boxes_decide = v.axis == SEPAX_AXIS_AABB || v.axis == SEPAX_AXIS_EXTENT;
  bool outside = !within(&w->box_b[j], c->word);
  bool undecided = outside || v.axis == SEPAX_AXIS_EXTENT;
  bool collision = outside || v.collision;
  run->candidates++;
  run->passes += !c->flag && w->design->limits == 0 && !boxes_decide && goes_round(&pair) ? 2 : 1;
  bool warning = !collision && w->design->limits > 0 && v.band == SEPAX_BAND_WARNING;
  if (!collision && !warning) {
    return true;
  }
  run->out_of_range += undecided;
  run->first = collision && run->collisions == 0 ? run->found.count : run->first;
  run->collisions += collision;
  if (run->found.count == w->room) {
    size_t room = w->room == 0 ? 256 : 2 * w->room;
    size_t(*more)[2] = realloc(run->found.pair, room * sizeof *more);
    if (more == NULL) {
      return sepax_fail(w->error, "out of memory for the pairs that collide");
    }
    run->found.pair = more;
    w->room = room;
  }
  run->found.pair[run->found.count][0] = i;
  run->found.pair[run->found.count++][1] = j;
  return true;
}

static bool walk_all(walk *w, size_t count_a, size_t count_b) {
  const sepax_config *c = &w->design->config;
  size_t lanes = (size_t)c->lanes;
  size_t length = count_b > lanes ? count_b : lanes;
  size_t rounds = (count_a + lanes - 1) / lanes;
  size_t last = (count_a - 1) % lanes;
  pace p = {.cores = (uint64_t)c->cores, .ii = (uint64_t)c->ii};
  for (size_t round = 0; round <= rounds; round++) {
    for (size_t j = 0; j < length && (round < rounds || j < last); j++) {
      uint64_t before = w->run->passes;
      for (size_t k = 0; k < lanes && j < count_b; k++) {
        size_t n = round * lanes + k;
        if (j < k && n < lanes) {
          continue;
        }
        n -= j < k ? lanes : 0;
        if (n < count_a) {
          w->run->pairs++;
          if (meet(&w->box_a[n], &w->box_b[j], w->design->limits > 0 ? w->design->margin[1] : 0) &&
              !judge(w, n, j)) {
            return false;
          }
        }
      }
      step(&p, w->run->passes - before);
    }
  }
  /* Registers from a step to the queue; from there to a core, and behind it. */
  enum { TO_QUEUE = 5, AROUND_CORE = 6 };
  w->run->cycles = p.now + TO_QUEUE;
  while (p.count > 0 || p.picked > 0 || p.fetched > 0) {
    tick(&p);
  }
  uint64_t answered = p.last_taken + AROUND_CORE + (uint64_t)w->design->latency;
  if (p.last_taken > 0 && answered > w->run->cycles) {
    w->run->cycles = answered;
  }
  return true;
}

bool sepax_engine(const sepax_design *design, const sepax_tri *a, size_t count_a,
                  const sepax_tri *b, size_t count_b, const int32_t move[3], sepax_engine_run *run,
                  sepax_error *error) {
  static const int32_t still[3] = {0, 0, 0};
  *run = (sepax_engine_run){0};
  if (design->config.lanes == 0 || count_a == 0 || count_b == 0 ||
      count_a > (size_t)design->config.memory_a || count_b > (size_t)design->config.memory_b) {
    return sepax_fail(
        error,
        "engine: %zu and %zu triangles do not fit %d lanes with memories of %d and %d; give others",
        count_a, count_b, design->config.lanes, design->config.memory_a, design->config.memory_b);
  }
  box *box_a = malloc(count_a * sizeof *box_a);
  box *box_b = malloc(count_b * sizeof *box_b);
  bool ok = box_a != NULL && box_b != NULL;
  if (!ok) {
    sepax_fail(error, "out of memory for %zu boxes", count_a + count_b);
  }
  for (size_t i = 0; i < count_a && ok; i++) {
    box_a[i] = box_of(&a[i], still);
  }
  for (size_t j = 0; j < count_b && ok; j++) {
    box_b[j] = box_of(&b[j], move);
  }
  walk w = {design, a, b, box_a, box_b, move, run, 0, error};
  ok = ok && walk_all(&w, count_a, count_b);
  run->first = run->collisions > 0 ? run->first : run->found.count;
  free(box_a);
  free(box_b);
  if (!ok) {
    sepax_pairs_free(&run->found);
  }
  return ok;
}
