/* options.h - the table of options. A row says everything about an option but what it does. */
#ifndef SEPAX_OPTIONS_H
#define SEPAX_OPTIONS_H

#include "sepax_design.h"

typedef enum {
  OPTION_NUMBER,    /* a whole number */
  OPTION_PERIOD,    /* nanoseconds, at most three decimals; the field holds picoseconds */
  OPTION_CHOICE,    /* one of `choices`; the field holds its index */
  OPTION_SWITCH,    /* the same of two, or 0, 1; without a value it is the second */
  OPTION_PRECISION, /* full, word, guard=G; the field holds G, -1 for full */
  OPTION_ARCH       /* the name of an architecture */
} option_kind;

typedef struct {
  const char *name; /* as in --name; its variable of make is in capitals, with _ for - */
  char letter;      /* -w; or 0 */
  option_kind kind;
  size_t field, size;         /* in sepax_config */
  int standard;               /* the default; outside of low ... high it means "none" */
  int low, high;              /* the range, as far as it depends on nothing else */
  const char *const *choices; /* ends with NULL */
  unsigned archs;             /* bits 1 << sepax_arch: those that read it */
  unsigned named;             /* those whose designs always have it in their name */
  bool shown;                 /* sepax_config_text prints it even where it is the default */
  const char *needs;          /* NULL, or the option without which it means nothing, or
                                 two, "lanes|tree", one of which is enough */
  const char *tag;            /* what it adds to the name of a design, "-a%s" */
  const char *argument;       /* of --help */
  const char *help;
} design_option;

/* Row i, NULL after the last. */
const design_option *sepax__design_option_at(size_t i);

/* The variable of make: CLOCK_NS for clock-ns. */
typedef struct {
  char text[32];
} option_text;
option_text sepax__design_option_variable(const design_option *option);

/* The value in `config` as text, and the default; "" for none. */
option_text sepax__design_option_value(const design_option *option, const sepax_config *config);

/* Is the option of this name at another value than its default? */
bool sepax__design_option_given(const char *name, const sepax_config *config);

/* Fails if an architecture does not read an option that was changed, if a value is out of its
 * range, or without the option that it needs. */
bool sepax__design_options_check(const sepax_config *config, sepax_error *error);

#endif
