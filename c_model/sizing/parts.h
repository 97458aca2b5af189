/* parts.h - what the parts of sepax size share: command.c reads what is asked and finds the answer,
 * output.c prints it. */
#ifndef SEPAX_SIZING_PARTS_H
#define SEPAX_SIZING_PARTS_H

#include "cli/cli.h"
#include "sepax_tree.h"

typedef struct {
  sepax_space space;
  const char *path[2], *folder;
  const char *path_file;     /* of poses, or NULL */
  const char *moved, *posed; /* an option that is for a motion, for a path; or NULL */
  int paths;
  sepax_size_request request;
  bool lanes_given;
  sepax_config clock; /* its period only */
  bool json, generate;
} size_options;

typedef enum { SIZE_CORE, SIZE_LANES, SIZE_TREE, SIZE_KINDS } size_kind_of;

/* The best design of a kind. */
typedef struct {
  bool asked, in_time;
  sepax_sized_design best; /* not in time: its cycles and seconds are those that none is below */
} size_kind;

typedef struct {
  sepax_size size;
  size_kind kind[SIZE_KINDS];
  const sepax_sized_design *best; /* of all kinds */
} size_answer;

void size_print_text(const size_options *o, const size_answer *answer);
void size_print_json(const size_options *o, const size_answer *answer);
bool size_names_printable(const size_options *o, sepax_error *error);

#endif
