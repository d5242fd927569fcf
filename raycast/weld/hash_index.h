// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace csgcast::detail {

/// Finds the entries of a table by their hashes. Entries are numbered from 0 and live elsewhere. A slot takes eight
/// bytes, at most three quarters of the slots are taken, and probing is linear.
class HashIndex {
 public:
  /// The number of the entry with this hash for which `same(number)` holds. If there is none, `next` is added and
  /// returned. `next` is the number of the entry that the caller is about to append.
  template <class Same>
  std::uint32_t find_or_add(std::uint64_t hash, std::uint32_t next, Same&& same) {
    if (4 * (count_ + 1) > 3 * slots_.size()) grow();
    const auto tag = static_cast<std::uint32_t>(hash >> 32);
    std::size_t i = tag & (slots_.size() - 1);
    for (; slots_[i].number != none; i = (i + 1) & (slots_.size() - 1)) {
      if (slots_[i].tag == tag && same(slots_[i].number)) return slots_[i].number;
    }
    slots_[i] = {tag, next};
    ++count_;
    return next;
  }

  /// Forgets all entries, and gives the memory back.
  void clear() { *this = HashIndex(); }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  static constexpr std::size_t least = 16;
  struct Slot {
    std::uint32_t tag = 0;  // the upper half of the hash
    std::uint32_t number = none;
  };

  void grow() {
    std::vector<Slot> larger(slots_.empty() ? least : 2 * slots_.size());
    for (const Slot& slot : slots_) {
      if (slot.number == none) continue;
      std::size_t i = slot.tag & (larger.size() - 1);
      while (larger[i].number != none) i = (i + 1) & (larger.size() - 1);
      larger[i] = slot;
    }
    slots_ = std::move(larger);
  }

  std::vector<Slot> slots_;  // their number is a power of two
  std::size_t count_ = 0;
};

}  // namespace csgcast::detail
