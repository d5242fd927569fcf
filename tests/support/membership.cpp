// SPDX-License-Identifier: MIT
#include "tests/support/membership.h"

#include <algorithm>
#include <vector>

#include "csg/solid/leaf_shape.h"

namespace csgcast::test {
namespace {

// (x, y, z) / w with w > 0.
struct Homogeneous {
  ExactPoint p;
  Dyadic w;
};

Homogeneous undo(const Transform& transform, const Homogeneous& at) {
  const ExactAffine m(transform);
  Homogeneous result{{}, m.determinant() * at.w};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result.p[i] += m.adjugate(i, j) * (at.p[j] - m.offset(j) * at.w);
  }
  if (result.w.sign() < 0) {
    result.w = -result.w;
    for (Dyadic& c : result.p) c = -c;
  }
  return result;
}

int sign_of(const QuadricForm& f, const Homogeneous& at) {
  using Form = QuadricForm;
  const auto& c = f.coefficient;
  const auto& [x, y, z] = at.p;
  const Dyadic second = c[Form::xx] * x * x + c[Form::yy] * y * y + c[Form::zz] * z * z + c[Form::xy] * x * y +
                        c[Form::xz] * x * z + c[Form::yz] * y * z;
  const Dyadic first = c[Form::x] * x + c[Form::y] * y + c[Form::z] * z;
  return (second + first * at.w + c[Form::one] * at.w * at.w).sign();
}

std::optional<bool> in_leaf(const LeafShape& shape, const Homogeneous& at) {
  std::vector<Truth> holds;
  for (const QuadricForm& form : shape.forms) {
    const int sign = sign_of(form, at);
    if (sign == 0) return std::nullopt;
    holds.push_back(truth(sign < 0));
  }
  if (shape.inside == nullptr) return std::find(holds.begin(), holds.end(), Truth::no) == holds.end();
  std::vector<Truth> values(shape.inside->size());
  evaluate(*shape.inside, holds, values);
  return values.front() == Truth::yes;
}

// Test trees are shallow: recursion reads best.
std::optional<bool> contains(const Solid& solid, const Homogeneous& at) {
  using Kind = Solid::Kind;
  const Kind kind = solid.kind();
  if (kind == Kind::empty) return false;
  if (kind == Kind::everything) return true;
  if (kind == Kind::leaf) return in_leaf(solid.shape(), at);
  const Homogeneous below = kind == Kind::transform ? undo(solid.transform(), at) : at;
  std::optional<bool> value;
  for (const Solid& child : solid.children()) {
    const std::optional<bool> in_child = contains(child, below);
    if (!in_child) return std::nullopt;
    if (!value) {
      value = kind == Kind::complement ? !*in_child : *in_child;
    } else if (kind == Kind::unite) {
      value = *value || *in_child;
    } else if (kind == Kind::intersect) {
      value = *value && *in_child;
    } else {
      value = *value && !*in_child;
    }
  }
  return value;
}

}  // namespace

std::optional<bool> contains(const Solid& solid, Point p) {
  return contains(solid, Homogeneous{{Dyadic(p.x), Dyadic(p.y), Dyadic(p.z)}, Dyadic(1.0)});
}

}  // namespace csgcast::test
