/* SPDX-License-Identifier: MIT */
/* kinematics.c - from positions of the axes to positions of the joints, and back. */
#include "nc/kinematics.h"
#include "util/error.h"

#include <string.h>

static const char *const modules[] = {"trivkins", "xyzac-trt-kins", "xyzbc-trt-kins", "5axiskins",
                                      NULL};
static const char *const coordinates[] = {"XYZABCUVW", "XYZAC", "XYZBC", "XYZBCW"};

/* pi / 180 to the nearest double. */
#define DEGREE 0x1.1df46a2529d39p-6

nc_interval nc_kinematics_metric(bool angular, nc_interval value) {
  return angular ? nc_times(value, nc_around(DEGREE))
                 : (nc_interval){nc_below(value.lo / 1000), nc_above(value.hi / 1000)};
}

/* ------------------------------------------------------------------------ of a program */

/* The parameters' names, and which kinematics have them. xyzac-trt-kins has x-offset, and
 * xyzbc-trt-kins y-offset, but neither uses it. */
static const struct {
  const char *name;
  bool trt;
} parameters[NC_VALUES] = {
    {"x-rot-point", true}, {"y-rot-point", true},   {"z-rot-point", true},
    {"x-offset", true},    {"y-offset", true},      {"z-offset", true},
    {"tool-offset", true}, {"pivot-length", false}, {"conventional-directions", true}};

static bool take_parameter(nc_kinematics *k, const nc_parameter *p, const char *name,
                           sepax_error *error) {
  size_t n = 0;
  while (n < NC_VALUES && strcmp(parameters[n].name, p->name) != 0) {
    n++;
  }
  if (n == NC_VALUES || k->module == NC_TRIVIAL || parameters[n].trt != (k->module != NC_BRIDGE)) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.180s: %s has no parameter '%.60s' known here",
                      name, modules[k->module], p->name);
  }
  k->base[n] = p->value;
  k->follows[n] = p->follows;
  return n != NC_CONVENTIONAL || (p->value == 0 && !p->follows) ||
         sepax_fail(error, SEPAX_ERROR_FORMAT,
                    "%.180s: conventional-directions is %g; kinematics are known for 0 only", name,
                    p->value);
}

/* `text` lists the axes of the joints in order, in either case, and perhaps more. */
static bool coordinates_fit(const nc_kinematics *k, const char *text) {
  for (size_t n = 0; n < k->joints; n++) {
    char letter = text[n] >= 'a' && text[n] <= 'z' ? (char)(text[n] - 'a' + 'A') : text[n];
    if (nc_axis(letter) != k->joint_axis[n]) {
      return false;
    }
  }
  return true;
}

static bool take_word(nc_kinematics *k, const char *word, const char *name, sepax_error *error) {
  if (strncmp(word, "coordinates=", 12) == 0) {
    return coordinates_fit(k, word + 12) ||
           sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "%.180s: %.60s differs from the axes of the joints; give each joint the axis "
                      "that the kinematics give it",
                      name, word);
  }
  if (k->module != NC_TRIVIAL && strcmp(word, "sparm=identityfirst") == 0) {
    k->identity_first = true;
    return true;
  }
  return (k->module == NC_TRIVIAL && strncmp(word, "kinstype=", 9) == 0) ||
         sepax_fail(error, SEPAX_ERROR_FORMAT, "%.180s: %s has no parameter '%.60s' known here",
                    name, modules[k->module], word);
}

/* Each axis that the formulas read or write has a joint. */
static bool has_axes(const nc_kinematics *k, const char *name, sepax_error *error) {
  for (const char *letter = k->module == NC_TRIVIAL ? "" : coordinates[k->module]; *letter != '\0';
       letter++) {
    size_t n = 0;
    while (n < k->joints && k->joint_axis[n] != nc_axis(*letter)) {
      n++;
    }
    if (n == k->joints && *letter != 'W') {
      return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.180s: %s needs a joint for axis %c", name,
                        modules[k->module], *letter);
    }
  }
  return true;
}

bool nc_kinematics_of(nc_kinematics *k, const nc_program *program, const char *name,
                      sepax_error *error) {
  *k = (nc_kinematics){.joints = program->joints, .base[NC_PIVOT] = 250};
  int module = 0;
  while (modules[module] != NULL && strcmp(modules[module], program->machine[0]) != 0) {
    module++;
  }
  if (modules[module] == NULL) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "%.180s: kinematics '%.60s' are none of: trivkins, xyzac-trt-kins, "
                      "xyzbc-trt-kins, 5axiskins",
                      name, program->machine[0]);
  }
  k->module = (nc_module)module;
  for (size_t n = 0; n < k->joints; n++) {
    k->joint_axis[n] = program->joint[n].axis;
  }
  for (size_t n = 1; n < program->machine_words; n++) {
    if (!take_word(k, program->machine[n], name, error)) {
      return false;
    }
  }
  for (size_t n = 0; n < program->parameters; n++) {
    if (!take_parameter(k, &program->parameter[n], name, error)) {
      return false;
    }
  }
  nc_kinematics_length(k, 0);
  return has_axes(k, name, error) && nc_kinematics_switch(k, 0);
}

bool nc_kinematics_switch(nc_kinematics *k, int type) {
  if (type < 0 || type > (k->module == NC_TRIVIAL ? 0 : 1)) {
    return false;
  }
  k->identity = k->module == NC_TRIVIAL || (type == 0) == k->identity_first;
  return true;
}

bool nc_kinematics_length(nc_kinematics *k, double z) {
  bool changes = false;
  for (int n = 0; n < NC_VALUES; n++) {
    double value = k->base[n] + (k->follows[n] ? z : 0);
    changes = changes || value != k->value[n];
    k->value[n] = value;
  }
  return changes;
}

/* ------------------------------------------------------------------------- to joints */

/* Turn the pair (a, b) by an angle from a to b. */
static void turn(nc_jet angle, nc_jet *a, nc_jet *b) {
  nc_jet s, c, first = *a;
  nc_jet_circle(angle, &s, &c);
  *a = nc_jet_subtract(nc_jet_times(c, first), nc_jet_times(s, *b));
  *b = nc_jet_add(nc_jet_times(s, first), nc_jet_times(c, *b));
}

static nc_jet radians(nc_jet degrees) { return nc_jet_scale(degrees, nc_around(DEGREE)); }

static nc_jet plus(nc_jet a, nc_interval b) {
  a.v = nc_add(a.v, b);
  return a;
}

static void trt_joints(const nc_kinematics *k, const nc_jet axis[NC_AXES], nc_jet p[3]) {
  nc_interval offset[3];
  for (int i = 0; i < 3; i++) {
    bool used = i == 2 || i == (k->module == NC_XYZAC ? 1 : 0);
    offset[i] = nc_point(used ? k->value[NC_OFFSET + i] : 0);
    p[i] = plus(axis[i], nc_point(-k->value[NC_POINT + i]));
  }
  offset[2] = nc_add(offset[2], nc_point(k->value[NC_TOOL_OFFSET]));
  turn(radians(axis[NC_C]), &p[0], &p[1]);
  for (int i = 0; i < 3; i++) {
    p[i] = plus(p[i], nc_minus(offset[i]));
  }
  if (k->module == NC_XYZAC) {
    turn(radians(axis[NC_A]), &p[1], &p[2]);
  } else {
    turn(radians(axis[NC_B]), &p[2], &p[0]);
  }
  for (int i = 0; i < 3; i++) {
    p[i] = plus(p[i], nc_add(offset[i], nc_point(k->value[NC_POINT + i])));
  }
}

static void bridge_joints(const nc_kinematics *k, const nc_jet axis[NC_AXES], nc_jet p[3]) {
  nc_jet sine_b, cosine_b, sine_c, cosine_c,
      length = plus(axis[NC_W], nc_point(k->value[NC_PIVOT]));
  nc_jet_circle(radians(axis[NC_B]), &sine_b, &cosine_b);
  nc_jet_circle(radians(axis[NC_C]), &sine_c, &cosine_c);
  nc_jet across = nc_jet_times(length, sine_b);
  p[0] = nc_jet_subtract(axis[0], nc_jet_times(across, cosine_c));
  p[1] = nc_jet_subtract(axis[1], nc_jet_times(across, sine_c));
  p[2] = plus(nc_jet_add(axis[2], nc_jet_times(length, cosine_b)), nc_point(-k->value[NC_PIVOT]));
}

void nc_kinematics_joints(const nc_kinematics *k, const nc_jet axis[NC_AXES],
                          nc_jet joint[NC_JOINTS_MOST]) {
  nc_jet p[3] = {axis[0], axis[1], axis[2]};
  if (!k->identity) {
    (k->module == NC_BRIDGE ? bridge_joints : trt_joints)(k, axis, p);
  }
  for (size_t n = 0; n < k->joints; n++) {
    int from = k->joint_axis[n];
    bool angular = from >= NC_A && from <= NC_C;
    nc_jet value = from <= NC_Z ? p[from] : axis[from];
    joint[n] =
        (nc_jet){nc_kinematics_metric(angular, value.v), nc_kinematics_metric(angular, value.d),
                 nc_kinematics_metric(angular, value.dd)};
  }
}
