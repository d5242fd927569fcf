// SPDX-License-Identifier: MIT
#pragma once

namespace csgcast::cli {

/// Asks for huge pages where the program will need much memory: a large scene touches tens of thousands of small ones,
/// each of which stops it for a microsecond, or ten on a virtual machine. Linking this replaces the global operator new
/// as well, for blocks of 4 MiB and more. What the system does not give is done without. To be called before the memory
/// is asked for.
void use_huge_pages();

}  // namespace csgcast::cli
