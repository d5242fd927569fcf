// SPDX-License-Identifier: MIT
#include "tests/support/rounded_leaves.h"

#include <array>
#include <utility>
#include <vector>

#include "tests/support/rebuilt.h"

namespace csgcast::test {
namespace {

using Product = std::array<long double, 12>;

Product product(const Product& outer, const Transform& inner) {
  Product result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      long double sum = column == 3 ? outer[4 * row + 3] : 0;
      for (std::size_t k = 0; k < 3; ++k) sum += outer[4 * row + k] * inner(k, column);
      result[4 * row + column] = sum;
    }
  }
  return result;
}

Solid rounded(const Solid& solid, const Product& above) {
  if (solid.kind() == Solid::Kind::leaf) {
    Transform m;
    for (std::size_t i = 0; i < above.size(); ++i) m.entry[i] = static_cast<double>(above[i]);
    return transformed(solid, m);
  }
  if (solid.kind() == Solid::Kind::transform) return rounded(solid.children()[0], product(above, solid.transform()));
  std::vector<Solid> children;
  for (const Solid& child : solid.children()) children.push_back(rounded(child, above));
  return rebuilt(solid, std::move(children));
}

}  // namespace

Point image(const Transform& m, Point p) {
  Point result;
  for (std::size_t row = 0; row < 3; ++row)
    result[row] = m(row, 0) * p.x + m(row, 1) * p.y + m(row, 2) * p.z + m(row, 3);
  return result;
}

Solid with_rounded_leaves(const Solid& solid, const Transform& world_from_solid) {
  Product above{};
  for (std::size_t i = 0; i < above.size(); ++i) above[i] = world_from_solid.entry[i];
  return rounded(solid, above);
}

}  // namespace csgcast::test
