// SPDX-License-Identifier: MIT
#include "tests/oracle/quadrics/subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace csgcast::oracle::quadrics {
namespace {

using Half = std::pair<SurfaceId, bool>;

std::vector<Half> sorted(std::vector<Half> halves) {
  std::sort(halves.begin(), halves.end());
  halves.erase(std::unique(halves.begin(), halves.end()), halves.end());
  return halves;
}

}  // namespace

Subject::Subject(const Solid& defined, const Solid& compiled)
    : formula_(defined),
      scene_(compile(with_numbered_leaves(compiled))),
      surface_id_(formula_.surfaces().size()),
      leaf_id_(formula_.leaves().size()) {
  std::map<RationalForm, SurfaceId> ids;
  for (std::uint32_t i = 0; i < scene_.surfaces().size(); ++i) {
    ids.emplace(RationalForm(scene_.surfaces()[i].exact.unpacked()), SurfaceId(i));
  }
  for (std::size_t i = 0; i < surface_id_.size(); ++i) {
    const auto found = ids.find(formula_.surfaces()[i]);
    if (found == ids.end()) continue;
    surface_id_[i] = found->second;
    ++matched_surfaces_;
  }
  for (std::uint32_t i = 0; i < scene_.leaves().size(); ++i) {
    leaf_id_.at(static_cast<std::size_t>(scene_.leaves()[i].place.line) - 1) = LeafId(i);
  }
}

std::string Subject::complaint() const {
  if (matched_surfaces_ != scene_.surfaces().size()) {
    return fmt::format("{} of {} surfaces are those of the solid", matched_surfaces_, scene_.surfaces().size());
  }
  for (std::size_t leaf = 0; leaf < leaf_id_.size(); ++leaf) {
    std::string complaint = complaint_about_leaf(leaf);
    if (!complaint.empty()) return complaint;
  }
  return complaint_about_order();
}

std::string Subject::complaint_about_order() const {
  const auto ascends = [](const auto& ids) {
    auto known = ids;
    std::erase_if(known, [](auto id) { return !id.valid(); });
    return std::is_sorted(known.begin(), known.end());
  };
  if (!ascends(leaf_id_)) return "leaves are not in file order";
  // Where an operand that is empty or everything by itself absorbs others, these need not bring their surfaces.
  if (formula_.has_no_constants() && !ascends(surface_id_)) return "surfaces are not in file order";
  return {};
}

std::string Subject::complaint_about_leaf(std::size_t leaf) const {
  if (!leaf_id_[leaf].valid()) return {};
  std::vector<Half> expected, found;
  const FormulaLeaf& own = formula_.leaves()[leaf];
  for (std::size_t i = own.first; i < own.end; ++i) {
    const Copy& copy = formula_.copies()[i];
    expected.emplace_back(surface_id_[copy.surface], copy.positive);
  }
  for (const HalfSpace& half : scene_.half_spaces(scene_.leaf(leaf_id_[leaf]))) {
    found.emplace_back(half.surface, half.sense == Sense::positive);
  }
  return sorted(found) == sorted(expected) ? "" : fmt::format("leaf {} has other half-spaces", leaf);
}

}  // namespace csgcast::oracle::quadrics
