// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "csg/exact/packed_form.h"
#include "csg/solid/leaf_shape.h"
#include "raycast/line/crossing.h"
#include "raycast/weld/near_faces.h"
#include "raycast/weld/near_pairs.h"
#include "raycast/weld/provenance.h"
#include "raycast/weld/welding.h"

namespace csgcast::detail {

/// The surface that another one is replaced by. A surface may stay itself.
struct Replacement {
  std::uint32_t surface;
  bool flipped = false;  ///< true if its canonical form has the other sign
};

/// Welds the surfaces of one scene. If several surfaces nearly coincide, the one with the simplest form takes the
/// others in. Each moves at most as far as the numbers behind it are uncertain. The result depends on the forms and
/// where they come from, not on their order.
class Welder {
 public:
  /// A surface and the leaves that own it.
  struct Candidate {
    const PackedForm* form;
    std::span<const Provenance::Source> sources;
  };

  /// `everything` holds all bounded leaves. If the box is not finite, the scene has no size.
  Welder(const Provenance& provenance, const Welding& welding, const Box& everything);

  /// Returns one replacement for each surface, and adds to the report.
  std::vector<Replacement> run(std::span<const Candidate> candidates, WeldReport& report);

 private:
  // One surface of a group.
  struct Surface {
    std::uint32_t number = 0;
    QuadricForm form;
    std::vector<Provenance::Source> sources;  // for each chain the most accurate one, and of these the best
    Box box;               // holds the bounded leaves that own the surface; holds everything if that is not finite
    std::size_t bits = 0;  // bits of all coefficients; fewer bits make a simpler form
  };
  // A surface of a group in the coordinates of a region, while it is compared.
  struct Member {
    const Surface* surface;
    RegionForm form;
    double distance;
  };

  FormError worst_known(const Candidate& candidate, const RegionForm& form) const;
  std::vector<Provenance::Source> best_known(const Candidate& candidate, const RegionForm& form) const;
  Surface described(std::uint32_t number) const;
  RegionForm region_form(std::uint32_t candidate) const;
  const std::vector<RegionForm>& region_forms();
  Grouping::Groups groups_by_rounding();
  Grouping::Groups groups_by_digits(std::span<const Replacement> replacements, WeldReport& report);
  Grouping::Groups groups_by_hand(std::span<const Replacement> replacements, WeldReport& report);
  Grouping::Groups groups_that_touch(double most_gap, std::span<const Replacement> replacements, WeldReport& report);
  std::vector<LeafFaces> faces(std::span<const Replacement> replacements,
                               std::vector<Provenance::Source>& one_source) const;
  double distance(const Member& a, const Member& b, const Region& region);
  void weld_groups(const Grouping::Groups& groups, std::vector<Replacement>& replacements, WeldReport& report);
  void weld_group(std::span<const std::uint32_t> numbers, std::vector<Replacement>& replacements, WeldReport& report);
  void gather(const Member& leader, const Region& region, std::vector<Member> members,
              std::vector<Replacement>& replacements, WeldReport& report);
  static bool precedes(const Surface& a, const Surface& b);
  void list_near_misses(std::span<const Replacement> replacements, WeldReport& report);

  const Provenance& provenance_;
  Welding welding_;
  bool has_size_;
  Box everything_;
  Region region_;
  bool by_hand_ = false;   // true if distance() measures in tolerances now, not in errors
  double border_ = 1;      // surfaces are one if their distance is at most this
  double most_error_ = 0;  // an error above this share of the largest coefficient tells nothing
  double tolerance_ = 0;   // the tolerance of welding by hand, in the scene's unit of length
  std::span<const Candidate> candidates_;
  std::vector<RegionForm> forms_;  // of all candidates, in region_; made when they are first all needed at once
  NearPairs near_;
  std::uint64_t work_ = 0;
  std::uint64_t most_work_ = 0;
};

}  // namespace csgcast::detail
