// SPDX-License-Identifier: MIT
#include "measure/detail/linear_cut.h"

#include <cmath>

#include "raycast/truth_table.h"

namespace csgcast::detail {
namespace {

using Tetrahedron = std::array<Vector, 4>;
using Triangle = std::array<Vector, 3>;

Vector between(Vector a, Vector b, double at_a, double at_b) {
  const double t = at_a / (at_a - at_b);
  return a + t * (b - a);
}

double area_of(const Triangle& t) {
  const Vector twice = cross(t[1] - t[0], t[2] - t[0]);
  return 0.5 * std::sqrt(dot(twice, twice));
}

/// Cuts a box's tetrahedra by one plane after another. What is left of a table once the planes before have been
/// decided goes along.
class Cutter {
 public:
  Cutter(std::span<const LinearForm> forms, LinearCut& result) : forms_(forms), result_(result) {}

  void add(const Tetrahedron& t, std::size_t next, std::uint64_t table) {
    while (table != 0 && ~table != 0 && !depends_on(table, next)) ++next;
    if (table == 0) return;
    if (~table == 0) return add_volume(t);
    const std::uint64_t below = restricted(table, next, false);
    const std::uint64_t above = restricted(table, next, true);
    std::array<double, 4> at{};
    std::array<std::size_t, 4> order{};  // the corners below the plane first
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) at[i] = forms_[next].at(t[i]);
    for (std::size_t i = 0; i < 4; ++i) {
      if (at[i] < 0) order[count++] = i;
    }
    for (std::size_t i = 0, last = count; i < 4; ++i) {
      if (!(at[i] < 0)) order[last++] = i;
    }
    if (count == 0) return add(t, next + 1, above);
    if (count == 4) return add(t, next + 1, below);
    const auto corner = [&](std::size_t i) { return t[order[i]]; };
    const auto cut = [&](std::size_t i, std::size_t j) {
      return between(t[order[i]], t[order[j]], at[order[i]], at[order[j]]);
    };
    const std::uint64_t change = below ^ above;
    if (count == 2) {
      const Vector p02 = cut(0, 2), p03 = cut(0, 3), p12 = cut(1, 2), p13 = cut(1, 3);
      add_wedge({corner(0), p02, p03}, {corner(1), p12, p13}, next + 1, below);
      add_wedge({corner(2), p02, p12}, {corner(3), p03, p13}, next + 1, above);
      add_face({p02, p03, p13}, next, next + 1, change);
      add_face({p02, p13, p12}, next, next + 1, change);
      return;
    }
    // One corner is alone on its side.
    const std::size_t alone = count == 1 ? 0 : 3;
    const std::size_t first = count == 1 ? 1 : 0;
    const Triangle face{cut(alone, first), cut(alone, first + 1), cut(alone, first + 2)};
    add({corner(alone), face[0], face[1], face[2]}, next + 1, count == 1 ? below : above);
    add_wedge(face, {corner(first), corner(first + 1), corner(first + 2)}, next + 1, count == 1 ? above : below);
    add_face(face, next, next + 1, change);
  }

 private:
  /// What lies between two triangles with corresponding corners.
  void add_wedge(const Triangle& a, const Triangle& b, std::size_t next, std::uint64_t table) {
    add({a[0], a[1], a[2], b[2]}, next, table);
    add({a[0], a[1], b[1], b[2]}, next, table);
    add({a[0], b[0], b[1], b[2]}, next, table);
  }

  void add_volume(const Tetrahedron& t) {
    const double volume = std::fabs(dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0]))) / 6;
    const Vector sum = t[0] + t[1] + t[2] + t[3];
    Moments& m = result_.moments;
    m.volume += volume;
    for (std::size_t i = 0; i < 3; ++i) m.first[i] += volume / 4 * sum[i];
    for (std::size_t k = 0; k < 6; ++k) {
      const auto [i, j] = Moments::pair[k];
      double products = sum[i] * sum[j];
      for (const Vector& corner : t) products += corner[i] * corner[j];
      m.second[k] += volume / 20 * products;
    }
  }

  /// A part of the plane `of`, where the value changes across it wherever `change` says so.
  void add_face(const Triangle& t, std::size_t of, std::size_t next, std::uint64_t change) {
    while (change != 0 && ~change != 0 && !depends_on(change, next)) ++next;
    if (change == 0) return;
    if (~change == 0) {
      result_.areas[of] += area_of(t);
      return;
    }
    const std::uint64_t below = restricted(change, next, false);
    const std::uint64_t above = restricted(change, next, true);
    std::array<double, 3> at{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = forms_[next].at(t[i]);
      count += at[i] < 0 ? 1 : 0;
    }
    if (count == 0) return add_face(t, of, next + 1, above);
    if (count == 3) return add_face(t, of, next + 1, below);
    std::size_t alone = 0;
    while ((at[alone] < 0) != (count == 1)) ++alone;
    const std::size_t b = (alone + 1) % 3;
    const std::size_t c = (alone + 2) % 3;
    const Vector pb = between(t[alone], t[b], at[alone], at[b]);
    const Vector pc = between(t[alone], t[c], at[alone], at[c]);
    add_face({t[alone], pb, pc}, of, next + 1, count == 1 ? below : above);
    add_face({pb, t[b], t[c]}, of, next + 1, count == 1 ? above : below);
    add_face({pb, t[c], pc}, of, next + 1, count == 1 ? above : below);
  }

  std::span<const LinearForm> forms_;
  LinearCut& result_;
};

}  // namespace

LinearCut cut_linearly(std::span<const LinearForm> forms, std::uint64_t table, Vector half) {
  LinearCut result;
  Cutter cutter(forms, result);
  const auto corner = [&](unsigned bits) {
    return Vector{(bits & 1) != 0 ? half.x : -half.x, (bits & 2) != 0 ? half.y : -half.y,
                  (bits & 4) != 0 ? half.z : -half.z};
  };
  // Five tetrahedra: one about every second corner, and the one that these leave.
  cutter.add({corner(0), corner(1), corner(2), corner(4)}, 0, table);
  cutter.add({corner(3), corner(1), corner(2), corner(7)}, 0, table);
  cutter.add({corner(5), corner(1), corner(4), corner(7)}, 0, table);
  cutter.add({corner(6), corner(2), corner(4), corner(7)}, 0, table);
  cutter.add({corner(1), corner(2), corner(4), corner(7)}, 0, table);
  return result;
}

}  // namespace csgcast::detail
