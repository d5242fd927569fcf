// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "csg/base/precondition.h"
#include "csg/exact/affine.h"
#include "csg/exact/directed.h"
#include "csg/solid/bounds.h"
#include "csg/solid/detail/form_bounds.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/solid.h"

namespace csgcast {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The least or largest value of one row of an affine map over all points. Doubles with a bound on their error choose
// the candidates, and exact arithmetic decides among them.
class RowExtent {
 public:
  RowExtent(const ExactAffine& m, std::size_t row) : m_(m), row_(row) {
    for (std::size_t i = 0; i < 3; ++i) linear_[i] = m.linear(row, i).nearest();
    offset_ = m.offset(row).nearest();
  }

  Dyadic least(std::span<const Point> points) const { return extreme(points, 1); }
  Dyadic greatest(std::span<const Point> points) const { return extreme(points, -1); }

 private:
  struct Estimate {
    double value = 0;
    double error = 0;
  };

  // Each of the four terms goes through at most six roundings of half an ulp: of its coefficient, product and sums. The
  // last summand covers what is lost when coefficients and products underflow.
  Estimate estimate(Point p) const {
    const double tx = linear_[0] * p.x, ty = linear_[1] * p.y, tz = linear_[2] * p.z;
    const double size = std::fabs(tx) + std::fabs(ty) + std::fabs(tz) + std::fabs(offset_);
    const double reach = 1 + std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z);
    return {tx + ty + tz + offset_, 16 * 0x1p-53 * size + 0x1p-1070 * reach};
  }

  Dyadic exact(Point p) const {
    Dyadic sum = m_.offset(row_);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!m_.linear(row_, i).is_zero() && p[i] != 0) sum += m_.linear(row_, i) * Dyadic(p[i]);
    }
    return sum;
  }

  Dyadic extreme(std::span<const Point> points, double sense) const {
    double surely = infinity;  // an upper bound that is certain
    for (const Point& p : points) {
      const Estimate e = estimate(p);
      surely = std::fmin(surely, sense * e.value + e.error);
    }
    std::optional<Dyadic> best;
    for (const Point& p : points) {
      const Estimate e = estimate(p);
      if (sense * e.value - e.error > surely) continue;  // false for NaN, which overflow causes
      Dyadic value = exact(p);
      if (!best || (sense > 0 ? value < *best : value > *best)) best = std::move(value);
    }
    return best.value_or(Dyadic());
  }

  const ExactAffine& m_;
  std::size_t row_;
  std::array<double, 3> linear_{};
  double offset_ = 0;
};

Box image_of_points(std::span<const Point> points, const ExactAffine& m) {
  Box box;
  for (std::size_t row = 0; row < 3; ++row) {
    const RowExtent extent(m, row);
    box.lower[row] = extent.least(points).rounded_down();
    box.upper[row] = extent.greatest(points).rounded_up();
  }
  return box;
}

void set_row(Box& box, std::size_t row, const Dyadic& center, const Dyadic& reach) {
  box.lower[row] = (center - reach).rounded_down();
  box.upper[row] = (center + reach).rounded_up();
}

// The length of a vector, rounded up. The length along an axis needs no root.
Dyadic length(std::span<const Dyadic> vector) {
  const Dyadic* only = nullptr;
  std::size_t terms = 0;
  for (const Dyadic& c : vector) {
    if (c.is_zero()) continue;
    only = &c;
    ++terms;
  }
  if (terms == 0) return {};
  if (terms == 1) return only->sign() < 0 ? -*only : *only;
  Dyadic square;
  for (const Dyadic& c : vector) square += c * c;
  return detail::square_root(square, detail::Toward::up);
}

// The extent of a moved ellipsoid along an axis is the length of that row of the map, times the semi-axes.
Box image_of_ellipsoid(Vector semi_axes, const ExactAffine& m) {
  Box box;
  for (std::size_t row = 0; row < 3; ++row) {
    std::array<Dyadic, 3> reach;
    for (std::size_t i = 0; i < 3; ++i) reach[i] = m.linear(row, i) * Dyadic(semi_axes[i]);
    set_row(box, row, m.offset(row), length(reach));
  }
  return box;
}

Box image_of_disc(const Disc& disc, const ExactAffine& m) {
  Box box;
  for (std::size_t row = 0; row < 3; ++row) {
    const Dyadic reach = Dyadic(disc.radius) * length(std::array{m.linear(row, 0), m.linear(row, 1)});
    set_row(box, row, m.offset(row) + m.linear(row, 2) * Dyadic(disc.z), reach);
  }
  return box;
}

Box image_of_discs(std::span<const Disc> discs, const ExactAffine& m) {
  Box box;
  for (const Disc& disc : discs) box = hull(box, image_of_disc(disc, m));
  return box;
}

}  // namespace

Box image(const Box& box, const ExactAffine& world_from_solid) {
  if (box.is_null()) return {};
  Box result;
  for (std::size_t row = 0; row < 3; ++row) {
    Dyadic least = world_from_solid.offset(row), greatest = least;
    bool bounded_below = true, bounded_above = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Dyadic& factor = world_from_solid.linear(row, i);
      if (factor.is_zero()) continue;  // then even an infinite side does not matter
      const double low = factor.sign() > 0 ? box.lower[i] : box.upper[i];
      const double high = factor.sign() > 0 ? box.upper[i] : box.lower[i];
      bounded_below = bounded_below && std::isfinite(low);
      bounded_above = bounded_above && std::isfinite(high);
      if (bounded_below) least += factor * Dyadic(low);
      if (bounded_above) greatest += factor * Dyadic(high);
    }
    result.lower[row] = bounded_below ? least.rounded_down() : -infinity;
    result.upper[row] = bounded_above ? greatest.rounded_up() : infinity;
  }
  return result;
}

Box world_bounds(const LeafShape& shape, const ExactAffine& world_from_solid) {
  CSGCAST_PRECONDITION(!world_from_solid.is_singular());
  static const ExactAffine identity;
  if (world_from_solid == identity) return shape.bounds;
  if (!shape.vertices.empty()) return image_of_points(shape.vertices, world_from_solid);
  if (shape.semi_axes) return image_of_ellipsoid(*shape.semi_axes, world_from_solid);
  if (!shape.discs.empty()) return image_of_discs(shape.discs, world_from_solid);
  const Box box = image(shape.bounds, world_from_solid);
  if (shape.forms.size() != 1 || !shape.others.empty() || shape.inside != nullptr) return box;
  return intersection(box, detail::bounds(FormMover(world_from_solid).moved(shape.forms.front())));
}

}  // namespace csgcast
