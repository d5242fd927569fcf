// SPDX-License-Identifier: MIT
#include <sstream>

#include "tests/cli/program.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast::test;

// A cube of side 2 about the origin with a hole of radius 0.5 along z, and a ball of radius 1 above it.
constexpr const char* scene = R"(part("body, steel", density = 7.8) {
  difference() {
    cube(size = 2, center = true);
    cylinder(h = 4, r = 0.5, center = true);
  }
}
part("ball") { translate([0, 0, 5]) { sphere(r = 1); } }
)";

const std::string columns =
    "ray,t_entry,t_exit,entry_nx,entry_ny,entry_nz,exit_nx,exit_ny,exit_nz,entry_solid,exit_solid,part\n";

Outcome intervals(const TemporaryFolder& folder, std::vector<std::string> arguments, const RunOptions& options = {}) {
  arguments.insert(arguments.begin(), {"intervals", "scene.csg"});
  return run(folder, arguments, options);
}

struct SceneFolder : TemporaryFolder {
  explicit SceneFolder(std::string_view text = scene) { write("scene.csg", text); }
};

TEST_CASE("intervals as CSV: a cut face's normal is turned round, solids are named by their place") {
  const SceneFolder folder;
  const Outcome outcome = intervals(folder, {"--ray", "-3,0,0,1,0,0", "--format", "csv"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out == columns +
                           "0,2,2.5,-1,0,0,1,0,0,3:5,4:5,\"body, steel\"\n"
                           "0,3.5,4,-1,0,0,1,0,0,4:5,3:5,\"body, steel\"\n");
}

TEST_CASE("an interval cut off by t = 0 has no entry normal and no entry solid") {
  const SceneFolder folder;
  CHECK(intervals(folder, {"--ray", "0,0,5,0,0,2", "--format", "csv"}).out ==
        columns + "0,0,0.5,,,,0,0,1,,7:39,ball\n");
}

TEST_CASE("the option --line asks for the whole line, --tmin and --tmax for a piece of it") {
  const SceneFolder folder;
  const auto csv = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--ray", "0,0,5,0,0,1", "--format", "csv"});
    return intervals(folder, arguments).out;
  };
  CHECK(csv({"--line"}) == columns + "0,-1,1,0,0,-1,0,0,1,7:39,7:39,ball\n");
  CHECK(csv({"--tmin", "-.5", "--tmax", "0.25"}) == columns + "0,-0.5,0.25,,,,,,,,,ball\n");
  CHECK(csv({"--tmin", "-inf", "--tmax", "0"}) == columns + "0,-1,0,0,0,-1,,,,7:39,,ball\n");
  CHECK(csv({"--tmin", "1"}) == columns);
}

TEST_CASE("unbounded ends are -inf and inf in CSV, null and unbounded in JSON") {
  const SceneFolder folder("complement() { sphere(r = 1); }");
  CHECK(intervals(folder, {"--ray", "0,0,0,0,0,1", "--line", "--format", "csv"}).out ==
        columns + "0,-inf,-1,,,,0,0,1,,1:16,\n0,1,inf,0,0,-1,,,,1:16,,\n");
  CHECK(intervals(folder, {"--ray", "0,0,0,0,0,1", "--format", "json"}).out ==
        R"({"rays": [
{"ray": 0, "origin": [0, 0, 0], "direction": [0, 0, 1], "intervals": [{"t_entry": 1, "t_exit": null, "unbounded": true, )"
        R"("entry_normal": [0, 0, -1], "exit_normal": null, "entry_solid": "1:16", "exit_solid": null, "part": null}]}
]}
)");
}

TEST_CASE("intervals as a table: length, obliquity in degrees, kind and place of the solids") {
  const SceneFolder folder;
  folder.write("rays.csv", "0.75,-9,0,0,2,0\n9,9,9,0,0,1\n");
  CHECK(intervals(folder, {"--rays", "rays.csv"}).out ==
        "ray 0 from 0.75,-9,0 along 0,2,0\n"
        "  t_entry  t_exit  length  entry_obliquity  exit_obliquity  entry_solid  exit_solid  part\n"
        "        4       5       2             0.00            0.00  cube 3:5     cube 3:5    body, steel\n"
        "\n"
        "ray 1 from 9,9,9 along 0,0,1: nothing\n");
}

TEST_CASE("by part: touching parts keep their own lists, the scene's list joins them") {
  const SceneFolder folder(
      "part(\"a\") { cube(1); }\npart(\"b\") { translate([1, 0, 0]) { cube(1); } }\ntranslate([2, 0, 0]) { cube(1); }");
  const std::vector<std::string> ray{"--ray", "-1,0.5,0.5,1,0,0", "--format", "csv"};
  CHECK(intervals(folder, ray).out == columns + "0,1,4,-1,0,0,1,0,0,1:13,3:24,a\n");
  std::vector<std::string> by_part = ray;
  by_part.insert(by_part.end(), {"--by", "part"});
  CHECK(intervals(folder, by_part).out == columns + "0,1,2,-1,0,0,1,0,0,1:13,1:13,a\n0,2,3,-1,0,0,1,0,0,2:36,2:36,b\n");
}

TEST_CASE("where a ray is in two parts at once, table and JSON tell it, and parts that touch do not overlap") {
  const SceneFolder folder(
      "part(\"a\") { cube(2); }\npart(\"b\") { translate([1, 0, 0]) { cube(2); } }\n"
      "part(\"c\") { translate([3, 0, 0]) { cube(2); } }");
  const Outcome table = intervals(folder, {"--ray", "-1,1,1,2,0,0"});
  CHECK(table.exit_code == 0);
  CHECK(table.out ==
        "ray 0 from -1,1,1 along 2,0,0\n"
        "  t_entry  t_exit  length  entry_obliquity  exit_obliquity  entry_solid  exit_solid  part\n"
        "      0.5       3       5             0.00            0.00  cube 1:13    cube 3:36   a\n"
        "  t_entry  t_exit  length  overlap of  with\n"
        "        1     1.5       1  a           b\n");
  for (const char* by : {"scene", "part"}) {
    const std::string json =
        intervals(folder, {"--ray", "-1,1,1,2,0,0", "--tmax", "1.25", "--format", "json", "--by", by}).out;
    CHECK(json.find("\"overlaps\": [{\"parts\": [\"a\", \"b\"], \"t_entry\": 1, \"t_exit\": 1.25}], "
                    "\"overlap_count\": 1}") != std::string::npos);
  }
}

TEST_CASE("of more overlaps than a ray can show the rest is counted") {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "part(\"p" + std::to_string(i) + "\") { cube(2); }\n";
  const SceneFolder folder(text);
  const std::string out = intervals(folder, {"--ray", "-1,1,1,2,0,0"}).out;
  CHECK(out.find("  and 3950 more overlaps\n") != std::string::npos);
}

TEST_CASE("the part of an interval that is cut off at its start is the one that holds the start") {
  const SceneFolder folder(
      "part(\"a\") { cube(1); }\npart(\"b\") { translate([1, 0, 0]) { cube(1); } }\ntranslate([2, 0, 0]) { cube(1); }");
  const auto part = [&](const std::string& from, const std::string& direction) {
    const std::string out =
        intervals(folder, {"--ray", from + ",0.5,0.5," + direction + ",0,0", "--format", "csv"}).out;
    return out.substr(out.rfind(',') + 1);
  };
  CHECK(part("0.5", "1") == "a\n");
  CHECK(part("1.5", "1") == "b\n");
  CHECK(part("1.5", "-1") == "b\n");
  CHECK(part("1", "1") == "b\n");  // between both: the one that the ray runs into
  CHECK(part("1", "-1") == "a\n");
  CHECK(part("2.5", "1") == "\n");
  CHECK(part("2.5", "-1") == "\n");
}

TEST_CASE("the part of an interval without a start is the one that the ray comes out of infinity in") {
  const SceneFolder folder("part(\"a\") { halfspace([1, 0, 0], 0); }\npart(\"b\") { halfspace([-1, 0, 0], 0); }");
  const auto part = [&](const std::string& direction) {
    const std::string out =
        intervals(folder, {"--ray", "5,0,0," + direction + ",0,0", "--line", "--format", "csv"}).out;
    return out.substr(out.rfind(',') + 1);
  };
  CHECK(part("1") == "a\n");
  CHECK(part("-1") == "b\n");
}

TEST_CASE("by part, a scene without parts is an error that says what to do") {
  const SceneFolder folder("cube(1);");
  const Outcome outcome = intervals(folder, {"--ray", "0,0,9,0,0,-1", "--by", "part"});
  CHECK(outcome.exit_code == 2);
  CHECK(
      outcome.err ==
      "scene.csg: error: the scene has no parts (--by part lists nothing else); name some with part(\"name\") { .. }, "
      "or leave --by out\n");
  CHECK(outcome.out.empty());
}

TEST_CASE("numbers read back to the same double") {
  const SceneFolder folder("cube(0.1);");
  CHECK(intervals(folder, {"--ray", "0,0.05,0.05,3,0,0", "--format", "csv"}).out ==
        columns + "0,0,0.03333333333333333,-1,0,0,1,0,0,1:1,1:1,\n");
  static_assert(0.03333333333333333 == 0.1 / 3);
}

TEST_CASE("a file of rays may have a header, blanks, blank lines, CR LF and a byte order mark") {
  const SceneFolder folder("cube(1);");
  folder.write("rays.csv", "\xef\xbb\xbfOX, oy,oz,dx,dy,dz\r\n\r\n .5 ,+.5,9,0,0,-1\r\n\n5e-1,0.5,-1,0,0,1");
  CHECK(intervals(folder, {"--rays", "rays.csv", "--format", "csv"}).out ==
        columns + "0,8,9,0,0,1,0,0,-1,1:1,1:1,\n1,1,2,0,0,-1,0,0,1,1:1,1:1,\n");
}

TEST_CASE("a file of rays may be as other programs write it") {
  const SceneFolder folder("cube(1);");
  const std::string wanted = columns + "0,8,9,0,0,1,0,0,-1,1:1,1:1,\n1,1,2,0,0,-1,0,0,1,1:1,1:1,\n";
  const std::vector<std::string> texts{"# rays\nox;oy;oz;dx;dy;dz\n0,5;0,5;9;0;0;-1\n # one more\n0.5;5e-1;-1;0;0;1\n",
                                       "0.5\t0.5\t9\t0\t0\t-1\n0.5\t0.5\t-1\t0\t0\t1\n",
                                       "\"dx\",\"dy\",\"dz\",\"name, of all\",\"OX\",\"oy\",\"oz\"\n0,0,-1,\"a, "
                                       "b\",\".5\", \" 0.5 \",9\n0,0,1,,0.5,0.5,-1\n"};
  for (const std::string& text : texts) {
    INFO(text);
    folder.write("rays.csv", text);
    CHECK(intervals(folder, {"--rays", "rays.csv", "--format", "csv"}).out == wanted);
  }
  folder.write("rays.csv", "u,v,w,x,y,z,ox\n0,0,-1,.5,.5,9,no\n0,0,1,.5,.5,-1,no\n");
  CHECK(intervals(folder, {"--rays", "rays.csv", "--format", "csv", "--columns", "x,y,z,u,v,w"}).out == wanted);
  CHECK(intervals(folder, {"--rays", "rays.csv", "--columns", "x,y,z"}).err ==
        "csgcast: error: --columns takes 6 names, separated by commas; see csgcast intervals --help\n");
  CHECK(intervals(folder, {"--ray", "0,0,9,0,0,-1", "--columns", "x,y,z,u,v,w"}).err ==
        "csgcast: error: --columns needs --rays (it names columns of a file); see csgcast intervals --help\n");
  folder.write("rays.csv", "0.5,0.5,9,0,0,-1\n");
  CHECK(intervals(folder, {"--rays", "rays.csv", "--columns", "x,y,z,u,v,w"}).err.find("there is no header") !=
        std::string::npos);
}

TEST_CASE("rays may come from standard input, or the scene, but not both") {
  const SceneFolder folder("cube(1);");
  const std::string row = "0.5,0.5,9,0,0,-1\n";
  const std::string answer = columns + "0,8,9,0,0,1,0,0,-1,1:1,1:1,\n";
  RunOptions options;
  options.input = row;
  CHECK(intervals(folder, {"--rays", "-", "--format", "csv"}, options).out == answer);
  options.input = "cube(1);";
  CHECK(run(folder, {"intervals", "-", "--ray", "0.5,0.5,9,0,0,-1", "--format", "csv"}, options).out == answer);
  const Outcome both = run(folder, {"intervals", "-", "--rays", "-"}, options);
  CHECK(both.exit_code == 2);
  CHECK(both.err ==
        "csgcast: error: the scene and --rays cannot both come from standard input; see csgcast intervals --help\n");
}

TEST_CASE("many rays keep their order on any number of threads") {
  const SceneFolder folder("cube([100000, 1, 1]);");
  std::string rays;
  std::string expected = columns;
  for (int i = 0; i < 20000; ++i) {
    rays += std::to_string(i) + ".5,-" + std::to_string(i + 1) + ",0.5,0,1,0\n";
    const std::string index = std::to_string(i);
    expected += index + "," + std::to_string(i + 1) + "," + std::to_string(i + 2) + ",0,-1,0,0,1,0,1:1,1:1,\n";
  }
  folder.write("rays.csv", rays);
  for (const char* threads : {"1", "2", "7"}) {
    INFO(threads << " threads");
    const Outcome outcome = intervals(folder, {"--rays", "rays.csv", "--format", "csv", "--threads", threads});
    CHECK(outcome.exit_code == 0);
    CHECK((outcome.out == expected));
  }
}

TEST_CASE("a long file of rays, which cells answer, has the same intervals as the same rays one by one") {
  const SceneFolder folder;
  const std::vector<std::string> starts{"-3,0.1,0.2,1,0.01,0", "0,0,5,0.1,0.2,1",  "-3,0,0,1,0,0", "0,0,-9,0,0,2",
                                        "0.7,0.2,0.1,3,1,-2",  "-4,-3,6,4,3.5,-1", "9,9,9,1,1,1",  "1,1,-3,0,0,1"};
  std::string many;
  for (int i = 0; i < 40; ++i)
    for (const std::string& start : starts) many += start + std::string(20, ' ') + "\n";
  folder.write("rays.csv", many);
  for (const std::vector<std::string>& span :
       {std::vector<std::string>{}, {"--line"}, {"--tmax", "2.25"}, {"--tmin", "-inf", "--tmax", "2.25"}}) {
    std::string expected = columns;
    std::vector<std::string> lists;
    for (const std::string& start : starts) {
      std::vector<std::string> arguments{"--ray", start, "--format", "csv"};
      arguments.insert(arguments.end(), span.begin(), span.end());
      lists.push_back(intervals(folder, arguments).out.substr(columns.size()));
    }
    for (std::size_t i = 0; i < 40 * starts.size(); ++i) {
      std::istringstream lines(lists[i % starts.size()]);
      for (std::string line; std::getline(lines, line);)
        expected += std::to_string(i) + line.substr(line.find(',')) + "\n";
    }
    std::vector<std::string> arguments{"--rays", "rays.csv", "--format", "csv"};
    arguments.insert(arguments.end(), span.begin(), span.end());
    CHECK(intervals(folder, arguments).out == expected);
  }
}

TEST_CASE("where to look must be said once, and make sense") {
  const SceneFolder folder("cube(1);");
  const std::string hint = "; see csgcast intervals --help\n";
  const auto error = [&](const std::vector<std::string>& arguments) {
    const Outcome outcome = intervals(folder, arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    return outcome.err;
  };
  CHECK(error({}) == "csgcast: error: exactly one of --ray and --rays is needed" + hint);
  CHECK(error({"--ray", "0,0,9,0,0,-1", "--rays", "x"}) ==
        "csgcast: error: exactly one of --ray and --rays is needed" + hint);
  CHECK(error({"--ray", "1,2,3"}) == "csgcast: error: --ray needs 6 numbers separated by commas, not 3" + hint);
  CHECK(error({"--ray", "0,0,9,0,0,-1", "--line", "--tmin", "1"}) ==
        "csgcast: error: --tmin cannot be given beside --line" + hint);
  CHECK(error({"--ray", "0,0,9,0,0,-1", "--tmin", "3", "--tmax", "3"}) ==
        "csgcast: error: no ray is left between t = 3 and t = 3" + hint);
  CHECK(error({"--ray", "0,0,9,0,0,-1", "--tmin", "nan"}) ==
        "csgcast: error: --tmin: 'nan' is no place on a ray" + hint);
  CHECK(error({"--ray", "0,0,9,0,0,-1", "--format", "xml"}) ==
        "csgcast: error: --format 'xml' is unknown (known are table|csv|json)" + hint);
}

}  // namespace
