// SPDX-License-Identifier: MIT
#include "measure/sheet/piece_forms.h"

#include <cmath>

#include "csg/base/truth_table.h"

namespace csgcast::detail {

double value_at(const LocalForm& form, Vector d) {
  double value = form.value + dot(form.gradient, d);
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = Moments::pair[k];
    value += form.bend[k] * d[i] * d[j];
  }
  return value;
}

PieceForms::PieceForms(const Space& space, const Piece& piece)
    : count(piece.is_crowded() ? 0 : piece.count), table(piece.table) {
  middle = 0.5 * (piece.box.upper + piece.box.lower);
  half = 0.5 * (piece.box.upper - piece.box.lower);
  for (std::size_t i = 0; i < count; ++i) {
    are_known = are_known && space.is_known(piece.surfaces[i]);
    f[i] = local_form(space.form(piece.surfaces[i]), piece.box);
    is_plane[i] = space.is_plane(piece.surfaces[i]);
    surface[i] = piece.surfaces[i];
  }
  if (are_known) merge_twins();
}

void PieceForms::merge_twins() {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count;) {
      if (!is_plane[i] || !is_plane[j] || !merge(i, j)) {
        ++j;
        continue;
      }
      // The last one moves to the free place.
      const std::size_t last = --count;
      if (j != last) {
        f[j] = f[last];
        is_plane[j] = is_plane[last];
        surface[j] = surface[last];
        table = table.renamed(last, j);
      }
    }
  }
}

/// If planes i and j are twins, plane i replaces plane j, and the table no longer depends on j.
bool PieceForms::merge(std::size_t i, std::size_t j) {
  const double s = dot(f[j].gradient, f[i].gradient) / dot(f[i].gradient, f[i].gradient);
  if (!(std::fabs(s) > 0)) return false;
  const Vector rest = f[j].gradient - s * f[i].gradient;
  double apart = std::fabs(f[j].value - s * f[i].value);
  for (std::size_t axis = 0; axis < 3; ++axis) apart += std::fabs(rest[axis]) * half[axis];
  if (!(apart <= std::fabs(s) * f[i].slack + f[j].slack)) return false;
  const auto value = [&](bool of_i, bool of_j) { return table.with(i, of_i).with(j, of_j); };
  const bool is_same_way = s > 0;
  const TruthTable below = value(false, !is_same_way);
  const TruthTable above = value(true, is_same_way);
  const TruthTable between = (value(false, is_same_way) ^ below) | (value(true, !is_same_way) ^ below);
  if (exceeds(between, below ^ above)) return false;  // between the two there is a thin sheet of the solid, or a gap
  table = TruthTable::by(i, below, above);
  f[i].slack += (apart + f[j].slack) / std::fabs(s);
  return true;
}

Range PieceForms::bend_of(const LocalForm& form) const {
  Range range;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = Moments::pair[k];
    const double most = form.bend[k] * half[i] * half[j];
    range.low -= i == j ? std::fmax(0, -most) : std::fabs(most);
    range.high += i == j ? std::fmax(0, most) : std::fabs(most);
  }
  return range;
}

bool PieceForms::surely_hold(Vector d) const {
  TruthTable values = table;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = value_at(f[i], d);
    if (std::fabs(value) > 2 * f[i].slack) values = values.with(i, value > 0);
  }
  return values.is_always();
}

Range PieceForms::slope_of(const LocalForm& form, std::size_t axis) const {
  // The slope of a polynomial of second degree is at most 4 / h times its greatest value (Markov).
  double reach = 4 * form.slack / half[axis];
  for (std::size_t j = 0; j < 3; ++j) reach += std::fabs(bend_along(form, axis, j)) * half[j] * (j == axis ? 2 : 1);
  return {form.gradient[axis] - reach, form.gradient[axis] + reach};
}

}  // namespace csgcast::detail
