// SPDX-License-Identifier: MIT
#include "csg/exact/packed_form.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "csg/exact/quadric_form.h"

namespace csgcast {
namespace {

using Count = std::uint32_t;
constexpr std::size_t usual_size = 128;

std::vector<std::byte> packed(const QuadricForm& form) {
  std::vector<std::byte> bytes;
  bytes.reserve(usual_size);
  for (const Dyadic& c : form.coefficient) c.pack(bytes);
  return bytes;
}

}  // namespace

PackedForm::PackedForm(const QuadricForm& form) : PackedForm(packed(form)) {}

PackedForm::PackedForm(std::span<const std::byte> content) : bytes_(new std::byte[sizeof(Count) + content.size()]) {
  const auto count = static_cast<Count>(content.size());
  std::memcpy(bytes_, &count, sizeof count);
  std::memcpy(bytes_ + sizeof count, content.data(), content.size());
}

PackedForm::PackedForm(const PackedForm& other) {
  if (other.bytes_ != nullptr) *this = PackedForm(other.content());
}

std::span<const std::byte> PackedForm::content() const {
  Count count = 0;
  std::memcpy(&count, bytes_, sizeof count);
  return {bytes_ + sizeof count, count};
}

QuadricForm PackedForm::unpacked() const {
  QuadricForm form;
  const std::byte* bytes = content().data();
  for (Dyadic& c : form.coefficient) c = Dyadic::unpack(bytes);
  return form;
}

// The hash is FNV-1a with one word in each step, and a final mix.
std::uint64_t PackedForm::hash() const {
  const std::span<const std::byte> bytes = content();
  std::uint64_t h = 0xcbf29ce484222325u ^ bytes.size();
  for (std::size_t i = 0; i < bytes.size(); i += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, &bytes[i], std::min(sizeof word, bytes.size() - i));
    h = (h ^ word) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return h;
}

bool operator==(const PackedForm& a, const PackedForm& b) {
  const auto x = a.content(), y = b.content();
  return std::equal(x.begin(), x.end(), y.begin(), y.end());
}

}  // namespace csgcast
