// SPDX-License-Identifier: MIT
#include "tests/bench/accuracy/pov_text.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "csg/base/length.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/simplify.h"

namespace csgcast::bench {
namespace {

using Kind = Solid::Kind;

std::string half_space(const QuadricForm& form) {
  using Form = QuadricForm;
  const auto c = [&form](Form::Term term) { return form.coefficient[term].nearest(); };
  const Vector linear{c(Form::x), c(Form::y), c(Form::z)};
  if (form.is_plane())
    return fmt::format("plane {{ {}, {:.17g} }}", pov_vector(linear.x, linear.y, linear.z),
                       -c(Form::one) / length(linear));
  return fmt::format("quadric {{ {}, {}, {}, {:.17g} }}", pov_vector(c(Form::xx), c(Form::yy), c(Form::zz)),
                     pov_vector(c(Form::xy), c(Form::xz), c(Form::yz)), pov_vector(linear.x, linear.y, linear.z),
                     c(Form::one));
}

std::string cone(const Disc& bottom, const Disc& top) {
  const std::string ends[] = {pov_vector(0, 0, bottom.z), pov_vector(0, 0, top.z)};
  if (bottom.radius == top.radius) return fmt::format("cylinder {{ {}, {}, {:.17g} }}", ends[0], ends[1], top.radius);
  return fmt::format("cone {{ {}, {:.17g}, {}, {:.17g} }}", ends[0], bottom.radius, ends[1], top.radius);
}

std::string leaf(const LeafShape& shape) {
  if (shape.kind == LeafKind::sphere) return fmt::format("sphere {{ 0, {:.17g} }}", shape.semi_axes->x);
  if (shape.kind == LeafKind::cylinder) return cone(shape.discs[0], shape.discs[1]);
  if (shape.kind == LeafKind::cube) {
    const Box& b = shape.bounds;
    return fmt::format("box {{ {}, {} }}", pov_vector(b.lower.x, b.lower.y, b.lower.z),
                       pov_vector(b.upper.x, b.upper.y, b.upper.z));
  }
  if (shape.forms.size() == 1) return half_space(shape.forms[0]);
  std::string text = "intersection {";
  for (const QuadricForm& form : shape.forms) text.append(" ").append(half_space(form));
  return text + " }";
}

// POV-Ray's matrices act on rows: the columns of ours, one after the other.
std::string matrix(const Transform& m) {
  std::string text = "matrix <";
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row)
      text += fmt::format("{}{:.17g}", column + row == 0 ? "" : ", ", m(row, column));
  }
  return text + ">";
}

// Of a simplified tree, in which nothing below the root is empty or everything.
std::string object(const Solid& solid, std::string_view union_word) {
  const auto children = [&solid](std::string_view word) {
    std::string text = fmt::format("{} {{", word);
    for (const Solid& child : solid.children()) text.append("\n").append(object(child, "merge"));
    return text + " }";
  };
  switch (solid.kind()) {
    case Kind::leaf:
      return leaf(solid.shape());
    case Kind::unite:
      return children(union_word);
    case Kind::intersect:
      return children("intersection");
    case Kind::subtract:
      return children("difference");
    case Kind::complement:
      return fmt::format("object {{ {} inverse }}", object(solid.children()[0], "merge"));
    case Kind::transform:
      return fmt::format("object {{ {} {} }}", object(solid.children()[0], union_word), matrix(solid.transform()));
    default:
      return object(solid.children()[0], union_word);
  }
}

}  // namespace

std::string pov_object(const Solid& solid, InnerFaces inner_faces) {
  const Solid simple = simplified(solid);
  if (simple.kind() == Kind::empty || simple.kind() == Kind::everything)
    return "intersection { plane { x, -1 } plane { -x, -1 } }";
  return object(simple, inner_faces == InnerFaces::hidden ? "union" : "merge");
}

std::string pov_vector(double x, double y, double z) { return fmt::format("<{:.17g}, {:.17g}, {:.17g}>", x, y, z); }

}  // namespace csgcast::bench
