// SPDX-License-Identifier: MIT
#pragma once

// Catch2 moved its headers from version 2 to 3; the tests include this one instead.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
