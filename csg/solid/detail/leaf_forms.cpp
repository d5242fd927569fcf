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

bool is_mixed(std::size_t term) {
  return term == QuadricForm::xy || term == QuadricForm::xz || term == QuadricForm::yz;
}

bool is_second_degree(std::size_t term) { return term < QuadricForm::x; }

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

LeafShape halfspace_shape(QuadricForm plane, Digits digits) {
  LeafShape shape;
  shape.kind = LeafKind::halfspace;
  shape.bounds = bounds(plane);
  shape.is_convex_polyhedron = true;
  shape.error.axes = {};
  shape.error.digits = digits;
  shape.error.errors.push_back(coefficient_error(plane, digits));
  shape.forms.push_back(plane);
  return shape;
}

FormError coefficient_error(const QuadricForm& form, Digits digits) {
  using Form = QuadricForm;
  std::array<double, Form::term_count> given;
  bool has_longest = false;
  for (std::size_t i = 0; i < given.size(); ++i) {
    given[i] = form.coefficient[i].nearest() * (is_mixed(i) ? 0.5 : 1);
    has_longest = has_longest || (is_second_degree(i) && digits.uses_all(given[i]));
  }
  FormError error;
  for (std::size_t i = 0; i < error.size(); ++i) {
    const bool beside_longer = has_longest && is_second_degree(i);
    error[i] = (beside_longer ? digits.error_beside_longer(given[i]) : digits.error(given[i])) * (is_mixed(i) ? 2 : 1);
  }
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
  shape.error.axes = {};
  shape.forms.reserve(sorted.size());
  shape.error.errors.reserve(sorted.size());
  for (const FormWithError& f : sorted) {
    shape.forms.push_back(f.form);
    shape.error.errors.push_back(f.error);
  }
}

}  // namespace csgcast::detail
