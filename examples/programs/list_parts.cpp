// SPDX-License-Identifier: MIT
// Reads a scene text and lists its named parts with their densities and bounds.
#include <csg/text/statement/builder.h>
#include <csg/text/syntax/reader.h>
#include <raycast/scene/scene.h>

#include <cstdio>

using namespace csgcast;

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: list_parts SCENE.csg\n");
    return 2;
  }
  const SceneDescription description = text::build(text::read_file(argv[1]));
  for (const Warning& warning : description.warnings) std::fprintf(stderr, "%s\n", to_string(warning).c_str());
  const Scene scene = compile(description.solid);
  std::printf("%zu leaves, %zu surfaces\n", scene.leaves().size(), scene.surfaces().size());
  for (const Part& part : scene.parts()) {
    const Box& box = scene.node(part.node).box;
    std::printf("%-14s density %-6g [%.2f, %.2f] x [%.2f, %.2f] x [%.2f, %.2f]\n", part.name.name.c_str(),
                part.name.density, box.lower.x, box.upper.x, box.lower.y, box.upper.y, box.lower.z, box.upper.z);
  }
} catch (const Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
