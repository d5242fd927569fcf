// SPDX-License-Identifier: MIT
#include "model/model.h"

#include <fmt/format.h>
#include <tbb/collaborative_call_once.h>

#include <algorithm>
#include <utility>

#include "csg/base/error.h"
#include "csg/base/place.h"
#include "csg/solid/rules/rules.h"
#include "model/ray_thickness.h"
#include "raycast/packets/threads.h"

namespace csgcast {
namespace {

constexpr std::size_t largest_grid = 16384;  // of thinnest(), along each axis

}  // namespace

struct Model::State {
  State(Solid solid, const Welding& welding) : queries(std::move(solid), welding) {}
  State(SceneDescription scene, const Welding& welding)
      : queries(std::exchange(scene.solid, {}), welding), description(std::move(scene)) {}

  /// The layers of a scene that transmits: made when a picture first asks them.
  const LayerCells& layers() {
    tbb::collaborative_call_once(layers_made, [&] { layer_cells.emplace(queries.scene()); });
    return *layer_cells;
  }

  RayQueries queries;
  SceneDescription description;  // but for the solid, which became the scene
  tbb::collaborative_once_flag layers_made;
  std::optional<LayerCells> layer_cells;
};

Model::Model(Solid solid, const Welding& welding) : state_(std::make_unique<State>(std::move(solid), welding)) {}
Model::Model(SceneDescription description, const Welding& welding)
    : state_(std::make_unique<State>(std::move(description), welding)) {}
Model::~Model() = default;
Model::Model(Model&&) noexcept = default;

const Scene& Model::scene() const { return state_->queries.scene(); }
const Cells& Model::cells() const { return state_->queries.cells(); }

ModelCounts Model::counts() const {
  const Cells::Counts counted = cells().counts();
  return {.leaves = scene().leaves().size(),
          .surfaces = scene().surfaces().size(),
          .parts = scene().parts().size(),
          .cells = counted.cells,
          .bytes = counted.bytes};
}

const Box& Model::bounds() const { return scene().bounds(); }

std::vector<std::string> Model::part_names() const {
  std::vector<std::string> names;
  for (const Part& part : scene().parts()) names.push_back(part.name.name);
  return names;
}

std::string Model::leaf_name(LeafId leaf) const {
  const std::size_t count = scene().leaves().size();
  if (leaf.index() >= count) {
    throw Error(ErrorCode::usage, {}, fmt::format("there is no leaf {}", leaf.index()),
                fmt::format("the model has {}, counted from 0", count), "give the number of a leaf");
  }
  const Leaf& found = scene().leaf(leaf);
  const std::string kind = word(found.kind);
  return found.place.line > 0 ? kind + " at " + to_string(found.place) : kind;
}

IntervalTable Model::intervals(const Rays& rays, const QueryOptions& options) const {
  return state_->queries.intervals(rays, options);
}

HitTable Model::first_hits(const Rays& rays, const QueryOptions& options) const {
  return state_->queries.first_hits(rays, options);
}

std::vector<std::uint8_t> Model::any_hits(const Rays& rays, const QueryOptions& options) const {
  return state_->queries.any_hits(rays, options);
}

std::vector<Location> Model::locate(std::span<const double> points, const QueryOptions& options) const {
  return state_->queries.locate(points, options);
}

std::vector<double> Model::thickness(const Rays& rays, const QueryOptions& options) const {
  return ray_thickness(cells(), rays, options);
}

SceneMeasures Model::measure(const MeasureOptions& options) const { return csgcast::measure(scene(), options); }

Section Model::section(const Plane& plane, const SectionOptions& options) const {
  return csgcast::section(scene(), plane, options);
}

CheckReport Model::check(const CheckOptions& options) const { return csgcast::check(scene(), options); }

std::optional<ThinPlace> Model::thinnest(std::size_t grid, const ProgressCallback& progress) const {
  if (grid == 0 || grid > largest_grid) {
    throw Error(ErrorCode::usage, {}, fmt::format("a grid of {} x {} rays", grid, grid),
                fmt::format("1 to {} along an axis are possible", largest_grid), "give a number in that range");
  }
  return find_thinnest(cells(), grid, progress);
}

View Model::view(double aspect, const ViewChange& change) const {
  SceneDescription seen = state_->description;
  if (change.camera) seen.camera = change.camera;
  if (change.background) {
    require(broken_rule("color", *change.background), "background");
    seen.background = change.background;
    seen.background_image.reset();
  }
  if (change.settings) {
    require(broken_rule(*change.settings), "settings");
    seen.settings = *change.settings;
  }
  View view = make_view(seen, scene(), aspect);
  if (!change.lights) return view;
  for (const LightDescription& light : *change.lights) require(broken_rule(light), "light");
  view.lights = *change.lights;
  return view;
}

Film Model::render(const RenderOptions& options, RenderReport* report) const {
  return render(view(static_cast<double>(options.width) / std::max(options.height, 1)), options, report);
}

Film Model::render(const View& view, const RenderOptions& options, RenderReport* report) const {
  const LayerCells* layers = nullptr;
  if (asks_layers(scene(), view, options)) on_threads(options.threads, [&] { layers = &state_->layers(); });
  return csgcast::render(scene(), view, options, report, {&cells(), layers});
}

}  // namespace csgcast
