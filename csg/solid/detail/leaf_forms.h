// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "csg/exact/quadric_form.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/solid.h"

// What the makers of leaves share.

namespace csgcast::detail {

/// Throws Error(bad_value) that names the statement unless all numbers are finite.
void require_finite(const std::string& statement, std::initializer_list<double> numbers);

/// n . p - distance, which is <= 0 inside. Throws Error(bad_value) that names the statement if n = 0. Precondition:
/// finite numbers.
QuadricForm plane_form(const std::string& statement, Vector normal, double distance);

/// The half-space where a plane form, whose coefficients are the numbers given, is <= 0.
LeafShape halfspace_shape(QuadricForm plane);

/// Each coefficient known to half an ulp.
FormError coefficient_error(const QuadricForm& form);

struct FormWithError {
  QuadricForm form;
  FormError error;
};

/// Gives the shape one canonical copy of each set f <= 0 among the forms (proportional by a positive factor: the same,
/// the least error is kept), in a fixed order; errors are about shape.error.center. Precondition: none of them is
/// constant.
void set_forms(LeafShape& shape, const std::vector<FormWithError>& forms);

}  // namespace csgcast::detail
