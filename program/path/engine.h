/* engine.h - the bodies and lines of a path as a tree engine gets them: of sepax path --jobs, and
 * of sepax size. */
#ifndef SEPAX_PATH_ENGINE_H
#define SEPAX_PATH_ENGINE_H

#include "path/parts.h"
#include "sepax_tree.h"

typedef struct {
  double resolution;            /* metres an LSB, of all trees */
  int word, clearance, warning; /* LSB; without a warning 0 */
  sepax_tree **tree;            /* of each body, about its middle; NULL: it is in no pair */
  size_t bodies;
  sepax_tree_pose **pose; /* of each pair in each line */
  size_t pairs;
} path_engine;

/* Of a scene that has kept its meshes. q->lsb, q->word: as given; without an LSB the finest,
 * without a word the least that holds every vertex of a near pair. The clearances are those of q,
 * at least that of touching, rounded up. */
bool path_engine_make(path_engine *engine, const path_scene *scene, const path_question *q,
                      sepax_error *error);
void path_engine_free(path_engine *engine);

#endif
