/* SPDX-License-Identifier: MIT */
/* kinematics.c - joints of the known kinematics: against positions that LinuxCNC's simulator took,
 * and back to the axes. */
#include "nc/kinematics.h"
#include "streams.h"

typedef struct {
  double axis[NC_AXES];
  double joint[7];
} sample;

/* Taken from the running simulator of LinuxCNC 2.9, by the project's tb/nc/simulator. */
static const sample xyzac[] = {
    {{10, 20, -5, -20, 0, 30}, {-1.9958348754011468, 12.549951340779181, -4.527270287337302}},
    {{-12.5, 7.25, 3.125, 33.3, 0, -77.7},
     {9.373446776735383, 23.47761982860862, 4.137071772729634}},
};
static const sample xyzbc[] = {
    {{10, 20, -5, 0, -20, 30}, {-3.8538509738154274, 20.26906523420376, -0.212667080506046}},
    {{-12.5, 7.25, 3.125, 0, 33.3, -77.7},
     {11.164468277945025, 15.406517860576491, -12.886231685636966}},
};
static const sample bridge[] = {
    {{10, 20, -5, 0, -20, 30, 0, 0, 5},
     {85.53052384513607, 63.607568274022746, -15.378381699593348}},
    {{-12.5, 7.25, 3.125, 0, 33.3, -77.7, 0, 0, -8},
     {-40.80396740404419, 137.0637161305506, -44.60961854887864}},
};

/* The kinematics of a head of a stream. */
static nc_kinematics kinematics_of(const char *module, const char *parameters,
                                   const char *letters) {
  stream t;
  nc_program p;
  nc_kinematics k;
  text_begin(&t);
  put_head(&t, module, parameters, letters, 1000, (double[NC_AXES]){0});
  fprintf(t.out, "end 0 1\n");
  fclose(t.out);
  FILE *in = fmemopen(t.at, t.size, "r");
  assert_works(nc_program_read(&p, in, "stream", &fault));
  assert_works(nc_kinematics_of(&k, &p, "stream", &fault));
  fclose(in);
  free(t.at);
  nc_program_free(&p);
  return k;
}

static void joints_at(const nc_kinematics *k, const double axis[NC_AXES],
                      nc_jet joint[NC_JOINTS_MOST]) {
  nc_jet jet[NC_AXES];
  for (int i = 0; i < NC_AXES; i++) {
    jet[i] = nc_still(nc_point(axis[i]));
  }
  nc_kinematics_joints(k, jet, joint);
}

static void assert_samples(const nc_kinematics *k, const sample *s, size_t count) {
  nc_jet joint[NC_JOINTS_MOST];
  for (size_t n = 0; n < count; n++) {
    joints_at(k, s[n].axis, joint);
    for (int i = 0; i < 3; i++) {
      assert_true(fabs(nc_middle(joint[i].v) * 1000 - s[n].joint[i]) < 1e-12);
      assert_true(joint[i].v.hi - joint[i].v.lo < 3e-15);
    }
  }
}

static const char trt[] = "parameter x-rot-point 3.5\nparameter y-rot-point -2.25\n"
                          "parameter z-rot-point 7.125\n";

CASE(test_samples) {
  char parameters[512];
  snprintf(parameters, sizeof parameters, "%sparameter y-offset 20\nparameter z-offset 10\n", trt);
  nc_kinematics k = kinematics_of("xyzac-trt-kins coordinates=xyzac", parameters, "XYZAC");
  assert_samples(&k, xyzac, LENGTH(xyzac));
  snprintf(parameters, sizeof parameters, "%sparameter x-offset -20\nparameter z-offset -15\n",
           trt);
  k = kinematics_of("xyzbc-trt-kins", parameters, "XYZBC");
  assert_samples(&k, xyzbc, LENGTH(xyzbc));
  k = kinematics_of("5axiskins coordinates=XYZBCWY", "", "XYZBCWY");
  assert_samples(&k, bridge, LENGTH(bridge));
}

/* With the tool offset that the samples of the simulator had in force. */
CASE(test_tool) {
  static const sample with[] = {
      {{-12.5, 7.25, 3.125, 33.3, 0, -77.7},
       {9.373446776735383, 46.811089593529225, 11.115258914578149}},
      {{-12.5, 7.25, 45.625, 33.3, 0, -77.7},
       {9.373446776735383, 23.47761982860862, 46.637071772729634}},
      {{1, 2, -17.5, -45, 0, 123.4}, {1.3280984313430109, -54.057869409138505, 22.36164841111355}}};
  char parameters[512];
  snprintf(parameters, sizeof parameters,
           "%sparameter y-offset 20\nparameter z-offset 10\nparameter tool-offset 40 z\n", trt);
  nc_kinematics k = kinematics_of("xyzac-trt-kins sparm=identityfirst", parameters, "XYZAC");
  assert_true(nc_kinematics_switch(&k, 1));
  assert_true(nc_kinematics_length(&k, 2.5));
  assert_false(nc_kinematics_length(&k, 2.5));
  assert_samples(&k, with, LENGTH(with));
}

static void turn_back(wide v[3], int about, wide degrees) { rotate(v, about, -degrees); }

/* From joints back to axes, by reversing each step. */
static void axes_of(const mill *m, const wide joint[3], wide axis[NC_AXES]) {
  int tilt = m->module == 'A' ? 0 : 1;
  const wide d[3] = {tilt == 1 ? m->offset[0] : 0, tilt == 0 ? m->offset[1] : 0,
                     (wide)m->offset[2] + m->tool};
  for (int i = 0; i < 3; i++) {
    axis[i] = joint[i] - d[i] - m->point[i];
  }
  turn_back(axis, tilt, axis[tilt == 0 ? NC_A : NC_B]);
  for (int i = 0; i < 3; i++) {
    axis[i] += d[i];
  }
  turn_back(axis, 2, axis[NC_C]);
  for (int i = 0; i < 3; i++) {
    axis[i] += m->point[i];
  }
}

/* Forward of inverse is where it began, to 1e-12 m. */
CASE(test_forward_of_inverse) {
  for (int n = 0; n < FEWER(2000); n++) {
    mill m = {.module = n % 2 == 0 ? 'A' : 'B'};
    char parameters[1024];
    for (int i = 0; i < 3; i++) {
      m.point[i] = 100 * random_unit();
      m.offset[i] = 100 * random_unit();
    }
    m.tool = 100 * random_unit();
    snprintf(parameters, sizeof parameters,
             "parameter x-rot-point %.17g\nparameter y-rot-point %.17g\n"
             "parameter z-rot-point %.17g\nparameter x-offset %.17g\nparameter y-offset %.17g\n"
             "parameter z-offset %.17g\nparameter tool-offset %.17g\n",
             m.point[0], m.point[1], m.point[2], m.offset[0], m.offset[1], m.offset[2], m.tool);
    nc_kinematics k = kinematics_of(n % 2 == 0 ? "xyzac-trt-kins" : "xyzbc-trt-kins", parameters,
                                    n % 2 == 0 ? "XYZAC" : "XYZBC");
    double axis[NC_AXES] = {0};
    wide back[NC_AXES], joint[3];
    nc_jet jet[NC_JOINTS_MOST];
    for (int i = 0; i < 6; i++) {
      back[i] = axis[i] = (i < 3 ? 200 : 400) * random_unit();
    }
    joints_at(&k, axis, jet);
    for (int i = 0; i < 3; i++) {
      joint[i] = 1000 * (wide)nc_middle(jet[i].v);
    }
    axes_of(&m, joint, back);
    for (int i = 0; i < 3; i++) {
      assert_true(fabsl(back[i] - axis[i]) < 1e-9L);
    }
  }
}

/* A type of the kinematics that is the identity, and one that is not known. */
CASE(test_types) {
  nc_kinematics k = kinematics_of("5axiskins", "parameter pivot-length 200 z\n", "XYZBC");
  double axis[NC_AXES] = {1, 2, 3, 0, 5, 6};
  nc_jet joint[NC_JOINTS_MOST];
  assert_false(k.identity);
  assert_true(nc_kinematics_switch(&k, 1));
  joints_at(&k, axis, joint);
  assert_true(fabs(nc_middle(joint[0].v) - 0.001) < 1e-18);
  assert_true(fabs(nc_middle(joint[3].v) - 5 * PI / 180) < 1e-16);
  assert_false(nc_kinematics_switch(&k, 2));
  assert_true(k.identity);
  k = kinematics_of("trivkins coordinates=xyzy kinstype=BOTH", "", "XYZY");
  assert_false(nc_kinematics_switch(&k, 1));
  joints_at(&k, axis, joint);
  assert_true(nc_middle(joint[1].v) == nc_middle(joint[3].v));
}
