/* emit.c - what the Verilog emitter must refuse, and what it must accept. */
#include "emit/emit.h"
#include "emit/gen.h"
#include "emit/template.h"
#include "harness.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
  sepax_design design;
  emitter e;
} fixture;

static void open_fixture(fixture *f) {
  sepax_config config = sepax_config_default();
  assert_true(sepax_design_init(&f->design, &config, &f->e.error));
  emit_init(&f->e, &f->design, "test");
}

/* Emit a module with inputs a, b of 8 bits, s of 4, and outputs y of 8 bits and t of 1. */
static bool small(emitter *e, const char *name, const char *body) {
  char text[2048];
  snprintf(text, sizeof text,
           "// A small module.\n"
           "module %s #(\n"
           "  parameter W = 8 // bits\n"
           ") (\n"
           "  input  wire                clk, // clock\n"
           "  input  wire signed [W-1:0] a, // number\n"
           "  input  wire signed [W-1:0] b, // number\n"
           "  input  wire        [3:0]   s, // number\n"
           "  output wire signed [W-1:0] y, // number\n"
           "  output reg                 t  // flag\n"
           ");\n%s\nendmodule\n",
           name, body);
  return emit_template_text(e, name, text, NULL);
}

/* `first`, if there is one, then a module with this body. */
static void expect_behind(const char *first, const char *name, const char *body,
                          const char *refusal) {
  fixture f;
  open_fixture(&f);
  if (first != NULL) {
    assert_true(small(&f.e, first, ""));
  }
  bool ok = small(&f.e, name, body);
  if (ok != (refusal == NULL)) {
    fail_msg("'%s': %s", body, ok ? "accepted" : f.e.error.text);
  }
  if (refusal != NULL && strstr(f.e.error.text, refusal) == NULL) {
    fail_msg("'%s': '%s' does not say '%s'", body, f.e.error.text, refusal);
  }
  emit_free(&f.e);
}

static void expect_text(const char *body, const char *refusal) {
  expect_behind(NULL, "small", body, refusal);
}

CASE(test_statements) {
  expect_text("assign y = a + b;", NULL);
  expect_text("assign y = (a < b) ? a : (b - a);", NULL);
  expect_text("assign y = {{(W-4){s[3]}}, s};", NULL);
  expect_text("assign y = {s, s[3:2], 2'd1};", NULL);
  expect_text("assign y = 8'sd5; // a comment", NULL);
  expect_text("always @(posedge clk) begin\n  if (t) begin\n    t <= !(a == b) && &s;\n  end "
              "else begin\n    t <= 1'b0;\n  end\nend",
              NULL);
  expect_text("assign y = a + c;", "undeclared signal 'c'");
  expect_text("assign z = a;", "undeclared signal 'z'");
  expect_text("assign a = b;", "an input is assigned");
  expect_text("assign y = s;", "8 bits against 4");
  expect_text("assign y = a + s;", "8 bits against 4");
  expect_text("assign y = {a, s};", "8 bits against 12");
  expect_text("assign y = {{(W-8){s[3]}}, a};", "replication by less than one");
  expect_text("assign y = a[8:1];", "select outside of 'a'");
  expect_text("assign y = t ? a : s;", "8 bits against 4");
  expect_text("assign y = s ? a : b;", "4 bits against 1");
  expect_text("assign y = (a == s) ? a : b;", "8 bits against 4");
  expect_text("assign y = 5;", "without a size");
  expect_text("assign y = W;", "without a size");
  expect_text("assign y = a +;", "not understood");
  expect_text("assign y = a", "expected ';'");
  expect_text("assign y = a; initial t = 1'b0;", "not understood");
  expect_text("always @(posedge clk) begin\n t <= a;\nend", "1 bits against 8");
  expect_text("always @(negedge clk) begin\n t <= 1'b0;\nend", "@(posedge clk)");
}

CASE(test_declarations) {
  expect_text("wire signed [W-1:0] a;", "'a' is declared twice");
  expect_text("assign y = n;\nwire signed [W-1:0] n;", "undeclared signal 'n'");
  expect_text("wire signed [W-9:0] n;", "no bits in");
  expect_behind("same", "same", "", "emitted twice");
}

static void expect_instance(const char *head, const char *connections, const char *refusal) {
  char body[512];
  snprintf(body, sizeof body, "wire u;\n%s inner (%s);", head, connections);
  expect_behind("small", "outer", body, refusal);
}

CASE(test_instances) {
  expect_instance("small #(.W(W))", ".clk(clk), .a(a), .b(b), .s(s), .y(y), .t(u)", NULL);
  expect_instance("small #(.W(4))", ".clk(clk), .a(s), .b(s), .s(s), .y(y[3:0]), .t(u)", NULL);
  expect_instance("small #(.W(9))", ".clk(clk), .a(a), .b(b), .s(s), .y(y), .t(u)",
                  "port 'a' has 9 bits");
  expect_instance("small", ".clk(clk), .a(a), .b(b), .s(a), .y(y), .t(u)", "port 's' has 4 bits");
  expect_instance("small", ".clk(clk), .a(a), .b(b), .s(s), .y(y)", "5 of the 6 ports");
  expect_instance("small", ".clk(clk), .a(a), .a(a), .b(b), .s(s), .y(y)", "connected twice");
  expect_instance("small", ".clk(clk), .a(a), .b(b), .s(s), .y(y), .z(u)", "no port 'z'");
  expect_instance("small", ".clk(clk), .a(a), .b(b), .s(s), .y(y), .t(v)", "undeclared signal 'v'");
  expect_instance("small #(.V(8))", ".clk(clk), .a(a), .b(b), .s(s), .y(y), .t(u)",
                  "no parameter 'V'");
  expect_instance("large", ".clk(clk)", "not emitted yet");
}

/* Every configuration passes its own check and prints the same bytes twice. */
CASE(test_designs) {
  static const char *const settings[] = {"--precision=full", "--precision=word",
                                         "--precision=guard=5", "--precision=word --block-float=on",
                                         "--coplanarity=paper --inequality=printed"};
  for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
    for (size_t s = 0; s < 2 * sizeof settings / sizeof settings[0]; s++) {
      bool conference = s % 2 == 1;
      fixture f = {0};
      sepax_config config = sepax_config_default();
      char *text[2] = {NULL, NULL};
      config.arch = conference ? SEPAX_ARCH_CONFERENCE : SEPAX_ARCH_PAPER;
      config.word = word;
      assert_true(sepax_config_parse(&config, settings[s / 2], &f.e.error));
      assert_true(sepax_design_init(&f.design, &config, &f.e.error));
      for (int run = 0; run < 2; run++) {
        size_t size = 0;
        FILE *out = open_memstream(&text[run], &size);
        emit_init(&f.e, &f.design, "test");
        if (!(conference ? gen_conference(&f.e) : gen_paper(&f.e))) {
          fail_msg("W = %d %s: %s", word, settings[s / 2], f.e.error.text);
        }
        for (int i = 0; i < f.e.modules; i++) {
          emit_print(f.e.module[i], out);
        }
        fclose(out);
        emit_free(&f.e);
      }
      assert_string_equal(text[0], text[1]);
      free(text[0]);
      free(text[1]);
    }
  }
}
