/* SPDX-License-Identifier: MIT */
/* poses.c - reads files of poses, 12 decimal numbers in each line. */
#include "sepax.h"
#include "util/error.h"
#include "util/list.h"
#include "util/plain_numbers.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { NUMBERS = 12 };

static const char blanks[] = " \t\r\n\v\f";
static const char cure[] = "give 12 numbers: the rotation by rows, then the translation";

/* A piece of a line for a message, short and printable. */
typedef struct {
  char text[28];
} quote;

static quote quoted(const char *word, size_t length) {
  enum { MOST = 24 };
  quote q;
  bool cut = length > MOST;
  snprintf(q.text, sizeof q.text, "%.*s%s", cut ? MOST : (int)length, word, cut ? "..." : "");
  for (char *c = q.text; *c != '\0'; c++) {
    *c = *c < ' ' || *c > '~' ? '?' : *c;
  }
  return q;
}

/* Read a decimal number, rounded once. strtod alone would also accept hexadecimal numbers and
 * words. */
static bool read_number(double *number, const char *word, size_t length, sepax_error *error) {
  static const char decimal[] = "+-.0123456789eE";
  char *end;
  *number = strtod(word, &end);
  if (end == word + length && !isfinite(*number) && strspn(word, decimal) >= length) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "%s is too large for a double; scale the bodies",
                      quoted(word, length).text);
  }
  if (end == word + length && isnan(*number)) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "NaN is no number; %s", cure);
  }
  if (end != word + length || strspn(word, decimal) < length) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "'%s' is no number; %s", quoted(word, length).text,
                      cure);
  }
  return true;
}

/* Read a line of `length` bytes. *empty: it has no pose. If `moved` is not NULL, then the nearest
 * rotation is taken, and *moved becomes at least the largest change of an entry. */
static bool read_pose(sepax_pose *pose, bool *empty, double *moved, char *line, size_t length,
                      sepax_error *error) {
  double number[NUMBERS];
  size_t count = 0;
  if (strlen(line) < length) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "a byte of zero is no text; %s", cure);
  }
  line[strcspn(line, "#")] = '\0';
  for (char *word = line; *(word += strspn(word, blanks)) != '\0'; count++) {
    size_t used = strcspn(word, blanks);
    double beyond;
    if (!read_number(count < NUMBERS ? &number[count] : &beyond, word, used, error)) {
      return false;
    }
    word += used;
  }
  *empty = count == 0;
  if (count != 0 && count != NUMBERS) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "%zu number%s; %s", count, count == 1 ? "" : "s",
                      cure);
  }
  for (int i = 0; i < 3 && count > 0; i++) {
    for (int k = 0; k < 3; k++) {
      pose->rotation[i][k] = number[3 * i + k];
    }
    pose->translation[i] = number[9 + i];
  }
  if (*empty || moved == NULL) {
    return *empty || sepax_pose_valid(pose, error);
  }
  double way;
  if (!sepax_pose_nearest(pose, &way, error)) {
    return false;
  }
  *moved = way > *moved ? way : *moved;
  return true;
}

static bool append(sepax_poses *poses, size_t *capacity, const sepax_pose *pose) {
  sepax_pose *grown = list_grow(poses->pose, capacity, poses->count, sizeof *grown);
  if (grown == NULL) {
    return false;
  }
  poses->pose = grown;
  poses->pose[poses->count++] = *pose;
  return true;
}

static bool read_lines(sepax_poses *poses, double *moved, FILE *in, const char *path,
                       sepax_error *error) {
  static const char mark[] =
      "\xef\xbb\xbf"; /* byte order mark of UTF-8, which some editors put in front of a file */
  char *line = NULL;
  size_t size = 0;
  size_t capacity = 0;
  bool ok = true;
  ssize_t length = 0;
  errno = 0;
  for (size_t number = 1; ok && (length = getline(&line, &size, in)) >= 0; number++) {
    sepax_pose pose;
    bool empty = false;
    sepax_error what = {0};
    size_t skip = number == 1 && strncmp(line, mark, strlen(mark)) == 0 ? strlen(mark) : 0;
    if (!read_pose(&pose, &empty, moved, line + skip, (size_t)length - skip, &what)) {
      ok = sepax_fail(error, SEPAX_ERROR_FORMAT, "%.240s:%zu: %.200s", path, number, what.text);
    } else if (!empty && !append(poses, &capacity, &pose)) {
      ok = sepax_fail(error, SEPAX_ERROR_MEMORY,
                      "%.240s:%zu: no memory for so many poses; split the file", path, number);
    }
    errno = 0;
  }
  if (ok && !feof(in)) {
    ok = sepax_fail(error, SEPAX_ERROR_FILE, "%.240s: %s; give a readable file of poses", path,
                    strerror(errno));
  }
  free(line); /* from getline, which only uses malloc */
  return ok;
}

static bool read_poses(sepax_poses *poses, double *moved, const char *path, sepax_error *error) {
  *poses = (sepax_poses){0};
  FILE *in = fopen(path, "r");
  if (in == NULL) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "%.240s: %s; give a readable file of poses", path,
                      strerror(errno));
  }
  plain_numbers plain = plain_numbers_begin();
  bool ok = read_lines(poses, moved, in, path, error);
  plain_numbers_end(plain);
  fclose(in);
  if (ok && poses->count == 0) {
    ok = sepax_fail(error, SEPAX_ERROR_FORMAT, "%.240s: the file has no poses; %s in each line",
                    path, cure);
  }
  if (!ok) {
    sepax_poses_free(poses);
  }
  return ok;
}

bool sepax_poses_read(sepax_poses *poses, const char *path, sepax_error *error) {
  return read_poses(poses, NULL, path, error);
}

bool sepax_poses_read_nearest(sepax_poses *poses, double *moved, const char *path,
                              sepax_error *error) {
  *moved = 0;
  return read_poses(poses, moved, path, error);
}

void sepax_poses_free(sepax_poses *poses) {
  sepax_release(poses->pose);
  *poses = (sepax_poses){0};
}
