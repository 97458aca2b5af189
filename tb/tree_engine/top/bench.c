/* SPDX-License-Identifier: MIT */
/* bench.c - checks the verilated tree engine against its golden model.
 *   tree-engine [--stress=SEED] [--latency=N] [--resolution=LENGTH] [--modes=N] [--budget=N]
 *               [--wave=FILE] A B POSES
 *   tree-engine [--stress=SEED] [--rounds=N] [--wave=FILE]
 *   tree-engine [--stress=SEED] --sound=N
 *   tree-engine --fuzz=N
 *   tree-engine [--stress=SEED] --scene=N
 *   tree-engine [--stress=SEED] [--latency=N] --jobs=FILE
 * The first: the bodies A and B, STL or files of `sepax tree`, in the poses of a file, 12 numbers a
 * line; a line a pose: cycles, near pairs, collisions. Modes are those of a job
 * (docs/reference/tree-engine.md; 16: cold caches at each pose). The second: N rounds of seeded
 * bodies, poses and modes; then damage. The third: these rounds without damage and all that
 * follows. The fourth: N batches of small bodies, of which any bytes are damaged. The fifth: six
 * bodies in N poses along a path (scene.c); with --stress, in trouble (troubles.c). The sixth: a
 * list of sepax path --jobs (list.c). Words with + are for the design. Exit status 1: a fault. */
#include "bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

sepax_design design;
sepax_tree_device device;
uint64_t bench_base = UINT64_C(0x1234560000);
unsigned long long wrong;

void expect(const char *what, unsigned long long got, unsigned long long wanted) {
  if (got != wanted && wrong++ < 20) {
    fprintf(stderr, "tree-engine: %s: %llu, expected %llu\n", what, got, wanted);
  }
}

_Noreturn void stop(const char *text) {
  fprintf(stderr, "tree-engine: %s\n", text);
  exit(2);
}

void stop_on(bool failed, const char *text) {
  if (failed) {
    stop(text);
  }
}

void stop_at(bool failed, const char *path, const char *text) {
  char line[768];
  snprintf(line, sizeof line, "%s: %s", path, text);
  stop_on(failed, line);
}

/* ------------------------------------------------------------------ memory */

static struct {
  uint8_t *byte;
  size_t used, space;
  bool is_reserved;
  uint32_t *bursts; /* that began at each beat of it */
} external;

size_t bench_space(size_t bytes, size_t unit) {
  size_t at = (external.used + unit - 1) / unit * unit;
  external.used = at + bytes;
  if (external.is_reserved) {
    stop_on(external.used > external.space, "too little is reserved");
    return at;
  }
  if (external.used > external.space) {
    external.space = 2 * external.used;
    external.byte = realloc(external.byte, external.space);
    stop_on(external.byte == NULL, "out of memory");
  }
  memset(external.byte + at, 0, bytes);
  return at;
}

uint8_t *bench_at(size_t offset) { return external.byte + offset; }
void bench_clear(void) {
  external.used = 0;
  if (external.is_reserved) {
    free(external.byte);
    external.byte = NULL;
    external.space = 0;
    external.is_reserved = false;
  }
}

void bench_reserve(size_t bytes) {
  bench_clear();
  free(external.byte);
  external.byte = calloc(1, bytes); /* pages that nobody writes are none */
  stop_on(external.byte == NULL, "out of memory");
  external.space = bytes;
  external.is_reserved = true;
}
uint64_t bench_address(size_t offset) { return bench_base + offset; }

void bench_tree(const sepax_tree *tree, uint8_t record[SEPAX_TREE_BODY_BYTES]) {
  size_t bytes;
  const uint8_t *image = sepax_tree_image(tree, &bytes);
  size_t at = bench_space(bytes, 4096);
  memcpy(bench_at(at), image, bytes);
  sepax_tree_body(tree, bench_address(at), record);
}

void bench_attach(memory_options options) {
  external.used = bench_space(0, 4096);
  options.bytes = external.byte;
  options.base = bench_base;
  options.size = external.used;
  if (!external.is_reserved) {
    external.bursts = realloc(external.bursts, external.used / MEMORY_BEAT * sizeof(uint32_t));
    stop_on(external.bursts == NULL, "out of memory");
    options.bursts = external.bursts;
  }
  bus_memory(&options);
}

/* ------------------------------------------------------------------ a batch */

/* The pairs of a pose by the golden model, and how far the engine is in them. */
typedef struct {
  sepax_contact *pair;
  size_t count, space, seen;
  bool unknown;  /* the golden model has not looked for them */
  bool stale;    /* caches hold other bodies than the job says */
  bool may_stop; /* by BUDGET or STOP */
  unsigned long long wrong;
} contacts;

static void keep(void *context, const sepax_tree_pair *pair) {
  contacts *c = context;
  if (c->count == c->space) {
    c->space = 2 * c->space + 64;
    c->pair = realloc(c->pair, c->space * sizeof *c->pair);
    stop_on(c->pair == NULL, "out of memory");
  }
  c->pair[c->count++] = (sepax_contact){.a = pair->triangle[0],
                                        .b = pair->triangle[1],
                                        .coplanar = pair->coplanar,
                                        .out_of_range = pair->out_of_range,
                                        .warning = !pair->collision};
}

static void see(void *context, const sepax_contact *got) {
  contacts *c = context;
  const sepax_contact *wanted = c->seen < c->count ? &c->pair[c->seen] : NULL;
  c->seen++;
  if (c->unknown) {
    return;
  }
  if (wanted == NULL || got->a != wanted->a || got->b != wanted->b ||
      got->coplanar != wanted->coplanar || got->out_of_range != wanted->out_of_range ||
      got->warning != wanted->warning) {
    if (c->wrong++ < 3) {
      fprintf(stderr, "tree-engine: pair %zu of %zu is %u %u, flags %d%d%d, expected %u %u\n",
              c->seen, c->count, got->a, got->b, got->coplanar, got->out_of_range, got->warning,
              wanted != NULL ? wanted->a : 0, wanted != NULL ? wanted->b : 0);
    }
  }
}

static void count(contacts *c, const char *what, uint64_t got, uint64_t wanted) {
  if (got != wanted && c->wrong++ < 3) {
    fprintf(stderr, "tree-engine: %s: %llu, expected %llu\n", what, (unsigned long long)got,
            (unsigned long long)wanted);
  }
}

/* A pose with a verdict. */
static void compare_counts(contacts *c, const sepax_tree_result *golden, const sepax_outcome *o) {
  const sepax_tree_run *run = &golden->run;
  bool stopped = (o->status & SEPAX_TREE_STOPPED) != 0;
  bool first = (golden->modes & SEPAX_TREE_FIRST) != 0 && run->collisions > 0;
  count(c, "status", o->status | (stopped ? golden->status : 0),
        golden->status | (stopped ? SEPAX_TREE_STOPPED : 0));
  if (!stopped) {
    count(c, "near pairs", o->near, run->near);
    count(c, "collisions", o->collisions, run->collisions);
    count(c, "warnings", o->warnings, run->warnings);
    count(c, "out of range", o->out_of_range, run->out_of_range);
  }
  if (!stopped && !first) {
    count(c, "entries", o->entries, run->entries);
    count(c, "steps", o->steps, run->steps);
    count(c, "rows", o->rows, run->rows);
    count(c, "pairs", o->pairs, run->pairs);
  }
  if ((o->status & SEPAX_TREE_HIT) != 0) {
    for (int i = 0; i < 2; i++) {
      count(c, "FIRST", o->first[i], run->found.triangle[i]);
      count(c, "row of FIRST", o->row[i], run->found.leaf[i] | (uint32_t)run->found.child[i] << 23);
    }
  }
  bool quiet = (golden->modes & SEPAX_TREE_QUIET) != 0;
  if (!stopped || quiet) {
    count(c, "pairs that came", c->seen, quiet ? 0 : c->count);
  }
}

static void compare(const bench_batch *b, contacts *c, const sepax_tree_result *golden,
                    const sepax_outcome *o) {
  count(c, "job", o->job, golden->job);
  count(c, "pose", o->pose, golden->pose);
  bool hit = (o->status & SEPAX_TREE_HIT) != 0;
  count(c, "no FIRST", hit ? 0 : o->first[0] | o->first[1] | o->row[0] | o->row[1], 0);
  count(c, "no run", (o->status & (SEPAX_TREE_BUS | SEPAX_TREE_REFUSED)) != 0 ? o->cycles : 0, 0);
  unsigned none = o->status & SEPAX_TREE_NO_VERDICT;
  count(c, "a status without a verdict is one bit", none != 0 ? o->status : 0, none & (0 - none));
  if (c->stale) {
    return;
  }
  bool found_first = (golden->modes & SEPAX_TREE_FIRST) != 0 && hit;
  if (!c->may_stop || found_first) {
    count(c, "STOPPED", o->status & SEPAX_TREE_STOPPED, 0);
  }
  if ((o->status & SEPAX_TREE_BUS) != 0 && b->errors) {
    return;
  }
  if (c->unknown && (golden->status & SEPAX_TREE_BUS) != 0) {
    return;
  }
  if (((golden->status | o->status) & SEPAX_TREE_NO_VERDICT) != 0) {
    bool stopped = (o->status & SEPAX_TREE_STOPPED) != 0; /* before it came to the damage */
    count(c, "status", o->status, stopped ? o->status : golden->status);
    return;
  }
  compare_counts(c, golden, o);
}

/* Where the engine was stopped before it found what the golden model found, the model goes on as
 * the engine does. */
static void follow(sepax_tree_batch *golden, const sepax_tree_batch *before,
                   const sepax_tree_result *result, const sepax_outcome *o) {
  bool missed = (o->status & SEPAX_TREE_HIT) == 0 && (result->status & SEPAX_TREE_HIT) != 0;
  if ((o->status & SEPAX_TREE_STOPPED) != 0 && missed) {
    bool begins = result->pose == 0;
    bool last = result->pose + 1 == golden->current.count;
    golden->has_row = begins ? (golden->current.modes & SEPAX_TREE_ROW) != 0 : before->has_row;
    golden->row = before->row;
    if (begins) {
      golden->row =
          (sepax_tree_pair){.leaf = {golden->current.leaf[0], golden->current.leaf[1]},
                            .child = {golden->current.child[0], golden->current.child[1]}};
    }
    golden->job = last ? result->job + 1 : result->job;
    golden->pose = last ? 0 : result->pose + 1;
  }
}

static void tally(bench_batch *b, const contacts *c, const sepax_tree_result *golden,
                  const sepax_outcome *o) {
  double off = (double)golden->run.cycles / (double)(o->cycles > 0 ? o->cycles : 1) - 1;
  b->poses++;
  b->status |= o->status;
  b->cycles += o->cycles;
  b->predicted += golden->run.cycles;
  b->off = fabs(off) > fabs(b->off) ? off : b->off;
  b->worst = o->cycles > b->worst ? o->cycles : b->worst;
  b->mismatches += c->wrong > 0;
  b->near += o->near;
  b->warnings += o->warnings;
  if ((o->status & SEPAX_TREE_HIT) != 0 && b->hits++ == 0) {
    b->first_hit[0] = o->job;
    b->first_hit[1] = o->pose;
  }
  b->out_of_range += o->out_of_range;
  b->stopped += (o->status & SEPAX_TREE_STOPPED) != 0;
  b->damaged += (o->status & SEPAX_TREE_DAMAGED) != 0;
  b->bus += (o->status & SEPAX_TREE_BUS) != 0;
  b->refused += (o->status & SEPAX_TREE_REFUSED) != 0;
  wrong += c->wrong;
  if (b->told != NULL) {
    b->told(b->context, o, c->wrong == 0);
  }
  if (b->print) {
    printf("%u %u %u%s\n", o->cycles, o->near, o->collisions,
           (o->status & SEPAX_TREE_STOPPED) != 0 ? " stopped, undecided" : "");
  }
}

/* Take a pose that the golden model has, and compare. False: the batch is lost. */
static bool take(bench_batch *b, contacts *c, const sepax_tree_result *result, sepax_outcome *o) {
  bool told = (result->status & SEPAX_TREE_NO_VERDICT) == 0;
  /* A bit that was damaged may say that the bodies are those of the batch before. */
  c->stale = b->any && (result->modes & SEPAX_TREE_WARM) != 0 &&
             (result->status & SEPAX_TREE_REFUSED) == 0;
  bus_limit(told && !c->stale ? 50000 + 16 * result->run.cycles : 1000000);
  c->seen = 0;
  c->wrong = 0;
  /* Where a root is damaged, the engine may have come to the first row before. */
  bool has_row = (result->modes & SEPAX_TREE_ROW) != 0;
  c->unknown = c->stale || (b->any && ((result->status & SEPAX_TREE_BUS) != 0 ||
                                       ((result->status & SEPAX_TREE_DAMAGED) != 0 && has_row)));
  sepax_tree_device_status status = sepax_tree_device_take(&device, see, c, o);
  if (status != SEPAX_TREE_DEVICE_OK && status != SEPAX_TREE_DEVICE_NO_VERDICT) {
    fprintf(stderr, "tree-engine: %s\n", sepax_tree_device_text(status));
    wrong++;
    return false;
  }
  compare(b, c, result, o);
  tally(b, c, result, o);
  return true;
}

/* What the registers say of a batch that took so many cycles at most. */
static void check_registers(const bench_batch *b, uint64_t most) {
  uint32_t value = 0;
  expect("STATUS", bus_read(NULL, SEPAX_TREE_STATUS, &value) ? value : UINT64_MAX, b->status << 1);
  expect("CYCLES", bus_read(NULL, SEPAX_TREE_CYCLES, &value), 1);
  expect("as many cycles as its poses took, or more", value >= b->cycles && value <= most, 1);
  expect("POSES", bus_read(NULL, SEPAX_TREE_POSES, &value) ? value : UINT64_MAX, b->poses);
  expect("HITS", bus_read(NULL, SEPAX_TREE_HITS, &value) ? value : UINT64_MAX, b->hits);
  if (b->hits > 0) {
    expect("HIT_JOB", bus_read(NULL, SEPAX_TREE_HIT_JOB, &value) ? value : UINT64_MAX,
           b->first_hit[0]);
    expect("HIT_POSE", bus_read(NULL, SEPAX_TREE_HIT_POSE, &value) ? value : UINT64_MAX,
           b->first_hit[1]);
  }
}

void bench_run(bench_batch *b) {
  const sepax_tree_memory seen = {external.byte, bench_base, external.used};
  contacts c = {.pair = NULL};
  sepax_tree_batch golden = {.design = &design,
                             .memory = &seen,
                             .list = bench_address(b->list),
                             .jobs = b->jobs,
                             .each = keep,
                             .context = &c};
  sepax_error error = {0};
  bench_reads reads = {.bursts = external.bursts};
  uint64_t bursts = bus_attached()->counts.bursts;
  uint64_t stopped = b->stopped;
  uint64_t begun = bus_cycles();
  if (!external.is_reserved) {
    memset(external.bursts, 0, external.used / MEMORY_BEAT * sizeof(uint32_t));
  }
  expect("start", sepax_tree_device_start(&device, golden.list, golden.jobs), SEPAX_TREE_DEVICE_OK);
  bool more = true;
  for (int n = 0; more; n++) {
    sepax_tree_result result = {.job = 0};
    sepax_outcome o = {.status = 0};
    sepax_tree_batch before = golden;
    c.count = 0;
    stop_on(!sepax_tree_next(&golden, &result, &more, &error), error.text);
    c.may_stop = golden.current.budget > 0 || (b->stop_at >= 0 && n >= b->stop_at);
    if (more && n == b->stop_at) {
      expect("STOP", sepax_tree_device_stop(&device), SEPAX_TREE_DEVICE_OK);
    }
    reads.colds += (result.modes & SEPAX_TREE_COLD) != 0 ||
                   (result.pose == 0 && (result.modes & SEPAX_TREE_WARM) == 0);
    if (!more || !take(b, &c, &result, &o)) {
      break;
    }
    bool ended =
        (o.status & SEPAX_TREE_NO_VERDICT) != 0 || (result.status & SEPAX_TREE_NO_VERDICT) != 0;
    follow(&golden, &before, &result, &o);
    if (b->stop_at < 0 || n < b->stop_at) {
      expect("LAST", o.last, ended || golden.job == golden.jobs);
    }
    more = !o.last;
  }
  free(c.pair);
  bool busy = true;
  for (int n = 0; busy && n < 1000; n++) {
    expect("busy", sepax_tree_device_busy(&device, &busy), SEPAX_TREE_DEVICE_OK);
  }
  expect("the batch ends", busy, 0);
  check_registers(b, bus_cycles() - begun);
  if (!b->any && !b->errors && !external.is_reserved) {
    reads.whole = b->stopped == stopped;
    reads_check(&reads, golden.list, golden.jobs, bus_attached()->counts.bursts - bursts);
  }
}

/* ------------------------------------------------------------------ command */

typedef struct {
  const char *path[3], *wave, *jobs;
  unsigned long long stress, rounds, latency, modes, budget, fuzz, sound, late, scene;
  double resolution;
  int paths;
} command;

static bool number_after(const char *text, const char *name, unsigned long long *value) {
  size_t length = strlen(name);
  if (strncmp(text, name, length) != 0) {
    return false;
  }
  char *end;
  *value = strtoull(text + length, &end, 10);
  stop_at(end == text + length || *end != '\0', text, "no whole number");
  return true;
}

static void parse(command *c, const char *text) {
  if (number_after(text, "--stress=", &c->stress) || number_after(text, "--rounds=", &c->rounds) ||
      number_after(text, "--latency=", &c->latency) || number_after(text, "--modes=", &c->modes) ||
      number_after(text, "--budget=", &c->budget) || number_after(text, "--fuzz=", &c->fuzz) ||
      number_after(text, "--sound=", &c->sound) || number_after(text, "--late=", &c->late) ||
      number_after(text, "--scene=", &c->scene) || text[0] == '+') {
    return;
  }
  if (strncmp(text, "--resolution=", 13) == 0) {
    char *end;
    c->resolution = strtod(text + 13, &end);
    stop_on(*end != '\0' || !(c->resolution > 0), "--resolution is a length above 0");
  } else if (strncmp(text, "--wave=", 7) == 0) {
    c->wave = text + 7;
  } else if (strncmp(text, "--jobs=", 7) == 0) {
    c->jobs = text + 7;
  } else {
    stop_on(
        text[0] == '-' || c->paths == 3,
        "usage: tree-engine [--stress=SEED] [--latency=N] [--resolution=LENGTH] [--modes=N] "
        "[--budget=N] A B POSES, or [--stress=SEED] [--rounds=N] [--sound=N], --fuzz=N, --scene=N, "
        "--jobs=FILE");
    c->path[c->paths++] = text;
  }
}

int main(int argc, char **argv) {
  command c = {.rounds = 20, .latency = 100, .modes = SEPAX_TREE_COLD};
  for (int i = 1; i < argc; i++) {
    parse(&c, argv[i]);
  }
  stop_on(c.paths % 3 != 0, "give two bodies and a file of poses, or nothing");
  stop_on(c.latency == 0 || c.latency > 100000, "--latency is 1 ... 100000 cycles");
  stop_on(c.budget > UINT32_MAX, "--budget is up to 4294967295 cycles");
  stop_on(c.modes > 127, "--modes is 0 ... 127");
  sepax_error error = {0};
  sepax_config config = sepax_config_default();
  stop_on(!sepax_config_parse(&config, SEPAX_OPTIONS, &error) ||
              !sepax_design_init(&design, &config, &error),
          error.text);
  bus_arguments(argc, argv);
  bus_open(c.stress, c.wave);
  const sepax_tree_device_bus bus = {NULL, bus_read, bus_write, bus_receive};
  expect("open", sepax_tree_device_open(&device, &bus), SEPAX_TREE_DEVICE_OK);
  expect("word", (unsigned long long)device.word, SEPAX_WORD);
  expect("margin", (unsigned long long)device.margin, (unsigned long long)design.margin[1]);
  const memory_options options = {.latency = (int)c.latency, .stress = c.stress};
  if (c.jobs != NULL) {
    bench_list(c.jobs, &options);
  } else if (c.paths == 3) {
    bench_meshes(c.path, c.resolution, (unsigned)c.modes, (unsigned)c.budget, &options);
  } else if (c.scene > 0) {
    bench_scene((size_t)c.scene, c.stress);
  } else if (c.fuzz > 0) {
    bench_fuzz(c.fuzz, c.stress);
  } else if (c.late > 0) {
    bench_late(c.late);
  } else if (c.sound > 0) {
    bench_sound(c.sound, c.stress, c.stress > 0);
  } else {
    bench_rounds(c.rounds, c.stress, c.stress > 0);
  }
  wrong += bus_breaches() + bus_attached()->counts.breaches;
  bus_close();
  bench_clear();
  free(external.byte);
  free(external.bursts);
  return wrong != 0;
}
