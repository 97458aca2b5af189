/* SPDX-License-Identifier: MIT */
/* main.c - what a mapped design draws with given pairs: its gates are simulated in 64 lanes,
 * each on a part of the pairs of its own, every verdict is compared with the golden model's, and
 * the transitions of every net become leakage, internal and switching power by its library.
 *
 *   power -l LIBERTY -n NETLIST -d "--arch=... --word=..." -p PERIOD [OPTIONS] < PAIRS
 *   power ... -r RESOLUTION A.stl B.stl
 *
 * LIBERTY  plain, the library of the netlist
 * PERIOD   of the clock in ns
 * A, B     all pairs of their triangles, quantised; each lane begins elsewhere. An object engine
 *          (--lanes) wants them: one whole run, its memories and buses played
 * -m FILE  a tree engine: poses of B, which the lanes share; the meshes are its bodies
 * -c N     cycles counted, after those in which the pipeline fills (200)
 * -i       idle: after some pairs (an engine: after its run) nothing comes any more; then count
 * -b       an engine: count while its objects come, before the run
 * -g A     no simulation: A transitions a cycle on every net, half the time 1
 * -s F     plant a fault: transitions counted times F
 * -o       energy inside cells as OpenSTA 2.0.17 counts it, to compare with -g
 * -x SHARE count glitches, too: cells have delays (glitches.h), and pulses pass that last this
 *          share of them: 1; more or less shows what the share is worth
 * -t FILE  transitions a cycle and share of ones, by pin, for OpenSTA (synth/power/sta.tcl)
 * -e FILE  power by cell: path, type; internal, switching, leakage in W
 *
 * JSON on standard output. Exit status 1: a wrong verdict; 2: it could not be done.
 *
 * A transition of a net takes C V^2 / 2 of its pins and of the library's default wire load. The
 * energy inside a cell is that of the library's tables at the input's slope and the output's load,
 * rising and falling in equal parts; an input's by the probability of each `when`, an output's from
 * the tables of all its inputs, weighted by how often they move. Without delays (-x) there are no
 * glitches. The clock has no slope and two transitions a cycle; what drives it and the inputs is
 * not counted. */
#include "analysis.h"
#include "design/engine_table.h"
#include "sepax_io.h"

#include <err.h>
#include <getopt.h>
#include <stdlib.h>

sepax_scene power_meshes(const analysis *m) {
  static const sepax_mesh_reading how = {.size = sizeof how, .result_mm = 1};
  sepax_error error = {0};
  sepax_soup mesh[2] = {{0}, {0}};
  sepax_scene scene;
  sepax_grid grid = {.resolution = m->want->resolution, .word = m->design.config.word};
  if (!sepax_mesh_read(&mesh[0], NULL, m->want->mesh[0], &how, &error) ||
      !sepax_mesh_read(&mesh[1], NULL, m->want->mesh[1], &how, &error) ||
      !sepax_scene_make(&scene, mesh, m->want->mesh, &grid, false, &error)) {
    errx(2, "%s", error.text);
  }
  sepax_soup_free(&mesh[0]);
  sepax_soup_free(&mesh[1]);
  return scene;
}

/* The number that option -c has been given, or else `other`. */
static double number(const char *const given[], char option, double other) {
  const char *text = given[(unsigned char)option];
  if (text == NULL) {
    return other;
  }
  char *end;
  double x = strtod(text, &end);
  if (end == text || *end != '\0' || !(x >= 0 && x < 1e9)) {
    errx(2, "-%c %s: give a number", option, text);
  }
  return x;
}

static request read_options(int argc, char **argv) {
  const char *given[128] = {NULL}; /* by the option's letter: its argument, or "" */
  for (int option; (option = getopt(argc, argv, "bc:d:e:g:il:m:n:op:r:s:t:x:")) != -1;) {
    if (option == '?') {
      exit(2);
    }
    given[option] = optarg != NULL ? optarg : "";
  }
  request r = {.liberty = given['l'],
               .netlist = given['n'],
               .design = given['d'],
               .pins = given['t'],
               .by_cell = given['e'],
               .poses = given['m'],
               .period = number(given, 'p', 0),
               .global = number(given, 'g', -1),
               .fault = number(given, 's', 1),
               .resolution = number(given, 'r', 0),
               .cycles = (int)number(given, 'c', 200),
               .idle = given['i'] != NULL,
               .loading = given['b'] != NULL,
               .glitches = number(given, 'x', 0),
               .as_sta = given['o'] != NULL};
  if (r.liberty == NULL || r.netlist == NULL || r.design == NULL || r.period <= 0 || r.cycles < 1 ||
      (optind != argc && optind + 2 != argc)) {
    errx(2, "give -l LIBERTY -n NETLIST -d DESIGN -p PERIOD, and pairs on standard input");
  }
  if (optind < argc) {
    r.mesh[0] = argv[optind];
    r.mesh[1] = argv[optind + 1];
  }
  return r;
}

static const char of_engines[] = "results, ends and counts";
static const power_engine engines[SEPAX_ENGINE_COUNT] = {
    [SEPAX_ENGINE_NONE] = {.simulate = power_pairs, .compared = "verdicts"},
    [SEPAX_ENGINE_OBJECT] = {.simulate = power_object,
                             .compared = of_engines,
                             .loads = true,
                             .runs = true},
    [SEPAX_ENGINE_TREE] = {.simulate = power_tree, .compared = of_engines, .runs = true},
};

int main(int argc, char **argv) {
  static analysis m;
  static request want;
  want = read_options(argc, argv);
  sepax_error error = {0};
  m.want = &want;
  sepax_config config = sepax_config_default();
  if (!sepax_config_parse(&config, want.design, &error) ||
      !sepax_design_init(&m.design, &config, &error)) {
    errx(2, "%s", error.text);
  }
  m.exact = config.arch == SEPAX_ARCH_EXACT;
  m.engine = &engines[sepax__config_engine(&config)];
  if (m.engine->simulate == NULL) {
    errx(2, "%s: the power of such an engine is not simulated; leave it out", want.design);
  }
  if (want.loading && (want.idle || !m.engine->loads)) {
    errx(2, "-b is for an object engine (--lanes), and not with -i");
  }
  library_read(&m.lib, want.liberty);
  gates_read(&m.g, &m.lib, want.netlist);
  power_prepare(&m);
  if (want.global < 0) {
    m.engine->simulate(&m);
  }
  power_count(&m);
  power_report(&m);
  if (m.wrong > 0) {
    errx(1, "%llu %s are not the golden model's", (unsigned long long)m.wrong, m.engine->compared);
  }
  return 0;
}
