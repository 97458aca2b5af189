/* SPDX-License-Identifier: MIT */
/* parts.h - what the parts of sepax path share. options.c and scene_options.c read the options.
 * scene.c makes bodies from links and pairs from bodies. rules.c lets pairs meet. search.c decides
 * each pair in each line. certify.c proves the motion between lines. results.c combines the
 * verdicts. certificate.c writes the proof. engine.c and jobs.c make jobs. text.c, data.c,
 * picture.c and page.c print and write the results. */
#ifndef SEPAX_PATH_PARTS_H
#define SEPAX_PATH_PARTS_H

#include "cli/meshes.h"
#include "cli/question.h"
#include "formats/formats.h"
#include "nc/nc.h"
#include "nc/tools.h"

enum { PATH_PACKAGES_MOST = 64, PATH_AXES_MOST = 16, PATH_CONTROLS_MOST = 10, PATH_WORD_MIN = 6 };

typedef struct {
  const char *urdf, *motion;
  const char *srdf, *table, *csv, *picture, *certificate, *page,
      *jobs;               /* files of the options, or NULL */
  report_bands bands;      /* metres */
  report_limit resolution; /* metres */
  report_limit lsb;        /* --lsb of --jobs, metres; 0: the finest */
  int word;                /* --word of --jobs; 0: not given */
  cli_output output;
  bool surfaces, no_distance, certify;
  bool keep; /* keep the meshes of the bodies */
  size_t intervals;
  int threads;
  format_motion_rules rules;
  cli_meshes meshes;
  sepax_package package[PATH_PACKAGES_MOST];
  size_t packages;
  /* Tools as bodies on a link; tools is NULL if there are none. The names of the links of the stock
   * and of the finished part, or NULL; how deep flutes may be in the part, metres. */
  const char *tools, *tool_link, *stock, *part;
  const char *first, *left;        /* files of the stock: at the start, and what is left; or NULL */
  report_limit gouge, cell, depth; /* metres; cell and depth: of the stock as it is cut */
  int loaded;                      /* the tool in the spindle at the start; -1: not known */
  /* Of an NC program; machine is NULL if the path is a motion file. */
  const char *machine, *tool_table, *start;
  struct {
    char letter;
    const char *joint;
  } axis[PATH_AXES_MOST]; /* of --axis */
  size_t axes;
  const char *control[PATH_CONTROLS_MOST]; /* of --control: options of the front end */
  size_t controls;
  bool dogleg;
  bool blended;           /* count blending without a bound */
  report_limit deviation; /* of joints from linear motion, metres or radians; 0: the default */
  report_limit smoothing; /* of linear joints by the control, metres */
  const char *written;    /* the motion file of --motion, or NULL */
  const char *tube;       /* the file of --tube, or NULL */
} path_question;

/* A part of a body: one collision element, which is a solid of its own. */
typedef struct {
  const sepax_shape *shape; /* NULL: of a tool */
  sepax_body *body;
  sepax_shell shell;
  report_mesh file; /* its mesh file; all zero if it has none */
} path_part;

typedef struct {
  size_t link;
  char *name;                   /* of a part of a tool, "T3 holder"; NULL: the link's name */
  const char *role;             /* of such a part, "holder" */
  const nc_turned_tool *turned; /* the tool, and which part of it */
  nc_tool_part turned_part;
  size_t tool; /* number of the tool's name in the motion; FORMAT_NO_NAME: not of a tool */
  sepax_body
      *body; /* all parts as one body, without triangles that occur twice; or the only part */
  path_part *part;
  size_t parts, open; /* number of parts; number of parts that are not closed */
  sepax_soup mesh;    /* all parts, in one mesh; only for --worst and --page */
  size_t triangles;
  double least[3], most[3]; /* the body's AABB in the link's coordinates */
} path_body;

#define PATH_NO_LINE SIZE_MAX

/* An interval between a line and the next: from index / 2^level to (index + 1) / 2^level of the
 * way. */
typedef struct {
  size_t segment; /* the line before, counted from 0 */
  unsigned level;
  uint64_t index;
  double bound;   /* no point of one body moves farther than this from its place at the middle, as
                     seen from the other body */
  bool by_axis;   /* proved by the gap of the bodies' boxes along `axis` */
  double axis[3]; /* from the second body to the first, in the second body's coordinates at the
                     middle */
} path_interval;

/* What is known of a pair between the lines: the certified intervals in the order of time, until
 * the end of the path or the first open interval. */
typedef struct {
  path_interval *interval;
  size_t count, capacity;
  bool certified; /* the whole path is free, in the lines and between them */
  bool is_open;
  path_interval open;
  double distance; /* distance at the middle of the open interval */
  bool ended;      /* the interval is open because the limit of --intervals was reached */
  bool collides;   /* a pose with a collision was found: */
  size_t segment;
  double part; /* part of the way from that line to the next */
} path_proof;

/* A moment of the path: a line, counted from 0, and the part of the way from this line to the next;
 * part 0 is the line itself. */
typedef struct {
  size_t line;
  double part;
} path_moment;

/* Two bodies and what is known of them. */
typedef struct {
  size_t body[2];
  sepax_chain chain;
  size_t tool; /* the pair exists only while this tool is in the spindle; FORMAT_NO_NAME: always */
  bool bare;   /* flutes or shank, and the stock or the part: clearance and warning do not count */
  bool by_cells; /* decided by the stock as it is cut */
  bool of_left;  /* no part of a tool, and not free of the first stock: so what is left decides */
  double deepest[2]; /* if by_cells: the deepest touch that was found, in metres: seen to touch when
                        shrunk by the first, free when shrunk by the second */
  size_t deepest_line;
  unsigned may_meet;                                    /* in motions of kind k if bit k is set */
  size_t lines_asked, lines_left_out, motions_left_out; /* left out by rules */
  size_t lines[VERDICTS];                               /* number of lines with each verdict */
  size_t first[VERDICTS];  /* first line with each verdict, or PATH_NO_LINE */
  sepax_within_reason why; /* of the first undecided line: why it is not known whether body[why_of]
                              is inside the other one */
  int why_of;
  double least; /* least clearance; infinite if it was not computed */
  size_t least_line;
  double interval[2]; /* the exact least clearance is within these numbers */
  size_t measured;    /* number of searches for the distance in a line */
  double point[2][3]; /* points of both bodies at that distance, in the coordinates of the chain's
                         top link */
  bool inside; /* at the least clearance one body, or a part of it, is inside the other; there are
                  no points */
  unsigned char *verdict; /* verdict of each line if it is written to a file; otherwise NULL */
  path_proof proof;
  /* Of --certify on a path with steps, otherwise NULL: between[n] is the verdict of the motion from
   * line n to the next; if it is not free, then part[n] is the part of the way where that was
   * found. */
  unsigned char *between;
  double *part;
} path_pair;

/* A list of jobs that path_write_jobs wrote. */
typedef struct {
  char *file;
  size_t jobs, poses, bodies, bytes;
  double resolution;
  sepax_config config; /* a design for the list */
} path_jobs;

/* The stock before the motion that ends in a line, coarse, in the coordinates of its link. */
typedef struct {
  size_t line;
  sepax_soup mesh;
} path_snapshot;

enum { PATH_SNAPSHOTS = 16 };

/* What the flutes of a tool do in feeds. */
typedef struct {
  size_t feeds, still; /* numbers of feeds, and of those in which the spindle does not turn */
  size_t first_still;  /* the line where the first of these ends */
  bool touches;        /* a feed touches what is left */
} path_feeds;

/* The stock as it is cut: its body, the side of its cells and the depth D, in metres; what is left.
 */
typedef struct {
  size_t body;
  double cell, depth; /* cell is 0 if no stock is cut */
  size_t cells, bytes;
  double seconds;
  path_feeds *feeds; /* of each name of the motion; NULL before the stock is cut */
  path_snapshot snapshot[PATH_SNAPSHOTS + 1]; /* in the order of the path; for the page */
  size_t snapshots;
} path_stock;

/* The link of the URDF from which the nose of the spindle is where the axes are, up to `off`
 * metres.
 */
typedef struct {
  size_t link; /* SIZE_MAX: not asked */
  double off;
  double length; /* metres: not the nose, but the point so far below it */
} path_agreement;

typedef struct {
  sepax_robot robot;
  format_motion motion;
  nc_motion nc;                    /* of an NC program; otherwise zero */
  size_t joint_of[NC_JOINTS_MOST]; /* the URDF's joint of each joint of the control */
  path_agreement agreement;        /* of kinematics that are not trivial */
  nc_tools tools;                  /* of --tools */
  size_t tool_link;                /* SIZE_MAX: no tools */
  size_t *partner;                 /* links that are compared with the link of the tools */
  size_t partners;
  size_t *row_of; /* the row of nc that each line of the path is */
  double *spread; /* of a program with dog-legs: spread[line * joints + j] is how far joint j may be
                     off in the motion that ends in the line; otherwise NULL */
  path_body *body;
  size_t bodies;
  size_t *body_of; /* of each link; SIZE_MAX if it has none */
  path_pair *pair;
  size_t pairs;
  sepax_srdf srdf; /* its robot is NULL if the URDF has the same name */
  /* Numbers of pairs that are not compared: links of one joint, links that no joint moves against
   * each other, pairs disabled by the SRDF. */
  size_t joined, rigid, disabled;
  path_jobs *jobs;                 /* of --jobs: a list, or one for each tool */
  size_t job_lists, jobs_left_out; /* number of lists; of pairs that are in none */
  path_stock stock;
  double gouge; /* how deep flutes may be in the finished part, metres */
  bool between; /* --certify has run */
  bool removed; /* a certificate of an earlier run was removed */
  bool tube_removed;
  double slack; /* each joint may be off by so much besides, m or rad */
  double seconds, between_seconds;
} path_scene;

/* An argp child for the options of a scene: SRDF, packages, bands, rules of the path. Its input is
 * a path_question. */
extern const struct argp path_scene_argp;

/* Read the options of sepax path. Ends the program if they are wrong. */
void path_parse(path_question *q, int argc, char **argv);

/* Do the options go together? */
bool path_options_agree(const path_question *q, sepax_error *error);

/* Load the scene. After false the scene can be freed. */
bool path_scene_load(path_scene *scene, const path_question *q, sepax_error *error);
void path_scene_free(path_scene *scene);

/* The clearance and the warning of a pair. */
report_bands path_bands(const path_question *q, const path_pair *pair);

/* Read a table of links or parts of tools that may meet in motions of a kind. */
bool path_rules_apply(path_scene *scene, const char *path, sepax_error *error);

/* Count the lines of each pair that are asked. */
void path_rules_count(path_scene *scene);

/* Does the pair exist in the motion from a line to the next, and must it be free? */
bool path_motion_asked(const path_scene *scene, const path_pair *pair, size_t line);

/* The same of a line: of the motion that ends there or the one that begins there. Of a line between
 * breaks its own kind and tool count. */
bool path_line_asked(const path_scene *scene, const path_pair *pair, size_t line);

/* The line at the end of the motion that a verdict in a line belongs to: the motion that ends there
 * if it is asked, else the one that begins there. */
size_t path_motion_of(const path_scene *scene, const path_pair *pair, size_t line);

/* Violations of a pair in motions of one kind. */
typedef struct {
  const path_pair *pair;
  report_verdict verdict;
  format_kind kind;
  path_moment first; /* its motion ends in line `motion` */
  size_t motion;
  size_t motions; /* number of lines of the program with such motions */
  size_t last;    /* the last of them */
} path_violation;

/* All violations of a path with steps, the worst first, then in the order of the path. NULL without
 * memory. The caller frees the list. */
path_violation *path_violations(const path_scene *scene, size_t *count);

/* Is the way from the line before to this one not known? The boxes of a dog-leg are no such break.
 */
bool path_way_unknown(const path_scene *scene, size_t line);

/* Number of motions whose corners the control may round without a bound, and the line of the first.
 */
size_t path_unbounded_corners(const path_scene *scene, size_t *first);

bool path_search(path_scene *scene, const path_question *q, sepax_error *error);

/* True if nothing is printed or written, so that the first collision ends the search. Not where a
 * stock is cut: what is left of it may decide anew. */
bool path_status_only(const path_question *q);

/* Certify the motion between the lines for all pairs that collide in no line. */
bool path_certify(path_scene *scene, const path_question *q, sepax_error *error);

report_verdict path_in_lines(const path_pair *pair); /* the worst verdict of all lines */
report_verdict path_between_lines(const path_pair *pair);
report_verdict
path_verdict_of(const path_pair *pair); /* the worse of both: in the lines and between them */
report_verdict path_worst(const path_scene *scene); /* the worst verdict of all pairs */
size_t path_certified_pairs(const path_scene *scene);
bool path_certified(const path_scene *scene); /* all pairs are certified */

void path_open_ends(const path_pair *pair,
                    double ends[2]); /* ends of the open interval, as parts of the way */
/* The pose with a collision, or the middle of the open interval, of a pair that is not free between
 * lines. */
path_moment path_between_moment(const path_pair *pair);
path_moment path_first(const path_pair *pair, report_verdict verdict);
/* What is known of the motion from a line to the next, and where it was found. Of a path without
 * steps only the first motion that is not free is known. */
report_verdict path_motion_verdict(const path_pair *pair, size_t line, path_moment *at);
/* The first moment with the worst verdict. If all pairs are free, then the line of the least
 * clearance. *pair receives the pair; NULL if no clearance was found. */
path_moment path_worst_moment(const path_scene *scene, const path_pair **pair);
double path_value(const format_motion *motion, path_moment at, size_t joint);
double path_time(const format_motion *motion, path_moment at);
void path_values(const format_motion *motion, path_moment at, double *value);

/* The motion file that the certificate is about. */
const char *path_motion_file(const path_question *q);

/* Write the certificate if all pairs are certified. Otherwise remove the certificate of an earlier
 * run. */
bool path_write_certificate(path_scene *scene, const path_question *q, sepax_error *error);

/* The place of a line in its program, "part.ngc:127", or "" if the path does not say it. */
enum { PATH_PLACE = 300 };
const char *path_place(const format_motion *motion, size_t line, char text[PATH_PLACE]);

const char *path_body_name(const path_scene *scene, size_t body);
/* Complete a body that has space for one part: the part and its box. */
bool path_body_of_mesh(path_body *b, const sepax_soup *mesh, bool keep, sepax_error *error);

const char *path_mesh_file(const path_part *part); /* NULL: none */
bool path_has_body(const path_scene *scene, size_t link);

/* The nearest points of a pair in the root's coordinates. */
void path_points(const path_scene *scene, const path_pair *pair, double point[2][3]);

void path_print_text(const path_scene *scene, const path_question *q);
void path_print_json(const path_scene *scene, const path_question *q);
bool path_write_csv(const path_scene *scene, const char *path, sepax_error *error);
bool path_write_picture(const path_scene *scene, const char *path, sepax_error *error);
/* Write the tube of a program that is free. Otherwise remove the tube of an earlier run. */
bool path_write_tube(path_scene *scene, const path_question *q, sepax_error *error);
bool path_tube_is_free(const path_scene *scene);

bool path_write_jobs(path_scene *scene, const path_question *q, sepax_error *error);

/* The JSON that path_print_json prints. json_t is of jansson. */
struct json_t *path_report(const path_scene *scene, const path_question *q);

/* Fails if three.js is missing or if the scene is too large for a page. */
bool path_page_possible(const path_scene *scene, sepax_error *error);
bool path_write_page(const path_scene *scene, const path_question *q, sepax_error *error);
extern const char path_page_html[]; /* the text of page.html, embedded by scripts/embed */

#endif
