// SPDX-License-Identifier: MIT
#include "raycast/scene/detail/boundedness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "csg/base/length.h"
#include "csg/base/truth_formula.h"
#include "raycast/scene/detail/far_form.h"

namespace csgcast::detail {
namespace {

// How many values of forms a node may take. After so many for all nodes, boxes are no longer drawn in.
constexpr std::uint64_t most_work_of_node = 1'000'000;
constexpr std::uint64_t most_work = 50'000'000;
constexpr double smallest_part = 0x1p-24;
constexpr double part_for_relations = 0x1p-6;  // half of a side: parts of this size ask what signs tell of each other
// The shares of w that are tried: the greatest serve most solids, the least is as good as infinity.
constexpr std::array<double, 6> shares{0x1p-3, 0x1p-6, 0x1p-12, 0x1p-24, 0x1p-48, 0x1p-100};
// The box is found to this share of its sides: first coarsely, again and again, and at last finely.
constexpr double coarse = 0x1p-3;
constexpr double fine = 0x1p-5;
constexpr int most_passes = 64;

/// The truth formula of a node. Its conditions are that a surface's form is at most 0, or that a place is in the box of
/// a bounded leaf.
struct NodeFormula {
  TruthFormula terms;
  std::vector<SurfaceId> surfaces;  // the conditions come in this order: surfaces, then boxes, then one unknown
  std::vector<Box> boxes;
};

/// Writes a node as a formula whose negations stand before conditions only.
class FormulaWriter {
 public:
  /// If `positive_only`, nothing is taken away: the formula holds wherever the node's does, and more.
  FormulaWriter(const SceneTables& tables, bool positive_only) : tables_(tables), positive_only_(positive_only) {}

  NodeFormula write(NodeId root) {
    std::vector<Open> open;
    enter(root, false, open);
    while (!open.empty()) {
      Open& top = open.back();
      if (top.next == top.children.size()) {
        formula_.terms[top.term].size = static_cast<std::uint32_t>(formula_.terms.size()) - top.term;
        open.pop_back();
        continue;
      }
      const std::uint32_t k = top.next++;
      const bool is_negated =
          top.is_negated != (top.op == Node::Op::complement || (top.op == Node::Op::subtract && k > 0));
      enter(top.children[k], is_negated, open);
    }
    number();
    return std::move(formula_);
  }

 private:
  struct Open {
    Node::Op op;
    bool is_negated;
    std::span<const NodeId> children;
    std::uint32_t term;  // its operator
    std::uint32_t next = 0;
  };
  // Numbers of conditions while the formula is written: surfaces as they are, boxes and the unknown from the end.
  static constexpr std::uint32_t unknown = 0xffffffffu;
  static constexpr std::uint32_t first_box = 0x80000000u;

  void operator_term(bool unites) {
    formula_.terms.push_back({unites ? TruthTerm::Op::unite : TruthTerm::Op::intersect, false, 1, 0});
  }

  void condition_term(std::uint32_t condition, bool is_contrary) {
    formula_.terms.push_back({TruthTerm::Op::condition, is_contrary, 1, condition});
  }

  void enter(NodeId id, bool is_negated, std::vector<Open>& open) {
    const Node& node = tables_.nodes[id.index()];
    if (node.op == Node::Op::empty) return operator_term(!is_negated);
    if (node.op == Node::Op::everything || (is_negated && positive_only_))
      return operator_term(is_negated && !positive_only_);
    if (node.op == Node::Op::leaf) return leaf(node, is_negated);
    const bool unites = node.op == Node::Op::unite;
    open.push_back({node.op, is_negated, std::span(tables_.children).subspan(node.first, node.count),
                    static_cast<std::uint32_t>(formula_.terms.size())});
    operator_term(unites != is_negated);
  }

  void leaf(const Node& node, bool is_negated) {
    const Leaf& leaf = tables_.leaves[node.first];
    const std::size_t begin = formula_.terms.size();
    operator_term(is_negated);
    if (node.box.is_finite()) {
      condition_term(first_box + static_cast<std::uint32_t>(formula_.boxes.size()), is_negated);
      formula_.boxes.push_back(node.box);
    }
    if (leaf.function != nullptr) {
      condition_term(unknown, is_negated);
    } else {
      for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
        const HalfSpace& half_space = tables_.half_spaces[k];
        condition_term(half_space.surface.index(), is_negated != (half_space.sense == Sense::positive));
      }
    }
    formula_.terms[begin].size = static_cast<std::uint32_t>(formula_.terms.size() - begin);
  }

  // Gives the conditions their final numbers.
  void number() {
    for (const TruthTerm& term : formula_.terms) {
      if (term.op == TruthTerm::Op::condition && term.condition < first_box)
        formula_.surfaces.emplace_back(term.condition);
    }
    auto& surfaces = formula_.surfaces;
    std::sort(surfaces.begin(), surfaces.end());
    surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
    const auto count = static_cast<std::uint32_t>(surfaces.size());
    for (TruthTerm& term : formula_.terms) {
      if (term.op != TruthTerm::Op::condition) continue;
      if (term.condition == unknown) {
        term.condition = count + static_cast<std::uint32_t>(formula_.boxes.size());
      } else if (term.condition >= first_box) {
        term.condition = count + (term.condition - first_box);
      } else {
        const auto at = std::lower_bound(surfaces.begin(), surfaces.end(), SurfaceId(term.condition));
        term.condition = static_cast<std::uint32_t>(at - surfaces.begin());
      }
    }
  }

  const SceneTables& tables_;
  NodeFormula formula_;
  bool positive_only_;
};

/// What the signs of two forms that differ by a constant, but for a factor, tell of each other.
struct Relation {
  enum class Kind : std::uint8_t {
    implies,  ///< where the first is at most 0, so is the second
    exclude,  ///< they are never both at most 0
    cover,    ///< one of them is always at most 0
  };
  Kind kind;
  std::uint32_t first;
  std::uint32_t second;
};

std::optional<Relation> relation(const QuadricForm& a, const QuadricForm& b, std::uint32_t i, std::uint32_t j) {
  constexpr std::size_t constant = QuadricForm::one;
  std::size_t m = 0;
  while (m < constant && a.coefficient[m].is_zero()) ++m;
  if (m == constant || b.coefficient[m].is_zero()) return std::nullopt;
  const auto difference = [&](std::size_t k) {
    return a.coefficient[k] * b.coefficient[m] - b.coefficient[k] * a.coefficient[m];
  };
  for (std::size_t k = 0; k < constant; ++k) {
    if (!difference(k).is_zero()) return std::nullopt;
  }
  // a = s b + rest, with s = a_m / b_m.
  const bool is_alike = a.coefficient[m].sign() == b.coefficient[m].sign();
  const bool rest_is_positive = difference(constant).sign() * b.coefficient[m].sign() > 0;
  if (is_alike)
    return rest_is_positive ? Relation{Relation::Kind::implies, i, j} : Relation{Relation::Kind::implies, j, i};
  return Relation{rest_is_positive ? Relation::Kind::exclude : Relation::Kind::cover, i, j};
}

/// A node's formula in the coordinates of a region.
class LocalFormula {
 public:
  LocalFormula(const NodeFormula& formula, const SurfaceTable& surfaces, const Region& region)
      : formula_(formula),
        surfaces_(surfaces),
        conditions_(formula.surfaces.size() + formula.boxes.size() + 1, Truth::unknown),
        values_(formula.terms.size()) {
    for (const SurfaceId id : formula.surfaces) {
      const PackedForm* form = surfaces.form(id);
      forms_.push_back(form != nullptr ? std::optional<FarForm>(std::in_place, form->unpacked(), region)
                                       : std::nullopt);
    }
    const double scale = std::ldexp(1, -region.exponent);
    for (const Box& box : formula.boxes) {
      const Vector rounding = 0x1p-40 * Vector{1, 1, 1};
      boxes_.push_back({as_point(scale * (box.lower - region.center)) - rounding,
                        as_point(scale * (box.upper - region.center)) + rounding});
    }
  }

  std::uint64_t work() const { return conditions_.size() + formula_.terms.size() / 4; }

  /// Far away all bounded leaves have ended.
  Truth holds(const FarPart& part) {
    return value([&](const FarForm& form) { return form.is_negative(part); }, [](const Box&) { return Truth::no; });
  }

  /// Whether the formula holds nowhere that holds() was asked for last, whatever signs the forms have that it could not
  /// tell, if these signs fit each other. `work` is increased by what that takes.
  bool holds_never(std::uint64_t& work) {
    constexpr std::size_t most_open = 10;
    find_relations();
    if (relations_.empty()) return false;
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < forms_.size(); ++i) {
      if (conditions_[i] == Truth::unknown && forms_[i]) open.push_back(i);
    }
    if (open.size() > most_open) return false;
    for (std::uint32_t signs = 0; signs < std::uint32_t{1} << open.size(); ++signs) {
      for (std::size_t k = 0; k < open.size(); ++k) conditions_[open[k]] = truth(((signs >> k) & 1) != 0);
      work += formula_.terms.size() / 4 + relations_.size() + 1;
      if (!fit()) continue;
      evaluate(formula_.terms, conditions_, values_);
      if (values_.front() != Truth::no) return false;
    }
    return true;
  }

  Truth holds_in(Vector middle, Vector half) {
    const auto apart = [&](const Box& box) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (middle[k] - half[k] > box.upper[k] || middle[k] + half[k] < box.lower[k]) return Truth::no;
      }
      return Truth::unknown;
    };
    return value([&](const FarForm& form) { return form.is_negative_in(middle, half); }, apart);
  }

  double farthest_surface() const {
    double most = 0;
    for (const auto& form : forms_) {
      const double distance = form ? form->distance() : 0;
      if (std::isfinite(distance)) most = std::fmax(most, distance);
    }
    return most;
  }

 private:
  static Point as_point(Vector v) { return {v.x, v.y, v.z}; }

  template <class OfForm, class OfBox>
  Truth value(OfForm&& of_form, OfBox&& of_box) {
    for (std::size_t i = 0; i < forms_.size(); ++i) conditions_[i] = forms_[i] ? of_form(*forms_[i]) : Truth::unknown;
    for (std::size_t i = 0; i < boxes_.size(); ++i) conditions_[forms_.size() + i] = of_box(boxes_[i]);
    evaluate(formula_.terms, conditions_, values_);
    return values_.front();
  }

  void find_relations() {
    constexpr std::size_t most_forms = 64;
    if (has_asked_ || forms_.size() > most_forms) return;
    has_asked_ = true;
    std::vector<QuadricForm> exact(forms_.size());
    for (std::size_t i = 0; i < forms_.size(); ++i) {
      if (forms_[i]) exact[i] = surfaces_.form(formula_.surfaces[i])->unpacked();
    }
    for (std::uint32_t i = 0; i < forms_.size(); ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        if (!forms_[i] || !forms_[j]) continue;
        if (const auto found = relation(exact[i], exact[j], i, j)) relations_.push_back(*found);
      }
    }
  }

  // Whether the conditions' values do not contradict each other.
  bool fit() const {
    return std::none_of(relations_.begin(), relations_.end(), [&](const Relation& r) {
      const Truth a = conditions_[r.first], b = conditions_[r.second];
      switch (r.kind) {
        case Relation::Kind::implies:
          return a == Truth::yes && b == Truth::no;
        case Relation::Kind::exclude:
          return a == Truth::yes && b == Truth::yes;
        default:
          return a == Truth::no && b == Truth::no;
      }
    });
  }

  const NodeFormula& formula_;
  const SurfaceTable& surfaces_;
  bool has_asked_ = false;  // for the relations
  std::vector<Relation> relations_;
  std::vector<std::optional<FarForm>> forms_;
  std::vector<Box> boxes_;
  std::vector<Truth> conditions_;
  std::vector<Truth> values_;
};

/// Looks for the bounds of one formula.
class BoundsSearch {
 public:
  BoundsSearch(const NodeFormula& formula, const SurfaceTable& surfaces, const Box& known)
      : formula_(formula), surfaces_(surfaces), known_(known) {}

  Extent run(bool draws_in) {
    // Forms are made anew for each place, so thousands of them take too long.
    constexpr std::size_t most_tightened = 4096, most_bounded = 65536;
    const std::size_t size = formula_.surfaces.size() + formula_.boxes.size();
    Box box = known_;
    if (!box.is_finite()) {
      if (size > most_bounded) return {};
      const Extent far = outermost(first_region());
      if (far.kind != Extent::Kind::bounded) return far;
      box = intersection(far.box, known_);
    }
    return {Extent::Kind::bounded, draws_in && size <= most_tightened ? tightened(box) : box, {}};
  }

  std::uint64_t work() const { return work_; }

 private:
  // Holds the bounded leaves in its cube, and most surfaces come near it.
  Region first_region() const {
    Box box = known_;
    for (const Box& leaf : formula_.boxes) box = hull(box.is_finite() ? box : Box(), leaf);
    Region region;
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool low = std::isfinite(box.lower[k]), high = std::isfinite(box.upper[k]);
      region.center[k] = low && high ? 0.5 * box.lower[k] + 0.5 * box.upper[k]
                         : low       ? box.lower[k]
                         : high      ? box.upper[k]
                                     : 0;
      if (low && high) size = std::fmax(size, 0.5 * (box.upper[k] - box.lower[k]));
    }
    const double distance = LocalFormula(formula_, surfaces_, region).farthest_surface();
    size = std::fmax(size, distance);
    region.exponent = size > 0 ? std::ilogb(size) + 1 : 0;
    return region;
  }

  // The node is bounded if its formula is false on all parts of the cube's six sides.
  Extent outermost(const Region& region) {
    LocalFormula formula(formula_, surfaces_, region);
    double least = 1;
    std::vector<FarPart> open;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        FarPart part{{0, 0, 0}, {1, 1, 1}, 1};
        part.middle[axis] = side;
        part.half[axis] = 0;
        open.push_back(part);
      }
    }
    while (!open.empty()) {
      FarPart part = open.back();
      open.pop_back();
      part.w = shares.back();
      work_ += formula.work();
      const Truth at_infinity = formula.holds(part);
      if (at_infinity == Truth::yes) return {Extent::Kind::unbounded, {}, part.middle};
      const bool asks_relations = longest(part.half) == part_for_relations;
      if (at_infinity == Truth::no || (asks_relations && formula.holds_never(work_))) {
        least = std::fmin(least, greatest_share(formula, part));
        continue;
      }
      if (longest(part.half) < smallest_part || work_ > most_work_of_node)
        return {Extent::Kind::undecided, {}, part.middle};
      split(part, open);
    }
    const double reach = std::ldexp(1 / least, region.exponent);
    const Vector diagonal{reach, reach, reach};
    return {Extent::Kind::bounded, Box{region.center - diagonal, region.center + diagonal}, {}};
  }

  // Precondition: the formula holds nowhere in the part with the least share.
  double greatest_share(LocalFormula& formula, FarPart part) {
    for (const double share : shares) {
      part.w = share;
      work_ += formula.work();
      if (formula.holds(part) == Truth::no || formula.holds_never(work_)) return share;
    }
    return shares.back();
  }

  static void split(const FarPart& part, std::vector<FarPart>& open) {
    std::array<FarPart, 4> quarters{part, part, part, part};
    unsigned bit = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (part.half[axis] == 0) continue;
      for (unsigned i = 0; i < 4; ++i) {
        quarters[i].half[axis] = 0.5 * part.half[axis];
        quarters[i].middle[axis] += ((i & bit) != 0 ? 0.5 : -0.5) * part.half[axis];
      }
      bit <<= 1;
    }
    open.insert(open.end(), quarters.begin(), quarters.end());
  }

  // A piece of space on the way to one side of the bounds.
  struct Piece {
    Vector middle;
    Vector half;
    double reach;  // towards the side

    friend bool operator<(const Piece& a, const Piece& b) { return a.reach < b.reach; }
  };

  // Draws the sides in, about a center of their own each time, until they are found.
  Box tightened(Box box) {
    double fineness = coarse;
    for (int pass = 0; pass < most_passes; ++pass) {
      if (box.is_null() || work_ > most_work_of_node) return box;
      const Vector before = box.size();
      const Region region = Region::around(box);
      LocalFormula formula(formula_, surfaces_, region);
      Box local{as_point(std::ldexp(1, -region.exponent) * (box.lower - region.center)),
                as_point(std::ldexp(1, -region.exponent) * (box.upper - region.center))};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
          if (!draw_in(formula, local, axis, sign, fineness)) return {};
        }
      }
      box = intersection(box, in_world(local, region));
      const Vector after = box.size();
      const bool stays = after.x > 0.75 * before.x && after.y > 0.75 * before.y && after.z > 0.75 * before.z;
      if (stays && fineness == fine) return box;
      if (stays) fineness = fine;
    }
    return box;
  }

  static Point as_point(Vector v) { return {v.x, v.y, v.z}; }

  static Box in_world(const Box& local, const Region& region) {
    Box box;
    const double unit = std::ldexp(1, region.exponent);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto outward = [&](double at, double way) {
        return std::nextafter(region.center[k] + std::nextafter(unit * at, way * HUGE_VAL), way * HUGE_VAL);
      };
      box.lower[k] = outward(local.lower[k], -1);
      box.upper[k] = outward(local.upper[k], 1);
    }
    return box;
  }

  // Moves one side of the box to the farthest piece that the formula may hold in. False if it holds nowhere.
  bool draw_in(LocalFormula& formula, Box& box, std::size_t axis, double sign, double fineness) {
    constexpr int most_pieces = 1 << 13;
    const auto piece_of = [&](Vector middle, Vector half) {
      return Piece{middle, half, sign * middle[axis] + half[axis]};
    };
    const Vector size = box.size();
    if (!(size[axis] > 0)) return true;
    std::priority_queue<Piece> open;
    constexpr double more = 1 + 0x1p-40;  // for the rounding of the middle
    open.push(piece_of(as_vector(box.center()), 0.5 * more * size));
    for (int i = 0; !open.empty(); ++i) {
      const Piece piece = open.top();
      open.pop();
      work_ += formula.work();
      if (formula.holds_in(piece.middle, piece.half) == Truth::no) continue;
      if (i == 0 && formula.holds_never(work_)) continue;
      std::size_t longest_side = axis;
      double most = 2 * piece.half[axis] / (fineness * size[axis]);  // the side that is looked for comes first
      for (std::size_t k = 0; k < 3; ++k) {
        const double share = piece.half[k] / (fineness * size[k]);
        if (k != axis && share > most) {
          most = share;
          longest_side = k;
        }
      }
      if (most <= 1 && formula.holds_never(work_)) continue;
      if (most <= 1 || i >= most_pieces || work_ > most_work_of_node) {
        double& end = sign > 0 ? box.upper[axis] : box.lower[axis];
        end = sign * std::fmin(sign * end, piece.reach);
        return true;
      }
      Vector half = piece.half;
      half[longest_side] *= 0.5;
      for (const double way : {-1.0, 1.0}) {
        Vector middle = piece.middle;
        middle[longest_side] += way * half[longest_side];
        open.push(piece_of(middle, half));
      }
    }
    return false;
  }

  const NodeFormula& formula_;
  const SurfaceTable& surfaces_;
  Box known_;  // holds the node; its sides may be infinite
  std::uint64_t work_ = 0;
};

}  // namespace

Extent Boundedness::of(NodeId node) {
  Extent extent;
  // What is taken away seldom bounds a solid, and without it there is less to compute.
  for (const bool positive_only : {true, false}) {
    const NodeFormula formula = FormulaWriter(tables_, positive_only).write(node);
    BoundsSearch search(formula, surfaces_, tables_.nodes[node.index()].box);
    extent = search.run(work_ <= most_work);
    work_ += search.work();
    if (extent.kind == Extent::Kind::bounded) return extent;
  }
  return extent;
}

}  // namespace csgcast::detail
