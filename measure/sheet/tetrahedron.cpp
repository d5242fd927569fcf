// SPDX-License-Identifier: MIT
#include "measure/sheet/tetrahedron.h"

namespace csgcast::detail {

std::array<Tetrahedron, 5> tetrahedra_of_box(Vector half) {
  const auto corner = [&](unsigned bits) {
    return Vector{(bits & 1) != 0 ? half.x : -half.x, (bits & 2) != 0 ? half.y : -half.y,
                  (bits & 4) != 0 ? half.z : -half.z};
  };
  return {
      Tetrahedron{corner(0), corner(1), corner(2), corner(4)}, Tetrahedron{corner(3), corner(2), corner(1), corner(7)},
      Tetrahedron{corner(5), corner(1), corner(4), corner(7)}, Tetrahedron{corner(6), corner(4), corner(2), corner(7)},
      Tetrahedron{corner(1), corner(2), corner(4), corner(7)}};
}

}  // namespace csgcast::detail
