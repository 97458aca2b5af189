/* SPDX-License-Identifier: MIT */
/* template.h - modules that are Verilog files with named holes.
 *
 * A file rtl_gen/FOLDER/sepax_NAME.v looks like the module that it makes and is compiled into the
 * program. It is a comment (the banner: purpose, formula, latency), then one module, with or
 * without an attribute on the line before it (keep_hierarchy), whose parameters and ports stand
 * one on a line, each with a comment behind it:
 *
 *     // A ring of DEPTH words: what was pushed first is popped first.
 *     // Latency 1.
 *     module sepax_fifo #(
 *       parameter WIDTH = @width@, // bits of a word
 *       parameter DEPTH = 4        // words, a power of 2
 *     ) (
 *       input  wire             clk,  // clock
 *       input  wire             push, // append in
 *       input  wire [WIDTH-1:0] in,   // the word
 *     //@ if level
 *       output wire [7:0]       used, // words that are stored, 0 ... DEPTH
 *     //@ end
 *       output wire [WIDTH-1:0] out   // the oldest word
 *     );
 *       ...
 *     endmodule
 *
 * @name@ is a hole: the text that the caller gives takes its place. The lines between "//@ if
 * name" and "//@ else" or "//@ end" stay if the hole's text is neither empty nor "0"; "//@ if
 * !name" negates. They nest, and stand alone on their lines. One line that ends with "//@ name" or
 * "//@ !name", behind its comment, stays or goes alone, without this mark. Holes may stand
 * anywhere, in the banner and in the module's name, too. A hole without a text and a line of more
 * than 100 columns are refused; texts that the file has no hole for are not, so that the files of
 * a folder can share a list.
 *
 * What is left is checked as every module is (emit.h) and can be instantiated from then on by
 * other templates. The reader understands: parameter, localparam (with a range or without), input,
 * output [reg], wire, reg, memories reg [W-1:0] x [0:N-1], wire arrays, integer, genvar; assign;
 * always @(posedge clk), always @(*) with begin/end, if/else, case/casez, for; generate if/for
 * with labels; function with its arguments in parentheses; instances with named ports and
 * parameters; part selects [i*W +: W]; {N{x}}; $signed, $unsigned, $clog2; `ifdef, where both
 * branches are checked; behind `ifdef FORMAL also initial, assert, assume, cover, $past, $stable.
 * Ranges are [msb:lsb] with lsb >= 0, of ports [msb:0].
 *
 * A module refuses parameters that it cannot serve by a generate block that instantiates a module
 * which does not exist and whose name is the fault:
 *
 *     generate
 *       if (DEPTH < 2) begin : check
 *         sepax_fifo_DEPTH_must_be_2_or_more fault ();
 *       end
 *     endgenerate
 *
 * The call, before the first instance:
 *
 *     emit_template(e, "sepax_fifo", (emit_hole[]){{"width", text.text}, {NULL, NULL}});
 *
 * `name` is the file's name without ".v", with its folder before it ("paper/sepax_top") where files
 * of several folders have it; the module's is what the text says. */
#ifndef SEPAX_EMIT_TEMPLATE_H
#define SEPAX_EMIT_TEMPLATE_H

#include "emit.h"

#include <stdio.h>

typedef struct {
  const char *name, *text;
} emit_hole;

/* Emit and check a module made of a template; false with e->error set if it is refused. `holes`
 * ends with {NULL}; NULL: there are none. */
bool emit_template(emitter *e, const char *name, const emit_hole *holes);

/* A list of holes that grows: texts printf-like, a name set again gets the new text. `hole` ends
 * with {NULL}. Without memory a hole has no text, or is not there, and the template that asks for
 * it is refused. */
typedef struct {
  emit_hole *hole;
  size_t count, space;
  const char *open; /* the name that `text` is written for, or NULL */
  emit_text text;
} emit_holes;
void emit_hole_set(emit_holes *h, const char *name, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* Numbers of several holes; the last row has no name. */
typedef struct {
  const char *name;
  int64_t number;
} emit_number;
void emit_hole_numbers(emit_holes *h, const emit_number *row);
/* A text to write, without its last newline: closed by emit_hole_close, or when the next is opened.
 */
emit_text *emit_hole_open(emit_holes *h, const char *name);
/* The same of a text that was written before; it is then empty. */
void emit_hole_take(emit_holes *h, const char *name, emit_text *text);
void emit_hole_close(emit_holes *h);
void emit_holes_free(emit_holes *h);

/* The same with the template's text itself. */
bool emit_template_text(emitter *e, const char *name, const char *text, const emit_hole *holes);

/* Append a template that is no module, such as a test bench, with its holes filled. Its text is not
 * read but for the holes and the columns; templates of other languages have their ending in the
 * name. False with e->error set if it is refused. */
bool emit_fill(emitter *e, const char *name, const emit_hole *holes, emit_text *out);

/* All files, made by scripts/embed; the last has no name. */
typedef struct {
  const char *path, *text; /* "FOLDER/sepax_NAME" of .v; of others with the ending */
} emit_template_file;
extern const emit_template_file emit_templates[];

#endif
