// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace csgcast {

struct QuadricForm;

/// A form for storage, in as few bytes as its numbers take. A ball's form takes 60 bytes, where a QuadricForm takes
/// 320. Equal forms have equal bytes.
class PackedForm {
 public:
  PackedForm() = default;  ///< no form; it can only be assigned to
  explicit PackedForm(const QuadricForm& form);
  PackedForm(const PackedForm& other);
  PackedForm(PackedForm&& other) noexcept : bytes_(std::exchange(other.bytes_, nullptr)) {}
  PackedForm& operator=(PackedForm other) noexcept {
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  ~PackedForm() { delete[] bytes_; }

  /// Precondition: there is a form.
  QuadricForm unpacked() const;
  std::uint64_t hash() const;
  friend bool operator==(const PackedForm& a, const PackedForm& b);

 private:
  explicit PackedForm(std::span<const std::byte> content);
  std::span<const std::byte> content() const;

  // Owned memory: the number of bytes (a std::uint32_t), then the packed coefficients in order. Null if there is no
  // form.
  std::byte* bytes_ = nullptr;
};

}  // namespace csgcast
