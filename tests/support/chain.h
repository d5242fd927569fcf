// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "csg/solid/solid.h"

namespace csgcast::test {

/// A step of a chain: what a solid is joined with, and how.
struct Link {
  enum class Op : std::uint8_t { unite, subtract, intersect };
  Op op;
  Solid solid;
};

/// The chain as a tree as deep as it is long. The first link is united with nothing.
inline Solid nested(const std::vector<Link>& links) {
  Solid solid = links.front().solid;
  for (auto link = links.begin() + 1; link != links.end(); ++link) {
    solid = link->op == Link::Op::unite      ? solid + link->solid
            : link->op == Link::Op::subtract ? solid - link->solid
                                             : (solid & link->solid);
  }
  return solid;
}

/// The same solid as a union of products: each that is united, within all that intersect it later and less all that are
/// subtracted later.
inline Solid flat(const std::vector<Link>& links) {
  std::vector<Solid> products;
  std::vector<Solid> within, without;
  for (auto link = links.rbegin(); link != links.rend(); ++link) {
    if (link->op == Link::Op::intersect) within.push_back(link->solid);
    if (link->op == Link::Op::subtract) without.push_back(link->solid);
    if (link->op != Link::Op::unite) continue;
    std::vector<Solid> factors = within;
    factors.push_back(link->solid);
    std::vector<Solid> parts = without;
    parts.insert(parts.begin(), factors.size() > 1 ? intersect(std::move(factors)) : link->solid);
    products.push_back(parts.size() > 1 ? subtract(std::move(parts)) : parts.front());
  }
  return products.size() > 1 ? unite(std::move(products)) : products.front();
}

}  // namespace csgcast::test
