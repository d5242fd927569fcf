// SPDX-License-Identifier: MIT
#include "raycast/packets/packet_caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "csg/base/add_members.h"
#include "csg/base/error.h"
#include "csg/base/precondition.h"
#include "raycast/cells/cells_data.h"
#include "raycast/line/interval_list.h"
#include "raycast/packets/detail/caster_pointers.h"
#include "raycast/packets/detail/lanes.h"
#include "raycast/packets/detail/ray_pointers.h"

namespace csgcast {
namespace {

using detail::FacePointers;
using detail::HitPointers;
using detail::RayPointers;

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

Ray ray_at(const RayPointers& rays, std::size_t i) {
  return {{rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]},
          {rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]}};
}

void begin(Caster& caster, const RayPointers& rays, std::size_t i) {
  std::optional<Departure> departure;
  if (rays.departure != nullptr) {
    const Sense side = rays.departs_positive[i] != 0 ? Sense::positive : Sense::negative;
    departure = Departure{SurfaceId(rays.departure[i]), side};
  }
  caster.begin(ray_at(rays, i), departure);
}

Span span_of(const RayPointers& rays, std::size_t i) {
  Span span = rays.whole_line ? Span::line() : Span();
  if (rays.end != nullptr) span.to = rays.end[i];
  return span;
}

// Rays [begin, begin + count).
RayPointers part(RayPointers rays, std::size_t begin, std::size_t count) {
  rays.count = count;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rays.origin[axis] += begin;
    rays.direction[axis] += begin;
  }
  if (rays.end != nullptr) rays.end += begin;
  if (rays.departure != nullptr) {
    rays.departure += begin;
    rays.departs_positive += begin;
  }
  return rays;
}

void set_hit(const HitPointers& hits, std::size_t i, const std::optional<Hit>& hit) {
  hits.state[i] = HitArrays::none;
  if (!hit) return;
  hits.state[i] = hit->passage == Passage::entry ? HitArrays::entry : HitArrays::exit;
  hits.t[i] = hit->crossing.t;
  hits.surface[i] = hit->crossing.surface.index();
  if (hits.root != nullptr) hits.root[i] = hit->crossing.root;
}

void set_face(const FacePointers& faces, std::size_t i, const Attribution& face) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    faces.point[axis][i] = face.point[axis];
    faces.normal[axis][i] = face.normal[axis];
  }
  faces.look[i] = face.look.index();
  faces.comes_positive[i] = face.front == Sense::positive ? 1 : 0;
  if (faces.leaf != nullptr) faces.leaf[i] = face.leaf.index();
}

}  // namespace

PacketCounts& PacketCounts::operator+=(const PacketCounts& other) {
  return add_members<&PacketCounts::rays, &PacketCounts::packets, &PacketCounts::nodes, &PacketCounts::cells,
                     &PacketCounts::surface_tests, &PacketCounts::flagged>(*this, other);
}

struct PacketCaster::State {
  State(const Cells& c, Width w, std::string_view instructions)
      : cells(c),
        code(w == Width::packet ? code_named(instructions).packet : code_named(instructions).single),
        caster(c.scene()) {}

  // Rays as arrays: those of `rays` from `begin` on, as many as are at once.
  detail::RayPointers load(std::span<const Ray> rays, std::size_t begin) {
    detail::RayPointers arrays;
    arrays.count = std::min(rays_at_once, rays.size() - begin);
    for (std::size_t i = 0; i < arrays.count; ++i) {
      const Point o = rays[begin + i].origin();
      const Vector d = rays[begin + i].direction();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        origin[axis][i] = o[axis];
        direction[axis][i] = d[axis];
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      arrays.origin[axis] = origin[axis].data();
      arrays.direction[axis] = direction[axis].data();
    }
    return arrays;
  }

  // What a ray that lanes left meets first, by the caster, which has begun it then.
  std::optional<Hit> tell_left(const detail::RayPointers& rays, std::size_t i, const detail::HitPointers& hits,
                               Rounding rounding) {
    begin(caster, rays, i);
    const Span span = span_of(rays, i);
    const std::optional<Hit> hit = caster.first_hit(cells.node(), span, rounding);
    set_hit(hits, i, hit);
    if (hits.is_inside != nullptr) {
      const bool is_inside = hit ? hit->passage == Passage::exit : caster.any_hit(cells.node(), span);
      hits.is_inside[i] = is_inside ? 1 : 0;
    }
    return hit;
  }

  // Whose face an end of the present ray's list is, if a surface makes it.
  EndFace face_of(const Crossing& crossing, Passage passage) {
    return end_face(caster.attribute(cells.node(), {crossing, passage}));
  }

  // Lists of rays that lanes left have none yet: they are put in, from the last one on. `base`: how many rays the batch
  // had before.
  void insert_left(const detail::RayPointers& rays, std::size_t base, std::size_t left_before, IntervalBatch& batch,
                   Rounding rounding, Ends ends) {
    for (std::size_t k = left.size(); k-- > left_before;) {
      const std::size_t i = left[k];
      begin(caster, rays, i);
      caster.intervals(cells.node(), list, span_of(rays, i), rounding);
      const auto at = static_cast<std::ptrdiff_t>(batch.offsets[base + i]);
      batch.intervals.insert(batch.intervals.begin() + at, list.begin(), list.end());
      for (std::size_t ray = base + i; ray < base + rays.count; ++ray) batch.offsets[ray + 1] += list.size();
      if (ends != Ends::bare) batch.faces.insert(batch.faces.begin() + 2 * at, 2 * list.size(), EndFace());
    }
  }

  // The faces that lanes could not tell, or that are of rays they left.
  void tell_faces(const detail::RayPointers& rays, std::size_t base, IntervalBatch& batch, Ends ends) {
    const auto is_known = [&](const EndFace& face) {
      return face.look.valid() && (face.leaf.valid() || ends == Ends::looks);
    };
    for (std::size_t i = 0; i < rays.count; ++i) {
      bool is_begun = false;
      for (std::size_t end = 2 * batch.offsets[base + i]; end < 2 * batch.offsets[base + i + 1]; ++end) {
        const Interval& interval = batch.intervals[end / 2];
        const bool enters = end % 2 == 0;
        const Crossing& crossing = enters ? interval.entry : interval.exit;
        EndFace& face = batch.faces[end];
        if (!crossing.surface.valid() || is_known(face)) continue;
        if (!is_begun) begin(caster, rays, i);
        is_begun = true;
        face = face_of(crossing, enters ? Passage::entry : Passage::exit);
      }
    }
  }

  // t of the ends of rays whose lanes could not round it.
  void round(const detail::RayPointers& rays, std::size_t base, IntervalBatch& batch) {
    for (const std::uint32_t i : unrounded) {
      begin(caster, rays, i);
      for (std::size_t k = batch.offsets[base + i]; k < batch.offsets[base + i + 1]; ++k) {
        Interval& interval = batch.intervals[k];
        if (interval.entry.surface.valid()) interval.entry = caster.reported(interval.entry);
        if (interval.exit.surface.valid()) interval.exit = caster.reported(interval.exit);
      }
    }
  }

  // No list for any ray yet.
  void leave_all(const detail::RayPointers& rays, std::size_t base, IntervalBatch& batch) {
    for (std::size_t i = 0; i < rays.count; ++i) {
      batch.offsets[base + i + 1] = batch.intervals.size();
      left.push_back(static_cast<std::uint32_t>(i));
    }
  }

  // Adds the lists of some rays to the batch.
  void add(const detail::RayPointers& rays, std::size_t base, IntervalBatch& batch, Rounding rounding, Ends ends) {
    batch.offsets.resize(base + rays.count + 1);
    const std::size_t left_before = left.size();
    unrounded.clear();
    const detail::LaneLists lists{.intervals = &batch.intervals,
                                  .faces = ends != Ends::bare ? &batch.faces : nullptr,
                                  .wants_normals = ends == Ends::faces,
                                  .ends = batch.offsets.data() + base + 1,
                                  .left = &left,
                                  .rounds = rounding == Rounding::nearest,
                                  .unrounded = &unrounded};
    if (ends == Ends::faces && !cells.scene().bounded_leaves().is_finite()) {
      leave_all(rays, base, batch);  // places are computed another way (LineCache::point)
    } else {
      code.lists(cells.scene(), cells.data(), rays, lists, counts);
    }
    round(rays, base, batch);
    insert_left(rays, base, left_before, batch, rounding, ends);
    if (ends != Ends::bare) tell_faces(rays, base, batch, ends);
    for (std::size_t k = left_before; k < left.size(); ++k) left[k] += static_cast<std::uint32_t>(base);
  }

  void fill(const detail::RayPointers& rays, IntervalBatch& batch, Rounding rounding, Ends ends) {
    clear(batch);
    // In pieces: what is put in between (insert_left) moves but little.
    for (std::size_t begin = 0; begin < rays.count; begin += rays_at_once)
      add(part(rays, begin, std::min(rays_at_once, rays.count - begin)), begin, batch, rounding, ends);
  }

  void clear(IntervalBatch& batch) {
    batch.intervals.clear();
    batch.faces.clear();
    batch.offsets.assign(1, 0);
    left.clear();
  }

  void first_hits(const detail::RayPointers& rays, const detail::HitPointers& hits, Rounding rounding) {
    detail::LaneHits lanes;
    static_cast<detail::HitPointers&>(lanes.faces) = hits;
    lanes.rounds = rounding == Rounding::nearest;
    lanes.unrounded = &unrounded;
    lanes.left = &left;
    unrounded.clear();
    left.clear();
    code.first_hits(cells.scene(), cells.data(), rays, lanes, counts);
    for (const std::uint32_t i : unrounded) {
      begin(caster, rays, i);
      hits.t[i] = caster.reported({hits.t[i], SurfaceId(hits.surface[i]), hits.root[i]}).t;
    }
    for (const std::uint32_t i : left) tell_left(rays, i, hits, rounding);
  }

  void any_hits(const detail::RayPointers& rays, std::uint8_t* hits) {
    detail::LaneHits lanes;
    lanes.faces.state = hits;
    lanes.left = &left;
    left.clear();
    code.any_hits(cells.scene(), cells.data(), rays, lanes, counts);
    for (const std::uint32_t i : left) {
      begin(caster, rays, i);
      hits[i] = caster.any_hit(cells.node(), span_of(rays, i)) ? 1 : 0;
    }
  }

  void first_faces(const detail::RayPointers& rays, const detail::FacePointers& faces) {
    detail::LaneHits lanes;
    lanes.faces = faces;
    lanes.unowned = &unowned;
    lanes.left = &left;
    unowned.clear();
    left.clear();
    roots.resize(std::max(roots.size(), rays.count));
    if (faces.root == nullptr) lanes.faces.root = roots.data();
    if (cells.scene().bounded_leaves().is_finite()) {
      code.first_hits(cells.scene(), cells.data(), rays, lanes, counts);
    } else {  // places are computed another way (LineCache::point)
      left.resize(rays.count);
      std::iota(left.begin(), left.end(), 0u);
    }
    for (const std::uint32_t i : unowned) {
      begin(caster, rays, i);
      const Passage passage = faces.state[i] == HitArrays::entry ? Passage::entry : Passage::exit;
      const Crossing crossing{faces.t[i], SurfaceId(faces.surface[i]), lanes.faces.root[i]};
      const Attribution face = caster.attribute(cells.node(), {crossing, passage});
      faces.look[i] = face.look.index();
      if (faces.leaf != nullptr) faces.leaf[i] = face.leaf.index();
    }
    for (const std::uint32_t i : left) {
      const std::optional<Hit> hit = tell_left(rays, i, faces, Rounding::close);
      if (hit) set_face(faces, i, caster.attribute(cells.node(), *hit));
    }
  }

  const Cells& cells;
  const detail::LaneFunctions& code;
  Caster caster;
  PacketCounts counts;
  std::array<std::array<double, rays_at_once>, 3> origin;
  std::array<std::array<double, rays_at_once>, 3> direction;
  std::array<std::uint8_t, rays_at_once> found;
  std::array<double, rays_at_once> t;
  std::array<std::uint32_t, rays_at_once> surface;
  std::array<std::uint8_t, rays_at_once> root;
  std::vector<std::uint32_t> left;     // the rays that lanes could not decide
  std::vector<std::uint32_t> unowned;  // those whose face they could not tell the owner of
  std::vector<std::uint8_t> roots;
  std::vector<std::uint32_t> unrounded;  // and those whose t they could not round
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

void PacketCaster::check_instructions(std::string_view name) { code_named(name); }

const Scene& PacketCaster::scene() const { return state_->cells.scene(); }

void PacketCaster::first_hits(const RayArrays& rays, const HitArrays& hits, Rounding rounding) {
  const bool rounds = rounding == Rounding::nearest;
  state_->first_hits(detail::pointers_of(rays), detail::pointers_of(hits, rays.count(), rounds), rounding);
}

void PacketCaster::any_hits(const RayArrays& rays, std::span<std::uint8_t> hits) {
  CSGCAST_PRECONDITION(hits.size() >= rays.count());
  state_->any_hits(detail::pointers_of(rays), hits.data());
}

void PacketCaster::first_faces(const RayArrays& rays, const FaceArrays& faces) {
  state_->first_faces(detail::pointers_of(rays), detail::pointers_of(faces, rays.count()));
}

void PacketCaster::first_faces(const RayPointers& rays, const FacePointers& faces) { state_->first_faces(rays, faces); }

void PacketCaster::intervals(const RayPointers& rays, IntervalBatch& batch, Rounding rounding, Ends ends) {
  state_->fill(rays, batch, rounding, ends);
}

void PacketCaster::first_hits(std::span<const Ray> rays, std::span<std::optional<Hit>> hits, Rounding rounding) {
  CSGCAST_PRECONDITION(hits.size() == rays.size());
  State& state = *state_;
  const detail::HitPointers arrays{state.found.data(), state.t.data(), state.surface.data(), state.root.data()};
  std::vector<std::uint32_t> left;
  for (std::size_t begin = 0; begin < rays.size(); begin += rays_at_once) {
    const detail::RayPointers some = state.load(rays, begin);
    state.first_hits(some, arrays, rounding);
    for (const std::uint32_t i : state.left) left.push_back(static_cast<std::uint32_t>(begin) + i);
    for (std::size_t i = 0; i < some.count; ++i) {
      std::optional<Hit>& hit = hits[begin + i];
      hit.reset();
      if (state.found[i] == HitArrays::none) continue;
      hit = Hit{{state.t[i], SurfaceId(state.surface[i]), state.root[i]},
                state.found[i] == HitArrays::entry ? Passage::entry : Passage::exit};
    }
  }
  state.left.swap(left);
}

void PacketCaster::any_hits(std::span<const Ray> rays, std::span<std::uint8_t> hits) {
  CSGCAST_PRECONDITION(hits.size() == rays.size());
  std::vector<std::uint32_t> left;
  for (std::size_t begin = 0; begin < rays.size(); begin += rays_at_once) {
    state_->any_hits(state_->load(rays, begin), hits.data() + begin);
    for (const std::uint32_t i : state_->left) left.push_back(static_cast<std::uint32_t>(begin) + i);
  }
  state_->left.swap(left);
}

void PacketCaster::intervals(const RayArrays& rays, IntervalBatch& batch, Rounding rounding, Ends ends) {
  state_->fill(detail::pointers_of(rays), batch, rounding, ends);
}

void PacketCaster::intervals(std::span<const Ray> rays, IntervalBatch& batch, Span span, Rounding rounding, Ends ends) {
  State& state = *state_;
  state.clear(batch);
  const bool fits_lanes = (span.from == 0 || span.from == -HUGE_VAL) && span.to > span.from;
  std::array<double, rays_at_once> end;
  end.fill(span.to);
  for (std::size_t begin = 0; begin < rays.size(); begin += rays_at_once) {
    detail::RayPointers some = state.load(rays, begin);
    some.whole_line = span.from != 0;
    some.end = span.to == HUGE_VAL ? nullptr : end.data();
    if (fits_lanes) {
      state.add(some, begin, batch, rounding, ends);
      continue;
    }
    for (std::size_t i = begin; i < begin + some.count; ++i) {
      state.caster.begin(rays[i]);
      state.caster.intervals(state.cells.node(), state.list, span, rounding);
      batch.intervals.insert(batch.intervals.end(), state.list.begin(), state.list.end());
      batch.offsets.push_back(batch.intervals.size());
      state.left.push_back(static_cast<std::uint32_t>(i));
    }
    if (ends == Ends::bare) continue;
    batch.faces.resize(2 * batch.intervals.size());
    state.tell_faces(some, begin, batch, ends);
  }
}

std::span<const std::uint32_t> PacketCaster::left_to_caster() const { return state_->left; }

PacketCounts PacketCaster::counts() const { return state_->counts; }

CasterCounts PacketCaster::caster_counts() const { return state_->caster.counts(); }

}  // namespace csgcast
