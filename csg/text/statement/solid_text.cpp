// SPDX-License-Identifier: MIT
#include "csg/text/statement/solid_text.h"

#include <cmath>
#include <optional>
#include <utility>

#include "csg/base/error.h"
#include "csg/base/tree_walk.h"
#include "csg/solid/leaf_shape.h"
#include "csg/text/statement/detail/document_digits.h"
#include "csg/text/statement/detail/leaf_statement.h"

namespace csgcast::text {
namespace {

using Kind = Solid::Kind;

constexpr std::size_t most_statements = std::size_t{1} << 22;

Value rgb_value(const Rgb& color) { return list_value({color.r, color.g, color.b}); }

/// The channel that decodes to this one, or all but.
double encoded(double linear) {
  const double middle = srgb_from_linear(linear);
  for (const double candidate : {middle, std::nextafter(middle, 0), std::nextafter(middle, 1)}) {
    if (linear_from_srgb(candidate) == linear) return candidate;
  }
  return middle;
}

Node color_statement(const Paint& paint) {
  Node node = statement("color");
  add_argument(node, "c",
               {List{number_value(encoded(paint.color.r)), number_value(encoded(paint.color.g)),
                     number_value(encoded(paint.color.b)), number_value(paint.alpha)}});
  return node;
}

Node material_statement(const Material& m) {
  Node node = statement("material");
  add_argument(node, "color", rgb_value(m.color));
  for (const auto& [name, value] :
       {std::pair("ambient", m.ambient), std::pair("diffuse", m.diffuse), std::pair("specular", m.specular),
        std::pair("shininess", m.shininess), std::pair("reflection", m.reflection),
        std::pair("transmission", m.transmission), std::pair("ior", m.ior)}) {
    add_argument(node, name, number_value(value));
  }
  add_argument(node, "emission", rgb_value(m.emission));
  add_argument(node, "absorption", rgb_value(m.absorption));
  return node;
}

Node matrix_statement(const Transform& t) {
  List rows;
  for (std::size_t i = 0; i < 3; ++i)
    rows.push_back({List{number_value(t(i, 0)), number_value(t(i, 1)), number_value(t(i, 2)), number_value(t(i, 3))}});
  rows.push_back({List{number_value(0), number_value(0), number_value(0), number_value(1)}});
  Node node = statement("multmatrix");
  add_argument(node, "m", {std::move(rows)});
  if (t.linear_error > 0 || t.offset_error > 0)
    add_argument(node, "error", {List{number_value(t.linear_error), number_value(t.offset_error)}});
  return node;
}

Node part_statement(const PartName& part) {
  Node node = statement("part");
  add_argument(node, "name", {part.name});
  add_argument(node, "density", number_value(part.density));
  return node;
}

Node look_statement(const LookStatement& look) {
  if (look.material) return material_statement(*look.material);
  return look.paint ? color_statement(*look.paint) : statement("group");
}

/// What stands around a node's children.
Node head_of(const Solid& solid) {
  switch (solid.kind()) {
    case Kind::intersect:
      return statement("intersection");
    case Kind::subtract:
      return statement("difference");
    case Kind::everything:
    case Kind::complement:
      return statement("complement");
    case Kind::transform:
      return matrix_statement(solid.transform());
    case Kind::part:
      return part_statement(solid.part());
    case Kind::look:
      return look_statement(solid.look());
    default:
      return statement("union");
  }
}

[[noreturn]] void fail_as_too_long(const Solid& solid) {
  throw Error(ErrorCode::limit, solid.place(), "the solid takes more than 4,194,304 statements",
              "each use of a shared solid counts", "write it in pieces");
}

Node statement_of_leaf(const Solid& leaf) {
  if (auto node = leaf_statement(leaf.shape())) return std::move(*node);
  throw Error(ErrorCode::unsupported, leaf.place(), "a solid's surfaces cannot be told in doubles",
              "its exact coefficients are longer", "make it with a function of csg/solid/primitives.h");
}

/// Puts a statement between another one and its children.
void insert_below(Node& node, Node inner) {
  inner.has_block = true;
  inner.children.swap(node.children);
  node.children.push_back(std::move(inner));
}

/// The digits of a solid's numbers. If those of its parts differ, the fewest.
class FewestDigits {
 public:
  void add(const Solid& solid) {
    if (solid.kind() == Kind::leaf) add(solid.shape().error.digits);
    if (solid.kind() == Kind::transform) add(solid.transform().digits);
  }

  Digits get() const { return fewest_; }

 private:
  void add(Digits digits) {
    if (digits.count() < fewest_.count()) fewest_ = digits;
  }

  Digits fewest_;
};

Node digits_statement(Digits digits) {
  Node node = statement("settings");
  add_argument(node, "digits", number_value(digits.count()));
  return node;
}

/// Gives statements the places of the nodes that they are made of, in one file: the first there is.
class Places {
 public:
  void mark(Node& node, const Place& place) {
    if (place.line == 0) return;
    if (!is_known_) file_ = place.file;
    is_known_ = true;
    if (!(place.file == file_)) return;
    node.line = place.line;
    node.column = place.column;
  }

  const FileName& file() const { return file_; }

 private:
  FileName file_;
  bool is_known_ = false;
};

}  // namespace

Document document_of(const Solid& solid) {
  std::size_t statements = 0;
  Places places;
  FewestDigits digits;
  TreeWalk<const Solid, Node> walk;
  Node whole = walk.run(
      {&solid, 1}, Node{},
      [&](const Solid& part, Node& above) -> std::optional<Node> {
        if (++statements > most_statements || part.leaf_count() > most_statements) fail_as_too_long(part);
        digits.add(part);
        if (part.kind() == Kind::leaf) {
          above.children.push_back(statement_of_leaf(part));
          places.mark(above.children.back(), part.place());
          return std::nullopt;
        }
        Node node = head_of(part);
        node.has_block = true;
        places.mark(node, part.place());
        return node;
      },
      [](const Solid& part) { return part.children(); },
      [](const Solid& part, Node node, Node& above) {
        const bool has_both = part.kind() == Kind::look && part.look().material && part.look().paint;
        if (has_both) insert_below(node, color_statement(*part.look().paint));
        above.children.push_back(std::move(node));
      });
  Document document;
  document.file = places.file();
  document.nodes.swap(whole.children);
  // What the text shows by itself needs no word, unless a reader would take it for something else.
  if (digits.get().are_few() || digits_shown(document).are_few())
    document.nodes.insert(document.nodes.begin(), digits_statement(digits.get()));
  return document;
}

}  // namespace csgcast::text
