// SPDX-License-Identifier: MIT
#include "raycast/cells/detail/section_ground.h"

#include <cmath>
#include <limits>
#include <utility>

#include "csg/base/length.h"
#include "csg/base/precondition.h"
#include "csg/exact/quadric_form.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;

// The axes of a section with a given normal, as rows. The third is the normal. The second leads upwards (along z), or
// along y if the section is seen from above or below.
CellAxes axes_about(Vector normal) {
  using Row = CellAxes::Row;
  const auto unit = [](Row row) {
    const long double size = std::sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);
    for (long double& x : row) x /= size;
    return row;
  };
  const Vector rounded = normalised(normal);
  const Row n = unit({rounded.x, rounded.y, rounded.z});
  const std::size_t up = std::fabs(n[2]) > 0.999L ? 1 : 2;
  Row v{};
  v[up] = 1;
  for (std::size_t i = 0; i < 3; ++i) v[i] -= n[up] * n[i];
  v = unit(v);
  CellAxes axes;
  axes.rows = {Row{v[1] * n[2] - v[2] * n[1], v[2] * n[0] - v[0] * n[2], v[0] * n[1] - v[1] * n[0]}, v, n};
  return axes;
}

// The form at one height, which may be off by `off`. The result does not depend on z.
CellForm at_height(const CellForm& form, long double z, double off, const CellBox& box) {
  const auto& c = form.c;
  const long double d = z - form.center.z;
  CellForm flat = form;
  flat.c[Form::one] = static_cast<double>((c[Form::zz] * d + c[Form::z]) * d + c[Form::one]);
  flat.c[Form::x] = static_cast<double>(c[Form::x] + c[Form::xz] * d);
  flat.c[Form::y] = static_cast<double>(c[Form::y] + c[Form::yz] * d);
  flat.c[Form::zz] = flat.c[Form::xz] = flat.c[Form::yz] = flat.c[Form::z] = 0;
  flat.center.z = 0;
  CellBox there = box;
  there.lower.z = there.upper.z = static_cast<double>(z);
  const LocalForm here = local_form(form, there);
  const Vector half = 0.5 * (there.upper - there.lower);
  const double slope = std::fabs(here.gradient.z) + std::fabs(c[Form::xz]) * half.x + std::fabs(c[Form::yz]) * half.y;
  flat.off = here.slack + off * (slope + std::fabs(c[Form::zz]) * off);
  // If a plane of the solid lies in the section's plane, the side just beyond it along the normal counts.
  bool is_plane = true;
  for (std::size_t i = 0; i < Form::x; ++i) is_plane = is_plane && c[i] == 0;
  const double most = std::fabs(flat.c[Form::one]) + 8 * (std::fabs(flat.c[Form::x]) + std::fabs(flat.c[Form::y]));
  if (is_plane && most <= 16 * flat.off) {
    flat.c[Form::x] = flat.c[Form::y] = flat.off = 0;
    flat.c[Form::one] = c[Form::z] > 0 ? 1 : -1;
  }
  return flat;
}

}  // namespace

SectionGround section_ground(const CellGround& of, NodeId node, Vector normal, double distance) {
  CSGCAST_PRECONDITION(of.is_bounded && is_finite(normal) && longest(normal) > 0);
  const Scene& scene = of.scene;
  const Frame& frame = scene.frame();
  const CellAxes axes = axes_about(normal);
  // The height is the distance of the plane from the frame's center, in the frame's units.
  const int exponent = std::ilogb(longest(normal));
  const Vector n{std::scalbn(normal.x, -exponent), std::scalbn(normal.y, -exponent), std::scalbn(normal.z, -exponent)};
  long double height = std::scalbn(static_cast<long double>(distance), -exponent);
  long double squared = 0;
  long double terms = std::fabs(height);
  for (std::size_t i = 0; i < 3; ++i) {
    terms += std::fabs(static_cast<long double>(n[i]) * frame.center[i]);
    height -= static_cast<long double>(n[i]) * frame.center[i];
    squared += static_cast<long double>(n[i]) * n[i];
  }
  height = std::scalbn(height / std::sqrt(squared), -frame.exponent);
  // If the scene is far from the origin, products and sums round. This bounds the rounding for any kind of long double.
  constexpr double rounding = 8 * static_cast<double>(std::numeric_limits<long double>::epsilon());
  const double off = rounding * static_cast<double>(std::scalbn(terms / std::sqrt(squared), -frame.exponent));

  auto ground = std::make_shared<CellGround>(of);
  ground->axes = axes;
  const auto across = [&](CellBox box) {
    const double margin = 0x1p-30 + off;
    const bool meets = height >= box.lower.z - margin && height <= box.upper.z + margin;
    box.lower.z = meets ? -0.5 : 1;
    box.upper.z = meets ? 0.5 : -1;
    return box;
  };
  const CellBox whole = ground->box_of(scene.node(node).box);
  ground->heights =
      CellGround::Heights{static_cast<double>(height) - (off + 0x1p-50), static_cast<double>(height) + (off + 0x1p-50)};
  for (std::size_t i = 0; i < scene.surfaces().size(); ++i) {
    const Surface& surface = scene.surfaces()[i];
    ground->forms[i] = at_height(axes.turned({surface.local, surface.center}), height, off, whole);
  }
  for (const Node& leaf : scene.nodes()) {
    if (leaf.op != Node::Op::leaf) continue;
    constexpr Vector far{HUGE_VAL, HUGE_VAL, HUGE_VAL};
    CellBox& box = ground->leaf_boxes[leaf.first];
    box = leaf.box.is_finite() ? across(ground->box_of(leaf.box)) : CellBox{-far, far};
  }
  const CellBox box = across(whole);
  const bool misses = box.lower.z > box.upper.z;
  ground->box = misses ? CellBox{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}} : box;
  return {std::move(ground), misses};
}

}  // namespace csgcast::detail
