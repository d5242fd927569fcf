// SPDX-License-Identifier: MIT
// Records what the rays of a packet meet on their way. Compiled once for each instruction set, by lanes.cpp.
#if defined(CSGCAST_LANE_LOG_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_LOG_INL_H
#undef CSGCAST_LANE_LOG_INL_H
#else
#define CSGCAST_LANE_LOG_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raycast/packets/detail/lane_line-inl.h"
#include "raycast/packets/detail/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// The ends of intervals that a packet's rays met, in order. Each row has what some of its lanes met at the same time.
template <class D>
class EndLog {
 public:
  using Bits = BitsOf<D>;

  EndLog() : lanes_(hn::Lanes(D())) { reserve(64); }

  void clear() { rows_ = 0; }

  /// `where` has the SurfaceId in its low bits and Crossing::root above. `face` has its leaf in the low bits and its
  /// look above.
  HWY_INLINE void add(hn::Mask<D> lanes, hn::Vec<D> t, hn::Vec<Bits> where, hn::Vec<Bits> face) {
    const D d;
    if (rows_ == masks_.size()) reserve(2 * rows_);
    hn::StoreU(face, Bits(), face_.data() + rows_ * lanes_);
    hn::StoreU(t, d, t_.data() + rows_ * lanes_);
    hn::StoreU(where, Bits(), where_.data() + rows_ * lanes_);
    masks_[rows_++] = static_cast<std::uint8_t>(lane_bits(d, lanes));
  }

  /// Sets the normals of the row that was added last.
  HWY_INLINE void set_normals(const Triples<hn::Vec<D>>& normals) {
    const D d;
    if (normal_.size() < 3 * t_.size()) normal_.resize(3 * t_.size());
    double* const to = normal_.data() + 3 * lanes_ * (rows_ - 1);
    hn::StoreU(normals.x, d, to);
    hn::StoreU(normals.y, d, to + lanes_);
    hn::StoreU(normals.z, d, to + 2 * lanes_);
  }

  std::size_t rows() const { return rows_; }
  unsigned mask(std::size_t row) const { return masks_[row]; }
  Crossing at(std::size_t row, std::size_t lane) const {
    const std::uint64_t where = where_[row * lanes_ + lane];
    return {t_[row * lanes_ + lane], SurfaceId(static_cast<std::uint32_t>(where)),
            static_cast<std::uint8_t>(where >> 32)};
  }
  EndFace face_at(std::size_t row, std::size_t lane) const {
    const std::uint64_t face = face_[row * lanes_ + lane];
    return {LeafId(static_cast<std::uint32_t>(face)), LookId(static_cast<std::uint32_t>(face >> 32))};
  }
  Normal normal_at(std::size_t row, std::size_t lane) const {
    const double* const normals = normal_.data() + 3 * lanes_ * row + lane;
    return {normals[0], normals[lanes_], normals[2 * lanes_]};
  }

 private:
  void reserve(std::size_t rows) {
    t_.resize(rows * lanes_);
    where_.resize(rows * lanes_);
    face_.resize(rows * lanes_);
    masks_.resize(rows);
  }

  std::size_t lanes_;
  std::size_t rows_ = 0;
  std::vector<double> t_;
  std::vector<std::uint64_t> where_;
  std::vector<std::uint64_t> face_;
  std::vector<double> normal_;  // empty until some are set
  std::vector<std::uint8_t> masks_;
};

/// The same for one ray. Ends are written directly to where they are wanted: behind the intervals of the rays before
/// it.
template <>
class EndLog<hn::Single<double>> {
 public:
  /// `start` is the t at which rays begin that start inside.
  EndLog(const LaneLists& lists, double start)
      : intervals_(*lists.intervals),
        faces_(lists.faces),
        start_(start),
        base_(2 * intervals_.size()),
        first_(base_),
        next_(base_) {
    make_room();
  }
  EndLog(const EndLog&) = delete;
  EndLog& operator=(const EndLog&) = delete;
  /// Removes what was not kept.
  ~EndLog() {
    intervals_.resize(first_ / 2);
    if (faces_ != nullptr) faces_->resize(first_);
  }

  /// Forgets what the ray met.
  void clear() { next_ = first_; }
  /// Keeps what the ray met; the next ray is added behind it. Returns the number of intervals.
  std::size_t keep() {
    first_ = next_;
    return first_ / 2;
  }

  HWY_INLINE void add(bool, double t, std::uint64_t where, std::uint64_t face) {
    if (faces_ != nullptr)
      (*faces_)[next_] = {LeafId(static_cast<std::uint32_t>(face)), LookId(static_cast<std::uint32_t>(face >> 32))};
    set(t, SurfaceId(static_cast<std::uint32_t>(where)), static_cast<std::uint8_t>(where >> 32));
  }
  HWY_INLINE void set_normals(const Triples<double>& normal) {
    (*faces_)[next_ - 1].normal = {normal.x, normal.y, normal.z};
  }
  void add_start() {
    if (faces_ != nullptr) (*faces_)[next_] = {};
    set(start_, {}, 0);
  }
  void add_end(double t) {
    if (faces_ != nullptr) (*faces_)[next_] = {};
    set(t, {}, 1);
  }

 private:
  HWY_INLINE void set(double t, SurfaceId surface, std::uint8_t root) {
    Interval& interval = room_[next_ / 2];
    (next_ % 2 == 0 ? interval.entry : interval.exit) = {t, surface, root};
    if (++next_ == size_) make_room();
  }
  HWY_NOINLINE void make_room() {
    intervals_.resize(next_ / 2 + (next_ - base_) / 2 + 64);
    size_ = 2 * intervals_.size();
    room_ = intervals_.data();
    if (faces_ != nullptr) faces_->resize(size_);
  }

  IntervalList& intervals_;
  std::vector<EndFace>* faces_;
  double start_;
  std::size_t base_;   // the number of ends before all of these rays
  std::size_t first_;  // the number of ends before the present ray
  std::size_t next_;
  std::size_t size_ = 0;  // the number of ends for which there is room
  Interval* room_ = nullptr;
};

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
