// SPDX-License-Identifier: MIT
#include "tests/oracle/subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "csg/exact/quadric_form.h"

namespace csgcast::oracle {
namespace {

// The product's integers as they stand: they must be the primitive ones, not only proportional.
RationalPlane plane_of(const Surface& surface) {
  const auto c = surface.exact.unpacked().coefficient;
  return {{rational(c[QuadricForm::x]), rational(c[QuadricForm::y]), rational(c[QuadricForm::z]),
           rational(c[QuadricForm::one])}};
}

RationalPlane sign_normalised(const RationalPlane& plane) { return plane.leading_sign() < 0 ? -plane : plane; }

using Half = std::pair<SurfaceId, bool>;

}  // namespace

bool combined(Operation operation, const std::vector<bool>& operands) {
  const auto is_true = [](bool value) { return value; };
  switch (operation) {
    case Operation::unite:
      return std::any_of(operands.begin(), operands.end(), is_true);
    case Operation::intersect:
      return std::all_of(operands.begin(), operands.end(), is_true);
    case Operation::subtract:
      return operands.front() && std::none_of(operands.begin() + 1, operands.end(), is_true);
  }
  return false;
}

Subject::Subject(Model model) : model_(std::move(model)), scene_(compile(model_.solid)) {
  std::map<RationalPlane, SurfaceId> ids;
  for (const Polyhedron& operand : model_.operands) {
    for (const RationalPlane& plane : operand.planes()) ids[sign_normalised(plane)] = SurfaceId();
  }
  for (std::uint32_t i = 0; i < scene_.surfaces().size(); ++i) {
    const auto found = ids.find(plane_of(scene_.surfaces()[i]));
    if (found != ids.end()) found->second = SurfaceId(i);
  }
  for (const auto& [plane, id] : ids) surfaces_.push_back({plane, id});
  std::stable_sort(surfaces_.begin(), surfaces_.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  std::map<RationalPlane, std::size_t> index;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) index[surfaces_[i].plane] = i;
  for (const Polyhedron& operand : model_.operands) {
    std::vector<OracleHalfSpace>& halves = half_spaces_.emplace_back();
    for (const RationalPlane& plane : operand.planes())
      halves.push_back({index.at(sign_normalised(plane)), plane.leading_sign() < 0});
  }
}

std::string Subject::complaint() const {
  const auto known =
      std::count_if(surfaces_.begin(), surfaces_.end(), [](const auto& surface) { return surface.id.valid(); });
  if (static_cast<std::size_t>(known) != scene_.surfaces().size()) {
    return fmt::format("{} of {} surfaces are planes of the model", known, scene_.surfaces().size());
  }
  // A set that the product knows to be empty has no leaf; every query must find it empty then.
  const bool is_empty = scene_.node(scene_.root()).op == Node::Op::empty;
  if (model_.operands.size() != 1 || is_empty) return {};
  if (scene_.leaves().size() != 1) return fmt::format("{} leaves in place of one", scene_.leaves().size());
  std::vector<Half> expected, found;
  for (const auto& half : half_spaces_.front()) expected.emplace_back(surfaces_[half.surface].id, half.positive);
  for (const HalfSpace& half : scene_.half_spaces(scene_.leaves().front())) {
    found.emplace_back(half.surface, half.sense == Sense::positive);
  }
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  return found == expected ? ""
                           : fmt::format("{} half-spaces differ from the expected {}", found.size(), expected.size());
}

}  // namespace csgcast::oracle
