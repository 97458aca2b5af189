/* SPDX-License-Identifier: MIT */
/* operand.c - literals, names with their selects, what stands in parentheses and braces. */
#include "check.h"

#include <ctype.h>
#include <string.h>

/* Bits that number n things: 1 for 1 and 2. */
static int index_bits(int64_t n) {
  int width = 1;
  while ((INT64_C(1) << width) < n) {
    width++;
  }
  return width;
}

/* -------------------------------------------------------------------------- literals */

/* Digits of a base: a value of up to 62 bits, or not known. */
static operand digits(reader *r, int base) {
  static const char figures[] = "0123456789abcdef";
  operand o = {0, true, 0};
  const char *first = r->at;
  for (; isalnum((unsigned char)*r->at) || *r->at == '_' || *r->at == '?'; r->at++) {
    const char *figure = memchr(figures, tolower((unsigned char)*r->at), (size_t)base);
    bool any = base != 10 && strchr("?xXzZ", *r->at) != NULL;
    if (figure != NULL || any) {
      o.known = o.known && !any && o.value < INT64_MAX / 32;
      o.value = o.known ? base * o.value + (figure - figures) : 0;
    } else if (*r->at != '_') {
      break;
    }
  }
  if (r->at == first || isalnum((unsigned char)*r->at)) {
    reader_refuse(r, "literal not understood");
  }
  return o;
}

static operand literal(reader *r) {
  static const char letters[] = "bodh";
  static const int base[] = {2, 8, 10, 16};
  operand size = digits(r, 10);
  if (*r->at != '\'') {
    return size;
  }
  r->at += 1 + (tolower((unsigned char)r->at[1]) == 's');
  const char *letter = memchr(letters, tolower((unsigned char)*r->at), sizeof letters - 1);
  if (letter == NULL || size.value < 1 || size.value > 100000) {
    reader_refuse(r, "literal not understood");
    return check_bits(1);
  }
  r->at++;
  operand o = digits(r, base[letter - letters]);
  o.width = (int)size.value;
  if (o.known && o.width < 63 && (o.value >> o.width) != 0) {
    reader_fault(r, "a literal exceeds its size");
  }
  return o;
}

/* ----------------------------------------------------------------------------- names */

/* One index of n things: a constant within, or just the bits that number them. */
static void check_index(reader *r, const char *what, operand index, int64_t n) {
  if (!index.known) {
    check_same_width(r, "index", index, check_bits(index_bits(n)));
  } else if (index.value < 0 || index.value >= n) {
    reader_fault(r, "select outside of '%s'", what);
  }
}

/* [bit], [msb:lsb], [base +: bits] or [base -: bits] behind a name, or nothing: the bits and the
 * value of a constant. */
static operand selected(reader *r, const check_name *whole) {
  operand part = {whole->width, whole->known, whole->value};
  if (!reader_take(r, "[")) {
    return part;
  }
  operand first = check_expression(r);
  int64_t low = first.value;
  int64_t count = 1;
  if (reader_take(r, ":")) {
    low = check_constant(r);
    count = first.value - low + 1;
    if (!first.known) {
      reader_fault(r, "a range that is not constant in '%s'", whole->name);
    }
  } else if (reader_take(r, "+:")) {
    count = check_constant(r);
  } else if (reader_take(r, "-:")) {
    count = check_constant(r);
    low -= count - 1;
  }
  reader_expect(r, "]");
  int width = whole->width > 0 ? whole->width : 32; /* of an integer */
  low -= whole->low;
  if (!first.known) {
    check_index(r, whole->name, first, width + whole->low);
  } else if (low < 0 || low + count > width) {
    reader_fault(r, "select outside of '%s'", whole->name);
  }
  if (count < 1) {
    reader_fault(r, "select outside of '%s'", whole->name);
  }
  if (r->failed || r->off > 0) {
    return check_bits(1);
  }
  part.width = (int)count;
  part.known = whole->known && first.known && low < 63 && count < 62;
  part.value = part.known ? (whole->value >> low) & ((INT64_C(1) << count) - 1) : 0;
  return part;
}

static operand called(reader *r, const check_name *f) {
  const char *separator = "(";
  for (int i = 0; i < f->arguments; i++) {
    reader_expect(r, separator);
    check_same_width(r, f->name, check_expression(r), check_bits(f->argument[i]));
    separator = ",";
  }
  reader_expect(r, ")");
  return check_bits(f->width);
}

/* A signal or constant with its selects; the first is the index of a memory's word. */
static operand signal(reader *r, const check_name *n) {
  if (n->words > 0) {
    reader_expect(r, "[");
    check_index(r, n->name, check_expression(r), n->words);
    reader_expect(r, "]");
  }
  return selected(r, n);
}

/* A name that is declared; NULL with a fault, and in a branch that is not taken. */
static const check_name *declared(reader *r, const char *name) {
  const check_name *n = r->off == 0 ? reader_find(r, name) : NULL;
  if (n == NULL || n->kind == NAME_LABEL) {
    reader_fault(r, "undeclared signal '%s'", name);
    return NULL;
  }
  return n;
}

static void argument(reader *r) { check_expression(r); }

/* The selects or the call behind a name that is not known. */
static operand skipped(reader *r) {
  const check_name any = {.width = 1};
  selected(r, &any);
  selected(r, &any);
  if (reader_take(r, "(")) {
    reader_list(r, argument);
  }
  return check_bits(1);
}

static operand named(reader *r, const char *name) {
  const check_name *n = declared(r, name);
  return n == NULL ? skipped(r) : n->kind == NAME_FUNCTION ? called(r, n) : signal(r, n);
}

/* ------------------------------------------------------------ what stands in braces */

/* Behind the first of several parts: the others and the closing brace. */
static operand concatenated(reader *r, operand first, operand (*part)(reader *r)) {
  bool sized = first.width > 0;
  while (reader_take(r, ",")) {
    operand next = part(r);
    sized = sized && next.width > 0;
    first.width += next.width;
  }
  reader_expect(r, "}");
  if (!sized) {
    reader_fault(r, "a constant without a size");
  }
  return check_bits(first.width);
}

/* {a, b} or {N{a, b}} behind the opening brace. */
static operand braces(reader *r) {
  operand first = check_expression(r);
  if (!reader_take(r, "{")) {
    return concatenated(r, first, check_expression);
  }
  operand part = concatenated(r, check_expression(r), check_expression);
  reader_expect(r, "}");
  if (!first.known) {
    reader_fault(r, "replication that is not constant");
  } else if (first.value < 1) {
    reader_fault(r, "replication by less than one");
  }
  return check_bits((int)(first.value * part.width));
}

operand check_target(reader *r) {
  static const char *const fault[] = {
      [NAME_CONSTANT] = "a constant is assigned:",
      [NAME_VARIABLE] = "a constant is assigned:",
      [NAME_WIRE] = "a wire is assigned in an always block:",
      [NAME_REG] = "no wire:",
      [NAME_INPUT] = "an input is assigned:",
      [NAME_FUNCTION] = "a function is assigned:",
  };
  char name[EMIT_NAME];
  if (reader_take(r, "{")) {
    return concatenated(r, check_target(r), check_target);
  }
  if (!reader_take_name(r, name)) {
    reader_refuse(r, "statement not understood");
  }
  const check_name *n = declared(r, name);
  if (n == NULL) {
    return skipped(r);
  }
  if (n->kind != (r->place == IN_MODULE ? NAME_WIRE : NAME_REG)) {
    reader_fault(r, "%s '%s'", fault[n->kind], name);
  }
  return signal(r, n);
}

/* ------------------------------------------------------------------------- operators */

/* Behind the dollar sign. */
static operand system_function(reader *r) {
  if (r->formal && reader_take(r, "initstate")) {
    return check_bits(1);
  }
  bool logarithm = reader_take(r, "clog2");
  bool past = r->formal && reader_take(r, "past");
  bool stable = r->formal && reader_take(r, "stable");
  if (!logarithm && !past && !stable && !reader_take(r, "signed")) {
    reader_expect(r, "unsigned");
  }
  reader_expect(r, "(");
  operand o = check_expression(r);
  if (past && reader_take(r, ",")) {
    check_constant(r);
  }
  reader_expect(r, ")");
  if (logarithm) {
    return (operand){0, o.known, o.value > 1 ? index_bits(o.value) : 0};
  }
  return check_bits(stable ? 1 : o.width);
}

operand check_primary(reader *r) {
  char name[EMIT_NAME];
  operand o = check_bits(1);
  reader_skip(r);
  if (isdigit((unsigned char)*r->at)) {
    return literal(r);
  }
  if (reader_take_name(r, name)) {
    return named(r, name);
  }
  if (reader_take(r, "(")) {
    o = check_expression(r);
    reader_expect(r, ")");
  } else if (reader_take(r, "{")) {
    o = braces(r);
  } else if (reader_take(r, "$")) {
    o = system_function(r);
  } else if (reader_take(r, "~")) {
    o = check_bits(check_primary(r).width);
  } else if (reader_take(r, "-")) {
    o = check_primary(r);
    o = o.width == 0 ? (operand){0, o.known, -o.value} : check_bits(o.width);
  } else if (reader_take(r, "!")) {
    o = check_primary(r);
    check_condition(r, o);
    o.value = !o.value;
  } else if (reader_take(r, "&") || reader_take(r, "|") || reader_take(r, "^")) {
    check_primary(r);
  } else {
    reader_refuse(r, "expression not understood");
  }
  return o;
}
