// SPDX-License-Identifier: MIT
#include "tests/bench/accuracy/povray.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/bench/accuracy/pov_text.h"

namespace csgcast::bench {
namespace {

constexpr std::size_t rounds = 50;

InnerFaces inner_faces(const Sample& sample) {
  Caster caster(*sample.scene);
  for (const Ray& ray : sample.rays) {
    if (caster.locate(ray.origin()) != Location::outside) return InnerFaces::seen;
  }
  return InnerFaces::hidden;
}

// The program that traces all rays of all scenes `Rounds` times, and in the first round writes the points, in units of
// about the scene, with the length of the normal, 0 for no hit; with Loop = 1 it does everything but trace.
constexpr std::string_view program = R"(
#for (Round, 1, Rounds)
  #for (I, 0, dimension_size(Origins, 1) - 1)
    #local Normal = <0, 0, 0>;
    #if (Loop)
      #local Hit = Origins[I] + Directions[I];
    #else
      #local Hit = trace(Thing, Origins[I], Directions[I], Normal);
    #end
    #if (Round = 1)
      #local Hit = Unit * Hit;
      #write (File, vlength(Normal), " ", str(Hit.x, 0, 30), " ", str(Hit.y, 0, 30), " ", str(Hit.z, 0, 30), "\n")
    #end
  #end
#end
#undef Thing
#undef Origins
#undef Directions
)";

// The power of two that brings the scene to about size 1, so that 30 digits after the point are enough of any hit.
int exponent_to_unit(const Sample& sample) { return -std::ilogb(sample.size); }

void write_scenes(std::span<const Sample> samples, const std::filesystem::path& folder) {
  std::ofstream file(folder / "scenes.pov");
  file << "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location 0 look_at z }\n";
  file << "#fopen File \"written.txt\" write\n";
  for (const Sample& sample : samples) {
    file << "#declare Thing = " << pov_object(sample.solid, inner_faces(sample)) << "\n";
    file << fmt::format("#declare Unit = {:.17g};\n", std::ldexp(1.0, exponent_to_unit(sample)));
    const auto write_array = [&](std::string_view name, const auto& vector_of) {
      file << fmt::format("#declare {} = array[{}] {{\n", name, sample.rays.size());
      for (const Ray& ray : sample.rays) {
        const auto v = vector_of(ray);
        file << pov_vector(v.x, v.y, v.z) << ",\n";
      }
      file << "};\n";
    };
    write_array("Origins", [](const Ray& ray) { return ray.origin(); });
    write_array("Directions", [](const Ray& ray) { return ray.direction(); });
    file << program;
  }
  file << "#fclose File\n";
}

// What the log says of the time to parse, which is when the program runs: "using 1 thread(s) with 0.038 CPU-seconds".
std::optional<double> seconds_in_log(const std::filesystem::path& log) {
  std::ifstream file(log);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const std::size_t parse_time = text.find("Parse Time:");
  constexpr std::string_view before = "with ";
  const std::size_t number = parse_time == std::string::npos ? parse_time : text.find(before, parse_time);
  if (number == std::string::npos) return std::nullopt;
  return std::strtod(text.c_str() + number + before.size(), nullptr);
}

// Seconds of processor time that the program ran; nothing if it fails.
std::optional<double> run(const std::filesystem::path& folder, std::string_view hits, bool only_loop) {
  const std::string command = fmt::format(
      "cd '{}' && povray +Iscenes.pov +W1 +H1 -F -D Declare=Rounds={} Declare=Loop={} >log.txt 2>&1 && "
      "mv written.txt {}",
      folder.string(), rounds, only_loop ? 1 : 0, hits);
  if (std::system(command.c_str()) != 0) return std::nullopt;  // NOLINT(cert-env33-c): a benchmark's own command
  return seconds_in_log(folder / "log.txt");
}

// Where on the ray a point is: its projection, in extended precision since the differences cancel.
double projected(const Ray& ray, const std::array<long double, 3>& point) {
  long double along = 0;
  long double square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const long double d = ray.direction()[axis];
    along += (point[axis] - ray.origin()[axis]) * d;
    square += d * d;
  }
  return static_cast<double>(along / square);
}

std::optional<FirstHits> read_hits(std::span<const Sample> samples, const std::filesystem::path& file_name) {
  FirstHits answer;
  std::ifstream file(file_name);
  for (const Sample& sample : samples) {
    for (const Ray& ray : sample.rays) {
      double normal_length = 0;
      std::array<long double, 3> point{};
      if (!(file >> normal_length >> point[0] >> point[1] >> point[2])) return std::nullopt;
      for (long double& coordinate : point) coordinate = std::ldexp(coordinate, -exponent_to_unit(sample));
      answer.t.push_back(normal_length > 0 ? std::optional(projected(ray, point)) : std::nullopt);
    }
  }
  return answer;
}

}  // namespace

std::optional<FirstHits> ask_povray(std::span<const Sample> samples, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_scenes(samples, folder);
  const std::optional<double> tracing = run(folder, "hits.txt", false);
  const std::optional<double> looping = run(folder, "loop.txt", true);
  if (!tracing || !looping) return std::nullopt;
  std::optional<FirstHits> answer = read_hits(samples, folder / "hits.txt");
  if (answer) answer->nanoseconds = (*tracing - *looping) / static_cast<double>(answer->t.size() * rounds) * 1e9;
  return answer;
}

}  // namespace csgcast::bench
