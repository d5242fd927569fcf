// SPDX-License-Identifier: MIT
#include "csg/exact/packed_form.h"

#include <cstdint>
#include <random>

#include "csg/exact/form_list.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

// Numbers of all lengths, from one bit to some hundred, of both signs, and zeros.
Dyadic any_number(std::mt19937_64& random) {
  Dyadic number(static_cast<double>(random() >> (random() % 64)));
  for (std::uint64_t i = random() % 5; i > 0; --i) number *= Dyadic(static_cast<double>(random()));
  const auto shift = static_cast<std::int64_t>(random() % 4000) - 2000;
  return (random() % 2 == 0 ? number : -number).scaled(shift);
}

QuadricForm any_form(std::mt19937_64& random) {
  QuadricForm form;
  for (Dyadic& c : form.coefficient) {
    if (random() % 3 != 0) c = any_number(random);
  }
  return form;
}

}  // namespace

TEST_CASE("a packed form unpacks to the same form, and equal forms have equal hashes") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const QuadricForm form = any_form(random);
    const PackedForm packed(form);
    CHECK(packed.unpacked() == form);
    PackedForm copy;
    copy = packed;
    CHECK(copy == packed);
    CHECK(copy.hash() == packed.hash());
    CHECK(copy.unpacked() == form);
    QuadricForm other = form;
    other.coefficient[random() % other.coefficient.size()] += Dyadic(1.0).scaled(-3000);
    other.coefficient[random() % other.coefficient.size()] += Dyadic(1.0);
    CHECK_FALSE(PackedForm(other) == packed);
  }
}

TEST_CASE("a mantissa at the limit of what a number keeps in itself is packed whole") {
  for (const int bits : {1, 53, 63, 64, 65, 119, 120, 121, 126, 127, 128, 129, 200}) {
    const Dyadic largest = Dyadic(mpz_class((mpz_class(1) << static_cast<mp_bitcnt_t>(bits)) - 1), -7);
    for (const Dyadic& number : {largest, -largest}) {
      QuadricForm form;
      form.coefficient[QuadricForm::xy] = number;
      const Dyadic unpacked = PackedForm(form).unpacked().coefficient[QuadricForm::xy];
      CHECK(unpacked == number);
      CHECK((unpacked * number).sign() == 1);
    }
  }
}

TEST_CASE("a list of forms hands out what was put in") {
  std::mt19937_64 random(2);
  std::vector<QuadricForm> forms;
  FormList list;
  CHECK(list.empty());
  for (int i = 0; i < 20; ++i) {
    forms.push_back(any_form(random));
    list.push_back(forms.back());
  }
  REQUIRE(list.size() == forms.size());
  CHECK(list.front() == forms.front());
  std::size_t i = 0;
  for (const QuadricForm& form : list) {
    CHECK(form == forms[i]);
    CHECK(list[i] == forms[i]);
    ++i;
  }
}
