// SPDX-License-Identifier: MIT
#include "raycast/detail/welder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace csgcast::detail {
namespace {

// The errors are those of doubles, with errors of their own: a pair at the very border counts.
constexpr double border = 1 + 0x1p-30;
// A surface is compared with so many others of its cluster at most, and with so many in all on the average.
constexpr std::size_t most_compared = 64;
constexpr std::uint64_t most_work_each = 128;
// Near misses are at most this share of the scene apart.
constexpr double greatest_near_miss = 0x1p-13;

std::size_t bits_of(const QuadricForm& form) {
  std::size_t bits = 0;
  for (const Dyadic& c : form.coefficient) bits += c.bits();
  return bits;
}

bool touch(const Box& a, const Box& b, double slack) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.lower[axis] - slack > b.upper[axis] || b.lower[axis] - slack > a.upper[axis]) return false;
  }
  return true;
}

// A motion of up to `tolerance` anywhere in a box, half of it for each of two surfaces.
SmallMotion motion_within(double tolerance, const Box& box, const Region& region) {
  SmallMotion motion;
  const double half = std::ldexp(0.5 * tolerance, -region.exponent);
  for (std::size_t k = 0; k < 3; ++k) {
    motion.offset[k] = half;
    for (std::size_t l = 0; l < 3; ++l) {
      const double reach = std::ldexp(0.5 * (box.upper[l] - box.lower[l]), -region.exponent);
      motion.slope[3 * k + l] = reach > 0 ? half / reach : 0;
    }
  }
  return motion;
}

// `motion_within` about the box's own center, seen from the region's: the offset grows by the way between them.
SmallMotion seen_from(SmallMotion motion, const Box& box, const Region& region) {
  const Vector way = box.center() - region.center;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l)
      motion.offset[k] += motion.slope[3 * k + l] * std::ldexp(std::fabs(way[l]), -region.exponent);
  }
  return motion;
}

}  // namespace

Welder::Welder(const Provenance& provenance, const Welding& welding, const Box& everything)
    : provenance_(provenance),
      welding_(welding),
      everything_(everything),
      tolerance_(welding.tolerance * length(everything.size())) {}

// The canonical forms decide, so the order of the file does not matter.
bool Welder::precedes(std::uint32_t a, std::uint32_t b) const {
  const Surface& x = surfaces_[a];
  const Surface& y = surfaces_[b];
  if (x.bits != y.bits) return x.bits < y.bits;
  return std::lexicographical_compare(x.form->coefficient.begin(), x.form->coefficient.end(),
                                      y.form->coefficient.begin(), y.form->coefficient.end());
}

Box Welder::box_of(std::uint32_t surface) const {
  const Box box = intersection(provenance_.box(surfaces_[surface].source), everything_);
  return box.is_null() ? everything_ : box;
}

FormError Welder::full_error(Provenance::Source source, const RegionForm& form, const Region& region) const {
  if (welding_.mode == Welding::Mode::derived) return provenance_.error(source, form, region, 0);
  Box box = intersection(provenance_.box(source), everything_);
  if (box.is_null()) box = everything_;
  return error_of(form, seen_from(motion_within(tolerance_, box, region), box, region));
}

FormError Welder::error(std::uint32_t surface, const RegionForm& form, const Region& region,
                        Provenance::ChainId known) const {
  return provenance_.error(surfaces_[surface].source, form, region, known);
}

void Welder::collect(std::span<const Candidate> candidates) {
  const Region region = Region::around(everything_);
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    const auto& [form, sources] = candidates[i];
    const RegionForm in_region(*form, region);
    Surface surface{form, sources.front(), bits_of(*form)};
    FormError worst{};
    double most = -1;
    for (const Provenance::Source source : sources) {
      const FormError error = full_error(source, in_region, region);
      const double sum = std::accumulate(error.begin(), error.end(), 0.0);
      if (!(sum > most)) continue;
      most = sum;
      worst = error;
      surface.source = source;
    }
    surfaces_.push_back(surface);
    if (most >= 0) near_.add(i, in_region, worst);
  }
}

// In errors, or in tolerances: at most 1 for one surface.
double Welder::distance(const Member& a, const Member& b, const Region& region) {
  ++work_;
  if (welding_.mode == Welding::Mode::by_hand)
    return gap(a.form, b.form, region, hull(box_of(a.surface), box_of(b.surface))) / tolerance_;
  const Provenance::ChainId known = provenance_.common(provenance_.chain_of(surfaces_[a.surface].source),
                                                       provenance_.chain_of(surfaces_[b.surface].source), work_);
  return distance_in_errors(a.form, error(a.surface, a.form, region, known), b.form,
                            error(b.surface, b.form, region, known));
}

std::vector<Replacement> Welder::run(std::span<const Candidate> candidates, WeldReport& report) {
  report.size = length(everything_.size());
  most_work_ = most_work_each * candidates.size() + 100'000;
  collect(candidates);
  std::vector<Replacement> replacements;
  for (std::uint32_t i = 0; i < candidates.size(); ++i) replacements.push_back({i});
  for (std::vector<std::uint32_t>& group : near_.groups()) weld_group(std::move(group), replacements, report);
  if (welding_.lists_near_misses) list_near_misses(candidates, replacements, report);
  return replacements;
}

void Welder::weld_group(std::vector<std::uint32_t> group, std::vector<Replacement>& replacements, WeldReport& report) {
  std::sort(group.begin(), group.end(), [this](std::uint32_t a, std::uint32_t b) { return precedes(a, b); });
  std::vector<bool> is_done(group.size());
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (is_done[i]) continue;
    const Region region = Region::around(box_of(group[i]));
    const Member leader{group[i], RegionForm(*surfaces_[group[i]].form, region), 0};
    std::vector<Member> members;
    for (std::size_t j = i + 1; j < group.size(); ++j) {
      work_ += j % 64 == 0 ? 1 : 0;
      if (is_done[j] || !near_.overlap(group[i], group[j])) continue;
      if (work_ > most_work_) {
        report.incomplete = true;
        return;
      }
      Member member{group[j], RegionForm(*surfaces_[group[j]].form, region), 0};
      member.distance = distance(leader, member, region);
      if (member.distance <= border) members.push_back(std::move(member));
    }
    gather(leader, region, std::move(members), replacements, report);
    for (std::size_t j = i + 1; j < group.size(); ++j)
      is_done[j] = is_done[j] || replacements[group[j]].surface != group[j];
  }
}

// Takes members in, nearest first, that could also coincide with each other.
void Welder::gather(const Member& leader, const Region& region, std::vector<Member> members,
                    std::vector<Replacement>& replacements, WeldReport& report) {
  std::sort(members.begin(), members.end(), [this](const Member& a, const Member& b) {
    return a.distance != b.distance ? a.distance < b.distance : precedes(a.surface, b.surface);
  });
  std::vector<const Member*> taken;
  for (const Member& member : members) {
    const std::size_t compared = std::min(taken.size(), most_compared);
    const bool fits = std::all_of(taken.end() - static_cast<std::ptrdiff_t>(compared), taken.end(),
                                  [&](const Member* other) { return distance(*other, member, region) <= border; });
    if (!fits) continue;
    taken.push_back(&member);
    replacements[member.surface] = {leader.surface, is_flipped(leader.form, member.form)};
    const double moved = gap(leader.form, member.form, region, box_of(member.surface));
    report.widest = std::fmax(report.widest, moved);
  }
  report.surfaces += taken.size();
  report.clusters += taken.empty() ? 0 : 1;
}

// The nearest that two surfaces come over leaves of theirs that touch; none if that is above `most`.
std::optional<NearMiss> Welder::near_miss(const Candidate& a, const Candidate& b, double most) {
  std::optional<NearMiss> nearest;
  for (const Provenance::Source from : a.sources) {
    const Box& box = provenance_.box(from);
    for (const Provenance::Source to : b.sources) {
      if (++work_ > most_work_) return nearest;
      if (from.leaf == to.leaf || !touch(box, provenance_.box(to), most)) continue;
      const Box both = intersection(hull(box, provenance_.box(to)), everything_);
      if (!both.is_finite()) continue;
      const Region region = Region::around(both);
      const double apart = gap(RegionForm(*a.form, region), RegionForm(*b.form, region), region, both);
      if (apart <= (nearest ? nearest->gap : most)) nearest = {provenance_.place(from), provenance_.place(to), apart};
    }
  }
  return nearest;
}

void Welder::list_near_misses(std::span<const Candidate> candidates, std::span<const Replacement> replacements,
                              WeldReport& report) {
  const double most = greatest_near_miss * report.size;
  const Region frame = Region::around(everything_);
  NearPairs near;
  for (std::uint32_t i = 0; i < surfaces_.size(); ++i) {
    if (replacements[i].surface != i) continue;
    const RegionForm form(*surfaces_[i].form, frame);
    near.add(i, form, error_of(form, seen_from(motion_within(most, box_of(i), frame), box_of(i), frame)));
  }
  std::vector<NearMiss> found;
  work_ = 0;
  for (const std::vector<std::uint32_t>& group : near.groups()) {
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (std::size_t j = i + 1; j < group.size() && work_ <= most_work_; ++j) {
        work_ += j % 64 == 0 ? 1 : 0;
        if (!near.overlap(group[i], group[j])) continue;
        if (const auto miss = near_miss(candidates[group[i]], candidates[group[j]], most)) found.push_back(*miss);
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const NearMiss& a, const NearMiss& b) { return a.gap < b.gap; });
  report.near_miss_count = found.size();
  // The first wide jump ends the run of gaps that look like one kind of rounding.
  for (std::size_t i = 0; i < found.size() && (i == 0 || found[i].gap <= 10 * found[i - 1].gap); ++i)
    report.suggested_tolerance = 1.25 * found[i].gap / report.size;
  // One line for two statements, however many faces of theirs nearly coincide.
  for (const NearMiss& miss : found) {
    const auto same = [&miss](const NearMiss& other) {
      return miss.first == other.first && miss.second == other.second;
    };
    if (report.near_misses.size() == WeldReport::most_near_misses) break;
    if (std::none_of(report.near_misses.begin(), report.near_misses.end(), same)) report.near_misses.push_back(miss);
  }
}

}  // namespace csgcast::detail
