/* formats.h - scenes and paths in the formats that people have: URDF, SRDF, meshes, CSV. Every
 * reader fails with one line that names the file, where it has one the line, and a cure. */
#ifndef SEPAX_FORMATS_H
#define SEPAX_FORMATS_H

#include "cli/meshes.h"
#include "sepax_mechanism.h"

/* ----------------------------------------------------------------- scenes */

typedef enum {
  FORMAT_MESH,
  FORMAT_BOX,
  FORMAT_CYLINDER,
  FORMAT_SPHERE,
  FORMAT_CAPSULE
} format_kind;

/* The geometry of a collision element, of which a link may have several. */
typedef struct {
  size_t link;
  format_kind kind;
  char *path;        /* of a mesh: its file, */
  char *name;        /* which the URDF calls so */
  double size[3];    /* sides; radius, length (a capsule's without its caps); of a mesh: scale */
  sepax_pose origin; /* in the link's coordinates */
  long line;
} format_shape;

/* Elements of a file that are passed over: their name, how many. A name that ends in '=' is an
 * attribute's. */
typedef struct {
  char *what;
  size_t count;
} format_other;

typedef struct {
  format_other *entry;
  size_t count;
} format_others;

/* A collision element without a surface: all its lengths are 0. */
typedef struct {
  size_t link;
  format_kind kind;
  long line;
} format_nothing;

typedef struct {
  char *name;                /* or NULL */
  sepax_mechanism mechanism; /* joined */
  size_t links;              /* of the file; those of the mechanism behind them are between the
                                joints of which a floating or planar joint is made */
  format_shape *shape;       /* in the order of the file */
  size_t shapes;
  format_nothing *nothing;
  size_t nothings;
  format_others others;
} format_robot;

/* Where package://NAME/ is. */
typedef struct {
  const char *name, *folder;
} format_package;

enum { FORMAT_LINKS_MOST = 4096, FORMAT_SHAPES_MOST = 65536 };

/* Metres, or radians, of an origin or a joint's value: sums and differences of these are far from
 * what a double ends with. */
#define FORMAT_VALUE_MOST 1e12

/* A floating joint J becomes six joints J/x, J/y, J/z, J/yaw, J/pitch and J/roll, a planar one
 * J/x, J/y and J/yaw, none of which has limits. */
bool format_urdf_read(format_robot *robot, const char *path, const format_package *package,
                      size_t packages, sepax_error *error);
void format_robot_free(format_robot *robot);

void format_others_free(format_others *others);

const char *format_kind_name(format_kind kind); /* of its element */

typedef struct {
  char *robot; /* whom it is for, or NULL */
  format_others others;
} format_srdf;

/* compared[a * links + b], all true before: set to false, both ways, what the file disables. `srdf`
 * may be NULL. */
bool format_srdf_read(bool *compared, const sepax_mechanism *m, format_srdf *srdf, const char *path,
                      sepax_error *error);
void format_srdf_free(format_srdf *srdf);

/* ----------------------------------------------------------------- meshes */

/* The surface of a shape in the link's coordinates. Spheres, cylinders and capsules are polyhedra
 * that hold them. Of a file, the numbers of STL, OBJ and PLY are metres, as robots' programs take
 * them; DAE has its own unit; a millimetre of a 3MF is one of the numbers, as its writers' STL
 * files have it. Then they are scaled. `said` is of the file; of a shape without one it is zero. */
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
  size_t columns; /* of the file, the time's included */
} format_motion;

typedef struct {
  bool hold;          /* joints without a column stay at 0 */
  bool ignore_limits; /* values may be beyond the limits of their joints */
} format_motion_rules;

bool format_motion_read(format_motion *motion, const sepax_mechanism *m,
                        const format_motion_rules *rules, const char *path, sepax_error *error);
void format_motion_free(format_motion *motion);

#endif
