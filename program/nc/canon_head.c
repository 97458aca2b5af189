/* SPDX-License-Identifier: MIT */
/* canon_head.c - reader of the records that come before the program's: files, machine, tools. */
#include "nc/reader.h"
#include "util/error.h"
#include "util/list.h"

#include <limits.h>
#include <string.h>

enum { TOOLS_MOST = 100000 };

bool nc_no_memory(const nc_reader *r) {
  return sepax_fail(r->words.error, SEPAX_ERROR_MEMORY, "%.180s:%zu: no memory for so many records",
                    r->words.name, r->words.line);
}

bool nc_read_file(nc_reader *r) {
  nc_program *p = r->program;
  long number;
  if (!nc_take_whole(&r->words, "number of a file", 0, NC_FILES_MOST, &number)) {
    return false;
  }
  for (size_t n = 0; n < p->files; n++) {
    if (p->file[n].number == (int)number) {
      return nc_refuse(&r->words, "file %ld has two records", number);
    }
  }
  if (r->words.rest == NULL || *r->words.rest == '\0') {
    return nc_refuse(&r->words, "file %ld has no path", number);
  }
  nc_file *grown = list_grow(p->file, &r->file_capacity, p->files, sizeof *grown);
  if (grown == NULL) {
    return nc_no_memory(r);
  }
  p->file = grown;
  p->file[p->files] = (nc_file){.number = (int)number};
  if (!nc_take_text(&r->words, &p->file[p->files].path)) {
    return false;
  }
  p->files++;
  return true;
}

bool nc_read_machine(nc_reader *r) {
  nc_program *p = r->program;
  if (p->machine_words > 0) {
    return nc_refuse(&r->words, "a second record `machine`");
  }
  do {
    if (p->machine_words == NC_WORDS_MOST) {
      return nc_refuse(&r->words, "more than %d words", NC_WORDS_MOST);
    }
    if (!nc_take_name(&r->words, "kinematics", p->machine[p->machine_words])) {
      return false;
    }
    p->machine_words++;
  } while (r->words.rest != NULL);
  return true;
}

bool nc_read_parameter(nc_reader *r) {
  nc_program *p = r->program;
  if (p->parameters == NC_PARAMETERS_MOST) {
    return nc_refuse(&r->words, "more than %d parameters", NC_PARAMETERS_MOST);
  }
  nc_parameter *to = &p->parameter[p->parameters];
  if (!nc_take_name(&r->words, "parameter", to->name) ||
      !nc_take_number(&r->words, "value of the parameter", &to->value)) {
    return false;
  }
  static const char *const more[] = {"z", NULL};
  int choice;
  to->follows = r->words.rest != NULL;
  if (to->follows && !nc_take_choice(&r->words, "what is added to the value", more, &choice)) {
    return false;
  }
  for (size_t n = 0; n < p->parameters; n++) {
    if (strcmp(p->parameter[n].name, to->name) == 0) {
      return nc_refuse(&r->words, "parameter %s has two records", to->name);
    }
  }
  p->parameters++;
  return true;
}

bool nc_read_servo(nc_reader *r) {
  double *period = &r->program->servo;
  return nc_take_number(&r->words, "servo period", period) &&
         ((*period >= 0 && *period <= 1) ||
          nc_refuse(&r->words, "%.9g s is no period of a servo loop", *period));
}

/* The axis of a letter; -1 after a refusal. */
static int axis_of(nc_reader *r, const char *letter) {
  int axis = letter[1] == '\0' ? nc_axis(letter[0]) : -1;
  if (axis < 0) {
    nc_refuse(&r->words, "axis '%.40s' is none of: %s", letter, "XYZABCUVW");
  }
  return axis;
}

bool nc_read_limits(nc_reader *r) {
  char letter[NC_NAME];
  nc_limits limits;
  if (!nc_take_name(&r->words, "axis of limits", letter) ||
      !nc_take_number(&r->words, "greatest speed", &limits.speed) ||
      !nc_take_number(&r->words, "greatest acceleration", &limits.acceleration)) {
    return false;
  }
  int axis = axis_of(r, letter);
  if (axis < 0) {
    return false;
  }
  r->program->limits[axis] = limits;
  return (limits.speed >= 0 && limits.acceleration >= 0) ||
         nc_refuse(&r->words, "axis %s: a limit is below 0", letter);
}

bool nc_read_joint(nc_reader *r) {
  static const char *const kinds[] = {"linear", "angular", NULL};
  nc_program *p = r->program;
  char letter[NC_NAME];
  long number;
  int angular = 0;
  if (!nc_take_whole(&r->words, "number of a joint", 0, NC_JOINTS_MOST - 1, &number) ||
      !nc_take_name(&r->words, "axis of a joint", letter) ||
      !nc_take_choice(&r->words, "kind of a joint", kinds, &angular)) {
    return false;
  }
  if (number != (long)p->joints) {
    return nc_refuse(&r->words, "joint %ld follows %zu joints; number them from 0, in order",
                     number, p->joints);
  }
  int axis = axis_of(r, letter);
  if (axis < 0) {
    return false;
  }
  nc_joint *to = &p->joint[p->joints];
  *to = (nc_joint){.axis = axis, .angular = angular == 1};
  if (to->angular != (axis >= NC_A && axis <= NC_C)) {
    return nc_refuse(&r->words,
                     "joint %ld is %s, but axis %c is %s; there are no kinematics for it", number,
                     kinds[angular], nc_letter(axis), kinds[1 - angular]);
  }
  if (!nc_take_number(&r->words, "lower limit", &to->least) ||
      !nc_take_number(&r->words, "upper limit", &to->most) ||
      (r->words.rest != NULL &&
       !nc_take_number(&r->words, "greatest acceleration", &to->acceleration))) {
    return false;
  }
  p->joints++;
  if (to->acceleration < 0) {
    return nc_refuse(&r->words, "joint %ld: %.9g is no greatest acceleration", number,
                     to->acceleration);
  }
  return to->least <= to->most ||
         nc_refuse(&r->words, "joint %ld: its lower limit is above its upper limit", number);
}

bool nc_read_tool(nc_reader *r) {
  nc_program *p = r->program;
  long number, pocket;
  nc_tool *grown = list_grow(p->tool, &r->tool_capacity, p->tools, sizeof *grown);
  if (grown == NULL) {
    return nc_no_memory(r);
  }
  p->tool = grown;
  nc_tool *to = &p->tool[p->tools];
  *to = (nc_tool){0};
  if (!nc_take_whole(&r->words, "number of a tool", 0, INT_MAX, &number) ||
      !nc_take_whole(&r->words, "pocket of a tool", -1, INT_MAX, &pocket) ||
      !nc_take_number(&r->words, "diameter of a tool", &to->diameter) ||
      !nc_take_numbers(&r->words, "offset of a tool", NC_AXES, to->offset)) {
    return false;
  }
  to->number = (int)number;
  to->pocket = (int)pocket;
  for (size_t n = 0; n < p->tools; n++) {
    if (p->tool[n].number == to->number) {
      return nc_refuse(&r->words, "tool %ld has two records", number);
    }
  }
  if (p->tools == TOOLS_MOST) {
    return nc_refuse(&r->words, "more than %d tools", TOOLS_MOST);
  }
  if (!nc_take_text(&r->words, &to->comment)) {
    return false;
  }
  p->tools++;
  return true;
}

bool nc_read_start(nc_reader *r) {
  static const char *const kinds[] = {"home", "given", NULL};
  nc_program *p = r->program;
  int given = 0;
  if (r->started) {
    return nc_refuse(&r->words, "a second record `start`");
  }
  if (p->machine_words == 0 || p->joints == 0) {
    return nc_refuse(&r->words, "`start` comes before %s",
                     p->joints == 0 ? "any `joint`" : "`machine`");
  }
  r->started = true;
  if (!nc_take_choice(&r->words, "start", kinds, &given)) {
    return false;
  }
  p->start_given = given == 1;
  return nc_take_numbers(&r->words, "start", NC_AXES, p->start);
}
