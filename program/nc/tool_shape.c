/* SPDX-License-Identifier: MIT */
/* tool_shape.c - flutes, shank and holder of a tool from the numbers of its row. */
#include "nc/tool_rows.h"
#include "util/error.h"
#include "util/plain_numbers.h"

#include <math.h>
#include <string.h>

/* Lengths that differ by less are equal, because a unit was converted: mm. */
static const double same = 1e-6;

static const double degree = 0x1.921fb54442d18p1 / 180;

const char *nc_tool_part_name(nc_tool_part part) {
  static const char *const names[NC_TOOL_PARTS] = {"flutes", "shank", "holder"};
  return names[part];
}

bool nc_tool_refuse(const nc_tool_row *row, sepax_error *error, const char *format, ...) {
  char detail[260];
  char tool[32] = "default";
  va_list args;
  va_start(args, format);
  vsnprintf(detail, sizeof detail, format, args);
  va_end(args);
  if (row->number >= 0) {
    snprintf(tool, sizeof tool, "tool %d", row->number);
  }
  return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.200s:%zu: %s: %s", row->path, row->line, tool,
                    detail);
}

void nc_turned_tool_free(nc_turned_tool *tool) {
  sepax_release(tool->name);
  sepax_release(tool->refusal);
  for (int n = 0; n < NC_TOOL_PARTS; n++) {
    sepax_release(tool->part[n].point);
  }
  *tool = (nc_turned_tool){0};
}

/* ----------------------------------------------------------------------- rules */

typedef enum { NONE, MAY, MUST, MUST_OR_0 } demand;

enum { RULES = TOOL_FLUTE + 1 };

/* What each kind says about its flutes: diameter, corner radius, tip angle, taper angle, flute
 * length. */
static const demand rules[NC_TOOL_KINDS][RULES] = {
    [NC_TOOL_FLAT] = {MUST, NONE, NONE, NONE, MUST},
    [NC_TOOL_BALL] = {MUST, NONE, NONE, NONE, MUST},
    [NC_TOOL_BULL] = {MUST, MUST, NONE, NONE, MUST},
    [NC_TOOL_DRILL] = {MUST, NONE, MUST, NONE, MUST},
    [NC_TOOL_TAPER] = {MUST_OR_0, MAY, NONE, MUST, MUST},
    [NC_TOOL_FACE] = {MUST, MAY, NONE, NONE, MUST},
    [NC_TOOL_PROBE] = {MUST, NONE, NONE, NONE, NONE},
    [NC_TOOL_FORM] = {MAY, NONE, NONE, NONE, NONE}};

/* A corner radius of 0 is none. */
static bool is_given(const nc_tool_row *row, tool_number n) {
  return !isnan(row->value[n]) && (n != TOOL_CORNER || row->value[n] > 0);
}

static bool check_rule(const nc_tool_row *row, tool_number n, sepax_error *error) {
  demand rule = rules[row->kind][n];
  const char *kind = nc_tool_kind_name(row->kind);
  const char *name = nc_tool_number_name(n);
  bool given = is_given(row, n);
  if (rule == NONE && given) {
    return nc_tool_refuse(row, error, "kind %s has no %s; leave the cell empty, or change the kind",
                          kind, name);
  }
  if ((rule == MUST || rule == MUST_OR_0) && !given) {
    return nc_tool_refuse(row, error, "kind %s needs '%s'; give it", kind, name);
  }
  return rule == MUST_OR_0 || !given || row->value[n] > 0 ||
         nc_tool_refuse(row, error, "'%s' is 0; give a number above 0, or leave the cell empty",
                        name);
}

static bool check_rules(const nc_tool_row *row, sepax_error *error) {
  bool form = row->kind == NC_TOOL_FORM;
  for (int n = 0; n < TOOL_NUMBERS; n++) {
    bool ruled = n < RULES;
    if (ruled ? !check_rule(row, (tool_number)n, error)
              : row->value[n] <= 0 &&
                    !nc_tool_refuse(row, error,
                                    "'%s' is 0; give a number above 0, or leave the cell empty",
                                    nc_tool_number_name((tool_number)n))) {
      return false;
    }
  }
  if (form != (row->steps[NC_FLUTES].text != NULL)) {
    return nc_tool_refuse(row, error,
                          form ? "kind form needs 'flutes'; give its steps"
                               : "'flutes' is for kind form; leave the cell empty, or change the "
                                 "kind");
  }
  double tip = row->value[TOOL_TIP];
  double taper = row->value[TOOL_TAPER];
  return (!(tip > 180) && !(taper >= 90)) ||
         nc_tool_refuse(row, error, "%s; give %s",
                        tip > 180 ? "a tip angle above 180 degrees"
                                  : "a taper angle of 90 degrees or more",
                        tip > 180 ? "the whole angle of the tip" : "the angle to the axis");
}

/* ---------------------------------------------------------------------- flutes */

/* The tip with its rounding, up to where the cylinder or the cone begins; *z and *r are that
 * point. */
static bool add_tip(turned_profile *p, const nc_tool_row *row, double *z, double *r,
                    sepax_error *error) {
  double radius = row->value[TOOL_DIAMETER] / 2;
  double corner = row->kind == NC_TOOL_BALL    ? radius
                  : is_given(row, TOOL_CORNER) ? row->value[TOOL_CORNER]
                                               : 0;
  double taper = row->kind == NC_TOOL_TAPER ? row->value[TOOL_TAPER] * degree : 0;
  if (corner > radius) {
    return nc_tool_refuse(row, error,
                          "a corner radius of %g mm is more than half of the diameter of %g mm; "
                          "mend one of them",
                          corner, 2 * radius);
  }
  *z = taper > 0 ? corner - corner * sin(taper) : corner;
  *r = taper > 0 ? (radius - corner) + corner * cos(taper) : radius;
  if (row->kind == NC_TOOL_DRILL) {
    *z = row->value[TOOL_TIP] < 180 ? radius / tan(row->value[TOOL_TIP] / 2 * degree) : 0;
    return nc_tool_add_point(p, row, 0, 0, 0, error) &&
           nc_tool_add_point(p, row, *z, radius, 0, error);
  }
  return nc_tool_add_point(p, row, 0, radius - corner, 0, error) &&
         (corner == 0 || nc_tool_add_point(p, row, *z, *r, corner, error));
}

static bool add_flutes(nc_turned_tool *tool, const nc_tool_row *row, sepax_error *error) {
  turned_profile *p = &tool->part[NC_FLUTES];
  double top = row->value[TOOL_FLUTE];
  double z = 0;
  double r = 0;
  if (!add_tip(p, row, &z, &r, error)) {
    return false;
  }
  if (top < z) {
    return nc_tool_refuse(row, error,
                          "a flute length of %g mm ends within the tip, which is %g mm high; mend "
                          "it",
                          top, z);
  }
  double wide = row->kind == NC_TOOL_TAPER ? r + (top - z) * tan(row->value[TOOL_TAPER] * degree)
                                           : row->value[TOOL_DIAMETER] / 2;
  return nc_tool_add_point(p, row, top, wide, 0, error);
}

static bool add_ball(nc_turned_tool *tool, const nc_tool_row *row, sepax_error *error) {
  turned_profile *p = &tool->part[NC_FLUTES];
  double radius = row->value[TOOL_DIAMETER] / 2;
  return nc_tool_add_point(p, row, 0, 0, 0, error) &&
         nc_tool_add_point(p, row, radius, radius, radius, error) &&
         nc_tool_add_point(p, row, 2 * radius, 0, radius, error);
}

static bool add_form(nc_turned_tool *tool, const nc_tool_row *row, sepax_error *error) {
  double z = 0;
  double widest = 0;
  if (!nc_tool_add_steps(&tool->part[NC_FLUTES], row, NC_FLUTES, &z, error)) {
    return false;
  }
  for (size_t n = 0; n < tool->part[NC_FLUTES].points; n++) {
    widest = fmax(widest, 2 * tool->part[NC_FLUTES].point[n].r);
  }
  if (is_given(row, TOOL_DIAMETER) && fabs(row->value[TOOL_DIAMETER] - widest) > same) {
    return nc_tool_refuse(row, error,
                          "a diameter of %g mm, but the greatest of 'flutes' is %g mm; mend one of "
                          "them",
                          row->value[TOOL_DIAMETER], widest);
  }
  tool->diameter = widest;
  return true;
}

/* ------------------------------------------------------------- shank and holder */

static double top_of(const turned_profile *p) { return p->point[p->points - 1].z; }

/* Steps from z up; *out is the stick-out, NAN if the row has none. */
static bool add_stepped_shank(nc_turned_tool *tool, const nc_tool_row *row, double z, double *out,
                              sepax_error *error) {
  if (is_given(row, TOOL_SHANK) || is_given(row, TOOL_NECK) || is_given(row, TOOL_USABLE)) {
    return nc_tool_refuse(row, error,
                          "'shank' has steps; leave shank diameter, neck diameter and usable "
                          "length empty");
  }
  if (!nc_tool_add_steps(&tool->part[NC_SHANK], row, NC_SHANK, &z, error)) {
    return false;
  }
  if (!isnan(*out) && fabs(*out - z) > same) {
    return nc_tool_refuse(row, error,
                          "the steps of 'shank' end %g mm above the tip, but the stick-out is %g "
                          "mm; mend one of them",
                          z, *out);
  }
  *out = z;
  return true;
}

/* A neck up to the usable length, then the shank up to the holder. */
static bool add_shank(nc_turned_tool *tool, const nc_tool_row *row, double z, double out,
                      sepax_error *error) {
  turned_profile *p = &tool->part[NC_SHANK];
  double shank = row->value[TOOL_SHANK] / 2;
  double neck = row->value[TOOL_NECK] / 2;
  double usable = row->value[TOOL_USABLE];
  if (is_given(row, TOOL_NECK) != is_given(row, TOOL_USABLE)) {
    return nc_tool_refuse(row, error,
                          "a neck needs 'neck diameter' and 'usable length'; give both");
  }
  if (usable <= z || usable > out) {
    return nc_tool_refuse(
        row, error,
        "a usable length of %g mm is not above the flutes, which end at %g mm, and "
        "up to the stick-out of %g mm; mend it",
        usable, z, out);
  }
  if (is_given(row, TOOL_NECK) && (!nc_tool_add_point(p, row, z, neck, 0, error) ||
                                   !nc_tool_add_point(p, row, usable, neck, 0, error))) {
    return false;
  }
  double from = is_given(row, TOOL_NECK) ? usable : z;
  return from >= out - same || (nc_tool_add_point(p, row, from, shank, 0, error) &&
                                nc_tool_add_point(p, row, out, shank, 0, error));
}

/* The shank that the numbers give, if they give one. */
static bool add_plain_shank(nc_turned_tool *tool, const nc_tool_row *row, double z, double out,
                            sepax_error *error) {
  bool above = out > z + same;
  if (is_given(row, TOOL_SHANK)) {
    return isnan(out) ? nc_tool_refuse(row, error, "a shank needs 'stick-out'; give it")
                      : add_shank(tool, row, z, out, error);
  }
  if (is_given(row, TOOL_NECK) || is_given(row, TOOL_USABLE)) {
    return nc_tool_refuse(row, error, "a neck needs 'shank diameter'; give it");
  }
  return !above || nc_tool_refuse(row, error,
                                  "the flutes end at %g mm and the stick-out is %g mm; give 'shank "
                                  "diameter'",
                                  z, out);
}

static bool add_upper_parts(nc_turned_tool *tool, const nc_tool_row *row, sepax_error *error) {
  double top = top_of(&tool->part[NC_FLUTES]);
  double z = row->kind == NC_TOOL_PROBE ? top / 2 : top; /* a stem begins within the ball */
  double out = row->value[TOOL_OUT];
  if (out < top - same) {
    return nc_tool_refuse(row, error,
                          "a stick-out of %g mm is less than the %g mm of the flutes; mend one of "
                          "them",
                          out, top);
  }
  bool ok = row->steps[NC_SHANK].text != NULL ? add_stepped_shank(tool, row, z, &out, error)
                                              : add_plain_shank(tool, row, z, out, error);
  if (!ok || row->steps[NC_HOLDER].text == NULL) {
    return ok;
  }
  return isnan(out) ? nc_tool_refuse(row, error, "a holder needs 'stick-out'; give it")
                    : nc_tool_add_steps(&tool->part[NC_HOLDER], row, NC_HOLDER, &out, error);
}

bool nc_tool_check_length(const nc_turned_tool *tool, const nc_tool_row *row, sepax_error *error) {
  const turned_profile *holder = &tool->part[NC_HOLDER];
  const turned_profile *below = &tool->part[tool->part[NC_SHANK].points > 0 ? NC_SHANK : NC_FLUTES];
  if (tool->length < top_of(below) - same) {
    return nc_tool_refuse(
        row, error,
        "a length of %g mm, but the tool is %g mm long below its holder; mend one "
        "of them",
        tool->length, top_of(below));
  }
  return holder->points == 0 || !(tool->length > top_of(holder) + same) ||
         nc_tool_refuse(row, error,
                        "its holder ends %g mm above the tip, below the nose of the spindle at the "
                        "length of %g mm; add a step to 'holder'",
                        top_of(holder), tool->length);
}

static bool add_parts(nc_turned_tool *tool, const nc_tool_row *row, sepax_error *error) {
  bool ok = row->kind == NC_TOOL_FORM    ? add_form(tool, row, error)
            : row->kind == NC_TOOL_PROBE ? add_ball(tool, row, error)
                                         : add_flutes(tool, row, error);
  sepax_error why;
  if (ok && !sepax__turned_check(&tool->part[NC_FLUTES], &why)) {
    return nc_tool_refuse(row, error, "its flutes, from the tip: %.150s", why.text);
  }
  return ok && add_upper_parts(tool, row, error) && nc_tool_check_length(tool, row, error);
}

bool nc_tool_shape(nc_turned_tool *tool, const nc_tool_row *row, sepax_error *error) {
  *tool = (nc_turned_tool){.number = row->number,
                           .line = row->line,
                           .kind = row->kind,
                           .diameter = row->value[TOOL_DIAMETER],
                           .length = row->value[TOOL_LENGTH]};
  plain_numbers plain = plain_numbers_begin();
  bool ok = check_rules(row, error) && add_parts(tool, row, error);
  plain_numbers_end(plain);
  if (!ok) {
    nc_turned_tool_free(tool);
  }
  return ok;
}
