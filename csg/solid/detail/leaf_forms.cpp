// SPDX-License-Identifier: MIT
#include "csg/solid/detail/leaf_forms.h"

#include <algorithm>
#include <cmath>
#include <compare>

#include "csg/base/error.h"
#include "csg/base/length.h"
#include "csg/base/precondition.h"
#include "csg/solid/detail/form_bounds.h"

namespace csgcast::detail {
namespace {

double magnitude_sum(const QuadricForm& form) {
  double sum = 0;
  for (const Dyadic& c : form.coefficient) sum += std::fabs(c.nearest());
  return sum;
}

}  // namespace

void require_finite(const std::string& statement, std::initializer_list<double> numbers) {
  if (std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); })) return;
  throw Error(ErrorCode::bad_value, {}, statement + ": a number is not finite",
              "sizes and coefficients are exact numbers", "give finite numbers");
}

QuadricForm plane_form(const std::string& statement, Vector normal, double distance) {
  CSGCAST_PRECONDITION(is_finite(normal) && std::isfinite(distance));
  if (normal == Vector{}) {
    throw Error(ErrorCode::bad_value, {}, statement + ": the normal of a plane is zero", "it has no direction",
                "give a normal with a non-zero component");
  }
  return QuadricForm::plane(normal.x, normal.y, normal.z, -Dyadic(distance));
}

LeafShape halfspace_shape(QuadricForm plane) {
  LeafShape shape;
  shape.kind = LeafKind::halfspace;
  shape.bounds = bounds(plane);
  shape.is_convex_polyhedron = true;
  shape.error.scales_with_axes = false;
  shape.error.errors.push_back(coefficient_error(plane));
  shape.forms.push_back(plane);
  return shape;
}

FormError coefficient_error(const QuadricForm& form) {
  FormError error;
  for (std::size_t i = 0; i < error.size(); ++i) error[i] = 0x1p-53 * std::fabs(form.coefficient[i].nearest());
  return error;
}

void set_forms(LeafShape& shape, const std::vector<FormWithError>& forms) {
  std::vector<FormWithError> sorted;
  sorted.reserve(forms.size());
  for (const auto& [form, error] : forms) {
    CSGCAST_PRECONDITION(!form.is_constant());
    CanonicalForm c = canonical(form);
    FormError scaled = error;
    const double scale = magnitude_sum(c.form) / magnitude_sum(form);
    for (double& e : scaled) e *= scale;
    sorted.push_back({c.flipped ? -c.form : std::move(c.form), scaled});
  }
  const auto less = [](const FormWithError& a, const FormWithError& b) {
    const auto& fa = a.form.coefficient;
    const auto& fb = b.form.coefficient;
    const auto order = std::lexicographical_compare_three_way(fa.begin(), fa.end(), fb.begin(), fb.end());
    return order < 0 || (order == 0 && a.error < b.error);
  };
  const auto same = [](const FormWithError& a, const FormWithError& b) { return a.form == b.form; };
  std::sort(sorted.begin(), sorted.end(), less);
  sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
  shape.error.scales_with_axes = false;
  shape.forms.reserve(sorted.size());
  shape.error.errors.reserve(sorted.size());
  for (const FormWithError& f : sorted) {
    shape.forms.push_back(f.form);
    shape.error.errors.push_back(f.error);
  }
}

}  // namespace csgcast::detail
