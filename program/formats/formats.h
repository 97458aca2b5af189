/* SPDX-License-Identifier: MIT */
/* formats.h - reads scenes and paths in common formats: URDF, SRDF, meshes, CSV. Each reader fails
 * with one line that names the file, the line if there is one, and a cure. */
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

/* The geometry of one collision element. A link may have several. */
typedef struct {
  size_t link;
  format_kind kind;
  char *path; /* for a mesh: its file */
  char *name; /* for a mesh: its name in the URDF */
  double
      size[3]; /* a box's sides; radius and length (a capsule's without its caps); a mesh's scale */
  sepax_pose origin; /* in the link's coordinates */
  long line;
} format_shape;

/* Elements of a file that are ignored: their names and numbers. A name that ends in '=' is an
 * attribute. */
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
  sepax_mechanism mechanism; /* after sepax_mechanism_join */
  size_t links; /* number of links in the file; further links of the mechanism lie between the
                   joints of which a floating or planar joint is made */
  format_shape *shape; /* in the order of the file */
  size_t shapes;
  format_nothing *nothing;
  size_t nothings;
  format_others others;
} format_robot;

/* The folder of package://NAME/. */
typedef struct {
  const char *name, *folder;
} format_package;

enum { FORMAT_LINKS_MOST = 4096, FORMAT_SHAPES_MOST = 65536 };

/* Largest size of an origin or a joint's value, in metres or radians, so that sums and differences
 * stay far from the limits of doubles. */
#define FORMAT_VALUE_MOST 1e12

/* Read a URDF. A floating joint J becomes six joints J/x, J/y, J/z, J/yaw, J/pitch and J/roll. A
 * planar joint becomes J/x, J/y and J/yaw. None of these has limits. */
bool format_urdf_read(format_robot *robot, const char *path, const format_package *package,
                      size_t packages, sepax_error *error);
void format_robot_free(format_robot *robot);

void format_others_free(format_others *others);

const char *format_kind_name(format_kind kind); /* name of its element */

typedef struct {
  char *robot; /* name of the robot, or NULL */
  format_others others;
} format_srdf;

/* compared[a * links + b], all true before: set to false, both ways, what the file disables. `srdf`
 * may be NULL. */
bool format_srdf_read(bool *compared, const sepax_mechanism *m, format_srdf *srdf, const char *path,
                      sepax_error *error);
void format_srdf_free(format_srdf *srdf);

/* ----------------------------------------------------------------- meshes */

/* The surface of a shape, in the link's coordinates. Spheres, cylinders and capsules become
 * polyhedra that contain them. Units of mesh files: the numbers of STL, OBJ and PLY are metres, as
 * in robots' programs. DAE files have their own unit. A millimetre of a 3MF counts as one metre
 * before scaling, as for the STL files of its writers. The scale is applied last. `said` describes
 * the file; for a shape without a file it is zero. */
bool format_shape_mesh(sepax_soup *mesh, report_mesh *said, const format_shape *shape,
                       const cli_meshes *rules, sepax_error *error);

/* Of triangles with the same corners keep the first, in order. The surface has the same points but
 * is no longer the same solid. Otherwise a search would compare each copy with each triangle of
 * another body. False without memory; then all stay. */
bool format_distinct(sepax_soup *mesh);

/* -------------------------------------------------------------------- path */

typedef struct {
  double *value; /* value[n * joints + j]: joint j in line n, for all joints, also those that follow
                    others */
  double *time;  /* or NULL */
  size_t *line;  /* line[n]: number of line n in its file, counted from 1 */
  size_t lines, joints;
  size_t columns; /* columns of the file, including the time */
} format_motion;

typedef struct {
  bool hold;          /* keep joints without a column at 0 */
  bool ignore_limits; /* accept values beyond the limits of joints */
} format_motion_rules;

bool format_motion_read(format_motion *motion, const sepax_mechanism *m,
                        const format_motion_rules *rules, const char *path, sepax_error *error);
void format_motion_free(format_motion *motion);

#endif
