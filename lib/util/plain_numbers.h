/* SPDX-License-Identifier: MIT */
/* plain_numbers.h - numbers with a decimal point, in every locale that a program may have chosen
 * (private). Between begin and end the calling thread has the numbers of locale C. */
#ifndef SEPAX_PLAIN_NUMBERS_H
#define SEPAX_PLAIN_NUMBERS_H

#include <locale.h>

typedef struct {
  locale_t plain, before;
} plain_numbers;

static inline plain_numbers plain_numbers_begin(void) {
  plain_numbers p = {newlocale(LC_NUMERIC_MASK, "C", (locale_t)0), (locale_t)0};
  p.before = p.plain != (locale_t)0 ? uselocale(p.plain) : (locale_t)0;
  return p;
}

static inline void plain_numbers_end(plain_numbers p) {
  if (p.plain != (locale_t)0) {
    uselocale(p.before);
    freelocale(p.plain);
  }
}

#endif
