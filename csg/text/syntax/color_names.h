// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "csg/solid/look.h"

namespace csgcast::text {

/// sRGB and opacity, each in [0, 1].
using EncodedColor = std::array<double, 4>;

/// A colour by its name in CSS and SVG (any case; `transparent` too).
std::optional<EncodedColor> named_color(std::string_view name);

/// A colour written #rgb, #rgba, #rrggbb or #rrggbbaa.
std::optional<EncodedColor> hexadecimal_color(std::string_view text);

/// Either: hexadecimal if it starts with #.
inline std::optional<EncodedColor> color_from(std::string_view text) {
  return text.starts_with('#') ? hexadecimal_color(text) : named_color(text);
}

/// The three channels; the opacity does not count.
Rgb linear_from(const EncodedColor& color);

/// All names, in lower case and alphabetical order. Source: CSS Color Module Level 4, section 6.1.
std::span<const std::string_view> color_names();

}  // namespace csgcast::text
