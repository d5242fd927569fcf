// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, by including itself.
#include "shade/detail/shading_lanes.h"

#include <cmath>
#include <cstddef>

#include "shade/phong.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/detail/shading_lanes.cpp"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "csg/vector_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using csgcast::HWY_NAMESPACE::in_all_lanes;
using csgcast::HWY_NAMESPACE::load_lanes;
using csgcast::HWY_NAMESPACE::normalised_lanes;
using csgcast::HWY_NAMESPACE::store_lanes;
using csgcast::HWY_NAMESPACE::Triples;

using Tag = hn::CappedTag<double, 8>;
using V = hn::Vec<Tag>;
using M = hn::Mask<Tag>;

void camera_rays(const CameraFrame& camera, std::size_t count, const double* x, const double* y,
                 double* const* origin, double* const* direction) {
  const Tag d;
  const Triples<V> right = in_all_lanes(d, camera.right);
  const Triples<V> up = in_all_lanes(d, camera.up);
  const Triples<V> forward = in_all_lanes(d, camera.forward);
  const Triples<V> eye = in_all_lanes(d, camera.eye);
  const V pixel = hn::Set(d, camera.pixel);
  for (std::size_t first = 0; first < count; first += hn::Lanes(d)) {
    const std::size_t some = HWY_MIN(hn::Lanes(d), count - first);
    const V across = hn::Sub(load_lanes(d, x + first, some), hn::Set(d, camera.width / 2));
    const V upwards = hn::Sub(hn::Set(d, camera.height / 2), load_lanes(d, y + first, some));
    const Triples<V> offset = scaled_by(pixel, scaled_by(across, right) + scaled_by(upwards, up));
    if (camera.parallel) {
      store_lanes(d, eye + offset, origin, first, some);
      store_lanes(d, forward, direction, first, some);
    } else {
      store_lanes(d, eye, origin, first, some);
      store_lanes(d, normalised_lanes(d, forward + offset), direction, first, some);
    }
  }
}

/// Calls f(look, lanes) for each look of a packet's points.
template <class F>
HWY_INLINE void each_look(const ShadingPoints& points, std::size_t first, std::size_t count, F&& f) {
  const Tag d;
  HWY_ALIGN double looks[16];
  for (std::size_t i = 0; i < hn::Lanes(d); ++i)
    looks[i] = static_cast<double>(points.look[first + (i < count ? i : count - 1)]);
  const V of = hn::Load(d, looks);
  for (M rest = hn::FirstN(d, hn::Lanes(d)); !hn::AllFalse(d, rest);) {
    const double look = looks[static_cast<std::size_t>(hn::FindFirstTrue(d, rest))];
    const M same = hn::Eq(of, hn::Set(d, look));
    rest = hn::AndNot(same, rest);
    f(static_cast<std::size_t>(look), same);
  }
}

void unlit(const Material* looks, const ShadingPoints& points, double* const* color) {
  const Tag d;
  for (std::size_t first = 0; first < points.count; first += hn::Lanes(d)) {
    const std::size_t some = HWY_MIN(hn::Lanes(d), points.count - first);
    const V zero = hn::Zero(d);
    Triples<V> sum{zero, zero, zero};
    each_look(points, first, some, [&](std::size_t look, M lanes) {
      const Rgb own = csgcast::unlit(looks[look]);
      sum = choose(lanes, Triples<V>{hn::Set(d, own.r), hn::Set(d, own.g), hn::Set(d, own.b)}, sum);
    });
    store_lanes(d, sum, color, first, some);
  }
}

/// power(), by the same products.
HWY_INLINE V power_lanes(V base, double exponent) {
  const Tag d;
  const bool is_whole = exponent >= 0 && exponent <= 65536 && exponent == std::floor(exponent);
  if (!is_whole) {
    HWY_ALIGN double values[16];
    hn::Store(base, d, values);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) values[i] = std::pow(values[i], exponent);
    return hn::Load(d, values);
  }
  V result = hn::Set(d, 1.0);
  for (auto rest = static_cast<unsigned>(exponent); rest != 0; rest >>= 1u) {
    if ((rest & 1u) != 0) result = hn::Mul(result, base);
    base = hn::Mul(base, base);
  }
  return result;
}

/// illuminate().
struct IlluminationLanes {
  Triples<V> to_light, path, light;
  M exists;
};

HWY_INLINE IlluminationLanes illuminate_lanes(const LightDescription& light, const Triples<V>& point) {
  const Tag d;
  IlluminationLanes from;
  const Vector away = -light.direction.value_or(Vector{0, 0, -1});
  from.path = light.position ? in_all_lanes(d, *light.position) - point : in_all_lanes(d, away);
  from.to_light = normalised_lanes(d, from.path);
  from.exists = hn::Gt(longest(from.to_light), hn::Zero(d));
  const Rgb own = light.intensity * light.color;
  from.light = {hn::Set(d, own.r), hn::Set(d, own.g), hn::Set(d, own.b)};
  if (light.falloff && light.position) {
    const V ratio = hn::Div(hn::Set(d, *light.falloff), dot(from.path, from.to_light));
    from.light = scaled_by(hn::Mul(ratio, ratio), from.light);
  }
  return from;
}

/// phong(): what a light adds where n_l is positive.
HWY_INLINE Triples<V> phong_lanes(const Material& material, const Triples<V>& normal, const Triples<V>& to_viewer,
                                  const IlluminationLanes& from, V n_l) {
  const Tag d;
  const V zero = hn::Zero(d);
  const V diffuse = hn::Mul(hn::Set(d, material.diffuse), n_l);
  Triples<V> share{hn::Mul(diffuse, hn::Set(d, material.color.r)), hn::Mul(diffuse, hn::Set(d, material.color.g)),
                   hn::Mul(diffuse, hn::Set(d, material.color.b))};
  if (material.specular > 0) {
    const Triples<V> incoming = -from.to_light;
    const V twice = hn::Mul(hn::Set(d, 2.0), dot(incoming, normal));
    const V r_v = dot(incoming - scaled_by(twice, normal), to_viewer);
    const M glints = hn::Gt(r_v, zero);
    if (!hn::AllFalse(d, glints)) {
      const V highlight = hn::IfThenElseZero(
          glints, hn::Mul(hn::Set(d, material.specular), power_lanes(hn::Max(r_v, zero), material.shininess)));
      share = {hn::Add(share.x, highlight), hn::Add(share.y, highlight), hn::Add(share.z, highlight)};
    }
  }
  return {hn::Mul(share.x, from.light.x), hn::Mul(share.y, from.light.y), hn::Mul(share.z, from.light.z)};
}

void light(const Material* looks, const LightDescription& description, const ShadingPoints& points,
           const LightArrays& result) {
  const Tag d;
  const V zero = hn::Zero(d);
  for (std::size_t first = 0; first < points.count; first += hn::Lanes(d)) {
    const std::size_t some = HWY_MIN(hn::Lanes(d), points.count - first);
    const Triples<V> ray = load_lanes(d, points.direction, first, some);
    const Triples<V> out = load_lanes(d, points.normal, first, some);
    const Triples<V> normal = choose(hn::Gt(dot(out, ray), zero), -out, out);
    const IlluminationLanes from = illuminate_lanes(description, load_lanes(d, points.point, first, some));
    const V n_l = dot(normal, from.to_light);
    const M faces = hn::And(from.exists, hn::Gt(n_l, zero));
    Triples<V> brings{zero, zero, zero};
    if (!hn::AllFalse(d, faces)) {
      each_look(points, first, some, [&](std::size_t look, M lanes) {
        brings = choose(hn::And(lanes, faces), phong_lanes(looks[look], normal, -ray, from, n_l), brings);
      });
    }
    store_lanes(d, brings, result.light, first, some);
    store_lanes(d, from.path, result.path, first, some);
    const M counts = hn::Gt(hn::Max(hn::Max(brings.x, brings.y), brings.z), zero);
    HWY_ALIGN std::uint8_t exists_bits[8];
    HWY_ALIGN std::uint8_t faces_bits[8];
    HWY_ALIGN std::uint8_t counts_bits[8];
    hn::StoreMaskBits(d, from.exists, exists_bits);
    hn::StoreMaskBits(d, faces, faces_bits);
    hn::StoreMaskBits(d, counts, counts_bits);
    for (std::size_t i = 0; i < some; ++i) {
      const auto has = [i](const std::uint8_t* bits) { return ((bits[0] >> i) & 1) != 0; };
      const bool faces_away = has(exists_bits) && !has(faces_bits);
      result.effect[first + i] = static_cast<std::uint8_t>(faces_away          ? LightEffect::facing_away
                                                           : has(counts_bits) ? LightEffect::some
                                                                              : LightEffect::none);
    }
  }
}

ShadingCode code(std::string_view name) { return {name, camera_rays, unlit, light}; }

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgcast::detail {

HWY_EXPORT(code);

const ShadingCode& shading_code() {
  static const ShadingCode best = HWY_DYNAMIC_DISPATCH(code)("best");
  return best;
}

}  // namespace csgcast::detail
#endif
