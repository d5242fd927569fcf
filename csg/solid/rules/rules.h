// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "csg/solid/scene_description.h"

namespace csgcast {

/// A rule that a value breaks, as it goes on from "'argument' must ".
struct BrokenRule {
  const char* argument;
  const char* rule;
};

/// What the values of a solid and of a picture must be, in scene texts and in code alike. Arguments are called as in
/// the scene text. Nothing: no rule is broken.
std::optional<BrokenRule> broken_rule(const PartName& part);
std::optional<BrokenRule> broken_rule(const Material& material);
std::optional<BrokenRule> broken_rule(const Paint& paint);
std::optional<BrokenRule> broken_rule(const LightDescription& light);
std::optional<BrokenRule> broken_rule(const RenderSettings& settings);
/// Linear light, as of a background: finite, and not negative.
std::optional<BrokenRule> broken_rule(const char* argument, const Rgb& light);

/// Throws Error(bad_value), with the name of the statement, if a rule is broken.
void require(const std::optional<BrokenRule>& broken, const char* statement);

}  // namespace csgcast
