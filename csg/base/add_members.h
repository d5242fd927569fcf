// SPDX-License-Identifier: MIT
#pragma once

namespace csgcast {

/// Adds the named members of one object to the same members of another, and returns the other.
template <auto... Members, class Counts>
constexpr Counts& add_members(Counts& to, const Counts& more) {
  ((to.*Members += more.*Members), ...);
  return to;
}

}  // namespace csgcast
