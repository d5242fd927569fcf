// SPDX-License-Identifier: MIT
#include "csg/text/statement/detail/operator_statements.h"

#include <utility>

namespace csgcast::text {

Combine make_union(const Call&) { return unite; }

Combine make_render(const Call& call) {
  call.number("convexity");  // a hint for drawing: only its type matters
  return unite;
}

Combine make_difference(const Call&) { return subtract; }

Combine make_intersection(const Call&) { return intersect; }

Combine make_complement(const Call&) {
  return [](std::vector<Solid> children) { return complement(unite(std::move(children))); };
}

Combine make_part(const Call& call) {
  const auto name = call.string("name");
  if (!name) call.missing("name", "a \"string\"");
  const PartName part{*name, call.number_or("density", 1)};
  call.require(broken_rule(part));
  return [part](std::vector<Solid> children) { return named(unite(std::move(children)), part); };
}

}  // namespace csgcast::text
