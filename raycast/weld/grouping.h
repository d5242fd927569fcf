// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace csgcast::detail {

/// The numbers below a count, which can be joined into groups.
class Grouping {
 public:
  using Groups = std::vector<std::vector<std::uint32_t>>;

  explicit Grouping(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t x = root_of(a), y = root_of(b);
    parent_[std::max(x, y)] = std::min(x, y);
  }

  /// The groups in ascending order. They contain only numbers i for which wanted(i) is true. A group with fewer than
  /// two such numbers is left out.
  template <class Wanted>
  Groups groups(Wanted&& wanted) {
    std::vector<std::uint32_t> count(parent_.size());  // by root: the size of its group
    for (std::uint32_t i = 0; i < parent_.size(); ++i) {
      if (wanted(i)) ++count[root_of(i)];
    }
    Groups groups;
    std::vector<std::uint32_t> place(parent_.size());  // by root: the index of its group in `groups`
    for (std::uint32_t i = 0; i < parent_.size(); ++i) {
      if (count[i] < 2) continue;
      place[i] = static_cast<std::uint32_t>(groups.size());
      groups.emplace_back().reserve(count[i]);
    }
    for (std::uint32_t i = 0; i < parent_.size(); ++i) {
      if (wanted(i) && count[root_of(i)] >= 2) groups[place[root_of(i)]].push_back(i);
    }
    return groups;
  }

 private:
  std::uint32_t root_of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  std::vector<std::uint32_t> parent_;
};

}  // namespace csgcast::detail
