// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "csg/solid/scene_description.h"
#include "csg/text/statement/detail/call.h"

namespace csgcast::text {

/// Makes one solid of a statement's children, in file order.
using Combine = std::function<Solid(std::vector<Solid>)>;

/// A solid without children: cube, sphere, ...
struct SolidStatement {
  Solid (*make)(const Call&);
};
/// A statement that combines its children: booleans, transforms, looks, part.
struct OperatorStatement {
  enum class Parts { allowed, forbidden };  ///< below it

  Combine (*make)(const Call&);
  Parts parts = Parts::allowed;
};
/// Something about the picture that stands at the top of the file: camera, light, background, settings.
struct SceneStatement {
  enum class Count { once, many };

  void (*apply)(const Call&, SceneDescription&);
  Count count = Count::once;
};
/// Valid OpenSCAD that has no solid here yet.
struct UnsupportedStatement {};

/// A word of the scene text and what it means.
struct Statement {
  std::string_view name;
  Parameters parameters;
  std::variant<SolidStatement, OperatorStatement, SceneStatement, UnsupportedStatement> meaning;
  bool has_lengths = false;  ///< whether its numbers are a solid's or a transform's
};

/// The statement of that name; null if there is none.
const Statement* find_statement(std::string_view name);

/// The names of all statements that are supported.
std::span<const std::string_view> statement_names();

}  // namespace csgcast::text
