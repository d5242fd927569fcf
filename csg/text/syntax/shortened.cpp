// SPDX-License-Identifier: MIT
#include "csg/text/syntax/shortened.h"

namespace csgcast::text {

std::string shortened(std::string_view word) {
  constexpr std::size_t longest = 40;
  if (word.size() <= longest) return std::string(word);
  const auto continues = [&](std::size_t i) { return (static_cast<unsigned char>(word[i]) & 0xc0) == 0x80; };
  std::size_t end = longest;
  for (int i = 0; i < 3 && continues(end); ++i) --end;  // a character has three bytes at most after its first
  return std::string(word.substr(0, end)) + "...";
}

}  // namespace csgcast::text
