// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/stress/families.h"

namespace csgcast::oracle::quadrics {

/// What was compared in one family, and what was found.
struct Tally {
  std::uint64_t solids = 0;
  std::uint64_t rays = 0;
  std::uint64_t lists = 0;          ///< spans asked about
  std::uint64_t intervals = 0;      ///< in all lists
  std::uint64_t ends = 0;           ///< of whole lines, made by a surface: its id, leaf, look, side and nearest t
  std::uint64_t ties = 0;           ///< groups of two or more crossings at one t, anywhere on a line
  std::uint64_t surface_walks = 0;  ///< ends whose surface only a walk over the group tells
  std::uint64_t leaf_walks = 0;     ///< ends whose leaf only a walk over the copies tells
  std::uint64_t departures = 0;     ///< rays that depart from a surface
  std::uint64_t points = 0;
  std::uint64_t on_surfaces = 0;  ///< points at which some surface vanishes
  std::uint64_t wrong = 0;
  std::vector<std::string> complaints;  ///< the first few

  void complain(std::string text);
};

/// Rays a family: 20,000 if the environment has CSGCAST_LONG=1, else 400.
std::uint64_t rays_a_family();

/// Compares trials of a family until so many rays are done: the compiled surfaces and leaves; on each ray the lists of
/// the ray, of the whole line, of spans that begin and end near (often exactly at) a crossing, first_hit and any_hit,
/// the reversed ray's list; a ray that departs from one of the ends; and where a point is, often one on a surface.
Tally check_family(const stress::Family& family, std::uint64_t rays);

/// One line of counts.
std::string summary(const std::string& family, const Tally& tally);

}  // namespace csgcast::oracle::quadrics
