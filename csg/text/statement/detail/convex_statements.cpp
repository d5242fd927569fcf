// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "csg/solid/mesh.h"
#include "csg/solid/primitives.h"
#include "csg/text/statement/detail/solid_statements.h"

namespace csgcast::text {
namespace {

constexpr std::string_view no_volume = "its points enclose no volume";

std::vector<Point> read_points(const Call& call, const List& list) {
  std::vector<Point> points;
  points.reserve(list.size());
  for (const Value& value : list) {
    const Vector v = call.vector_entry(value, "a point");
    points.push_back({v.x, v.y, v.z});
  }
  return points;
}

PlaneEquation read_plane(const Call& call, const Value& value) {
  const List& row = call.list_entry(value, "a plane");
  if (row.size() != 4) {
    call.reject(ErrorCode::wrong_type, call.place(value), "a plane of 'convex' must be a list of four numbers",
                fmt::format("it has {}", row.size()), "give [nx, ny, nz, d] for n . p <= d");
  }
  const auto number = [&](std::size_t i) { return call.entry(row[i], "a plane's entry"); };
  const PlaneEquation plane{{number(0), number(1), number(2)}, number(3)};
  if (plane.normal == Vector{}) {
    call.reject(ErrorCode::bad_value, call.place(value), "a plane of 'convex' has no normal", "it is the zero vector",
                "give [nx, ny, nz, d] with a normal that is not zero");
  }
  return plane;
}

Mesh::Face read_face(const Call& call, const Value& value, std::size_t point_count) {
  Mesh::Face face;
  const List& corners = call.list_entry(value, "a face");
  face.reserve(corners.size());
  for (const Value& corner : corners) {
    const double index = call.entry(corner, "a face's corner");
    if (!(index >= 0 && index < static_cast<double>(point_count)) || index != std::trunc(index)) {
      call.reject(ErrorCode::bad_value, call.place(corner), fmt::format("a face of 'polyhedron' names point {}", index),
                  fmt::format("there are {} points, counted from 0", point_count), "give the number of a point");
    }
    face.push_back(static_cast<std::uint32_t>(index));
  }
  return face;
}

std::string coordinates(Point p) { return fmt::format("[{}, {}, {}]", p.x, p.y, p.z); }

void require_closed(const Call& call, const Mesh& mesh) {
  const auto edge = open_edge(mesh);
  if (!edge) return;
  call.reject(ErrorCode::bad_value, call.place(), "the mesh of this 'polyhedron' is not closed",
              fmt::format("faces do not run equally often both ways along the edge between {} and {}",
                          coordinates(edge->from), coordinates(edge->to)),
              "add the missing face, or turn the one that is the wrong way round");
}

/// Of faces that are bent by more than the rounding of their corners, the hull adds or takes what OpenSCAD does not.
void warn_if_bent(const Call& call, const Mesh& mesh) {
  double farthest = 0;
  for (const Point& p : mesh.points) farthest = std::max({farthest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  const double known = std::max(8 * call.digits().error_beside_longer(farthest), 0x1p-40 * farthest);
  const double bend = greatest_bend(mesh);
  if (bend > known)
    call.warn(fmt::format("a face of this 'polyhedron' is bent by {:.2g}: the hull of its points is taken", bend));
}

}  // namespace

Solid make_convex(const Call& call) {
  const List* points = call.list("points");
  const List* planes = call.list("planes");
  if ((points == nullptr) == (planes == nullptr)) {
    call.reject(ErrorCode::bad_value, call.place(), "'convex' needs either 'points' or 'planes'",
                points == nullptr ? "neither is given" : "both are given", "give one of them");
  }
  const std::optional<Vector> error = call.vector("error");
  if (error) {
    call.require(points != nullptr, "error", "stand beside 'points'");
    call.require(error->x >= 0 && error->y >= 0 && error->z >= 0, "error", "not be negative");
  }
  if (points != nullptr) {
    const std::vector<Point> read = read_points(call, *points);
    return warn_if_empty(call, error ? convex_from_points(read, *error) : convex_from_points(read, call.digits()),
                         no_volume);
  }
  std::vector<PlaneEquation> equations;
  equations.reserve(planes->size());
  for (const Value& plane : *planes) equations.push_back(read_plane(call, plane));
  call.require(!equations.empty(), "planes", "hold at least one plane");
  return warn_if_empty(call, convex_from_planes(equations, call.digits()),
                       "no point is on the inner side of all its planes");
}

Solid make_polyhedron(const Call& call) {
  const List* points = call.list("points");
  // `triangles` is what OpenSCAD called faces before 2014.
  const List* triangles = call.list("triangles");
  const List* faces = call.list("faces");
  if (faces != nullptr) call.require(triangles == nullptr, "triangles", "not stand beside 'faces', its newer name");
  if (faces == nullptr) faces = triangles;
  call.number("convexity");  // a hint for drawing: only its type matters
  Mesh given;
  if (points != nullptr) given.points = read_points(call, *points);
  if (faces != nullptr) {
    for (const Value& face : *faces) given.faces.push_back(read_face(call, face, given.points.size()));
  }
  const Mesh mesh = welded(given);
  require_closed(call, mesh);
  if (!is_convex(mesh)) {
    call.reject(ErrorCode::unsupported, call.place(), "this polyhedron is not convex",
                "only convex ones are supported yet", "compose it of convex ones by union and difference");
  }
  warn_if_bent(call, mesh);
  return warn_if_empty(call, convex_from_points(mesh.points, call.digits()), no_volume);
}

}  // namespace csgcast::text
