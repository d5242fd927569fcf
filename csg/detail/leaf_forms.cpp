// SPDX-License-Identifier: MIT
#include "csg/detail/leaf_forms.h"

#include <algorithm>
#include <cmath>

#include "csg/detail/form_bounds.h"
#include "csg/error.h"

namespace csgcast::detail {

void require_finite(const std::string& statement, std::initializer_list<double> numbers) {
  if (std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); })) return;
  throw Error(ErrorCode::bad_value, {}, statement + ": a number is not finite",
              "sizes and coefficients are exact numbers", "give finite numbers");
}

QuadricForm plane_form(const std::string& statement, Vector normal, double distance) {
  if (normal == Vector{}) {
    throw Error(ErrorCode::bad_value, {}, statement + ": the normal of a plane is zero", "it has no direction",
                "give a normal with a non-zero component");
  }
  return QuadricForm::plane(normal.x, normal.y, normal.z, -Dyadic(distance));
}

LeafShape halfspace_shape(QuadricForm plane) {
  LeafShape shape;
  shape.kind = "halfspace";
  shape.bounds = bounds(plane);
  shape.is_convex_polyhedron = true;
  shape.forms.push_back(std::move(plane));
  return shape;
}

std::vector<QuadricForm> without_duplicates(const std::vector<QuadricForm>& forms) {
  std::vector<QuadricForm> result;
  result.reserve(forms.size());
  for (const QuadricForm& f : forms) {
    CanonicalForm c = canonical(f);
    result.push_back(c.flipped ? -c.form : std::move(c.form));
  }
  const auto less = [](const QuadricForm& a, const QuadricForm& b) {
    return std::lexicographical_compare(a.coefficient.begin(), a.coefficient.end(), b.coefficient.begin(),
                                        b.coefficient.end());
  };
  std::sort(result.begin(), result.end(), less);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace csgcast::detail
