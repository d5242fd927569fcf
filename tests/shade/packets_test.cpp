// SPDX-License-Identifier: MIT
#include <array>
#include <string_view>

#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "raycast/packets/layer_caster.h"
#include "raycast/packets/packet_caster.h"
#include "shade/trace/render.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/examples.h"

using namespace csgcast;

namespace {

Film picture(const SceneDescription& description, const Scene& scene, Engine engine, int samples, int threads,
             RenderReport* report = nullptr) {
  RenderOptions options;
  options.width = 121;
  options.height = 83;
  options.samples = samples;
  options.engine = engine;
  options.threads = threads;
  return render(scene, make_view(description, scene, 121.0 / 83), options, report);
}

// Makes the picture of a scene's text with both engines and compares them; what they report: packets, then one by one.
std::array<RenderReport, 2> compare_engines(const std::string& text) {
  const SceneDescription description = text::build(text::read(text, "scene.csg"));
  const Scene scene = compile(description.solid, Welding::derived());
  std::array<RenderReport, 2> reports;
  const Film expected = picture(description, scene, Engine::scalar, 1, 1, &reports[1]);
  CHECK(picture(description, scene, Engine::packets, 1, 2, &reports[0]).values() == expected.values());
  CHECK(reports[0].rays.reflection == reports[1].rays.reflection);
  return reports;
}

}  // namespace

TEST_CASE("packets make the same picture as rays one by one, bit for bit, on any number of threads") {
  for (const std::string& name : test::example_names()) {
    INFO(name);
    const SceneDescription description = test::example(name);
    const Scene scene = compile(description.solid, Welding::derived());
    for (const int threads : {1, 2, 8}) {
      if (test::is_sanitized && threads != 8) continue;
      const int samples = threads == 2 ? 9 : 1;
      RenderReport one_by_one;
      const Film expected = picture(description, scene, Engine::scalar, samples, 1, &one_by_one);
      RenderReport report;
      CHECK(picture(description, scene, Engine::packets, samples, threads, &report).values() == expected.values());
      CHECK(report.rays.primary + report.skipped.primary_beyond_bounds == one_by_one.rays.primary);
      CHECK(report.rays.shadow == one_by_one.rays.shadow);
      CHECK(report.rays.reflection == one_by_one.rays.reflection);
      CHECK(report.skipped.shadow_facing_away == one_by_one.skipped.shadow_facing_away);
      CHECK(report.skipped.shadow_without_effect == one_by_one.skipped.shadow_without_effect);
      CHECK(report.skipped.shadow_leading_away == one_by_one.skipped.shadow_leading_away);
      CHECK(report.skipped.reflection_leading_away == one_by_one.skipped.reflection_leading_away);
    }
  }
}

TEST_CASE("pictures of every kind are the same bit for bit by packets of every instruction set and by single rays") {
  const int width = test::is_sanitized ? 21 : 73, height = test::is_sanitized ? 17 : 58;
  for (const std::string& name : test::example_names()) {
    const SceneDescription description = test::example(name);
    const Scene scene = compile(description.solid, Welding::derived());
    const View view = make_view(description, scene, 1.0 * width / height);
    for (const Mode mode : {Mode::shaded, Mode::edges, Mode::xray, Mode::depth, Mode::normal, Mode::id}) {
      RenderOptions options;
      options.width = width;
      options.height = height;
      options.mode = mode;
      options.samples = mode == Mode::edges ? 4 : 1;
      options.threads = 2;
      options.engine = Engine::scalar;
      RenderReport one_by_one;
      const Film expected = render(scene, view, options, &one_by_one);
      options.engine = Engine::packets;
      const std::vector<std::string_view> sets = PacketCaster::instruction_sets();
      for (std::size_t i = 0; i < sets.size(); ++i) {
        // Each mode by each set is for the release build; sanitizers see each mode and each set.
        if (test::is_sanitized && mode != Mode::shaded && i != static_cast<std::size_t>(mode) % sets.size()) continue;
        const std::string_view instructions = sets[i];
        INFO(name << " mode " << static_cast<int>(mode) << ' ' << instructions);
        options.instructions = instructions;
        RenderReport report;
        CHECK(render(scene, view, options, &report).values() == expected.values());
        CHECK(report.rays.primary + report.skipped.primary_beyond_bounds == one_by_one.rays.primary);
        CHECK((mode == Mode::shaded || report.packets.rays == report.rays.primary));
      }
    }
  }
}

TEST_CASE("a picture is not made for instructions that no machine has") {
  const SceneDescription description = test::example("die");
  const Scene scene = compile(description.solid);
  RenderOptions options;
  options.instructions = "AVX-1024";
  CHECK_THROWS_AS(render(scene, make_view(description, scene, 4.0 / 3), options), Error);
}

TEST_CASE("mirrors, cuts and eyes inside solids look the same in packets, at any depth of reflection") {
  const std::string room = R"(
    light(position = [0.3, -0.4, 1.5]);
    light(direction = [1, 1, -1], intensity = 0.3);
    rotate(a = 30, v = [1, 2, 3]) {
      material(color = [0.9, 0.8, 0.7], reflection = 0.8) {
        difference() {
          cube(size = 4, center = true);
          cube(size = 3, center = true);
          material(color = [0.2, 0.4, 0.9], reflection = 0.5) { cylinder(h = 9, r = 0.4, center = true); }
        }
      }
      material(color = [0.4, 0.9, 0.3], reflection = 0.9) {
        intersection() { sphere(r = 0.9); translate([0, 0, 0.2]) { difference() { cube(size = 2); sphere(r = 0.5); } } }
      }
    }
  )";
  for (const char* view : {"camera(eye = [1.1, -1, 0.2], look_at = [0, 0, 0.3], fov = 80);",
                           "camera(eye = [9, -6, 5], look_at = [0, 0, 0], fov = 40);",
                           "camera(eye = [0.35, 0.3, 0.7], look_at = [0, -1, 0], fov = 90);"}) {
    for (const char* depth : {"1", "2", "40"}) {
      INFO(view << " depth " << depth);
      if (test::is_sanitized && std::string_view(depth) != "2") continue;
      const std::string text =
          std::string(view) + "settings(max_depth = " + depth + ", min_contribution = 0.001);" + room;
      const auto [report, one_by_one] = compare_engines(text);
      CHECK(report.skipped.reflection_below_cutoff == one_by_one.skipped.reflection_below_cutoff);
      CHECK(report.skipped.reflection_leading_away == one_by_one.skipped.reflection_leading_away);
      CHECK(report.skipped.depth_limit == one_by_one.skipped.depth_limit);
    }
  }
}

TEST_CASE("light through glass that touches, overlaps, is cut and looks uneven is the same with and without cells") {
  const std::string glass =
      "material(color = [0, 0, 0.1], specular = 0.5, reflection = 0.1, transmission = 0.9, ior = 1.5, "
      "absorption = [0.1, 0.3, 0.2]) ";
  const std::string water =
      "material(color = [0, 0.1, 0], reflection = 0.05, transmission = 0.95, ior = 1.33, "
      "absorption = [0.3, 0.1, 0.1]) ";
  const std::string stone = "material(color = [0.8, 0.7, 0.6], reflection = 0.2) ";
  const std::vector<std::string> solids{
      // side by side, of one medium and of two
      glass + "{ cube(size = 1); } " + glass + "{ translate([1, 0, 0]) { cube(size = 1); } } " + water +
          "{ translate([0, 1, 0]) { cube(size = 1); } }",
      // one in the other, and an opaque thing in both
      water + "{ sphere(r = 1.2); } " + glass + "{ cube(size = 1.4, center = true); } " + stone +
          "{ cylinder(h = 3, r = 0.3, center = true); }",
      stone + "{ cylinder(h = 3, r = 0.3, center = true); } " + glass + "{ sphere(r = 1.2); } " + water +
          "{ cube(size = [1, 1, 1], center = true); }",
      // cut by something with a look of its own, and by the neighbour's shape
      glass + "{ difference() { sphere(r = 1.2); " + water + "{ cube(size = 1); } cylinder(h = 3, r = 0.4); } } " +
          water + "{ intersection() { sphere(r = 1.2); cube(size = 1); } }",
      // looks that change within a solid
      glass + "{ union() { sphere(r = 0.9); " + water + "{ translate([0.8, 0, 0]) { sphere(r = 0.8); } } } } " + stone +
          "{ halfspace(n = [0, 0, 1], d = -0.5); }",
      // a light on a face, where something opaque goes on
      glass + "{ translate([2, -3, 3]) { cube(size = 2); } sphere(r = 1); } " + stone +
          "{ translate([2, -3, 4.5]) { cube(size = 2); } }",
      // half of space is water
      water + "{ halfspace(n = [0, 0, 1], d = 0.1); } " + stone + "{ sphere(r = 0.7); } " + glass +
          "{ translate([1, 0, 0]) { sphere(r = 0.5); } }",
  };
  const std::array<const char*, 2> views{"camera(eye = [3, -4, 2.5], look_at = [0.2, 0.2, 0], fov = 35);",
                                         "camera(eye = [0.3, 0.2, 0.15], look_at = [0, 1, 0.2], fov = 90);"};
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t j = 0; j < views.size(); ++j) {
      if (test::is_sanitized && j != i % 2) continue;
      const std::string& solid = solids[i];
      const char* view = views[j];
      INFO(view << solid);
      const std::string text = std::string(view) + "light(position = [3, -2, 5]); light(direction = [0.3, 0.5, -1]);" +
                               "settings(max_depth = 6, min_contribution = 0.001);" + solid;
      REQUIRE(LayerCells::suits(compile(text::build(text::read(text, "glass.csg")).solid, Welding::derived())));
      const auto [report, one_by_one] = compare_engines(text);
      CHECK(report.rays.shadow == one_by_one.rays.shadow);
      CHECK(report.rays.transmission == one_by_one.rays.transmission);
      CHECK(report.total_reflections == one_by_one.total_reflections);
      CHECK(report.packets.rays > 0);
    }
  }
}
