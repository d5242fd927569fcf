// SPDX-License-Identifier: MIT
#pragma once

namespace csgcast::detail {

/// What program and module for pictures must agree on: it differs where PictureModule does.
constexpr const char* module_version = CSGCAST_VERSION " pictures 1";

}  // namespace csgcast::detail
