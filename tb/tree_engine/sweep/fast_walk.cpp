// SPDX-License-Identifier: MIT
// fast_walk.cpp - see fast_walk.h. All 16 children of a node are turned at once; 4 turned boxes
// meet 16 boxes at once; the vertices of a leaf are turned at once; B's triangle meets 16 of A.
#include "fast_walk.h"

#include <algorithm>
#include <cstring>

#if defined __x86_64__ && defined __GNUC__
#pragma GCC target("avx2,fma,avx512f,avx512bw,avx512dq,avx512vl,avx512vbmi,avx512vnni")
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized" /* in immintrin.h: GCC's bug 105593 */
#include <immintrin.h>

namespace {

constexpr size_t NEAR = 512;   /* pairs that are judged at once */
constexpr size_t STACK = 4096; /* entries; the walk is depth-first */

int32_t word32(const uint8_t *from) {
  int32_t value;
  memcpy(&value, from, sizeof value);
  return value;
}

/* The head of a node. */
struct Head {
  const uint8_t *byte;
  int exponent[3], origin[3], children, level, beats;
  uint32_t first, record;

  explicit Head(const uint8_t *from) : byte(from) {
    const auto word = uint32_t(word32(from + 12));
    for (int i = 0; i < 3; i++) {
      exponent[i] = int(word >> (4 * i) & 15);
      origin[i] = int(uint32_t(word32(from + 4 * i)) << 14) >> 14;
    }
    children = int(word >> 12 & 15) + 1;
    level = int(word >> 16 & 15);
    beats = int(word >> 20 & 15) + 1;
    first = uint32_t(word32(from + 16));
    record = uint32_t(word32(from + 20));
  }
};

struct Entry {
  uint32_t s, t;
  uint16_t mask;
  uint8_t side;
};

uint16_t half(unsigned mask) {
  const int ones = __builtin_popcount(mask);
  return ones > 8 ? 0 : uint16_t(mask);
}

/* Vertices of a leaf as columns, and the numbers of those of a triangle. */
struct Leaf {
  alignas(64) int32_t vertex[3][32];
  alignas(64) int32_t corner[3][16];
  uint32_t number;
};

class Fast : public FastWalk {
public:
  Fast(const sepax_tree *a, const sepax_tree *b) {
    size_t bytes;
    image[0] = sepax_tree_image(a, &bytes);
    image[1] = sepax_tree_image(b, &bytes);
    for (int k = 0; k < 3; k++) {
      for (int i = 0; i < 3; i++) {
        columns[0].c[k][i] = column[3 * k + i];
        columns[1].c[k][i] = column[9 + 3 * k + i];
      }
    }
    for (int j = 0; j < 16; j++) {
      for (int i = 0; i < 6; i++) {
        by_axis[i / 4][16 * (i % 4) + j] = uint8_t(32 + 6 * j + i);
      }
      for (int k = 0; k < 3; k++) {
        ends[k][2 * j] = uint8_t(32 + 6 * j + k);
        ends[k][2 * j + 1] = uint8_t(35 + 6 * j + k);
      }
      for (int g = 0; g < 4; g++) {
        std::fill(repeat[g] + 16 * (j % 4), repeat[g] + 16 * (j % 4) + 16, uint8_t(4 * g + j % 4));
      }
    }
  }

  void ask(const sepax_tree_pose &asked, TreePairs &list) override {
    pose = &asked;
    found = &list;
    leaf[0].number = leaf[1].number = UINT32_MAX;
    const Head root(image[1]);
    top = 0;
    push(0, 0, half((1U << root.children) - 1), 0);
    while (top > 0) {
      const Entry e = stack[--top];
      finish(e);
    }
    judge();
  }

private:
  void push(uint32_t s, uint32_t t, unsigned mask, int side) {
    stack[top++] = {s, t, uint16_t(mask), uint8_t(side)};
  }

  /* Pairs of low, high + 1 of the children of S in 16-bit words, or 16 times its own box. */
  void load_boxes(const Head &s, bool own, __m512i box[3]) const {
    const __m512i one = _mm512_set1_epi32(0x10000);
    for (int k = 0; k < 3; k++) {
      if (own) {
        const int h = int8_t(s.byte[28 + k]);
        box[k] = _mm512_set1_epi32(int(uint32_t(uint16_t(-1 - h)) | uint32_t(h + 1) << 16));
      } else {
        const __m512i which =
            _mm512_castsi256_si512(_mm256_load_si256(reinterpret_cast<const __m256i *>(ends[k])));
        const __m512i bytes = _mm512_permutex2var_epi8(_mm512_loadu_si512(s.byte), which,
                                                       _mm512_loadu_si512(s.byte + 64));
        box[k] = _mm512_add_epi16(_mm512_cvtepi8_epi16(_mm512_castsi512_si256(bytes)), one);
      }
    }
  }

  /* Turned boxes in cells of T, saturated to int8; the bits of those that are beyond. */
  __mmask16 turn(const sepax_tree_side &side, const Head &s, const Head &t, const __m512i box[3],
                 __m128i low[3], __m128i high[3]) const {
    const int64_t far = 1 << 20;
    const int e_max = std::max(s.exponent[0], std::max(s.exponent[1], s.exponent[2]));
    __mmask16 beyond = 0;
    for (int i = 0; i < 3; i++) {
      const int g = std::max(t.exponent[i], e_max);
      int64_t x = side.shift[i] - int64_t(t.origin[i]) * (1 << 20);
      __m512i up[3];
      __m512i down[3];
      for (int k = 0; k < 3; k++) {
        const int by = 10 + g - s.exponent[k];
        const int n = int((int64_t(side.matrix[i][k]) + (int64_t(1) << (by - 1))) >> by);
        const uint32_t above = uint16_t(std::max(n, 0));
        const uint32_t below = uint16_t(std::min(n, 0));
        x += int64_t(side.matrix[i][k]) * s.origin[k];
        up[k] = _mm512_set1_epi32(int(above | below << 16));
        down[k] = _mm512_set1_epi32(int(below | above << 16));
      }
      const int64_t d = x >> (10 + g);
      const int64_t slack = 192 + ((int64_t(side.sigma[i]) + (1 << g) - 1) >> g);
      __m512i lo = _mm512_set1_epi32(int(std::clamp(d - slack, -far, far - 1)));
      __m512i hi = _mm512_set1_epi32(int(std::clamp(d + 1 + slack, -far, far - 1)));
      for (int k = 0; k < 3; k++) {
        lo = _mm512_dpwssd_epi32(lo, box[k], up[k]);
        hi = _mm512_dpwssd_epi32(hi, box[k], down[k]);
      }
      const int by = 10 + t.exponent[i] - g;
      const __m128i shift = _mm_cvtsi32_si128(std::abs(by));
      lo = by >= 0 ? _mm512_sra_epi32(lo, shift) : _mm512_sll_epi32(lo, shift);
      hi = by >= 0 ? _mm512_sra_epi32(hi, shift) : _mm512_sll_epi32(hi, shift);
      beyond |= _mm512_cmpgt_epi32_mask(lo, _mm512_set1_epi32(INT8_MAX)) |
                _mm512_cmplt_epi32_mask(hi, _mm512_set1_epi32(INT8_MIN));
      low[i] = _mm512_cvtsepi32_epi8(lo);
      high[i] = _mm512_cvtsepi32_epi8(hi);
    }
    return beyond;
  }

  /* hit[i], bit j: box i hits child j of T; for i in the mask. */
  void lanes(const Head &t, unsigned mask, const __m128i low[3], const __m128i high[3],
             uint16_t hit[16]) const {
    const __m512i t0 = _mm512_loadu_si512(t.byte);
    const __m512i t1 = _mm512_loadu_si512(t.byte + 64);
    const __m512i b0 = _mm512_permutex2var_epi8(t0, _mm512_load_si512(by_axis[0]), t1);
    const __m512i b1 = _mm512_permutex2var_epi8(t0, _mm512_load_si512(by_axis[1]), t1);
    const __m512i t_low[3] = {_mm512_shuffle_i32x4(b0, b0, 0x00),
                              _mm512_shuffle_i32x4(b0, b0, 0x55),
                              _mm512_shuffle_i32x4(b0, b0, 0xAA)};
    const __m512i t_high[3] = {_mm512_shuffle_i32x4(b0, b0, 0xFF),
                               _mm512_shuffle_i32x4(b1, b1, 0x00),
                               _mm512_shuffle_i32x4(b1, b1, 0x55)};
    for (int g = 0; g < 4; g++) {
      __mmask64 hits = 0;
      if ((mask >> (4 * g) & 15) != 0) {
        const __m512i of = _mm512_load_si512(repeat[g]);
        hits = 0x0001000100010001U * ((1ULL << t.children) - 1);
        for (int i = 0; i < 3; i++) {
          const __m512i l = _mm512_shuffle_epi8(_mm512_broadcast_i32x4(low[i]), of);
          const __m512i h = _mm512_shuffle_epi8(_mm512_broadcast_i32x4(high[i]), of);
          hits = _mm512_mask_cmple_epi8_mask(hits, l, t_high[i]);
          hits = _mm512_mask_cmpge_epi8_mask(hits, h, t_low[i]);
        }
      }
      memcpy(hit + 4 * g, &hits, sizeof hits);
    }
    const __m256i all = _mm256_load_si256(reinterpret_cast<const __m256i *>(hit));
    _mm256_store_si256(reinterpret_cast<__m256i *>(hit),
                       _mm256_maskz_mov_epi16(__mmask16(mask), all));
  }

  void finish(const Entry &e) {
    const Head s(image[e.side == 0] + 128 * size_t(e.s));
    const Head t(image[e.side] + 128 * size_t(e.t));
    __m512i box[3];
    __m128i low[3];
    __m128i high[3];
    load_boxes(s, e.mask == 0, box);
    const unsigned beyond = turn(pose->side[e.side], s, t, box, low, high);
    const unsigned mask = (e.mask == 0 ? 1U : e.mask) & ~beyond;
    if (mask == 0) {
      return;
    }
    alignas(64) uint16_t hit[16];
    alignas(64) uint16_t column[16];
    lanes(t, mask, low, high, hit);
    if (e.mask == 0) {
      if (hit[0] != 0) {
        push(e.t, e.s, hit[0], 1 - e.side);
      }
    } else if (s.level > 0) {
      for (uint32_t i = 0; i < 16; i++) {
        if (hit[i] != 0) {
          push(e.t, s.first + i, half(hit[i]), 1 - e.side);
        }
      }
    } else if (t.level > 0) {
      turn_masks(hit, column);
      for (uint32_t j = 0; j < 16; j++) {
        if (column[j] != 0) {
          push(e.s, t.first + j, half(column[j]), e.side);
        }
      }
    } else if (e.side == 0) {
      rows(t, e.t, s, e.s, hit);
    } else {
      turn_masks(hit, column);
      rows(s, e.s, t, e.t, column);
    }
  }

  static void turn_masks(const uint16_t hit[16], uint16_t column[16]) {
    const __m256i all = _mm256_load_si256(reinterpret_cast<const __m256i *>(hit));
    for (int j = 0; j < 16; j++) {
      column[j] = _mm256_test_epi16_mask(all, _mm256_set1_epi16(short(1 << j)));
    }
  }

  /* The record of a leaf; false if it is that of the last time. */
  bool load(int body, const Head &head, uint32_t number) {
    Leaf &l = leaf[body];
    if (l.number == number) {
      return false;
    }
    l.number = number;
    const uint8_t *record = image[body] + 16 * size_t(head.record);
    const sepax_tree_side &side = pose->side[0];
    for (int from = 0; from < 2 * head.beats - 4; from += 8) {
      const int left = std::min(2 * head.beats - 4 - from, 8);
      const __m512i w = _mm512_maskz_loadu_epi64(__mmask8((1 << left) - 1), record + 32 + 8 * from);
      const __m512i v[3] = {_mm512_srai_epi64(_mm512_slli_epi64(w, 43), 43),
                            _mm512_srai_epi64(_mm512_slli_epi64(w, 22), 43),
                            _mm512_srai_epi64(_mm512_slli_epi64(w, 1), 43)};
      for (int i = 0; i < 3; i++) {
        __m256i p = _mm512_cvtepi64_epi32(v[i]);
        if (body == 1) { /* every sum is below 2^53 */
          __m512d sum = _mm512_set1_pd(double(side.shift[i]));
          for (int k = 0; k < 3; k++) {
            const __m512d m = _mm512_set1_pd(double(side.matrix[i][k]));
            sum = _mm512_fmadd_pd(m, _mm512_cvtepi64_pd(v[k]), sum);
          }
          p = _mm512_cvtpd_epi32(_mm512_floor_pd(_mm512_mul_pd(sum, _mm512_set1_pd(0x1p-20))));
        }
        _mm256_store_si256(reinterpret_cast<__m256i *>(&l.vertex[i][from]), p);
      }
    }
    const __m512i numbers =
        _mm512_cvtepu16_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i *>(record)));
    for (unsigned k = 0; k < 3; k++) {
      _mm512_store_si512(
          l.corner[k], _mm512_and_si512(_mm512_srli_epi32(numbers, 5 * k), _mm512_set1_epi32(31)));
    }
    return true;
  }

  void load_a(const Head &head, uint32_t number) {
    if (!load(0, head, number)) {
      return;
    }
    const Leaf &l = leaf[0];
    for (int i = 0; i < 3; i++) {
      const __m512i v0 = _mm512_load_si512(l.vertex[i]);
      const __m512i v1 = _mm512_load_si512(l.vertex[i] + 16);
      __m512i x[3];
      for (int k = 0; k < 3; k++) {
        x[k] = _mm512_permutex2var_epi32(v0, _mm512_load_si512(l.corner[k]), v1);
      }
      low_a[i] = _mm512_min_epi32(x[0], _mm512_min_epi32(x[1], x[2]));
      high_a[i] = _mm512_max_epi32(x[0], _mm512_max_epi32(x[1], x[2]));
    }
  }

  /* mask[b]: the triangles of leaf A that meet triangle b of leaf B. */
  void rows(const Head &a, uint32_t number_a, const Head &b, uint32_t number_b,
            const uint16_t mask[16]) {
    bool loaded = false;
    for (int n = 0; n < 16; n++) {
      if (mask[n] == 0) {
        continue;
      }
      if (!loaded) {
        load_a(a, number_a);
        load(1, b, number_b);
        loaded = true;
      }
      __mmask16 near = mask[n];
      for (int i = 0; i < 3; i++) {
        const int32_t *v = leaf[1].vertex[i];
        const int32_t p = v[leaf[1].corner[0][n]];
        const int32_t q = v[leaf[1].corner[1][n]];
        const int32_t r = v[leaf[1].corner[2][n]];
        const __m512i low = _mm512_set1_epi32(std::min(p, std::min(q, r)));
        const __m512i high = _mm512_set1_epi32(std::max(p, std::max(q, r)));
        near = _mm512_mask_cmple_epi32_mask(near, low_a[i], high);
        near = _mm512_mask_cmpge_epi32_mask(near, high_a[i], low);
      }
      for (unsigned left = near; left != 0; left &= left - 1) {
        keep(a.first, __builtin_ctz(left), b.first, n);
      }
    }
  }

  void keep(uint32_t first_a, int a, uint32_t first_b, int b) {
    for (int k = 0; k < 3; k++) {
      for (int i = 0; i < 3; i++) {
        column[3 * k + i][waiting] = leaf[0].vertex[i][leaf[0].corner[k][a]];
        column[9 + 3 * k + i][waiting] = leaf[1].vertex[i][leaf[1].corner[k][b]];
      }
    }
    pair[waiting++] = {first_a + uint32_t(a), first_b + uint32_t(b)};
    if (waiting == NEAR) {
      judge();
    }
  }

  void judge() {
    uint64_t bits[NEAR / 64];
    sepax_exact_pairs(SEPAX_SIMD_BEST, &columns[0], &columns[1], waiting, bits);
    for (size_t w = 0; w < (waiting + 63) / 64; w++) {
      for (uint64_t left = bits[w]; left != 0; left &= left - 1) {
        found->push_back(pair[64 * w + size_t(__builtin_ctzll(left))]);
      }
    }
    waiting = 0;
  }

  const uint8_t *image[2];
  const sepax_tree_pose *pose = nullptr;
  TreePairs *found = nullptr;
  Entry stack[STACK];
  size_t top = 0, waiting = 0;
  Leaf leaf[2] = {};
  __m512i low_a[3], high_a[3];
  alignas(64) uint8_t by_axis[2][64] = {}, ends[3][64] = {}, repeat[4][64] = {};
  alignas(64) int32_t column[18][NEAR];
  sepax_columns columns[2];
  std::pair<uint32_t, uint32_t> pair[NEAR];
};

} // namespace

std::unique_ptr<FastWalk> make_fast_walk(const sepax_tree *a, const sepax_tree *b) {
  const bool runs = __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512vbmi") &&
                    __builtin_cpu_supports("avx512vnni");
  return runs ? std::make_unique<Fast>(a, b) : nullptr;
}
#else
std::unique_ptr<FastWalk> make_fast_walk(const sepax_tree *, const sepax_tree *) { return nullptr; }
#endif
