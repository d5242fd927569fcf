// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "csg/exact/affine.h"

namespace csgcast {

/// The exact form f of a surface f = 0 that is neither a plane nor a quadric. Its class says what f is; the kind of
/// surface that takes it (raycast/surface/kind.h) knows the class. Immutable: solids, scenes and threads share it.
class OtherForm {
 public:
  virtual ~OtherForm() = default;

  /// A form g such that g(world_from_solid(p)) has the sign of f(p) for every p. Precondition: world_from_solid is not
  /// singular.
  virtual std::shared_ptr<const OtherForm> moved(const ExactAffine& world_from_solid) const = 0;

  /// The form that represents all multiples of f.
  struct Canonical {
    std::shared_ptr<const OtherForm> form;
    bool flipped = false;  ///< true if the factor was negative: f <= 0 is where the canonical form is >= 0
  };
  virtual Canonical canonical() const = 0;

  /// True if two canonical forms are equal. Forms of different classes are not equal.
  virtual bool equals(const OtherForm& other) const = 0;
  /// The hash is equal for equal forms.
  virtual std::uint64_t hash() const = 0;
};

}  // namespace csgcast
