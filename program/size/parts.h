/* parts.h - what the parts of sepax size share: command.c reads what is asked and finds the answer,
 * scene.c measures a mechanism on a path, output.c prints all that. */
#ifndef SEPAX_SIZING_PARTS_H
#define SEPAX_SIZING_PARTS_H

#include "path/engine.h"
#include "design/engine_table.h"

typedef struct {
  sepax_space space;
  const char *path[2], *folder;
  path_question scene; /* of a mechanism; path[] are its URDF and CSV */
  bool is_scene;
  const char *resolution;             /* as it is written */
  const char *path_file;              /* of poses, or NULL */
  const char *moved, *posed, *placed; /* an option for a motion, for a path, for a workspace */
  int paths;
  sepax_size_request request;
  bool lanes_given;
  sepax_config clock; /* its period only */
  bool json, generate;
} size_options;

/* The best design with an engine. */
typedef struct {
  bool asked, in_time;
  sepax_sized_design best; /* not in time: its cycles and seconds are those that none is below */
} size_best;

/* A pair of a mechanism with the best design. */
typedef struct {
  uint64_t worst; /* cycles */
  size_t line;    /* of these */
  double mean;
} size_pair;

typedef struct {
  report_mesh file[2]; /* of two meshes */
  sepax_size *size;    /* of each pair; of two meshes it is one */
  size_t pairs;
  path_scene scene; /* of a mechanism, as are: */
  path_engine engine;
  size_pair *each;
  size_best with[SEPAX_ENGINE_COUNT];
  const sepax_sized_design *best; /* of all engines */
} size_answer;

/* Designs with an engine: how they are asked for and told of. */
typedef struct {
  const char *name; /* NULL: they are not looked at */
  bool walks_trees; /* of the bodies, until the first collision if that is asked for */
  /* The request for these designs alone; false: the options exclude them. */
  bool (*ask)(sepax_size_request *request, const size_options *o, const size_answer *answer);
  void (*print)(const sepax_config *config, double kbit); /* the line of the design */
  void (*print_basis)(const size_options *o); /* on a path: what the cycles rest on, or NULL */
} size_engine;
extern const size_engine size_engines[SEPAX_ENGINE_COUNT];
const size_engine *size_engine_of(const sepax_sized_design *m);

enum { SIZE_WIDTH = 11 }; /* of what a line begins with */

/* What the pairs of a mechanism need in each line. False leaves what can be freed. */
bool size_scene_read(size_answer *answer, const size_options *o, sepax_error *error);
/* What each takes with the best design. */
bool size_scene_tell(size_answer *answer, const size_options *o, sepax_error *error);
void size_scene_free(size_answer *answer);

void size_print_text(const size_options *o, const size_answer *answer);
void size_print_json(const size_options *o, const size_answer *answer);
bool size_names_printable(const size_options *o, sepax_error *error);

#endif
