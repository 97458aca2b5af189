/* parts.h - what the parts of sepax path share: command.c and options.c read what is asked, scene.c
 * makes bodies of the links and pairs of the bodies, search.c asks each pair in each line,
 * certify.c what is between the lines, results.c puts that together, certificate.c writes it down,
 * engine.c makes jobs of it, text.c and data.c tell, picture.c and page.c show. */
#ifndef SEPAX_PATH_PARTS_H
#define SEPAX_PATH_PARTS_H

#include "cli/meshes.h"
#include "cli/question.h"
#include "formats/formats.h"

enum { PATH_PACKAGES_MOST = 64, PATH_WORD_MIN = 6 };

typedef struct {
  const char *urdf, *motion;
  const char *srdf, *csv, *picture, *certificate, *page, *jobs; /* or NULL */
  report_bands bands;                                           /* metres */
  report_limit resolution;                                      /* metres */
  report_limit lsb; /* of the trees of `jobs`, metres; 0: the finest */
  int word;         /* of these; 0: not given */
  cli_output output;
  bool surfaces, no_distance, certify;
  bool keep; /* the bodies' meshes */
  size_t intervals;
  int threads;
  format_motion_rules rules;
  cli_meshes meshes;
  format_package package[PATH_PACKAGES_MOST];
  size_t packages;
} path_question;

/* One collision element of a body, a solid of its own. */
typedef struct {
  sepax_body *body;
  sepax_shell shell;
  report_mesh file; /* zero where it has none */
} path_part;

typedef struct {
  size_t link;
  sepax_body
      *body; /* of all parts, without triangles that are there twice; or that of the only one */
  path_part *part;
  size_t parts, open; /* how many parts are no solids */
  sepax_soup mesh;    /* of all parts; for picture and page only */
  size_t triangles;
  double least[3], most[3]; /* its AABB in the link's coordinates */
} path_body;

#define PATH_NO_LINE SIZE_MAX

/* From a line to the next: the part index / 2^level ... (index + 1) / 2^level of the way. */
typedef struct {
  size_t segment; /* the line, from 0 */
  unsigned level;
  uint64_t index;
  double bound;   /* no point of a body moves farther from the middle, seen from the other */
  bool by_axis;   /* their boxes are so far from each other along `axis`, */
  double axis[3]; /* from the second body to the first, in the second's coordinates at the middle */
} path_interval;

/* What is known of a pair between the lines: the intervals that are certified, in the order of
 * time, to the end or to that which is open. */
typedef struct {
  path_interval *interval;
  size_t count, capacity;
  bool certified; /* the whole path, lines and all */
  bool is_open;
  path_interval open;
  double distance; /* at the middle of that */
  bool ended;      /* it is open as no more intervals were to be taken */
  bool collides;   /* in a pose that was found there or behind it: */
  size_t segment;
  double part; /* of the way */
} path_proof;

/* In a line, from 0, or, where `part` is not 0, so far on the way to the next. */
typedef struct {
  size_t line;
  double part;
} path_moment;

/* Two bodies, and what is known of them. */
typedef struct {
  size_t body[2];
  sepax_chain chain;
  size_t lines[VERDICTS]; /* how many have this verdict */
  size_t first[VERDICTS]; /* the first of them, or PATH_NO_LINE */
  double least;           /* the least clearance, infinite where it is not asked */
  size_t least_line;
  double point[2][3];     /* that far from each other, in the coordinates of the chain's top */
  bool inside;            /* one has the other, or a part of it, inside there: no points */
  unsigned char *verdict; /* of each line, where they are written; or NULL */
  path_proof proof;
} path_pair;

/* What path_write_jobs wrote. */
typedef struct {
  size_t bodies, bytes;
  double resolution;
  sepax_config config; /* of a design for it */
} path_jobs;

typedef struct {
  format_robot robot;
  format_motion motion;
  path_body *body;
  size_t bodies;
  path_pair *pair;
  size_t pairs;
  format_srdf srdf; /* its robot NULL where the URDF has that name, too */
  /* Pairs that are not compared: links of one joint, links that no joint moves against each other;
   * by the SRDF. */
  size_t joined, rigid, disabled;
  path_jobs jobs;
  bool between; /* what is between the lines was asked */
  bool removed; /* a certificate of an earlier run */
  double seconds, between_seconds;
} path_scene;

/* An argp child, whose input is a path_question: SRDF, packages, bands, rules of the path. */
extern const struct argp path_scene_argp;

/* False leaves a scene that can be freed. */
bool path_scene_load(path_scene *scene, const path_question *q, sepax_error *error);
void path_scene_free(path_scene *scene);

bool path_search(path_scene *scene, const path_question *q, sepax_error *error);

/* Nothing is printed or written: the first collision ends the search. */
bool path_status_only(const path_question *q);

/* Of pairs that do not collide in any line: do they between lines? */
bool path_certify(path_scene *scene, const path_question *q, sepax_error *error);

report_verdict path_in_lines(const path_pair *pair); /* the worst of all lines */
report_verdict path_between_lines(const path_pair *pair);
report_verdict path_verdict_of(const path_pair *pair); /* of both */
report_verdict path_worst(const path_scene *scene);    /* of all pairs */
size_t path_certified_pairs(const path_scene *scene);
bool path_certified(const path_scene *scene); /* all of them */

void path_open_ends(const path_pair *pair, double ends[2]); /* parts of the way of its segment */
/* Of what is not free between lines: the pose that collides, or the middle of what is open. */
path_moment path_between_moment(const path_pair *pair);
path_moment path_first(const path_pair *pair, report_verdict verdict);
/* The first of the worst verdict; where all are free, the line of the least clearance. */
path_moment path_worst_moment(const path_scene *scene);
double path_value(const format_motion *motion, path_moment at, size_t joint);
double path_time(const format_motion *motion, path_moment at);
void path_values(const format_motion *motion, path_moment at, double *value);

/* The certificate where all pairs are certified; otherwise the file of an earlier run goes. */
bool path_write_certificate(path_scene *scene, const path_question *q, sepax_error *error);

const char *path_body_name(const path_scene *scene, size_t body);
bool path_has_body(const path_scene *scene, size_t link);

/* Where two points of a pair are in the root's coordinates. */
void path_points(const path_scene *scene, const path_pair *pair, double point[2][3]);

void path_print_text(const path_scene *scene, const path_question *q);
void path_print_json(const path_scene *scene, const path_question *q);
bool path_write_csv(const path_scene *scene, const char *path, sepax_error *error);
bool path_write_picture(const path_scene *scene, const char *path, sepax_error *error);
bool path_write_jobs(path_scene *scene, const path_question *q, sepax_error *error);

/* What path_print_json prints: jansson's json_t. */
struct json_t *path_report(const path_scene *scene, const path_question *q);

/* False where the page's programs are missing, or the scene is larger than a page. */
bool path_page_possible(const path_scene *scene, sepax_error *error);
bool path_write_page(const path_scene *scene, const path_question *q, sepax_error *error);
extern const char path_page_html[]; /* page.html, by scripts/embed */

#endif
