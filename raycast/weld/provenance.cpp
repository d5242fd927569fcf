// SPDX-License-Identifier: MIT
#include "raycast/weld/provenance.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace csgcast::detail {
namespace {

using Form = QuadricForm;
using Matrix = std::array<double, 9>;

// A linear function of s. Its constant comes last.
using LinearForm = std::array<double, 4>;

void add_product(FormError& sum, double factor, const LinearForm& a, const LinearForm& b) {
  if (factor == 0) return;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum[Form::second_degree(i, j)] += factor * a[i] * b[j];
    sum[Form::x + i] += factor * (a[i] * b[3] + a[3] * b[i]);
  }
  sum[Form::one] += factor * a[3] * b[3];
}

// The polynomial with coefficients c in q, where q is a linear function of s.
FormError substituted(const FormError& c, const std::array<LinearForm, 3>& q) {
  static constexpr LinearForm constant{0, 0, 0, 1};
  FormError sum{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = k; l < 3; ++l) add_product(sum, c[Form::second_degree(k, l)], q[k], q[l]);
    add_product(sum, c[Form::x + k], q[k], constant);
  }
  sum[Form::one] += c[Form::one];
  return sum;
}

// Adds the motion of points that are off by up to |off| on each axis. `off` is a function of s. The motion is then
// moved to the world by `linear`.
void add_moved(SmallMotion& motion, const Matrix& linear, const std::array<LinearForm, 3>& off, int exponent) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double factor = std::ldexp(std::fabs(linear[3 * i + k]), -exponent);
      if (factor == 0) continue;
      motion.offset[i] += factor * off[k][3];
      for (std::size_t l = 0; l < 3; ++l) motion.slope[3 * i + l] += factor * off[k][l];
    }
  }
}

// Equal transforms have equal hashes, because adding zero makes a negative zero positive.
std::uint64_t hash(std::uint32_t outer, const Transform& transform) {
  std::uint64_t h = outer;
  for (const double entry : transform.entry) {
    h = (h ^ std::bit_cast<std::uint64_t>(entry + 0.0)) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return h;
}

std::size_t largest(const FormError& form) {
  const auto less = [](double a, double b) { return std::fabs(a) < std::fabs(b); };
  return static_cast<std::size_t>(std::max_element(form.begin(), form.end(), less) - form.begin());
}

}  // namespace

Provenance::Provenance() : turns_(1), linears_(1), links_(1) {
  const std::array<double, 12> errors = Transform().errors();
  for (std::size_t row = 0; row < 3; ++row)
    std::copy_n(errors.begin() + 4 * row, 3, turns_.front().error.begin() + 3 * row);
}

bool Provenance::is_link(const Link& link, ChainId outer, const Transform& transform) const {
  if (link.outer != outer || link.digits != transform.digits) return false;
  for (std::size_t row = 0; row < 3; ++row) {
    if (link.own_offset[row] != transform(row, 3)) return false;
    for (std::size_t column = 0; column < 3; ++column) {
      if (turns_[link.turn].entry[3 * row + column] != transform(row, column)) return false;
    }
  }
  return true;
}

// Sets the linear parts of a link. A translation has no linear part of its own, so the whole is that of the chain
// outside.
void Provenance::set_linear(Link& link, const Transform& transform, const ExactAffine& world_from_solid) {
  const std::array<double, 12> errors = transform.errors();
  Turn turn;
  for (std::size_t row = 0; row < 3; ++row) {
    link.own_offset_error[row] = errors[4 * row + 3];
    for (std::size_t column = 0; column < 3; ++column) {
      turn.entry[3 * row + column] = transform(row, column);
      turn.error[3 * row + column] = errors[4 * row + column];
    }
  }
  has_few_digits_ = has_few_digits_ || transform.digits.are_few();
  if (turn.entry == identity && turn.error == turns_.front().error) {
    link.linear = links_[link.outer].linear;
    return;
  }
  const Dyadic determinant = world_from_solid.determinant();
  const std::int64_t scale = determinant.is_zero() ? 0 : determinant.magnitude();
  const double scaled_determinant = determinant.scaled(-scale).nearest();
  Linear linear;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      linear.forward[3 * row + column] = world_from_solid.linear(row, column).nearest();
      linear.inverse[3 * row + column] =
          world_from_solid.adjugate(row, column).scaled(-scale).nearest() / scaled_determinant;
    }
  }
  link.turn = static_cast<std::uint32_t>(turns_.size());
  turns_.push_back(turn);
  link.linear = static_cast<std::uint32_t>(linears_.size());
  linears_.push_back(linear);
}

Provenance::ChainId Provenance::chain(ChainId outer, const Transform& transform, const ExactAffine& world_from_solid) {
  // The index numbers chains from the first one that is not empty.
  const auto next = static_cast<std::uint32_t>(links_.size() - 1);
  const std::uint32_t number = by_transform_.find_or_add(
      hash(outer, transform), next, [&](std::uint32_t other) { return is_link(links_[other + 1], outer, transform); });
  if (number < next) return number + 1;
  Link link;
  link.outer = outer;
  link.depth = links_[outer].depth + 1;
  link.digits = transform.digits;
  for (std::size_t row = 0; row < 3; ++row) {
    link.own_offset[row] = transform(row, 3);
    link.offset[row] = world_from_solid.offset(row).nearest();
  }
  set_linear(link, transform, world_from_solid);
  links_.push_back(link);
  return number + 1;
}

std::uint32_t Provenance::add_leaf(const Solid& solid, ChainId chain, const Box& box) {
  has_few_digits_ = has_few_digits_ || solid.shape().error.digits.are_few();
  leaves_.push_back({solid, chain, box});
  return static_cast<std::uint32_t>(leaves_.size() - 1);
}

Provenance::ChainId Provenance::common(ChainId a, ChainId b, std::uint64_t& steps) const {
  while (a != b) {
    ++steps;
    const bool a_is_deeper = links_[a].depth >= links_[b].depth;
    const bool b_is_deeper = links_[b].depth >= links_[a].depth;
    if (a_is_deeper) a = links_[a].outer;
    if (b_is_deeper) b = links_[b].outer;
  }
  return a;
}

Provenance::LocalRegion Provenance::local(const Link& link, const Region& region) const {
  const Vector from = as_vector(region.center) - link.offset;
  const Matrix& inverse = linears_[link.linear].inverse;
  LocalRegion result{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) {
      result.at[k] += inverse[3 * k + l] * from[l];
      result.spread[3 * k + l] = std::ldexp(inverse[3 * k + l], region.exponent);
    }
  }
  return result;
}

// The motion by errors of transforms inside `known` and of sizes.
SmallMotion Provenance::motion(const LeafSource& leaf, const Region& region, ChainId known) const {
  const LeafShape& shape = leaf.solid.shape();
  SmallMotion motion;
  for (ChainId id = leaf.chain; id != known; id = links_[id].outer) {
    const Link& link = links_[id];
    const Turn& turn = turns_[link.turn];
    const LocalRegion inside = local(link, region);
    // `off` bounds how far the errors of this transform's own numbers move the points that it maps.
    std::array<LinearForm, 3> off{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const double entry = turn.error[3 * i + j];
        off[i][3] += entry * std::fabs(inside.at[j]);
        for (std::size_t l = 0; l < 3; ++l) off[i][l] += entry * std::fabs(inside.spread[3 * j + l]);
      }
      off[i][3] += link.own_offset_error[i];
    }
    add_moved(motion, linears_[links_[link.outer].linear].forward, off, region.exponent);
  }
  const Link& innermost = links_[leaf.chain];
  const LocalRegion inside = local(innermost, region);
  if (shape.error.axes != Vector{}) {
    std::array<LinearForm, 3> off{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double error = shape.error.axes[i];
      off[i][3] = error * std::fabs(inside.at[i]);
      for (std::size_t l = 0; l < 3; ++l) off[i][l] = error * std::fabs(inside.spread[3 * i + l]);
    }
    add_moved(motion, linears_[innermost.linear].forward, off, region.exponent);
  }
  return motion;
}

FormError Provenance::error(Source source, const RegionForm& form, const Region& region, ChainId known) const {
  const LeafSource& leaf = leaves_[source.leaf];
  const LeafShape& shape = leaf.solid.shape();
  FormError sum = error_of(form, motion(leaf, region, known));
  if (!shape.error.errors.empty()) {
    const FormError own = shape_error(shape, source.form, form, local(links_[leaf.chain], region));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += own[i];
  }
  return sum;
}

double Provenance::displacement(Source source, const RegionForm& form, const Region& region) const {
  const LeafSource& leaf = leaves_[source.leaf];
  double most = 0;
  if (form.is_plane) {
    const FormError off = error(source, form, region, 0);
    const auto& c = form.coefficient;
    most = std::accumulate(off.begin(), off.end(), 0.0) / std::hypot(c[Form::x].high, c[Form::y].high, c[Form::z].high);
  } else {
    const SmallMotion moved = motion(leaf, region, 0);
    for (std::size_t k = 0; k < 3; ++k)
      most = std::fmax(most, moved.offset[k] + moved.slope[3 * k] + moved.slope[3 * k + 1] + moved.slope[3 * k + 2]);
  }
  return std::ldexp(most, region.exponent);
}

// The error of the leaf's own form in the region's coordinates and the scale of the moved form.
FormError Provenance::shape_error(const LeafShape& shape, std::uint32_t form, const RegionForm& moved,
                                  const LocalRegion& local) const {
  RoundedCoefficients rounded{};
  const QuadricForm exact = shape.forms[form];
  round_scaled(exact, rounded);
  const std::size_t largest_term = largest(rounded);
  const double to_rounded = rounded[largest_term] / exact.coefficient[largest_term].nearest();
  std::array<LinearForm, 3> q{};
  std::array<LinearForm, 3> from_center{};
  for (std::size_t k = 0; k < 3; ++k) {
    q[k][3] = local.at[k];
    from_center[k][3] = std::fabs(local.at[k] - shape.error.center[k]);
    for (std::size_t l = 0; l < 3; ++l) {
      q[k][l] = local.spread[3 * k + l];
      from_center[k][l] = std::fabs(q[k][l]);
    }
  }
  // The same form is moved in plain double. Compared with it, the exact one shows by which factor it was scaled.
  const FormError plainly_moved = substituted(rounded, q);
  const std::size_t term = largest(plainly_moved);
  const double factor = std::fabs(moved.coefficient[term].high / plainly_moved[term] * to_rounded);
  FormError error = substituted(shape.error.errors[form], from_center);
  for (double& e : error) e *= factor;
  return error;
}

}  // namespace csgcast::detail
