// SPDX-License-Identifier: MIT
#include "raycast/detail/provenance.h"

#include <algorithm>
#include <cmath>

namespace csgcast::detail {
namespace {

using Form = QuadricForm;
using Matrix = std::array<double, 9>;
constexpr double u = 0x1p-53;

// A linear function of s, the constant last.
using LinearForm = std::array<double, 4>;

void add_product(FormError& sum, double factor, const LinearForm& a, const LinearForm& b) {
  if (factor == 0) return;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum[Form::second_degree(i, j)] += factor * a[i] * b[j];
    sum[Form::x + i] += factor * (a[i] * b[3] + a[3] * b[i]);
  }
  sum[Form::one] += factor * a[3] * b[3];
}

// The polynomial with these coefficients in q, where q is a linear function of s.
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

// Adds what the points at + spread s, known to |off| on each axis and moved by `linear` to the world, may be off.
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

std::size_t largest(const FormError& form) {
  const auto less = [](double a, double b) { return std::fabs(a) < std::fabs(b); };
  return static_cast<std::size_t>(std::max_element(form.begin(), form.end(), less) - form.begin());
}

}  // namespace

Provenance::Provenance() : links_(1) {}

Provenance::ChainId Provenance::chain(ChainId outer, const Transform& transform, const ExactAffine& world_from_solid) {
  const auto [it, is_new] = known_.try_emplace({outer, transform.entry}, static_cast<ChainId>(links_.size()));
  if (!is_new) return it->second;
  Link link;
  link.outer = outer;
  link.depth = links_[outer].depth + 1;
  link.transform = transform;
  const Dyadic determinant = world_from_solid.determinant();
  const std::int64_t scale = determinant.is_zero() ? 0 : determinant.magnitude();
  const double scaled_determinant = determinant.scaled(-scale).nearest();
  for (std::size_t row = 0; row < 3; ++row) {
    link.offset[row] = world_from_solid.offset(row).nearest();
    for (std::size_t column = 0; column < 3; ++column) {
      link.linear[3 * row + column] = world_from_solid.linear(row, column).nearest();
      link.inverse[3 * row + column] =
          world_from_solid.adjugate(row, column).scaled(-scale).nearest() / scaled_determinant;
    }
  }
  links_.push_back(link);
  return it->second;
}

std::uint32_t Provenance::add_leaf(const Solid& solid, ChainId chain, const Box& box) {
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
  LocalRegion result{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) {
      result.at[k] += link.inverse[3 * k + l] * from[l];
      result.spread[3 * k + l] = std::ldexp(link.inverse[3 * k + l], region.exponent);
    }
  }
  return result;
}

FormError Provenance::error(Source source, const RegionForm& form, const Region& region, ChainId known) const {
  const LeafSource& leaf = leaves_[source.leaf];
  const LeafShape& shape = leaf.solid.shape();
  SmallMotion motion;
  for (ChainId id = leaf.chain; id != known; id = links_[id].outer) {
    const Link& link = links_[id];
    const LocalRegion inside = local(link, region);
    // What this one transform's own numbers may be off, over the points that it moves.
    std::array<LinearForm, 3> off{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const double entry = u * std::fabs(link.transform(i, j)) + link.transform.linear_error;
        off[i][3] += entry * std::fabs(inside.at[j]);
        for (std::size_t l = 0; l < 3; ++l) off[i][l] += entry * std::fabs(inside.spread[3 * j + l]);
      }
      off[i][3] += u * std::fabs(link.transform(i, 3));
    }
    add_moved(motion, links_[link.outer].linear, off, region.exponent);
  }
  const Link& innermost = links_[leaf.chain];
  const LocalRegion inside = local(innermost, region);
  if (shape.error.scales_with_axes) {
    std::array<LinearForm, 3> off{};
    for (std::size_t i = 0; i < 3; ++i) {
      off[i][3] = u * std::fabs(inside.at[i]);
      for (std::size_t l = 0; l < 3; ++l) off[i][l] = u * std::fabs(inside.spread[3 * i + l]);
    }
    add_moved(motion, innermost.linear, off, region.exponent);
  }
  FormError sum = error_of(form, motion);
  if (!shape.error.errors.empty()) {
    const FormError own = shape_error(shape, source.form, form, inside);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += own[i];
  }
  return sum;
}

// The error of the leaf's own form in the region's coordinates and the scale of the moved form.
FormError Provenance::shape_error(const LeafShape& shape, std::uint32_t form, const RegionForm& moved,
                                  const LocalRegion& local) const {
  RoundedCoefficients rounded{};
  round_scaled(shape.forms[form], rounded);
  const std::size_t largest_term = largest(rounded);
  const double to_rounded = rounded[largest_term] / shape.forms[form].coefficient[largest_term].nearest();
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
  // The same form, moved in plain double, tells by which factor the exact one was scaled.
  const FormError plainly_moved = substituted(rounded, q);
  const std::size_t term = largest(plainly_moved);
  const double factor = std::fabs(moved.coefficient[term].high / plainly_moved[term] * to_rounded);
  FormError error = substituted(shape.error.errors[form], from_center);
  for (double& e : error) e *= factor;
  return error;
}

}  // namespace csgcast::detail
