// SPDX-License-Identifier: MIT
#include "measure/detail/piece_forms.h"

#include <cmath>

namespace csgcast::detail {

PieceForms::PieceForms(const Space& space, const Piece& piece) : count(piece.is_crowded() ? 0 : piece.count) {
  middle = 0.5 * (piece.box.upper + piece.box.lower);
  half = 0.5 * (piece.box.upper - piece.box.lower);
  for (std::size_t i = 0; i < count; ++i) {
    are_known = are_known && space.is_known(piece.surfaces[i]);
    f[i] = local_form(space.form(piece.surfaces[i]), piece.box);
    is_plane[i] = space.is_plane(piece.surfaces[i]);
  }
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

Range PieceForms::slope_of(const LocalForm& form, std::size_t axis) const {
  double reach = 0;
  for (std::size_t j = 0; j < 3; ++j) reach += std::fabs(bend_along(form, axis, j)) * half[j] * (j == axis ? 2 : 1);
  return {form.gradient[axis] - reach, form.gradient[axis] + reach};
}

}  // namespace csgcast::detail
