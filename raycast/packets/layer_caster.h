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

/// The cells of each layer of a scene that transmits light. They are read-only once they are made.
class LayerCells {
 public:
  /// True if there are few enough layers for a ray to ask them all.
  static bool suits(const Scene& scene);

  /// The scene must outlive the cells. Precondition: suits().
  explicit LayerCells(const Scene& scene);

  const Scene& scene() const { return *scene_; }
  const std::vector<Cells>& layers() const { return layers_; }
  /// True if everything in a region looks like the region. It is known for all regions.
  bool looks_even(RegionId region) const { return even_looks_[region.index()] != 0; }
  bool all_look_even() const { return all_look_even_; }

 private:
  const Scene* scene_;
  std::vector<Cells> layers_;
  std::vector<std::uint8_t> even_looks_;
  bool all_look_even_;
};

/// Finds the first change of medium on a ray by the cells of the layers. The result is the first one of
/// Caster::interfaces, and the face there, bit for bit. The object is the working memory of one thread.
class LayerCaster {
 public:
  /// Both must outlive it. `caster` must be of the same scene. It decides which of two close crossings comes first.
  /// `instructions` are those of a PacketCaster.
  LayerCaster(const LayerCells& cells, Caster& caster, std::string_view instructions = {});

  const LayerCells& cells() const { return cells_; }

  enum class Outcome : std::uint8_t {
    none,   ///< the ray meets no boundary of a layer
    found,  ///< change() and face() describe it
    open,   ///< the first boundary of a layer changes nothing that a ray sees; call Caster::interfaces
  };
  Outcome look(const Ray& ray, const std::optional<Departure>& departure);
  const Interface& change() const { return change_; }
  /// The face there. Its leaf, region and part are not set.
  const Attribution& face() const { return face_; }

  /// Finds all changes in [0, end), as Caster::interfaces does, and the looks of their faces. The vectors are
  /// overwritten.
  void look_through(const Ray& ray, const std::optional<Departure>& departure, double end,
                    std::vector<Interface>& changes, std::vector<LookId>& looks);

  PacketCounts counts() const;
  /// The work done for rays that lanes could not decide.
  CasterCounts caster_counts() const;

 private:
  struct Query;

  // What the ray meets first in a layer.
  struct Meeting {
    Crossing crossing;
    Attribution face;
    bool hits = false;
    bool enters = false;
    bool is_inside = false;   // at the start; later, after the first end that it meets
    bool is_certain = false;  // true if t is as certain as those of lanes
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
