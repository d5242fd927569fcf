// SPDX-License-Identifier: MIT
#include "tests/bench/peers/peer_scene.h"

#include <filesystem>
#include <stdexcept>

#include "csg/base/length.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "shade/film/camera.h"

namespace csgcast::bench {
namespace {

bool holds(const Box& box, Point p) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (p[axis] < box.lower[axis] || p[axis] > box.upper[axis]) return false;
  }
  return true;
}

// The place in a tile of its index-th ray: x and y are the index's even and odd bits.
int every_second_bit(int index) { return (index & 1) | ((index >> 1) & 2) | ((index >> 2) & 4); }

std::vector<Ray> camera_rays(const CameraDescription& description, int side) {
  const int tiles = (side + tile_side - 1) / tile_side;
  const Camera camera(description, tiles * tile_side, tiles * tile_side);
  std::vector<Ray> rays;
  for (int tile = 0; tile < tiles * tiles; ++tile) {
    for (int index = 0; index < tile_side * tile_side; ++index) {
      const int x = tile % tiles * tile_side + every_second_bit(index);
      const int y = tile / tiles * tile_side + every_second_bit(index >> 1);
      rays.push_back(camera.ray(x + 0.5, y + 0.5));
    }
  }
  return rays;
}

}  // namespace

PeerScene read_peer_scene(const std::string& file, int side) {
  const SceneDescription description = text::build(text::read_file(file));
  if (!description.camera) throw std::runtime_error(file + ": no camera statement");
  PeerScene scene;
  scene.name = std::filesystem::path(file).stem().string();
  scene.compiled = compile(description.solid, Welding::derived());
  scene.tree = part_tree(description.solid);
  if (holds(scene.compiled.bounds(), description.camera->eye))
    throw std::runtime_error(file + ": the camera is not outside the solid's bounds");
  scene.rays = camera_rays(*description.camera, side);
  scene.size = length(scene.compiled.bounds().size());
  return scene;
}

std::vector<Ray> every_tile(const std::vector<Ray>& rays, std::size_t stride) {
  std::vector<Ray> some;
  for (std::size_t i = 0; i < rays.size(); i += stride * tile_rays)
    some.insert(some.end(), rays.begin() + static_cast<std::ptrdiff_t>(i),
                rays.begin() + static_cast<std::ptrdiff_t>(i + tile_rays));
  return some;
}

}  // namespace csgcast::bench
