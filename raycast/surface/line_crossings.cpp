// SPDX-License-Identifier: MIT
#include "raycast/surface/line_crossings.h"

#include <algorithm>

#include "raycast/surface/detail/line_memory.h"

namespace csgcast {

LineMemory::LineMemory() : state_(std::make_unique<State>()) {}
LineMemory::~LineMemory() = default;
LineMemory::LineMemory(LineMemory&&) noexcept = default;

void LineMemory::forget() {
  state_->exact.forget();
  state_->block = state_->used = 0;
}

std::span<double> LineMemory::room_for(std::size_t count) {
  constexpr std::size_t block_size = 256;
  State& state = *state_;
  while (state.block < state.blocks.size() && state.blocks[state.block].size() - state.used < count) {
    ++state.block;
    state.used = 0;
  }
  if (state.block == state.blocks.size()) state.blocks.emplace_back(std::max(block_size, count));
  const std::span<double> room = std::span(state.blocks[state.block]).subspan(state.used, count);
  state.used += count;
  return room;
}

}  // namespace csgcast
