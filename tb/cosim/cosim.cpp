// SPDX-License-Identifier: MIT
// cosim.cpp - drives a verilated top with pairs and checks each verdict against the golden
// model of the same configuration, and its cycle against the architecture's rule.
#ifdef SEPAX_GATES
#include "lanes.h"
#else
#include "driver.h"
#endif

#if !SEPAX_EXACT || defined SEPAX_BANDS
#include "axis_source.h"
#endif
#include <algorithm>

namespace {

struct Options {
  cli_grid grid{};
  int source = 0; // the key of the option that names it, or KEY_MESHES
  const char *text = nullptr, *mesh[2] = {nullptr, nullptr}, *wave = nullptr;
  uint64_t count = 100000, seed = 1, stress = 0;
  uint64_t first = 0; // of --ternary
};

// ----------------------------------------------------------------------- options

enum {
  KEY_STRESS = 0x400,
  KEY_WAVE,
  KEY_FAMILY,
  KEY_TERNARY,
  KEY_SAMPLE,
  KEY_BITS,
  KEY_OVERLAPS,
  KEY_POWERS,
  KEY_CORNERS,
  KEY_AXES,
  KEY_WITHIN,
  KEY_BEYOND,
  KEY_MESHES
};

const argp_option options_table[] = {
    {"pairs", 'p', "FILE", 0, "judge the pairs of this file (- : standard input)", 0},
    {"count", 'n', "PAIRS", 0,
     "judge so many pairs of the hard families, of ternary or sample"
     " (100000)",
     0},
    {"seed", 's', "SEED", 0, "seed of those pairs (1)", 0},
    {"family", KEY_FAMILY, "NAME", 0, "of one family only", 0},
    {"corners", KEY_CORNERS, nullptr, 0,
     "instead of those families, coordinates at the ends and the middle of the range", 0},
    {"overlaps", KEY_OVERLAPS, nullptr, 0,
     "instead of those families, pairs in a plane or on a line that overlap by one vertex each", 0},
    {"powers", KEY_POWERS, nullptr, 0,
     "instead of those families, coordinates that are 0 or powers of two", 0},
#if !SEPAX_EXACT || defined SEPAX_BANDS
    {"axes", KEY_AXES, nullptr, 0, "instead of those families, pairs that one axis decides", 0},
#endif
#ifdef SEPAX_EXTENT_A
    {"within", KEY_WITHIN, nullptr, 0, "those families within the extents of the design", 0},
    {"beyond", KEY_BEYOND, nullptr, 0, "the same, one triangle of each pair beyond them", 0},
#endif
    {"ternary", KEY_TERNARY, "FIRST", 0,
     "judge pairs from this on of the 3^18 with coordinates -1, 0, 1", 0},
    {"sample", KEY_SAMPLE, nullptr, 0, "judge COUNT of those 3^18, spread over all", 0},
    {"bits", KEY_BITS, nullptr, 0, "judge the 2^18 pairs with coordinates 0, 1", 0},
    {"stress", KEY_STRESS, "SEED", 0,
     "gaps, blocked verdicts (where there is out_ready) and resets at random", 0},
    {"wave", KEY_WAVE, "FILE", 0, "write an FST waveform", 0},
    {nullptr, 0, nullptr, 0, nullptr, 0}};

void choose_source(Options *o, argp_state *state, int key, char *text) {
  if (o->source != 0 && (o->source != key || key != KEY_MESHES)) {
    argp_error(state,
               "give pairs, meshes, a family, corners, ternary, sample or bits, not several");
  }
  o->source = key;
  o->text = text;
}

error_t parse(int key, char *text, argp_state *state) {
  Options *o = static_cast<Options *>(state->input);
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &o->grid;
    return 0;
  case 'n':
    o->count = cli_count(state, "count", text, 0, UINT64_MAX);
    if (o->count == 0) {
      argp_error(state, "count: 0 pairs are no test; give 1 or more");
    }
    return 0;
  case 's':
    o->seed = cli_count(state, "seed", text, 0, UINT64_MAX);
    return 0;
  case KEY_STRESS:
    o->stress = cli_count(state, "stress", text, 0, UINT64_MAX);
    return 0;
  case KEY_WAVE:
    o->wave = text;
    return 0;
  case KEY_TERNARY:
    o->first = cli_count(state, "ternary", text, 0, TERNARY_PAIRS - 1);
    [[fallthrough]];
  case 'p':
  case KEY_FAMILY:
  case KEY_CORNERS:
  case KEY_AXES:
  case KEY_WITHIN:
  case KEY_BEYOND:
  case KEY_SAMPLE:
  case KEY_BITS:
  case KEY_OVERLAPS:
  case KEY_POWERS:
    choose_source(o, state, key, text);
    return 0;
  case ARGP_KEY_ARG:
    if (o->mesh[1] != nullptr) {
      argp_error(state, "unexpected argument '%s': give two STL files", text);
    }
    choose_source(o, state, KEY_MESHES, text);
    o->mesh[o->mesh[0] == nullptr ? 0 : 1] = text;
    return 0;
  case ARGP_KEY_END:
    if (o->source == KEY_MESHES && o->mesh[1] == nullptr) {
      argp_error(state, "give two STL files");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

Source open_source(const Options &o, const sepax_design &design) {
  switch (o.source) {
  case 'p':
    std::printf("pairs of %s\n", std::strcmp(o.text, "-") == 0 ? "standard input" : o.text);
    return file_source(o.text, design);
  case KEY_TERNARY:
    return ternary_source(o.first, std::min(o.count, TERNARY_PAIRS - o.first));
  case KEY_SAMPLE:
    return sample_source(std::min(o.count, TERNARY_PAIRS));
  case KEY_BITS:
    return bits_source();
  case KEY_CORNERS:
    return corner_source(o.count, o.seed);
  case KEY_OVERLAPS:
    return overlap_source(o.count, o.seed);
  case KEY_POWERS:
    return power_source(o.count, o.seed);
#if !SEPAX_EXACT || defined SEPAX_BANDS
  case KEY_AXES:
    return axis_source(o.count, o.seed, design);
#endif
#ifdef SEPAX_EXTENT_A
  case KEY_WITHIN:
    return family_source(o.count, o.seed, "all", draw_extents<false>);
  case KEY_BEYOND:
    return family_source(o.count, o.seed, "all", draw_extents<true>);
#endif
  case KEY_MESHES:
    return mesh_source(o.mesh, o.grid);
  default:
    return family_source(o.count, o.seed, o.text == nullptr ? "all" : o.text, draw_pair);
  }
}

// ------------------------------------------------------------------------ the run

uint64_t send_all(Driver *driver, const Source &source, double *seconds) {
  constexpr uint64_t PAIRS_A_LOOK = 256; // at the clock
  sepax_pair pair;
  uint64_t sent = 0;
  cli_progress progress = cli_progress_begin("pairs through the design", source.total);
  while (!driver->too_many() && source.next(&pair) && driver->send(sent, pair)) {
    if (++sent % PAIRS_A_LOOK == 0) {
      cli_progress_show(&progress, sent);
    }
  }
  driver->drain();
  *seconds = cli_progress_end(&progress);
  return sent;
}

int report(const Driver &driver, uint64_t sent, double seconds) {
  driver.report();
  std::printf("simulated in %.1f s, %.0f pairs/s\n", seconds,
              seconds > 0 ? (double)sent / seconds : 0.0);
  if (driver.mismatches != 0) {
    return 1;
  }
  if (sent == 0) {
    std::fprintf(stderr, "cosim: no pairs were given; that is no test\n");
    return EXIT_ERROR;
  }
  if (driver.judged + driver.dropped != sent + driver.damaged) {
    std::fprintf(stderr, "cosim: %llu pairs sent, %llu judged\n", (unsigned long long)sent,
                 (unsigned long long)driver.judged);
    return 1;
  }
  return 0;
}

} // namespace

int main(int argc, char **argv) {
  const argp_child children[] = {{&cli_grid_argp, 0, nullptr, 0}, {nullptr, 0, nullptr, 0}};
  const argp parser = {options_table,
                       parse,
                       "[A.stl B.stl]",
                       "Co-simulate the generated design (" SEPAX_OPTIONS
                       ") and its golden model on two meshes, a file of pairs, or seeded "
                       "hard pairs.\vExit status: 0 equal, 1 a mismatch, 2 error.",
                       children,
                       nullptr,
                       nullptr};
  Options options;
  options.grid.grid.word = SEPAX_WORD;
  argp_err_exit_status = EXIT_ERROR;
  argp_parse(&parser, argc, argv, 0, nullptr, &options);
  sepax_config config = sepax_config_default();
  sepax_design design;
  sepax_error error{};
  if (!sepax_config_parse(&config, SEPAX_OPTIONS, &error) ||
      !sepax_design_init(&design, &config, &error)) {
    fail(error);
  }
  std::printf("%s\n", SEPAX_OPTIONS);
  Source source = open_source(options, design);
  Driver driver(options.wave, options.stress, design);
  double seconds = 0;
  uint64_t sent = send_all(&driver, source, &seconds);
  return report(driver, sent, seconds);
}
