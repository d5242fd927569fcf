// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "csg/base/box.h"
#include "csg/base/ids.h"
#include "csg/base/progress.h"
#include "csg/solid/scene_description.h"
#include "csg/solid/solid.h"
#include "measure/check.h"
#include "measure/measure.h"
#include "measure/section.h"
#include "measure/thickness.h"
#include "query/ray_queries.h"
#include "raycast/cells/cells.h"
#include "raycast/scene/scene.h"
#include "shade/film/film.h"
#include "shade/film/view.h"
#include "shade/trace/render.h"

namespace csgcast {

/// How large a model is.
struct ModelCounts {
  std::size_t leaves = 0;
  std::size_t surfaces = 0;
  std::size_t parts = 0;
  std::size_t cells = 0;  ///< those that some surface crosses
  std::size_t bytes = 0;  ///< memory of the cells
};

/// What a picture has instead of the description's camera, lights, background and settings.
struct ViewChange {
  std::optional<CameraDescription> camera{};
  std::optional<std::vector<LightDescription>> lights{};  ///< none at all: what is not ambient is dark
  std::optional<Rgb> background{};
  std::optional<RenderSettings> settings{};
};

/// A solid made ready for every kind of question: compiled, and cut into cells, which it keeps for all that use them.
/// C and Python have the same calls: docs/api.md. Any number of threads may ask one model at once. A call shares its
/// work among the threads of its arena: on_threads() (raycast/packets/threads.h) is another number for any call. Calls
/// throw Cancelled if their progress callback says so.
class Model {
 public:
  /// Throws as compile() does. The solid alone has no camera and lights: pictures get the defaults of make_view().
  explicit Model(Solid solid, const Welding& welding = Welding::derived());
  /// Keeps the description's camera, lights, background and settings for pictures.
  explicit Model(SceneDescription description, const Welding& welding = Welding::derived());
  ~Model();
  Model(Model&&) noexcept;

  const Scene& scene() const;
  const Cells& cells() const;

  ModelCounts counts() const;
  /// Holds the solid, quickly found and maybe wide; null if it is empty, infinite where it may be unbounded.
  const Box& bounds() const;
  /// In file order.
  std::vector<std::string> part_names() const;
  /// The kind of a leaf, and which statement made it: `sphere at part.csg:3:5`; `sphere` if it was made in code. Throws
  /// Error(usage) for a leaf that there is not.
  std::string leaf_name(LeafId leaf) const;

  /// Rays and points: as of RayQueries.
  IntervalTable intervals(const Rays& rays, const QueryOptions& options = {}) const;
  HitTable first_hits(const Rays& rays, const QueryOptions& options = {}) const;
  std::vector<std::uint8_t> any_hits(const Rays& rays, const QueryOptions& options = {}) const;
  std::vector<Location> locate(std::span<const double> points, const QueryOptions& options = {}) const;
  /// ray_thickness() (model/ray_thickness.h).
  std::vector<double> thickness(const Rays& rays, const QueryOptions& options = {}) const;

  /// The functions of the same names in measure/, of the whole solid. section_svg(), section_json() and
  /// section_polylines() make other things of a section; section_image() (model/section_image.h) makes a picture.
  SceneMeasures measure(const MeasureOptions& options = {}) const;
  Section section(const Plane& plane, const SectionOptions& options = {}) const;
  CheckReport check(const CheckOptions& options = {}) const;
  /// find_thinnest(). Throws Error(usage) unless `grid` is 1 to 16384.
  std::optional<ThinPlace> thinnest(std::size_t grid = 512, const ProgressCallback& progress = {}) const;

  /// The description's camera, lights, background and settings, changed so, or the defaults of what both leave open,
  /// for pictures of `aspect` = width / height. Throws Error(bad_value) for what a scene text refuses of lights,
  /// background and settings (csg/solid/rules/rules.h).
  View view(double aspect, const ViewChange& change = {}) const;
  /// A picture in that view, or in another one: csgcast::render() with the cells that are there. Throws as that does.
  Film render(const RenderOptions& options = {}, RenderReport* report = nullptr) const;
  Film render(const View& view, const RenderOptions& options = {}, RenderReport* report = nullptr) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace csgcast
