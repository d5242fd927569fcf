// SPDX-License-Identifier: MIT
#include "csg/text/statement/detail/solid_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "csg/solid/primitives.h"
#include "csg/text/statement/detail/facets.h"

namespace csgcast::text {
namespace {

Centering centering(const Call& call) {
  return call.boolean_or("center", false) ? Centering::centered : Centering::corner;
}

/// A radius given as itself or as a diameter, which wins as in OpenSCAD.
std::optional<double> radius(const Call& call, std::string_view radius_name, std::string_view diameter_name) {
  const auto given = call.number(radius_name);
  const auto diameter = call.number(diameter_name);
  if (given && diameter) call.warn(fmt::format("'{}' is ignored, since '{}' is given", radius_name, diameter_name));
  if (diameter) return *diameter / 2;
  return given;
}

/// The sides of the polygon that stands for a circle; nothing if the curve is kept. `points` counts the vertices for
/// that many sides.
template <class PointCount>
std::optional<int> polygon_sides(const Call& call, double radius, PointCount points) {
  constexpr double coarse = 16;  // an explicit $fn up to here means the polygon
  constexpr double most_points = 250'000;
  const Fineness fineness = call.fineness();
  if (call.options().facets == Facets::never) return std::nullopt;
  const bool asks = fineness.fn > 0 && fineness.fn <= coarse;
  if (call.options().facets == Facets::automatic && !asks) return std::nullopt;
  const double sides = side_count(radius, fineness);
  if (points(sides) > most_points) {
    call.reject(ErrorCode::limit, call.place(), fmt::format("'{}' has too many facets", call.name()),
                fmt::format("$fn, $fa and $fs ask for {:.0f} sides", sides),
                "ask for fewer or keep its curve (--facets never)");
  }
  call.count_faceted();
  return static_cast<int>(sides);
}

/// What share of it a size may be off by its few digits.
double share(const Call& call, double size) {
  return call.digits().are_few() && size > 0 ? call.digits().error(size) / size : 0;
}

}  // namespace

Solid warn_if_empty(const Call& call, Solid solid, std::string_view why) {
  if (solid.kind() == Solid::Kind::empty) call.warn(fmt::format("'{}' is empty: {}", call.name(), why));
  return solid;
}

Solid make_cube(const Call& call) {
  Vector size{1, 1, 1};
  const Value* given = call.find("size");
  if (given != nullptr && std::holds_alternative<double>(given->data)) {
    const double side = call.required_number("size");
    size = {side, side, side};
  } else if (given != nullptr && !std::holds_alternative<List>(given->data)) {
    call.reject(ErrorCode::wrong_type, call.place("size"),
                "'size' of 'cube' must be a number or a list of three numbers", "",
                "give cube(size = 1) or cube(size = [1, 2, 3])");
  } else {
    size = call.vector("size").value_or(size);
  }
  return warn_if_empty(call, box(size, centering(call), call.digits()), "a size is not greater than 0");
}

Solid make_sphere(const Call& call) {
  const double r = radius(call, "r", "d").value_or(1);
  const auto sides = polygon_sides(call, r, [](double n) { return n * (n + 1) / 2; });
  Solid solid;
  if (r > 0 && sides) {
    solid = convex_from_points(sphere_vertices(r, *sides), Vector{share(call, r), share(call, r), share(call, r)});
  } else if (r > 0) {
    solid = sphere(r, call.digits());
  }
  return warn_if_empty(call, std::move(solid), "its radius is not greater than 0");
}

Solid make_cylinder(const Call& call) {
  const double h = call.number_or("h", 1);
  const auto both = radius(call, "r", "d");
  const auto own_bottom = radius(call, "r1", "d1");
  const auto own_top = radius(call, "r2", "d2");
  if (both && (own_bottom || own_top)) call.warn("a cylinder with both 'r' and 'r1' or 'r2': these win");
  const double bottom_radius = own_bottom.value_or(both.value_or(1));
  const double top_radius = own_top.value_or(both.value_or(1));
  const Centering centred = centering(call);
  const double widest = std::max(bottom_radius, top_radius);
  const auto sides = polygon_sides(call, widest, [](double n) { return 2 * n; });
  const bool has_interior = h > 0 && bottom_radius >= 0 && top_radius >= 0 && widest > 0;
  Solid solid;
  if (has_interior && sides) {
    const double bottom = centred == Centering::centered ? -h / 2 : 0;
    const double top = centred == Centering::centered ? h / 2 : h;
    const double r_share = std::max(share(call, bottom_radius), share(call, top_radius));
    solid = convex_from_points(cylinder_vertices(bottom, top, bottom_radius, top_radius, *sides),
                               Vector{r_share, r_share, share(call, h)});
  } else if (has_interior) {
    solid = cylinder(h, bottom_radius, top_radius, centred, call.digits());
  }
  return warn_if_empty(call, std::move(solid), "it needs h > 0 and radii that are not negative and not both 0");
}

}  // namespace csgcast::text
