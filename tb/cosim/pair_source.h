/* SPDX-License-Identifier: MIT */
// pair_source.h - where the pairs of the Verilator test bench come from.
#ifndef SEPAX_PAIR_SOURCE_H
#define SEPAX_PAIR_SOURCE_H

#include "cli/cli.h"
#include "meshes.h"
#include "sepax_params.h"
#include "sepax_vectors.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstdio>
#include <cstring>
#include <functional>

struct Source {
  uint64_t total; // 0: not known beforehand
  std::function<bool(sepax_pair *)> next;
};

[[noreturn]] inline void fail(const sepax_error &error) { std::exit(cli_fail("cosim", &error)); }

inline Source file_source(const char *path, const sepax_design &design) {
  FILE *in = std::strcmp(path, "-") == 0 ? stdin : std::fopen(path, "r");
  if (in == nullptr) {
    std::fprintf(stderr, "cosim: %s: cannot be read; give a file of pairs\n", path);
    std::exit(EXIT_ERROR);
  }
  return {0, [=, &design, number = (size_t)0](sepax_pair *pair) mutable {
            sepax_error error{};
            sepax_told told;
            sepax_line line =
                sepax_pair_read_told(pair, &told, in, path, &number, SEPAX_WORD, &error);
            if (line == SEPAX_LINE_ERROR) {
              fail(error);
            }
            if (line == SEPAX_LINE_PAIR && told.count > 0) {
              sepax_judgement verdict = sepax_judge(&design, pair);
              if (!sepax_told_check(&told, &design, &verdict, &error)) {
                std::fprintf(stderr, "cosim: %s:%zu: %s\n", path, number, error.text);
                std::exit(EXIT_ERROR);
              }
            }
            return line == SEPAX_LINE_PAIR;
          }};
}

// Pairs nth(0) ... nth(count - 1).
template <typename Nth> Source counted(uint64_t count, Nth nth) {
  return {count, [=, at = (uint64_t)0](sepax_pair *pair) mutable {
            if (at == count) {
              return false;
            }
            *pair = nth(at++);
            return true;
          }};
}

inline Source mesh_source(const char *const path[2], const cli_grid &grid) {
  sepax_error error{};
  sepax_scene scene{};
  if (!mesh_files_scene(&scene, path, &grid.grid, grid.file_normals, &error)) {
    fail(error);
  }
  mesh_files_print(&scene, path);
  return counted((uint64_t)scene.count[0] * scene.count[1], [=](uint64_t n) {
    return sepax_scene_pair(&scene, n / scene.count[1], n % scene.count[1]);
  });
}

// Seeded hard pairs draw(family, random): of one family, or of "all" in turn.
template <typename Draw>
Source family_source(uint64_t count, uint64_t seed, const char *name, Draw draw) {
  sepax_error error{};
  size_t first, last;
  if (!cli_families(name, &first, &last, &error)) {
    fail(error);
  }
  return counted(count, [=, random = sepax_random{seed}](uint64_t n) mutable {
    return draw(first + n % (last - first + 1), &random);
  });
}

inline sepax_pair draw_pair(size_t family, sepax_random *random) {
  auto *pair = SEPAX_EXACT ? sepax_family_triangles : sepax_family_pair;
  return pair(family, SEPAX_WORD, random);
}

#ifdef SEPAX_EXTENT_A
// Within the design's extents, or exceeding them.
template <bool exceeding> sepax_pair draw_extents(size_t family, sepax_random *random) {
  const int extent[2] = {SEPAX_EXTENT_A, SEPAX_EXTENT_B};
  return sepax_extent_pair(family, SEPAX_WORD, extent, exceeding, random);
}
#endif

// Number k of a pair in the order of a line of text: 18 coordinates, 6 components of normals.
template <typename Pair> auto &coordinate(Pair &pair, int k) {
  auto &v = k < 9 ? pair.a.v[k / 3] : k < 18 ? pair.b.v[k / 3 - 3] : k < 21 ? pair.na : pair.nb;
  return k % 3 == 0 ? v.x : k % 3 == 1 ? v.y : v.z;
}

// exact has no normals.
inline sepax_pair pair_with_normals(sepax_pair pair) {
  if (!SEPAX_EXACT) {
    pair.na = sepax_unit_normal(&pair.a, SEPAX_WORD);
    pair.nb = sepax_unit_normal(&pair.b, SEPAX_WORD);
  }
  return pair;
}

// Coordinate k of the pair is value[digit of base^k in n].
template <unsigned base> sepax_pair pair_of_digits(uint64_t n, const int32_t (&value)[base]) {
  sepax_pair pair{};
  for (int k = 0; k < 18; k++) {
    coordinate(pair, k) = value[n % base];
    n /= base;
  }
  return pair_with_normals(pair);
}

constexpr uint64_t TERNARY_PAIRS = 387420489; // 3^18

// Pairs first ... first + count - 1 of those with coordinates -1, 0, 1.
inline Source ternary_source(uint64_t first, uint64_t count) {
  return counted(count, [=](uint64_t n) { return pair_of_digits(first + n, {-1, 0, 1}); });
}

// So many of them, each once, spread over all: the step has no factor 3, and is the golden section.
inline Source sample_source(uint64_t count) {
  constexpr uint64_t STEP = 239439031;
  return counted(count, [](uint64_t n) {
    return pair_of_digits(n * STEP % TERNARY_PAIRS, {-1, 0, 1});
  });
}

inline Source bits_source() {
  return counted(1 << 18, [](uint64_t n) { return pair_of_digits(n, {0, 1}); });
}

// Each coordinate is one of seven at the ends and the middle of the range.
inline Source corner_source(uint64_t count, uint64_t seed) {
  return counted(count, [random = sepax_random{seed}](uint64_t) mutable {
    constexpr int64_t CHOICES = 1628413597910449; // 7^18
    const int32_t min = sepax_word_min(SEPAX_WORD);
    const int32_t max = sepax_word_max(SEPAX_WORD);
    return pair_of_digits((uint64_t)sepax_random_range(&random, 0, CHOICES - 1),
                          {min, min + 1, -1, 0, 1, max - 1, max});
  });
}

// Numbers of which those of A are above those of B, but for the least of A, which is by `depth`
// below the greatest of B, or with a negative depth is not.
inline void draw_depths(sepax_random *random, int64_t low, int64_t high, int64_t number[6]) {
  const int64_t depth = sepax_random_range(random, -2, 1) < 0
                            ? sepax_random_range(random, -2, 2)
                            : sepax_random_range(random, -1, high - low - 2);
  const int64_t least = sepax_random_range(random, low + 1, high - 1 - (depth > 0 ? depth : 0));
  const int64_t greatest = std::max(least + depth, low);
  for (int k = 0; k < 3; k++) {
    number[k] = sepax_random_range(random, std::max(least, greatest) + 1, high);
    number[3 + k] = sepax_random_range(random, low, std::max(std::min(least, greatest) - 1, low));
  }
  number[sepax_random_range(random, 0, 2)] = least;
  number[3 + sepax_random_range(random, 0, 2)] = greatest;
}

// A pair in a plane along y that an edge of A separates, but x does not. A's vertices of least and
// greatest x and B's of least x have an orient2d in x and y of 2^(2 W - 1), the highest bit that
// tells one from 0, or minus that.
inline sepax_pair highest_bit_pair(sepax_random *random) {
  const int64_t high = sepax_word_max(SEPAX_WORD), low = sepax_word_min(SEPAX_WORD);
  const int64_t slope = sepax_random_range(random, -1, 1), sign = sepax_random_range(random, 0, 1);
  const int64_t point[6][2] = {{low, low},
                               {high, low + 1},
                               {sepax_random_range(random, low, high), low},
                               {-1, 1},
                               {sepax_random_range(random, -1, high), high},
                               {sepax_random_range(random, -1, high), high}};
  sepax_pair pair{};
  for (int k = 0; k < 6; k++) {
    coordinate(pair, 3 * k) = (int32_t)point[k][0];
    coordinate(pair, 3 * k + 1) = (int32_t)(sign == 0 ? point[k][1] : -1 - point[k][1]);
    coordinate(pair, 3 * k + 2) = (int32_t)(slope < 0 ? -1 - point[k][0] : slope * point[k][0]);
  }
  return pair_with_normals(pair);
}

// Pairs in a plane along x, y or z, or on a line, that overlap with one vertex each, or touch, or
// do not: where AABBs decide, one order of two coordinates does.
inline Source overlap_source(uint64_t count, uint64_t seed) {
  return counted(count, [random = sepax_random{seed}](uint64_t n) mutable {
    const int64_t high = sepax_word_max(SEPAX_WORD), low = sepax_word_min(SEPAX_WORD);
    if (n % 8 == 7) {
      return highest_bit_pair(&random);
    }
    int64_t direction[3], along[6], above[6];
    for (int64_t &component : direction) {
      component = sepax_random_range(&random, -1, 1);
    }
    const bool line = sepax_random_range(&random, 0, 2) == 0;
    draw_depths(&random, low + 1, high, above);
    for (int64_t &place : along) {
      place = sepax_random_range(&random, -high / 2, high / 2);
    }
    const bool swapped = sepax_random_range(&random, 0, 1) != 0;
    const int first = (int)sepax_random_range(&random, 0, 2);
    sepax_pair pair{};
    for (int k = 0; k < 6; k++) {
      const int of = 3 * (swapped ? (k + 3) % 6 : k); // its x
      const int64_t place = line ? above[k] : along[k];
      coordinate(pair, of + first) = (int32_t)(direction[0] * place);
      coordinate(pair, of + (first + 1) % 3) = (int32_t)(direction[1] * place);
      coordinate(pair, of + (first + 2) % 3) = (int32_t)(line ? direction[2] * place : above[k]);
    }
    return pair_with_normals(pair);
  });
}

// Each coordinate is 0 or a power of two, of either sign: orient2d and orient3d often are one, too,
// and so have a single bit that tells them from 0. Every other pair is in a plane.
inline Source power_source(uint64_t count, uint64_t seed) {
  return counted(count, [random = sepax_random{seed}](uint64_t n) mutable {
    sepax_pair pair{};
    const int64_t copied = sepax_random_range(&random, 0, 2); // z is x, y or 0
    const int64_t least = sepax_random_range(&random, 0, SEPAX_WORD - 1);
    for (int k = 0; k < 18; k++) {
      const int64_t exponent = sepax_random_range(&random, least - 2, SEPAX_WORD - 1);
      const int64_t power = exponent < least ? 0 : -(INT64_C(1) << exponent);
      const bool positive = exponent < SEPAX_WORD - 1 && sepax_random_range(&random, 0, 1) != 0;
      coordinate(pair, k) = (int32_t)(positive ? -power : power);
      if (n % 2 != 0 && k % 3 == 2) {
        coordinate(pair, k) = copied == 2 ? 0 : coordinate(pair, k - 2 + (int)copied);
      }
    }
    return pair_with_normals(pair);
  });
}

#endif
