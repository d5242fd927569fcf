// SPDX-License-Identifier: MIT
#include "model/model.h"

#include <tbb/parallel_for.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "csg/base/error.h"
#include "csg/solid/primitives.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "measure/section_json.h"
#include "measure/section_svg.h"
#include "model/section_file.h"
#include "model/section_image.h"
#include "raycast/packets/threads.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

SceneDescription description_of(const std::string& text) { return text::build(text::read(text, "a.csg")); }

SceneDescription glass_and_steel() {
  return description_of(
      "camera(eye = [5, -7, 4], look_at = [0, 0, 0]);\nlight(position = [3, -9, 9]);\n"
      "part(\"glass\") { material(transmission = 0.8, ior = 1.5) { sphere(1, $fn = 99); } }\n"
      "part(\"steel\", density = 8) { material(reflection = 0.5) { translate([2, 1, 0]) { cube(1); } } }");
}

SceneDescription opaque() { return description_of("difference() { cube(2, center = true); sphere(1.2, $fn = 99); }"); }

RenderOptions small(Mode mode = Mode::shaded) {
  RenderOptions options;
  options.width = 90;
  options.height = 60;
  options.mode = mode;
  return options;
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("A model answers rays, points and measures as the functions of the other modules do") {
  const Model model(glass_and_steel());
  const RayQueries queries(model.scene().leaves().empty() ? Solid() : glass_and_steel().solid);
  const std::vector<double> origins{-5, 0, 0, 2.5, 1.5, 9}, directions{1, 0, 0, 0, 0, -1};
  const Rays rays{origins, directions};
  CHECK(model.intervals(rays).t == queries.intervals(rays).t);
  CHECK(model.intervals(rays).t == std::vector<double>{4, 6, 8, 9});
  CHECK(model.first_hits(rays).t == queries.first_hits(rays).t);
  CHECK(model.any_hits(rays) == std::vector<std::uint8_t>{1, 1});
  CHECK(model.locate(origins) == queries.locate(origins));
  CHECK(model.measure().whole.volume.value == measure(model.scene()).whole.volume.value);
  CHECK(model.measure().parts.at(1).mass.value == Approx(8));
  CHECK(model.section({{0, 0, 1}, 0.5}).area.value == section(model.scene(), {{0, 0, 1}, 0.5}).area.value);
  CHECK_FALSE(model.check().is_empty);
  CHECK(model.thinnest(30)->thickness == find_thinnest(model.cells(), 30)->thickness);
  CHECK_THROWS_AS(model.thinnest(0), Error);
  CHECK_THROWS_AS(model.thinnest(16385), Error);
}

TEST_CASE("A model tells its names, counts and bounds") {
  const Model model(glass_and_steel());
  CHECK(model.part_names() == std::vector<std::string>{"glass", "steel"});
  CHECK(model.leaf_name(LeafId(0)) == "sphere at a.csg:3:59");
  CHECK(Model(sphere(1)).leaf_name(LeafId(0)) == "sphere");
  CHECK_THROWS_AS(model.leaf_name(LeafId(2)), Error);
  CHECK_THROWS_AS(model.leaf_name(LeafId()), Error);
  CHECK(model.counts().leaves == 2);
  CHECK(model.counts().surfaces == 7);
  CHECK(model.counts().parts == 2);
  CHECK(model.counts().cells == model.cells().counts().cells);
  CHECK(model.counts().bytes > 0);
  CHECK(model.bounds().lower.x == Approx(-1));
  CHECK(Model(Solid()).bounds().is_null());
}

TEST_CASE("A model's pictures are those that make their own cells, bit for bit, in every mode and again") {
  for (const SceneDescription& description : {glass_and_steel(), opaque()}) {
    const Model model(description);
    for (const Mode mode : {Mode::shaded, Mode::edges, Mode::xray, Mode::depth, Mode::normal, Mode::id}) {
      const RenderOptions options = small(mode);
      const Film own = csgcast::render(model.scene(), make_view(description, model.scene(), 1.5), options);
      RenderReport report;
      CHECK((model.render(options, &report).values() == own.values()));
      CHECK((model.render(options).values() == own.values()));
    }
    RenderOptions scalar = small();
    scalar.engine = Engine::scalar;
    CHECK((model.render(scalar).values() == model.render(small()).values()));
  }
}

TEST_CASE("Many threads may ask one model for pictures at once, and none makes the layers twice") {
  const Model model(glass_and_steel());
  const Film one = Model(glass_and_steel()).render(small());
  std::vector<Film> films(8, Film(1, 1, FilmContent::color));
  on_threads(8, [&] {
    tbb::parallel_for(std::size_t{0}, films.size(), [&](std::size_t i) { films[i] = model.render(small()); });
  });
  for (const Film& film : films) CHECK((film.values() == one.values()));
}

TEST_CASE("A picture may have another camera, other lights, another background and other settings") {
  const Model model(glass_and_steel());
  const RenderOptions options = small();
  const auto values_with = [&](const ViewChange& change) {
    return model.render(model.view(1.5, change), options).values();
  };
  const std::vector<float> plain = values_with({});
  CHECK((plain == model.render(options).values()));
  CHECK((values_with({.camera = CameraDescription{{9, 0, 0}, {0, 0, 0}}}) != plain));
  CHECK((values_with({.background = Rgb{1, 0, 0}}) != plain));
  CHECK((values_with({.settings = RenderSettings{0, 0}}) != plain));
  LightDescription light;
  light.direction = Vector{0, 0, -1};
  CHECK((values_with({.lights = std::vector{light}}) != plain));
  const std::vector<float> dark = values_with({.lights = std::vector<LightDescription>{}});
  CHECK((dark != plain));
  light.intensity = 0;
  CHECK((values_with({.lights = std::vector{light}}) == dark));
  // A description that says the same gives the same picture.
  SceneDescription said = glass_and_steel();
  said.background = Rgb{1, 0, 0};
  CHECK((Model(said).render(options).values() == values_with({.background = Rgb{1, 0, 0}})));

  light.intensity = -1;
  CHECK_THROWS_AS(model.view(1, {.lights = std::vector{light}}), Error);
  light.intensity = 1;
  light.position = Point{};
  CHECK_THROWS_AS(model.view(1, {.lights = std::vector{light}}), Error);
  CHECK_THROWS_AS(model.view(1, {.background = Rgb{-1, 0, 0}}), Error);
  CHECK_THROWS_AS(model.view(1, {.background = Rgb{std::numeric_limits<double>::infinity(), 0, 0}}), Error);
  CHECK_THROWS_AS(model.view(1, {.settings = RenderSettings{-1, 0}}), Error);
  CHECK_THROWS_AS(model.view(1, {.settings = RenderSettings{1, 2}}), Error);
}

TEST_CASE("A section is written as a drawing, as numbers or as a picture, by its ending") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "csgcast_section_files";
  std::filesystem::create_directories(folder);
  const Model model(opaque());
  const Plane plane{{0, 0, 1}, 0.9};
  const Section cut = model.section(plane);
  write_section(model.scene(), plane, cut, folder / "a.svg");
  CHECK(content_of(folder / "a.svg") == section_svg(cut, unseen_tolerance(cut)));
  write_section(model.scene(), plane, cut, folder / "a.json");
  CHECK(content_of(folder / "a.json") == section_json(cut));
  write_section(model.scene(), plane, cut, folder / "a.png", 40);
  CHECK(content_of(folder / "a.png").starts_with("\x89PNG"));
  CHECK(section_image(model.scene(), plane, cut, 40).width() == 40);
  CHECK_THROWS_AS(write_section(model.scene(), plane, cut, folder / "a.dxf"), Error);
  CHECK_THROWS_AS(write_section(model.scene(), plane, cut, folder / "a.png", 0), Error);
  const Model half(halfspace({0, 0, 1}, 0));
  const Section unbounded = half.section({{1, 0, 0}, 0});
  for (const char* name : {"b.svg", "b.png"})
    CHECK_THROWS_AS(write_section(half.scene(), {{1, 0, 0}, 0}, unbounded, folder / name), Error);
  std::filesystem::remove_all(folder);
}
TEST_CASE("the thickness where rays enter is that of walls, and nothing where they miss") {
  const Model model(box({2, 3, 4}) - transformed(box({1, 3, 4}), translation({0.5, 0, 0})));
  const std::vector<double> origins{-1, 1, 1, -1, 1, 1, 0.25, 1, -9, 9, 9, 9};
  const std::vector<double> directions{1, 0, 0, 1, 0, 0.01, 0, 0, 1, 1, 0, 0};
  const std::vector<double> found = model.thickness({origins, directions});
  CHECK(found == std::vector<double>{0.5, 0.5, 4, 0});
  const std::vector<double> zero{0, 0, 0};
  CHECK_THROWS_AS(model.thickness({zero, zero}), Error);
  CHECK_THROWS_AS(model.thickness({origins, zero}), Error);
}
