// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>

#include "raycast/scene/scene.h"

namespace csgcast {

/// A scene's space, cut into cells. Each cell has the part of the tree that matters in it. Cells make rays fast
/// (docs/cells.md). They are read-only once they are made; any number of threads may use them.
class Cells {
 public:
  /// Makes the cells of the whole solid, or of one of its nodes. The scene must outlive them. It takes some 20 us a
  /// leaf, shared by the threads of the present arena (raycast/packets/threads.h).
  explicit Cells(const Scene& scene) : Cells(scene, scene.root()) {}
  Cells(const Scene& scene, NodeId node);
  ~Cells();
  Cells(Cells&&) noexcept;

  const Scene& scene() const { return *scene_; }
  NodeId node() const { return node_; }

  struct Counts {
    std::size_t nodes = 0;      ///< nodes of the kd-tree, ends included
    std::size_t cells = 0;      ///< cells that some surface crosses
    std::size_t surfaces = 0;   ///< surfaces of these cells, summed over the cells
    std::size_t large = 0;      ///< cells with more surfaces than a table of truth values takes
    std::size_t undecided = 0;  ///< cells through which every ray is left to the caster
    std::size_t boxed = 0;      ///< leaves, or intersections of leaves, in a hierarchy of boxes; 0 if there is none
    std::size_t bytes = 0;      ///< memory of all of them
  };
  Counts counts() const;

  /// The cells themselves, for code that casts packets (cells_data.h).
  struct Data;
  const Data& data() const { return *data_; }

 private:
  const Scene* scene_;
  NodeId node_;
  std::unique_ptr<const Data> data_;
};

}  // namespace csgcast
