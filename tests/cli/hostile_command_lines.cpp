// SPDX-License-Identifier: MIT
#include "tests/cli/hostile.h"

namespace csgcast::test {

std::vector<Hostile> hostile_command_lines() {
  const auto render = [](std::vector<std::string> more) {
    std::vector<std::string> all{"render", "scene.csg", "-o", "out.png"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const auto ray = [](const std::string& numbers) {
    return std::vector<std::string>{"intervals", "scene.csg", "-o", "out.png", "--ray", numbers};
  };
  const std::string cube = "cube(1);";
  RunOptions full_disk;
  full_disk.largest_file = 20;
  return {
      {"a picture without pixels", cube, 2, "csgcast: error: --size: '0' is out of range", render({"--size", "0x0"})},
      {"a picture of a million by a million", cube, 2, "csgcast: error: --size: '1000000' is out of range",
       render({"--size", "1000000x1000000"})},
      {"a picture beyond all memory", cube, 2, "csgcast: error: ", render({"--size", "65536x65536"})},
      {"a size beyond int", cube, 2, "csgcast: error: --size: '99999999999999999999' is out of range",
       render({"--size", "99999999999999999999x1"})},
      {"a size that is no size", cube, 2, "csgcast: error: --size: 'big' has no 'x'", render({"--size", "big"})},
      {"no samples", cube, 2, "csgcast: error: --samples: '0' is out of range", render({"--samples", "0"})},
      {"no threads", cube, 2, "csgcast: error: --threads: '0' is out of range", render({"--threads", "0"})},
      {"a camera at NaN", cube, 2, "csgcast: error: --camera: 'nan' is not finite",
       render({"--camera", "nan,0,0,1,1,1"})},
      {"a camera of three numbers", cube, 2, "csgcast: error: ", render({"--camera", "1,2,3"})},
      {"a camera at what it looks at", cube, 2, "csgcast: error: ", render({"--camera", "1,2,3,1,2,3"})},
      {"a pixel outside", cube, 2, "csgcast: error: --trace-pixel 800,0 is outside",
       render({"--trace-pixel", "800,0"})},
      {"the rays of a pixel that shows depth", cube, 2, "csgcast: error: --trace-pixel needs --mode shaded",
       render({"--trace-pixel", "1,1", "--mode", "depth"})},
      {"an unknown mode", cube, 2, "csgcast: error: --mode 'foo' is unknown", render({"--mode", "foo"})},
      {"a ray of NaN", cube, 2, "csgcast: error: --ray: 'nan' is not finite", ray("0,0,nan,0,0,1")},
      {"a ray without direction", cube, 2, "csgcast: error: --ray: the direction is zero", ray("0,0,9,0,0,0")},
      {"a ray beyond double", cube, 2, "csgcast: error: --ray: '1e400' is beyond", ray("0,0,1e400,0,0,1")},
      {"a ray at the edge of double", cube, 2, "csgcast: error: --ray: the ray is out of range",
       ray("1e308,1e308,1e308,-1e308,-1e308,-1e308")},
      {"a ray at the least of double", cube, 2, "csgcast: error: --ray: the ray is out of range",
       ray("0.5,0.5,9,0,0,-5e-324")},
      {"a scene that is not there", cube, 2, "nope.csg: error: cannot read this file", {"info", "nope.csg"}},
      {"a scene that is a folder", cube, 2, ".: error: cannot read this file", {"info", "."}},
      {"a picture of no kind",
       cube,
       2,
       "x.stl: error: not a known kind of picture",
       {"render", "scene.csg", "-o", "x.stl"}},
      {"a picture in no folder",
       cube,
       2,
       "no/out.png: error: cannot write",
       {"render", "scene.csg", "-o", "no/out.png"}},
      {"intervals into a folder",
       cube,
       2,
       ".: error: cannot write this file",
       {"intervals", "scene.csg", "--ray", "0,0,9,0,0,-1", "-o", "."}},
      {"intervals on a full device",
       cube,
       1,
       "/dev/full: error: cannot write this file",
       {"intervals", "scene.csg", "--ray", "0,0,9,0,0,-1", "-o", "/dev/full"}},
      {"a picture on a full disk", cube, 1, "out.png: error: ", render({"--size", "64x64"}), full_disk},
      {"intervals on a full disk", cube, 1, "out.png: error: cannot write this file", ray("0.5,0.5,9,0,0,-1"),
       full_disk},
      {"what it knows on a full disk",
       cube,
       1,
       "out.png: error: cannot write this file",
       {"info", "scene.csg", "-o", "out.png"},
       full_disk},
  };
}

}  // namespace csgcast::test
