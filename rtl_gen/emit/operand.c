/* operand.c - literals, names with their selects, what stands in parentheses and braces. */
#include "check.h"

#include <ctype.h>
#include <string.h>

static operand constant(int64_t value) { return (operand){0, true, value}; }
static operand bits(int width) { return (operand){width, false, 0}; }

int check_index_bits(int64_t n) {
  int width = 1;
  while ((INT64_C(1) << width) < n) {
    width++;
  }
  return width;
}

/* -------------------------------------------------------------------------- literals */

static int digit_of(char c) {
  return isdigit((unsigned char)c)   ? c - '0'
         : isalpha((unsigned char)c) ? tolower((unsigned char)c) - 'a' + 10
                                     : 36;
}

static int64_t decimal(reader *r) {
  int64_t value = 0;
  while (r->at < r->end && (isdigit((unsigned char)*r->at) || *r->at == '_')) {
    if (*r->at != '_' && value < INT64_MAX / 16) {
      value = 10 * value + (*r->at - '0');
    }
    r->at++;
  }
  return value;
}

/* The digits behind 8'd: a value of up to 62 bits, or not known. */
static operand digits(reader *r, int width) {
  static const char letters[] = "bodh";
  static const int radix[] = {2, 8, 10, 16};
  operand o = {width, true, 0};
  if (r->at < r->end && (*r->at == 's' || *r->at == 'S')) {
    r->at++;
  }
  const char *letter = r->at < r->end ? strchr(letters, tolower((unsigned char)*r->at)) : NULL;
  if (letter == NULL || *letter == '\0') {
    reader_refuse(r, "literal not understood", "");
    return o;
  }
  int base = radix[letter - letters];
  const char *first = ++r->at;
  for (; r->at < r->end && (isalnum((unsigned char)*r->at) || strchr("_?", *r->at)); r->at++) {
    if (*r->at == '_') {
      continue;
    }
    int digit = digit_of(*r->at);
    bool any = strchr("?xXzZ", *r->at) != NULL && base != 10;
    if (!any && digit >= base) {
      reader_refuse(r, "literal not understood", "");
      return o;
    }
    o.known = o.known && !any && o.value < INT64_MAX / 32;
    o.value = o.known ? base * o.value + digit : 0;
  }
  if (r->at == first) {
    reader_refuse(r, "literal not understood", "");
  }
  if (o.known && width < 63 && (o.value >> width) != 0 && r->off == 0) {
    reader_refuse(r, "a literal exceeds its size", "");
  }
  return o;
}

static operand literal(reader *r) {
  int64_t value = decimal(r);
  if (r->at == r->end || *r->at != '\'') {
    return constant(value);
  }
  r->at++;
  if (value < 1 || value > 100000) {
    reader_refuse(r, "no bits in a literal", "");
    return bits(1);
  }
  return digits(r, (int)value);
}

/* ----------------------------------------------------------------------------- names */

/* One index of n things: a constant within, or just the bits that number them. */
static void check_index(reader *r, const char *what, operand index, int64_t n) {
  if (r->failed || r->off > 0) {
    return;
  }
  if (index.known) {
    if (index.value < 0 || index.value >= n) {
      reader_refuse(r, "select outside of", what);
    }
  } else {
    check_same_width(r, "index", index, bits(check_index_bits(n)));
  }
}

/* [bit], [msb:lsb], [base +: bits] or [base -: bits] behind a name; the lowest
 * selected bit in *low, counted from the name's, -1 if it is not known. */
static operand selected(reader *r, const check_name *whole, int64_t *low) {
  int width = whole->width;
  char name[EMIT_NAME];
  memcpy(name, whole->name, EMIT_NAME);
  *low = 0;
  if (!reader_take(r, "[")) {
    return bits(width);
  }
  int lowest = whole->low;
  operand first = check_expression(r);
  first.value -= first.known ? lowest : 0;
  int64_t count = 1;
  *low = first.known ? first.value : -1;
  if (reader_take(r, ":")) {
    int64_t lsb = check_constant(r) - lowest;
    if (!first.known && r->off == 0) {
      reader_refuse(r, "a range that is not constant in", name);
    }
    count = first.value - lsb + 1;
    *low = lsb;
  } else if (reader_take(r, "+:")) {
    count = check_constant(r);
  } else if (reader_take(r, "-:")) {
    count = check_constant(r);
    *low = first.known ? first.value - count + 1 : -1;
  }
  reader_expect(r, "]");
  if (r->failed || r->off > 0) {
    return bits(1);
  }
  if (count < 1) {
    reader_refuse(r, "select outside of", name);
  }
  if (first.known && *low + count > width) {
    reader_refuse(r, "select outside of", name);
  }
  if (first.known && *low < 0) {
    reader_refuse(r, "select outside of", name);
  }
  if (!first.known) {
    check_index(r, name, first, width + lowest);
  }
  return bits((int)count);
}

static operand called(reader *r, const check_name *function) {
  check_name f = *function;
  reader_expect(r, "(");
  for (int i = 0; i < f.arguments && !r->failed; i++) {
    if (i > 0) {
      reader_expect(r, ",");
    }
    check_same_width(r, f.name, check_expression(r), bits(f.argument[i]));
  }
  reader_expect(r, ")");
  return bits(f.width);
}

/* A constant, whole or selected from: 8 bits of an integer are i[7:0]. */
static operand constant_operand(reader *r, const check_name *name) {
  check_name n = *name;
  operand whole = {n.width, n.known, n.value};
  int64_t low = 0;
  if (!reader_next_is(r, "[")) {
    return whole;
  }
  n.width = n.width > 0 ? n.width : 32;
  operand part = selected(r, &n, &low);
  if (n.known && low >= 0 && low < 63 && part.width < 62) {
    part.known = true;
    part.value = (n.value >> low) & ((INT64_C(1) << part.width) - 1);
  }
  return part;
}

static operand signal(reader *r, const check_name *name) {
  check_name n = *name;
  int64_t low = 0;
  if (n.words > 0) {
    reader_expect(r, "[");
    check_index(r, n.name, check_expression(r), n.words);
    reader_expect(r, "]");
  }
  return selected(r, &n, &low);
}

/* A name in a branch that is not taken, which may not be declared: its selects, its call. */
static operand skipped(reader *r) {
  int64_t low = 0;
  const check_name any = {.width = 1};
  while (reader_next_is(r, "[")) {
    selected(r, &any, &low);
  }
  if (reader_take(r, "(")) {
    do {
      check_expression(r);
    } while (reader_take(r, ","));
    reader_expect(r, ")");
  }
  return bits(1);
}

static operand named(reader *r, const char *name) {
  if (r->off > 0) {
    const check_name *n = reader_find(r, name);
    return n != NULL && n->kind == NAME_CONSTANT ? constant_operand(r, n) : skipped(r);
  }
  const check_name *n = reader_find(r, name);
  if (n == NULL || n->kind == NAME_LABEL) {
    reader_refuse(r, "undeclared signal", name);
    return bits(1);
  }
  if (n->kind == NAME_CONSTANT) {
    return constant_operand(r, n);
  }
  return n->kind == NAME_FUNCTION ? called(r, n) : signal(r, n);
}

operand check_target(reader *r, bool procedural) {
  char name[EMIT_NAME];
  if (reader_take(r, "{")) {
    int width = 0;
    do {
      width += check_target(r, procedural).width;
    } while (!r->failed && reader_take(r, ","));
    reader_expect(r, "}");
    return bits(width);
  }
  if (!reader_take_name(r, name)) {
    reader_refuse(r, "statement not understood", "");
    return bits(1);
  }
  if (r->off > 0) {
    return skipped(r);
  }
  const check_name *n = reader_find(r, name);
  if (n == NULL || n->kind == NAME_LABEL) {
    reader_refuse(r, "undeclared signal", name);
  } else if (n->kind == NAME_INPUT) {
    reader_refuse(r, "an input is assigned:", name);
  } else if (n->kind == NAME_CONSTANT) {
    reader_refuse(r, "a constant is assigned:", name);
  } else if (procedural && n->kind == NAME_WIRE) {
    reader_refuse(r, "a wire is assigned in an always block:", name);
  } else if (!procedural && n->kind != NAME_WIRE) {
    reader_refuse(r, "no wire:", name);
  } else {
    return signal(r, n);
  }
  return bits(1);
}

/* ------------------------------------------------------------------------- operators */

/* {a, b} or {N{a, b}} behind the opening brace. */
static operand braces(reader *r) {
  operand first = check_expression(r);
  if (reader_take(r, "{")) {
    int width = 0;
    do {
      width += check_expression(r).width;
    } while (!r->failed && reader_take(r, ","));
    reader_expect(r, "}");
    reader_expect(r, "}");
    if (!r->failed && r->off == 0 && !first.known) {
      reader_refuse(r, "replication that is not constant", "");
    } else if (!r->failed && r->off == 0 && first.value < 1) {
      reader_refuse(r, "replication by less than one", "");
    }
    return bits((int)first.value * width);
  }
  int width = first.width;
  bool sized = first.width > 0;
  while (!r->failed && reader_take(r, ",")) {
    operand next = check_expression(r);
    sized = sized && next.width > 0;
    width += next.width;
  }
  if (!r->failed && !sized && r->off == 0) {
    reader_refuse(r, "a constant without a size", "");
  }
  reader_expect(r, "}");
  return bits(width);
}

/* Behind the name of a system function. */
static operand system_function(reader *r) {
  char name[EMIT_NAME] = "";
  reader_take_name(r, name);
  bool whole = strcmp(name, "signed") == 0 || strcmp(name, "unsigned") == 0;
  if (strcmp(name, "initstate") == 0 && r->formal) {
    return bits(1);
  }
  reader_expect(r, "(");
  operand o = check_expression(r);
  if (strcmp(name, "clog2") == 0) {
    int64_t n = o.value;
    o = (operand){0, o.known, n > 1 ? check_index_bits(n) : 0};
  } else if (strcmp(name, "past") == 0 && r->formal) {
    if (reader_take(r, ",")) {
      check_constant(r);
    }
  } else if (r->formal && (strcmp(name, "stable") == 0 || strcmp(name, "rose") == 0 ||
                           strcmp(name, "fell") == 0)) {
    o = bits(1);
  } else if (!whole) {
    reader_refuse(r, "expression not understood", "");
  }
  reader_expect(r, ")");
  return whole ? bits(o.width) : o;
}

operand check_primary(reader *r) {
  char name[EMIT_NAME];
  reader_skip(r);
  if (reader_take(r, "(")) {
    operand o = check_expression(r);
    reader_expect(r, ")");
    return o;
  }
  if (reader_take(r, "{")) {
    return braces(r);
  }
  if (reader_take(r, "$")) {
    return system_function(r);
  }
  if (reader_take(r, "~")) {
    return bits(check_primary(r).width);
  }
  if (reader_take(r, "-")) {
    operand o = check_primary(r);
    return o.width == 0 && o.known ? constant(-o.value) : bits(o.width);
  }
  if (reader_take(r, "!")) {
    operand o = check_primary(r);
    check_condition(r, o);
    return (operand){o.width, o.known, !o.value};
  }
  if (reader_take(r, "&") || reader_take(r, "|") || reader_take(r, "^")) {
    check_primary(r);
    return bits(1);
  }
  if (r->at < r->end && isdigit((unsigned char)*r->at)) {
    return literal(r);
  }
  if (reader_take_name(r, name)) {
    return named(r, name);
  }
  reader_refuse(r, "expression not understood", "");
  return bits(1);
}
