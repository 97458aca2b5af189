/* SPDX-License-Identifier: MIT */
/* options.h - the table of design options. A row says everything about an option except for what it
 * does. */
#ifndef SEPAX_OPTIONS_H
#define SEPAX_OPTIONS_H

#include "sepax_design.h"

typedef enum {
  OPTION_NUMBER,    /* a whole number */
  OPTION_PERIOD,    /* nanoseconds, at most three decimals; the field holds picoseconds */
  OPTION_CHOICE,    /* one of `choices`; the field holds its index */
  OPTION_SWITCH,    /* one of two choices, or 0 or 1; the option without a value means the second */
  OPTION_PRECISION, /* full, word, guard=G; the field holds G, -1 for full */
  OPTION_ARCH       /* the name of an architecture */
} option_kind;

typedef struct {
  const char *name; /* as in --name; the variable of make has capitals, and _ for - */
  char letter;      /* the letter w of -w; 0: none */
  option_kind kind;
  size_t field, size;         /* place and size of the value in sepax_config */
  int standard;               /* the default; a default outside low ... high means "none" */
  int low, high;              /* the range, as far as it does not depend on other options */
  const char *const *choices; /* names of the choices, then NULL */
  bool decides;               /* a verdict depends on it */
  unsigned archs;             /* bits 1 << sepax_arch of the architectures that read the option */
  unsigned named;       /* architectures whose designs always have the option in their names */
  bool shown;           /* sepax_config_text prints it even where it is the default */
  const char *needs;    /* the option without which this one has no effect, or two of which one is
                           enough ("lanes|tree"); NULL: none */
  const char *tag;      /* text that the option adds to the name of a design, "-a%s" */
  const char *argument; /* name of the value in --help */
  const char *help;
} design_option;

/* Row i of the table; NULL after the last row. */
const design_option *sepax__design_option_at(size_t i);

/* The variable of make: "CLOCK_NS" for "clock-ns". */
typedef struct {
  char text[32];
} option_text;
option_text sepax__design_option_variable(const design_option *option);

/* The value in `config` as text; "" if it is "none". */
option_text sepax__design_option_value(const design_option *option, const sepax_config *config);

/* True if the value of this option is not its default. */
bool sepax__design_option_given(const char *name, const sepax_config *config);

/* Fails if a changed option is not read by the architecture, if a value is out of range, or if an
 * option is given without the one that it needs. */
bool sepax__design_options_check(const sepax_config *config, sepax_error *error);

#endif
