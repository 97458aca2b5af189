/* SPDX-License-Identifier: MIT */
/* stock.h - the stock of a machining program as it is cut, as certain bounds in cells (private).
 *
 * A stock is a grid of cubic cells. A cell is there or it is gone. There are two kinds of bounds:
 *
 *   outer   All material that is left lies in the cells that are there. A cell goes only if it lies
 *           wholly inside the cutter while the cutter goes a way.
 *   inner   The cells that are there are wholly material. A cell goes as soon as the cutter may
 *           touch it.
 *
 * So a body that is free of the outer bound is free of the material, and a body that holds a point
 * of the inner bound collides. Between the two nothing is known. docs/reference/stock.md has the
 * proofs, and how deep a body may be in the outer bound of a cut that it made itself.
 *
 * Cutters and bodies are solids of revolution around the z axis of the tool. One solid is a list of
 * convex shapes. All lengths are in the unit of the caller. Failures are reported as in sepax.h.
 * A stock may be read by several threads at once, but not while it changes. */
#ifndef SEPAX_STOCK_H
#define SEPAX_STOCK_H

#include "mesh/revolve.h"
#include "sepax.h"
#include "sepax_mechanism.h"

/* ------------------------------------------------------------------ shapes */

enum { SEPAX__STOCK_LIMITS = 64 };

/* One limit of a convex shape; rho is the distance from the axis.
 *   cone   a * rho + b * z <= c, with a >= 0 and a^2 + b^2 = 1 up to rounding
 *   round  no farther than c from the cylinder rho <= ring that begins at z = a and leads to +z if
 * b is 1, to -z if b is -1; or, if c is below 0, -c or more inside it. The cylinder is a ray if
 * ring is 0. */
typedef struct {
  bool round;
  bool joined; /* the next shape of the same tool goes on here: shrinking leaves this limit */
  double a, b, c, ring;
} sepax__stock_limit;

/* A convex solid of revolution: all points that keep every limit. It lies within rho <= radius and
 * low <= z <= high. */
typedef struct {
  int count;
  sepax__stock_limit limit[SEPAX__STOCK_LIMITS];
  double radius, low, high;
} sepax__stock_shape;

/* A corner of a profile, rounded by an arc of radius `round` that is tangent to both edges. */
typedef struct {
  double r, z, round;
} sepax__stock_corner;

/* The shapes of a convex profile. Its corners lead from the lowest point of the axis (r = 0) to the
 * highest (r = 0), and z never falls. A ball of radius R at the end of a cylinder of length L has
 * the corners (0, 0, 0), (R, 0, R), (R, L, 0), (0, L, 0).
 *
 * The solid lies inside `outside`, and `inside` lies inside the solid, up to rounding, which cuts
 * and tests add. Straight edges, balls and quarters of circles between a flat face and a cylinder,
 * as of a bull nose, are kept as they are. Other arcs become chords in `inside`, tangents in
 * `outside`: no point of the surface of either is farther than `error_most` from the solid's, but
 * for the corners of the tangents, which are up to twice as far away. A 256th of a cell suits a
 * depth of two cells. Errors: ARGUMENT if the profile is not as above, not convex, if an arc is
 * longer than its edges or a number is not finite; LIMIT if it needs more than SEPAX__STOCK_LIMITS
 * limits. */
bool sepax__stock_shape_make(const sepax__stock_corner *corner, size_t count, double error_most,
                             sepax__stock_shape *inside, sepax__stock_shape *outside,
                             sepax_error *error);

/* Convex shapes that make up a solid together. */
typedef struct {
  sepax__stock_shape *shape;
  size_t count;
} sepax__stock_shapes;
void sepax__stock_shapes_free(sepax__stock_shapes *shapes);

/* The shapes of a turned profile (mesh/revolve.h). The solid lies in the union of `outside`, and
 * the union of `inside` lies in the solid. The profile is cut into convex parts at the heights
 * where it turns inward; the flat faces between these parts are `joined`. `joined[0]` says the same
 * of the lowest face, and `joined[1]` of the highest, where the next part of the tool goes on. Arcs
 * are exact to `error_most`, as above. Both lists are to be freed. Errors: ARGUMENT if the profile
 * is not legal or error_most is not above 0; LIMIT as sepax__stock_shape_make; MEMORY. */
bool sepax__stock_shapes_make(const turned_profile *profile, const bool joined[2],
                              double error_most, sepax__stock_shapes *inside,
                              sepax__stock_shapes *outside, sepax_error *error);

/* Shrink the shape by `by`: what is left are exactly the points of it around which a ball of radius
 * `by` lies in the shape, but for limits that are `joined`. A negative `by` makes it larger: the
 * shape then holds all points that are no farther than -by from it, and more at its edges. Cost: a
 * few operations for each limit. */
void sepax__stock_shape_shrink(sepax__stock_shape *shape, double by);

/* -------------------------------------------------------------------- ways */

/* A part of a way: the tool in pose `at` goes straight on by the vector `way` and does not turn. No
 * point of the tool is ever farther than `deviation` from where this puts it. */
typedef struct {
  sepax_pose at; /* of the tool, in the coordinates of the stock */
  double way[3];
  double deviation;
} sepax__stock_piece;

/* A way of the tool through the stock, from 0 to 1. The function describes the part between `from`
 * and `to`: the tool at any s with from <= s <= to is near its place in the piece at
 * (s - from) / (to - from). The deviation holds for all points of all shapes that are used with the
 * way. It includes the rounding of the poses, and falls as the part gets shorter. */
typedef struct {
  void (*piece)(const void *context, double from, double to, sepax__stock_piece *piece);
  const void *context;
} sepax__stock_way;

/* The piece between `from` and `to` of a way that is one piece from 0 to 1; `context` is that
 * sepax__stock_piece. For a way without turning. */
void sepax__stock_straight(const void *context, double from, double to, sepax__stock_piece *piece);

/* A way of a tool on a link of a mechanism, through stock on another one, while all joints move
 * linearly. `chain` leads from the link of the tool to the link of the stock. The tool's
 * coordinates are `mount` in those of its link. `box` holds all shapes of the tool, in coordinates
 * of the link; deviations are smaller if it is no larger than it must be. The caller fills in all
 * fields; `value` has room for three values of each joint of the mechanism. */
typedef struct {
  const sepax_chain *chain;
  const sepax_mechanism *mechanism;
  sepax_pose mount;
  double box[2][3];
  const double *from, *to; /* values of all joints */
  double *value[3];
} sepax__stock_joints;

/* The piece of such a way; `context` is a sepax__stock_joints. If no joint turns, then the whole
 * way is one piece with no deviation but rounding. lib/stock/joints.c has the proof of the
 * deviation. Cost: a few microseconds. */
void sepax__stock_joint_piece(const void *context, double from, double to,
                              sepax__stock_piece *piece);

/* The box, in coordinates of the link, of a shape that is mounted there. */
void sepax__stock_mounted_box(const sepax__stock_shape *shape, const sepax_pose *mount,
                              double box[2][3]);

/* ------------------------------------------------------------------ stocks */

typedef enum { SEPAX__STOCK_OUTER, SEPAX__STOCK_INNER } sepax__stock_bound;

typedef struct sepax__stock sepax__stock;

/* A stock without a cell, for what lies in the box. Cells have the side `cell` and begin at the
 * box's least corner. Material outside of the box is not tracked: a stock of a small box around one
 * place, with smaller cells, answers for that place.
 *
 * Memory: 4 bytes for each brick of 8 x 8 x 8 cells, 4 bytes for each 8 x 8 x 8 bricks, and 72
 * bytes for each brick that is neither empty nor full. Up to a third of the 72 bytes more is kept
 * while the list grows. Errors: ARGUMENT if a number is not finite, the box is empty or the cell is
 * not greater than 0; LIMIT on more than 2^28 bricks, or if a coordinate is more than 2^30 cells;
 * MEMORY. */
bool sepax__stock_new(sepax__stock **stock, sepax__stock_bound bound, const double box[2][3],
                      double cell, sepax_error *error);
void sepax__stock_free(sepax__stock *stock);

/* What is there: the kind of bound, the side of a cell, the box of all cells of the grid, the cells
 * that are there, and the bytes that the stock occupies. */
typedef struct {
  sepax__stock_bound bound;
  double cell;
  double box[2][3];
  uint64_t cells;
  uint64_t bytes;
} sepax__stock_facts;
sepax__stock_facts sepax__stock_look(const sepax__stock *stock);

/* True if the cell that holds the point is there. A point on a face belongs to the cell above. */
bool sepax__stock_has(const sepax__stock *stock, const double point[3]);

/* ----------------------------------------------------------------- filling */

/* Add a box to the stock. Outer: every cell that touches it, up to rounding of the cell's faces by
 * 2^-20 of a cell: a box that ends on a face does not fill the cell beyond. Inner: every cell
 * wholly inside, with the same rounding. So faces count as equal within 2^-20 of a cell, and the
 * first stock is exact to that length. Errors: ARGUMENT if a number is not finite; MEMORY. */
bool sepax__stock_fill_box(sepax__stock *stock, const double box[2][3], sepax_error *error);

/* Add a convex shape in a pose, for example a cylinder or a cone. Outer: give the shape `outside`;
 * every cell that touches it is added, and cells up to half a cell farther away. Inner: give
 * `inside`; cells are added that are wholly inside. Errors: ARGUMENT if the pose is not valid;
 * MEMORY. */
bool sepax__stock_fill_shape(sepax__stock *stock, const sepax__stock_shape *shape,
                             const sepax_pose *pose, sepax_error *error);

/* Shown while something takes long: the share that is done, 0 ... 1, hundreds of times or more. */
typedef struct {
  void (*show)(void *context, double share);
  void *context;
} sepax__stock_watch;

/* Add the solid of a closed mesh: outer: every cell that touches a triangle or is inside; inner:
 * every cell inside that touches no triangle. Touching is judged with 2^-20 of a cell to spare. A
 * point is inside if the triangles wind around it (the winding number is not 0). That number is
 * computed once for each region of cells without a triangle. Errors: ARGUMENT if a coordinate is
 * not finite, or if a winding number is not whole, because the mesh is open or triangles are turned
 * round; MEMORY. After an error the stock must be freed. The caller proves that the mesh is closed
 * (sepax_shell_find): a hole much smaller than a cell is not seen here. `watch` may be NULL. */
bool sepax__stock_fill_mesh(sepax__stock *stock, const sepax_soup *mesh,
                            const sepax__stock_watch *watch, sepax_error *error);

/* ----------------------------------------------------------------- cutting */

/* The tool goes a way and cuts. Outer: give the shapes `inside`; a cell goes if all of it lies in
 * one of them, shrunk by `tolerance` and the deviation of the way, while it goes one piece of the
 * way. Inner: give `outside`; cells go that one of them may touch, made larger by the same. The
 * tolerance is how far the machine may be from the way. Ways are divided until deviation and
 * tolerance are at most cell / 8, the deviation cell / 32, or it does not fall any more. Errors:
 * ARGUMENT if a pose is not valid, or the tolerance is negative or not finite; MEMORY. After an
 * error an outer bound is still an outer bound; an inner one must be freed. */
bool sepax__stock_cut(sepax__stock *stock, const sepax__stock_shape *shape, size_t shapes,
                      const sepax__stock_way *way, double tolerance, sepax_error *error);

/* ----------------------------------------------------------------- testing */

/* What a test found. If `free` is true, then it is proved: no point of the shapes, shrunk, is in a
 * cell at any time of the way. If it is false, then cells may be touched; `box` encloses those that
 * were found. */
typedef struct {
  bool free;
  double box[2][3];
} sepax__stock_touch;

/* Do the shapes, shrunk by `shrink`, touch the outer bound on the way? Give the shapes `outside`.
 * `tolerance` makes them larger. If `all` is true, then found->box encloses all cells that may be
 * touched on the whole way, so outside of it the way is free; otherwise the test ends at the first.
 * Shapes that are parts of one tool, one above the other, must have the limits between them
 * `joined`, or shrinking opens a gap. Cost: about 0.2 microseconds far away, some microseconds in a
 * slot. Errors: ARGUMENT if the bound is not outer, a pose is not valid, or `shrink` is negative or
 * not less than half of a shape's radius, which would leave too little of it to prove anything. */
bool sepax__stock_test(const sepax__stock *stock, const sepax__stock_shape *shape, size_t shapes,
                       const sepax__stock_way *way, double shrink, double tolerance, bool all,
                       sepax__stock_touch *found, sepax_error *error);

/* How deep are the shapes in the outer bound? depth[0]: shrunk by this they are seen to touch it,
 * or -1 if they are free as they are. depth[1]: shrunk by this they are free of it (proved), or
 * infinity if that cannot be told, as the shapes are too small. depth[1] - depth[0] is at most a
 * quarter of a cell, unless depth[1] is infinite. Errors: as sepax__stock_test. */
bool sepax__stock_depth(const sepax__stock *stock, const sepax__stock_shape *shape, size_t shapes,
                        const sepax__stock_way *way, double tolerance, double depth[2],
                        sepax_error *error);

/* Do the shapes certainly meet material? Give the shapes `inside` and the inner bound. If *hit is
 * true, then a point of the shapes, shrunk by `tolerance` and the deviation, is in a cell of the
 * inner bound: the tool collides wherever within the tolerance it is. `at` is that point. If *hit
 * is false, nothing is proved. Errors: ARGUMENT if the bound is not inner or a pose is not valid.
 */
bool sepax__stock_hit(const sepax__stock *stock, const sepax__stock_shape *shape, size_t shapes,
                      const sepax__stock_way *way, double tolerance, bool *hit, double at[3],
                      sepax_error *error);

/* ------------------------------------------------------------------- files */

/* Write the stock to a file, and read it. docs/reference/stock.md has the format. The file is
 * written under a temporary name and renamed. Errors: FILE; FORMAT if the file is not such a file,
 * of another version, truncated, too long, damaged (checksum) or has impossible sizes; LIMIT as
 * sepax__stock_new; MEMORY. */
bool sepax__stock_write(const sepax__stock *stock, const char *path, sepax_error *error);
bool sepax__stock_read(sepax__stock **stock, const char *path, sepax_error *error);

/* The surface of the cells that are there: rectangles of faces between material and none, two
 * triangles each. The mesh is closed (sepax_shell_find) and its triangles are turned outward; a
 * corner may be in the middle of another triangle's edge, exactly. Cost: some nanoseconds for each
 * brick and each face, twice. Errors: LIMIT on more than `most` triangles; MEMORY. The soup is
 * empty if there is no cell. */
bool sepax__stock_mesh(const sepax__stock *stock, size_t most, sepax_soup *soup,
                       sepax_error *error);

#endif
