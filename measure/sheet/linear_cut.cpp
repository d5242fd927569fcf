// SPDX-License-Identifier: MIT
#include "measure/sheet/linear_cut.h"

#include <cmath>

#include "csg/base/length.h"
#include "csg/base/truth_table.h"
#include "measure/sheet/tetrahedron.h"

namespace csgcast::detail {
namespace {

/// Cuts a box's tetrahedra by one plane after another. It passes along the part of the table that is left once the
/// previous planes are decided.
class Cutter {
 public:
  Cutter(std::span<const LinearForm> forms, LinearCut& result) : forms_(forms), result_(result) {
    for (std::size_t i = 0; i < forms.size(); ++i) units_[i] = normalised(forms[i].gradient);
  }

  void add(const Tetrahedron& t, std::size_t next, const TruthTable& table) {
    if (table.is_never()) return;
    if (table.is_always()) return add_volume(t);
    while (!table.depends_on(next)) ++next;
    const TruthTable below = table.with(next, false);
    const TruthTable above = table.with(next, true);
    std::array<double, 4> at{};
    for (std::size_t i = 0; i < 4; ++i) at[i] = forms_[next].at(t[i]);
    const TruthTable change = below ^ above;
    cut(
        t, at, [&](const Tetrahedron& part) { add(part, next + 1, below); },
        [&](const Tetrahedron& part) { add(part, next + 1, above); },
        [&](const Triangle& face) { add_face(face, next, next + 1, change); });
  }

 private:
  void add_volume(const Tetrahedron& t) {
    const double volume = dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])) / 6;
    const Vector sum = t[0] + t[1] + t[2] + t[3];
    Moments& m = result_.moments;
    m.volume += volume;
    ++result_.tetrahedra;
    for (std::size_t i = 0; i < 3; ++i) m.first[i] += volume / 4 * sum[i];
    for (std::size_t k = 0; k < 6; ++k) {
      const auto [i, j] = Moments::pair[k];
      double products = sum[i] * sum[j];
      for (const Vector& corner : t) products += corner[i] * corner[j];
      m.second[k] += volume / 20 * products;
    }
  }

  /// Adds a part of the plane `of`. The value changes across it wherever `change` is true.
  void add_face(const Triangle& t, std::size_t of, std::size_t next, const TruthTable& change) {
    if (change.is_never()) return;
    if (change.is_always()) {
      result_.areas[of] += 0.5 * dot(units_[of], cross(t[1] - t[0], t[2] - t[0]));
      ++result_.triangles;
      return;
    }
    while (!change.depends_on(next)) ++next;
    const TruthTable below = change.with(next, false);
    const TruthTable above = change.with(next, true);
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
    const Vector pb = zero_between(t[alone], t[b], at[alone], at[b]);
    const Vector pc = zero_between(t[alone], t[c], at[alone], at[c]);
    add_face({t[alone], pb, pc}, of, next + 1, count == 1 ? below : above);
    add_face({pb, t[b], t[c]}, of, next + 1, count == 1 ? above : below);
    add_face({pb, t[c], pc}, of, next + 1, count == 1 ? above : below);
  }

  std::span<const LinearForm> forms_;
  std::array<Vector, Piece::most_surfaces> units_{};  // the normalised gradients
  LinearCut& result_;
};

}  // namespace

LinearCut cut_linearly(std::span<const LinearForm> forms, const TruthTable& table, Vector half) {
  LinearCut result;
  Cutter cutter(forms, result);
  for (const Tetrahedron& t : tetrahedra_of_box(half)) cutter.add(t, 0, table);
  return result;
}

}  // namespace csgcast::detail
