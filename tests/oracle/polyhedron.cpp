// SPDX-License-Identifier: MIT
// The one file that sees CGAL's geometry: its headers take a minute to compile.
#include "tests/oracle/polyhedron.h"

#include <CGAL/Convex_hull_3/dual/halfspace_intersection_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace csgcast::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Polyhedron_3<Kernel>;
using SideOfMesh = CGAL::Side_of_triangle_mesh<Mesh, Kernel>;

Kernel::Point_3 kernel_point(const RationalPoint& p) { return {Kernel::FT(p[0]), Kernel::FT(p[1]), Kernel::FT(p[2])}; }

RationalPoint rational_point(const Kernel::Point_3& p) {
  return {CGAL::exact(p.x()), CGAL::exact(p.y()), CGAL::exact(p.z())};
}

Kernel::Plane_3 kernel_plane(const RationalPlane& plane) {
  const auto& c = plane.coefficient;
  return {Kernel::FT(c[0]), Kernel::FT(c[1]), Kernel::FT(c[2]), Kernel::FT(c[3])};
}

// convex_hull_3 makes a mesh of flat points too, so they are told apart by predicates: a point off the first, one off
// their line, one off their plane.
bool lie_in_one_plane(const std::vector<Kernel::Point_3>& points) {
  const auto end = points.end();
  const auto a = points.begin();
  if (a == end) return true;
  const auto b = std::find_if(a, end, [&](const auto& p) { return p != *a; });
  if (b == end) return true;
  const auto c = std::find_if(b, end, [&](const auto& p) { return !CGAL::collinear(*a, *b, p); });
  return c == end || std::all_of(c, end, [&](const auto& p) { return CGAL::coplanar(*a, *b, *c, p); });
}

}  // namespace

struct Polyhedron::Data {
  Mesh mesh;
  std::unique_ptr<SideOfMesh> side;
  std::vector<RationalPoint> corners;
  std::vector<Triangle> triangles;
  std::vector<RationalPlane> planes;
  std::vector<Kernel::Plane_3> kernel_planes;

  void set_planes(const std::vector<RationalPlane>& all) {
    planes = without_duplicates(all);
    for (const RationalPlane& plane : planes) kernel_planes.push_back(kernel_plane(plane));
  }

  void set_surface(const std::vector<Kernel::Point_3>& points) {
    CGAL::convex_hull_3(points.begin(), points.end(), mesh);
    side = std::make_unique<SideOfMesh>(mesh);
    std::map<Mesh::Vertex_const_handle, std::size_t> index;
    for (auto v = mesh.vertices_begin(); v != mesh.vertices_end(); ++v) {
      index[v] = corners.size();
      corners.push_back(rational_point(v->point()));
    }
    for (auto f = mesh.facets_begin(); f != mesh.facets_end(); ++f) {
      const auto h = f->halfedge();
      triangles.push_back(
          {index.at(h->vertex()), index.at(h->next()->vertex()), index.at(h->next()->next()->vertex())});
    }
  }

  std::vector<RationalPlane> triangle_planes() const {
    std::vector<RationalPlane> result;
    for (const auto& [a, b, c] : triangles) result.push_back(plane_through(corners[a], corners[b], corners[c]));
    return result;
  }
};

Polyhedron::Polyhedron(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

std::optional<Polyhedron> Polyhedron::hull(const std::vector<RationalPoint>& points) {
  std::vector<Kernel::Point_3> kernel_points;
  for (const RationalPoint& p : points) kernel_points.push_back(kernel_point(p));
  if (lie_in_one_plane(kernel_points)) return std::nullopt;
  auto data = std::make_shared<Data>();
  data->set_surface(kernel_points);
  data->set_planes(data->triangle_planes());
  return Polyhedron(std::move(data));
}

Polyhedron Polyhedron::intersection(const std::vector<RationalPlane>& planes, const RationalPoint& inside) {
  std::vector<Kernel::Plane_3> kernel_planes;
  for (const RationalPlane& plane : planes) kernel_planes.push_back(kernel_plane(plane));
  Mesh primal;  // its faces are polygons, and corners of more than three planes come several times: its hull has
                // neither flaw
  CGAL::halfspace_intersection_3(kernel_planes.begin(), kernel_planes.end(), primal,
                                 boost::make_optional(kernel_point(inside)));
  auto data = std::make_shared<Data>();
  data->set_surface(std::vector<Kernel::Point_3>(primal.points_begin(), primal.points_end()));
  data->set_planes(planes);
  for (const RationalPlane& facet : without_duplicates(data->triangle_planes())) {
    if (!std::binary_search(data->planes.begin(), data->planes.end(), facet))
      throw std::logic_error("a facet in none of the planes");
  }
  return Polyhedron(std::move(data));
}

Polyhedron Polyhedron::half_spaces(const std::vector<RationalPlane>& planes) {
  auto data = std::make_shared<Data>();
  data->set_planes(planes);
  return Polyhedron(std::move(data));
}

const std::vector<RationalPlane>& Polyhedron::planes() const { return data_->planes; }
const std::vector<RationalPoint>& Polyhedron::corners() const { return data_->corners; }
const std::vector<Polyhedron::Triangle>& Polyhedron::triangles() const { return data_->triangles; }

std::optional<Location> Polyhedron::side_of_mesh(Point p) const {
  if (!data_->side) return std::nullopt;
  switch ((*data_->side)(Kernel::Point_3(p.x, p.y, p.z))) {
    case CGAL::ON_BOUNDED_SIDE:
      return Location::inside;
    case CGAL::ON_UNBOUNDED_SIDE:
      return Location::outside;
    default:
      return Location::boundary;
  }
}

void Polyhedron::signs(Point p, std::vector<int>& signs) const {
  const Kernel::Point_3 point(p.x, p.y, p.z);
  signs.clear();
  for (const Kernel::Plane_3& plane : data_->kernel_planes)
    signs.push_back(static_cast<int>(plane.oriented_side(point)));
}

}  // namespace csgcast::oracle
