// SPDX-License-Identifier: MIT
// What the rays of a packet met on their way. Compiled once for each instruction set; included by lanes.cpp only.
#if defined(CSGCAST_LANE_LOG_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_LOG_INL_H
#undef CSGCAST_LANE_LOG_INL_H
#else
#define CSGCAST_LANE_LOG_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// The ends of intervals that a packet's rays met, in order: each row is what some of its lanes met at once.
template <class D>
class EndLog {
 public:
  using Bits = BitsOf<D>;

  EndLog() : lanes_(hn::Lanes(D())) { reserve(64); }

  void clear() { rows_ = 0; }

  /// `where`: SurfaceId below, Crossing::root above. `face`: its leaf below, its look above.
  HWY_INLINE void add(hn::Mask<D> lanes, hn::Vec<D> t, hn::Vec<Bits> where, hn::Vec<Bits> face) {
    const D d;
    if (rows_ == masks_.size()) reserve(2 * rows_);
    hn::StoreU(face, Bits(), face_.data() + rows_ * lanes_);
    hn::StoreU(t, d, t_.data() + rows_ * lanes_);
    hn::StoreU(where, Bits(), where_.data() + rows_ * lanes_);
    std::uint8_t mask[8];
    hn::StoreMaskBits(d, lanes, mask);
    masks_[rows_++] = mask[0];
  }

  /// Of the row that was added last.
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
  std::vector<double> normal_;  // once some are set
  std::vector<std::uint8_t> masks_;
};

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
