// SPDX-License-Identifier: MIT
#include "tests/stress/families.h"

#include <iterator>

#include "tests/stress/family_lists.h"

namespace csgcast::stress {

std::span<const Family> families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> list;
    for (const auto part :
         {box_families, curved_families, quadric_families, scale_families, extreme_families, tree_families}) {
      std::vector<Family> some = part();
      list.insert(list.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
    }
    return list;
  }();
  return all;
}

}  // namespace csgcast::stress
