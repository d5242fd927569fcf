// SPDX-License-Identifier: MIT
#include "csg/text/statement/detail/look_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "csg/text/statement/detail/color_argument.h"

namespace csgcast::text {
namespace {

/// Channels outside [0, 1] are brought there with a warning; negative ones are left as the mark of a colour that is not
/// set. As in OpenSCAD, an undef one is 0.
EncodedColor color_from_list(const Call& call, const List& channels) {
  if (channels.size() != 3 && channels.size() != 4) {
    call.reject(ErrorCode::wrong_type, call.place("c"), "'c' of 'color' must have three or four channels",
                fmt::format("it has {}", channels.size()), "give [r, g, b] or [r, g, b, a], each from 0 to 1");
  }
  EncodedColor color{0, 0, 0, 1};
  for (std::size_t i = 0; i < channels.size(); ++i) {
    color[i] = counts_as_undef(channels[i]) ? 0 : call.entry(channels[i], "a channel");
    if (color[i] > 1) call.warn(fmt::format("a channel of 'color' is {}, more than 1: it counts as 1", color[i]));
    color[i] = std::min(color[i], 1.0);
  }
  return color;
}

/// The colour and opacity of a color statement; nothing if it sets none.
std::optional<EncodedColor> encoded_color(const Call& call) {
  const Value* value = call.find("c");
  const auto alpha = call.number("alpha");
  if (alpha) call.require(*alpha >= 0 && *alpha <= 1, "alpha", "be between 0 and 1");
  if (value == nullptr) return std::nullopt;
  EncodedColor color{};
  if (std::holds_alternative<List>(value->data)) {
    color = color_from_list(call, *call.list("c"));
  } else if (std::holds_alternative<std::string>(value->data)) {
    color = color_from_string(call, "c");
  } else {
    call.reject(ErrorCode::wrong_type, call.place("c"), "'c' of 'color' must be a string or a list of channels", "",
                "give a CSS name, \"#rrggbb\" or [r, g, b]");
  }
  if (alpha) color[3] = *alpha;
  if (*std::min_element(color.begin(), color.end()) < 0) return std::nullopt;
  return color;
}

}  // namespace

Combine make_color(const Call& call) {
  const auto encoded = encoded_color(call);
  if (!encoded) return unite;
  LookStatement look;
  look.paint = Paint{linear_from(*encoded), (*encoded)[3]};
  return [look](std::vector<Solid> children) { return with_look(unite(std::move(children)), look); };
}

Combine make_material(const Call& call) {
  Material material;
  material.color = color_argument(call, "color").value_or(material.color);
  material.ambient = call.number_or("ambient", material.ambient);
  material.diffuse = call.number_or("diffuse", material.diffuse);
  material.specular = call.number_or("specular", material.specular);
  material.shininess = call.number_or("shininess", material.shininess);
  material.reflection = call.number_or("reflection", material.reflection);
  material.transmission = call.number_or("transmission", material.transmission);
  material.ior = call.number_or("ior", material.ior);
  material.emission = call.rgb("emission").value_or(material.emission);
  material.absorption = call.rgb("absorption").value_or(material.absorption);
  call.require(broken_rule(material));
  LookStatement look;
  look.material = material;
  return [look](std::vector<Solid> children) { return with_look(unite(std::move(children)), look); };
}

}  // namespace csgcast::text
