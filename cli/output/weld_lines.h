// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/output/json.h"
#include "csg/base/digits.h"
#include "raycast/weld/welding.h"

namespace csgcast::cli {

/// What was welded, and what nearly was: lines `welded` and `near misses`.
void append_welding(std::string& out, const WeldReport& report);
/// The same in one line each, for warnings. `digits` are those of the scene's numbers.
std::string joined_line(const WeldReport& report, Digits digits);
std::string near_misses_line(const WeldReport& report);
/// The same as a member `welded`.
void json_welding(Json& json, const WeldReport& report);

}  // namespace csgcast::cli
