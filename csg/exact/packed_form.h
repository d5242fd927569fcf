// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "csg/exact/quadric_form.h"

namespace csgcast {

/// A form in as few bytes as its numbers take, for keeping: a ball's takes 60, where a QuadricForm takes 320. Equal
/// forms have equal bytes.
class PackedForm {
 public:
  PackedForm() = default;  ///< no form; only to be assigned to
  explicit PackedForm(const QuadricForm& form);
  PackedForm(const PackedForm& other);
  PackedForm(PackedForm&& other) noexcept = default;
  PackedForm& operator=(const PackedForm& other);
  PackedForm& operator=(PackedForm&& other) noexcept = default;
  ~PackedForm() = default;

  QuadricForm unpacked() const;
  std::uint64_t hash() const;
  friend bool operator==(const PackedForm& a, const PackedForm& b);

 private:
  explicit PackedForm(std::span<const std::byte> content);
  std::span<const std::byte> content() const;

  std::unique_ptr<std::byte[]> bytes_;  // how many follow (a std::uint32_t), then the coefficients, packed, in order
};

}  // namespace csgcast
