// SPDX-License-Identifier: MIT
#include "csg/text/statement/detail/transform_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "csg/exact/affine.h"

namespace csgcast::text {
namespace {

using Matrix4 = std::array<std::array<double, 4>, 4>;

Combine move_by(const Call& call, const Transform& transform) {
  const bool finite = transform.is_finite();
  if (!finite) call.warn(fmt::format("'{}' is empty: its matrix is not finite", call.name()));
  if (finite && ExactAffine(transform).is_singular()) {
    call.warn(fmt::format("'{}' is empty: its matrix is singular", call.name()));
  }
  return [transform, finite](std::vector<Solid> children) {
    return finite ? transformed(unite(std::move(children)), transform) : Solid();
  };
}

// Quotients have other digits than the entries, so what these may be off goes along.
Transform divided(const Transform& t, double by) {
  Transform result;
  const bool finite = t.is_finite();
  const std::array<double, 12> errors = finite ? t.errors() : std::array<double, 12>{};
  for (std::size_t i = 0; i < errors.size(); ++i) {
    result.entry[i] = t.entry[i] / by;
    if (!t.digits.are_few() && t.linear_error == 0 && t.offset_error == 0) continue;
    double& most = i % 4 == 3 ? result.offset_error : result.linear_error;
    most = std::fmax(most, std::fabs(errors[i] / by));
  }
  return result;
}

void require_at_most_four(const Call& call, const Value& place, std::size_t count, std::string_view what) {
  if (count <= 4) return;
  call.reject(ErrorCode::bad_value, call.place(place), fmt::format("the matrix of 'multmatrix' has {} {}", count, what),
              "four are the most", "give a 4x4 matrix");
}

Matrix4 read_matrix(const Call& call) {
  Matrix4 m{};
  for (std::size_t i = 0; i < 4; ++i) m[i][i] = 1;
  const List* rows = call.list("m");
  if (rows == nullptr) call.missing("m", "a 4x4 matrix");
  require_at_most_four(call, *call.find("m"), rows->size(), "rows");
  for (std::size_t i = 0; i < rows->size(); ++i) {
    if (counts_as_undef((*rows)[i])) continue;
    const List& row = call.list_entry((*rows)[i], "a row of the matrix");
    require_at_most_four(call, (*rows)[i], row.size(), "columns");
    for (std::size_t j = 0; j < row.size(); ++j) {
      if (!counts_as_undef(row[j])) m[i][j] = call.entry(row[j], "a matrix entry");
    }
  }
  return m;
}

// `error`, which csgcast writes: how far entries of the linear part and of the last column are off. Then their digits
// tell nothing.
void read_errors(const Call& call, Transform& transform) {
  const List* errors = call.list("error");
  if (errors == nullptr) return;
  call.require(errors->size() == 2, "error", "be a list of two numbers, of the linear part and the last column");
  const std::array<double, 2> read{call.entry((*errors)[0], "an error"), call.entry((*errors)[1], "an error")};
  call.require(read[0] >= 0 && read[1] >= 0, "error", "not be negative");
  transform.digits = {};
  transform.linear_error = read[0];
  transform.offset_error = read[1];
}

}  // namespace

Combine make_multmatrix(const Call& call) {
  const Matrix4 m = read_matrix(call);
  if (m[3][0] != 0 || m[3][1] != 0 || m[3][2] != 0) {
    call.warn("the last row of 'multmatrix' asks for a perspective, which is ignored, as in OpenSCAD");
  }
  Transform transform;
  for (std::size_t i = 0; i < 3; ++i) std::copy(m[i].begin(), m[i].end(), transform.entry.begin() + 4 * i);
  transform.digits = call.digits();
  read_errors(call, transform);
  if (m[3][3] != 1) transform = divided(transform, m[3][3]);
  return move_by(call, transform);
}

Combine make_translate(const Call& call) {
  const auto offset = call.padded_vector("v", 0);
  if (!offset) call.missing("v", "a list of three numbers");
  return move_by(call, translation(*offset, call.digits()));
}

Combine make_rotate(const Call& call) {
  const Value* angle = call.find("a");
  if (angle == nullptr) call.missing("a", "an angle in degrees, or a list of three angles");
  if (std::holds_alternative<List>(angle->data)) {
    const auto angles = call.padded_vector("a", 0);
    if (!angles) call.missing("a", "a list of three angles in degrees");
    if (call.find("v") != nullptr) call.warn("'v' of 'rotate' is ignored, since 'a' is a list");
    return move_by(call, rotation(*angles, call.digits()));
  }
  const double degrees = call.required_number("a");
  return move_by(call, rotation(degrees, call.vector("v").value_or(Vector{0, 0, 1}), call.digits()));
}

Combine make_scale(const Call& call) {
  const Value* factor = call.find("v");
  if (factor != nullptr && std::holds_alternative<double>(factor->data)) {
    const double f = call.required_number("v");
    return move_by(call, scaling({f, f, f}, call.digits()));
  }
  const auto factors = call.padded_vector("v", 1);
  if (!factors) call.missing("v", "a factor, or a list of three");
  return move_by(call, scaling(*factors, call.digits()));
}

Combine make_mirror(const Call& call) {
  const auto normal = call.padded_vector("v", 0);
  if (!normal) call.missing("v", "the normal of the mirror's plane, a list of three numbers");
  return move_by(call, mirroring(*normal, call.digits()));
}

}  // namespace csgcast::text
