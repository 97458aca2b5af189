/* SPDX-License-Identifier: MIT */
/* streams.h - streams of canonical motion as text in memory, and an independent reckoning of joints
 * and ways in numbers with 64 bits of mantissa. */
#ifndef TB_UNIT_NC_STREAMS_H
#define TB_UNIT_NC_STREAMS_H

#include "harness.h"
#include "nc/nc.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef long double wide;

/* A stream that grows; it must not be moved. */
typedef struct {
  char *at;
  size_t size;
  FILE *out;
} stream;

static inline void text_begin(stream *t) {
  t->out = open_memstream(&t->at, &t->size);
  assert_non_null(t->out);
}

/* Read what was put; the text is freed. */
static inline bool text_read(stream *t, nc_motion *m, const nc_rules *rules) {
  assert_int_equal(fclose(t->out), 0);
  FILE *in = fmemopen(t->at, t->size, "r");
  assert_non_null(in);
  bool ok = nc_motion_read(m, in, "stream", rules, &fault);
  fclose(in);
  free(t->at);
  return ok;
}

static inline void put_axes(stream *t, const double axis[NC_AXES]) {
  for (int i = 0; i < NC_AXES; i++) {
    fprintf(t->out, " %.17g", axis[i]);
  }
}

static inline void put_move(stream *t, const char *kind, int line, const double axis[NC_AXES]) {
  fprintf(t->out, "move %s 0 %d", kind, line);
  put_axes(t, axis);
  fprintf(t->out, "\n");
}

static inline void put_arc(stream *t, int line, const double axis[NC_AXES], const double centre[3],
                           const double normal[3], int turns) {
  fprintf(t->out, "arc feed 0 %d", line);
  put_axes(t, axis);
  fprintf(t->out, " %.17g %.17g %.17g %.17g %.17g %.17g %d\n", centre[0], centre[1], centre[2],
          normal[0], normal[1], normal[2], turns);
}

/* The head of a stream: kinematics, joints for the letters with limits of +-most, start. */
static inline void put_head(stream *t, const char *machine, const char *parameters,
                            const char *letters, double most, const double start[NC_AXES]) {
  fprintf(t->out, "sepax-nc 1\nfile 0 part.ngc\nmachine %s\n%s", machine, parameters);
  for (size_t n = 0; letters[n] != '\0'; n++) {
    bool angular = strchr("ABC", letters[n]) != NULL;
    fprintf(t->out, "joint %zu %c %s %.17g %.17g\n", n, letters[n], angular ? "angular" : "linear",
            -most, most);
  }
  fprintf(t->out, "start given");
  put_axes(t, start);
  fprintf(t->out, "\n");
}

/* ------------------------------------------------------------------- in wide numbers */

/* Parameters of the kinematics, in mm. */
typedef struct {
  char module; /* 'I' identity, 'A' xyzac, 'B' xyzbc, 'M' the bridge mill */
  double point[3], offset[3], tool, pivot;
} mill;

static inline wide wide_radians(wide degrees) { return degrees * acosl(-1) / 180; }

static inline void rotate(wide v[3], int about, wide degrees) {
  wide s = sinl(wide_radians(degrees)), c = cosl(wide_radians(degrees));
  int j = (about + 1) % 3, k = (about + 2) % 3;
  wide a = c * v[j] - s * v[k], b = s * v[j] + c * v[k];
  v[j] = a;
  v[k] = b;
}

/* X, Y, Z of the joints in mm, from axes in mm and degrees. */
static inline void wide_joints(const mill *m, const wide axis[NC_AXES], wide joint[3]) {
  int tilt = m->module == 'A' ? 0 : 1;
  const wide d[3] = {tilt == 1 ? m->offset[0] : 0, tilt == 0 ? m->offset[1] : 0,
                     (wide)m->offset[2] + m->tool};
  for (int i = 0; i < 3; i++) {
    joint[i] = axis[i];
  }
  if (m->module == 'M') {
    wide tool[3] = {0, 0, -(m->pivot + axis[NC_W])};
    /* The tool hangs from the pivot and is turned by -B and C. */
    rotate(tool, 1, -axis[NC_B]);
    rotate(tool, 2, axis[NC_C]);
    for (int i = 0; i < 3; i++) {
      joint[i] -= tool[i] + (i == 2 ? m->pivot : 0);
    }
  } else if (m->module != 'I') {
    for (int i = 0; i < 3; i++) {
      joint[i] -= m->point[i];
    }
    rotate(joint, 2, axis[NC_C]);
    for (int i = 0; i < 3; i++) {
      joint[i] -= d[i];
    }
    rotate(joint, tilt, axis[tilt == 0 ? NC_A : NC_B]);
    for (int i = 0; i < 3; i++) {
      joint[i] += d[i] + m->point[i];
    }
  }
}

/* Of all joints by their letters, in m and rad. */
static inline void wide_metric(const mill *m, const char *letters, const wide axis[NC_AXES],
                               wide *joint) {
  wide space[3];
  wide_joints(m, axis, space);
  for (size_t n = 0; letters[n] != '\0'; n++) {
    int i = nc_axis(letters[n]);
    joint[n] = i <= NC_Z ? space[i] / 1000 : i <= NC_C ? wide_radians(axis[i]) : axis[i] / 1000;
  }
}

/* A motion: straight, or an arc. */
typedef struct {
  double from[NC_AXES], to[NC_AXES];
  bool arc;
  double centre[3], normal[3];
  int turns;
} motion;

static inline wide wide_dot(const wide *a, const wide *b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The length up to radius w of a spiral whose radius grows with the angle, by its integral. */
static inline wide spiral(wide w, wide angle, wide c) {
  wide root = sqrtl(angle * angle * w * w + c * c);
  return w / 2 * root + c * c / (2 * angle) * asinhl(angle * w / c);
}

static inline void wide_arc(const motion *m, wide t, wide axis[NC_AXES]) {
  wide n[3], u[3], e[3], v[3], size = 0;
  for (int i = 0; i < 3; i++) {
    size += (wide)m->normal[i] * m->normal[i];
  }
  for (int i = 0; i < 3; i++) {
    n[i] = m->normal[i] / sqrtl(size);
    u[i] = (wide)m->from[i] - m->centre[i];
    e[i] = (wide)m->to[i] - m->centre[i];
  }
  wide up = wide_dot(u, n), rise = wide_dot(e, n) - up;
  for (int i = 0; i < 3; i++) {
    u[i] -= up * n[i];
    e[i] -= (up + rise) * n[i];
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    v[i] = n[j] * u[k] - n[k] * u[j];
  }
  wide r0 = sqrtl(wide_dot(u, u)), r1 = sqrtl(wide_dot(e, e));
  wide angle = atan2l(wide_dot(e, v), wide_dot(e, u));
  angle += (angle < 1e-6L ? 2 * acosl(-1) : 0) + 2 * acosl(-1) * m->turns;
  wide by = r1 - r0, r = r0 + by * t;
  for (int i = 0; i < 3; i++) {
    axis[i] = m->centre[i] + (up + rise * t) * n[i] +
              r / r0 * (cosl(angle * t) * u[i] + sinl(angle * t) * v[i]);
  }
  wide share = t;
  if (fabsl(by) > 1e-9L) {
    wide c = sqrtl(by * by + rise * rise);
    share = (spiral(r, angle, c) - spiral(r0, angle, c)) /
            (spiral(r1, angle, c) - spiral(r0, angle, c));
  }
  for (int i = 3; i < NC_AXES; i++) {
    axis[i] = m->from[i] + ((wide)m->to[i] - m->from[i]) * share;
  }
}

static inline void wide_way(const motion *m, wide t, wide axis[NC_AXES]) {
  if (m->arc) {
    wide_arc(m, t, axis);
    return;
  }
  for (int i = 0; i < NC_AXES; i++) {
    axis[i] = m->from[i] + ((wide)m->to[i] - m->from[i]) * t;
  }
}

#endif
