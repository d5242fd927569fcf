// SPDX-License-Identifier: MIT
#include "shade/trace/ray_tree.h"

#include <fmt/format.h>

#include <iterator>

#include "csg/exact/quadric_kind.h"

namespace csgcast {
namespace {

const char* name(RayKind kind) {
  switch (kind) {
    case RayKind::primary:
      return "primary";
    case RayKind::shadow:
      return "shadow";
    case RayKind::reflection:
      return "reflection";
    case RayKind::transmission:
      return "transmission";
  }
  return "";
}

const char* sentence(Fate fate) {
  switch (fate) {
    case Fate::hit:
      return "hits";
    case Fate::left:
      return "leaves: background";
    case Fate::at_depth_limit:
      return "not traced, depth limit: background";
    case Fate::below_cutoff:
      return "not traced: below min_contribution";
    case Fate::facing_away:
      return "not traced: faces away";
    case Fate::without_effect:
      return "not traced: adds nothing";
    case Fate::blocked:
      return "is blocked";
    case Fate::arrived:
      return "arrives";
  }
  return "";
}

const char* surface_word(const Surface& surface) {
  if (surface.is_plane) return word(QuadricKind::plane);
  return surface.other == nullptr ? word(kind_of_quadric(surface.exact.unpacked())) : "no quadric";
}

std::string text(Rgb c) { return fmt::format("[{:.6g} {:.6g} {:.6g}]", c.r, c.g, c.b); }

std::string line(const RayRecord& ray, const Scene& scene) {
  std::string result(2 * static_cast<std::size_t>(ray.depth), ' ');
  const auto out = std::back_inserter(result);
  fmt::format_to(out, "{}{}", ray.total ? "total " : "", name(ray.kind));
  if (ray.kind == RayKind::shadow) fmt::format_to(out, " to light {}", ray.light + 1);
  fmt::format_to(out, " {}", sentence(ray.fate));
  if (ray.fate == Fate::hit) {
    const Leaf& leaf = scene.leaf(ray.leaf);
    fmt::format_to(out, " {} {} (look {}) at t {:.9g}", to_string(leaf.place), word(leaf.kind), ray.look.index(),
                   ray.t);
    fmt::format_to(out, " on surface {} ({})", ray.surface.index(), surface_word(scene.surface(ray.surface)));
  }
  const bool reaches = ray.fate == Fate::hit || ray.fate == Fate::left || ray.fate == Fate::at_depth_limit;
  if (reaches || ray.fate == Fate::below_cutoff) fmt::format_to(out, ", weight {}", text(ray.weight));
  if (ray.fate == Fate::arrived) fmt::format_to(out, ", passes {}", text(ray.weight));
  if (reaches || ray.fate == Fate::arrived) fmt::format_to(out, ", brings {}", text(ray.brings));
  result += '\n';
  return result;
}

}  // namespace

std::string to_string(const RayTree& tree, const Scene& scene) {
  std::string result;
  for (const RayRecord& ray : tree) result += line(ray, scene);
  return result;
}

}  // namespace csgcast
