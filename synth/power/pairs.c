/* SPDX-License-Identifier: MIT */
/* pairs.c - pairs through the gates in 64 lanes, each on a part of them. */
#include "analysis.h"
#include "liberty/text.h"
#include "sepax_vectors.h"
#include "util/aabb.h"

#include <err.h>
#include <stdio.h>

/* Cycles: before counting, in which the pipeline fills; with pairs, when idle; lanes' verdicts that
 * may be outstanding; words of a pair of paper. */
enum { OUTSTANDING = 256, FILL = 120, IDLE_AFTER = 40, INPUT_WORDS = 3 };

static sepax_pair *all_pairs;
static unsigned char *expected; /* of each pair: bit 0 collision, bit 1 coplanar */

typedef struct {
  size_t next, first, end; /* pairs of this lane, in turn */
  int word;                /* paper: which of the three input words */
  unsigned char outstanding[OUTSTANDING];
  unsigned begin, stop;
} lane;

typedef struct {
  const int *in[18]; /* nets of the coordinates, or of the words of paper */
  uint64_t *in_valid, *out_valid, *out_collision, *out_coplanar;
  uint64_t *in_ready, *out_ready; /* paper: always 1, and none */
} ports;

static void find_ports(ports *p, const analysis *m) {
  static const char *const of_paper[] = {"in_a_x", "in_a_y", "in_a_z", "in_b_x",
                                         "in_b_y", "in_b_z", "in_na",  "in_nb"};
  const gates *g = &m->g;
  for (int k = 0; k < (m->exact ? 18 : 8); k++) {
    char name[32];
    snprintf(name, sizeof name, "in_%c%d_%c", k < 9 ? 'a' : 'b', k / 3 % 3 + 1, 'x' + k % 3);
    p->in[k] = gates_find(g, m->exact ? name : of_paper[k], m->design.config.word)->net;
  }
  p->in_valid = gates_bit(g, "in_valid");
  p->out_valid = gates_bit(g, "out_valid");
  p->out_collision = gates_bit(g, "out_collision");
  p->out_coplanar = gates_bit(g, "out_coplanar");
  p->in_ready = m->exact ? gates_bit(g, "in_ready") : &g->value[1];
  p->out_ready = m->exact ? gates_bit(g, "out_ready") : NULL;
}

/* Word k of a pair on the inputs; of paper the one of `turn` three. */
static int32_t word_of(const sepax_pair *pair, bool exact, int k, int turn) {
  if (exact || k < 6) {
    int vertex = exact ? k / 3 : k / 3 * 3 + turn;
    const sepax_tri *tri = vertex < 3 ? &pair->a : &pair->b;
    return vec_component(&tri->v[vertex % 3], k % 3);
  }
  return vec_component(k == 6 ? &pair->na : &pair->nb, turn);
}

static void offer(analysis *m, const ports *p, const lane *of, unsigned l) {
  for (int k = 0; k < (m->exact ? 18 : 8); k++) {
    int32_t word = word_of(&all_pairs[of->next], m->exact, k, of->word);
    gates_set(&m->g, p->in[k], m->design.config.word, l, (uint32_t)word);
  }
}

/* The pair on the inputs, or a word of it, has been taken. */
static void take(analysis *m, lane *of, int group, bool count) {
  if (!m->exact && ++of->word < INPUT_WORDS) {
    return;
  }
  of->word = 0;
  if (of->stop - of->begin == OUTSTANDING) {
    errx(2, "the design takes pairs and gives no verdicts");
  }
  of->outstanding[of->stop++ % OUTSTANDING] = expected[of->next];
  of->next = of->next + 1 == of->end ? of->first : of->next + 1;
  m->taken += count;
  m->taken_by[group] += count;
}

static void judge(analysis *m, lane *of, unsigned char verdict, bool count) {
  if (of->begin == of->stop || of->outstanding[of->begin % OUTSTANDING] != verdict) {
    m->wrong++;
  }
  of->begin += of->begin != of->stop;
  if (count) {
    m->judged++;
    m->collisions += verdict & 1;
    m->coplanar += verdict >> 1;
  }
}

static void run(analysis *m) {
  static lane lanes[GATES_LANES];
  static ports p;
  gates *g = &m->g;
  find_ports(&p, m);
  for (unsigned l = 0; l < GATES_LANES; l++) {
    lanes[l].first = lanes[l].next = m->pairs * l / GATES_LANES;
    lanes[l].end = m->pairs * (l + 1) / GATES_LANES;
    if (lanes[l].end == lanes[l].first) {
      errx(2, "give at least 64 pairs");
    }
  }
  if (p.out_ready != NULL) {
    *p.out_ready = ~UINT64_C(0);
  }
  for (int cycle = -2; cycle < FILL + m->want->cycles; cycle++) {
    bool valid = cycle >= 0 && !(m->want->idle && cycle >= IDLE_AFTER);
    bool count = cycle >= FILL;
    gates_reset(g, cycle < 0);
    *p.in_valid = valid ? ~UINT64_C(0) : 0;
    for (unsigned l = 0; l < GATES_LANES && (valid || cycle == -2); l++) {
      offer(m, &p, &lanes[l], l);
    }
    gates_settle(g);
    for (unsigned l = 0; l < GATES_LANES && cycle >= 0; l++) {
      if ((*p.out_valid >> l & 1) != 0) {
        unsigned verdict = (*p.out_collision >> l & 1) | (*p.out_coplanar >> l & 1) << 1;
        judge(m, &lanes[l], (unsigned char)verdict, count);
      }
      if (valid && (*p.in_ready >> l & 1) != 0) {
        take(m, &lanes[l], (int)l * GATES_GROUPS / GATES_LANES, count);
      }
    }
    gates_rise(g, count);
  }
  if (m->judged == 0 && !m->want->idle) {
    errx(2, "no verdict came");
  }
}

static void make_pairs(analysis *m) {
  sepax_scene scene = power_meshes(m);
  m->pairs = scene.count[0] * scene.count[1];
  all_pairs = text_alloc(m->pairs, sizeof *all_pairs);
  for (size_t k = 0; k < m->pairs; k++) {
    all_pairs[k] = sepax_scene_pair(&scene, k / scene.count[1], k % scene.count[1]);
  }
  sepax_scene_free(&scene);
}

static void read_pairs(analysis *m) {
  size_t lines = 0;
  sepax_error error = {0};
  sepax_line line;
  do {
    all_pairs = text_more(all_pairs, m->pairs, sizeof *all_pairs);
    line = sepax_pair_read(&all_pairs[m->pairs], stdin, "pairs", &lines, m->design.config.word,
                           &error);
    m->pairs += line == SEPAX_LINE_PAIR;
  } while (line == SEPAX_LINE_PAIR);
  if (line == SEPAX_LINE_ERROR) {
    errx(2, "%s", error.text);
  }
}

static void judge_pairs(analysis *m) {
  expected = text_alloc(m->pairs, sizeof *expected);
  for (size_t k = 0; k < m->pairs; k++) {
    sepax_judgement v = sepax_judge(&m->design, &all_pairs[k]);
    expected[k] = (unsigned char)(v.collision | v.coplanar << 1);
    m->undecided += m->exact && v.axis == SEPAX_AXIS_EXTENT;
  }
}

void power_pairs(analysis *m) {
  if (m->want->mesh[0] != NULL) {
    make_pairs(m);
  } else {
    read_pairs(m);
  }
  judge_pairs(m);
  run(m);
}
