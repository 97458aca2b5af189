// pair_source.h - where the pairs of the Verilator test bench come from.
#ifndef SEPAX_PAIR_SOURCE_H
#define SEPAX_PAIR_SOURCE_H

#include "cli/cli.h"
#include "sepax_params.h"
#include "sepax_vectors.h"

#include <cstdlib>
#include <cstring>

struct Source {
  virtual ~Source() = default;
  virtual uint64_t total() const = 0; // 0: not known beforehand
  virtual bool next(sepax_pair *pair) = 0;
};

[[noreturn]] inline void fail(const sepax_error &error) { std::exit(cli_fail("cosim", &error)); }

class FileSource : public Source {
public:
  explicit FileSource(const char *path)
      : name(path), in(std::strcmp(path, "-") == 0 ? stdin : std::fopen(path, "r")) {
    if (in == nullptr) {
      std::fprintf(stderr, "cosim: %s: cannot be read; give a file of pairs\n", path);
      std::exit(EXIT_ERROR);
    }
  }
  uint64_t total() const override { return 0; }
  bool next(sepax_pair *pair) override {
    sepax_error error{};
    sepax_line line = sepax_pair_read(pair, in, name, &number, SEPAX_WORD, &error);
    if (line == SEPAX_LINE_ERROR) {
      fail(error);
    }
    return line == SEPAX_LINE_PAIR;
  }

private:
  const char *name;
  FILE *in;
  size_t number = 0;
};

class MeshSource : public Source {
public:
  MeshSource(const char *const path[2], const cli_grid &grid) {
    sepax_error error{};
    if (!sepax_scene_load(&scene, path, &grid.grid, grid.file_normals, &error)) {
      fail(error);
    }
  }
  uint64_t total() const override { return (uint64_t)scene.count[0] * scene.count[1]; }
  bool next(sepax_pair *pair) override {
    if (at == total()) {
      return false;
    }
    *pair = sepax_scene_pair(&scene, at / scene.count[1], at % scene.count[1]);
    at++;
    return true;
  }

private:
  sepax_scene scene{};
  uint64_t at = 0;
};

// Seeded hard pairs: one family, or all of them in turn.
class FamilySource : public Source {
public:
  FamilySource(uint64_t pairs, uint64_t seed, const char *only) : random{seed}, pairs(pairs) {
    size_t all = 0;
    size_t chosen = SIZE_MAX;
    for (; sepax_family_name(all) != nullptr; all++) {
      if (only != nullptr && std::strcmp(only, sepax_family_name(all)) == 0) {
        chosen = all;
      }
    }
    if (only != nullptr && chosen == SIZE_MAX) {
      std::fprintf(stderr, "cosim: family '%s' is unknown; sepax vectors --list\n", only);
      std::exit(EXIT_ERROR);
    }
    first = only != nullptr ? chosen : 0;
    families = only != nullptr ? 1 : all;
  }
  uint64_t total() const override { return pairs; }
  bool next(sepax_pair *pair) override {
    if (at == pairs) {
      return false;
    }
    size_t family = first + at++ % families;
    *pair = SEPAX_EXACT ? sepax_family_triangles(family, SEPAX_WORD, &random)
                        : sepax_family_pair(family, SEPAX_WORD, &random);
    return true;
  }

private:
  sepax_random random;
  uint64_t pairs, at = 0;
  size_t first, families;
};

#ifdef SEPAX_EXTENT_A
// Seeded hard pairs of all families in turn, within the design's extents or exceeding them.
class ExtentSource : public Source {
public:
  ExtentSource(uint64_t pairs, uint64_t seed, bool exceeding)
      : random{seed}, pairs(pairs), exceeding(exceeding) {
    while (sepax_family_name(families) != nullptr) {
      families++;
    }
  }
  uint64_t total() const override { return pairs; }
  bool next(sepax_pair *pair) override {
    const int extent[2] = {SEPAX_EXTENT_A, SEPAX_EXTENT_B};
    if (at == pairs) {
      return false;
    }
    *pair = sepax_extent_pair(at++ % families, SEPAX_WORD, extent, exceeding, &random);
    return true;
  }

private:
  sepax_random random;
  uint64_t pairs, at = 0;
  size_t families = 0;
  bool exceeding;
};
#endif

// Coordinate 0 ... 17 of a pair, in the order of a line of text.
inline int32_t &coordinate(sepax_pair *pair, int k) {
  sepax_vec &v = (k < 9 ? pair->a : pair->b).v[k / 3 % 3];
  return k % 3 == 0 ? v.x : k % 3 == 1 ? v.y : v.z;
}

inline void find_normals(sepax_pair *pair) {
  if (!SEPAX_EXACT) { // that architecture has none
    pair->na = sepax_unit_normal(&pair->a, SEPAX_WORD);
    pair->nb = sepax_unit_normal(&pair->b, SEPAX_WORD);
  }
}

// Pair n of the small grid lowest ... lowest + base - 1: coordinate k is the digit of
// base^k in n, plus the lowest.
class GridSource : public Source {
public:
  static constexpr int DIGITS = 18;

  static uint64_t size(int base) {
    uint64_t pairs = 1;
    for (int k = 0; k < DIGITS; k++) {
      pairs *= (uint64_t)base;
    }
    return pairs;
  }

  GridSource(int base, int lowest, uint64_t first, uint64_t count)
      : highest(lowest + base - 1), lowest(lowest), pairs(count) {
    for (int k = 0; k < DIGITS; k++) {
      coordinate(&current, k) = lowest + (int32_t)(first % (uint64_t)base);
      first /= (uint64_t)base;
    }
  }
  uint64_t total() const override { return pairs; }
  bool next(sepax_pair *pair) override {
    if (at == pairs) {
      return false;
    }
    at++;
    *pair = current;
    find_normals(pair);
    for (int k = 0; k < DIGITS; k++) {
      int32_t &digit = coordinate(&current, k);
      if (digit++ < highest) {
        break;
      }
      digit = lowest;
    }
    return true;
  }

private:
  int32_t highest, lowest;
  uint64_t pairs, at = 0;
  sepax_pair current{};
};

// Each coordinate is one of seven at the ends and the middle of the range.
class CornerSource : public Source {
public:
  CornerSource(uint64_t pairs, uint64_t seed) : random{seed}, pairs(pairs) {}
  uint64_t total() const override { return pairs; }
  bool next(sepax_pair *pair) override {
    const int32_t min = sepax_word_min(SEPAX_WORD);
    const int32_t max = sepax_word_max(SEPAX_WORD);
    const int32_t value[] = {min, min + 1, -1, 0, 1, max - 1, max};
    constexpr int64_t CHOICES = 1628413597910449; // 7^18
    if (at == pairs) {
      return false;
    }
    at++;
    *pair = {};
    uint64_t draw = (uint64_t)sepax_random_range(&random, 0, CHOICES - 1);
    for (int k = 0; k < 18; k++) {
      coordinate(pair, k) = value[draw % 7];
      draw /= 7;
    }
    find_normals(pair);
    return true;
  }

private:
  sepax_random random;
  uint64_t pairs, at = 0;
};

#endif
