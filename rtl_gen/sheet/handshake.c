/* SPDX-License-Identifier: MIT */
/* handshake.c - see handshake.h. */
#include "sheet/handshake.h"

#include <stdio.h>

/* A cycle: a character for each lane. */
static void cycle(wave *w, const char *of_lanes) {
  for (int i = 0; i < w->lanes && of_lanes[i] != '\0'; i++) {
    wave_put(&w->lane[i], (const char[]){of_lanes[i], '\0'});
  }
}

static void gap(wave *w) { cycle(w, "||||||||||||"); }

/* Lanes with these names; NULL ends them. */
static void add_lanes(wave *w, const char *const *names) {
  for (; *names != NULL; names++) {
    wave_add(w, *names);
  }
}

static void add_labels(wave_lane *lane, const char *const *labels) {
  for (; *labels != NULL; labels++) {
    wave_label(lane, *labels);
  }
}

#define LIST(...) ((const char *const[]){__VA_ARGS__, NULL})

/* valid/ready: pair 1 waits until the core can take it, verdict 0 for out_ready. */
static void draw_core(int ii, wave *w) {
  add_lanes(w, LIST("clk", "in_valid", "in_ready", "in_a1_x ...", "out_valid", "out_ready",
                    "out_collision ..."));
  add_labels(&w->lane[3], LIST("P0", "P1"));
  cycle(w, "p01x00=");
  cycle(w, ".1.=...");
  cycle(w, ii > 1 ? "..0=..." : "...=...");
  if (ii > 3) {
    gap(w);
  } else if (ii == 3) {
    cycle(w, ".......");
  }
  if (ii > 1) {
    cycle(w, "..1....");
  }
  cycle(w, ii > 1 ? ".00x..." : ".0.x...");
  gap(w);
  cycle(w, "....1.=");
  cycle(w, ".....1.");
  if (ii > 2) {
    cycle(w, "....0.=");
  }
  if (ii > 3) {
    gap(w);
  }
  cycle(w, "....1.=");
  cycle(w, "....0.=");
  add_labels(&w->lane[6], ii > 2 ? LIST("0", "V0", "0", "V1", "0") : LIST("0", "V0", "V1", "0"));
}

/* AXI4-Stream: the transfers of a pair, and its verdict, which waits for a cycle. */
static void draw_stream(int transfers, wave *w) {
  add_lanes(w, LIST("aclk", "s_axis_tvalid", "s_axis_tready", "s_axis_tdata", "s_axis_tuser",
                    "m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser"));
  add_labels(&w->lane[3], transfers == 6   ? LIST("A1", "A2", "A3", "B1", "B2", "B3")
                          : transfers == 2 ? LIST("A", "B")
                                           : LIST("A, B"));
  add_labels(&w->lane[4], LIST("tag"));
  add_labels(&w->lane[7], LIST("V"));
  add_labels(&w->lane[8], LIST("tag"));
  cycle(w, "p01xx00xx");
  for (int i = 0; i < transfers; i++) {
    static const char *const row[2][2] = {{"...=.....", "...==...."}, {".1.=.....", ".1.==...."}};
    cycle(w, row[i == 0 ? 1 : 0][i + 1 == transfers ? 1 : 0]);
  }
  cycle(w, ".0.xx....");
  gap(w);
  cycle(w, ".....1.==");
  cycle(w, "......1..");
  cycle(w, ".....0.xx");
}

/* Three words a pair, without ready. */
static void draw_published(wave *w) {
  add_lanes(w, LIST("clk", "in_valid", "in_a_*", "in_b_*", "in_na", "in_nb", "out_valid",
                    "out_collision ..."));
  add_labels(&w->lane[2], LIST("A1", "A2", "A3", "A1", "A2", "A3"));
  add_labels(&w->lane[3], LIST("B1", "B2", "B3", "B1", "B2", "B3"));
  add_labels(&w->lane[4], LIST("x", "y", "z", "x", "y", "z"));
  add_labels(&w->lane[5], LIST("x", "y", "z", "x", "y", "z"));
  add_labels(&w->lane[7], LIST("0", "V0", "0", "V1", "0"));
  cycle(w, "p0xxxx0=");
  for (int i = 0; i < 6; i++) {
    cycle(w, i == 0 ? ".1====.." : "..====..");
  }
  cycle(w, ".0xxxx..");
  gap(w);
  cycle(w, "......1=");
  cycle(w, "......0=");
  cycle(w, "........");
  cycle(w, "......1=");
  cycle(w, "......0=");
}

/* AXI4-Lite: a write of 1. Address and data are held until the answer is made, in the cycle behind
 * them, or three cycles later on an FPGA (sepax_registers.v); no other is taken meanwhile. */
static void draw_engine(unsigned start, bool fpga, wave *w) {
  snprintf(w->text, sizeof w->text, "0x%02x", start);
  add_lanes(w, LIST("aclk", "s_axi_awvalid", "s_axi_awready", "s_axi_awaddr", "s_axi_wvalid",
                    "s_axi_wready", "s_axi_wdata", "s_axi_bvalid", "s_axi_bready", "irq"));
  wave_label(&w->lane[3], w->text);
  wave_label(&w->lane[6], "1");
  cycle(w, "p01x01x010");
  cycle(w, ".1.=1.=...");
  cycle(w, ".00x00x...");
  for (int i = 0; i < 3 && fpga; i++) {
    cycle(w, "..........");
  }
  cycle(w, "..1..1.1..");
  cycle(w, ".......0..");
  gap(w);
  cycle(w, ".........1");
  cycle(w, "..........");
}

void handshake_wave(const sepax_design *design, unsigned start, wave *w) {
  const sepax_config *c = &design->config;
  *w = (wave){.title = "Two pairs P0, P1 and their verdicts V0, V1"};
  if (c->arch != SEPAX_ARCH_EXACT) {
    draw_published(w);
    w->title = "Two pairs of three words each, and their verdicts V0, V1";
  } else if (c->stream != SEPAX_STREAM_NONE) {
    draw_stream(sepax_stream_transfers(c), w);
    w->title = "A pair and its verdict V";
  } else if (c->lanes > 0 || c->tree) {
    draw_engine(start, c->target != SEPAX_TARGET_ASIC, w);
    w->title = c->tree ? "A write starts a batch, an interrupt ends it"
                       : "A write starts a run, an interrupt ends it";
  } else {
    draw_core(c->ii, w);
  }
}
