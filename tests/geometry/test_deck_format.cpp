// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/decks/deck_format.h"

#include "temporary_folder.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

TEST_CASE("solvers and systems of units have names", "[decks]")
{
  for (const std::string& name : deck_format_names())
    CHECK(deck_extension(deck_format(name)).starts_with("."));
  CHECK(test::input_error([] { deck_format("nastran"); }) ==
        "no deck is known for a solver \"nastran\"; known are dyna, radioss and abaqus");
  CHECK(test::input_error([] { deck_units("furlong"); }).find("kg-m-s, t-mm-s, kg-mm-ms") !=
        std::string::npos);
}

TEST_CASE("systems of units are coherent and of the size that their names say", "[decks]")
{
  CHECK(deck_units("t-mm-s").pressure() == Approx(1e6));
  CHECK(deck_units("kg-mm-ms").pressure() == Approx(1e9));
  CHECK(deck_units("g-mm-ms").pressure() == Approx(1e6));
  CHECK(deck_units("g-cm-us").pressure() == Approx(1e11)); // 1 Mbar
  CHECK(deck_units("lbf-s2/in-in-s").pressure() == Approx(6894.757293));
  CHECK(deck_units("slug-ft-s").pressure() == Approx(47.88025898));
  CHECK(deck_units("slug-ft-s").mass == Approx(14.59390294));
  CHECK(deck_units("t-mm-s").density() == Approx(1e12));
  CHECK(deck_units("kg-mm-ms").velocity() == Approx(1));
  // Mass x velocity^2 = pressure x volume, whatever the system.
  for (const DeckUnits& u : deck_unit_systems())
    CHECK(u.mass * u.velocity() * u.velocity() == Approx(u.pressure() * u.length * u.length * u.length));
}
