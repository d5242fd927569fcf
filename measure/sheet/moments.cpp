// SPDX-License-Identifier: MIT
#include "measure/sheet/moments.h"

namespace csgcast::detail {

Moments moved(const Moments& m, Vector by) {
  Moments result = m;
  for (std::size_t i = 0; i < 3; ++i) result.first[i] += by[i] * m.volume;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = Moments::pair[k];
    result.second[k] += by[i] * m.first[j] + by[j] * m.first[i] + by[i] * by[j] * m.volume;
  }
  return result;
}

Moments box_moments(Vector half) {
  Moments result;
  result.volume = 8 * half.x * half.y * half.z;
  for (std::size_t i = 0; i < 3; ++i) result.second[i] = result.volume * half[i] * half[i] / 3;
  return result;
}

}  // namespace csgcast::detail
