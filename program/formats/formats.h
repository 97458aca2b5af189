/* formats.h - scenes and paths in the formats that people have: URDF, SRDF, meshes, CSV. Every
 * reader fails with one line that names the file, where it has one the line, and a cure. */
#ifndef SEPAX_FORMATS_H
#define SEPAX_FORMATS_H

#include "cli/meshes.h"
#include "sepax_mechanism.h"

/* ----------------------------------------------------------------- scenes */

typedef enum { FORMAT_MESH, FORMAT_BOX, FORMAT_CYLINDER, FORMAT_SPHERE } format_kind;

/* The geometry of a collision element, of which a link may have several. */
typedef struct {
  size_t link;
  format_kind kind;
  char *path;        /* of a mesh: its file, */
  char *name;        /* which the URDF calls so */
  double size[3];    /* sides; radius, length; radius; of a mesh: scale */
  sepax_pose origin; /* in the link's coordinates */
  long line;
} format_shape;

typedef struct {
  char *name;                /* or NULL */
  sepax_mechanism mechanism; /* joined */
  format_shape *shape;       /* in the order of the file */
  size_t shapes;
} format_robot;

/* Where package://NAME/ is. */
typedef struct {
  const char *name, *folder;
} format_package;

enum { FORMAT_LINKS_MOST = 4096, FORMAT_SHAPES_MOST = 65536 };

/* Metres, or radians, of an origin or a joint's value: sums and differences of these are far from
 * what a double ends with. */
#define FORMAT_VALUE_MOST 1e12

bool format_urdf_read(format_robot *robot, const char *path, const format_package *package,
                      size_t packages, sepax_error *error);
void format_robot_free(format_robot *robot);

/* compared[a * links + b], all true before: set to false, both ways, what the file disables. `of`,
 * unless NULL, gets the name of its robot, by sepax_allocate, or NULL. */
bool format_srdf_read(bool *compared, const sepax_mechanism *m, char **of, const char *path,
                      sepax_error *error);

/* ----------------------------------------------------------------- meshes */

/* The surface of a shape in the link's coordinates. Spheres and cylinders are polyhedra that hold
 * them. Of a file, the numbers of STL, OBJ and PLY are metres, as robots' programs take them; DAE
 * has its own unit; a millimetre of a 3MF is one of the numbers, as its writers' STL files have it.
 * Then they are scaled. `said` is of the file; of a shape without one it is zero. */
bool format_shape_mesh(sepax_soup *mesh, report_mesh *said, const format_shape *shape,
                       const cli_meshes *rules, sepax_error *error);

/* Of triangles with the same corners the first stays, in order: the same points, but no longer the
 * same solid. A search would compare each of them with each of another body. False without memory;
 * then all stay. */
bool format_distinct(sepax_soup *mesh);

/* -------------------------------------------------------------------- path */

typedef struct {
  double *value; /* of line n: value[n * joints ...], of all joints, those that follow, too */
  double *time;  /* or NULL */
  size_t *line;  /* where line n is in its file, from 1 */
  size_t lines, joints;
} format_motion;

typedef struct {
  bool hold;          /* joints without a column stay at 0 */
  bool ignore_limits; /* values may be beyond the limits of their joints */
} format_motion_rules;

bool format_motion_read(format_motion *motion, const sepax_mechanism *m,
                        const format_motion_rules *rules, const char *path, sepax_error *error);
void format_motion_free(format_motion *motion);

#endif
