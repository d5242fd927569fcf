// SPDX-License-Identifier: MIT
#include "csg/exact/quadric_kind.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "csg/base/precondition.h"
#include "csg/exact/directed.h"
#include "csg/exact/symmetric_eigen.h"

namespace csgcast {
namespace {

using Form = QuadricForm;
using Kind = QuadricKind;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The symmetric 4 x 4 matrix of twice the form: 2 f(p) = (p, 1)' m (p, 1).
using Matrix = std::array<std::array<Dyadic, 4>, 4>;

Matrix matrix_of(const Form& form) {
  const auto& c = form.coefficient;
  Matrix m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Dyadic& entry = c[Form::second_degree(std::min(i, j), std::max(i, j))];
      m[i][j] = i == j ? entry.scaled(1) : entry;
    }
    m[i][3] = m[3][i] = c[Form::x + i];
  }
  m[3][3] = c[Form::one].scaled(1);
  return m;
}

/// Of the rows and columns i < j.
Dyadic minor2(const Matrix& m, std::size_t i, std::size_t j) { return m[i][i] * m[j][j] - m[i][j] * m[i][j]; }

/// Of the rows and columns i < j < k.
Dyadic minor3(const Matrix& m, std::size_t i, std::size_t j, std::size_t k) {
  return m[i][i] * minor2(m, j, k) - m[i][j] * (m[i][j] * m[k][k] - m[j][k] * m[i][k]) +
         m[i][k] * (m[i][j] * m[j][k] - m[j][j] * m[i][k]);
}

/// The minor of all rows but the last, and all columns but `left_out`.
Dyadic minor_of_first_rows(const Matrix& m, std::size_t left_out) {
  std::array<std::size_t, 3> c{};
  for (std::size_t i = 0; i < 3; ++i) c[i] = i < left_out ? i : i + 1;
  const auto pair = [&](std::size_t a, std::size_t b) { return m[1][c[a]] * m[2][c[b]] - m[1][c[b]] * m[2][c[a]]; };
  return m[0][c[0]] * pair(1, 2) - m[0][c[1]] * pair(0, 2) + m[0][c[2]] * pair(0, 1);
}

Dyadic determinant(const Matrix& m) {
  Dyadic sum;
  for (std::size_t k = 0; k < 4; ++k) {
    const Dyadic term = m[3][k].is_zero() ? Dyadic() : m[3][k] * minor_of_first_rows(m, k);
    k % 2 == 1 ? sum += term : sum -= term;
  }
  return sum;
}

/// How many eigenvalues are positive and negative.
struct Signature {
  int positive = 0;
  int negative = 0;
  int rank() const { return positive + negative; }
};

/// From the elementary symmetric functions of the eigenvalues, the sums of principal minors: e1, e2, .. As all
/// eigenvalues are real, Descartes's rule of signs counts exactly.
Signature signature(std::span<const Dyadic> e) {
  Signature result;
  int last = 1, last_of_mirrored = 1;
  for (std::size_t k = 0; k < e.size(); ++k) {
    const int mirrored = e[k].sign();  // of the polynomial's values at -x
    if (mirrored == 0) continue;
    const int sign = k % 2 == 0 ? -mirrored : mirrored;
    result.positive += sign != last ? 1 : 0;
    result.negative += mirrored != last_of_mirrored ? 1 : 0;
    last = sign;
    last_of_mirrored = mirrored;
  }
  return result;
}

/// The invariants of the second-degree part: sums of its principal minors.
std::array<Dyadic, 3> invariants(const Matrix& m) {
  return {m[0][0] + m[1][1] + m[2][2], minor2(m, 0, 1) + minor2(m, 0, 2) + minor2(m, 1, 2), minor3(m, 0, 1, 2)};
}

/// Of the whole matrix, from that of its second-degree part. If the part has full rank there is one eigenvalue more,
/// whose sign is that of the quotient of the determinants.
Signature signature_of_all(const Matrix& m, Signature a, const std::array<Dyadic, 3>& e) {
  const Dyadic whole = determinant(m);
  if (a.rank() == 3) {
    const int added = whole.sign() * e[2].sign();
    return {a.positive + (added > 0 ? 1 : 0), a.negative + (added < 0 ? 1 : 0)};
  }
  const std::array<Dyadic, 4> of_all{e[0] + m[3][3], e[1] + minor2(m, 0, 3) + minor2(m, 1, 3) + minor2(m, 2, 3),
                                     e[2] + minor3(m, 0, 1, 3) + minor3(m, 0, 2, 3) + minor3(m, 1, 2, 3), whole};
  return signature(of_all);
}

/// Whether two eigenvalues of the second-degree part are the same: the discriminant of its characteristic polynomial.
bool has_equal_eigenvalues(const std::array<Dyadic, 3>& e) {
  const auto& [e1, e2, e3] = e;
  const Dyadic discriminant = Dyadic(18.0) * e1 * e2 * e3 - Dyadic(4.0) * e1 * e1 * e1 * e3 + e1 * e1 * e2 * e2 -
                              Dyadic(4.0) * e2 * e2 * e2 - Dyadic(27.0) * e3 * e3;
  return discriminant.is_zero();
}

/// Of a definite second-degree part of full rank.
Kind ellipsoidal(const std::array<Dyadic, 3>& e) {
  if (e[0] * e[0] == Dyadic(3.0) * e[1]) return Kind::sphere;
  return has_equal_eigenvalues(e) ? Kind::spheroid : Kind::ellipsoid;
}

/// Of the second-degree part alone (`a`, with at least as many positive as negative ones) and of the whole matrix.
Kind kind_of(Signature a, Signature all, const std::array<Dyadic, 3>& e) {
  const bool is_central = all.rank() - a.rank() < 2;
  const int added_positive = all.positive - a.positive;
  const int added_negative = all.negative - a.negative;
  switch (10 * a.positive + a.negative) {
    case 30:
      return added_positive > 0 ? Kind::none : added_negative > 0 ? ellipsoidal(e) : Kind::point;
    case 21: {
      const bool is_circular = has_equal_eigenvalues(e);
      if (added_positive > 0)
        return is_circular ? Kind::circular_hyperboloid_of_two_sheets : Kind::elliptic_hyperboloid_of_two_sheets;
      if (added_negative > 0)
        return is_circular ? Kind::circular_hyperboloid_of_one_sheet : Kind::elliptic_hyperboloid_of_one_sheet;
      return is_circular ? Kind::circular_cone : Kind::elliptic_cone;
    }
    case 20: {
      const bool is_circular = e[0] * e[0] == Dyadic(4.0) * e[1];
      if (!is_central) return is_circular ? Kind::circular_paraboloid : Kind::elliptic_paraboloid;
      if (added_positive > 0) return Kind::none;
      if (added_negative == 0) return Kind::line;
      return is_circular ? Kind::circular_cylinder : Kind::elliptic_cylinder;
    }
    case 11:
      if (!is_central) return Kind::hyperbolic_paraboloid;
      return all.rank() > a.rank() ? Kind::hyperbolic_cylinder : Kind::crossing_planes;
    case 10:
      if (!is_central) return Kind::parabolic_cylinder;
      return added_positive > 0 ? Kind::none : added_negative > 0 ? Kind::parallel_planes : Kind::double_plane;
    default:
      return !is_central ? Kind::plane : all.rank() > 0 ? Kind::none : Kind::everything;
  }
}

struct Classified {
  Kind kind = Kind::everything;
  bool is_mirrored = false;  ///< more eigenvalues of the second-degree part are negative than positive
};

Classified classified(const Matrix& m) {
  const std::array<Dyadic, 3> e = invariants(m);
  Signature a = signature(e);
  Signature all = signature_of_all(m, a, e);
  const bool is_mirrored = a.negative > a.positive;
  if (is_mirrored) {
    std::swap(a.positive, a.negative);
    std::swap(all.positive, all.negative);
  }
  return {kind_of(a, all, e), is_mirrored};  // e's tests do not tell a form from its negative
}

// Exact vectors and matrices of rational numbers, for the center.

using Rational = mpq_class;
using Exact3 = std::array<Rational, 3>;

Rational rational(const Dyadic& x) {
  Rational q(x.mantissa());
  const std::int64_t shift = x.exponent();
  const auto bits = static_cast<mp_bitcnt_t>(shift < 0 ? -shift : shift);
  if (shift < 0) mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), bits);
  if (shift > 0) mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), bits);
  return q;
}

Rational dot(const Exact3& a, const Exact3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Exact3 cross(const Exact3& a, const Exact3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Exact3 sum(const Exact3& a, const Rational& s, const Exact3& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

/// A symmetric matrix, whose rows are its columns.
struct Symmetric {
  std::array<Exact3, 3> row;

  Exact3 operator*(const Exact3& v) const { return {dot(row[0], v), dot(row[1], v), dot(row[2], v)}; }
  Symmetric adjugate() const { return {{cross(row[1], row[2]), cross(row[2], row[0]), cross(row[0], row[1])}}; }
  Rational trace() const { return row[0][0] + row[1][1] + row[2][2]; }
};

/// x with m x = v. Precondition: m is regular.
Exact3 solved(const Symmetric& m, const Exact3& v) {
  const Symmetric adjugate = m.adjugate();
  const Rational inverse = 1 / dot(m.row[0], adjugate.row[0]);
  return sum(Exact3{}, inverse, adjugate * v);
}

/// 2 f(center + d) = d' a d + 2 slope . d + value, where a slope = 0; one of slope and value is zero.
struct Centered {
  Exact3 center;
  Exact3 slope;
  Rational value;
};

/// About the center or vertex that is nearest the origin, of 2 f(p) = p' a p + 2 b . p + c.
///
/// In ranks 1 and 2 a' = a + (the part that it lacks, scaled) is regular and the same on what a reaches. Of rank 2,
/// adj(a) is e2 times the projection onto what a maps to 0; of rank 1, a is its trace times a projection.
Centered centered(const Symmetric& a, const Exact3& b, const Rational& c, int rank) {
  Centered result;
  Exact3 p;
  if (rank == 3) {
    p = solved(a, sum(Exact3{}, -1, b));
  } else if (rank == 2) {
    const Symmetric adjugate = a.adjugate();
    result.slope = sum(Exact3{}, 1 / adjugate.trace(), adjugate * b);
    Symmetric filled;
    for (std::size_t i = 0; i < 3; ++i) filled.row[i] = sum(a.row[i], 1, adjugate.row[i]);
    p = solved(filled, sum(result.slope, -1, b));
  } else {
    const Rational inverse = 1 / a.trace();
    const Exact3 reached = sum(Exact3{}, inverse, a * b);
    result.slope = sum(b, -1, reached);
    p = sum(Exact3{}, -inverse, reached);
  }
  // a p = -(b - slope), and slope . p = 0.
  const Rational value = c + dot(b, p);
  const Rational steep = dot(result.slope, result.slope);
  if (sgn(steep) == 0) {
    result.center = p;
    result.value = value;
  } else {
    result.center = sum(p, -value / (2 * steep), result.slope);
  }
  return result;
}

/// Rounded down to 128 bits; exact if it has no more.
Dyadic to_128_bits(const Rational& x) {
  return detail::quotient(Dyadic(x.get_num(), 0), Dyadic(x.get_den(), 0), detail::Toward::down);
}

double nearest(const Rational& x) { return to_128_bits(x).nearest(); }

/// The square root of a positive number: off by less than an ulp, the nearest double if it is a short number.
double root(const Rational& x) { return detail::square_root(to_128_bits(x), detail::Toward::down).nearest(); }

/// Numbers near 1: a form's second-degree part, rounded, and the power of two that it was divided by.
struct Rounded {
  std::array<double, 6> entry{};
  std::int64_t exponent = 0;
};

Rounded rounded(const Matrix& m) {
  constexpr std::array<std::array<std::size_t, 2>, 6> place{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  Rounded result;
  result.exponent = std::numeric_limits<std::int64_t>::min();
  for (const auto [i, j] : place) {
    if (!m[i][j].is_zero()) result.exponent = std::max(result.exponent, m[i][j].magnitude());
  }
  for (std::size_t k = 0; k < place.size(); ++k)
    result.entry[k] = m[place[k][0]][place[k][1]].nearest(-result.exponent);
  return result;
}

/// Which of the ascending eigenvalues of the second-degree part belong to u, v and w.
std::array<std::size_t, 3> order_of(Kind kind) {
  switch (kind) {
    case Kind::sphere:
    case Kind::spheroid:
    case Kind::ellipsoid:
    case Kind::point:
      return {0, 1, 2};
    case Kind::hyperbolic_cylinder:
    case Kind::hyperbolic_paraboloid:
    case Kind::crossing_planes:
      return {2, 0, 1};
    case Kind::parabolic_cylinder:
    case Kind::parallel_planes:
    case Kind::double_plane:
      return {2, 0, 1};
    default:  // the negative or zero one is that of the axis
      return {1, 2, 0};
  }
}

int rank_of(Kind kind) {
  switch (kind) {
    case Kind::circular_cylinder:
    case Kind::elliptic_cylinder:
    case Kind::circular_paraboloid:
    case Kind::elliptic_paraboloid:
    case Kind::hyperbolic_paraboloid:
    case Kind::hyperbolic_cylinder:
    case Kind::crossing_planes:
    case Kind::line:
      return 2;
    case Kind::parabolic_cylinder:
    case Kind::parallel_planes:
    case Kind::double_plane:
      return 1;
    default:
      return 3;
  }
}

Eigen::Vector3d eigen_vector(Vector v) { return {v.x, v.y, v.z}; }
Vector as_vector(const Eigen::Vector3d& v) { return Vector{v[0], v[1], v[2]}; }

/// A direction, each component of which is off by less than 2^-50.
Eigen::Vector3d direction(const Exact3& v) {
  const Rational greatest = std::max({Rational(abs(v[0])), Rational(abs(v[1])), Rational(abs(v[2]))});
  Eigen::Vector3d result;
  for (std::size_t i = 0; i < 3; ++i) result[static_cast<Eigen::Index>(i)] = nearest(v[i] / greatest);
  return result.normalized();
}

/// Fills a shape in from its exact center and its rounded axes.
class ShapeTeller {
 public:
  ShapeTeller(QuadricShape& shape, const Centered& centered, const Rounded& second_degree)
      : shape_(shape),
        centered_(centered),
        scale_(second_degree.exponent),
        // A halved ulp of numbers below 1.
        eigen_(symmetric_eigen(second_degree.entry, 0x1p-54)) {}

  void operator()() {
    const std::array<std::size_t, 3> order = order_of(shape_.kind);
    for (std::size_t i = 0; i < 3; ++i) {
      shape_.axes[i] = eigen_.axis[order[i]];
      shape_.axes_error[i] = eigen_.angle[order[i]];
      value_[i] = eigen_.value[order[i]];
    }
    turn_axes();
    tell_sizes();
    shape_.relative_error = certainty_ * (1 + 0x1p-40) + 0x1p-49;
  }

 private:
  bool opens() const { return sgn(dot(centered_.slope, centered_.slope)) != 0; }

  /// Toward where it opens, and right-handed: the sign of u is of no matter.
  void turn_axes() {
    if (opens()) {
      const Eigen::Vector3d way = -direction(centered_.slope);
      const bool is_cylinder = shape_.kind == Kind::parabolic_cylinder;
      const std::size_t along = is_cylinder ? 1 : 2;
      shape_.axes[along] = as_vector(way);
      shape_.axes_error[along] = 0x1p-48;
      if (is_cylinder) {
        shape_.axes[2] = as_vector(eigen_vector(shape_.axes[0]).cross(way).normalized());
        shape_.axes_error[2] = shape_.axes_error[0] + 0x1p-48;
        return;
      }
    }
    const Eigen::Vector3d u = eigen_vector(shape_.axes[0]);
    if (u.cross(eigen_vector(shape_.axes[1])).dot(eigen_vector(shape_.axes[2])) < 0) shape_.axes[0] = as_vector(-u);
  }

  /// The magnitude of an eigenvalue; what a root of it may be off counts.
  double counted(std::size_t i) {
    const double size = std::fabs(value_[i]);
    const double off = eigen_.value_error / size;
    // 1/(1 - x) - 1 <= 2 x for 0 <= x <= 1/2; roots, and products of two of them, are off by less.
    certainty_ += off <= 0.5 ? 2 * off : infinity;
    return size;
  }

  void tell_sizes() {
    switch (shape_.kind) {
      case Kind::point:
      case Kind::line:
      case Kind::double_plane:
        return;
      case Kind::circular_cone:
      case Kind::elliptic_cone: {
        const double along = counted(2);
        for (std::size_t i = 0; i < 2; ++i) shape_.half_angles[i] = std::atan(std::sqrt(along / counted(i)));
        return;
      }
      case Kind::crossing_planes: {
        const double first = counted(0);
        shape_.half_angles[0] = std::atan(std::sqrt(first / counted(1)));
        return;
      }
      case Kind::circular_paraboloid:
      case Kind::elliptic_paraboloid:
      case Kind::hyperbolic_paraboloid:
      case Kind::parabolic_cylinder: {
        // l u² = 2 |slope| w, and a parabola u² = 4 f w has the focal length f.
        const Rational steep = dot(centered_.slope, centered_.slope) / 4;
        const std::size_t count = shape_.kind == Kind::parabolic_cylinder ? 1 : 2;
        for (std::size_t i = 0; i < count; ++i) {
          const Rational eigenvalue = scaled(counted(i));
          shape_.focal_lengths[i] = root(steep / (eigenvalue * eigenvalue));
        }
        return;
      }
      default:
        tell_semi_axes();
    }
  }

  void tell_semi_axes() {
    // l u² + .. = -value.
    const int rank = rank_of(shape_.kind);
    for (std::size_t i = 0; i < 3; ++i)
      shape_.semi_axes[i] = static_cast<int>(i) < rank ? root(abs(centered_.value) / scaled(counted(i))) : infinity;
  }

  /// In the scale of the form.
  Rational scaled(double eigenvalue) const { return rational(Dyadic(eigenvalue).scaled(scale_)); }

  QuadricShape& shape_;
  const Centered& centered_;
  std::int64_t scale_;
  SymmetricEigen eigen_;
  std::array<double, 3> value_{};
  double certainty_ = 0;  // relative, of the lengths
};

}  // namespace

const char* word(QuadricKind kind) {
  switch (kind) {
    case Kind::sphere:
      return "sphere";
    case Kind::spheroid:
      return "spheroid";
    case Kind::ellipsoid:
      return "ellipsoid";
    case Kind::circular_cylinder:
      return "circular cylinder";
    case Kind::elliptic_cylinder:
      return "elliptic cylinder";
    case Kind::parabolic_cylinder:
      return "parabolic cylinder";
    case Kind::hyperbolic_cylinder:
      return "hyperbolic cylinder";
    case Kind::circular_cone:
      return "circular cone";
    case Kind::elliptic_cone:
      return "elliptic cone";
    case Kind::circular_paraboloid:
      return "circular paraboloid";
    case Kind::elliptic_paraboloid:
      return "elliptic paraboloid";
    case Kind::hyperbolic_paraboloid:
      return "hyperbolic paraboloid";
    case Kind::circular_hyperboloid_of_one_sheet:
      return "circular hyperboloid of one sheet";
    case Kind::elliptic_hyperboloid_of_one_sheet:
      return "elliptic hyperboloid of one sheet";
    case Kind::circular_hyperboloid_of_two_sheets:
      return "circular hyperboloid of two sheets";
    case Kind::elliptic_hyperboloid_of_two_sheets:
      return "elliptic hyperboloid of two sheets";
    case Kind::plane:
      return "plane";
    case Kind::crossing_planes:
      return "crossing planes";
    case Kind::parallel_planes:
      return "parallel planes";
    case Kind::double_plane:
      return "double plane";
    case Kind::line:
      return "line";
    case Kind::point:
      return "point";
    case Kind::none:
      return "nothing";
    case Kind::everything:
      return "everything";
  }
  return "";
}

QuadricKind kind_of_quadric(const QuadricForm& form) { return classified(matrix_of(form)).kind; }

QuadricShape shape_of_quadric(const QuadricForm& form) {
  CSGCAST_PRECONDITION(!form.is_plane() && !form.is_constant());
  Matrix m = matrix_of(form);
  const Classified found = classified(m);
  QuadricShape shape;
  shape.kind = found.kind;
  shape.center = {none, none, none};
  shape.axes.fill({none, none, none});
  shape.axes_error.fill(infinity);
  shape.semi_axes.fill(none);
  shape.half_angles.fill(none);
  shape.focal_lengths.fill(none);
  if (shape.kind == Kind::none) return shape;
  const auto negate = [&] {
    for (auto& row : m) {
      for (Dyadic& entry : row) entry = -std::move(entry);
    }
  };
  if (found.is_mirrored) negate();
  const auto exact = [&] {
    Symmetric a;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) a.row[i][j] = rational(m[i][j]);
    }
    const Exact3 b{rational(m[0][3]), rational(m[1][3]), rational(m[2][3])};
    return centered(a, b, rational(m[3][3]), rank_of(shape.kind));
  };
  Centered about = exact();
  // A hyperbolic cylinder has its vertices on u.
  if (shape.kind == Kind::hyperbolic_cylinder && sgn(about.value) > 0) {
    negate();
    about = exact();
  }
  for (std::size_t i = 0; i < 3; ++i) shape.center[i] = nearest(about.center[i]);
  ShapeTeller(shape, about, rounded(m))();
  return shape;
}

}  // namespace csgcast
