/* SPDX-License-Identifier: MIT */
/* rows_scarcity.c - rows of an NC program without memory: each allocation refused in turn. */
#include "streams.h"
#include "unit/memory/scarce.h"

static bool work(void *context) {
  static const char text[] = "sepax-nc 1\nfile 0 part.ngc\nmachine xyzac-trt-kins\n"
                             "joint 0 X linear -500 500\njoint 1 Y linear -500 500\n"
                             "joint 2 Z linear -500 500\njoint 3 A angular -90 90\n"
                             "joint 4 C angular -900 900\n"
                             "tool 1 1 6 0 0 9 0 0 0 0 0 0 six\nstart home 0 0 0 0 0 0 0 0 0\n"
                             "note 0 1 text\nload 0 2 1\nkins 0 2 1 0 0 0 0 0 0 0 0 0\n"
                             "kins 0 3 0 0 0 0 0 0 0 0 0 0\n"
                             "move feed 0 4 50 20 10 40 0 700 0 0 0\n"
                             "move rapid 0 5 10 20 10 40 0 0 0 0 0\nend 0 6\n";
  FILE *in = context;
  nc_motion m;
  rewind(in);
  if (fwrite(text, 1, sizeof text - 1, in) != sizeof text - 1) {
    return false;
  }
  rewind(in);
  if (!nc_motion_read(&m, in, "stream", NULL, &fault)) {
    assert_true(m.rows == 0 && m.row == NULL && m.program.record == NULL);
    return false;
  }
  assert_true(m.rows > 512);
  nc_motion_free(&m);
  return true;
}

CASE(test_memory) {
  FILE *in = tmpfile();
  assert_non_null(in);
  long refused = assert_scarce(work, in);
  print_message("%ld allocations\n", refused);
  assert_true(refused > 10);
  fclose(in);
}
