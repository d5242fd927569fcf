// SPDX-License-Identifier: MIT
#include "raycast/weld/welder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "csg/base/length.h"

namespace csgcast::detail {
namespace {

// Errors are computed in double and to first order. So they are off by errors of their own: a share of the largest
// error of an entry. A pair that is farther by a little more still counts.
struct Tolerance {
  double border;
  double most_error;
};
constexpr Tolerance for_doubles{1 + 0x1p-30, 0x1p-20};
constexpr Tolerance for_few_digits{1 + 0x1p-6, 0x1p-4};
// A surface is compared with at most this many others of its cluster, by at most this many of its chains of transforms.
// In addition to the comparisons that any scene may take, each surface may cost this many comparisons on average.
constexpr std::size_t most_compared = 16;
constexpr std::size_t most_chains = 16;
constexpr std::uint64_t most_work_each = 40;
constexpr std::uint64_t least_work = 100'000;
// Near misses are at most this share of the scene apart.
constexpr double greatest_near_miss = 0x1p-13;
constexpr double wide_jump = 10;
constexpr std::size_t most_misses = 100'000;
constexpr Box unit{{-1, -1, -1}, {1, 1, 1}};

std::size_t bits_of(const QuadricForm& form) {
  std::size_t bits = 0;
  for (const Dyadic& c : form.coefficient) bits += c.bits();
  return bits;
}

double total(const FormError& error) { return std::accumulate(error.begin(), error.end(), 0.0); }

void count(std::span<const Replacement> replacements, WeldReport& report) {
  std::vector<bool> takes_in(replacements.size());
  for (std::uint32_t i = 0; i < replacements.size(); ++i) {
    if (replacements[i].surface == i) continue;
    ++report.surfaces;
    report.clusters += takes_in[replacements[i].surface] ? 0 : 1;
    takes_in[replacements[i].surface] = true;
  }
}

}  // namespace

// Simpler forms come first. Canonical forms alone decide, so the order of the file does not matter.
bool Welder::precedes(const Surface& a, const Surface& b) {
  if (a.bits != b.bits) return a.bits < b.bits;
  return std::lexicographical_compare(a.form.coefficient.begin(), a.form.coefficient.end(), b.form.coefficient.begin(),
                                      b.form.coefficient.end());
}

// If the scene has no size, any center will do to judge the rounding.
Welder::Welder(const Provenance& provenance, const Welding& welding, const Box& everything)
    : provenance_(provenance),
      welding_(welding),
      has_size_(everything.is_finite()),
      everything_(has_size_ ? everything : unit),
      region_(Region::around(everything_)),
      tolerance_(has_size_ ? welding.tolerance * length(everything.size()) : 0) {
  const Tolerance tolerance = provenance.has_few_digits() ? for_few_digits : for_doubles;
  border_ = tolerance.border;
  most_error_ = tolerance.most_error;
}

// The error of the least accurately known source. It is used to look for surfaces that may coincide.
FormError Welder::worst_known(const Candidate& candidate, const RegionForm& form) const {
  FormError worst{};
  double most = -1;
  for (const Provenance::Source source : candidate.sources) {
    const FormError error = provenance_.error(source, form, region_, 0);
    const double sum = total(error);
    if (sum > most || std::isnan(sum)) worst = error;
    most = std::fmax(most, sum);
  }
  return worst;
}

// For each chain of transforms this finds the most accurately known source, and of these the best ones. Two surfaces
// are different if any of these sources tells them apart.
std::vector<Provenance::Source> Welder::best_known(const Candidate& candidate, const RegionForm& form) const {
  std::map<Provenance::ChainId, std::pair<double, Provenance::Source>> best;
  for (const Provenance::Source source : candidate.sources) {
    const double sum = total(provenance_.error(source, form, region_, 0));
    const auto [it, is_new] = best.try_emplace(provenance_.chain_of(source), sum, source);
    if (!is_new && sum < it->second.first) it->second = {sum, source};
  }
  std::vector<std::pair<double, Provenance::Source>> sorted;
  sorted.reserve(best.size());
  for (const auto& [chain, known] : best) sorted.push_back(known);
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Provenance::Source> sources;
  for (const auto& [sum, source] : sorted) {
    if (sources.size() == most_chains) break;
    sources.push_back(source);
  }
  return sources;
}

Welder::Surface Welder::described(std::uint32_t number) const {
  const Candidate& candidate = candidates_[number];
  Surface surface;
  surface.number = number;
  surface.form = candidate.form->unpacked();
  surface.sources = best_known(candidate, RegionForm(surface.form, region_));
  surface.bits = bits_of(surface.form);
  for (const Provenance::Source source : candidate.sources)
    surface.box = hull(surface.box, intersection(provenance_.box(source), everything_));
  if (!surface.box.is_finite()) surface.box = everything_;
  return surface;
}

RegionForm Welder::region_form(std::uint32_t candidate) const {
  return forms_.empty() ? RegionForm(candidates_[candidate].form->unpacked(), region_) : forms_[candidate];
}

const std::vector<RegionForm>& Welder::region_forms() {
  if (!forms_.empty()) return forms_;
  forms_.reserve(candidates_.size());
  for (const Candidate& candidate : candidates_) forms_.emplace_back(candidate.form->unpacked(), region_);
  return forms_;
}

Grouping::Groups Welder::groups_by_rounding() {
  if (welding_.lists_near_misses) region_forms();  // they are needed again
  for (std::uint32_t i = 0; i < candidates_.size(); ++i) {
    const RegionForm form = region_form(i);
    near_.add(i, form, worst_known(candidates_[i], form));
  }
  return near_.groups();
}

// The leaves with those of their surfaces that are left. `one_source` gets one source of each leaf, from which the
// leaf's statement is known.
std::vector<LeafFaces> Welder::faces(std::span<const Replacement> replacements,
                                     std::vector<Provenance::Source>& one_source) const {
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> place_of(provenance_.leaf_count(), none);
  std::vector<LeafFaces> leaves;
  for (std::uint32_t i = 0; i < candidates_.size(); ++i) {
    for (const Provenance::Source source : candidates_[i].sources) {
      std::uint32_t& place = place_of[source.leaf];
      if (place == none) {
        place = static_cast<std::uint32_t>(leaves.size());
        const Box box = intersection(provenance_.box(source), everything_);
        leaves.push_back({box.is_finite() ? box : everything_, {}});
        one_source.push_back(source);
      }
      std::vector<std::uint32_t>& surfaces = leaves[place].surfaces;
      const std::uint32_t now = replacements[i].surface;
      if (std::find(surfaces.begin(), surfaces.end(), now) == surfaces.end()) surfaces.push_back(now);
    }
  }
  return leaves;
}

// With few digits errors are wide: thousands of surfaces are near each other by any one number. So only faces that come
// near each other in space are compared.
Grouping::Groups Welder::groups_by_digits(std::span<const Replacement> replacements, WeldReport& report) {
  double most = 0;
  region_forms();
  for (std::uint32_t i = 0; i < candidates_.size(); ++i) {
    for (const Provenance::Source source : candidates_[i].sources) {
      const double displacement = provenance_.displacement(source, forms_[i], region_);
      if (std::isfinite(displacement)) most = std::fmax(most, displacement);
    }
  }
  // Both surfaces of a pair move, and the gap over both of their leaves may be a few times that over one.
  const double size = length(everything_.size());
  const double most_gap = std::fmin(std::fmax(8 * most, greatest_near_miss * size), Welding::greatest_tolerance * size);
  return groups_that_touch(most_gap, replacements, report);
}

Grouping::Groups Welder::groups_by_hand(std::span<const Replacement> replacements, WeldReport& report) {
  return groups_that_touch(tolerance_, replacements, report);
}

Grouping::Groups Welder::groups_that_touch(double most_gap, std::span<const Replacement> replacements,
                                           WeldReport& report) {
  const std::vector<RegionForm>& forms = region_forms();
  Grouping grouping(candidates_.size());
  std::vector<Provenance::Source> one_source;
  const std::vector<LeafFaces> leaves = faces(replacements, one_source);
  NearFaces search(forms, region_, most_gap);
  const bool whole = search.search(leaves, 4 * most_work_, [&grouping](const NearFaces::Pair& pair) {
    grouping.join(pair.a, pair.b);
    return true;
  });
  report.incomplete = report.incomplete || !whole;
  return grouping.groups([replacements](std::uint32_t i) { return replacements[i].surface == i; });
}

// The distance of two surfaces, in errors or in tolerances. If it is at most 1, they can be one surface.
double Welder::distance(const Member& a, const Member& b, const Region& region) {
  ++work_;
  const Surface& f = *a.surface;
  const Surface& g = *b.surface;
  if (by_hand_) return gap(a.form, b.form, region, hull(f.box, g.box)) / tolerance_;
  double most = 0;
  for (const Provenance::Source from : f.sources) {
    for (const Provenance::Source to : g.sources) {
      const Provenance::ChainId known = provenance_.common(provenance_.chain_of(from), provenance_.chain_of(to), work_);
      most = std::fmax(most, distance_in_errors(a.form, provenance_.error(from, a.form, region, known), b.form,
                                                provenance_.error(to, b.form, region, known), most_error_));
      if (most > border_) return most;
    }
  }
  return most;
}

std::vector<Replacement> Welder::run(std::span<const Candidate> candidates, WeldReport& report) {
  report.size = has_size_ ? length(everything_.size()) : 0;
  most_work_ = most_work_each * candidates.size() + least_work;
  candidates_ = candidates;
  std::vector<Replacement> replacements;
  replacements.reserve(candidates.size());
  for (std::uint32_t i = 0; i < candidates.size(); ++i) replacements.push_back({i});
  const bool by_digits = provenance_.has_few_digits();
  weld_groups(by_digits ? groups_by_digits(replacements, report) : groups_by_rounding(), replacements, report);
  if (welding_.mode == Welding::Mode::by_hand && has_size_) {
    by_hand_ = true;
    work_ = 0;
    weld_groups(groups_by_hand(replacements, report), replacements, report);
  }
  // A surface that took others in may later have been taken in itself, when welding by hand.
  for (Replacement& replacement : replacements) {
    const Replacement& next = replacements[replacement.surface];
    replacement = {next.surface, replacement.flipped != next.flipped};
  }
  count(replacements, report);
  if (welding_.lists_near_misses && has_size_) list_near_misses(replacements, report);
  return replacements;
}

void Welder::weld_groups(const Grouping::Groups& groups, std::vector<Replacement>& replacements, WeldReport& report) {
  for (const std::vector<std::uint32_t>& group : groups) weld_group(group, replacements, report);
}

void Welder::weld_group(std::span<const std::uint32_t> numbers, std::vector<Replacement>& replacements,
                        WeldReport& report) {
  std::vector<Surface> group;
  group.reserve(numbers.size());
  for (const std::uint32_t number : numbers) group.push_back(described(number));
  std::sort(group.begin(), group.end(), precedes);
  const bool has_ranges = !by_hand_ && !provenance_.has_few_digits();
  std::vector<bool> is_done(group.size());
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (is_done[i]) continue;
    const Region region = Region::around(group[i].box);
    if (!region.is_resolved()) continue;
    const Member leader{&group[i], RegionForm(group[i].form, region), 0};
    std::vector<Member> members;
    for (std::size_t j = i + 1; j < group.size(); ++j) {
      work_ += j % 64 == 0 ? 1 : 0;
      if (is_done[j] || (has_ranges && !near_.overlap(group[i].number, group[j].number))) continue;
      if (work_ > most_work_) {
        report.incomplete = true;
        return;
      }
      Member member{&group[j], RegionForm(group[j].form, region), 0};
      member.distance = distance(leader, member, region);
      if (member.distance <= border_) members.push_back(std::move(member));
    }
    gather(leader, region, std::move(members), replacements, report);
    for (std::size_t j = i + 1; j < group.size(); ++j)
      is_done[j] = is_done[j] || replacements[group[j].number].surface != group[j].number;
  }
}

// The leader takes members in, nearest first. A member must also be able to coincide with all members taken in before
// it.
void Welder::gather(const Member& leader, const Region& region, std::vector<Member> members,
                    std::vector<Replacement>& replacements, WeldReport& report) {
  std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
    return a.distance != b.distance ? a.distance < b.distance : precedes(*a.surface, *b.surface);
  });
  std::vector<const Member*> taken;
  for (const Member& member : members) {
    const std::size_t compared = std::min(taken.size(), most_compared);
    const bool fits = std::all_of(taken.end() - static_cast<std::ptrdiff_t>(compared), taken.end(),
                                  [&](const Member* other) { return distance(*other, member, region) <= border_; });
    if (!fits) continue;
    taken.push_back(&member);
    replacements[member.surface->number] = {leader.surface->number, is_flipped(leader.form, member.form)};
    const double moved = gap(leader.form, member.form, region, member.surface->box);
    report.widest = std::fmax(report.widest, moved);
  }
}

void Welder::list_near_misses(std::span<const Replacement> replacements, WeldReport& report) {
  const std::vector<RegionForm>& forms = region_forms();
  std::vector<Provenance::Source> one_source;
  const std::vector<LeafFaces> leaves = faces(replacements, one_source);
  // Two faces of one leaf are not a near miss, because the leaf was made like that.
  std::map<std::pair<std::uint32_t, std::uint32_t>, NearMiss> nearest;
  const auto note = [&](const NearFaces::Pair& pair) {
    if (pair.leaf_of_a == pair.leaf_of_b || pair.gap <= tolerance_) return true;
    const NearMiss miss{provenance_.place(one_source[pair.leaf_of_a]), provenance_.place(one_source[pair.leaf_of_b]),
                        pair.gap};
    const auto [it, is_new] = nearest.try_emplace({pair.a, pair.b}, miss);
    if (!is_new && miss.gap < it->second.gap) it->second = miss;
    return nearest.size() < most_misses;
  };
  NearFaces search(forms, region_, greatest_near_miss * report.size);
  search.search(leaves, 4 * most_work_, note);
  std::vector<NearMiss> found;
  found.reserve(nearest.size());
  for (const auto& [surfaces, miss] : nearest) found.push_back(miss);
  std::stable_sort(found.begin(), found.end(), [](const NearMiss& a, const NearMiss& b) { return a.gap < b.gap; });
  report.near_miss_count = found.size();
  // The suggested tolerance would weld the near misses up to the last wide jump of their gaps. The limit of near misses
  // serves as the gap after the widest one.
  double next = greatest_near_miss * report.size;
  for (std::size_t i = found.size(); i-- > 0 && report.suggested_tolerance == 0; next = found[i].gap) {
    if (next > wide_jump * found[i].gap) report.suggested_tolerance = 1.25 * found[i].gap / report.size;
  }
  // Two statements are listed once, however many of their faces nearly coincide.
  for (const NearMiss& miss : found) {
    const auto same = [&miss](const NearMiss& other) {
      return miss.first == other.first && miss.second == other.second;
    };
    if (report.near_misses.size() == WeldReport::most_near_misses) break;
    if (std::none_of(report.near_misses.begin(), report.near_misses.end(), same)) report.near_misses.push_back(miss);
  }
}

}  // namespace csgcast::detail
