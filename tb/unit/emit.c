/* SPDX-License-Identifier: MIT */
/* emit.c - what the Verilog templates may say, what of it is refused, and that every design passes.
 */
#include "arith/arith.h"
#include "conference/conference.h"
#include "emit/prefix.h"
#include "emit/template.h"
#include "harness.h"
#include "paper/paper.h"
#include "tree_engine/boxes/boxes.h"
#include "tree_engine/memory/memory.h"
#include "tree_engine/walk/walk.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char head[] = "// A module.\n"
                           "module @name@ #(\n"
                           "  parameter W = 8, // bits\n"
                           "  parameter N = 3  // words, 1 ...\n"
                           ") (\n"
                           "  input  wire           clk, // clock\n"
                           "  input  wire           en,  // take it\n"
                           "  input  wire [1:0]     sel, // which\n"
                           "  input  wire [W-1:0]   a,   // a word\n"
                           "  input  wire [N*W-1:0] all, // words\n"
                           "  input wire signed [W-1:0] b, // a number\n"
                           "  input  wire [3:0]     s,   // a number\n"
                           "//@ if wide\n"
                           "  input  wire [W:0]     more, // a word more\n"
                           "//@ end\n"
                           "  output wire [W-1:0]   y,   // a word\n"
                           "  output reg            t,   // a flag\n"
                           "  output reg  [N*W-1:0] q    // words\n"
                           ");\n";

static const emit_hole no_holes[] = {{"name", "small"}, {"wide", ""}, {NULL, NULL}};

/* Emit head and body, behind another module if there is one, and compare the refusal; NULL: none.
 */
static void expect_behind(const char *first, const emit_hole *holes, const char *begin,
                          const char *body, const char *refusal) {
  emitter e;
  char text[4096];
  emit_init(&e, NULL, "test");
  assert_true(first == NULL || emit_template_text(&e, "first", first, no_holes));
  snprintf(text, sizeof text, "%s%s\nendmodule\n", begin, body);
  bool ok = emit_template_text(&e, "small", text, holes);
  if (ok != (refusal == NULL) || (!ok && strstr(e.error.text, refusal) == NULL)) {
    fail_msg("'%s': %s", body, ok ? "accepted" : e.error.text);
  }
  emit_free(&e);
}

static void expect_with(const emit_hole *holes, const char *begin, const char *body,
                        const char *refusal) {
  expect_behind(NULL, holes, begin, body, refusal);
}

static void expect(const char *body, const char *refusal) {
  expect_with(no_holes, head, body, refusal);
}

CASE(test_declarations) {
  expect("  localparam S = 2 * W;\n  wire [S-1:0] d = {a, a};\n  assign y = d[W +: W];", NULL);
  expect("  localparam [3:0] LIMIT = N;\n  wire f = a[3:0] == LIMIT;", NULL);
  expect("  localparam [0:0] LIMIT = N;", "exceeds the size of 'LIMIT'");
  expect("  wire [W-1:0] d = all;", "8 bits against 24");
  expect("  wire [0:3] d;", "no bits in 'd'");
  expect("  wire signed [W-9:0] d;", "no bits in 'd'");
  expect("  wire [9:4] d;\n  wire f = d[9] && d[4] && &d[7:5];", NULL);
  expect("  wire [9:4] d;\n  wire f = d[3];", "select outside of 'd'");
  expect("  wire [9:4] d;\n  wire f = d[10];", "select outside of 'd'");
  expect("  wire a;", "'a' is declared twice");
  expect("  wire cross;", "a word of SystemVerilog as a name: 'cross'");
  expect("  wire units;", "a word of Verilog-AMS as a name: 'units'");
  expect("  wire zi_zp;", "a word of Verilog-AMS as a name: 'zi_zp'");
  expect("  wire above_2, my_units;", NULL);
  expect("  assign y = n;\n  wire [W-1:0] n;", "undeclared signal 'n'");
  expect("  wire f = a == 2'd4;", "exceeds its size");
  expect("  wire [W-1:0] p, m;\n  assign {p, m} = {a, a};", NULL);
  expect("  assign q = all;", "no wire: 'q'");
  expect("  always @(posedge clk) begin\n    y <= a;\n  end", "a wire is assigned in an always");
}

CASE(test_memories) {
  expect("  reg [W-1:0] word_q [0:N-1];\n"
         "  assign y = word_q[sel];\n"
         "  always @(posedge clk) begin\n    word_q[sel] <= a;\n  end",
         NULL);
  expect("  reg [W-1:0] word_q [0:N-1];\n  assign y = word_q[en];", "index: 1 bits against 2");
  expect("  reg [W-1:0] word_q [0:N-1];\n  assign y = word_q[3];", "select outside of 'word_q'");
  expect("  reg [W-1:0] word_q [0:N-1];\n  wire f = word_q[2][7];", NULL);
  expect("  reg [W-1:0] word_q [0:N-1];\n  wire f = word_q[2][8];", "select outside of 'word_q'");
}

CASE(test_loops) {
  static const char loop[] = "  integer i;\n"
                             "  always @(posedge clk) begin\n"
                             "    for (i = %d; i < N; i = i + 1) begin\n"
                             "      if (en && sel == i[1:0]) begin\n"
                             "        q[i*W +: %s] <= a;\n"
                             "      end\n"
                             "    end\n"
                             "  end";
  char text[1024];
  snprintf(text, sizeof text, loop, 0, "W");
  expect(text, NULL);
  snprintf(text, sizeof text, loop, -1, "W");
  expect(text, "select outside of 'q'");
  snprintf(text, sizeof text, loop, 0, "W-1");
  expect(text, "7 bits against 8");
  expect("  genvar k;\n"
         "  generate\n"
         "    for (k = 0; k < N; k = k + 1) begin : each\n"
         "      wire [W-1:0] mine;\n"
         "      assign mine = all[k*W +: W];\n"
         "      if (k == N - 1) begin : last\n"
         "        assign y = mine;\n"
         "      end else begin : other\n"
         "        wire [W-1:0] next;\n"
         "        assign next = all[(k+1)*W +: W] ^ mine;\n"
         "      end\n"
         "    end\n"
         "  endgenerate",
         NULL);
  expect("  genvar k;\n  generate\n    for (k = 0; k < N; k = k + 1) begin : each\n"
         "      wire [W-1:0] next = all[(k+1)*W +: W];\n    end\n  endgenerate",
         "select outside of 'all'");
  expect("  genvar k;\n  generate\n    for (k = 0; k < N; k = k) begin : each\n"
         "      wire mine;\n    end\n  endgenerate",
         "a loop without an end");
  expect("  integer i;\n  wire f = a == i;", "without a size");
}

CASE(test_statements) {
  expect("  always @(posedge clk) begin\n"
         "    case (sel)\n"
         "      2'd0, 2'd1: q[W-1:0] <= a;\n"
         "      default: q <= all;\n"
         "    endcase\n"
         "  end",
         NULL);
  expect("  always @(posedge clk) begin\n    casez ({en, sel})\n      3'b1??: q <= all;\n"
         "      default: q <= {N{a}};\n    endcase\n  end",
         NULL);
  expect("  always @(posedge clk) begin\n    case (sel)\n      3'd0: q <= all;\n    endcase\n  end",
         "case: 2 bits against 3");
  expect("  always @(*) begin\n    q = all;\n  end", NULL);
  expect("  always @(*) begin\n    q <= all;\n  end", "<= in a combinational block");
  expect("  always @(posedge clk) begin\n    q = all;\n  end", "expected '<='");
  expect("  function [W-1:0] twice(input [W-1:0] x, input f);\n"
         "    twice = f ? {x[W-2:0], 1'b0} : x;\n  endfunction\n"
         "  assign y = twice(a, en);",
         NULL);
  expect("  function [W-1:0] twice(input [W-1:0] x);\n    twice = x;\n  endfunction\n"
         "  assign y = twice(sel);",
         "twice: 2 bits against 8");
  expect("  /* any */ (* keep *) wire f = a[$clog2(W)] && a < 8'h1f; // f", NULL);
  expect("  initial q = all;", "not understood");
  expect("`ifdef FORMAL\n  initial assume (en);\n  always @(posedge clk) begin\n"
         "    if (!$initstate) begin\n      assert ($past(a) == y || $stable(sel));\n    end\n"
         "  end\n`endif",
         NULL);
  expect("`ifdef FORMAL\n  always @(posedge clk) begin\n    assert (a);\n  end\n`endif",
         "condition: 8 bits against 1");
}

CASE(test_widths) {
  expect("assign y = a + b;", NULL);
  expect("assign y = (a < b) ? a : (b - a);", NULL);
  expect("assign y = {{(W-4){s[3]}}, s};", NULL);
  expect("assign y = {s, s[3:2], 2'd1};", NULL);
  expect("assign y = 8'sd5; // a comment", NULL);
  expect("always @(posedge clk) begin\n  if (t) begin\n    t <= !(a == b) && &s;\n  end "
         "else begin\n    t <= 1'b0;\n  end\nend",
         NULL);
  expect("assign y = a + c;", "undeclared signal 'c'");
  expect("assign z = a;", "undeclared signal 'z'");
  expect("assign a = b;", "an input is assigned");
  expect("assign y = s;", "8 bits against 4");
  expect("assign y = a + s;", "8 bits against 4");
  expect("assign y = {a, s};", "8 bits against 12");
  expect("assign y = {{(W-8){s[3]}}, a};", "replication by less than one");
  expect("assign y = a[8:1];", "select outside of 'a'");
  expect("assign y = t ? a : s;", "8 bits against 4");
  expect("assign y = s ? a : b;", "4 bits against 1");
  expect("assign y = (a == s) ? a : b;", "8 bits against 4");
  expect("assign y = 5;", "without a size");
  expect("assign y = W;", "without a size");
  expect("assign y = a +;", "not understood");
  expect("assign y = a", "expected ';'");
  expect("assign y = a; initial t = 1'b0;", "not understood");
  expect("always @(posedge clk) begin\n t <= a;\nend", "1 bits against 8");
  expect("always @(negedge clk) begin\n t <= 1'b0;\nend", "@(posedge clk)");
}

CASE(test_holes) {
  static const emit_hole wide[] = {{"name", "large"}, {"wide", "1"}, {NULL, NULL}};
  static const emit_hole short_of[] = {{"wide", "1"}, {NULL, NULL}};
  static const char nested[] = "//@ if wide\n//@ if !name\n  wire n = 0;\n//@ else\n  assign y ="
                               " more[W-1:0];\n//@ end\n//@ else\n  assign y = a;\n//@ end";
  expect_with(wide, head, "  assign y = more[W:1];", NULL);
  expect("  assign y = more[W:1];", "undeclared signal 'more'");
  expect_with(wide, head, nested, NULL);
  expect(nested, NULL);
  static const char inlined[] = "  assign y = more[W:1]; // a line //@ wide\n"
                                "  assign y = a; //@ !wide\n  wire n = nothing; //@ !name";
  expect_with(wide, head, inlined, NULL);
  expect(inlined, NULL);
  expect("  assign y = a; //@ no wide", "no text for the hole @no wide@");
  expect_with(short_of, head, "", "no text for the hole @name@");
  expect("//@ if wide", "//@ if without //@ end");
  expect("//@ for wide", "not understood: //@ for wide");
  expect("  // 3456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 "
         "123456789 123456789",
         "more than 100 columns");
  expect_with(NULL, "module m (\n  input wire a\n);\n", "", "no comment");
  expect_with(NULL, "module m (\n  input wire a // port\n);\nendmodule\n", "", "text behind");
}

static void expect_top(const char *body, const char *refusal) {
  static const char leaf[] =
      "// A leaf.\nmodule leaf #(\n  parameter W = 8, // bits\n"
      "  parameter V = W + 1 // bits\n) (\n"
      "  input wire [W-1:0] a, // word\n  output wire [V-1:0] y // word\n);\n"
      "  generate\n    if (W < 4) begin : check\n"
      "      leaf_W_must_be_at_least_4 fault ();\n    end\n  endgenerate\n"
      "  assign y = {a, 1'b0};\nendmodule\n";
  static const char top[] =
      "module top #(\n  parameter W = 5 // bits\n) (\n  input wire [W-1:0] a, // word\n"
      "  output wire [W:0] y // word\n);\n";
  expect_behind(leaf, no_holes, top, body, refusal);
}

/* A template instantiates and is instantiated; the checks follow the parameters. */
CASE(test_instances) {
  expect_top("leaf #(.W(5)) inner (.a(a), .y(y));", NULL);
  expect_top("leaf #(.W(W)) inner (.a(a), .y(y));", NULL);
  expect_top("leaf #(.W(4)) inner (.a(a[3:0]), .y(y[4:0]));", NULL);
  expect_top("leaf #(.W(5)) inner (.a(a), .y({y[5:1], y[0]}));", NULL);
  expect_top("leaf #(.W(4)) inner (.a(a), .y(y));", "port 'a' has 4 bits, its connection 5");
  expect_top("leaf inner (.a(a), .y(y));", "port 'a' has 8 bits");
  expect_top("leaf #(.W(5)) inner (.a(a), .a(a), .y(y));", "connected twice");
  expect_top("leaf #(.W(5)) inner (.a(a), .y(y), .z(a));", "no port 'z'");
  expect_top("leaf #(.W(5)) inner (.a(a), .y(v));", "undeclared signal 'v'");
  expect_top("leaf #(.W(5), .V(5)) inner (.a(a), .y(y[5:1]));", "5 bits against 6");
  expect_top("leaf #(.W(3)) inner (.a(a[2:0]), .y(y[3:0]));", "leaf_W_must_be_at_least_4");
  expect_top("leaf #(.W(5)) inner (.a(a), .y(a));", "an input is assigned");
  expect_top("leaf #(.W(5)) inner (.a(a));", "1 of the 2 ports are connected of 'leaf'");
  expect_top("leaf #(.X(5)) inner (.a(a), .y(y));", "no parameter 'X'");
  expect_top("leaf #(.W(2+1+2+0+0+0+0+0+0+0+0+0+0+0+0+0+0+0+0+0+0+0+0+0)) inner (.a(a), .y(y));",
             NULL);
  expect_top("twig #(.W(5)) inner (.a(a), .y(y));", "not emitted yet: 'twig'");
  expect_behind("module same (\n  input wire a // bit\n);\nendmodule\n", NULL,
                "module same (\n  input wire a // bit\n);", "", "emitted twice");
}

/* A block in a block has a name of its own. */
CASE(test_labels) {
  static const char within[] = "  genvar i, k;\n  generate\n"
                               "    for (i = 0; i < N; i = i + 1) begin : %s\n"
                               "      for (k = 0; k < 2; k = k + 1) begin : %s\n"
                               "        wire f = a[k];\n      end\n    end\n"
                               "    for (i = 0; i < 2; i = i + 1) begin : %s\n"
                               "      wire g = a[i];\n    end\n  endgenerate";
  expect(gen_format(within, "outer", "inner", "last").text, NULL);
  expect(gen_format(within, "axis", "axis", "last").text, "'axis' names a block around it, too");
}

/* Modules that nobody needs go, with what only they need; a name that is part of another does not
 * count. */
CASE(test_drop_unused) {
  static const char text[] = "// A module.\nmodule @name@ (\n  input wire a // bit\n);\n@of@\n"
                             "endmodule\n";
  static const char *const row[][2] = {{"leaf", ""},
                                       {"leaf_2", ""},
                                       {"lonely_leaf", ""},
                                       {"lonely", "  lonely_leaf l (.a(a));\n  leaf m (.a(a));"},
                                       {"twig", "  leaf_2 l (.a(a));"},
                                       {"top", "  twig t (.a(a));"}};
  emitter e;
  emit_init(&e, NULL, "test");
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    const emit_hole hole[] = {{"name", row[i][0]}, {"of", row[i][1]}, {NULL, NULL}};
    assert_true(emit_template_text(&e, row[i][0], text, hole));
  }
  emit_drop_unused(&e);
  assert_int_equal(e.modules, 3);
  assert_string_equal(e.module[0]->name, "leaf_2");
  assert_string_equal(e.module[1]->name, "twig");
  assert_string_equal(e.module[2]->name, "top");
  emit_free(&e);
}

static void expect_prefix(const char *text, const char *prefix, const char *want) {
  emit_text out = {NULL};
  prefix_put(&out, text, prefix);
  char *got = text_take(&out);
  assert_string_equal(got, want);
  free(got);
}

CASE(test_prefix) {
  expect_prefix("sepax_fa a (sepax_b); `ifdef SEPAX_X", "left",
                "left_fa a (left_b); `ifdef LEFT_X");
  expect_prefix("sepax_", "a1_b", "a1_b_");
  expect_prefix("SEPAX_SEPAX_sepax_", "a1_b", "A1_B_SEPAX_sepax_");
  expect_prefix("sepax gen, sepax.f, sepaxes, my_sepax_x, 1sepax_x, $sepax_x, Sepax_x", "left",
                "sepax gen, sepax.f, sepaxes, my_sepax_x, 1sepax_x, $sepax_x, Sepax_x");
  expect_prefix("sepax_a\nSEPAX_b", "sepax", "sepax_a\nSEPAX_b");
  expect_prefix("", "left", "");
}

CASE(test_print) {
  emitter e;
  emit_text out = {NULL};
  emit_init(&e, NULL, "sepax gen");
  assert_true(emit_template_text(
      &e, "m",
      "// Bits of @w@.\n(* keep_hierarchy *)\nmodule m_@w@ (\n  input wire a, // bit  //@ w\n"
      "  output wire y // bit\n);\n  assign y = a;\nendmodule\n",
      (emit_hole[]){{"w", "3"}, {NULL, NULL}}));
  emit_print(emit_find(&e, "m_3"), &out);
  char *text = text_take(&out);
  assert_string_equal(
      text,
      "// m_3.v\n// SPDX-License-Identifier: MIT\n//\n// Bits of 3.\n//\n"
      "// Generated by sepax " SEPAX_VERSION
      "; do not edit. Made by:\n//   sepax gen\n\n`default_nettype none\n\n"
      "(* keep_hierarchy *)\nmodule m_3 (\n  input wire a, // bit\n  output wire y // bit\n);\n"
      "  assign y = a;\nendmodule\n\n`default_nettype wire\n");
  free(text);
  emit_free(&e);
}

/* After a refusal the modules of the tree engine, which need no design, say no more and do no harm.
 */
CASE(test_refused) {
  emitter e;
  emit_init(&e, NULL, "test");
  assert_false(emit_template_text(&e, "first", "module first;\n", NULL));
  const sepax_error refused = e.error;
  gen_tree_ram(&e, false);
  gen_tree_memory(&e, false);
  gen_multiplier_parts(&e, false);
  gen_turn_vertex(&e, delay_model_of(SEPAX_TARGET_ASIC), 18);
  gen_tree_compare(&e, delay_model_of(SEPAX_TARGET_ASIC));
  gen_tree_walk(&e, false, 3);
  assert_non_null(strstr(refused.text, "generator refuses first"));
  assert_string_equal(e.error.text, refused.text);
  emit_free(&e);
}

/* Every configuration (of `make experiment NAME=sanitize` every seventh word length) passes its own
 * check and prints the same bytes twice. */
CASE(test_designs) {
  static const char *const settings[] = {"--precision=full", "--precision=word",
                                         "--precision=guard=5", "--precision=word --block-float=on",
                                         "--coplanarity=paper --inequality=printed"};
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word += STEP) {
    for (size_t s = 0; s < 2 * sizeof settings / sizeof settings[0]; s++) {
      bool conference = s % 2 == 1;
      emitter e = {0};
      sepax_design design;
      sepax_config config = sepax_config_default();
      char *text[2] = {NULL, NULL};
      config.arch = conference ? SEPAX_ARCH_CONFERENCE : SEPAX_ARCH_PAPER;
      config.word = word;
      assert_true(sepax_config_parse(&config, settings[s / 2], &e.error));
      assert_true(sepax_design_init(&design, &config, &e.error));
      for (int run = 0; run < 2; run++) {
        emit_text out = {NULL};
        emit_init(&e, &design, "test");
        if (!(conference ? gen_conference(&e) : gen_paper(&e))) {
          fail_msg("W = %d %s: %s", word, settings[s / 2], e.error.text);
        }
        for (int i = 0; i < e.modules; i++) {
          emit_print(e.module[i], &out);
        }
        text[run] = text_take(&out);
        emit_free(&e);
      }
      assert_string_equal(text[0], text[1]);
      free(text[0]);
      free(text[1]);
    }
  }
}
