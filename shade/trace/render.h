// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "csg/base/progress.h"
#include "raycast/cells/cells.h"
#include "raycast/packets/layer_caster.h"
#include "raycast/ray/caster.h"
#include "raycast/scene/scene.h"
#include "shade/film/film.h"
#include "shade/film/pixel_region.h"
#include "shade/film/view.h"
#include "shade/trace/report.h"

namespace csgcast {

/// What a picture shows.
enum class Mode : std::uint8_t {
  shaded,  ///< light: shade/light/phong.h and shade/trace/tracer.h
  edges,   ///< a line drawing on pale shading
  xray,    ///< how long each ray is inside the solid
  depth,   ///< how far the first boundary is from the eye (for parallel cameras: from the plane of the eye)
  normal,  ///< which way the first boundary faces, towards the viewer
  id,      ///< which leaf the first boundary belongs to
};

/// What the film of a mode holds.
FilmContent content(Mode mode);

/// How rays are traced. The picture is the same, bit for bit.
enum class Engine : std::uint8_t {
  packets,  ///< many at once, where that is possible
  scalar,   ///< one by one: the definition
};

/// Which pixels of a shaded picture get all their samples.
enum class Sampling : std::uint8_t {
  regular,   ///< all
  adaptive,  ///< those that do not look like the pixels around them, the same bit for bit as with regular sampling. The
             ///< others get one sample, at their centre: docs/shading.md
};

struct RenderOptions {
  int width = 800;
  int height = 600;
  int samples = 1;  ///< rays a pixel, rounded up to a square number k²: a regular k x k grid, averaged; depth, normal
                    ///< and id always take 1
  Sampling sampling = Sampling::regular;
  Mode mode = Mode::shaded;
  Engine engine = Engine::packets;
  /// What packets are made for: one of PacketCaster::instruction_sets(); by default the best. The picture is the same.
  std::string instructions;
  /// The part of the picture that is made, and no other: bit for bit what it is in the whole. None: all of it. Costs
  /// what its pixels cost; adaptive samples look at the pixels around it, too.
  std::optional<PixelRegion> region{};
  int threads = 0;  ///< as of on_threads() (raycast/packets/threads.h); 0: those of the present arena
  ProgressCallback progress{};
};

/// Whether a picture in this mode averages several rays a pixel.
bool takes_samples(Mode mode);

/// Rays a pixel along each axis: the least k with k² of at least the samples; 1 in modes that take one ray.
int grid(const RenderOptions& options);

/// Throws what render() throws for sizes, samples and instructions.
void check(const RenderOptions& options);

/// What a scene was cut into before. A picture that has use for what is null makes it; the picture is the same.
struct KeptCells {
  const Cells* cells = nullptr;  ///< of the whole scene
  const LayerCells* layer_cells = nullptr;
};

/// Whether a picture in this mode asks the layers: of a scene that transmits, and has few enough of them.
bool asks_layers(const Scene& scene, const View& view, const RenderOptions& options);

/// A picture, the same bit for bit on any number of threads; of a region a film of its size. Throws Error(limit) for a
/// size or number of samples that is not positive or too large (65,536 pixels a side, 2^27 in all, 1,024 samples),
/// Error(bad_value) for a view that no camera has, Error(usage) for adaptive samples in a mode other than shaded,
/// instructions that the machine does not have, or a region that is empty or not within the picture; Cancelled. Adds to
/// *report if it is not null. Precondition: `kept` is of this scene.
Film render(const Scene& scene, const View& view, const RenderOptions& options, RenderReport* report = nullptr,
            const KeptCells& kept = {});

/// The tree of rays of one pixel's centre as indented text, a line for each ray: kind, weight, t and place of the hit,
/// what it brings. Pixel (0, 0) is the top left one; throws Error(usage) for one outside the picture, and for modes
/// other than shaded. Whatever the region.
std::string trace_pixel(const Scene& scene, const View& view, const RenderOptions& options, int x, int y);

}  // namespace csgcast
