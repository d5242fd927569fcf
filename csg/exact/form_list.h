// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <iterator>
#include <vector>

#include "csg/exact/packed_form.h"
#include "csg/exact/quadric_form.h"

namespace csgcast {

/// An ordered list of forms. They are stored packed and returned by value.
class FormList {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = QuadricForm;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = QuadricForm;

    explicit Iterator(std::vector<PackedForm>::const_iterator at) : at_(at) {}
    QuadricForm operator*() const { return at_->unpacked(); }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    Iterator operator++(int) { return Iterator(at_++); }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    std::vector<PackedForm>::const_iterator at_;
  };

  void push_back(const QuadricForm& form) { forms_.emplace_back(form); }
  void reserve(std::size_t count) { forms_.reserve(count); }
  std::size_t size() const { return forms_.size(); }
  bool empty() const { return forms_.empty(); }
  QuadricForm operator[](std::size_t index) const { return forms_[index].unpacked(); }
  QuadricForm front() const { return forms_.front().unpacked(); }
  Iterator begin() const { return Iterator(forms_.begin()); }
  Iterator end() const { return Iterator(forms_.end()); }

 private:
  std::vector<PackedForm> forms_;
};

}  // namespace csgcast
