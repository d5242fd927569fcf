// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace csgcast {

struct QuadricForm;

/// A form in as few bytes as its numbers take, for keeping: a ball's takes 60, where a QuadricForm takes 320. Equal
/// forms have equal bytes.
class PackedForm {
 public:
  PackedForm() = default;  ///< no form; only to be assigned to
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

  // Owned: how many follow (a std::uint32_t), then the coefficients, packed, in order. Null: no form.
  std::byte* bytes_ = nullptr;
};

}  // namespace csgcast
