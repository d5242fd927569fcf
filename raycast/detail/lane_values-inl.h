// SPDX-License-Identifier: MIT
// What a cell with more surfaces than a table holds comes to. Compiled once for each instruction set; included by
// lanes.cpp only.
#if defined(CSGCAST_LANE_VALUES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGCAST_LANE_VALUES_INL_H
#undef CSGCAST_LANE_VALUES_INL_H
#else
#define CSGCAST_LANE_VALUES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace csgcast::detail {
namespace HWY_NAMESPACE {

/// The value in a state, by the cell's steps.
template <class D>
hn::Mask<BitsOf<D>> value_by_steps(D, const CellData& cells, const Cell& cell, hn::Vec<BitsOf<D>> state) {
  using Bits = BitsOf<D>;
  using U = hn::Vec<Bits>;
  const Bits bits;
  hn::Mask<Bits> stack[Cell::most_operands];
  std::size_t height = 0;
  for (std::size_t i = 0; i < cell.step_count; ++i) {
    const Step& step = cells.steps[cell.first_step + i];
    if (step.op == Step::Op::leaf) {
      const U off = hn::And(hn::Xor(state, hn::Set(bits, step.want)), hn::Set(bits, step.mask));
      stack[height++] = hn::Eq(off, hn::Zero(bits));
      continue;
    }
    if (step.op == Step::Op::complement) {
      stack[height - 1] = hn::Not(stack[height - 1]);
      continue;
    }
    --height;
    hn::Mask<Bits>& left = stack[height - 1];
    const hn::Mask<Bits> right = stack[height];
    left = step.op == Step::Op::unite       ? hn::Or(left, right)
           : step.op == Step::Op::intersect ? hn::And(left, right)
                                            : hn::AndNot(right, left);
  }
  return stack[0];
}

}  // namespace HWY_NAMESPACE
}  // namespace csgcast::detail
HWY_AFTER_NAMESPACE();
#endif
