// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/packets/detail/ray_pointers.h"
#include "raycast/packets/packet_caster.h"

namespace csgcast {

struct PacketCaster::RayPointers : detail::RayPointers {};
struct PacketCaster::FacePointers : detail::FacePointers {};

}  // namespace csgcast
