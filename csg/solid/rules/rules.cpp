// SPDX-License-Identifier: MIT
#include "csg/solid/rules/rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace csgcast {
namespace {

using Broken = std::optional<BrokenRule>;

constexpr const char* finite = "be finite";
constexpr const char* no_negative = "not be negative";
constexpr const char* share = "be between 0 and 1";

bool all(const Rgb& color, bool (*holds)(double)) { return holds(color.r) && holds(color.g) && holds(color.b); }
bool is_number(double number) { return std::isfinite(number); }
bool is_share(double number) { return number >= 0 && number <= 1; }
template <class Tag>
bool is_number(const Triple<Tag>& t) {
  return is_number(t.x) && is_number(t.y) && is_number(t.z);
}

Broken strength(const char* name, double number) {
  if (!is_number(number)) return BrokenRule{name, finite};
  return number >= 0 ? Broken{} : BrokenRule{name, no_negative};
}

}  // namespace

Broken broken_rule(const char* argument, const Rgb& light) {
  if (!all(light, is_number)) return BrokenRule{argument, finite};
  return std::min({light.r, light.g, light.b}) >= 0 ? Broken{} : BrokenRule{argument, no_negative};
}

Broken broken_rule(const PartName& part) {
  if (part.name.empty()) return BrokenRule{"name", "not be empty"};
  return strength("density", part.density);
}

Broken broken_rule(const Material& material) {
  if (const Broken broken = broken_rule("color", material.color)) return broken;
  for (const auto& [name, number] :
       {std::pair("ambient", material.ambient), std::pair("diffuse", material.diffuse),
        std::pair("specular", material.specular), std::pair("shininess", material.shininess)}) {
    if (const Broken broken = strength(name, number)) return broken;
  }
  if (!is_share(material.reflection)) return BrokenRule{"reflection", share};
  if (!is_share(material.transmission)) return BrokenRule{"transmission", share};
  if (!is_number(material.ior)) return BrokenRule{"ior", finite};
  if (!(material.ior > 0)) return BrokenRule{"ior", "be greater than 0"};
  if (const Broken broken = broken_rule("emission", material.emission)) return broken;
  return broken_rule("absorption", material.absorption);
}

Broken broken_rule(const Paint& paint) {
  if (!all(paint.color, is_share)) return BrokenRule{"c", share};
  return is_share(paint.alpha) ? Broken{} : BrokenRule{"alpha", share};
}

Broken broken_rule(const LightDescription& light) {
  const auto& [position, direction, color, intensity, falloff] = light;
  if (position.has_value() == direction.has_value())
    return BrokenRule{"position", "be given, or 'direction', but not both"};
  if (position && !is_number(*position)) return BrokenRule{"position", finite};
  if (direction && !is_number(*direction)) return BrokenRule{"direction", finite};
  if (direction && *direction == Vector{}) return BrokenRule{"direction", "not be the zero vector"};
  if (const Broken broken = broken_rule("color", color)) return broken;
  if (const Broken broken = strength("intensity", intensity)) return broken;
  if (!falloff) return {};
  if (!is_number(*falloff)) return BrokenRule{"falloff", finite};
  if (!(*falloff > 0)) return BrokenRule{"falloff", "be greater than 0"};
  return position ? Broken{} : BrokenRule{"falloff", "belong to a light with a 'position'"};
}

Broken broken_rule(const RenderSettings& settings) {
  if (settings.max_depth < 0 || settings.max_depth > 100)
    return BrokenRule{"max_depth", "be a whole number from 0 to 100"};
  return is_share(settings.min_contribution) ? Broken{} : BrokenRule{"min_contribution", share};
}

void require(const Broken& broken, const char* statement) {
  if (!broken) return;
  throw Error(ErrorCode::bad_value, {}, fmt::format("'{}' of '{}' must {}", broken->argument, statement, broken->rule),
              "", "give another value");
}

}  // namespace csgcast
