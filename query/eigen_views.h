// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "csg/base/error.h"
#include "query/ray_queries.h"

// Rays and tables as matrices of Eigen, without a copy. No other header includes this one: only who includes it needs
// Eigen (find_package(Eigen3)).

namespace csgcast {

/// Triples as rows, as they lie in memory: an origin, a direction or a point each.
using TripleRows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// Pairs as rows: an entry and an exit each.
template <class Number>
using PairRows = Eigen::Matrix<Number, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// The numbers of a matrix of rows, in place; a block of whole rows, a Ref or a Map of one as well. It must outlive
/// them. What is not double or lies otherwise does not compile; throws Error(usage) for columns of a wider matrix.
template <class Derived>
std::span<const double> numbers_of(const Eigen::MatrixBase<Derived>& rows) {
  static_assert(std::is_same_v<typename Derived::Scalar, double> && Derived::ColsAtCompileTime == 3 &&
                    Derived::IsRowMajor && Derived::InnerStrideAtCompileTime == 1,
                "rays and points are rows of three doubles that lie after another: give a csgcast::TripleRows");
  if (rows.rows() > 1 && rows.derived().outerStride() != 3) {
    throw Error(ErrorCode::usage, {}, "the rows of the matrix do not lie after another", "rays are taken in place",
                "copy them to a csgcast::TripleRows");
  }
  return {rows.derived().data(), 3 * static_cast<std::size_t>(rows.rows())};
}

/// Rays of two matrices of (rays, 3), which must outlive them. Throws Error(usage) if they are not as many; likewise.
template <class Origins, class Directions>
Rays rays_of(const Eigen::MatrixBase<Origins>& origins, const Eigen::MatrixBase<Directions>& directions) {
  if (origins.rows() != directions.rows()) {
    throw Error(ErrorCode::usage, {}, "there are not as many origins as directions", "each ray has one of both",
                "give matrices of as many rows");
  }
  return {numbers_of(origins), numbers_of(directions)};
}

/// What a table of intervals holds, in place: valid as long as the table is not changed.
class IntervalViews {
 public:
  explicit IntervalViews(const IntervalTable& table)
      : offsets(table.offsets.data(), rows(table.offsets.size())),
        t(table.t.data(), rows(table.count()), 2),
        surfaces(table.surfaces.data(), rows(table.surfaces.size() / 2), 2),
        leaves(table.leaves.data(), rows(table.leaves.size() / 2), 2),
        parts(table.parts.data(), rows(table.parts.size() / 2), 2),
        entry_normals(table.normals.data(), rows(table.normals.size() / 6), 3, Eigen::OuterStride<>(6)),
        exit_normals(table.normals.empty() ? nullptr : &table.normals[3], rows(table.normals.size() / 6), 3,
                     Eigen::OuterStride<>(6)) {}
  /// A table that ends with the statement would leave views of nothing.
  explicit IntervalViews(IntervalTable&&) = delete;

  using Normals = Eigen::Map<const TripleRows, Eigen::Unaligned, Eigen::OuterStride<>>;

  Eigen::Map<const Eigen::Matrix<std::uint64_t, Eigen::Dynamic, 1>> offsets;  ///< (rays + 1)
  Eigen::Map<const PairRows<double>> t;                                       ///< (intervals, 2)
  Eigen::Map<const PairRows<std::uint32_t>> surfaces;                         ///< (intervals, 2)
  Eigen::Map<const PairRows<std::uint32_t>> leaves;  ///< (intervals, 2); (0, 2) unless faces were asked for
  Eigen::Map<const PairRows<std::uint32_t>> parts;   ///< likewise
  Normals entry_normals;                             ///< (intervals, 3); (0, 3) unless normals were asked for
  Normals exit_normals;                              ///< likewise

 private:
  static Eigen::Index rows(std::size_t count) { return static_cast<Eigen::Index>(count); }
};

/// What a table of hits holds, in place, likewise.
class HitViews {
 public:
  explicit HitViews(const HitTable& table)
      : t(table.t.data(), rows(table.t.size())),
        surfaces(table.surfaces.data(), rows(table.surfaces.size())),
        is_entry(table.is_entry.data(), rows(table.is_entry.size())) {}
  explicit HitViews(HitTable&&) = delete;

  Eigen::Map<const Eigen::VectorXd> t;                                         ///< (rays); infinity without a hit
  Eigen::Map<const Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 1>> surfaces;  ///< (rays); no_id without a hit
  Eigen::Map<const Eigen::Matrix<std::uint8_t, Eigen::Dynamic, 1>> is_entry;   ///< (rays); 1 or 0

 private:
  static Eigen::Index rows(std::size_t count) { return static_cast<Eigen::Index>(count); }
};

/// The places at t along rays: origins + t directions, row by row. All are of as many rows.
inline TripleRows points_at(const Eigen::Ref<const TripleRows>& origins, const Eigen::Ref<const TripleRows>& directions,
                            const Eigen::Ref<const Eigen::VectorXd>& t) {
  if (origins.rows() != directions.rows() || origins.rows() != t.rows()) {
    throw Error(ErrorCode::usage, {}, "origins, directions and t are not as many", "each ray has one of each",
                "give matrices of as many rows");
  }
  return origins + t.asDiagonal() * directions;
}

}  // namespace csgcast
