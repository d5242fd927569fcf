// SPDX-License-Identifier: MIT
#include "raycast/surface/detail/exact_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "csg/base/precondition.h"
#include "csg/exact/quadric_form.h"
#include "raycast/surface/detail/line_memory.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;

// Computes floor(sqrt(value)) in units that leave at least `bits` significant bits.
Dyadic square_root(const Dyadic& value, std::int64_t bits) {
  if (value.is_zero()) return {};
  std::int64_t shift = 2 * bits - static_cast<std::int64_t>(value.bits());
  if (shift < 0) shift = 0;
  if ((value.exponent() - shift) % 2 != 0) ++shift;
  mpz_class scaled = value.mantissa() << static_cast<mp_bitcnt_t>(shift);
  return {sqrt(scaled), (value.exponent() - shift) / 2};
}

// Computes a / b, cut off after at least `bits` bits.
Dyadic quotient(const Dyadic& a, const Dyadic& b, std::int64_t bits) {
  if (a.is_zero()) return {};
  const std::int64_t wanted = bits + static_cast<std::int64_t>(b.bits()) - static_cast<std::int64_t>(a.bits());
  const std::int64_t shift = wanted > 0 ? wanted : 0;
  const mpz_class numerator = a.mantissa() << static_cast<mp_bitcnt_t>(shift);
  return {mpz_class(numerator / b.mantissa()), a.exponent() - b.exponent() - shift};
}

constexpr std::int64_t approximation_bits = 128;

// The root with a relative error of at most 2^-120. If the sum of p and the square root would cancel, the other formula
// for the root is used.
Dyadic approximate(const ExactRoot& root, const ExactPolynomial& f) {
  const Dyadic radical = square_root(root.d, approximation_bits + 8);
  const Dyadic signed_radical = root.s < 0 ? -radical : root.s == 0 ? Dyadic() : radical;
  if (root.s == 0 || root.p.sign() == 0 || root.p.sign() == root.s)
    return quotient(root.p + signed_radical, root.q, approximation_bits);
  // (p + r)(p - r) = p² - d, which is 4 a c for the roots of a t² + b t + c.
  return quotient(Dyadic(2.0) * f.c, root.p - signed_radical, approximation_bits);
}

// Sets tau for a given t, rounded. The error is half an ulp of tau, plus what was cut off of t.
void set_tau(const Line& line, LineCrossings& found, unsigned index, const Dyadic& t) {
  const LineFrame& frame = line.in_frame;
  const Dyadic along = t.scaled(-std::int64_t{std::ilogb(frame.unit)});
  constexpr double most = std::numeric_limits<double>::max();
  const double tau =
      std::clamp((along - Dyadic(frame.shift)).nearest(), -most, most);  // beyond it the error below is infinite
  found.few[index] = tau;
  const double error = 0x1p-52 * std::fabs(tau) + 0x1p-110 * std::fabs(along.nearest()) + 0x1p-1000;
  found.error = std::fmax(found.error, error);
}

ExactMemory& memory_of(const Line& line, ExactMemory& scratch) {
  return line.memory != nullptr ? line.memory->state().exact : scratch;
}

}  // namespace

ExactPolynomial::ExactPolynomial(const Line& line, SurfaceId id, const Surface& surface) {
  const QuadricForm form = surface.exact.unpacked();
  const auto& k = form.coefficient;
  const Point o = line.ray.origin();
  const Vector d = line.ray.direction();
  const Dyadic x(o.x);
  const Dyadic y(o.y);
  const Dyadic z(o.z);
  const Dyadic dx(d.x);
  const Dyadic dy(d.y);
  const Dyadic dz(d.z);
  const Dyadic two(2.0);
  if (!surface.is_plane) {
    a = (k[Form::xx] * dx + k[Form::xy] * dy + k[Form::xz] * dz) * dx + (k[Form::yy] * dy + k[Form::yz] * dz) * dy +
        k[Form::zz] * dz * dz;
    b = (two * k[Form::xx] * x + k[Form::xy] * y + k[Form::xz] * z) * dx +
        (two * k[Form::yy] * y + k[Form::xy] * x + k[Form::yz] * z) * dy +
        (two * k[Form::zz] * z + k[Form::xz] * x + k[Form::yz] * y) * dz;
  }
  b += k[Form::x] * dx + k[Form::y] * dy + k[Form::z] * dz;
  if (id == line.departure) {
    c = std::exchange(b, std::exchange(a, Dyadic()));
    return;
  }
  c = form.at(o);
}

ExactMemory::Known& ExactMemory::known(const Line& line, SurfaceId id, const Surface& surface) {
  const std::size_t index = id.index();
  if (index >= place_.size()) place_.resize(index + 1);
  std::uint32_t& place = place_[index];
  if (place < known_.size() && known_[place].id == id) return known_[place];
  place = static_cast<std::uint32_t>(known_.size());
  return known_.emplace_back(Known{id, ExactPolynomial(line, id, surface), {}});
}

const ExactPolynomial& ExactMemory::polynomial(const Line& line, SurfaceId id, const Surface& surface) {
  return known(line, id, surface).polynomial;
}

const ExactRoot& ExactMemory::root(const Line& line, SurfaceId id, const Surface& surface, unsigned root) {
  Known& entry = known(line, id, surface);
  std::optional<ExactRoot>& known_root = entry.roots[root];
  if (!known_root) known_root.emplace(entry.polynomial.root(root));
  return *known_root;
}

LineCrossings exact_crossings(const Line& line, SurfaceId id, const Surface& surface) {
  ExactMemory scratch;
  ExactMemory& memory = memory_of(line, scratch);
  const ExactPolynomial& f = memory.polynomial(line, id, surface);
  LineCrossings found;
  if (id == line.departure) {
    // Here f / t = b t + c. After the start f has the sign of the departure's side. If f has the other sign in the end,
    // there is one crossing on the way. At a silhouette the crossing may come out before the start; then it is set to
    // the start. Where f is linear on the line, its slope alone tells the side. It has no slope where the line lies in
    // a plane.
    const bool positive = line.departure_side == Sense::positive;
    const bool is_linear = f.b.is_zero();
    found.positive_before = is_linear && !f.c.is_zero() ? f.c.sign() > 0 : positive;
    if (is_linear || (f.b.sign() > 0) == positive) return found;
    found.count = 1;
    set_tau(line, found, 0, f.b.sign() * f.c.sign() < 0 ? approximate(f.root(0), f) : Dyadic());
    return found;
  }
  if (f.a.is_zero()) {
    found.positive_before = f.b.is_zero() ? f.c.sign() >= 0 : f.b.sign() < 0;
    if (f.b.is_zero()) return found;
    found.count = 1;
    set_tau(line, found, 0, approximate(f.root(0), f));
    return found;
  }
  found.positive_before = f.a.sign() > 0;
  const ExactRoot& lower = memory.root(line, id, surface, 0);
  if (lower.d.sign() <= 0) return found;
  found.count = 2;
  set_tau(line, found, 0, approximate(lower, f));
  set_tau(line, found, 1, approximate(memory.root(line, id, surface, 1), f));
  return found;
}

ExactRoot exact_root(const Line& line, const CrossingView& crossing) {
  ExactMemory scratch;
  ExactMemory& memory = memory_of(line, scratch);
  const ExactPolynomial& f = memory.polynomial(line, crossing.id, *crossing.surface);
  if (crossing.id == line.departure && !(f.b.sign() * f.c.sign() < 0)) return ExactRoot(Dyadic());
  // If the partner of a crossing is out of reach, floating point knows this crossing only, so its number is found anew.
  unsigned root = crossing.root;
  if (crossing.found->count == 1 && !f.a.is_zero()) root = crossing.found->positive_before == (f.a.sign() > 0) ? 0 : 1;
  return memory.root(line, crossing.id, *crossing.surface, root);
}

double exact_nearest_t(const Line& line, const CrossingView& crossing) {
  ExactMemory scratch;
  const ExactPolynomial& f = memory_of(line, scratch).polynomial(line, crossing.id, *crossing.surface);
  const ExactRoot root = exact_root(line, crossing);
  const Dyadic t = approximate(root, f);
  const Dyadic slack = t.scaled(-112);  // far above 2^-120, the error of the approximation
  const double low = (t - slack).nearest();
  const double high = (t + slack).nearest();
  if (low == high) return low;
  // If a point halfway between two doubles lies within the slack, the exact root is compared with it.
  const Dyadic halfway = (Dyadic(low) + Dyadic(high)).scaled(-1);
  const auto side = root <=> ExactRoot(halfway);
  if (side == 0) return halfway.nearest();
  return side < 0 ? std::fmin(low, high) : std::fmax(low, high);
}

}  // namespace csgcast::detail
