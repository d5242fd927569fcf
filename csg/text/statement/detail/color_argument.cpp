// SPDX-License-Identifier: MIT
#include "csg/text/statement/detail/color_argument.h"

#include <fmt/format.h>

#include <string>

#include "csg/base/precondition.h"
#include "csg/text/syntax/shortened.h"
#include "csg/text/syntax/suggestion.h"

namespace csgcast::text {

EncodedColor color_from_string(const Call& call, std::string_view name) {
  CSGCAST_PRECONDITION(call.string(name).has_value());
  const std::string text = call.string(name).value();
  if (const auto color = color_from(text)) return *color;
  if (text.starts_with('#')) {
    call.reject(ErrorCode::bad_value, call.place(name), fmt::format("'{}' is no colour", shortened(text)),
                "a colour has 3, 4, 6 or 8 hexadecimal digits", "write #rgb, #rgba, #rrggbb or #rrggbbaa");
  }
  call.reject(ErrorCode::unknown_name, call.place(name), fmt::format("there is no colour named '{}'", shortened(text)),
              "", did_you_mean(text, color_names(), "give a CSS name, \"#rrggbb\" or [r, g, b]"));
}

std::optional<Rgb> color_argument(const Call& call, std::string_view name) {
  const Value* value = call.find(name);
  if (value == nullptr || std::holds_alternative<List>(value->data)) return call.rgb(name);
  if (!std::holds_alternative<std::string>(value->data)) {
    call.reject(ErrorCode::wrong_type, call.place(name),
                fmt::format("'{}' of '{}' must be a string or a list of three numbers", name, call.name()), "",
                "give a CSS name, \"#rrggbb\" or linear [r, g, b]");
  }
  const EncodedColor color = color_from_string(call, name);
  if (color[3] < 1) {
    call.reject(ErrorCode::bad_value, call.place(name),
                fmt::format("'{}' of '{}' must be an opaque colour", name, call.name()), "it has no use for an opacity",
                "write #rrggbb");
  }
  return linear_from(color);
}

}  // namespace csgcast::text
