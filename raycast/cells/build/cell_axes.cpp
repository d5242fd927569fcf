// SPDX-License-Identifier: MIT
#include "raycast/cells/build/cell_axes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "csg/base/length.h"
#include "csg/exact/quadric_form.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;
using Row = CellAxes::Row;

// Directions that are square to each other up to this bound were meant to be square, because scenes are written with
// six digits.
constexpr long double nearly = 0x1p-13L;
// Directions that are square to each other up to this bound are treated as square.
constexpr long double exactly = 0x1p-44L;
// The axes must serve at least this many times the planes that the frame's own axes serve, and this share of all
// planes.
constexpr double least_gain = 1.5;
constexpr double least_share = 0.25;

long double dot(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Row normalised(Row v) {
  const long double inverse = 1 / std::sqrt(dot(v, v));
  for (long double& c : v) c *= inverse;
  return v;
}

Row cross(const Row& a, const Row& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The direction of the component of v that is square to a unit vector.
Row square_to(const Row& axis, Row v) {
  const long double along = dot(axis, v);
  for (std::size_t i = 0; i < 3; ++i) v[i] -= along * axis[i];
  return normalised(v);
}

struct Direction {
  Row unit{};
  std::size_t count = 0;
};

// The normals of the planes, the most frequent first. Opposite normals count as one.
std::vector<Direction> normals_of(const Scene& scene) {
  std::map<std::array<std::int64_t, 3>, Direction> found;
  for (const Surface& surface : scene.surfaces()) {
    if (!surface.is_plane || !surface.in_range) continue;
    Row n = normalised({surface.local[Form::x], surface.local[Form::y], surface.local[Form::z]});
    // The normal is turned so that its first coordinate that is not next to zero is positive.
    const std::size_t leading = std::fabs(n[0]) > 0x1p-20L ? 0 : std::fabs(n[1]) > 0x1p-20L ? 1 : 2;
    if (n[leading] < 0) n = {-n[0], -n[1], -n[2]};
    std::array<std::int64_t, 3> key{};
    for (std::size_t i = 0; i < 3; ++i) key[i] = std::llround(n[i] * 0x1p30L);
    Direction& direction = found[key];
    if (direction.count++ == 0) direction.unit = n;
  }
  std::vector<Direction> sorted;
  for (const auto& [key, direction] : found) sorted.push_back(direction);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Direction& a, const Direction& b) { return a.count > b.count; });
  return sorted;
}

// The number of planes that are square to one of the axes.
std::size_t served_by(const std::array<Row, 3>& axes, const std::vector<Direction>& directions) {
  std::size_t count = 0;
  for (const Direction& direction : directions) {
    const bool is_served = std::any_of(axes.begin(), axes.end(), [&](const Row& axis) {
      return 1 - std::fabs(dot(axis, direction.unit)) < nearly * nearly / 2;
    });
    if (is_served) count += direction.count;
  }
  return count;
}

Vector product(const std::array<Row, 3>& rows, Vector v) {
  Vector result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = static_cast<double>(rows[i][0] * v.x + rows[i][1] * v.y + rows[i][2] * v.z);
  return result;
}

// The box that holds a box after its points were multiplied by these rows.
CellBox box_about(const std::array<Row, 3>& rows, const CellBox& box) {
  const Vector size = box.upper - box.lower;
  if (!(longest(size) < HUGE_VAL)) {
    constexpr Vector far{HUGE_VAL, HUGE_VAL, HUGE_VAL};
    const bool is_null = size.x < 0 || size.y < 0 || size.z < 0;
    return is_null ? CellBox{far, -far} : CellBox{-far, far};
  }
  const Vector middle = product(rows, 0.5 * (box.lower + box.upper));
  const Vector half = 0.5 * (box.upper - box.lower);
  Vector reach;
  for (std::size_t i = 0; i < 3; ++i) {
    const Row& row = rows[i];
    const long double sum = std::fabs(row[0]) * half.x + std::fabs(row[1]) * half.y + std::fabs(row[2]) * half.z;
    reach[i] = static_cast<double>(sum) + 0x1p-48;
  }
  return {middle - reach, middle + reach};
}

}  // namespace

std::array<Vector, 3> CellAxes::rounded() const {
  std::array<Vector, 3> result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = {static_cast<double>(rows[i][0]), static_cast<double>(rows[i][1]), static_cast<double>(rows[i][2])};
  return result;
}

Vector CellAxes::turned(Vector v) const { return product(rows, v); }

CellForm CellAxes::turned(const CellForm& form) const {
  const auto& c = form.c;
  const std::array<Row, 3> matrix{Row{c[Form::xx], c[Form::xy] / 2.0L, c[Form::xz] / 2.0L},
                                  Row{c[Form::xy] / 2.0L, c[Form::yy], c[Form::yz] / 2.0L},
                                  Row{c[Form::xz] / 2.0L, c[Form::yz] / 2.0L, c[Form::zz]}};
  const auto entry = [&](std::size_t i, std::size_t j) {
    const Row image{dot(matrix[0], rows[j]), dot(matrix[1], rows[j]), dot(matrix[2], rows[j])};
    return static_cast<double>(dot(rows[i], image));
  };
  const Vector linear = turned(Vector{c[Form::x], c[Form::y], c[Form::z]});
  CellForm result;
  result.c[Form::xx] = entry(0, 0);
  result.c[Form::yy] = entry(1, 1);
  result.c[Form::zz] = entry(2, 2);
  result.c[Form::xy] = 2 * entry(0, 1);
  result.c[Form::xz] = 2 * entry(0, 2);
  result.c[Form::yz] = 2 * entry(1, 2);
  result.c[Form::x] = linear.x;
  result.c[Form::y] = linear.y;
  result.c[Form::z] = linear.z;
  result.c[Form::one] = c[Form::one];
  result.center = turned(form.center);
  // Coefficients are off by 2^-58 of the sum of all, and are rounded. Within 2 of the center, the form is off by no
  // more than this.
  double all = 0;
  for (std::size_t i = 0; i < Form::x; ++i) all += 4 * std::fabs(form.c[i]);
  for (std::size_t i = Form::x; i < Form::one; ++i) all += 2 * std::fabs(form.c[i]);
  result.off = form.off + 0x1p-57 * all;
  return result;
}

CellBox CellAxes::holding(const CellBox& box) const { return box_about(rows, box); }

CellBox CellAxes::turned_back(const CellBox& box) const {
  std::array<Row, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) columns[i] = {rows[0][i], rows[1][i], rows[2][i]};
  return box_about(columns, box);
}

std::optional<CellAxes> common_axes(const Scene& scene) {
  const std::vector<Direction> directions = normals_of(scene);
  if (directions.empty()) return std::nullopt;
  std::size_t planes = 0;
  for (const Direction& direction : directions) planes += direction.count;
  const std::array<Row, 3> own{Row{1, 0, 0}, Row{0, 1, 0}, Row{0, 0, 1}};
  const Row first = directions.front().unit;
  const auto square_up_to = [&](long double tolerance) {
    return std::find_if(directions.begin(), directions.end(),
                        [&](const Direction& direction) { return std::fabs(dot(first, direction.unit)) < tolerance; });
  };
  auto second = square_up_to(exactly);
  if (second == directions.end()) second = square_up_to(nearly);
  // If there is no second direction, any direction will do.
  const std::size_t thinnest = static_cast<std::size_t>(
      std::min_element(first.begin(), first.end(),
                       [](long double a, long double b) { return std::fabs(a) < std::fabs(b); }) -
      first.begin());
  CellAxes axes;
  axes.rows[0] = first;
  axes.rows[1] = square_to(first, second != directions.end() ? second->unit : own[thinnest]);
  axes.rows[2] = normalised(cross(axes.rows[0], axes.rows[1]));
  const double served = static_cast<double>(served_by(axes.rows, directions));
  const double by_own = static_cast<double>(served_by(own, directions));
  if (served < least_gain * by_own || served < least_share * static_cast<double>(planes)) return std::nullopt;
  return axes;
}

}  // namespace csgcast::detail
