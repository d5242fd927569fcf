// SPDX-License-Identifier: MIT
#include "csg/base/shared.h"

#include <atomic>

namespace csgcast {

static_assert(alignof(std::size_t) >= std::atomic_ref<std::size_t>::required_alignment);

void Counted::add_owner() { std::atomic_ref(owners_).fetch_add(1, std::memory_order_relaxed); }

void Counted::drop_owner() {
  // Before the last owner deletes the value, it sees everything that the other owners did with it.
  if (has_one_owner() || std::atomic_ref(owners_).fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

bool Counted::has_one_owner() const {
  // A reference to a constant needs C++26. Nothing is written here.
  return std::atomic_ref(const_cast<std::size_t&>(owners_)).load(std::memory_order_acquire) == 1;
}

}  // namespace csgcast
