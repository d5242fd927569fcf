// SPDX-License-Identifier: MIT
#include "raycast/packet_caster.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "csg/error.h"
#include "raycast/detail/lanes.h"
#include "raycast/interval_list.h"

namespace csgcast {
namespace {

// Bounds the memory, and is many packets.
constexpr std::size_t rays_at_once = 256;

const detail::LaneCode& code_named(std::string_view instructions) {
  const auto codes = detail::lane_codes();
  if (instructions.empty()) return codes.front();
  const auto named =
      std::find_if(codes.begin(), codes.end(), [&](const detail::LaneCode& code) { return code.name == instructions; });
  if (named != codes.end()) return *named;
  throw Error(ErrorCode::usage, {}, "no instruction set is called " + std::string(instructions),
              "this machine has others", "ask PacketCaster::instruction_sets()");
}

Ray ray_at(const RayArrays& rays, std::size_t i) {
  return {{rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]},
          {rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]}};
}

void begin(Caster& caster, const RayArrays& rays, std::size_t i) {
  std::optional<Departure> departure;
  if (rays.departure != nullptr) {
    const Sense side = rays.departs_positive[i] != 0 ? Sense::positive : Sense::negative;
    departure = Departure{SurfaceId(rays.departure[i]), side};
  }
  caster.begin(ray_at(rays, i), departure);
}

Span span_of(const RayArrays& rays, std::size_t i) {
  Span span = rays.whole_line ? Span::line() : Span();
  if (rays.end != nullptr) span.to = rays.end[i];
  return span;
}

void set_face(const FaceArrays& faces, std::size_t i, const Hit& hit, const Attribution& face) {
  faces.state[i] = hit.passage == Passage::entry ? FaceArrays::entry : FaceArrays::exit;
  faces.t[i] = hit.crossing.t;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    faces.point[axis][i] = face.point[axis];
    faces.normal[axis][i] = face.normal[axis];
  }
  faces.surface[i] = hit.crossing.surface.index();
  faces.look[i] = face.look.index();
  faces.comes_positive[i] = face.front == Sense::positive ? 1 : 0;
  if (faces.leaf != nullptr) faces.leaf[i] = face.leaf.index();
}

}  // namespace

PacketCounts& PacketCounts::operator+=(const PacketCounts& other) {
  rays += other.rays;
  packets += other.packets;
  nodes += other.nodes;
  cells += other.cells;
  surface_tests += other.surface_tests;
  flagged += other.flagged;
  return *this;
}

struct PacketCaster::State {
  State(const Cells& c, Width w, std::string_view instructions)
      : cells(c),
        code(w == Width::packet ? code_named(instructions).packet : code_named(instructions).single),
        caster(c.scene()) {}

  void load(std::span<const Ray> rays) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Point o = rays[i].origin();
      const Vector d = rays[i].direction();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        origin[axis][i] = o[axis];
        direction[axis][i] = d[axis];
      }
    }
    lane_rays.count = rays.size();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lane_rays.origin[axis] = origin[axis].data();
      lane_rays.direction[axis] = direction[axis].data();
    }
  }

  // The intervals of a ray from the ends that lanes found; to round t the caster must be at the ray.
  void append_known(std::size_t ray, Span span, Rounding rounding, std::vector<Interval>& intervals) {
    bool inside = lists.starts_inside[ray];
    Crossing entry{span.from, {}, 0};
    for (std::size_t k = lists.offsets[ray]; k < lists.offsets[ray + 1]; ++k) {
      const detail::LaneLists::End& end = lists.ends[k];
      Crossing at{end.t, SurfaceId(cells.data().slots[end.slot].surface), end.root};
      if (rounding == Rounding::nearest) at = caster.reported(at);
      if (inside) {
        intervals.push_back({entry, at});
      } else {
        entry = at;
      }
      inside = !inside;
    }
    if (inside) intervals.push_back({entry, {span.to, {}, 1}});
  }

  const Cells& cells;
  const detail::LaneFunctions& code;
  Caster caster;
  RayArrays lane_rays;
  PacketCounts counts;
  detail::LaneLists lists;
  std::array<std::array<double, rays_at_once>, 3> origin;
  std::array<std::array<double, rays_at_once>, 3> direction;
  std::array<std::uint8_t, rays_at_once> found;
  std::array<double, rays_at_once> t;
  std::array<std::uint32_t, rays_at_once> surface;
  std::array<std::uint8_t, rays_at_once> comes_positive;
  std::array<std::uint8_t, rays_at_once> root;
  std::vector<std::uint32_t> left;  // the rays that lanes could not decide
  IntervalList list;
};

PacketCaster::PacketCaster(const Cells& cells, Width width, std::string_view instructions)
    : state_(std::make_unique<State>(cells, width, instructions)) {}
PacketCaster::~PacketCaster() = default;
PacketCaster::PacketCaster(PacketCaster&&) noexcept = default;

std::vector<std::string_view> PacketCaster::instruction_sets() {
  std::vector<std::string_view> names;
  for (const detail::LaneCode& code : detail::lane_codes()) names.push_back(code.name);
  return names;
}

const Scene& PacketCaster::scene() const { return state_->cells.scene(); }

void PacketCaster::first_hits(std::span<const Ray> rays, std::span<std::optional<Hit>> hits, Rounding rounding) {
  State& state = *state_;
  detail::LaneHits lanes;
  lanes.faces.state = state.found.data();
  lanes.faces.t = state.t.data();
  lanes.faces.surface = state.surface.data();
  lanes.faces.comes_positive = state.comes_positive.data();
  lanes.root = state.root.data();
  lanes.left = &state.left;
  for (std::size_t begin = 0; begin < rays.size(); begin += rays_at_once) {
    const auto packet = rays.subspan(begin, std::min(rays_at_once, rays.size() - begin));
    state.load(packet);
    state.left.clear();
    state.code.first_hits(scene(), state.cells.data(), state.lane_rays, lanes, state.counts);
    for (std::size_t i = 0; i < packet.size(); ++i) {
      std::optional<Hit>& hit = hits[begin + i];
      hit.reset();
      if (state.found[i] == FaceArrays::none) continue;
      const Passage passage = state.found[i] == FaceArrays::entry ? Passage::entry : Passage::exit;
      hit = Hit{{state.t[i], SurfaceId(state.surface[i]), state.root[i]}, passage};
      if (rounding == Rounding::close) continue;
      state.caster.begin(packet[i]);
      hit->crossing = state.caster.reported(hit->crossing);
    }
    for (const std::uint32_t i : state.left) {
      state.caster.begin(packet[i]);
      hits[begin + i] = state.caster.first_hit(state.cells.node(), {}, rounding);
    }
  }
}

void PacketCaster::any_hits(std::span<const Ray> rays, std::span<std::uint8_t> hits) {
  for (std::size_t begin = 0; begin < rays.size(); begin += rays_at_once) {
    state_->load(rays.subspan(begin, std::min(rays_at_once, rays.size() - begin)));
    any_hits(state_->lane_rays, hits.data() + begin);
  }
}

void PacketCaster::intervals(std::span<const Ray> rays, IntervalBatch& batch, Span span, Rounding rounding) {
  State& state = *state_;
  batch.intervals.clear();
  batch.offsets.assign(1, 0);
  batch.offsets.reserve(rays.size() + 1);
  batch.left_to_caster.clear();
  const bool fits_lanes = (span.from == 0 || span.from == line_start().t) && span.to > span.from;
  std::array<double, rays_at_once> end;
  end.fill(span.to);
  for (std::size_t begin = 0; begin < rays.size(); begin += rays_at_once) {
    const auto packet = rays.subspan(begin, std::min(rays_at_once, rays.size() - begin));
    if (fits_lanes) {
      state.load(packet);
      state.lane_rays.whole_line = span.from != 0;
      state.lane_rays.end = span.to == line_end().t ? nullptr : end.data();
      state.code.lists(scene(), state.cells.data(), state.lane_rays, state.lists, state.counts);
      state.lane_rays = {};
    }
    for (std::size_t i = 0; i < packet.size(); ++i) {
      const bool is_known = fits_lanes && !state.lists.is_flagged[i];
      if (!is_known || rounding == Rounding::nearest) state.caster.begin(packet[i]);
      if (is_known) {
        state.append_known(i, span, rounding, batch.intervals);
      } else {
        state.caster.intervals(state.cells.node(), state.list, span);
        batch.intervals.insert(batch.intervals.end(), state.list.begin(), state.list.end());
      }
      batch.offsets.push_back(batch.intervals.size());
      batch.left_to_caster.push_back(is_known ? 0 : 1);
    }
  }
}

void PacketCaster::first_faces(const RayArrays& rays, const FaceArrays& faces) {
  State& state = *state_;
  detail::LaneHits lanes;
  lanes.faces = faces;
  lanes.left = &state.left;
  state.left.clear();
  if (scene().bounded_leaves().is_finite()) {
    state.code.first_hits(scene(), state.cells.data(), rays, lanes, state.counts);
  } else {  // places are computed another way (LineCache::point)
    state.left.resize(rays.count);
    std::iota(state.left.begin(), state.left.end(), 0u);
  }
  for (const std::uint32_t i : state.left) {
    begin(state.caster, rays, i);
    const std::optional<Hit> hit = state.caster.first_hit(state.cells.node(), span_of(rays, i), Rounding::close);
    faces.state[i] = FaceArrays::none;
    if (hit) set_face(faces, i, *hit, state.caster.attribute(state.cells.node(), *hit));
  }
}

void PacketCaster::any_hits(const RayArrays& rays, std::uint8_t* hits) {
  State& state = *state_;
  detail::LaneHits lanes;
  lanes.faces.state = hits;
  lanes.left = &state.left;
  state.left.clear();
  state.code.any_hits(scene(), state.cells.data(), rays, lanes, state.counts);
  for (const std::uint32_t i : state.left) {
    begin(state.caster, rays, i);
    hits[i] = state.caster.any_hit(state.cells.node(), span_of(rays, i)) ? 1 : 0;
  }
}

std::span<const std::uint32_t> PacketCaster::left_to_caster() const { return state_->left; }

PacketCounts PacketCaster::counts() const { return state_->counts; }

CasterCounts PacketCaster::caster_counts() const { return state_->caster.counts(); }

}  // namespace csgcast
