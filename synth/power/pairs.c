/* pairs.c - pairs through the gates in 64 lanes, each on a part of them. */
#include "analysis.h"
#include "cli/cli.h"
#include "liberty/text.h"
#include "sepax_vectors.h"

#include <stdio.h>
#include <stdlib.h>

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
  int in[18][32]; /* coordinates, or the words of paper: a x y z, b x y z, na, nb */
  int in_valid, in_ready, out_valid, out_collision, out_coplanar, out_ready, rst;
} ports;

static void find_ports(ports *p, const analysis *m) {
  static const char *const of_paper[] = {"in_a_x", "in_a_y", "in_a_z", "in_b_x",
                                         "in_b_y", "in_b_z", "in_na",  "in_nb"};
  int words = m->exact ? 18 : 8;
  for (int k = 0; k < words; k++) {
    char name[32];
    if (m->exact) {
      snprintf(name, sizeof name, "in_%c%d_%c", k < 9 ? 'a' : 'b', k / 3 % 3 + 1, 'x' + k % 3);
    } else {
      snprintf(name, sizeof name, "%s", of_paper[k]);
    }
    gates_find_word(&m->g, name, m->design.config.word, p->in[k]);
  }
  p->rst = gates_find(&m->g, "rst", -1);
  p->in_valid = gates_find(&m->g, "in_valid", -1);
  p->out_valid = gates_find(&m->g, "out_valid", -1);
  p->out_collision = gates_find(&m->g, "out_collision", -1);
  p->out_coplanar = gates_find(&m->g, "out_coplanar", -1);
  p->in_ready = m->exact ? gates_find(&m->g, "in_ready", -1) : 1;
  p->out_ready = m->exact ? gates_find(&m->g, "out_ready", -1) : -1;
}

static void offer(analysis *m, const ports *p, const lane *of, unsigned l) {
  const sepax_pair *pair = &all_pairs[of->next];
  const sepax_vec *v[6] = {&pair->a.v[0], &pair->a.v[1], &pair->a.v[2],
                           &pair->b.v[0], &pair->b.v[1], &pair->b.v[2]};
  int word = m->design.config.word;
  if (m->exact) {
    for (int k = 0; k < 6; k++) {
      gates_set(&m->g, p->in[3 * k], word, l, (uint32_t)v[k]->x);
      gates_set(&m->g, p->in[3 * k + 1], word, l, (uint32_t)v[k]->y);
      gates_set(&m->g, p->in[3 * k + 2], word, l, (uint32_t)v[k]->z);
    }
    return;
  }
  const int32_t na[3] = {pair->na.x, pair->na.y, pair->na.z};
  const int32_t nb[3] = {pair->nb.x, pair->nb.y, pair->nb.z};
  for (int k = 0; k < 2; k++) {
    const sepax_vec *of_word = v[3 * k + of->word];
    gates_set(&m->g, p->in[3 * k], word, l, (uint32_t)of_word->x);
    gates_set(&m->g, p->in[3 * k + 1], word, l, (uint32_t)of_word->y);
    gates_set(&m->g, p->in[3 * k + 2], word, l, (uint32_t)of_word->z);
  }
  gates_set(&m->g, p->in[6], word, l, (uint32_t)na[of->word]);
  gates_set(&m->g, p->in[7], word, l, (uint32_t)nb[of->word]);
}

/* The pair on the inputs, or a word of it, has been taken. */
static void take(analysis *m, lane *of, bool count) {
  if (!m->exact && ++of->word < INPUT_WORDS) {
    return;
  }
  of->word = 0;
  if (of->stop - of->begin == OUTSTANDING) {
    power_fail("the design takes pairs and gives no verdicts");
  }
  of->outstanding[of->stop++ % OUTSTANDING] = expected[of->next];
  of->next = of->next + 1 == of->end ? of->first : of->next + 1;
  m->taken += count;
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

static void set_all(analysis *m, int net, bool bit) {
  if (net >= 0) {
    m->g.value[net] = bit ? ~UINT64_C(0) : 0;
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
      power_fail("give at least 64 pairs");
    }
  }
  gates_scramble(g);
  for (int cycle = -2; cycle < FILL + m->want->cycles; cycle++) {
    bool valid = cycle >= 0 && !(m->want->idle && cycle >= IDLE_AFTER);
    bool count = cycle >= FILL;
    set_all(m, p.rst, cycle < 0);
    set_all(m, p.in_valid, valid);
    set_all(m, p.out_ready, true);
    for (unsigned l = 0; l < GATES_LANES && (valid || cycle == -2); l++) {
      offer(m, &p, &lanes[l], l);
    }
    gates_settle(g);
    for (unsigned l = 0; l < GATES_LANES && cycle >= 0; l++) {
      if ((g->value[p.out_valid] >> l & 1) != 0) {
        judge(m, &lanes[l],
              (unsigned char)((g->value[p.out_collision] >> l & 1) |
                              (g->value[p.out_coplanar] >> l & 1) << 1),
              count);
      }
      if (valid && (g->value[p.in_ready] >> l & 1) != 0) {
        take(m, &lanes[l], count);
      }
    }
    gates_rise(g, count);
  }
  if (m->judged == 0 && !m->want->idle) {
    power_fail("no verdict came");
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
  for (;;) {
    if ((m->pairs & (m->pairs - 1)) == 0) {
      all_pairs = realloc(all_pairs, (m->pairs == 0 ? 1 : 2 * m->pairs) * sizeof *all_pairs);
      if (all_pairs == NULL) {
        power_fail("out of memory");
      }
    }
    sepax_line line = sepax_pair_read(&all_pairs[m->pairs], stdin, "pairs", &lines,
                                      m->design.config.word, &error);
    if (line == SEPAX_LINE_ERROR) {
      exit(cli_fail("power", &error));
    }
    if (line == SEPAX_LINE_EMPTY) {
      break;
    }
    m->pairs++;
  }
}

static void judge_pairs(analysis *m) {
  expected = text_alloc(m->pairs, sizeof *expected);
  for (size_t k = 0; k < m->pairs; k++) {
    sepax_verdict v = sepax_judge(&m->design, &all_pairs[k]);
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
