// SPDX-License-Identifier: MIT
#include "model/section_image.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "csg/base/error.h"
#include "csg/base/length.h"
#include "measure/section_svg.h"
#include "raycast/ray/caster.h"

namespace csgcast {
namespace {

constexpr int most_pixels = 16384;
constexpr int lines_of_row = 4;
constexpr Rgb inside{0.11, 0.2, 0.31};
constexpr Rgb outside{1, 1, 1};

/// Adds what of each pixel of a row lies within [from, to], in pixels, times a weight.
void add_run(std::vector<double>& row, double from, double to, double weight) {
  from = std::fmax(from, 0);
  to = std::fmin(to, static_cast<double>(row.size()));
  for (auto x = static_cast<std::size_t>(from); x < row.size() && static_cast<double>(x) < to; ++x) {
    const double left = std::fmax(from, static_cast<double>(x));
    const double right = std::fmin(to, static_cast<double>(x) + 1);
    row[x] += weight * std::fmax(right - left, 0);
  }
}

}  // namespace

Film section_image(const Scene& scene, const Plane& plane, const Section& section, int pixels) {
  if (pixels < 1 || pixels > most_pixels) {
    throw Error(ErrorCode::limit, {}, fmt::format("a picture of {} pixels", pixels),
                fmt::format("1 to {} are possible along the longer side", most_pixels), "give a number in that range");
  }
  const PlaneRectangle seen = seen_rectangle(section);
  const double width = seen.greatest.u - seen.least.u;
  const double height = seen.greatest.v - seen.least.v;
  const double scale = pixels / std::fmax(width, height);
  Film film(std::max(1, static_cast<int>(std::lround(width * scale))),
            std::max(1, static_cast<int>(std::lround(height * scale))), FilmContent::color);
  // In the plane of a face the section is what is just beyond.
  const Vector unit = normalised(plane.normal);
  const Point origin = section.origin + 1e-12 * std::fmax(width, height) * unit;
  tbb::parallel_for(tbb::blocked_range<int>(0, film.height()), [&](const auto& rows) {
    Caster caster(scene);
    IntervalList list;
    for (int y = rows.begin(); y != rows.end(); ++y) {
      std::vector<double> row(static_cast<std::size_t>(film.width()));
      for (int line = 0; line < lines_of_row; ++line) {
        const double v = seen.greatest.v - (y + (line + 0.5) / lines_of_row) / scale;
        caster.begin(Ray(origin + seen.least.u * section.u + v * section.v, section.u));
        caster.intervals(list, Span::line());
        for (const Interval& interval : list)
          add_run(row, interval.entry.t * scale, interval.exit.t * scale, 1.0 / lines_of_row);
      }
      for (int x = 0; x < film.width(); ++x) {
        const double share = std::fmin(row[static_cast<std::size_t>(x)], 1);
        film.set(x, y, share * inside + (1 - share) * outside);
      }
    }
  });
  return film;
}

}  // namespace csgcast
