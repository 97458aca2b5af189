/* SPDX-License-Identifier: MIT */
/* parts.h - what the parts of sepax size share. options.c reads the options. command.c finds the
 * answer. scene.c measures a machine on a path. output.c prints. */
#ifndef SEPAX_SIZING_PARTS_H
#define SEPAX_SIZING_PARTS_H

#include "path/jobs/engine.h"
#include "design/engine_table.h"

typedef struct {
  sepax_space space;
  const char *path[2], *folder;
  path_question scene; /* for a machine; path[] has its URDF and CSV */
  bool is_scene;
  const char *resolution; /* as the user wrote it */
  const char *path_file;  /* file of --poses, or NULL */
  const char *moved, *posed,
      *placed; /* the first option given for a motion, for a path, for a workspace */
  int paths;
  sepax_size_request request;
  bool lanes_given;
  sepax_config clock; /* only its clock period is read */
  bool json, generate;
} size_options;

/* The best design with one engine. */
typedef struct {
  bool asked, in_time;
  bool refused; /* designs are in time, but none can be made for the clock */
  sepax_sized_design
      best; /* if none is in time: cycles and seconds that no design of the engine can beat */
} size_best;

/* A pair of bodies of a machine, with the best design. */
typedef struct {
  uint64_t worst; /* cycles of the slowest line */
  size_t line;    /* the slowest line */
  double mean;
} size_pair;

typedef struct {
  report_mesh file[2]; /* for two meshes */
  sepax_size *size;    /* for each pair; two meshes are one pair */
  size_t pairs;
  path_scene scene; /* for a machine, as the next fields: */
  path_engine engine;
  unsigned char *absent; /* absent[pair * lines + line]: the pair is not asked in the line */
  size_pair *each;
  size_best with[SEPAX_ENGINE_COUNT];
  const sepax_sized_design *best; /* the best of all engines */
} size_answer;

/* A kind of designs, by engine: how to request and how to print them. */
typedef struct {
  const char *name; /* NULL: not considered */
  bool walks_trees; /* the engine walks the bodies' trees, until the first collision with --first */
  /* Restrict the request to these designs. False if the options exclude them. */
  bool (*ask)(sepax_size_request *request, const size_options *o, const size_answer *answer);
  void (*print)(const sepax_config *config, double kbit); /* prints the line "design" */
  void (*print_basis)(
      const size_options *o); /* on a path: prints how the cycles were found; or NULL */
} size_engine;
extern const size_engine size_engines[SEPAX_ENGINE_COUNT];
const size_engine *size_engine_of(const sepax_sized_design *m);

enum { SIZE_WIDTH = 11 }; /* width of the first word of a line */

/* Read the options. Ends the program if they are wrong. */
void size_parse(size_options *o, int argc, char **argv);

/* Measure all pairs of a machine in each line. After false the answer can be freed. */
bool size_scene_read(size_answer *answer, const size_options *o, sepax_error *error);
const path_pair *size_pair_of(const size_answer *answer, size_t n);
/* Find the cycles of each pair with the best design. */
bool size_scene_tell(size_answer *answer, const size_options *o, sepax_error *error);
void size_scene_free(size_answer *answer);

void size_print_text(const size_options *o, const size_answer *answer);
void size_print_json(const size_options *o, const size_answer *answer);
bool size_names_printable(const size_options *o, sepax_error *error);

#endif
