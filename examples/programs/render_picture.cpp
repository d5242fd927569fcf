// SPDX-License-Identifier: MIT
// Builds a scene in code, renders it, writes the picture and tells what it cost.
#include <csg/solid/primitives.h>
#include <shade/picture/image_file.h>
#include <shade/trace/render.h>

#include <cstdio>

using namespace csgcast;

namespace {

Solid painted(Solid solid, const Material& material) { return with_look(std::move(solid), {material, {}}); }

}  // namespace

int main(int argc, char** argv) try {
  Material clay;
  clay.color = {0.6, 0.22, 0.1};
  Material chrome;
  chrome.color = {0.05, 0.05, 0.05};
  chrome.reflection = 0.8;
  Material ground;
  ground.color = {0.55, 0.55, 0.5};
  ground.specular = 0;

  const Solid bowl = sphere(2) - sphere(1.8) - transformed(box({5, 5, 5}), translation({-2.5, -2.5, 0.4}));
  SceneDescription description;
  description.solid = unite({painted(bowl, clay), painted(transformed(sphere(0.8), translation({0, 0, -1})), chrome),
                             painted(halfspace({0, 0, 1}, -2), ground)});
  description.camera.emplace();
  description.camera->eye = {5, -7, 5};
  description.camera->look_at = {0, 0, -0.9};
  description.lights.emplace_back().position = Point{-4, -6, 9};

  const Scene scene = compile(description.solid);
  RenderOptions options;
  options.width = 320;
  options.height = 240;
  options.samples = 4;
  RenderReport report;
  const Film film = render(scene, make_view(description, scene, 4.0 / 3), options, &report);
  write_image(film, argc > 1 ? argv[1] : "bowl.png");
  std::printf("%llu primary rays\n", static_cast<unsigned long long>(report.rays.primary));
} catch (const Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
