// driver_paper.h - drives architectures paper and conference: three input words a pair, no
// waiting; each verdict in its cycle.
#ifndef SEPAX_DRIVER_PAPER_H
#define SEPAX_DRIVER_PAPER_H

#include "design_under_test.h"

class Driver : public DesignUnderTest {
public:
#ifdef SEPAX_CONFERENCE
  static constexpr double CLOCK_MHZ = 400; // table 4
#else
  static constexpr double CLOCK_MHZ = 500;
#endif
  static constexpr int INPUT_WORDS = 3;

  Driver(const char *wave, uint64_t stress, const sepax_design &design)
      : DesignUnderTest(wave, stress, design) {
    top->rst = 1;
    idle();
    tick();
    tick();
    top->rst = 0;
    cycle = 0;
  }

  bool send(uint64_t index, const sepax_pair &pair) {
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
          scoreboard.push({index, cycle + 1 + SEPAX_LATENCY - INPUT_WORDS, false,
                           sepax_judge(&design, &pair), pair});
        }
        tick();
      }
      idle();
      if (resets == sent_with) {
        return true;
      }
    }
  }

  void drain() {
    idle();
    for (int i = 0; i < 2 * SEPAX_LATENCY && !scoreboard.empty(); i++) {
      tick();
    }
    for (int i = 0; i < SEPAX_LATENCY; i++) {
      tick(); // a verdict too many is seen here
    }
    complain_never_came();
  }

  void report() const {
    if (stress != 0) {
      std::printf("random gaps, %llu resets, %llu pairs dropped by them\n",
                  (unsigned long long)resets, (unsigned long long)dropped);
    } else {
      std::printf(
          "latency %d, II %d: each verdict in its cycle; %llu cycles = %.3f ms at %.0f MHz\n",
          SEPAX_LATENCY, SEPAX_II, (unsigned long long)last_verdict_cycle,
          1e-3 * (double)last_verdict_cycle / CLOCK_MHZ, CLOCK_MHZ);
    }
  }

private:
  void drive(const sepax_pair &pair, int k) {
    const sepax_vec &a = pair.a.v[k];
    const sepax_vec &b = pair.b.v[k];
    const int32_t na[] = {pair.na.x, pair.na.y, pair.na.z};
    const int32_t nb[] = {pair.nb.x, pair.nb.y, pair.nb.z};
    top->in_valid = 1;
    top->in_a_x = word_bits(a.x);
    top->in_a_y = word_bits(a.y);
    top->in_a_z = word_bits(a.z);
    top->in_b_x = word_bits(b.x);
    top->in_b_y = word_bits(b.y);
    top->in_b_z = word_bits(b.z);
    top->in_na = word_bits(na[k]);
    top->in_nb = word_bits(nb[k]);
  }

  void idle() { top->in_valid = 0; }

  // A gap with whatever on the data inputs; now and then a reset, which drops every
  // pair in flight.
  void disturb() {
    sepax_pair noise = sepax_family_pair(0, SEPAX_WORD, &random);
    drive(noise, 0);
    idle();
    if (chance(200)) {
      top->rst = 1;
      tick();
      top->rst = 0;
      drop_outstanding();
    } else {
      tick();
    }
  }

  void tick() {
    settle();
    if (top->rst == 0) {
      look();
    }
    rise();
  }

  void look() {
    bool due = !scoreboard.empty() && scoreboard.front().cycle == cycle;
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
    const Outstanding &e = scoreboard.front();
    scoreboard.pop();
    count(e);
    if (!top->out_valid) {
      complain(&e, "no verdict in the cycle where it is due");
    } else {
      compare(e);
    }
  }
};

#endif
