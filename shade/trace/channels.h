// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "csg/base/progress.h"
#include "raycast/scene/scene.h"
#include "shade/film/film.h"
#include "shade/film/view.h"
#include "shade/trace/render.h"

namespace csgcast {

/// What a channel of a picture tells of the first boundary on the ray through a pixel's centre.
enum class Channel : std::uint8_t {
  depth,     ///< its distance, as Mode::depth; infinite where there is nothing
  normal,    ///< the unit normal, towards the viewer; zero where there is nothing
  position,  ///< the place in the scene; not a number where there is nothing
  id,        ///< the number of the surface, the same for faces that coincide; -1 where there is nothing
  part,      ///< the number of the part, counted from 0; -1 outside of all
  leaf,      ///< the number of the leaf, as Mode::id; -1 where there is nothing
};

/// The names of a channel's numbers in a file: `Z`; `N.X`, `N.Y`, `N.Z`; `P.X`, ..; `id`, `part`, `leaf`.
std::vector<std::string> names_in_file(Channel channel);

/// A film for each of the channels, certified like Mode::depth, Mode::normal and Mode::id. Of the options width,
/// height, engine, instructions, threads and progress count. Throws as render() does. Precondition: `kept` is of this
/// scene.
std::vector<Film> channel_films(const Scene& scene, const View& view, const RenderOptions& options,
                                std::span<const Channel> channels, const KeptCells& kept = {});

/// A shaded picture with alpha: the share of a pixel's rays that meet the solid. The background that the other rays see
/// is taken out; reflected and transmitted rays see it as ever. Colours are multiplied by alpha. Throws as render()
/// does, and Error(usage) for other modes and adaptive samples. Precondition: `kept` is of this scene.
Film render_with_alpha(const Scene& scene, const View& view, const RenderOptions& options,
                       RenderReport* report = nullptr, const KeptCells& kept = {});

}  // namespace csgcast
