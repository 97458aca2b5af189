/* polygon.c - a stub. */
#include "reader/polygon.h"

bool sepax__polygon_divide(const double (*corner)[3], size_t count, size_t (*triangle)[3],
                           bool *bent) {
  (void)corner;
  *bent = false;
  for (size_t n = 1; n + 1 < count; n++) {
    triangle[n - 1][0] = 0;
    triangle[n - 1][1] = n;
    triangle[n - 1][2] = n + 1;
  }
  return true;
}
