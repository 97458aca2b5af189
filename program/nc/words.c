/* SPDX-License-Identifier: MIT */
/* words.c - the words of one line of the stream. */
#include "nc/words.h"
#include "nc/canon.h"
#include "util/error.h"
#include "util/text.h"

#include <math.h>
#include <string.h>

static const double number_most = 1e9;

bool nc_refuse(const nc_words *w, const char *format, ...) {
  char detail[300];
  va_list args;
  va_start(args, format);
  vsnprintf(detail, sizeof detail, format, args);
  va_end(args);
  return sepax_fail(w->error, SEPAX_ERROR_FORMAT, "%.180s:%zu: %s", w->name, w->line, detail);
}

char *nc_word(nc_words *w) {
  char *word = w->rest;
  if (word == NULL) {
    return NULL;
  }
  char *blank = strchr(word, ' ');
  if (blank != NULL) {
    *blank = '\0';
  }
  w->rest = blank != NULL ? blank + 1 : NULL;
  return word;
}

bool nc_take_number(nc_words *w, const char *what, double *value) {
  const char *word = nc_word(w);
  if (word == NULL) {
    return nc_refuse(w, "the line ends before %s; write a number", what);
  }
  if (!sepax__number(word, strlen(word), value)) {
    return nc_refuse(w, "%s: '%.40s' is no finite number", what, word);
  }
  return fabs(*value) <= number_most ||
         nc_refuse(w, "%s: %.40s is beyond +-%g", what, word, number_most);
}

bool nc_take_numbers(nc_words *w, const char *what, size_t count, double *value) {
  for (size_t n = 0; n < count; n++) {
    if (!nc_take_number(w, what, &value[n])) {
      return false;
    }
  }
  return true;
}

bool nc_take_whole(nc_words *w, const char *what, long least, long most, long *value) {
  double number = 0;
  if (!nc_take_number(w, what, &number)) {
    return false;
  }
  if (!(number == floor(number) && number >= (double)least && number <= (double)most)) {
    return nc_refuse(w, "%s: %.9g is no whole number from %ld to %ld", what, number, least, most);
  }
  *value = (long)number;
  return true;
}

bool nc_take_name(nc_words *w, const char *what, char *name) {
  const char *word = nc_word(w);
  if (word == NULL || *word == '\0') {
    return nc_refuse(w, "%s is missing", what);
  }
  if (strlen(word) >= NC_NAME) {
    return nc_refuse(w, "%s: '%.40s...' is longer than %d characters", what, word, NC_NAME - 1);
  }
  strcpy(name, word);
  return true;
}

bool nc_take_choice(nc_words *w, const char *what, const char *const names[], int *choice) {
  const char *word = nc_word(w);
  char list[120] = "";
  for (int n = 0; names[n] != NULL; n++) {
    if (word != NULL && strcmp(word, names[n]) == 0) {
      *choice = n;
      return true;
    }
    snprintf(list + strlen(list), sizeof list - strlen(list), "%s%s", n > 0 ? ", " : "", names[n]);
  }
  return nc_refuse(w, "%s: '%.40s' is none of: %s", what, word != NULL ? word : "", list);
}

bool nc_take_text(nc_words *w, char **text) {
  const char *rest = w->rest != NULL ? w->rest : "";
  *text = sepax_allocate(strlen(rest) + 1);
  w->rest = NULL;
  if (*text == NULL) {
    return sepax_fail(w->error, SEPAX_ERROR_MEMORY, "%.180s:%zu: no memory", w->name, w->line);
  }
  strcpy(*text, rest);
  return true;
}

bool nc_take_end(const nc_words *w) {
  return w->rest == NULL || nc_refuse(w, "'%.40s' is one word too many", w->rest);
}
