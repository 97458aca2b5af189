/* SPDX-License-Identifier: MIT */
/* sepax_guard.c - the guard as a real-time component of LinuxCNC (uspace):
 *   loadrt sepax_guard urdf=/path/machine.urdf joints=x,y,z coordinates=XYZ clearance=2mm ...
 *   addf sepax-guard.check servo-thread      after motion-controller
 * README.md has all parameters, pins and the wiring. rtapi_app_main reads files and takes memory,
 * which LinuxCNC allows there: it runs in rtapi_app's own thread, before any period. */
#include "guard.h"

#include <hal.h>
#include <math.h>
#include <rtapi.h>
#include <rtapi_app.h>
#include <stdlib.h>
#include <string.h>

#define NAME "sepax-guard"

MODULE_LICENSE("Dual MIT/GPL");
MODULE_AUTHOR("the authors of sepax");
MODULE_DESCRIPTION("stops the machine before its bodies come within a clearance");

static char *urdf[GUARD_TOOLS_MOST];
RTAPI_MP_ARRAY_STRING(urdf, GUARD_TOOLS_MOST, "URDF of the machine with each tool");
static char *srdf;
RTAPI_MP_STRING(srdf, "SRDF: pairs that are not compared");
static int tools[GUARD_TOOLS_MOST] = {-1, -1, -1, -1, -1, -1, -1, -1,
                                      -1, -1, -1, -1, -1, -1, -1, -1};
RTAPI_MP_ARRAY_INT(tools, GUARD_TOOLS_MOST, "number of the tool of each URDF");
static char *joints[GUARD_JOINTS_MOST];
RTAPI_MP_ARRAY_STRING(joints, GUARD_JOINTS_MOST, "joint of the URDF of each joint");
static char *coordinates;
RTAPI_MP_STRING(coordinates, "axis of each joint, as of trivkins");
static char *unit;
RTAPI_MP_STRING(unit, "unit of length of the machine, mm or inch");
static char *clearance;
RTAPI_MP_STRING(clearance, "least distance, in the unit");
static char *slow_zone;
RTAPI_MP_STRING(slow_zone, "slower when nearer than the clearance and this");
static char *slow_scale;
RTAPI_MP_STRING(slow_scale, "feed in the slow zone");
static char *brake;
RTAPI_MP_STRING(brake, "share of the acceleration that certainly brakes");
static int reaction = 10;
RTAPI_MP_INT(reaction, "periods from a verdict to braking");
static int work = GUARD_WORK;
RTAPI_MP_INT(work, "units of work of a query");
static int tube_rows = 100000;
RTAPI_MP_INT(tube_rows, "room for the tube of a program; 0: no tube");

/* The pins are in HAL's shared memory. */
typedef struct {
  hal_float_t *position[GUARD_JOINTS_MOST], *velocity[GUARD_JOINTS_MOST];
  hal_float_t *acceleration[GUARD_JOINTS_MOST], *fastest[GUARD_JOINTS_MOST];
  hal_float_t *speed;
  hal_bit_t *coordinated, *homed, *reset;
  hal_s32_t *tool;
  hal_float_t *feed_scale, *least, *most;
  hal_bit_t *feed_inhibit, *jog_stop, *ok, *slow, *stopped, *in_tube, *heartbeat;
  hal_s32_t *state, *reason, *nearest[2];
  hal_u32_t *work, *stops;
} pins;

static pins *pin;
static guard *the_guard;
static guard_settings settings;
static int component = -1;
static int memory = -1; /* of the tube */

static bool complain(const char *what, const char *value) {
  rtapi_print_msg(RTAPI_MSG_ERR, "sepax_guard: %s%s\n", what, value);
  return false;
}

/* ------------------------------------------------------------------ each period */

static void read_pins(guard_input *in, long period) {
  for (size_t n = 0; n < settings.joints; n++) {
    in->position[n] = *pin->position[n];
    in->velocity[n] = *pin->velocity[n];
    in->acceleration[n] = *pin->acceleration[n];
    in->fastest[n] = *pin->fastest[n];
  }
  in->speed = *pin->speed;
  in->period = (double)period * 1e-9;
  in->coordinated = *pin->coordinated;
  in->homed = *pin->homed;
  in->reset = *pin->reset;
  in->tool = *pin->tool;
}

static void check(void *unused, long period) {
  guard_input in = {0};
  guard_output out;
  (void)unused;
  read_pins(&in, period);
  guard_step(the_guard, &in, &out);
  const bool stopped = out.state == GUARD_STOPPED;
  *pin->stops += stopped && !*pin->stopped ? 1 : 0;
  *pin->feed_scale = out.feed_scale;
  *pin->feed_inhibit = out.feed_inhibit;
  *pin->jog_stop = out.jog_stop;
  *pin->ok = !out.feed_inhibit;
  *pin->slow = out.state == GUARD_SLOW;
  *pin->stopped = stopped;
  *pin->in_tube = out.in_tube;
  *pin->state = (hal_s32_t)out.state;
  *pin->reason = (hal_s32_t)out.reason;
  for (int side = 0; side < 2; side++) {
    *pin->nearest[side] = out.nearest[side] == SEPAX_NO_PAIR ? -1 : (hal_s32_t)out.nearest[side];
  }
  *pin->least = out.least;
  *pin->most = out.most;
  *pin->work = out.work > UINT32_MAX ? UINT32_MAX : (hal_u32_t)out.work;
  *pin->heartbeat = !*pin->heartbeat;
}

/* ------------------------------------------------------------------ start */

static bool bit(hal_pin_dir_t way, hal_bit_t **at, const char *name) {
  return hal_pin_bit_newf(way, at, component, NAME ".%s", name) == 0;
}

static bool real(hal_pin_dir_t way, hal_float_t **at, const char *name) {
  return hal_pin_float_newf(way, at, component, NAME ".%s", name) == 0;
}

static bool joint_pin(hal_float_t **at, size_t n, const char *name) {
  return hal_pin_float_newf(HAL_IN, at, component, NAME ".joint.%d.%s", (int)n, name) == 0;
}

static bool integer(hal_pin_dir_t way, hal_s32_t **at, const char *name) {
  return hal_pin_s32_newf(way, at, component, NAME ".%s", name) == 0;
}

static bool inputs_made(void) {
  for (size_t n = 0; n < settings.joints; n++) {
    if (!joint_pin(&pin->position[n], n, "pos-cmd") ||
        !joint_pin(&pin->velocity[n], n, "vel-cmd") ||
        !joint_pin(&pin->acceleration[n], n, "max-accel") ||
        !joint_pin(&pin->fastest[n], n, "max-vel")) {
      return false;
    }
  }
  return real(HAL_IN, &pin->speed, "current-vel") && bit(HAL_IN, &pin->coordinated, "coord-mode") &&
         bit(HAL_IN, &pin->homed, "homed") && bit(HAL_IN, &pin->reset, "reset") &&
         integer(HAL_IN, &pin->tool, "tool-number");
}

static bool outputs_made(void) {
  return real(HAL_OUT, &pin->feed_scale, "feed-scale") &&
         bit(HAL_OUT, &pin->feed_inhibit, "feed-inhibit") &&
         bit(HAL_OUT, &pin->jog_stop, "jog-stop") && bit(HAL_OUT, &pin->ok, "ok") &&
         bit(HAL_OUT, &pin->slow, "slow") && bit(HAL_OUT, &pin->stopped, "stopped") &&
         bit(HAL_OUT, &pin->in_tube, "in-tube") && bit(HAL_OUT, &pin->heartbeat, "heartbeat") &&
         integer(HAL_OUT, &pin->state, "state") && integer(HAL_OUT, &pin->reason, "reason") &&
         integer(HAL_OUT, &pin->nearest[0], "nearest-a") &&
         integer(HAL_OUT, &pin->nearest[1], "nearest-b") && real(HAL_OUT, &pin->least, "least") &&
         real(HAL_OUT, &pin->most, "most") &&
         hal_pin_u32_newf(HAL_OUT, &pin->work, component, NAME ".work") == 0 &&
         hal_pin_u32_newf(HAL_OUT, &pin->stops, component, NAME ".stops") == 0;
}

/* Until the first period the machine stands. */
static void stand(void) {
  *pin->feed_inhibit = true;
  *pin->jog_stop = true;
  *pin->state = GUARD_BLIND;
  *pin->reason = GUARD_NOT_HOMED;
  *pin->nearest[0] = *pin->nearest[1] = -1;
}

static bool number(const char *name, const char *text, double otherwise, double *value) {
  char *end = NULL;
  *value = otherwise;
  if (text == NULL) {
    return isfinite(otherwise) || complain("this parameter is needed: ", name);
  }
  *value = strtod(text, &end);
  return (end != text && *end == 0 && isfinite(*value)) ||
         complain("not a number, which has no unit: ", name);
}

static bool unit_read(void) {
  settings.unit = unit != NULL && strcmp(unit, "inch") == 0 ? 0.0254 : 0.001;
  return unit == NULL || strcmp(unit, "inch") == 0 || strcmp(unit, "mm") == 0 ||
         complain("unit is mm or inch, not ", unit);
}

static bool settings_read(void) {
  if (!unit_read() || !number("clearance", clearance, NAN, &settings.clearance) ||
      !number("slow_zone", slow_zone, 0, &settings.slow_zone) ||
      !number("slow_scale", slow_scale, 0.2, &settings.slow_scale) ||
      !number("brake", brake, 0.2, &settings.brake)) {
    return false;
  }
  settings.clearance *= settings.unit;
  settings.slow_zone *= settings.unit;
  settings.reaction = reaction;
  settings.work = work > 0 ? (uint64_t)work : 0;
  if (tube_rows < 0 || tube_rows > TUBE_ROWS_MOST) {
    return complain("tube_rows is 0 ... 10000000", "");
  }
  while (settings.joints < GUARD_JOINTS_MOST && joints[settings.joints] != NULL) {
    settings.name[settings.joints] = joints[settings.joints];
    settings.joints++;
  }
  if (coordinates == NULL || strlen(coordinates) != settings.joints) {
    return complain("coordinates needs one letter for each of joints", "");
  }
  memcpy(settings.axis, coordinates, settings.joints);
  return true;
}

static bool guard_made(void) {
  guard_tool tool[GUARD_TOOLS_MOST];
  char text[GUARD_TEXT] = "";
  size_t count = 0;
  while (count < GUARD_TOOLS_MOST && urdf[count] != NULL) {
    tool[count] = (guard_tool){.tool = tools[count], .urdf = urdf[count], .srdf = srdf};
    if (count > 0 && (tools[count] < 0 || tools[0] < 0)) {
      return complain("of several URDFs each needs the number of its tool in ", "tools");
    }
    count++;
  }
  the_guard = guard_new(&settings, tool, count, text);
  return the_guard != NULL || complain(text, "");
}

/* The memory in which `sepax_guard_tube` puts a tube. */
static bool tube_made(void) {
  void *at = NULL;
  if (tube_rows == 0) {
    return true;
  }
  const size_t bytes = tube_size(settings.joints, (uint64_t)tube_rows);
  memory = rtapi_shmem_new(TUBE_KEY, component, bytes);
  if (memory < 0 || rtapi_shmem_getptr(memory, &at) < 0) {
    return complain("no memory for tube_rows", "");
  }
  memset(at, 0, bytes); /* also takes its pages, before any period */
  guard_begin_tube(the_guard, at, (uint64_t)tube_rows);
  guard_use_tube(the_guard, at);
  return true;
}

void rtapi_app_exit(void) {
  if (memory >= 0) {
    rtapi_shmem_delete(memory, component);
  }
  memory = -1;
  if (component >= 0) {
    hal_exit(component);
  }
  component = -1;
  guard_free(the_guard);
  the_guard = NULL;
}

int rtapi_app_main(void) {
  settings = (guard_settings){0};
  if (!settings_read() || !guard_made()) {
    return -1;
  }
  component = hal_init("sepax_guard");
  if (component >= 0 && (pin = hal_malloc(sizeof *pin)) != NULL && inputs_made() &&
      outputs_made() && tube_made() &&
      hal_export_funct(NAME ".check", check, NULL, 1, 0, component) == 0) {
    stand();
    hal_ready(component);
    return 0;
  }
  complain("HAL refused a pin or the function", "");
  rtapi_app_exit();
  return -1;
}
