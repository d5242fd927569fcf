// SPDX-License-Identifier: MIT
// Parts of a result that are made one by one and joined: byte for byte what one run makes.
#include <fmt/format.h>

#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

constexpr const char* scene = R"(part("ball") { sphere(2); }
part("a \"bar\", long") { translate([0.5, 0, 0]) { cube([6, 1, 1], center = true); } }
)";

struct Parts : TemporaryFolder {
  Parts() {
    write("scene.csg", scene);
    write("other.csg", "sphere(2);");
    std::string rays = "ox,oy,oz,dx,dy,dz\n";
    for (int i = 0; i < 57; ++i)
      rays += fmt::format("{},{},-9,{},0,1\n{}", 0.11 * i - 3, 0.07 * i - 2, 0.01 * i, i % 9 == 0 ? "\n" : "");
    write("rays.csv", rays);
  }

  std::string error(const std::vector<std::string>& arguments) const {
    const Outcome outcome = run(*this, arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    return outcome.err;
  }
  void check(const std::vector<std::string>& arguments) const {
    const Outcome outcome = run(*this, arguments);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
  }
  void tile(int index, int count, std::vector<std::string> more = {}, const std::string& of = "scene.csg") const {
    std::vector<std::string> arguments{"render",  of,
                                       "--size",  "60x41",
                                       "--tiles", fmt::format("{}/{}", index, count),
                                       "-o",      fmt::format("{}.csgtile", index)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    check(arguments);
  }
  void rows(const std::string& range, const std::string& name, const std::string& format = "csv",
            std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"intervals", "scene.csg", "--rays", "rays.csv", "--rows",
                                       range,       "--format",  format,   "-o",       name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    check(arguments);
  }
};

bool starts(const std::string& text, const std::string& start) {
  INFO(text);
  CHECK(text.substr(0, start.size()) == start);
  return text.substr(0, start.size()) == start;
}

TEST_CASE("tiles joined are byte for byte the picture of one run, in each mode and kind of file, and in any order") {
  const Parts folder;
  const std::vector<std::vector<std::string>> kinds{{},
                                                    {"--mode", "edges", "--samples", "4"},
                                                    {"--mode", "depth"},
                                                    {"--mode", "id"},
                                                    {"--mode", "xray"},
                                                    {"--mode", "normal"},
                                                    {"--samples", "9", "--adaptive"},
                                                    {"--camera", "9,9,9,0,0,0", "--part", "ball"}};
  for (const std::vector<std::string>& kind : kinds) {
    for (int i = 0; i < 3; ++i) folder.tile(i, 3, kind);
    for (const std::string name : {"png", "exr"}) {
      std::vector<std::string> whole{"render", "scene.csg", "--size", "60x41", "-o", "one." + name};
      whole.insert(whole.end(), kind.begin(), kind.end());
      folder.check(whole);
      folder.check({"join", "-o", "joined." + name, "2.csgtile", "0.csgtile", "1.csgtile"});
      CHECK((folder.read("one." + name) == folder.read("joined." + name)));
    }
  }
}

TEST_CASE("joining tiles tells which is missing, doubled, of another picture, or broken") {
  const Parts folder;
  for (int i = 0; i < 3; ++i) folder.tile(i, 3);
  const auto join = [&](std::vector<std::string> parts) {
    parts.insert(parts.begin(), {"join", "-o", "x.png"});
    return folder.error(parts);
  };
  CHECK(starts(join({"0.csgtile", "2.csgtile"}), "csgcast: error: tile 1/3 is missing"));
  CHECK(
      starts(join({"0.csgtile", "1.csgtile", "2.csgtile", "1.csgtile"}), "1.csgtile: error: tile 1/3 is given twice"));
  CHECK(starts(folder.error({"join", "0.csgtile", "1.csgtile", "2.csgtile"}), "csgcast: error: -o is needed"));
  CHECK(starts(folder.error({"join"}), "csgcast: error: PART is missing"));
  CHECK(starts(folder.error({"join", "-o", "0.csgtile", "0.csgtile"}), "csgcast: error: -o '0.csgtile' is the file"));
  const std::string good = folder.read("1.csgtile");
  folder.tile(1, 3, {"--samples", "4"});
  CHECK(join({"0.csgtile", "1.csgtile", "2.csgtile"}).find("another 'samples'") != std::string::npos);
  folder.tile(1, 3, {}, "other.csg");
  CHECK(join({"0.csgtile", "1.csgtile", "2.csgtile"}).find("another 'scene'") != std::string::npos);
  folder.tile(1, 2);
  CHECK(starts(join({"0.csgtile", "1.csgtile", "2.csgtile"}),
               "1.csgtile: error: this part and 0.csgtile are not of one"));
  for (const std::string& broken : {good.substr(0, good.size() - 1), good + "x", good.substr(0, 40)}) {
    folder.write("1.csgtile", broken);
    CHECK(starts(join({"0.csgtile", "1.csgtile", "2.csgtile"}), "1.csgtile: error: this is no whole tile"));
  }
  CHECK(starts(join({"scene.csg"}), "scene.csg: error: this is no part that can be joined"));
  CHECK(starts(join({"none.csgtile"}), "none.csgtile: error: cannot read this file"));
  CHECK(folder.names().size() == 6);  // the scenes, the rays and the tiles
}

TEST_CASE("tiles are numbered below their count, have a row at least, and are called .csgtile") {
  const Parts folder;
  const auto render = [&](const std::string& tiles, const std::string& name) {
    return folder.error({"render", "scene.csg", "--size", "60x41", "--tiles", tiles, "-o", name});
  };
  CHECK(starts(render("3/3", "a.csgtile"), "csgcast: error: tile 3/3 does not exist"));
  CHECK(starts(render("0/42", "a.csgtile"), "csgcast: error: tile 0/42 of a picture of 41 rows"));
  CHECK(starts(render("1", "a.csgtile"), "csgcast: error: --tiles: '1' has no '/'"));
  CHECK(starts(render("0/3", "a.png"), "a.png: error: not the name of a tile"));
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"--bits", "16"}, {"--alpha"}, {"--channels", "color,depth"}}) {
    std::vector<std::string> arguments{"render", "scene.csg", "--tiles", "0/3", "-o", "a.csgtile"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    CHECK(starts(folder.error(arguments), "csgcast: error: " + more[0] + " cannot be given beside --tiles"));
  }
}

TEST_CASE("rows joined are byte for byte the intervals of one run") {
  const Parts folder;
  for (const std::string format : {"csv", "json"}) {
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{}, {"--line"}, {"--by", "part", "--tmax", "9"}}) {
      std::vector<std::string> whole{"intervals", "scene.csg", "--rays", "rays.csv", "--format", format, "-o", "one"};
      whole.insert(whole.end(), more.begin(), more.end());
      folder.check(whole);
      folder.rows(":1", "a", format, more);
      folder.rows("1:20", "b", format, more);
      folder.rows("20:57", "c", format, more);
      folder.check({"join", "-o", "joined", "c", "a", "b"});
      CHECK((folder.read("one") == folder.read("joined")));
      folder.rows("0:", "a", format, more);
      CHECK((run(folder, {"join", "a"}).out == folder.read("one")));
      folder.rows(":57", "a", format, more);
      folder.rows("57:99", "b", format, more);
      CHECK(starts(folder.error({"join", "a", "a"}), "a: error: rows 0:57 given twice"));
      CHECK((run(folder, {"join", "a", "b"}).out == folder.read("one")));
    }
  }
}

TEST_CASE("rays keep the numbers that they have in the whole file") {
  const Parts folder;
  folder.rows("30:32", "part");
  const std::string part = folder.read("part");
  CHECK(part.find("\n30,") != std::string::npos);
  CHECK(part.find("\n31,") != std::string::npos);
  CHECK(part.find("\n0,") == std::string::npos);
  const Outcome table = run(folder, {"intervals", "scene.csg", "--rays", "rays.csv", "--rows", "30:31"});
  CHECK(starts(table.out, "ray 30 from "));
}

TEST_CASE("joining rows tells which are missing, doubled or of another result") {
  const Parts folder;
  folder.rows("0:10", "a");
  folder.rows("10:20", "b");
  folder.rows("20:", "c");
  CHECK(starts(folder.error({"join", "a", "c"}), "csgcast: error: rows 10:20 missing"));
  CHECK(starts(folder.error({"join", "a", "b"}), "csgcast: error: rows 20: missing"));
  CHECK(starts(folder.error({"join", "b", "c"}), "csgcast: error: rows 0:10 missing"));
  CHECK(starts(folder.error({"join", "a", "b", "b", "c"}), "b: error: rows 10:20 given twice"));
  folder.rows("9:20", "b");
  CHECK(starts(folder.error({"join", "a", "b", "c"}), "b: error: row 9 given twice"));
  folder.rows("10:20", "b", "csv", {"--line"});
  CHECK(folder.error({"join", "a", "b", "c"}).find("another 'tmin'") != std::string::npos);
  folder.rows("10:20", "b", "json");
  CHECK(folder.error({"join", "a", "b", "c"}).find("their formats differ") != std::string::npos);
  folder.check({"intervals", "scene.csg", "--rays", "rays.csv", "--format", "csv", "-o", "b"});
  CHECK(starts(folder.error({"join", "a", "b", "c"}), "b: error: this is no part that can be joined"));
}

TEST_CASE("ranges of rows are a:b, of a file, and begin within it") {
  const Parts folder;
  const auto refused = [&](const std::string& range) {
    return folder.error({"intervals", "scene.csg", "--rays", "rays.csv", "--rows", range});
  };
  CHECK(starts(refused("58:60"), "rays.csv: error: there are no rows from 58 on (the file has 57)"));
  CHECK(starts(refused("7"), "csgcast: error: --rows: '7' has no ':'"));
  CHECK(starts(refused("-1:7"), "csgcast: error: --rows: '-1:7' are no whole numbers"));
  CHECK(starts(refused("7:7"), "csgcast: error: --rows: '7:7' holds no row"));
  CHECK(starts(folder.error({"intervals", "scene.csg", "--ray", "0,0,9,0,0,-1", "--rows", "0:1"}),
               "csgcast: error: --rows needs --rays"));
}

}  // namespace
