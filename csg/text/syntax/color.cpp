// SPDX-License-Identifier: MIT
#include "csg/text/syntax/color.h"

#include "csg/text/syntax/color_names.h"

namespace csgcast::text {

std::optional<Paint> paint_from(std::string_view text) {
  const auto color = color_from(text);
  if (!color) return std::nullopt;
  return Paint{linear_from(*color), (*color)[3]};
}

}  // namespace csgcast::text
