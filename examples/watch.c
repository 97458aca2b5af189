/* SPDX-License-Identifier: MIT */
/* watch.c - a guard in a control loop: values of joints in, a verdict on each line of values out:
 *   cc watch.c $(pkg-config --cflags --libs sepax-io) -o watch
 *   ./watch robot.urdf robot.srdf 0.002 0.0005 < values
 * CLEARANCE and TRAVEL are in metres (radians). A line has one value for each joint, in the order
 * of the URDF. The verdict holds for all positions within the travel of the values. */
#include <sepax_robot.h>
#include <stdio.h>
#include <stdlib.h>

enum { JOINTS_MOST = 64 };

static int fail(const char *what) {
  fprintf(stderr, "watch: %s\n", what);
  return 2;
}

int main(int argc, char **argv) {
  sepax_robot_machine robot;
  sepax_watch *watch;
  sepax_machine_answer answer;
  sepax_error error = {0};
  double value[JOINTS_MOST];
  double travel[JOINTS_MOST];
  if (argc != 5) {
    return fail("give URDF SRDF CLEARANCE TRAVEL");
  }
  if (!sepax_robot_machine_read(&robot, argv[1], argv[2], NULL, &error) ||
      !sepax_watch_new(&watch, robot.machine, &error)) {
    return fail(error.text);
  }
  const size_t joints = robot.robot.mechanism.joints;
  if (joints == 0 || joints > JOINTS_MOST) {
    return fail("needs a robot of 1 to 64 joints");
  }
  for (size_t k = 0; k < joints; k++) {
    travel[k] = atof(argv[4]);
  }
  size_t n = 0;
  const sepax_machine_query query = {
      .size = sizeof query, .clearance = atof(argv[3]), .travel = travel, .work = 1000};
  while (scanf("%lf", &value[n]) == 1) {
    n = (n + 1) % joints;
    if (n == 0) { /* from here on no memory is taken */
      if (!sepax_watch_ask(watch, value, &query, &answer, &error)) {
        return fail(error.text); /* stop the axes */
      }
      if (answer.verdict == SEPAX_APART) {
        puts("apart");
      } else {
        const size_t *pair = robot.pairs.pair[answer.pair];
        const sepax_link *link = robot.robot.mechanism.link;
        printf("%s: %s, %s\n", answer.verdict == SEPAX_NEAR ? "near" : "undecided",
               link[pair[0]].name, link[pair[1]].name);
      }
    }
  }
  sepax_watch_free(watch);
  sepax_robot_machine_free(&robot);
  return feof(stdin) && n == 0 ? 0 : fail("the input has no number, or a line is cut"); /* stop */
}
