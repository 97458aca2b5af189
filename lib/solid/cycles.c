/* SPDX-License-Identifier: MIT */
/* cycles.c - finds the closed surfaces that sheets form, which are the kernel of a matrix modulo 2:
 * its columns are sheets, its rows places.
 *
 * If a place is in the boundary of one sheet alone, then this sheet is in no closed surface. If it
 * is in two boundaries, then their sheets are in the same closed surfaces, and become one group.
 * This leaves little of most bodies. The rest is reduced column by column. */
#include "parts.h"
#include "sheets.h"
#include "util/memory.h"

#include <stdlib.h>
#include <string.h>

/* ROUNDS: of taking out and joining. WORK: steps of the reduction. */
enum { ROUNDS = 64, WORK = 1 << 24 };

typedef struct {
  uint32_t *number; /* sorted */
  size_t count;
} numbers;

typedef struct {
  numbers place; /* of this column and those that were added to it */
  numbers group; /* which these are */
} column;

typedef struct {
  const surface *s;
  border *list;
  size_t count;
  uint32_t places;
  uint8_t *member;
  uint64_t *word;
  uint32_t *group; /* union-find of sheets */
  uint32_t *times; /* of each place: of how many groups it is */
  uint32_t *sum;   /* of each place: their sum modulo 2 */
  uint32_t *begin; /* of each group: its first border; of the one after the last, their end */
  uint32_t *stack;
  uint64_t cycles; /* how many are found */
} search;

/* Order the borders by groups that are left, and count. False without memory. */
static bool begin_round(search *c) {
  uint32_t limit = (uint32_t)c->s->count;
  size_t kept = 0;
  for (size_t n = 0; n < c->count; n++) {
    uint32_t group = set_of(c->group, c->list[n].sheet);
    if (c->member[group]) {
      c->list[kept++] = (border){group, c->list[n].place};
    }
  }
  c->count = kept;
  if (!sepax__sort_borders(c->list, &c->count, limit, c->places)) {
    return false;
  }
  memset(c->times, 0, c->places * sizeof *c->times);
  memset(c->sum, 0, c->places * sizeof *c->sum);
  memset(c->begin, 0, ((size_t)limit + 1) * sizeof *c->begin);
  for (size_t n = 0; n < c->count; n++) {
    c->times[c->list[n].place]++;
    c->sum[c->list[n].place] ^= c->list[n].sheet;
    c->begin[c->list[n].sheet + 1]++;
  }
  for (uint32_t n = 0; n < limit; n++) {
    c->begin[n + 1] += c->begin[n];
  }
  return true;
}

/* Take out groups that have a place alone. */
static bool take_out(search *c) {
  size_t depth = 0;
  bool any = false;
  for (uint32_t n = 0; n < c->places; n++) {
    if (c->times[n] == 1) {
      c->stack[depth++] = n;
    }
  }
  while (depth > 0) {
    uint32_t place = c->stack[--depth];
    uint32_t group = c->sum[place];
    if (c->times[place] != 1) {
      continue;
    }
    any = true;
    c->member[group] = 0;
    for (uint32_t n = c->begin[group]; n < c->begin[group + 1]; n++) {
      uint32_t at = c->list[n].place;
      c->sum[at] ^= group;
      if (--c->times[at] == 1) {
        c->stack[depth++] = at;
      }
    }
  }
  return any;
}

/* Join the two groups of a place. */
static bool join_groups(search *c) {
  bool any = false;
  for (size_t n = 0; n < c->count; n++) {
    const border *b = &c->list[n];
    if (c->member[b->sheet] && c->times[b->place] == 2) {
      any = true;
      join(c->group, b->sheet, c->sum[b->place] ^ b->sheet);
    }
  }
  return any;
}

/* The groups are a closed surface. */
static void add_cycle(search *c, const uint32_t *group, size_t count) {
  uint64_t word = word_of(2 * c->cycles++);
  for (size_t n = 0; n < count; n++) {
    c->word[group[n]] ^= word;
    join(c->s->parent, group[0], group[n]);
  }
}

/* p becomes the sum of p and q modulo 2. False without memory. */
static bool add_numbers(numbers *p, const numbers *q) {
  uint32_t *sum = sepax_allocate((p->count + q->count) * sizeof *sum + 1);
  if (sum == NULL) {
    return false;
  }
  size_t i = 0;
  size_t j = 0;
  size_t count = 0;
  while (i < p->count || j < q->count) {
    if (j == q->count || (i < p->count && p->number[i] < q->number[j])) {
      sum[count++] = p->number[i++];
    } else if (i == p->count || q->number[j] < p->number[i]) {
      sum[count++] = q->number[j++];
    } else {
      i++;
      j++;
    }
  }
  sepax_release(p->number);
  *p = (numbers){sum, count};
  return true;
}

static bool make_column(const search *c, uint32_t group, column *made) {
  size_t count = c->begin[group + 1] - c->begin[group];
  made->place = (numbers){sepax_allocate(count * sizeof(uint32_t)), count};
  made->group = (numbers){sepax_allocate(sizeof(uint32_t)), 1};
  if (made->place.number == NULL || made->group.number == NULL) {
    return false;
  }
  for (size_t n = 0; n < count; n++) {
    made->place.number[n] = c->list[c->begin[group] + n].place;
  }
  made->group.number[0] = group;
  return true;
}

/* Reduce each column by earlier ones with the same last place. A column that vanishes is a closed
 * surface. c->times becomes the column + 1 that has a place as its last one. *over: too much work.
 */
static bool reduce(search *c, column *all, size_t columns, bool *over) {
  size_t work = 0;
  size_t most = WORK + 16 * c->count;
  memset(c->times, 0, c->places * sizeof *c->times);
  for (size_t n = 0; n < columns; n++) {
    column *own = &all[n];
    while (own->place.count > 0) {
      uint32_t last = own->place.number[own->place.count - 1];
      if (c->times[last] == 0) {
        c->times[last] = (uint32_t)n + 1;
        break;
      }
      const column *earlier = &all[c->times[last] - 1];
      work += own->place.count + earlier->place.count + own->group.count + earlier->group.count;
      if (work > most) {
        *over = true;
        return true;
      }
      if (!add_numbers(&own->place, &earlier->place) ||
          !add_numbers(&own->group, &earlier->group)) {
        return false;
      }
    }
    if (own->place.count == 0) {
      add_cycle(c, own->group.number, own->group.count);
    }
  }
  return true;
}

static bool find_rest(search *c, bool *tangled) {
  size_t columns = 0;
  for (uint32_t n = 0; n < c->s->count; n++) {
    if (c->member[n] && set_of(c->group, n) == n) {
      columns += c->begin[n + 1] > c->begin[n];
    }
  }
  column *all = sepax__zeroed(columns + 1, sizeof *all);
  bool ok = all != NULL;
  bool over = false;
  columns = 0;
  for (uint32_t n = 0; n < c->s->count && ok; n++) {
    if (c->member[n] && set_of(c->group, n) == n) {
      if (c->begin[n + 1] > c->begin[n]) {
        ok = make_column(c, n, &all[columns++]);
      } else {
        add_cycle(c, &n, 1);
      }
    }
  }
  ok = ok && reduce(c, all, columns, &over);
  for (size_t n = 0; n < columns; n++) {
    sepax_release(all[n].place.number);
    sepax_release(all[n].group.number);
  }
  sepax_release(all);
  for (uint32_t n = 0; n < c->s->count && over; n++) {
    uint32_t group = set_of(c->group, n);
    tangled[n] = c->member[group] && c->begin[group + 1] > c->begin[group];
  }
  return ok;
}

bool sepax__find_cycles(const surface *s, border *list, size_t count, uint32_t places,
                        uint8_t *member, uint64_t *word, bool *tangled) {
  search c = {s,
              list,
              count,
              places,
              member,
              word,
              .group = sepax_allocate(s->count * sizeof *c.group),
              .times = sepax_allocate(places * sizeof *c.times + 1),
              .sum = sepax_allocate(places * sizeof *c.sum + 1),
              .begin = sepax_allocate((s->count + 1) * sizeof *c.begin),
              .stack = sepax_allocate(places * sizeof *c.stack + 1)};
  bool ok =
      c.group != NULL && c.times != NULL && c.sum != NULL && c.begin != NULL && c.stack != NULL;
  for (uint32_t n = 0; n < s->count && ok; n++) {
    c.group[n] = n;
  }
  bool more = ok;
  for (int n = 0; n < ROUNDS && ok && more; n++) {
    ok = begin_round(&c);
    more = ok && take_out(&c);
    more = ok && (join_groups(&c) || more);
  }
  ok = ok && (!more || begin_round(&c)) && find_rest(&c, tangled);
  for (uint32_t n = 0; n < s->count && ok; n++) {
    uint32_t group = set_of(c.group, n);
    word[n] = member[group] ? word[group] : 0;
    if (word[n] != 0) {
      join(s->parent, n, group);
    }
  }
  for (uint32_t n = 0; n < s->count && ok; n++) {
    member[n] = word[n] != 0;
  }
  sepax_release(c.group);
  sepax_release(c.times);
  sepax_release(c.sum);
  sepax_release(c.begin);
  sepax_release(c.stack);
  return ok;
}
