// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "raycast/cells/cells.h"
#include "raycast/packets/packet_caster.h"
#include "raycast/ray/caster.h"

namespace csgcast {

/// The cells of each layer of a scene that transmits. Read-only once they are made.
class LayerCells {
 public:
  /// Whether there are few enough layers for a ray to ask them all.
  static bool suits(const Scene& scene);

  /// The scene must outlive the cells. Precondition: suits().
  explicit LayerCells(const Scene& scene);

  const Scene& scene() const { return *scene_; }
  const std::vector<Cells>& layers() const { return layers_; }
  /// Whether all that a region is made of looks like it; of all regions.
  bool looks_even(RegionId region) const { return even_looks_[region.index()] != 0; }
  bool all_look_even() const { return all_look_even_; }

 private:
  const Scene* scene_;
  std::vector<Cells> layers_;
  std::vector<std::uint8_t> even_looks_;
  bool all_look_even_;
};

/// Finds the first change of medium on a ray by the cells of the layers: the first one of Caster::interfaces, and the
/// face there, bit for bit. The working memory of one thread.
class LayerCaster {
 public:
  /// Both must outlive it. `caster`, of the same scene, is asked which of two crossings that are close comes first.
  /// `instructions`: as of a PacketCaster.
  LayerCaster(const LayerCells& cells, Caster& caster, std::string_view instructions = {});

  const LayerCells& cells() const { return cells_; }

  enum class Outcome : std::uint8_t {
    none,   ///< the ray meets no boundary of a layer
    found,  ///< change() and face() tell of it
    open,   ///< the first boundary of a layer changes nothing that a ray sees: Caster::interfaces has to be asked
  };
  Outcome look(const Ray& ray, const std::optional<Departure>& departure);
  const Interface& change() const { return change_; }
  /// Without its leaf, region and part: these are not asked for.
  const Attribution& face() const { return face_; }

  /// All changes in [0, end), Caster::interfaces, and what their faces show. The vectors are overwritten.
  void look_through(const Ray& ray, const std::optional<Departure>& departure, double end,
                    std::vector<Interface>& changes, std::vector<LookId>& looks);

  PacketCounts counts() const;
  /// What the rays cost that lanes could not decide.
  CasterCounts caster_counts() const;

 private:
  struct Query;

  // What the ray meets first of a layer.
  struct Meeting {
    Crossing crossing;
    Attribution face;
    bool hits = false;
    bool enters = false;
    bool is_inside = false;   // at the start; then, after what it meets first
    bool is_certain = false;  // t is as certain as those of lanes
  };

  void meet(std::size_t layer, const Query& query);
  std::weak_ordering order(const Meeting& a, const Meeting& b, Query& query);
  bool far_apart(const Crossing& a, const Crossing& b, const Query& query) const;
  std::weak_ordering exact_order(const Crossing& a, const Crossing& b, Query& query);
  std::size_t holder() const;
  const Box& box_of(std::size_t layer) const { return scene_.node(scene_.layers()[layer].node).box; }

  const LayerCells& cells_;
  const Scene& scene_;
  Caster& caster_;
  std::vector<PacketCaster> casters_;  // by layer
  std::vector<Meeting> meetings_;      // by layer
  std::vector<IntervalBatch> lists_;   // by layer
  std::vector<std::span<const Interval>> spans_;
  std::vector<std::size_t> passed_;
  Interface change_;
  Attribution face_{};
};

}  // namespace csgcast
