// SPDX-License-Identifier: MIT
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <type_traits>

namespace csgcast::bench {

struct ReleaseEmbree {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

/// An Embree device or scene that is released with its owner.
template <class Handle>
using OwnedEmbree = std::unique_ptr<std::remove_pointer_t<Handle>, ReleaseEmbree>;

}  // namespace csgcast::bench
