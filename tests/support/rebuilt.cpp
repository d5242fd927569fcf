// SPDX-License-Identifier: MIT
#include "tests/support/rebuilt.h"

#include <utility>

namespace csgcast::test {

Solid rebuilt(const Solid& solid, std::vector<Solid> children) {
  switch (solid.kind()) {
    case Solid::Kind::unite:
      return unite(std::move(children));
    case Solid::Kind::intersect:
      return intersect(std::move(children));
    case Solid::Kind::subtract:
      return subtract(std::move(children));
    case Solid::Kind::complement:
      return complement(std::move(children.front()));
    case Solid::Kind::transform:
      return transformed(std::move(children.front()), solid.transform());
    case Solid::Kind::part:
      return named(std::move(children.front()), solid.part());
    case Solid::Kind::look:
      return with_look(std::move(children.front()), solid.look());
    default:
      return solid;
  }
}

}  // namespace csgcast::test
