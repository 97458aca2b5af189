/* SPDX-License-Identifier: MIT */
// axis_source.h - pairs that one axis decides. Of `paper` and `conference`: it alone separates, by
// little, or none does and it almost would. With a clearance: the gap on it is about a limit.
#ifndef SEPAX_AXIS_SOURCE_H
#define SEPAX_AXIS_SOURCE_H

#include "pair_source.h"

#include <array>
#include <cmath>

namespace axis {

using Vector = std::array<double, 3>; // exact to 53 bits, which is enough to draw by

inline Vector vector(const sepax_vec &v) { return {(double)v.x, (double)v.y, (double)v.z}; }

inline double dot(const Vector &p, const Vector &q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

inline Vector cross(const Vector &p, const Vector &q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

inline Vector edge(const sepax_tri &tri, int k) {
  const Vector from = vector(tri.v[k]), to = vector(tri.v[(k + 1) % 3]);
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

// From one triangle to the other on an axis, below 0 where they overlap; and how much is little.
struct Gap {
  double gap, little;
};

inline Gap gap_on(const sepax_pair &pair, const Vector &axis) {
  double a[3], b[3];
  for (int k = 0; k < 3; k++) {
    a[k] = dot(vector(pair.a.v[k]), axis);
    b[k] = dot(vector(pair.b.v[k]), axis);
  }
  std::sort(a, a + 3);
  std::sort(b, b + 3);
  return {std::max(a[0] - b[2], b[0] - a[2]),
          1 + (std::max(a[2], b[2]) - std::min(a[0], b[0])) / 64};
}

// Of table 1, or if all of B is in A's plane of table 2, axis n of 0 ... 10; the normals are last.
inline Vector nth(const sepax_pair &pair, bool coplanar, int n) {
  if (n >= 9) {
    return vector(n == 9 ? pair.na : pair.nb);
  }
  if (!coplanar) {
    return cross(edge(pair.a, n / 3), edge(pair.b, n % 3));
  }
  return n < 3 ? cross(vector(pair.na), edge(pair.a, n))
               : cross(vector(pair.nb), edge(pair.b, n - 3));
}

inline bool coplanar(const sepax_pair &pair) {
  const Vector normal = vector(pair.na);
  for (int k = 0; k < 3; k++) {
    const double difference = dot(vector(pair.b.v[k]), normal) - dot(vector(pair.a.v[k]), normal);
    if (std::abs(difference) >= std::ldexp(1, SEPAX_WORD - 1)) {
      return false;
    }
  }
  return true;
}

// Does this axis decide? No other separates; this one does, by little, or almost does.
inline bool decides(const sepax_pair &pair, int wanted, bool separates) {
  const bool flat = coplanar(pair);
  if (flat && wanted >= 6 && wanted < 9) {
    return false;
  }
  const Gap own = gap_on(pair, nth(pair, flat, wanted));
  if (std::abs(own.gap) > own.little || own.little == 1 || (own.gap > 0) != separates) {
    return false;
  }
  for (int n = 0; n < 11; n++) {
    if (n != wanted && !(flat && n >= 6 && n < 9) && gap_on(pair, nth(pair, flat, n)).gap > 0) {
      return false;
    }
  }
  return true;
}

inline sepax_vec draw_vector(sepax_random *random, int bits) {
  const int64_t high = (INT64_C(1) << bits) - 1;
  sepax_vec v{};
  v.x = (int32_t)sepax_random_range(random, -high - 1, high);
  v.y = (int32_t)sepax_random_range(random, -high - 1, high);
  v.z = (int32_t)sepax_random_range(random, -high - 1, high);
  return v;
}

inline sepax_vec draw_unit(sepax_random *random) {
  sepax_vec v{};
  v.x = (int32_t)sepax_random_range(random, -1, 1);
  v.y = (int32_t)sepax_random_range(random, -1, 1);
  v.z = (int32_t)sepax_random_range(random, -1, 1);
  return v;
}

inline sepax_vec beside(const sepax_vec &v, sepax_random *random) {
  const auto sum = [](int32_t x, int32_t d) {
    const int64_t low = sepax_word_min(SEPAX_WORD), high = sepax_word_max(SEPAX_WORD);
    return (int32_t)std::clamp((int64_t)x + d, low, high);
  };
  const sepax_vec step = draw_unit(random);
  return {sum(v.x, step.x), sum(v.y, step.y), sum(v.z, step.z)};
}

// N_A is long. Two vertices of B are those of A, or beside them; one is far from A's along N_A.
inline sepax_pair draw_far(sepax_random *random) {
  sepax_pair pair{};
  const int64_t high = sepax_word_max(SEPAX_WORD), least = sepax_random_range(random, 1, high);
  const int far = (int)sepax_random_range(random, 0, 2);
  const int32_t above = sepax_random_range(random, 0, 1) == 0 ? 1 : -1;
  for (int k = 0; k < 3; k++) {
    pair.a.v[k] = draw_vector(random, SEPAX_WORD - 1);
    const bool same = sepax_random_range(random, 0, 1) == 0;
    pair.b.v[k] = same ? pair.a.v[k] : beside(pair.a.v[k], random);
  }
  pair.nb = sepax_unit_normal(&pair.b, SEPAX_WORD);
  for (int c = 0; c < 3; c++) { // components
    const int32_t sign = sepax_random_range(random, 0, 1) == 0 ? 1 : -1;
    const auto size = [&] { return sign * (int32_t)sepax_random_range(random, least, high); };
    coordinate(pair, 18 + c) = size();
    coordinate(pair, 3 * far + c) = -above * size();
    coordinate(pair, 9 + 3 * far + c) = above * size();
  }
  return pair;
}

// Any two triangles, with their normals or others: also those of a file are what they are.
inline sepax_pair draw(sepax_random *random) {
  const int bits = (int)sepax_random_range(random, 1, SEPAX_WORD - 1);
  sepax_pair pair{};
  for (int k = 0; k < 3; k++) {
    pair.a.v[k] = draw_vector(random, bits);
    pair.b.v[k] = draw_vector(random, bits);
  }
  if (sepax_random_range(random, 0, 1) == 0) { // a common vertex
    pair.b.v[sepax_random_range(random, 0, 2)] = pair.a.v[sepax_random_range(random, 0, 2)];
  }
  if (sepax_random_range(random, 0, 1) == 0) { // two vertices that are neighbours
    sepax_tri &near = sepax_random_range(random, 0, 1) == 0 ? pair.a : pair.b;
    const int64_t k = sepax_random_range(random, 0, 2);
    near.v[k] = beside(near.v[(k + 1) % 3], random);
  }
  pair = pair_with_normals(pair);
  switch (sepax_random_range(random, 0, 3)) {
  case 0:
    pair.na = draw_unit(random);
    pair.nb = draw_vector(random, SEPAX_WORD - 1);
    break;
  case 1:
    pair.na = draw_vector(random, SEPAX_WORD - 1);
    pair.nb = draw_unit(random);
    break;
  case 2:
    pair.na = draw_unit(random);
    break;
  default:
    break;
  }
  return pair;
}

#ifdef SEPAX_BANDS
// Coordinates at the ends of the range, or anywhere in a part of it.
inline sepax_pair draw_long(sepax_random *random) {
  const int64_t low = sepax_word_min(SEPAX_WORD), high = sepax_word_max(SEPAX_WORD);
  const bool ends = sepax_random_range(random, 0, 1) == 0;
  const int bits = (int)sepax_random_range(random, 1, SEPAX_WORD - 1);
  sepax_pair pair{};
  for (int k = 0; k < 6; k++) {
    (k < 3 ? pair.a.v[k] : pair.b.v[k - 3]) = draw_vector(random, bits);
  }
  for (int k = 0; k < 18 && ends; k++) {
    const int64_t from = sepax_random_range(random, 0, 2);
    coordinate(pair, k) =
        (int32_t)(sepax_random_range(random, 0, 1) == 0 ? low + from : high - from);
  }
  return pair;
}

// The axis of the verdict at these limits, if it is normal to two edges.
inline int proof(const sepax_design &design, const sepax_pair &pair) {
  const int axis = sepax_judge(&design, &pair).axis;
  return axis == SEPAX_AXIS_NORMAL_A   ? 9
         : axis == SEPAX_AXIS_NORMAL_B ? 10
         : axis < SEPAX_AXIS_NORMAL_A  ? axis - SEPAX_AXIS_EDGES
                                       : -1;
}

// Does an axis decide on which the gap is at a limit? It proves so here, or at limits less by one.
inline bool limits(const sepax_design &design, const sepax_design &nearer, const sepax_pair &pair) {
  for (int n = 0; n < 11; n++) {
    const sepax_tri &tri = n == 10 ? pair.b : pair.a;
    const Vector normal = n < 9 ? nth(pair, false, n) : cross(edge(tri, 0), edge(tri, 1));
    const double gap = gap_on(pair, normal).gap;
    const double x = std::abs(normal[0]), y = std::abs(normal[1]), z = std::abs(normal[2]);
    for (const int clearance : {design.config.clearance, design.config.warning}) {
      const double limit = (2 + clearance) * (x + y + z) + clearance * std::max({x, y, z});
      if (gap > 0 && std::abs(2 * gap - limit) <= 2 &&
          (proof(design, pair) == n || proof(nearer, pair) == n)) {
        return true;
      }
    }
  }
  return false;
}
#endif

} // namespace axis

#ifdef SEPAX_BANDS
// Every other at a limit; of the rest any gap on such an axis decides.
inline Source axis_source(uint64_t count, uint64_t seed, const sepax_design &design) {
  sepax_config less = design.config;
  less.clearance -= less.clearance > 0;
  less.warning -= less.warning > less.clearance + 1;
  sepax_design nearer;
  sepax_error error{};
  if (!sepax_design_init(&nearer, &less, &error)) {
    fail(error);
  }
  return counted(count, [=, random = sepax_random{seed}](uint64_t n) mutable {
    constexpr int TRIES = 500;
    sepax_pair pair = axis::draw_long(&random);
    for (int k = 0; k < TRIES && !(n % 2 == 1 ? axis::proof(design, pair) >= 0
                                              : axis::limits(design, nearer, pair));
         k++) {
      pair = axis::draw_long(&random);
    }
    return pair;
  });
}
#else
// Each axis in turn, and one in four where one vertex decides that the pair is not coplanar.
inline Source axis_source(uint64_t count, uint64_t seed, const sepax_design &) {
  return counted(count, [random = sepax_random{seed}](uint64_t n) mutable {
    constexpr int TRIES = 400, AXES = 11;
    if (n % 4 == 3) {
      return axis::draw_far(&random);
    }
    sepax_pair pair = axis::draw(&random);
    for (int k = 0; k < TRIES && !axis::decides(pair, (int)(n % AXES), n / AXES % 2 == 0); k++) {
      pair = axis::draw(&random);
    }
    return pair;
  });
}

#endif

#endif
