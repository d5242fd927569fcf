// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "raycast/detail/near_pairs.h"
#include "raycast/detail/provenance.h"
#include "raycast/hit.h"
#include "raycast/welding.h"

namespace csgcast::detail {

/// What a surface becomes: another one, or itself.
struct Replacement {
  std::uint32_t surface;
  bool flipped = false;  ///< its canonical form has the other sign
};

/// Welds the surfaces of one scene. What it does depends on their forms and where they come from, not on their order:
/// the simplest form of those that nearly coincide takes the others in, and each moves at most as far as their own
/// numbers are uncertain.
class Welder {
 public:
  /// A surface and the leaves that own it.
  struct Candidate {
    const QuadricForm* form;
    std::vector<Provenance::Source> sources;
  };

  /// `everything` holds all bounded leaves, and is finite.
  Welder(const Provenance& provenance, const Welding& welding, const Box& everything);

  /// One replacement a surface; adds to the report.
  std::vector<Replacement> run(std::span<const Candidate> candidates, WeldReport& report);

 private:
  struct Surface {
    const QuadricForm* form;
    Provenance::Source source;  // of those that own it the one known worst
    std::size_t bits;
  };
  // A surface at a place, while it is compared.
  struct Member {
    std::uint32_t surface;
    RegionForm form;
    double distance;
  };

  void collect(std::span<const Candidate> candidates);
  FormError error(std::uint32_t surface, const RegionForm& form, const Region& region, Provenance::ChainId known) const;
  FormError full_error(Provenance::Source source, const RegionForm& form, const Region& region) const;
  double distance(const Member& a, const Member& b, const Region& region);
  Box box_of(std::uint32_t surface) const;
  void weld_group(std::vector<std::uint32_t> group, std::vector<Replacement>& replacements, WeldReport& report);
  void gather(const Member& leader, const Region& region, std::vector<Member> members,
              std::vector<Replacement>& replacements, WeldReport& report);
  void list_near_misses(std::span<const Candidate> candidates, std::span<const Replacement> replacements,
                        WeldReport& report);
  std::optional<NearMiss> near_miss(const Candidate& a, const Candidate& b, double most);
  bool precedes(std::uint32_t a, std::uint32_t b) const;

  const Provenance& provenance_;
  Welding welding_;
  Box everything_;
  double tolerance_ = 0;  // of by_hand, in the scene's unit of length
  std::vector<Surface> surfaces_;
  NearPairs near_;
  std::uint64_t work_ = 0;
  std::uint64_t most_work_ = 0;
};

}  // namespace csgcast::detail
