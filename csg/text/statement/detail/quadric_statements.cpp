// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>

#include "csg/solid/primitives.h"
#include "csg/text/statement/detail/solid_statements.h"

namespace csgcast::text {
namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;

Matrix3 symmetric_matrix(const Call& call, std::string_view name) {
  const List* rows = call.list(name);
  if (rows == nullptr) call.missing(name, "a symmetric 3x3 matrix [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]");
  call.require(rows->size() == 3, name, "have three rows");
  Matrix3 matrix{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector row = call.vector_entry((*rows)[i], "a row of the matrix");
    for (std::size_t j = 0; j < 3; ++j) matrix[i][j] = row[j];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (matrix[i][j] == matrix[j][i]) continue;
      const Value& entry = std::get<List>((*rows)[i].data)[j];
      call.reject(ErrorCode::bad_value, call.place(entry),
                  fmt::format("the matrix '{}' of '{}' is not symmetric", name, call.name()),
                  fmt::format("row {} column {} is {}, row {} column {} is {}", i + 1, j + 1, matrix[i][j], j + 1,
                              i + 1, matrix[j][i]),
                  "give both entries half of what the product counts in all");
    }
  }
  return matrix;
}

}  // namespace

Solid make_ellipsoid(const Call& call) {
  return warn_if_empty(call, ellipsoid(call.required_vector("r"), call.digits()), "a semi-axis is not greater than 0");
}

Solid make_paraboloid(const Call& call) {
  const double h = call.required_number("h");
  const double r = call.required_number("r");
  return warn_if_empty(call, paraboloid(h, r, call.digits()), "h or r is not greater than 0");
}

Solid make_hyperboloid(const Call& call) {
  const double h = call.required_number("h");
  const double r = call.required_number("r");
  const double waist = call.required_number("waist");
  return warn_if_empty(call, hyperboloid(h, r, waist, call.digits()),
                       "it needs h > 0 and radii that are not negative and not both 0");
}

Solid make_quadric(const Call& call) {
  const Matrix3 a = symmetric_matrix(call, "A");
  const Vector b = call.required_vector("b");
  const double c = call.required_number("c");
  return warn_if_empty(call, quadric({a[0][0], a[1][1], a[2][2], a[0][1], a[0][2], a[1][2]}, b, c, call.digits()),
                       "no region satisfies its inequality");
}

Solid make_halfspace(const Call& call) {
  const Vector normal = call.required_vector("n");
  call.require(normal != Vector{}, "n", "not be the zero vector");
  return halfspace(normal, call.required_number("d"), call.digits());
}

}  // namespace csgcast::text
