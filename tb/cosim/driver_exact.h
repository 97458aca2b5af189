// driver_exact.h - drives architecture exact: a pair in one transfer, valid/ready on both
// sides; verdicts in the order of the pairs.
#ifndef SEPAX_DRIVER_EXACT_H
#define SEPAX_DRIVER_EXACT_H

#include "design_under_test.h"

class Driver : public DesignUnderTest {
public:
  Driver(const char *wave, uint64_t stress, const sepax_design &design)
      : DesignUnderTest(wave, stress, design) {
    top->rst = 1;
    top->in_valid = 0;
    top->out_ready = 1;
    settle();
    rise();
    settle();
    rise();
    top->rst = 0;
    cycle = 0;
    until_reset = next_reset();
  }

  // Offer the pair until it is taken; false when the design hangs.
  bool send(uint64_t index, const sepax_pair &pair) {
    Outstanding e{index, 0, false, sepax_judge(&design, &pair), pair};
    drive(pair);
    while (!hung) {
      if (stress != 0 ? stressed_tick(&pair) : tick(true, true)) {
        e.cycle = cycle;
        e.alone = idle >= SETTLE;
        if (scoreboard.full()) {
          hang("more pairs were taken than the design can hold");
        }
        scoreboard.push(e);
        taken(e);
        return true;
      }
    }
    return false;
  }

  void drain() {
    while (!scoreboard.empty() && !hung) {
      if (stress != 0) {
        stressed_tick(nullptr);
      } else {
        tick(false, true);
      }
    }
    for (int i = 0; i < 4 * (SEPAX_LATENCY + SEPAX_II) && !hung; i++) {
      tick(false, true); // a verdict too many is seen here
    }
    complain_never_came();
    if ((coplanar == 0 || !SECOND_PASS) && !hung && stream_cycles() > stream_allowed()) {
      std::fprintf(stderr,
                   "cosim: %llu cycles from the first to the last of %llu pairs; "
                   "II = %d allows %llu\n",
                   (unsigned long long)stream_cycles(), (unsigned long long)streamed, SEPAX_II,
                   (unsigned long long)stream_allowed());
      mismatches++;
    }
  }

  void report() const {
    std::printf("axes 0 ... %d:", LAST_AXIS);
    for (int axis = 0; axis <= LAST_AXIS; axis++) {
      std::printf(" %llu", (unsigned long long)axes[axis]);
    }
#ifdef SEPAX_BANDS
    std::printf("\nbands free, warning, collision: %llu %llu %llu", (unsigned long long)bands[0],
                (unsigned long long)bands[1], (unsigned long long)bands[2]);
#endif
    std::printf("\nlatency %d: %llu pairs that met an empty core; ", SEPAX_LATENCY,
                (unsigned long long)latencies);
    if (stress != 0) {
      std::printf("random gaps and blocks, %llu resets, %llu pairs dropped by them\n",
                  (unsigned long long)resets, (unsigned long long)dropped);
      return;
    }
    std::printf("II %d", SEPAX_II);
    if (streamed > 1) {
      std::printf(": %.4f cycles a pair", (double)stream_cycles() / (double)(streamed - 1));
    }
    std::printf("; %llu cycles = %.3f ms at %g ns\n", (unsigned long long)last_verdict_cycle,
                1e-9 * (double)last_verdict_cycle * design.config.clock_ps,
                1e-3 * design.config.clock_ps);
  }

private:
#if defined SEPAX_EXTENT_A
  static constexpr int LAST_AXIS = SEPAX_AXIS_EXTENT;
#elif defined SEPAX_BOXES || defined SEPAX_BANDS
  static constexpr int LAST_AXIS = SEPAX_AXIS_AABB;
#else
  static constexpr int LAST_AXIS = 12;
#endif
#ifdef SEPAX_BANDS
  static constexpr bool SECOND_PASS = false;
#else
  static constexpr bool SECOND_PASS = true;
#endif
  // Without stress the first pairs go alone, until so many latencies were seen.
  static constexpr uint64_t ALONE_LATENCIES = 3, ALONE_PAIRS = 32;
  // A pair is alone after so many idle cycles. Behind an AABB test a pair may be taken
  // before the II window of the core, empty by then, ends.
#ifdef SEPAX_BOXES
  static constexpr uint64_t SETTLE = 1 + 2 * SEPAX_II;
#else
  static constexpr uint64_t SETTLE = 1;
#endif
  // Cycles of waiting, out_ready high, with no transfer on either side.
  static constexpr uint64_t PATIENCE = 2000 + 64 * (SEPAX_LATENCY + SEPAX_II);

  struct Verdict {
    bool valid, collision, coplanar;
    int axis, band;
    bool operator!=(const Verdict &v) const {
      return valid != v.valid || collision != v.collision || coplanar != v.coplanar ||
             axis != v.axis || band != v.band;
    }
  };

  Verdict shown() const {
    return {top->out_valid != 0, top->out_collision != 0, top->out_coplanar != 0,
            (int)top->out_axis, shown_band()};
  }

#ifdef SEPAX_BANDS
  int shown_band() const { return (int)top->out_band; }
#else
  static int shown_band() { return 0; }
#endif

  void drive(const sepax_pair &p) {
    top->in_a1_x = word_bits(p.a.v[0].x);
    top->in_a1_y = word_bits(p.a.v[0].y);
    top->in_a1_z = word_bits(p.a.v[0].z);
    top->in_a2_x = word_bits(p.a.v[1].x);
    top->in_a2_y = word_bits(p.a.v[1].y);
    top->in_a2_z = word_bits(p.a.v[1].z);
    top->in_a3_x = word_bits(p.a.v[2].x);
    top->in_a3_y = word_bits(p.a.v[2].y);
    top->in_a3_z = word_bits(p.a.v[2].z);
    top->in_b1_x = word_bits(p.b.v[0].x);
    top->in_b1_y = word_bits(p.b.v[0].y);
    top->in_b1_z = word_bits(p.b.v[0].z);
    top->in_b2_x = word_bits(p.b.v[1].x);
    top->in_b2_y = word_bits(p.b.v[1].y);
    top->in_b2_z = word_bits(p.b.v[1].z);
    top->in_b3_x = word_bits(p.b.v[2].x);
    top->in_b3_y = word_bits(p.b.v[2].y);
    top->in_b3_z = word_bits(p.b.v[2].z);
  }

  // One clock cycle; true if a pair is offered and taken in it.
  bool tick(bool offer, bool ready) {
    top->in_valid = offer;
    top->out_ready = ready;
    settle();
    if (stress != 0) {
      check_independence(offer, ready);
    }
    was_empty = scoreboard.empty();
    idle = was_empty ? idle + 1 : 0;
    bool take = offer && top->in_ready;
    bool give = top->out_valid && ready;
    look(ready);
    rise();
    if (!ready) {
      blocked = cycle;
    }
    if (take || give) {
      waited = 0;
    } else if (ready && (offer || !was_empty) && ++waited > PATIENCE) {
      hang(offer ? "time-out: no pair is taken" : "time-out: no verdict comes");
    }
    return take;
  }

  void look(bool ready) {
    if (blocked_verdict.valid && shown() != blocked_verdict) {
      complain(scoreboard.empty() ? nullptr : &scoreboard.front(),
               "a verdict moves while it is blocked");
    }
    blocked_verdict = {};
    if (!top->out_valid) {
      return;
    }
    if (scoreboard.empty()) {
      complain(nullptr, "a verdict that nobody asked for");
      return;
    }
    if (!ready) {
      blocked_verdict = shown();
      return;
    }
    const Outstanding &e = scoreboard.front();
    scoreboard.pop();
    count(e);
#ifdef SEPAX_EXTENT_A
    if ((top->out_of_range != 0) != (e.verdict.axis == SEPAX_AXIS_EXTENT)) {
      complain(&e, "wrong out_of_range");
    }
#endif
    if (shown().band != (int)e.verdict.band) {
      complain_axis(e);
    } else if (shown().axis == e.verdict.axis) {
      axes[e.verdict.axis]++;
      bands[e.verdict.band]++;
      compare(e);
    } else {
      complain_axis(e);
    }
    if (!e.verdict.coplanar || !SECOND_PASS) {
      check_latency(e);
    }
  }

  void complain_axis(const Outstanding &e) {
    char text[112];
    Verdict v = shown();
    std::snprintf(text, sizeof text, "expected %s, axis %d, band %d; got %s, axis %d, band %d",
                  e.verdict.collision ? "collision" : "separated", e.verdict.axis,
                  (int)e.verdict.band, v.collision ? "collision" : "separated", v.axis, v.band);
    complain(&e, text);
  }

  // Never earlier; not later where nothing was in the way.
  void check_latency(const Outstanding &e) {
    uint64_t took = cycle - e.cycle + 1;
    bool free = e.alone && blocked < e.cycle;
    latencies += free;
    if (took < SEPAX_LATENCY || (free && took != SEPAX_LATENCY)) {
      char text[80];
      std::snprintf(text, sizeof text, "verdict in cycle %llu from taking the pair, not %d",
                    (unsigned long long)took, SEPAX_LATENCY);
      complain(&e, text);
    }
  }

  void taken(const Outstanding &e) {
    if (stress != 0) {
      return;
    }
    if (latencies < ALONE_LATENCIES && e.index < ALONE_PAIRS) {
      while (!scoreboard.empty() && !hung) {
        tick(false, true);
      }
      for (uint64_t i = 0; i < SETTLE; i++) {
        tick(false, true); // the verdict has left, and an II window that has begun ends
      }
      return;
    }
    if (streamed++ == 0) {
      first_taken = e.cycle;
    }
    last_taken = e.cycle;
  }

  uint64_t stream_cycles() const { return last_taken - first_taken; }
  uint64_t stream_allowed() const {
    return streamed == 0 ? 0 : (streamed - 1) * SEPAX_II + SEPAX_LATENCY;
  }

  void hang(const char *what) {
    complain(scoreboard.empty() ? nullptr : &scoreboard.front(), what);
    hung = true;
  }

  // ------------------------------------------------------------------------ stress

  // A stretch of cycles in which a signal is 1 in `eighths` of 8 cycles.
  struct Stretch {
    uint64_t left, eighths;
  };

  bool next(Stretch *s) {
    static const uint64_t rates[] = {0, 1, 4, 7, 8};
    if (s->left == 0) {
      s->left = 1 + draw() % (8 * SEPAX_LATENCY);
      s->eighths = rates[draw() % 5];
    }
    s->left--;
    return draw() % 8 < s->eighths;
  }

  // A cycle with anything on the data inputs when no pair is offered; now and then a
  // reset, which drops every pair in flight.
  bool stressed_tick(const sepax_pair *pair) {
    if (until_reset-- == 0) {
      reset();
    }
    bool offer = next(&offering) && pair != nullptr;
    if (offer) {
      drive(*pair);
    } else {
      drive_noise();
    }
    return tick(offer, next(&accepting));
  }

  void drive_noise() {
    sepax_pair noise;
    for (int k = 0; k < 18; k++) {
      coordinate(&noise, k) = (int32_t)(uint32_t)draw();
    }
    drive(noise);
  }

  // A few cycles or many thousand.
  uint64_t next_reset() {
    uint64_t most = UINT64_C(8) << draw() % 13;
    return draw() % most;
  }

  // Nothing is handed over in a cycle of reset, whatever valid and ready say.
  void reset() {
    until_reset = next_reset();
    top->rst = 1;
    do {
      drive_noise();
      top->in_valid = draw() % 2;
      top->out_ready = draw() % 2;
      settle();
      rise();
    } while (chance(3));
    top->rst = 0;
    drop_outstanding();
    blocked_verdict = {};
    waited = 0;
  }

  void check_independence(bool offer, bool ready) {
    bool in_ready = top->in_ready;
    Verdict before = shown();
    top->in_valid = !offer;
    top->eval();
    if ((top->in_ready != 0) != in_ready) {
      complain(nullptr, "in_ready depends on in_valid of the same cycle");
    }
    top->in_valid = offer;
    top->out_ready = !ready;
    top->eval();
    if (shown() != before) {
      complain(nullptr, "the verdict depends on out_ready of the same cycle");
    }
    top->out_ready = ready;
    top->eval();
  }

  Stretch offering{0, 0}, accepting{0, 0};
  Verdict blocked_verdict{}; // shown and blocked in the cycle before
  bool was_empty = true;     // before this cycle
  uint64_t idle = 0;         // cycles for which it has been empty, this one, too
  uint64_t until_reset = 0, blocked = 0, waited = 0, latencies = 0, axes[LAST_AXIS + 1] = {};
  uint64_t bands[3] = {};
  uint64_t streamed = 0, first_taken = 0, last_taken = 0;
};

#endif
