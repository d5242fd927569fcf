// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>

namespace csgcast {

/// Base of values that Shared owns: it counts the owners.
class Counted {
 public:
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;

 protected:
  Counted() = default;
  virtual ~Counted() = default;

 private:
  template <class T>
  friend class Shared;

  void add_owner();
  void drop_owner();  // deletes the value if that was the last one
  bool has_one_owner() const;

  std::size_t owners_ = 1;  // read and written atomically
};

/// One of the owners of a value that does not change, or of no value. The last owner deletes the value. Any thread may
/// make and drop copies. T derives from Counted. Where T is incomplete, the value cannot be accessed.
template <class T>
class Shared {
 public:
  Shared() = default;
  Shared(const Shared& other) : value_(other.value_) {
    if (value_ != nullptr) value_->add_owner();
  }
  Shared(Shared&& other) noexcept : value_(std::exchange(other.value_, nullptr)) {}
  Shared& operator=(Shared other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~Shared() {
    if (value_ != nullptr) value_->drop_owner();
  }

  /// Makes a new value, of T or of a class derived from it, and returns its first owner.
  template <class Value = T, class... Arguments>
  static Shared make(Arguments&&... arguments) {
    Shared made;
    made.value_ = new Value(std::forward<Arguments>(arguments)...);
    return made;
  }

  explicit operator bool() const { return value_ != nullptr; }
  /// Precondition: there is a value.
  const T& operator*() const { return static_cast<const T&>(*value_); }
  const T* operator->() const { return &**this; }
  /// The value if this is its only owner, who alone may change it. Otherwise null.
  T* if_only_owner() const {
    return value_ != nullptr && value_->has_one_owner() ? &static_cast<T&>(*value_) : nullptr;
  }
  /// True for the same value, not for an equal one.
  friend bool operator==(const Shared&, const Shared&) = default;

 private:
  Counted* value_ = nullptr;
};

}  // namespace csgcast
