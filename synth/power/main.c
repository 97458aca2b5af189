/* power.c - what a mapped design draws with given pairs: its gates are simulated in 64 lanes,
 * each on a part of the pairs of its own, every verdict is held against the golden model, and
 * the transitions of every net become leakage, internal and switching power by its library.
 *
 *   power -l LIBERTY -n NETLIST -d "--arch=... --word=..." -p PERIOD [OPTIONS] < PAIRS
 *   power ... -r RESOLUTION A.stl B.stl
 *
 * LIBERTY  plain, the library of the netlist
 * PERIOD   of the clock in ns
 * A, B     all pairs of their triangles, quantised; each lane begins elsewhere. An object engine
 *          (--lanes) wants them: one whole run, its memories and buses played (engine.h)
 * -c N     cycles counted, after those in which the machine fills (200)
 * -i       idle: after some pairs (an engine: after its run) nothing comes any more; then count
 * -b       an engine: count while its objects come, before the run
 * -g A     no simulation: A transitions a cycle on every net, half the time 1
 * -s F     plant a fault: transitions counted times F
 * -o       energy inside cells as OpenSTA 2.0.17 counts it, to compare with -g
 * -t FILE  transitions a cycle and share of ones, by pin, for OpenSTA (synth/power/sta.tcl)
 * -e FILE  power by cell: path, type; internal, switching, leakage in W
 *
 * JSON on standard output. Exit status 1: a wrong verdict; 2: it could not be done.
 *
 * A transition of a net takes C V^2 / 2 of its pins and of the library's default wire load. The
 * energy inside a cell is that of the library's tables at the input's slope and the output's load,
 * rise and fall in equal parts; an input's by the probability of each `when`, an output's from
 * the tables of all its inputs, weighted by how often they move. Without delays there are no
 * glitches. The clock has no slope and two transitions a cycle; what drives it and the inputs is
 * not counted. */
#include "cli/cli.h"
#include "gates.h"
#include "engine.h"
#include "liberty/text.h"
#include "sepax_design.h"
#include "sepax_vectors.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { OWED = 256, FILL = 120, IDLE_AFTER = 40, INPUT_WORDS = 3 };

typedef struct {
  const char *liberty, *netlist, *design, *pins, *by_cell;
  const char *mesh[2];
  double period, global, fault, resolution;
  int cycles;
  bool idle, loading, as_sta;
} request;

typedef struct {
  const request *want;
  sepax_design design;
  bool exact, engine;
  library lib;
  gates g;
  double *act, *one;  /* of each net: transitions a cycle, share of ones */
  double *load;       /* of each net, F */
  int *loads;         /* pins that read it */
  double (*slope)[2]; /* of each net: rise, fall, ns */
  sepax_pair *pair;
  unsigned char *verdict;  /* of each pair: bit 0 collision, bit 1 coplanar */
  size_t pairs, undecided; /* of all given, those beyond the extents */
  uint64_t taken, judged, wrong, collisions, coplanar; /* while it counts, but wrong: always */
} machine;

typedef struct {
  double leakage, internal, switching;
} watts;

static _Noreturn void fail(const char *what) {
  fprintf(stderr, "power: %s\n", what);
  exit(2);
}

/* --------------------------------------------------------------------- the lanes */

typedef struct {
  size_t next, first, end; /* pairs of this lane, in turn */
  int word;                /* paper: which of the three input words */
  unsigned char owed[OWED];
  unsigned begin, stop;
} lane;

typedef struct {
  int in[18][32]; /* coordinates, or the words of paper: a x y z, b x y z, na, nb */
  int in_valid, in_ready, out_valid, out_collision, out_coplanar, out_ready, rst;
} ports;

static void find_ports(ports *p, const machine *m) {
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

static void offer(machine *m, const ports *p, const lane *of, unsigned l) {
  const sepax_pair *pair = &m->pair[of->next];
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
static void take(machine *m, lane *of, bool count) {
  if (!m->exact && ++of->word < INPUT_WORDS) {
    return;
  }
  of->word = 0;
  if (of->stop - of->begin == OWED) {
    fail("the machine takes pairs and gives no verdicts");
  }
  of->owed[of->stop++ % OWED] = m->verdict[of->next];
  of->next = of->next + 1 == of->end ? of->first : of->next + 1;
  m->taken += count;
}

static void judge(machine *m, lane *of, unsigned char verdict, bool count) {
  if (of->begin == of->stop || of->owed[of->begin % OWED] != verdict) {
    m->wrong++;
  }
  of->begin += of->begin != of->stop;
  if (count) {
    m->judged++;
    m->collisions += verdict & 1;
    m->coplanar += verdict >> 1;
  }
}

static void set_all(machine *m, int net, bool bit) {
  if (net >= 0) {
    m->g.value[net] = bit ? ~UINT64_C(0) : 0;
  }
}

static void run(machine *m) {
  static lane lanes[GATES_LANES];
  static ports p;
  gates *g = &m->g;
  find_ports(&p, m);
  for (unsigned l = 0; l < GATES_LANES; l++) {
    lanes[l].first = lanes[l].next = m->pairs * l / GATES_LANES;
    lanes[l].end = m->pairs * (l + 1) / GATES_LANES;
    if (lanes[l].end == lanes[l].first) {
      fail("give at least 64 pairs");
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
    fail("no verdict came");
  }
}

static void find_activities(machine *m) {
  gates *g = &m->g;
  m->act = text_alloc((size_t)g->nets, sizeof *m->act);
  m->one = text_alloc((size_t)g->nets, sizeof *m->one);
  for (int k = 0; k < g->nets; k++) {
    bool global = m->want->global >= 0;
    double all = (double)g->cycles * GATES_LANES;
    m->act[k] = global ? m->want->global : m->want->fault * (double)g->toggles[k] / all;
    m->one[k] = global ? 0.5 : (double)g->ones[k] / all;
  }
  m->act[0] = m->act[1] = m->one[0] = 0;
  m->one[1] = 1;
  m->act[g->clock] = 2;
  m->one[g->clock] = 0.5;
}

/* ------------------------------------------------------------- loads and slopes */

static void find_loads(machine *m) {
  gates *g = &m->g;
  m->loads = text_alloc((size_t)g->nets, sizeof *m->loads);
  m->load = text_alloc((size_t)g->nets, sizeof *m->load);
  for (int c = 0; c < g->cells; c++) {
    const lib_cell *type = g->cell[c].type;
    for (int k = 0; k < type->pins; k++) {
      if (!type->pin[k].output && g->cell[c].net[k] >= 0) {
        m->load[g->cell[c].net[k]] += type->pin[k].capacitance;
        m->loads[g->cell[c].net[k]]++;
      }
    }
  }
  for (int k = 0; k < g->ports; k++) {
    m->loads[g->port[k].net] += g->port[k].output;
  }
  for (int k = 0; k < g->nets; k++) {
    m->load[k] += m->lib.wire[m->loads[k] < LIB_FANOUT ? m->loads[k] : LIB_FANOUT - 1];
  }
}

static void slope_of(machine *m, const gates_cell *cell) {
  for (int k = 0; k < cell->type->arcs; k++) {
    const lib_arc *arc = &cell->type->arc[k];
    int to = cell->net[arc->to];
    if (to < 0 || arc->from < 0) {
      continue;
    }
    double load = m->load[to] / m->lib.farad;
    for (int edge = 0; edge < 2; edge++) {   /* of the output */
      for (int from = 0; from < 2; from++) { /* of the input */
        bool causes = arc->clocked ? from == 0 : from == edge ? arc->on_rise : arc->on_fall;
        double in = arc->clocked ? 0 : m->slope[cell->net[arc->from]][from];
        double slope = causes ? lib_look_up(&arc->slope[edge], in, load) : 0;
        if (slope > m->slope[to][edge]) {
          m->slope[to][edge] = slope;
        }
      }
    }
  }
}

static void find_slopes(machine *m) {
  gates *g = &m->g;
  m->slope = text_alloc((size_t)g->nets, sizeof *m->slope);
  for (int c = 0; c < g->cells; c++) {
    if (g->cell[c].type->register_) {
      slope_of(m, &g->cell[c]);
    }
  }
  for (int k = 0; k < g->ordered; k++) {
    slope_of(m, &g->cell[g->order[k]]);
  }
}

/* ---------------------------------------------------------------------- power */

/* Energy (J) of a transition by these tables, rise and fall in equal parts. */
static double energy_of(const machine *m, const gates_cell *cell, const lib_power *power) {
  int from = cell->net[power->related >= 0 ? power->related : power->pin];
  int out = cell->net[power->pin];
  double load = cell->type->pin[power->pin].output ? m->load[out] / m->lib.farad : 0;
  double sum = 0;
  for (int edge = 0; edge < 2; edge++) {
    sum += lib_look_up(&power->energy[edge], from < 0 ? 0 : m->slope[from][edge], load);
  }
  return sum / 2 * m->lib.joule;
}

/* Inside the cell, in a cycle (J). */
static double internal_energy(const machine *m, const gates_cell *cell) {
  const lib_cell *type = cell->type;
  double one[LIB_PINS];
  double energy[LIB_PINS] = {0};
  double weight[LIB_PINS] = {0};
  double plain[LIB_PINS] = {0};
  int tables[LIB_PINS] = {0};
  double row[64];
  double state = 0.5;
  double differ = 0.5;
  for (int k = 0; k < type->pins; k++) {
    one[k] = cell->net[k] >= 0 ? m->one[cell->net[k]] : 0.5;
    if (type->register_ && type->pin[k].output && cell->net[k] >= 0) {
      state = type->pin[k].function.op[0] == LIB_STATE ? one[k] : 1 - one[k];
      differ = m->want->global >= 0 ? 0.5 : m->act[cell->net[k]];
    }
  }
  int rows = lib_rows(type, one, state, differ, row);
  double sum = 0;
  for (int k = 0; k < type->powers; k++) {
    const lib_power *power = &type->power[k];
    int pin = power->pin;
    if (cell->net[pin] < 0) {
      continue;
    }
    double likely = 0;
    for (int r = 0; r < rows; r++) {
      likely += (power->when >> r & 1) != 0 ? row[r] : 0;
    }
    double each = energy_of(m, cell, power);
    if (m->want->as_sta) {
      sum += 2 * each * likely * m->act[cell->net[pin]];
      continue;
    }
    if (!type->pin[pin].output) {
      sum += each * likely * m->act[cell->net[pin]];
      continue;
    }
    int related = power->related < 0 ? -1 : cell->net[power->related];
    double w = likely * (related < 0 ? 1 : m->act[related]);
    energy[pin] += w * each;
    weight[pin] += w;
    plain[pin] += each;
    tables[pin]++;
  }
  for (int k = 0; k < type->pins; k++) {
    if (tables[k] > 0) {
      sum += m->act[cell->net[k]] * (weight[k] > 0 ? energy[k] / weight[k] : plain[k] / tables[k]);
    }
  }
  return sum;
}

static watts power_of(const machine *m, const gates_cell *cell) {
  double rate = 1e9 / m->want->period;
  double volt = m->lib.volt;
  watts w = {.leakage = cell->type->leakage, .internal = internal_energy(m, cell) * rate};
  for (int k = 0; k < cell->type->pins; k++) {
    int net = cell->net[k];
    if (cell->type->pin[k].output && net >= 0) {
      w.switching += 0.5 * m->load[net] * volt * volt * m->act[net] * rate;
    }
  }
  return w;
}

/* --------------------------------------------------------------------- reports */

static void print_path(FILE *out, const gates *g, int place) {
  if (g->place[place].parent >= 0) {
    print_path(out, g, g->place[place].parent);
    fprintf(out, "%s/", g->place[place].name);
  }
}

static FILE *create(const char *path) {
  FILE *out = fopen(path, "w");
  if (out == NULL) {
    fprintf(stderr, "power: %s: cannot be written\n", path);
    exit(2);
  }
  return out;
}

static void close_file(FILE *out, const char *path) {
  if (fclose(out) != 0) {
    fprintf(stderr, "power: %s: cannot be written\n", path);
    exit(2);
  }
}

/* What OpenSTA lets be set: inputs of the top, and all pins of cells. */
static void print_pins(const machine *m) {
  const gates *g = &m->g;
  FILE *out = create(m->want->pins);
  for (int k = 0; k < g->ports; k++) {
    if (!g->port[k].output && g->port[k].net != g->clock) {
      fprintf(out, "port %s %.6g %.6g\n", g->port[k].name, m->act[g->port[k].net],
              m->one[g->port[k].net]);
    }
  }
  for (int c = 0; c < g->cells; c++) {
    const gates_cell *cell = &g->cell[c];
    for (int k = 0; k < cell->type->pins; k++) {
      if (cell->net[k] > 1 && cell->net[k] != g->clock) {
        fprintf(out, "pin ");
        print_path(out, g, cell->place);
        fprintf(out, "%s/%s %.6g %.6g\n", cell->name, cell->type->pin[k].name, m->act[cell->net[k]],
                m->one[cell->net[k]]);
      }
    }
  }
  close_file(out, m->want->pins);
}

static void print_cells(const machine *m) {
  FILE *out = create(m->want->by_cell);
  for (int c = 0; c < m->g.cells; c++) {
    watts w = power_of(m, &m->g.cell[c]);
    print_path(out, &m->g, m->g.cell[c].place);
    fprintf(out, "%s %s %.6g %.6g %.6g\n", m->g.cell[c].name, m->g.cell[c].type->name, w.internal,
            w.switching, w.leakage);
  }
  close_file(out, m->want->by_cell);
}

static void print_watts(watts w) {
  printf("\"leakage_w\": %.6g, \"internal_w\": %.6g, \"switching_w\": %.6g, \"total_w\": %.6g",
         w.leakage, w.internal, w.switching, w.leakage + w.internal + w.switching);
}

static void print_report(const machine *m) {
  const gates *g = &m->g;
  watts *own = text_alloc((size_t)g->places, sizeof *own);
  int *cells = text_alloc((size_t)g->places, sizeof *cells);
  watts all = {0, 0, 0};
  watts registers = {0, 0, 0};
  for (int c = 0; c < g->cells; c++) {
    watts w = power_of(m, &g->cell[c]);
    watts *into[3] = {&own[g->cell[c].place], &all, g->cell[c].type->register_ ? &registers : NULL};
    for (int k = 0; k < 3 && into[k] != NULL; k++) {
      into[k]->leakage += w.leakage;
      into[k]->internal += w.internal;
      into[k]->switching += w.switching;
    }
    cells[g->cell[c].place]++;
  }
  double joule = (all.leakage + all.internal + all.switching) * m->want->period * 1e-9;
  printf(
      "{\"period_ns\": %g, \"lanes\": %d, \"cycles\": %llu, \"pairs\": %llu, \"judged\": %llu, "
      "\"collisions\": %llu, \"coplanar\": %llu, \"wrong\": %llu, \"undecided_percent\": %.4g, \"cells\": %d,\n ",
      m->want->period, GATES_LANES, (unsigned long long)g->cycles, (unsigned long long)m->taken,
      (unsigned long long)m->judged, (unsigned long long)m->collisions,
      (unsigned long long)m->coplanar, (unsigned long long)m->wrong,
      m->pairs > 0 ? 100.0 * (double)m->undecided / (double)m->pairs : 0.0, g->cells);
  print_watts(all);
  printf(", \"cycle_pj\": %.6g, \"pair_pj\": ", joule * 1e12);
  if (m->taken > 0) {
    printf("%.6g", joule * 1e12 * (double)g->cycles * GATES_LANES / (double)m->taken);
  } else {
    printf("null");
  }
  if (m->engine) {
    printf(", \"machine_nj\": %.6g, \"memories\": \"not counted\"",
           joule * 1e9 * (double)g->cycles);
  }
  printf(",\n \"registers\": {");
  print_watts(registers);
  printf("}, \"clock_pins_pj\": %.6g,\n \"places\": [",
         m->load[g->clock] * m->lib.volt * m->lib.volt * 1e12);
  for (int k = 0; k < g->places; k++) {
    printf("%s\n  {\"place\": \"", k > 0 ? "," : "");
    print_path(stdout, g, k);
    printf("\", \"module\": \"%s\", \"cells\": %d, ", g->place[k].module, cells[k]);
    print_watts(own[k]);
    printf("}");
  }
  printf("]}\n");
  free(own);
  free(cells);
}

/* ----------------------------------------------------------------------- input */

static sepax_scene read_meshes(const machine *m) {
  sepax_error error = {0};
  sepax_scene scene;
  sepax_grid grid = {.resolution = m->want->resolution, .word = m->design.config.word};
  if (!sepax_scene_load(&scene, m->want->mesh, &grid, false, &error)) {
    exit(cli_fail("power", &error));
  }
  return scene;
}

static void make_pairs(machine *m) {
  sepax_scene scene = read_meshes(m);
  m->pairs = scene.count[0] * scene.count[1];
  m->pair = text_alloc(m->pairs, sizeof *m->pair);
  for (size_t k = 0; k < m->pairs; k++) {
    m->pair[k] = sepax_scene_pair(&scene, k / scene.count[1], k % scene.count[1]);
  }
  sepax_scene_free(&scene);
}

static void run_engine(machine *m) {
  if (m->want->mesh[0] == NULL) {
    fail("an object engine wants two meshes; give -r RESOLUTION A.stl B.stl");
  }
  sepax_scene scene = read_meshes(m);
  power_part part = m->want->idle ? POWER_IDLE : m->want->loading ? POWER_LOADING : POWER_RUN;
  power_tally tally = power_engine(&m->g, &m->design, &scene, part, m->want->cycles);
  sepax_scene_free(&scene);
  m->wrong = tally.wrong;
  if (part == POWER_RUN) {
    m->taken = m->judged = m->pairs = tally.pairs;
    m->collisions = tally.collisions;
    m->coplanar = tally.coplanar;
    m->undecided = tally.out_of_range;
  }
}

static void read_pairs(machine *m) {
  size_t lines = 0;
  sepax_error error = {0};
  for (;;) {
    if ((m->pairs & (m->pairs - 1)) == 0) {
      m->pair = realloc(m->pair, (m->pairs == 0 ? 1 : 2 * m->pairs) * sizeof *m->pair);
      if (m->pair == NULL) {
        fail("out of memory");
      }
    }
    sepax_line line =
        sepax_pair_read(&m->pair[m->pairs], stdin, "pairs", &lines, m->design.config.word, &error);
    if (line == SEPAX_LINE_ERROR) {
      exit(cli_fail("power", &error));
    }
    if (line == SEPAX_LINE_EMPTY) {
      break;
    }
    m->pairs++;
  }
}

static void judge_pairs(machine *m) {
  m->verdict = text_alloc(m->pairs, sizeof *m->verdict);
  for (size_t k = 0; k < m->pairs; k++) {
    sepax_verdict v = sepax_judge(&m->design, &m->pair[k]);
    m->verdict[k] = (unsigned char)(v.collision | v.coplanar << 1);
    m->undecided += m->exact && v.axis == SEPAX_AXIS_EXTENT;
  }
}

static double number(const char *text, char option) {
  char *end;
  double x = strtod(text, &end);
  if (end == text || *end != '\0' || !(x >= 0 && x < 1e9)) {
    fprintf(stderr, "power: -%c %s: give a number\n", option, text);
    exit(2);
  }
  return x;
}

static request read_options(int argc, char **argv) {
  request r = {.global = -1, .fault = 1, .cycles = 200};
  for (int option; (option = getopt(argc, argv, "bc:d:e:g:il:n:op:r:s:t:")) != -1;) {
    switch (option) {
    case 'b':
      r.loading = true;
      break;
    case 'c':
      r.cycles = (int)number(optarg, 'c');
      break;
    case 'd':
      r.design = optarg;
      break;
    case 'e':
      r.by_cell = optarg;
      break;
    case 'g':
      r.global = number(optarg, 'g');
      break;
    case 'i':
      r.idle = true;
      break;
    case 'l':
      r.liberty = optarg;
      break;
    case 'n':
      r.netlist = optarg;
      break;
    case 'o':
      r.as_sta = true;
      break;
    case 'p':
      r.period = number(optarg, 'p');
      break;
    case 'r':
      r.resolution = number(optarg, 'r');
      break;
    case 's':
      r.fault = number(optarg, 's');
      break;
    case 't':
      r.pins = optarg;
      break;
    default:
      exit(2);
    }
  }
  if (r.liberty == NULL || r.netlist == NULL || r.design == NULL || r.period <= 0 || r.cycles < 1 ||
      (optind != argc && optind + 2 != argc)) {
    fail("give -l LIBERTY -n NETLIST -d DESIGN -p PERIOD, and pairs on standard input");
  }
  if (optind < argc) {
    r.mesh[0] = argv[optind];
    r.mesh[1] = argv[optind + 1];
  }
  return r;
}

int main(int argc, char **argv) {
  static machine m;
  static request want;
  want = read_options(argc, argv);
  sepax_error error = {0};
  m.want = &want;
  sepax_config config = sepax_config_default();
  if (!sepax_config_parse(&config, want.design, &error) ||
      !sepax_design_init(&m.design, &config, &error)) {
    return cli_fail("power", &error);
  }
  m.exact = config.arch == SEPAX_ARCH_EXACT;
  m.engine = config.lanes > 0;
  if (want.loading && (want.idle || !m.engine)) {
    fail("-b is for an object engine (--lanes), and not with -i");
  }
  library_read(&m.lib, want.liberty);
  gates_read(&m.g, &m.lib, want.netlist);
  if (want.global < 0 && m.engine) {
    run_engine(&m);
  } else if (want.global < 0) {
    if (want.mesh[0] != NULL) {
      make_pairs(&m);
    } else {
      read_pairs(&m);
    }
    judge_pairs(&m);
    run(&m);
  }
  find_activities(&m);
  find_loads(&m);
  find_slopes(&m);
  if (want.pins != NULL) {
    print_pins(&m);
  }
  if (want.by_cell != NULL) {
    print_cells(&m);
  }
  print_report(&m);
  if (m.wrong > 0) {
    fprintf(stderr, "power: %llu %s are not the golden model's\n", (unsigned long long)m.wrong,
            m.engine ? "results, ends and counts" : "verdicts");
    return 1;
  }
  return 0;
}
