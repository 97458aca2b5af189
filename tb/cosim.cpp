// cosim.cpp - drives a verilated sepax_top with pairs and holds each verdict, and
// the cycle it comes in, against the golden model of the same configuration.
#include "Vsepax_top.h"
#include "cli/cli.h"
#include "sepax_params.h"
#include "verilated.h"
#if VM_TRACE
#include "verilated_fst_c.h"
#endif

#include <cstdlib>
#include <cstring>
#include <deque>
#include <memory>
#include <string>

namespace {

constexpr int INPUT_WORDS = 3;
constexpr uint64_t MISMATCHES_SHOWN = 20;
constexpr double CLOCK_HZ = 500e6;

struct Options {
  cli_grid grid{};
  const char *pairs = nullptr, *mesh[2] = {nullptr, nullptr}, *wave = nullptr;
  uint64_t count = 100000, seed = 1, stress = 0;
};

// ---------------------------------------------------------------- pairs to judge

struct Source {
  virtual ~Source() = default;
  virtual uint64_t total() const = 0; // 0: not known beforehand
  virtual bool next(sepax_pair *pair) = 0;
};

[[noreturn]] void fail(const sepax_error &error) {
  std::exit(cli_fail("cosim", &error));
}

class FileSource : public Source {
public:
  explicit FileSource(const char *path)
      : name(path), in(std::strcmp(path, "-") == 0 ? stdin : std::fopen(path, "r")) {
    if (in == nullptr) {
      std::fprintf(stderr, "cosim: %s: cannot be read; give a file of pairs\n", path);
      std::exit(EXIT_ERROR);
    }
  }
  uint64_t total() const override { return 0; }
  bool next(sepax_pair *pair) override {
    sepax_error error{};
    sepax_line line = sepax_pair_read(pair, in, name, &number, SEPAX_WORD, &error);
    if (line == SEPAX_LINE_ERROR) {
      fail(error);
    }
    return line == SEPAX_LINE_PAIR;
  }

private:
  const char *name;
  FILE *in;
  size_t number = 0;
};

class MeshSource : public Source {
public:
  MeshSource(const char *const path[2], const cli_grid &grid) {
    sepax_error error{};
    if (!sepax_scene_load(&scene, path, &grid.grid, grid.file_normals, &error)) {
      fail(error);
    }
  }
  uint64_t total() const override { return (uint64_t)scene.count[0] * scene.count[1]; }
  bool next(sepax_pair *pair) override {
    if (at == total()) {
      return false;
    }
    *pair = sepax_scene_pair(&scene, at / scene.count[1], at % scene.count[1]);
    at++;
    return true;
  }

private:
  sepax_scene scene{};
  uint64_t at = 0;
};

class FamilySource : public Source {
public:
  FamilySource(uint64_t pairs, uint64_t seed) : random{seed}, pairs(pairs) {
    while (sepax_family_name(families) != nullptr) {
      families++;
    }
  }
  uint64_t total() const override { return pairs; }
  bool next(sepax_pair *pair) override {
    if (at == pairs) {
      return false;
    }
    *pair = sepax_family_pair(at++ % families, SEPAX_WORD, &random);
    return true;
  }

private:
  sepax_random random;
  uint64_t pairs, at = 0;
  size_t families = 0;
};

// ------------------------------------------------------------------- the machine

struct Expected {
  uint64_t index, cycle;
  sepax_pair pair;
  sepax_verdict verdict;
};

class Bench {
public:
  Bench(const Options &options, const sepax_design &design)
      : design(design), stress(options.stress), random{options.stress},
        top(new Vsepax_top(&context)) {
#if VM_TRACE
    if (options.wave != nullptr) {
      context.traceEverOn(true);
      trace.reset(new VerilatedFstC);
      top->trace(trace.get(), 99);
      trace->open(options.wave);
    }
#endif
    top->clk = 0;
    top->rst = 1;
    idle();
    tick();
    tick();
    top->rst = 0;
    cycle = 0;
  }

  ~Bench() {
#if VM_TRACE
    if (trace) {
      trace->close();
    }
#endif
    top->final();
  }

  void send(uint64_t index, const sepax_pair &pair) {
    for (;;) {
      uint64_t sent_with = resets;
      for (int k = 0; k < INPUT_WORDS && resets == sent_with; k++) {
        while (stress != 0 && resets == sent_with && chance(4)) {
          disturb();
        }
        if (resets != sent_with) {
          break;
        }
        drive(pair, k);
        if (k == INPUT_WORDS - 1) {
          expected.push_back({index, cycle + 1 + SEPAX_LATENCY - INPUT_WORDS, pair,
                              sepax_judge(&design, &pair)});
        }
        tick();
      }
      idle();
      if (resets == sent_with) {
        return;
      }
    }
  }

  void drain() {
    idle();
    for (int i = 0; i < 2 * SEPAX_LATENCY && !expected.empty(); i++) {
      tick();
    }
    for (int i = 0; i < SEPAX_LATENCY; i++) {
      tick(); // a verdict too many is seen here
    }
    if (!expected.empty()) {
      std::fprintf(stderr, "cosim: time-out: %zu verdicts never came\n", expected.size());
      mismatches += expected.size();
    }
  }

  bool too_many() const { return mismatches >= MISMATCHES_SHOWN; }
  uint64_t mismatches = 0, judged = 0, collisions = 0, coplanar = 0, resets = 0, dropped = 0;
  uint64_t last_verdict_cycle = 0;

private:
  bool chance(uint64_t one_in) { return sepax_random_next(&random) % one_in == 0; }

  void drive(const sepax_pair &pair, int k) {
    const uint32_t mask = 0xffffffffu >> (32 - SEPAX_WORD);
    const sepax_vec &a = pair.a.v[k];
    const sepax_vec &b = pair.b.v[k];
    const int32_t na[] = {pair.na.x, pair.na.y, pair.na.z};
    const int32_t nb[] = {pair.nb.x, pair.nb.y, pair.nb.z};
    top->in_valid = 1;
    top->in_a_x = (uint32_t)a.x & mask;
    top->in_a_y = (uint32_t)a.y & mask;
    top->in_a_z = (uint32_t)a.z & mask;
    top->in_b_x = (uint32_t)b.x & mask;
    top->in_b_y = (uint32_t)b.y & mask;
    top->in_b_z = (uint32_t)b.z & mask;
    top->in_na = (uint32_t)na[k] & mask;
    top->in_nb = (uint32_t)nb[k] & mask;
  }

  void idle() { top->in_valid = 0; }

  // A gap with whatever on the data inputs; now and then a reset, which drops every
  // pair in the machine.
  void disturb() {
    sepax_pair noise = sepax_family_pair(0, SEPAX_WORD, &random);
    drive(noise, 0);
    idle();
    if (chance(200)) {
      top->rst = 1;
      resets++;
      tick();
      top->rst = 0;
      dropped += expected.size();
      expected.clear();
    } else {
      tick();
    }
  }

  // One clock cycle: what the machine's outputs show in it, then the rising edge.
  void tick() {
    cycle++;
    top->eval();
    dump();
    if (top->rst == 0) {
      look();
    }
    top->clk = 1;
    top->eval();
    dump();
    top->clk = 0;
  }

  void look() {
    bool due = !expected.empty() && expected.front().cycle == cycle;
    if (!top->out_valid && !due) {
      if (top->out_collision || top->out_coplanar) {
        complain(nullptr, "an output is 1 without out_valid");
      }
      return;
    }
    if (!due) {
      complain(nullptr, "a verdict that nobody asked for");
      return;
    }
    Expected e = expected.front();
    expected.pop_front();
    judged++;
    collisions += e.verdict.collision;
    coplanar += e.verdict.coplanar;
    last_verdict_cycle = cycle;
    if (!top->out_valid) {
      complain(&e, "no verdict in the cycle where it is due");
    } else if (top->out_collision != e.verdict.collision) {
      complain(&e, e.verdict.collision ? "expected collision, got separated"
                                       : "expected separated, got collision");
    } else if (top->out_coplanar != e.verdict.coplanar) {
      complain(&e, e.verdict.coplanar ? "expected coplanar, got not coplanar"
                                      : "expected not coplanar, got coplanar");
    }
  }

  void complain(const Expected *e, const char *what) {
    mismatches++;
    if (mismatches > MISMATCHES_SHOWN) {
      return;
    }
    if (e == nullptr) {
      std::fprintf(stderr, "cosim: cycle %llu: %s\n", (unsigned long long)cycle, what);
      return;
    }
    std::fprintf(stderr, "cosim: pair %llu, cycle %llu: %s\n  ", (unsigned long long)e->index,
                 (unsigned long long)cycle, what);
    sepax_pair_print(stderr, &e->pair);
    std::fprintf(stderr, "\n  replay: make wave " SEPAX_MAKE " PAIR='");
    sepax_pair_print(stderr, &e->pair);
    std::fprintf(stderr, "'\n");
  }

  void dump() {
#if VM_TRACE
    if (trace) {
      trace->dump(time++);
    }
#endif
  }

  const sepax_design &design;
  uint64_t stress;
  sepax_random random;
  VerilatedContext context;
  std::unique_ptr<Vsepax_top> top;
#if VM_TRACE
  std::unique_ptr<VerilatedFstC> trace;
  uint64_t time = 0; // half cycles
#endif
  std::deque<Expected> expected;
  uint64_t cycle = 0;
};

// ----------------------------------------------------------------------- options

enum { KEY_STRESS = 0x400, KEY_WAVE };

const argp_option options_table[] = {
    {"pairs", 'p', "FILE", 0, "judge the pairs of this file (- : standard input)", 0},
    {"count", 'n', "PAIRS", 0, "judge so many pairs of the hard families (100000)", 0},
    {"seed", 's', "SEED", 0, "seed of those pairs (1)", 0},
    {"stress", KEY_STRESS, "SEED", 0, "gaps between words and resets at random", 0},
    {"wave", KEY_WAVE, "FILE", 0, "write an FST waveform", 0},
    {nullptr, 0, nullptr, 0, nullptr, 0}};

error_t parse(int key, char *text, argp_state *state) {
  Options *o = static_cast<Options *>(state->input);
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &o->grid;
    return 0;
  case 'p':
    o->pairs = text;
    return 0;
  case 'n':
    o->count = cli_count(state, "count", text, UINT64_MAX);
    return 0;
  case 's':
    o->seed = cli_count(state, "seed", text, UINT64_MAX);
    return 0;
  case KEY_STRESS:
    o->stress = cli_count(state, "stress", text, UINT64_MAX);
    return 0;
  case KEY_WAVE:
    o->wave = text;
    return 0;
  case ARGP_KEY_ARG:
    if (o->mesh[1] != nullptr) {
      argp_error(state, "unexpected argument '%s': give two STL files", text);
    }
    o->mesh[o->mesh[0] == nullptr ? 0 : 1] = text;
    return 0;
  case ARGP_KEY_END:
    if ((o->mesh[0] == nullptr) != (o->mesh[1] == nullptr)) {
      argp_error(state, "give two STL files");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

Source *open_source(const Options &o) {
  if (o.pairs != nullptr) {
    return new FileSource(o.pairs);
  }
  if (o.mesh[0] != nullptr) {
    return new MeshSource(o.mesh, o.grid);
  }
  return new FamilySource(o.count, o.seed);
}

int report(const Bench &bench, uint64_t sent, double seconds, bool stressed) {
  double clock_ms = 1e3 * (double)bench.last_verdict_cycle / CLOCK_HZ;
  std::printf("%s\n", SEPAX_OPTIONS);
  std::printf("%llu pairs, %llu mismatches, %llu collisions, %llu coplanar\n",
              (unsigned long long)bench.judged, (unsigned long long)bench.mismatches,
              (unsigned long long)bench.collisions, (unsigned long long)bench.coplanar);
  if (stressed) {
    std::printf("random gaps, %llu resets, %llu pairs dropped by them\n",
                (unsigned long long)bench.resets, (unsigned long long)bench.dropped);
  } else {
    std::printf("latency %d, II %d: each verdict in its cycle; %llu cycles = %.3f ms at 500 MHz\n",
                SEPAX_LATENCY, SEPAX_II, (unsigned long long)bench.last_verdict_cycle, clock_ms);
  }
  std::printf("simulated in %.1f s, %.0f pairs/s\n", seconds,
              seconds > 0 ? (double)sent / seconds : 0.0);
  if (sent == 0) {
    std::fprintf(stderr, "cosim: no pairs were given; that is no test\n");
    return EXIT_ERROR;
  }
  if (bench.judged + bench.dropped != sent && bench.mismatches == 0) {
    std::fprintf(stderr, "cosim: %llu pairs sent, %llu judged\n", (unsigned long long)sent,
                 (unsigned long long)bench.judged);
    return 1;
  }
  return bench.mismatches == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
  const argp_child children[] = {{&cli_grid_argp, 0, nullptr, 0}, {nullptr, 0, nullptr, 0}};
  const argp parser = {options_table,
                       parse,
                       "[A.stl B.stl]",
                       "Co-simulate the generated machine (" SEPAX_OPTIONS
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
  std::unique_ptr<Source> source(open_source(options));
  Bench bench(options, design);
  sepax_pair pair;
  uint64_t sent = 0;
  cli_progress progress = cli_progress_begin("pairs through the machine", source->total());
  while (!bench.too_many() && source->next(&pair)) {
    bench.send(sent++, pair);
    cli_progress_show(&progress, sent);
  }
  bench.drain();
  return report(bench, sent, cli_progress_end(&progress), options.stress != 0);
}
