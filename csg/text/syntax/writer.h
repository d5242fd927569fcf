// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "csg/text/syntax/syntax.h"

namespace csgcast::text {

/// The document as scene text in OpenSCAD's own layout, numbers so that they read back to the same double:
/// read(write(d)) == d.
std::string write(const Document& document);

}  // namespace csgcast::text
