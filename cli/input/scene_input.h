// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/input/command.h"
#include "cli/output/progress_bar.h"
#include "csg/solid/scene_description.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/syntax.h"
#include "raycast/scene/scene.h"

namespace csgcast::cli {

/// What every command that reads a scene asks for.
struct SceneOptions {
  std::string path;
  text::Facets facets = text::Facets::automatic;
  Welding welding = Welding::derived();
  bool skips_unsupported = false;
  std::vector<std::string> parts;  ///< those that are all there is; none: the whole scene
  int threads = 0;                 ///< on_threads() of all that the command does; 0: a thread a core
  bool quiet = false;

  ProgressBar::Show progress() const { return quiet ? ProgressBar::Show::never : ProgressBar::Show::if_terminal; }
};

/// Adds the scene, --facets, --weld, --skip-unsupported, --part, --threads and --quiet. `options` must live as long as
/// `command`.
void add_scene_options(Command& command, SceneOptions& options);

/// What became of round solids: `3 round solids are polyhedra, as $fn says (--facets never keeps them round)`.
std::string faceted_line(std::uint64_t count);

/// A scene ready to be asked, and how long that took.
struct SceneInput {
  SceneDescription description;  ///< but for the solid, which became the scene
  Scene scene;
  double read_seconds = 0;  ///< reading the text and building solids from it
  double compile_seconds = 0;
};

/// A document and how long it took to read.
struct DocumentInput {
  text::Document document;
  double read_seconds = 0;
};

DocumentInput read_document(const SceneOptions& options);

/// Builds and compiles a document, and prints the warnings, and one if it is empty, to standard error unless it shall
/// be quiet. Of a large scene the text, the solids and the surfaces each take much memory: what was made of a thing
/// takes its place.
SceneInput compile_document(DocumentInput input, const SceneOptions& options);

/// Both at once.
SceneInput read_scene(const SceneOptions& options);

}  // namespace csgcast::cli
