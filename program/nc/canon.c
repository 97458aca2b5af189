/* SPDX-License-Identifier: MIT */
/* canon.c - reader of canonical motion. */
#include "nc/canon.h"
#include "nc/reader.h"
#include "util/error.h"
#include "util/list.h"
#include "util/plain_numbers.h"

#include <limits.h>
#include <math.h>
#include <string.h>

static const char letters[] = "XYZABCUVW";
static const size_t records_most = (size_t)1 << 24;

enum { LINES_MOST = INT_MAX, TURNS_MOST = 10000 };

char nc_letter(int axis) { return letters[axis]; }

int nc_axis(char letter) {
  const char *at = letter != '\0' ? strchr(letters, letter) : NULL;
  return at != NULL ? (int)(at - letters) : -1;
}

const char *nc_program_file(const nc_program *program, int number) {
  for (size_t n = 0; n < program->files; n++) {
    if (program->file[n].number == number) {
      return program->file[n].path;
    }
  }
  return "(a file of unknown name)";
}

void nc_program_free(nc_program *program) {
  for (size_t n = 0; n < program->files; n++) {
    sepax_release(program->file[n].path);
  }
  for (size_t n = 0; n < program->tools; n++) {
    sepax_release(program->tool[n].comment);
  }
  for (size_t n = 0; n < program->records; n++) {
    sepax_release(program->record[n].text);
  }
  sepax_release(program->file);
  sepax_release(program->tool);
  sepax_release(program->record);
  *program = (nc_program){0};
}

/* ---------------------------------------------------------------- what the program does */

static bool take_place(nc_reader *r, nc_record *to) {
  long file, line;
  if (!nc_take_whole(&r->words, "number of a file", -1, NC_FILES_MOST, &file) ||
      !nc_take_whole(&r->words, "line of the program", 0, LINES_MOST, &line)) {
    return false;
  }
  to->file = (int)file;
  to->line = (size_t)line;
  size_t n = 0;
  while (n < r->program->files && r->program->file[n].number != to->file) {
    n++;
  }
  return file == -1 || n < r->program->files ||
         nc_refuse(&r->words, "file %ld has no record `file` before this line", file);
}

static bool take_kind(nc_reader *r, nc_record *to) {
  static const char *const kinds[] = {"rapid", "feed", "probe", NULL};
  int kind = 0;
  if (!nc_take_choice(&r->words, "kind of a motion", kinds, &kind)) {
    return false;
  }
  to->kind = (nc_kind)kind;
  return take_place(r, to) && nc_take_numbers(&r->words, "axis", NC_AXES, to->axis);
}

static bool read_move(nc_reader *r, nc_record *to) {
  to->action = NC_DO_MOVE;
  return take_kind(r, to);
}

static bool read_arc(nc_reader *r, nc_record *to) {
  long turns;
  to->action = NC_DO_ARC;
  if (!take_kind(r, to) || !nc_take_numbers(&r->words, "centre", 3, to->centre) ||
      !nc_take_numbers(&r->words, "normal", 3, to->normal) ||
      !nc_take_whole(&r->words, "turns", 0, TURNS_MOST, &turns)) {
    return false;
  }
  to->number = (int)turns;
  double square =
      to->normal[0] * to->normal[0] + to->normal[1] * to->normal[1] + to->normal[2] * to->normal[2];
  return fabs(square - 1) < 1e-6 ||
         nc_refuse(&r->words, "the normal's length is %.9g instead of 1", sqrt(square));
}

static bool read_dwell(nc_reader *r, nc_record *to) {
  to->action = NC_DO_DWELL;
  to->kind = NC_DWELL;
  return take_place(r, to) && nc_take_number(&r->words, "seconds", &to->seconds) &&
         (to->seconds >= 0 || nc_refuse(&r->words, "%.9g s is no time", to->seconds));
}

static bool read_number(nc_reader *r, nc_record *to, const char *what, long most) {
  long number;
  if (!take_place(r, to) || !nc_take_whole(&r->words, what, 0, most, &number)) {
    return false;
  }
  to->number = (int)number;
  return true;
}

static bool read_load(nc_reader *r, nc_record *to) {
  to->action = NC_DO_LOAD;
  return read_number(r, to, "number of a tool", INT_MAX);
}

static bool read_kins(nc_reader *r, nc_record *to) {
  to->action = NC_DO_KINS;
  return read_number(r, to, "type of the kinematics", 9) &&
         nc_take_numbers(&r->words, "position", NC_AXES, to->axis);
}

static bool read_note(nc_reader *r, nc_record *to) {
  to->action = NC_DO_NOTE;
  return take_place(r, to) && nc_take_text(&r->words, &to->text);
}

static bool read_length(nc_reader *r, nc_record *to) {
  to->action = NC_DO_LENGTH;
  return take_place(r, to) && nc_take_numbers(&r->words, "offset", NC_AXES, to->axis);
}

static bool read_spindle(nc_reader *r, nc_record *to) {
  static const char *const states[] = {"off", "on", NULL};
  to->action = NC_DO_SPINDLE;
  return take_place(r, to) && nc_take_choice(&r->words, "spindle", states, &to->number);
}

/* G64 P0 is G64 without P, so a tolerance of 0 is no bound. */
static bool read_blend(nc_reader *r, nc_record *to) {
  static const char *const blends[] = {"exact", "within", "unbounded", NULL};
  int blend = 0;
  to->action = NC_DO_BLEND;
  if (!take_place(r, to) || !nc_take_choice(&r->words, "blend", blends, &blend)) {
    return false;
  }
  to->blend = (nc_blend)blend;
  if (to->blend != NC_WITHIN) {
    return true;
  }
  if (!nc_take_number(&r->words, "tolerance", &to->within)) {
    return false;
  }
  to->blend = to->within > 0 ? NC_WITHIN : NC_UNBOUNDED;
  return to->within >= 0 || nc_refuse(&r->words, "%.9g mm is no tolerance", to->within);
}

static bool read_end(nc_reader *r, nc_record *to) {
  to->action = NC_DO_END;
  r->ended = true;
  return take_place(r, to);
}

/* --------------------------------------------------------------------------- lines */

typedef struct {
  const char *name;
  bool (*head)(nc_reader *r);                  /* of a record of the head, */
  bool (*action)(nc_reader *r, nc_record *to); /* or of what the program does */
} entry;

static const entry entries[] = {
    {"file", nc_read_file, NULL},   {"machine", nc_read_machine, NULL},
    {"joint", nc_read_joint, NULL}, {"parameter", nc_read_parameter, NULL},
    {"tool", nc_read_tool, NULL},   {"start", nc_read_start, NULL},
    {"servo", nc_read_servo, NULL}, {"limits", nc_read_limits, NULL},
    {"move", NULL, read_move},      {"arc", NULL, read_arc},
    {"dwell", NULL, read_dwell},    {"load", NULL, read_load},
    {"length", NULL, read_length},  {"spindle", NULL, read_spindle},
    {"kins", NULL, read_kins},      {"blend", NULL, read_blend},
    {"note", NULL, read_note},      {"end", NULL, read_end},
};

static bool read_action(nc_reader *r, const entry *e) {
  nc_program *p = r->program;
  if (!r->started) {
    return nc_refuse(&r->words, "`%s` comes before `start`", e->name);
  }
  nc_record *grown = p->records < records_most
                         ? list_grow(p->record, &r->record_capacity, p->records, sizeof *grown)
                         : NULL;
  if (grown == NULL) {
    return nc_no_memory(r);
  }
  p->record = grown;
  nc_record *to = &p->record[p->records];
  *to = (nc_record){0};
  if (!e->action(r, to)) {
    return false;
  }
  p->records++;
  return true;
}

static bool read_record(nc_reader *r) {
  const char *name = nc_word(&r->words);
  if (r->ended) {
    return nc_refuse(&r->words, "a line after `end`");
  }
  for (size_t n = 0; n < sizeof entries / sizeof *entries; n++) {
    const entry *e = &entries[n];
    if (strcmp(e->name, name) == 0) {
      if (e->head != NULL && r->started && e->head != nc_read_file) {
        return nc_refuse(&r->words, "`%s` comes after `start`", name);
      }
      return (e->head != NULL ? e->head(r) : read_action(r, e)) && nc_take_end(&r->words);
    }
  }
  return nc_refuse(&r->words, "record '%.40s' is not known", name);
}

/* Read a line without its line feed: 1, 0 at the end of the stream, -1 after an error. */
static int get_line(nc_reader *r, FILE *stream, char *text) {
  size_t length = 0;
  int c;
  r->words.line++;
  while ((c = getc(stream)) != EOF && c != '\n') {
    if (c == '\0' || length == NC_LINE_MOST - 1) {
      nc_refuse(&r->words, c == '\0' ? "a byte of zero; the stream is text"
                                     : "the line is too long for a record");
      return -1;
    }
    text[length++] = (char)c;
  }
  text[length] = '\0';
  if (c == EOF && ferror(stream)) {
    nc_refuse(&r->words, "the stream cannot be read");
    return -1;
  }
  if (c == EOF && length > 0) {
    nc_refuse(&r->words, "the stream ends within a line; what wrote it did not finish");
    return -1;
  }
  return c != EOF;
}

static bool read_lines(nc_reader *r, FILE *stream) {
  char text[NC_LINE_MOST];
  int got = get_line(r, stream, text);
  if (got < 0) {
    return false;
  }
  if (strcmp(text, "sepax-nc 1") != 0) {
    return nc_refuse(&r->words, "the first line is not `sepax-nc 1`");
  }
  while ((got = get_line(r, stream, text)) == 1) {
    r->words.rest = text;
    if (!read_record(r)) {
      return false;
    }
  }
  return got == 0 && (r->ended || nc_refuse(&r->words, "the stream ends without `end`; what wrote "
                                                       "it did not finish"));
}

bool nc_program_read(nc_program *program, FILE *stream, const char *name, sepax_error *error) {
  nc_reader r = {.words = {.name = name, .error = error}, .program = program};
  *program = (nc_program){0};
  plain_numbers plain = plain_numbers_begin();
  bool ok = read_lines(&r, stream);
  plain_numbers_end(plain);
  if (!ok) {
    nc_program_free(program);
  }
  return ok;
}
