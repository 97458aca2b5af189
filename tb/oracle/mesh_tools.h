/* mesh_tools.h - what the tests of meshes share. */
#ifndef MESH_TOOLS_H
#define MESH_TOOLS_H

#include "sepax.h"

enum { PATH_BYTES = 1024 };

static const double pi = 0x1.921fb54442d18p1;

extern char folder[PATH_BYTES / 2]; /* scratch */
extern char path[PATH_BYTES];       /* part.stl in it */
extern sepax_error fault;           /* of the call under test */

/* Setup and teardown of a group of tests that needs the folder. */
int make_folder(void **state);
int remove_folder(void **state);

/* The same numbers in every run: 0 ... count - 1; uniform in -1 ... 1. */
int random_below(int count);
double random_unit(void);

/* The number `ulps` doubles above x, or below it. */
double stepped(double x, int ulps);

/* The fault is one line that has the part in it. */
void assert_message(const char *part);

/* The mesh of the file `path`. */
sepax_mesh read_ok(void);

/* The grid that sepax_grid_fit chooses: the meshes fit, and at the next finer
 * resolution they do not. */
sepax_grid assert_fit(const sepax_mesh *const meshes[], size_t count, int word);

#endif
