// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "csg/solid/look.h"

namespace csgcast::text {

/// A colour as scene texts write it: a CSS name (any case; `transparent` too), #rgb, #rgba, #rrggbb or #rrggbbaa, which
/// are sRGB. Nothing for other texts.
std::optional<Paint> paint_from(std::string_view text);

}  // namespace csgcast::text
