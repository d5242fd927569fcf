// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "csg/exact/quadric_form.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/solid.h"

// The functions that the makers of leaves share.

namespace csgcast::detail {

/// Throws Error(bad_value) with the statement's name unless all numbers are finite.
void require_finite(const std::string& statement, std::initializer_list<double> numbers);

/// The form n . p - distance, which is <= 0 inside. Throws Error(bad_value) with the statement's name if n = 0.
/// Precondition: the numbers are finite.
QuadricForm plane_form(const std::string& statement, Vector normal, double distance);

/// The half-space where a plane form is <= 0. The form's coefficients must be the numbers that were given.
LeafShape halfspace_shape(QuadricForm plane, Digits digits);

/// The error if each coefficient is a number of a text with these digits. One that counts twice was given as its half.
FormError coefficient_error(const QuadricForm& form, Digits digits);

struct FormWithError {
  QuadricForm form;
  FormError error;
};

/// Sets the forms of the shape, in a fixed order. Forms that are proportional by a positive factor describe the same
/// set f <= 0; one canonical copy of them is kept, with the least error. Errors are about shape.error.center.
/// Precondition: none of the forms is constant.
void set_forms(LeafShape& shape, const std::vector<FormWithError>& forms);

}  // namespace csgcast::detail
