// SPDX-License-Identifier: MIT
#include "csg/text/color.h"

#include "csg/text/detail/color_argument.h"
#include "csg/text/detail/color_names.h"

namespace csgcast::text {

std::optional<Paint> paint_from(std::string_view text) {
  const auto color = color_from(text);
  if (!color) return std::nullopt;
  return Paint{linear_from(*color), (*color)[3]};
}

}  // namespace csgcast::text
