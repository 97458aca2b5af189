/* SPDX-License-Identifier: MIT */
/* sepax_robot.h - libsepax-io: read robots and other mechanisms from URDF and SRDF: the links and
 * joints, the collision geometry of the links, and the pairs of links that are compared.
 *
 * The conventions are those of sepax.h. docs/reference/mechanisms.md lists what is read, what is
 * passed over and what is refused. Lengths are in metres, angles in radians. A build without
 * libxml2 has these functions, too; those that read files fail with FORMAT and say so.
 */
#ifndef SEPAX_ROBOT_H
#define SEPAX_ROBOT_H

#include "sepax_io.h"
#include "sepax_mechanism.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

enum { SEPAX_ROBOT_LINKS_MOST = 4096, SEPAX_ROBOT_SHAPES_MOST = 65536 };

/* The largest size of an origin or of a joint's value, in metres or radians. Sums and differences
 * of such numbers stay far from the limits of doubles. */
#define SEPAX_ROBOT_VALUE_MOST 1e12

/* ------------------------------------------------------------------ robots */

typedef enum {
  SEPAX_SHAPE_MESH,
  SEPAX_SHAPE_BOX,
  SEPAX_SHAPE_CYLINDER,
  SEPAX_SHAPE_SPHERE,
  SEPAX_SHAPE_CAPSULE
} sepax_shape_kind;

/* The geometry of one collision element. A link may have several. */
typedef struct {
  size_t link;
  sepax_shape_kind kind;
  char *path;        /* of a mesh: its file, which existed when the URDF was read; else NULL */
  char *name;        /* of a mesh: its name in the URDF; else NULL */
  double size[3];    /* box: its sides. Cylinder, sphere, capsule: radius, and length, which for a
                        capsule is that of its cylinder. Mesh: the factors of its scale */
  sepax_pose origin; /* of the shape in the link's coordinates */
  long line;         /* of the URDF */
} sepax_shape;

/* A collision element without a surface: all its lengths are 0. */
typedef struct {
  size_t link;
  sepax_shape_kind kind;
  long line;
} sepax_bare_shape;

/* Elements of a file that were passed over: their name, how many there are, and the line of the
 * first. A name that ends in '=' is an attribute, and one that ends in a quote is text. */
typedef struct {
  char *what;
  size_t count;
  long line;
} sepax_robot_other;

typedef struct {
  sepax_robot_other *entry;
  size_t count;
} sepax_robot_others;

typedef struct {
  char *name;                /* of the robot, or NULL */
  sepax_mechanism mechanism; /* after sepax_mechanism_join. The first `links` links are those of the
                                file, in its order */
  size_t links;              /* links of the file. Further links of the mechanism lie between the
                                joints of which a floating or planar joint is made */
  sepax_shape *shape;        /* in the order of the file, so those of a link follow each other */
  size_t shapes;
  sepax_bare_shape *nothing;
  size_t nothings;
  sepax_robot_others others;
} sepax_robot;

/* The folder of package://NAME/. */
typedef struct {
  const char *name, *folder;
} sepax_package;

/* Options of sepax_robot_read. */
typedef struct {
  size_t size;
  const sepax_package *package; /* packages that are not beside the URDF or above it */
  size_t packages;
  bool fans; /* of meshes, which sepax_robot_machine_read reads: that of sepax_mesh_reading */
} sepax_robot_reading;

/* Read a URDF. A floating joint J becomes six joints J/x, J/y, J/z, J/yaw, J/pitch and J/roll. A
 * planar joint becomes J/x, J/y and J/yaw. None of these has limits. Mesh files are looked for, but
 * not read. `how` may be NULL. Errors: FILE; FORMAT, with the line of the file and the cure;
 * MEMORY.
 */
bool sepax_robot_read(sepax_robot *robot, const char *path, const sepax_robot_reading *how,
                      sepax_error *error);
void sepax_robot_free(sepax_robot *robot);

/* "mesh", "box", "cylinder", "sphere" or "capsule": the name of the element. */
const char *sepax_shape_kind_name(sepax_shape_kind kind);

/* ------------------------------------------------------------------ shapes */

/* Options of sepax_shape_mesh. */
typedef struct {
  size_t size;
  double unit; /* length in metres of a mesh file's unit, 0 ... 1e9; 0: the numbers of STL, OBJ and
                  PLY are metres, as in robots' programs. DAE files have their own unit. A
                  millimetre of a 3MF counts as one metre, as for the STL files of its writers */
  bool unplaced; /* do not apply the origin: the result has the shape's own coordinates */
  bool fans;     /* of a mesh: that of sepax_mesh_reading */
} sepax_shape_reading;

/* The surface of a shape in the link's coordinates, in metres. Spheres, cylinders and capsules
 * become polyhedra that contain them: 4,608, 256 or 4,800 triangles, with corners at most 0.25 % of
 * the radius outside. A mesh file is read by sepax_mesh_read; `account` describes it, and is all
 * zero for a shape without a file. Then the unit, the scale and the origin are applied, each of
 * which rounds. `account` and `how` may be NULL. Errors: those of sepax_mesh_read. */
bool sepax_shape_mesh(sepax_soup *mesh, sepax_mesh_account *account, const sepax_shape *shape,
                      const sepax_shape_reading *how, sepax_error *error);

/* ------------------------------------------------------------------- pairs */

typedef struct {
  char *robot; /* name of the robot, or NULL */
  sepax_robot_others others;
} sepax_srdf;

/* Read an SRDF for a mechanism. compared[a * links + b] is set to false, both ways, for all pairs
 * of links a and b that the file disables; the caller sets it to true before. `srdf` may be NULL.
 * Errors: FILE; FORMAT, with the line of the file and the cure; MEMORY. */
bool sepax_srdf_read(bool *compared, const sepax_mechanism *m, sepax_srdf *srdf, const char *path,
                     sepax_error *error);
void sepax_srdf_free(sepax_srdf *srdf);

/* The pairs of links that are compared. */
typedef struct {
  size_t (*pair)[2]; /* two links that have shapes; pair[n][0] < pair[n][1], in order */
  size_t count;
  sepax_srdf srdf; /* what the SRDF has; all zero without one */
  /* Numbers of pairs that are left out: links of one joint, links that no joint moves against each
   * other, pairs that the SRDF disables. */
  size_t joined, rigid, disabled;
} sepax_robot_pairs;

/* Choose the pairs. With the path of an SRDF: all pairs that it does not disable. With NULL: all
 * but the two links of one joint, and links between which all joints are fixed. A floating or
 * planar joint does not hold its links together, so they are compared. Errors: those of
 * sepax_srdf_read. */
bool sepax_robot_pairs_choose(sepax_robot_pairs *pairs, const sepax_robot *robot, const char *srdf,
                              sepax_error *error);
void sepax_robot_pairs_free(sepax_robot_pairs *pairs);

/* ---------------------------------------------------------------- machines */

/* A machine from files, with all that it is made of. */
typedef struct {
  sepax_robot robot;
  sepax_robot_pairs pairs;
  sepax_machine_body *body; /* one for each link that has shapes, all of them together */
  size_t bodies;
  size_t (*pair)[2]; /* the pairs as numbers of bodies */
  sepax_machine *machine;
} sepax_robot_machine;

/* Read a URDF, its meshes and maybe an SRDF (`srdf` may be NULL), and make the machine. Make its
 * watches by sepax_watch_new; free these before the machine. Of triangles with the same corners one
 * stays. `how` may be NULL. Errors: those of the functions above; ARGUMENT if no two bodies are
 * compared. */
bool sepax_robot_machine_read(sepax_robot_machine *machine, const char *urdf, const char *srdf,
                              const sepax_robot_reading *how, sepax_error *error);
void sepax_robot_machine_free(sepax_robot_machine *machine);

/* The number of the joint of this name, or SEPAX_NO_JOINT. */
size_t sepax_robot_joint(const sepax_robot *robot, const char *name);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
