// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "csg/solid/look.h"
#include "csg/text/statement/detail/call.h"
#include "csg/text/syntax/color_names.h"

namespace csgcast::text {

/// The colour that a "string" argument names, or writes in hexadecimal digits. Throws Error(unknown_name) or
/// Error(bad_value) if it does neither. Precondition: the argument is a string.
EncodedColor color_from_string(const Call& call, std::string_view name);

/// A colour argument of a statement that has no opacity: a "string" as above, which counts as sRGB, or a list of three
/// numbers that are not negative, which are linear and have no upper limit. Throws Error(bad_value) for a string with
/// an opacity below 1.
std::optional<Rgb> color_argument(const Call& call, std::string_view name);

}  // namespace csgcast::text
