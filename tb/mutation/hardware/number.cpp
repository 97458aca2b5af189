// SPDX-License-Identifier: MIT
// number.cpp - which mutant of a netlist is simulated: that of SEPAX_MUTANT, 0: none.
#include <cstdlib>

extern "C" int sepax_mutant() {
  const char *number = std::getenv("SEPAX_MUTANT");
  return number == nullptr ? 0 : std::atoi(number);
}
