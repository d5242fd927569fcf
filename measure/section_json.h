// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "measure/section.h"

namespace csgcast {

/// A section as a JSON object, as `csgcast section` writes it (docs/cli.md): every number reads back to the same
/// double; null stands for what is not finite.
std::string section_json(const Section& section);

}  // namespace csgcast
