// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, by including itself.
#include "shade/trace/detail/shading_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "raycast/scene/scene.h"
#include "raycast/simd/instruction_set.h"
#include "raycast/simd/lane_targets.h"
#include "shade/light/phong.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/trace/detail/shading_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raycast/simd/vector_lanes-inl.h"

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

void camera_rays(const CameraFrame& camera, std::size_t count, const double* x, const double* y, double* const* origin,
                 double* const* direction) {
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

/// Calls f(look, lanes) for each look that some of a packet's lanes have.
template <class F>
HWY_INLINE void each_look(const ShadingPoints& points, std::size_t first, M lanes, F&& f) {
  const Tag d;
  const std::uint32_t* looks = points.look + first;  // far fewer than 2^31
  const V of =
      hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::int32_t, Tag>(), reinterpret_cast<const std::int32_t*>(looks)));
  for (M rest = lanes; !hn::AllFalse(d, rest);) {
    const std::uint32_t look = looks[static_cast<std::size_t>(hn::FindFirstTrue(d, rest))];
    const M same = hn::And(rest, hn::Eq(of, hn::Set(d, static_cast<double>(look))));
    rest = hn::AndNot(same, rest);
    f(look, same);
  }
}

/// The lanes of samples that a byte says yes of.
HWY_INLINE M lanes_of(const std::uint8_t* yes) {
  const Tag d;
  const hn::Rebind<std::uint8_t, Tag> bytes;
  const hn::Rebind<std::int32_t, Tag> wider;
  return hn::Gt(hn::PromoteTo(d, hn::PromoteTo(wider, hn::LoadU(bytes, yes))), hn::Zero(d));
}

/// The lanes whose samples are plain.
HWY_INLINE M plain_lanes(const ShadingPoints& points, std::size_t first, std::size_t count) {
  return hn::And(hn::FirstN(Tag(), count), lanes_of(points.is_plain + first));
}

void unlit(const Material* looks, const ShadingPoints& points, double* const* color) {
  const Tag d;
  for (std::size_t first = 0; first < points.count; first += hn::Lanes(d)) {
    const std::size_t some = HWY_MIN(hn::Lanes(d), points.count - first);
    const V zero = hn::Zero(d);
    Triples<V> sum{zero, zero, zero};
    each_look(points, first, plain_lanes(points, first, some), [&](std::size_t look, M lanes) {
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

/// Puts the lanes' shadow rays behind those that are there.
HWY_INLINE void append(M lanes, unsigned bits, const Triples<V>& origin, const Triples<V>& path,
                       const Triples<V>& light, std::size_t first, ShadowRays& rays) {
  const Tag d;
  const V values[9] = {origin.x, origin.y, origin.z, path.x, path.y, path.z, light.x, light.y, light.z};
  double* const to[9] = {rays.origin[0], rays.origin[1], rays.origin[2], rays.path[0], rays.path[1],
                         rays.path[2],   rays.light[0],  rays.light[1],  rays.light[2]};
  // Some processors take a hundred cycles to compress to memory.
  const bool all = hn::AllTrue(d, lanes);
  for (std::size_t i = 0; i < 9; ++i) {
    if (all) {
      hn::StoreU(values[i], d, to[i] + rays.count);
    } else {
      hn::CompressStore(values[i], lanes, d, to[i] + rays.count);
    }
  }
  for (; bits != 0; bits &= bits - 1)
    rays.sample[rays.count++] = static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(__builtin_ctz(bits));
}

HWY_INLINE unsigned bits_of(M lanes) {
  std::uint8_t bits[8];
  hn::StoreMaskBits(Tag(), lanes, bits);
  return bits[0];
}

/// Adds to the lanes' colours.
HWY_INLINE void add(M lanes, const Triples<V>& light, std::size_t first, std::size_t count, double* const* color) {
  const Tag d;
  const Triples<V> before = load_lanes(d, color, first, count);
  store_lanes(d, choose(lanes, before + light, before), color, first, count);
}

void light(const Material* looks, const LightDescription& description, const ShadingPoints& points, ShadowRays& rays,
           double* const* color) {
  const Tag d;
  const V zero = hn::Zero(d);
  rays.count = 0;
  for (std::size_t first = 0; first < points.count; first += hn::Lanes(d)) {
    const std::size_t some = HWY_MIN(hn::Lanes(d), points.count - first);
    const M plain = plain_lanes(points, first, some);
    if (hn::AllFalse(d, plain)) continue;
    const Triples<V> ray = load_lanes(d, points.direction, first, some);
    const Triples<V> out = load_lanes(d, points.normal, first, some);
    const Triples<V> point = load_lanes(d, points.point, first, some);
    const Triples<V> normal = choose(hn::Gt(dot(out, ray), zero), -out, out);
    const IlluminationLanes from = illuminate_lanes(description, point);
    const V n_l = dot(normal, from.to_light);
    const M faces = hn::And(plain, hn::And(from.exists, hn::Gt(n_l, zero)));
    const M faces_away = hn::AndNot(faces, hn::And(plain, from.exists));
    rays.facing_away += static_cast<std::uint64_t>(__builtin_popcount(bits_of(faces_away)));
    Triples<V> brings{zero, zero, zero};
    if (!hn::AllFalse(d, faces)) {
      each_look(points, first, faces, [&](std::size_t look, M lanes) {
        brings = choose(lanes, phong_lanes(looks[look], normal, -ray, from, n_l), brings);
      });
    }
    const M counts = hn::And(faces, hn::Gt(hn::Max(hn::Max(brings.x, brings.y), brings.z), zero));
    const M none = hn::AndNot(hn::Or(counts, faces_away), plain);
    rays.without_effect += static_cast<std::uint64_t>(__builtin_popcount(bits_of(none)));
    M asks = counts;
    if (points.leads_away != nullptr) {
      const M rises = hn::Gt(dot(out, from.to_light), hn::Set(d, clear_departure));
      const M leads_away = hn::And(hn::And(counts, rises), lanes_of(points.leads_away + first));
      if (!hn::AllFalse(d, leads_away)) {
        rays.leading_away += static_cast<std::uint64_t>(__builtin_popcount(bits_of(leads_away)));
        add(leads_away, brings, first, some, color);
        asks = hn::AndNot(leads_away, counts);
        if (hn::AllFalse(d, asks)) continue;
      }
    }
    append(asks, bits_of(asks), point, from.path, brings, first, rays);
  }
}

ShadingCode code() { return {camera_rays, unlit, light}; }

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgcast::detail {

const ShadingCode& shading_code(std::string_view instructions) {
  struct Named {
    std::string_view name;
    ShadingCode code;
  };
  static const std::vector<Named> codes = [] {
    std::vector<Named> found;
#if HWY_TARGETS & HWY_AVX3
    if (has(InstructionSet::avx512)) found.push_back({"AVX-512", N_AVX3::code()});
#endif
#if HWY_TARGETS & HWY_AVX2
    if (has(InstructionSet::avx2)) found.push_back({"AVX2", N_AVX2::code()});
#endif
#if HWY_TARGETS & HWY_SSE4
    if (has(InstructionSet::sse4)) found.push_back({"SSE4", N_SSE4::code()});
#endif
    found.push_back({"baseline", HWY_STATIC_DISPATCH(code)()});
    return found;
  }();
  const auto named = std::find_if(codes.begin(), codes.end(), [&](const Named& c) { return c.name == instructions; });
  return named != codes.end() ? named->code : codes.front().code;
}

}  // namespace csgcast::detail
#endif
