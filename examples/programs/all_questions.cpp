// SPDX-License-Identifier: MIT
// Reads a scene text, and asks one Model every kind of question.
#include <csg/text/statement/builder.h>
#include <csg/text/syntax/reader.h>
#include <measure/section_polylines.h>
#include <model/model.h>

#include <cstdio>
#include <vector>

using namespace csgcast;

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: all_questions SCENE.csg\n");
    return 2;
  }
  const Model model(text::build(text::read_file(argv[1])));
  const ModelCounts counts = model.counts();
  std::printf("%zu leaves, %zu surfaces, %zu parts\n", counts.leaves, counts.surfaces, counts.parts);

  const Measures whole = model.measure().whole;
  if (!whole.is_bounded) {
    std::printf("it may be unbounded: there is nothing to measure\n");
    return 0;
  }
  std::printf("volume %.4g, area %.4g\n", whole.volume.value, whole.area.value);
  const Point middle = whole.bounds.center();
  const std::vector<double> origin{middle.x, middle.y, whole.bounds.upper.z + 1}, down{0, 0, -1};
  std::printf("a ray down through the middle: %zu intervals\n", model.intervals({origin, down}).count());
  const Location location = model.locate(std::vector{middle.x, middle.y, middle.z})[0];
  std::printf("the middle is %s\n", location == Location::inside ? "inside" : "not inside");

  const Section cut = model.section({{0, 0, 1}, middle.z});
  std::printf("cut in the middle: area %.4g, %zu loops\n", cut.area.value, section_polylines(cut, 1e-3).size());
  if (const auto thinnest = model.thinnest(64))
    std::printf("a wall of %.4g at %s\n", thinnest->thickness, word(model.scene().leaf(thinnest->leaf).kind));
  const CheckReport report = model.check();
  std::printf("%zu overlaps, %zu statements without effect\n", report.overlaps.size(), report.redundant.size());

  RenderOptions options;
  options.width = 64;
  options.height = 48;
  const Film film = model.render(options);
  std::printf("a picture of %d x %d pixels\n", film.width(), film.height());
} catch (const Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
