// SPDX-License-Identifier: GPL-3.0-or-later
// The main function of every test program; compiled once because Catch2 2 takes long to compile.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
