// SPDX-License-Identifier: MIT
// multiplier.cpp - checks a verilated generated multiplier against the product of 128-bit
// integers: operands that are corners, powers of two and their neighbours, and random.
//
// Compiled with MODEL=Vsepax_mul_AxB, A_W, B_W, P_W, LATENCY, and DIGITS, LESS: digits of b that
// count so much less, but for the highest, which is in -2 ... 2; 0: a plain product.
#define STRINGIFY(name) #name
#define HEADER(name) STRINGIFY(name.h)
#include HEADER(MODEL)
#include "sepax_vectors.h"
#include "verilated.h"

#include <cstdio>
#include <cstdlib>
#include <type_traits>

namespace {

using Wide = unsigned __int128;

Wide low(Wide value, int bits) { return bits >= 128 ? value : value & (((Wide)1 << bits) - 1); }

__int128 extend(Wide value, int bits) {
  return (__int128)(low(value, bits) << (128 - bits)) >> (128 - bits);
}

// A port is an integer, or an array of 32-bit words where it is wider than 64 bits.
template <typename Port> void set(Port &port, Wide value) {
  if constexpr (std::is_integral<Port>::value) {
    port = (Port)value;
  } else {
    for (int i = 0; i < (int)(sizeof port / sizeof port[0]); i++) {
      port[i] = (uint32_t)(value >> (32 * i));
    }
  }
}

template <typename Port> Wide get(const Port &port) {
  if constexpr (std::is_integral<Port>::value) {
    return port;
  } else {
    Wide value = 0;
    for (int i = 0; i < (int)(sizeof port / sizeof port[0]); i++) {
      value |= (Wide)port[i] << (32 * i);
    }
    return value;
  }
}

Wide operand(sepax_random *random, int bits) {
  uint64_t how = sepax_random_next(random);
  Wide value = ((Wide)sepax_random_next(random) << 64) | sepax_random_next(random);
  if (how % 4 == 0) { // a power of two, or near one, or its negative
    value = ((Wide)1 << (how / 4 % (unsigned)bits)) + (how / 1024 % 3) - 1;
    value = how / 4096 % 2 ? value : -value;
  } else if (how % 4 == 1) { // short
    value >>= 64 + how / 4 % 64;
    value = how / 4096 % 2 ? value : -value;
  }
  return low(value, bits);
}

} // namespace

int main(int argc, char **argv) {
  uint64_t count = argc > 1 ? strtoull(argv[1], nullptr, 10) : 1000000;
  sepax_random random = {A_W * 1000 + B_W};
  MODEL top;
  Wide expected[LATENCY + 1] = {};
  uint64_t wrong = 0;
  Wide offset = 0;
  for (int i = 1; i < DIGITS; i++) {
    offset = 4 * offset + LESS;
  }
  for (uint64_t n = 0; n < count + LATENCY; n++) {
    Wide a = operand(&random, A_W);
    Wide b = operand(&random, B_W);
    if (DIGITS > 0 && B_W > 2 * DIGITS) { // what a factor of 2 DIGITS bits can be
      b = low((Wide)extend(b, 2 * DIGITS) + offset, B_W);
    }
    set(top.a, a);
    set(top.b, b);
    for (int i = LATENCY; i > 0; i--) {
      expected[i] = expected[i - 1];
    }
    expected[0] = low((Wide)(extend(a, A_W)) * ((Wide)extend(b, B_W) - offset), P_W);
#if LATENCY > 0
    top.clk = 0;
    top.eval();
    if (n >= LATENCY && low(get(top.p), P_W) != expected[LATENCY]) {
      wrong++;
    }
    top.clk = 1;
    top.eval();
#else
    top.eval();
    wrong += low(get(top.p), P_W) != expected[0];
#endif
  }
  std::printf("%dx%d modulo 2^%d, %d digits less %d, latency %d: %llu products, %llu wrong\n", A_W,
              B_W, P_W, DIGITS, LESS, LATENCY, (unsigned long long)count,
              (unsigned long long)wrong);
  return wrong == 0 && count > 0 ? 0 : 1;
}
