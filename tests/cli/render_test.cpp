// SPDX-License-Identifier: MIT
#include <unistd.h>

#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

constexpr const char* scene = R"(camera(eye = [0, 0, 9], look_at = [0, 0, 0], up = [0, 1, 0], height = 4);
light(direction = [0, 0, -1]);
cube(2, center = true);
)";

struct SceneFolder : TemporaryFolder {
  explicit SceneFolder(std::string_view text = scene) { write("scene.csg", text); }
};

/// The number after `"key": `; -1 if there is none.
double member(const std::string& json, const std::string& key) {
  const std::size_t at = json.find('"' + key + "\": ");
  return at == std::string::npos ? -1 : std::stod(json.substr(at + key.size() + 4));
}

/// Width and height as a PNG file's head says.
std::pair<int, int> png_size(const std::string& png) {
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value * 256 + static_cast<unsigned char>(png[i]);
    return value;
  };
  return png.size() < 24 ? std::pair(0, 0) : std::pair(number(16), number(20));
}

TEST_CASE("render writes each kind of picture that its ending asks for") {
  using namespace std::string_literals;
  const SceneFolder folder;
  const auto head = [&](const std::string& name, std::size_t length) {
    const Outcome outcome = run(folder, {"render", "scene.csg", "-o", name, "--size", "40x30"});
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.empty());
    return folder.read(name).substr(0, length);
  };
  CHECK(head("a.png", 8) == "\x89PNG\r\n\x1a\n"s);
  CHECK(head("a.jpg", 3) == "\xff\xd8\xff"s);
  CHECK(head("a.JPEG", 3) == "\xff\xd8\xff"s);
  CHECK(head("a.exr", 4) == "\x76\x2f\x31\x01"s);
  CHECK(head("a.tif", 4) == "II*\0"s);
  CHECK(png_size(folder.read("a.png")) == std::pair(40, 30));
}

TEST_CASE("a picture is 800x600 unless --size says otherwise, and the same on any number of threads") {
  const SceneFolder folder;
  run(folder, {"render", "scene.csg", "-o", "one.png", "--threads", "1"});
  run(folder, {"render", "scene.csg", "-o", "three.png", "--threads", "3"});
  CHECK(png_size(folder.read("one.png")) == std::pair(800, 600));
  CHECK((folder.read("one.png") == folder.read("three.png")));
}

TEST_CASE("the option --stats counts rays by kind and times each stage") {
  const SceneFolder folder;
  const Outcome outcome = run(folder, {"render", "scene.csg", "-o", "a.png", "--size", "40x40", "--samples", "4",
                                       "--stats", "a.json", "--threads", "1"});
  CHECK(outcome.exit_code == 0);
  const std::string stats = folder.read("a.json");
  CHECK(member(stats, "width") == 40);
  CHECK(member(stats, "height") == 40);
  CHECK(member(stats, "threads") == 1);
  CHECK(member(stats, "primary") + member(stats, "primary_beyond_bounds") == 4 * 40 * 40);
  CHECK(member(stats, "primary_beyond_bounds") > 0);
  CHECK(member(stats, "shadow") == 0);
  CHECK(member(stats, "shadow_leading_away") == 4 * 20 * 20);  // the cube fills the middle quarter
  CHECK(member(stats, "reflection") == 0);
  CHECK(member(stats, "transmission") == 0);
  CHECK(member(stats, "surface_tests") > 0);
  for (const char* key :
       {"box_tests", "leaf_tests", "exact_calls", "depth_limit", "read", "compile", "trace", "write"}) {
    INFO(key);
    CHECK(member(stats, key) >= 0);
  }
}

TEST_CASE(
    "the option --adaptive takes all samples only where pixels do not look alike, and --stats counts the others") {
  const SceneFolder folder;
  std::vector<std::string> regular{"render", "scene.csg", "-o", "a.png", "--size", "60x60", "--samples", "16"};
  CHECK(run(folder, regular).exit_code == 0);
  std::vector<std::string> adaptive = regular;
  adaptive[3] = "b.png";
  adaptive.insert(adaptive.end(), {"--adaptive", "--stats", "b.json"});
  CHECK(run(folder, adaptive).exit_code == 0);
  CHECK((folder.read("a.png") == folder.read("b.png")));
  const std::string stats = folder.read("b.json");
  CHECK(member(stats, "refined_pixels") > 0);
  CHECK(member(stats, "refined_pixels") < 8 * 32);  // the cube is 30 pixels wide: two pixels along each side
  CHECK(member(stats, "primary") + member(stats, "primary_beyond_bounds") + member(stats, "primary_like_neighbours") ==
        16 * 60 * 60 + member(stats, "refined_pixels"));
}

TEST_CASE("the option --adaptive needs light to compare, and samples to leave out") {
  const SceneFolder folder;
  const auto refused = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render", "scene.csg", "-o", "a.png", "--adaptive"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(folder, arguments);
    CHECK(outcome.exit_code == 2);
    return outcome.err;
  };
  CHECK(refused({"--samples", "4", "--mode", "edges"}) ==
        "csgcast: error: --adaptive needs --mode shaded (pixels are compared by their light); see csgcast render "
        "--help\n");
  CHECK(
      refused({}) ==
      "csgcast: error: --adaptive needs --samples of more than 1 (it takes fewer where pixels look alike); see csgcast "
      "render --help\n");
  CHECK(folder.names() == std::vector<std::string>{"scene.csg"});
}

TEST_CASE("each mode makes a picture of its own") {
  const SceneFolder folder;
  std::vector<std::string> pictures;
  for (const std::string mode : {"shaded", "edges", "xray", "depth", "normal", "id"}) {
    const Outcome outcome = run(
        folder, {"render", "scene.csg", "-o", "a.png", "--size", "40x30", "--camera", "5,-7,6,0,0,0", "--mode", mode});
    CHECK(outcome.exit_code == 0);
    for (const std::string& other : pictures) CHECK((folder.read("a.png") != other));
    pictures.push_back(folder.read("a.png"));
  }
}

TEST_CASE("the option --camera replaces the scene's camera, in either of OpenSCAD's forms") {
  const SceneFolder folder;
  const auto picture = [&](const std::string& camera) {
    std::vector<std::string> arguments{"render", "scene.csg", "-o", "a.png", "--size", "40x30"};
    if (!camera.empty()) arguments.insert(arguments.end(), {"--camera", camera});
    CHECK(run(folder, arguments).exit_code == 0);
    return folder.read("a.png");
  };
  const std::string own = picture("");
  const std::string six = picture("0,-9,0,0,0,0");
  CHECK((six != own));
  CHECK((picture("0,0,0,90,0,0,9") != own));
}

TEST_CASE("the option --facets changes the picture of a solid with $fn") {
  const SceneFolder folder("sphere(r = 1, $fn = 20);");
  const auto picture = [&](const std::string& facets) {
    run(folder, {"render", "scene.csg", "-o", "a.png", "--size", "40x30", "--facets", facets});
    return folder.read("a.png");
  };
  CHECK((picture("auto") == picture("never")));
  CHECK((picture("auto") != picture("always")));
}

TEST_CASE("the option --trace-pixel prints the rays of one pixel, with a picture or without") {
  const SceneFolder folder;
  const std::vector<std::string> pixel{"render", "scene.csg", "--size", "40x30", "--trace-pixel", "20,15"};
  const Outcome alone = run(folder, pixel);
  CHECK(alone.exit_code == 0);
  CHECK(alone.out.substr(0, 12) == "pixel 20,15:");
  CHECK(alone.out.find("primary") != std::string::npos);
  CHECK(alone.out.find(" on surface ") != std::string::npos);
  std::vector<std::string> both = pixel;
  both.insert(both.end(), {"-o", "a.png"});
  CHECK(run(folder, both).out == alone.out);
  CHECK(png_size(folder.read("a.png")) == std::pair(40, 30));
}

TEST_CASE("render needs somewhere to write to, and statistics a picture") {
  const SceneFolder folder;
  const Outcome nothing = run(folder, {"render", "scene.csg"});
  CHECK(nothing.exit_code == 2);
  CHECK(nothing.err == "csgcast: error: -o is needed (where shall the picture go?); see csgcast render --help\n");
  const Outcome stats = run(folder, {"render", "scene.csg", "--trace-pixel", "1,1", "--stats", "a.json"});
  CHECK(stats.exit_code == 2);
  CHECK(stats.err ==
        "csgcast: error: --stats needs -o (there is no picture to count rays of); see csgcast render --help\n");
}

TEST_CASE("what is wrong with the output is found before the scene is read") {
  const SceneFolder folder("this is no scene");
  CHECK(run(folder, {"render", "scene.csg", "-o", "a.stl"}).err ==
        "a.stl: error: not a known kind of picture (its name ends in .stl); known endings are .png, .jpg, .jpeg, .tif, "
        ".tiff, .exr, .hdr, .webp, .bmp, .tga, .ppm, .pgm, .gif, .jp2, .dpx, .sgi, .iff, .ico\n");
  CHECK(
      run(folder, {"render", "scene.csg", "-o", "no/a.png"}).err ==
      "no/a.png: error: cannot write this file (No such file or directory); choose a path in a folder that exists and "
      "may be written\n");
  CHECK(run(folder, {"render", "scene.csg", "-o", "a.png", "--stats", "no/a.json"}).exit_code == 2);
  CHECK(folder.names() == std::vector<std::string>{"scene.csg"});
}

TEST_CASE("a background image is found from the scene's folder, and one that cannot be read is an error at its place") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("scenes"));
  folder.write("sky.csg", "background(color = [0.25, 0.5, 0.75]);\ntranslate([-9, 0, 0]) sphere(1);\n");
  REQUIRE(run(folder, {"render", "sky.csg", "-o", "scenes/sky.exr", "--size", "8x4", "--camera", "0,0,0,1,0,0"})
              .exit_code == 0);
  folder.write("scenes/a.csg", "background(image = \"sky.exr\");\ncube(1);\n");
  std::filesystem::create_directory(folder.path("plain"));
  folder.write("plain/a.csg", "background(color = [0.25, 0.5, 0.75]);\ncube(1);\n");
  const std::vector<std::string> more{"--size", "24x16", "-o", "out.png"};
  const auto picture = [&](const std::string& file) {
    std::vector<std::string> arguments{"render", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(folder, arguments);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    return folder.read("out.png");
  };
  CHECK((picture("scenes/a.csg") == picture("plain/a.csg")));
  CHECK(run(folder, {"info", "scenes/a.csg"}).out.find("background  image scenes/sky.exr") != std::string::npos);
  folder.write("scenes/c.csg", "cube(1);\n  background(image = \"no.exr\");\n");
  const Outcome outcome = run(folder, {"render", "scenes/c.csg", "-o", "c.png"});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.err.find("scenes/c.csg:2:3: error: the background image 'scenes/no.exr' cannot be read (") == 0);
  folder.write("d.csg", "background(color = \"red\", image = \"no.exr\");\ncube(1);\n");
  CHECK(run(folder, {"info", "d.csg"}).exit_code == 2);
}

TEST_CASE("channels, transparency and bits are for the pictures that hold them") {
  const SceneFolder folder;
  const auto refused = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"render", "scene.csg", "--size", "8x8"});
    const Outcome outcome = run(folder, more);
    CHECK(outcome.exit_code == 2);
    return outcome.err;
  };
  CHECK(refused({"-o", "a.png", "--channels", "depth"}).find("--channels needs -o with an .exr") != std::string::npos);
  CHECK(refused({"-o", "a.exr", "--channels", "depth,deep"}).find("'deep' is unknown") != std::string::npos);
  CHECK(refused({"-o", "a.exr", "--channels", "depth,depth"}).find("more than once") != std::string::npos);
  CHECK(refused({"-o", "a.exr", "--channels", "alpha"}).find("alpha needs color") != std::string::npos);
  CHECK(refused({"-o", "a.exr", "--channels", "depth", "--samples", "4"}).find("have no effect") != std::string::npos);
  CHECK(refused({"-o", "a.jpg", "--bits", "16"}).find(".jpg files hold 8") != std::string::npos);
  CHECK(refused({"-o", "a.png", "--alpha", "--mode", "id"}).find("alpha needs --mode shaded") != std::string::npos);
  CHECK(refused({"-o", "a.jpg", "--alpha"}).find("has no transparency") != std::string::npos);
  for (const char* name : {"a.hdr", "a.gif", "a.iff"})
    CHECK(refused({"-o", name, "--mode", "depth"}).find("has no single channel") != std::string::npos);
  CHECK(refused({"-o", "a.hdr", "--mode", "id"}).find("has no single channel") != std::string::npos);
  CHECK(folder.names() == std::vector<std::string>{"scene.csg"});
}

TEST_CASE("only pictures of other kinds than plain .png need the module for pictures") {
  const SceneFolder folder;
  RunOptions bare;
  bare.program = "/usr/bin/env";
  const auto without_module = [&](const std::string& picture) {
    return run(folder,
               {"CSGCAST_MODULES=/nowhere", CSGCAST_PROGRAM, "render", "scene.csg", "--size", "8x8", "-o", picture},
               bare);
  };
  CHECK(without_module("a.png").exit_code == 0);
  const Outcome outcome = without_module("a.exr");
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.err.find("a.exr: error: this kind of picture needs a module that cannot be loaded (") == 0);
  CHECK(outcome.err.find("write a .png, or install csgcast with OpenImageIO") != std::string::npos);
  folder.write("sky.csg", "cube(1);\n  background(image = \"sky.hdr\");\n");
  const Outcome sky = run(
      folder, {"CSGCAST_MODULES=/nowhere", CSGCAST_PROGRAM, "render", "sky.csg", "--size", "8x8", "-o", "b.png"}, bare);
  CHECK(sky.exit_code == 2);
  CHECK(sky.err.find("sky.csg:2:3: error: this kind of picture needs a module that cannot be loaded (") == 0);
  CHECK(sky.err.find("give a background color, or install csgcast with OpenImageIO") != std::string::npos);
}

TEST_CASE("the memory for all channels is asked for before the scene is read") {
  const SceneFolder folder("this is no scene");
  const double machine = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  if (machine >= 256 * 0x1p30) return;  // a larger picture cannot be asked for
  const auto said = [&](const std::string& names) {
    return run(folder, {"render", "scene.csg", "--size", "65536x65536", "-o", "a.exr", "--channels", names}).err;
  };
  CHECK(said("color,depth,normal,position,id,part,leaf").find("needs 416 GB of memory") != std::string::npos);
  CHECK(said("color,alpha,depth").find("needs 256 GB of memory") != std::string::npos);
}

}  // namespace
