// SPDX-License-Identifier: MIT
#include "tests/cli/hostile.h"

namespace csgcast::test {

using namespace std::string_literals;

std::vector<Hostile> hostile_rows() {
  const std::vector<std::string> points{"locate", "scene.csg", "--points", "rows.csv", "-o", "out.png"};
  return {
      {"no rays", "", 0, ""},
      {"a header and no rays", "ox,oy,oz,dx,dy,dz\n", 0, ""},
      {"blank lines", "\n  \n\r\n0,0,9,0,0,-1", 0, ""},
      {"a direction of zero", "0,0,9,0,0,-1\n0,0,9,0,0,0\n", 2, "2:7: error: the direction is zero"},
      {"NaN in a ray", "0,0,nan,0,0,-1\n", 2, "1:5: error: 'nan' is not finite"},
      {"NaN at the start of the first ray", "nan,0,0,0,0,-1\n", 2, "1:1: error: 'nan' is not finite"},
      {"infinity in a ray", "0,0,9,0,0,-1\n0,0,-inf,0,0,-1\n", 2, "2:5: error: '-inf' is not finite"},
      {"a number beyond double in a ray", "0,0,1e400,0,0,-1\n", 2, "1:5: error: '1e400' is too large"},
      {"a word in a ray", "ox,oy,oz,dx,dy,dz\n0,0, up,0,0,-1\n", 2, "2:6: error: 'up' is no number"},
      {"an empty field in a ray", "0,0,,0,0,-1\n", 2, "1:5: error: a number is missing"},
      {"five numbers in a ray", "0,0,9,0,0\n", 2, "1:10: error: this line has too few numbers"},
      {"seven numbers in a ray", "0,0,9,0,0,-1,5\n", 2, "1:14: error: this line has too many numbers"},
      {"a header that names a column twice", "ox,oy,oz,dx,dy,dz,ox\n0,0,9,0,0,-1,1\n", 2,
       "1:19: error: the header names a column 'ox' twice"},
      {"a header without a column", "ox,oy,oz\n", 2, "1:1: error: the header names no column 'dx'"},
      {"a quote that is never closed", "0,0,\"9,0,0,-1\n", 2, "1:5: error: '\"9' is no number"},
      {"a row that is longer than its header", "ox,oy,oz,dx,dy,dz,id\n0,0,9,0,0,-1,5,6\n", 2,
       "2:16: error: this line has too many numbers"},
      {"a row that is shorter than its header", "ox,oy,oz,dx,dy,dz,id\n0,0,9,0,0,-1\n", 2,
       "2:13: error: this line has too few numbers"},
      {"rays that are bytes", "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s, 2, "1:1: error: '?PNG' is no number"},
      {"a line of ten million bytes", repeated("0", 10'000'000), 2, "1:1: error: this line is longer than 4096 bytes"},
      {"a point with four numbers", "1,2,3,4\n", 2, "1:7: error: this line has too many numbers", points},
      {"a point that is not finite", "x,y,z\n1,2,inf\n", 2, "2:5: error: 'inf' is not finite", points},
  };
}

}  // namespace csgcast::test
