/* SPDX-License-Identifier: MIT */
/* sides.c - finds polygons that a file has twice. */
#include "sides.h"

#include "util/hash.h"
#include "util/memory.h"

static uint64_t hash_of(const double corner[3]) {
  const double v[3] = {corner[0] + 0.0, corner[1] + 0.0, corner[2] + 0.0}; /* -0 becomes 0 */
  return hash_doubles(v, 3);
}

static uint32_t short_hash(const double corner[3]) { return (uint32_t)(hash_of(corner) >> 32); }

/* The slot of the polygon, or the free one where it belongs. */
static polygon_side *slot_of(const polygon_sides *sides, uint64_t all) {
  size_t at = (size_t)all & (sides->slots - 1);
  while (sides->slot[at].all != 0 && sides->slot[at].all != all) {
    at = (at + 1) & (sides->slots - 1);
  }
  return &sides->slot[at];
}

/* At least half of the slots stay free. */
static bool reserve(polygon_sides *sides) {
  if (2 * (sides->used + 1) <= sides->slots) {
    return true;
  }
  polygon_sides grown = {.slots = sides->slots == 0 ? 64 : 4 * sides->slots, .used = sides->used};
  grown.slot = sepax__zeroed(grown.slots, sizeof *grown.slot);
  if (grown.slot == NULL) {
    return false;
  }
  for (size_t n = 0; n < sides->slots; n++) {
    if (sides->slot[n].all != 0) {
      *slot_of(&grown, sides->slot[n].all) = sides->slot[n];
    }
  }
  sepax_release(sides->slot);
  *sides = grown;
  return true;
}

bool sepax__sides_find(polygon_sides *sides, const double (*corner)[3], size_t count, size_t *first,
                       bool *back) {
  uint64_t all = count;
  for (size_t n = 0; n < count; n++) {
    all += hash_of(corner[n]); /* a sum does not depend on the order */
  }
  all = all != 0 ? all : 1;
  *first = 0;
  *back = false;
  if (!reserve(sides)) {
    return false;
  }
  polygon_side *side = slot_of(sides, all);
  if (side->all == 0) {
    *side = (polygon_side){all, {short_hash(corner[0]), short_hash(corner[1])}};
    sides->used++;
    return true;
  }
  for (size_t n = 0; n < count; n++) {
    bool ahead = short_hash(corner[(n + 1) % count]) == side->corner[1];
    bool behind = short_hash(corner[(n + count - 1) % count]) == side->corner[1];
    if (short_hash(corner[n]) == side->corner[0] && (ahead || behind)) {
      *first = n;
      *back = !ahead;
      break;
    }
  }
  return true;
}
