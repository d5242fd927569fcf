// SPDX-License-Identifier: MIT
#include "csg/text/statement/solid_text.h"

#include <cmath>
#include <utility>

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

// A walk from the leaves up with a stack of its own.
class Writer {
 public:
  Document run(const Solid& root) {
    visit(root);
    while (!frames_.empty()) {
      Frame& top = frames_.back();
      if (top.next_child < top.solid->children().size()) {
        visit(top.solid->children()[top.next_child++]);
        continue;
      }
      Frame done = std::move(top);
      frames_.pop_back();
      deliver(std::move(done.node));
    }
    return std::move(document_);
  }

 private:
  struct Frame {
    const Solid* solid = nullptr;
    std::size_t next_child = 0;
    Node node;
  };

  void visit(const Solid& solid) {
    if (++statements_ > most_statements || solid.leaf_count() > most_statements) {
      throw Error(ErrorCode::limit, solid.place(), "the solid takes more than 4,194,304 statements",
                  "each use of a shared solid counts", "write it in pieces");
    }
    if (solid.kind() == Kind::leaf) {
      auto node = leaf_statement(solid.shape());
      if (!node) {
        throw Error(ErrorCode::unsupported, solid.place(), "a solid's surfaces cannot be told in doubles",
                    "its exact coefficients are longer", "make it with a function of csg/solid/primitives.h");
      }
      return deliver(std::move(*node));
    }
    Frame frame{&solid, 0, head_of(solid)};
    frame.node.has_block = true;
    frames_.push_back(std::move(frame));
  }

  void deliver(Node node) {
    if (frames_.empty()) {
      document_.nodes.push_back(std::move(node));
      return;
    }
    Frame& parent = frames_.back();
    const bool has_both =
        parent.solid->kind() == Kind::look && parent.solid->look().material && parent.solid->look().paint;
    if (has_both) {
      Node paint = color_statement(*parent.solid->look().paint);
      paint.has_block = true;
      paint.children.push_back(std::move(node));
      node = std::move(paint);
    }
    parent.node.children.push_back(std::move(node));
  }

  Document document_;
  std::vector<Frame> frames_;
  std::size_t statements_ = 0;
};

}  // namespace

Document document_of(const Solid& solid) { return Writer().run(solid); }

}  // namespace csgcast::text
