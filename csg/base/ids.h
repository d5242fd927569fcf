// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <optional>  // for std::hash, which <functional> has too, at four times the length

namespace csgcast {

/// An index into one particular table; ids of different tables do not mix. A default-made id is not valid.
template <class Tag>
class Id {
 public:
  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t index) : index_(index) {}

  constexpr bool valid() const { return index_ != none; }
  constexpr std::uint32_t index() const { return index_; }
  friend constexpr auto operator<=>(Id, Id) = default;

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  std::uint32_t index_ = none;
};

using SurfaceId = Id<struct SurfaceTag>;
using LeafId = Id<struct LeafTag>;
using NodeId = Id<struct NodeTag>;
using PartId = Id<struct PartTag>;
using RegionId = Id<struct RegionTag>;
using LookId = Id<struct LookTag>;

}  // namespace csgcast

template <class Tag>
struct std::hash<csgcast::Id<Tag>> {
  std::size_t operator()(csgcast::Id<Tag> id) const noexcept { return id.index(); }
};
