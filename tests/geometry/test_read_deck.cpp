// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/decks/read_deck.h"

#include "core/error.h"
#include "deck_samples.h"
#include "geometry/decks/write_deck.h"
#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <random>

using namespace birdstrike;
using namespace birdstrike::test;
using namespace birdstrike::test::decks;

namespace {

DeckBird there_and_back(const TemporaryFolder& folder, const Particles& bird, const DeckOptions& options)
{
  const auto files = write_deck(bird, options, folder / ("bird" + deck_extension(options.format)));
  return read_deck(files[0]);
}

void check_same(const DeckBird& read, const Particles& bird, const DeckOptions& options)
{
  REQUIRE(read.size() == bird.size());
  CHECK(read.format == options.format);
  CHECK(read.units == options.units);
  REQUIRE(read.part_names.size() == bird.parts.size());
  for (std::size_t k = 0; k < bird.parts.size(); ++k) {
    CHECK(read.part_names[k] == bird.parts[k].name);
    CHECK(read.part_density[k] == Approx(reference_density(bird.parts[k].eos)).epsilon(1e-4));
  }
  const std::vector<std::int32_t> row = bird.row_of_id();
  std::vector<Vector3> position;
  double length = 0, speed = 0;
  for (std::size_t i = 0; i < bird.size(); ++i) {
    position.push_back(bird.position(i));
    length = std::max(length, bird.position(i).norm());
    speed = std::max(speed, bird.velocity(i).norm());
  }
  for (std::size_t id = 0; id < bird.size(); ++id) {
    const auto i = static_cast<std::size_t>(row[id]);
    REQUIRE(read.id[id] == options.first_id + static_cast<std::int64_t>(id));
    REQUIRE(read.part[id] == bird.part[i]);
    REQUIRE(read.mass[id] == Approx(bird.mass[i]).epsilon(2e-9));
    REQUIRE((read.position[id] - bird.position(i)).norm() <= 2e-9 * length);
    REQUIRE((read.velocity[id] - bird.velocity(i)).norm() <= 1e-5 * speed);
  }
  double mass = 0;
  for (const double m : read.mass)
    mass += m;
  CHECK(mass == Approx(total_mass(bird)).epsilon(1e-9));
  CHECK((centre_of_mass(read.position, read.mass) - centre_of_mass(position, bird.mass)).norm() <
        1e-9 * length);
}

std::string complaint(const std::filesystem::path& file, const std::string& units = "")
{
  return input_error([&] { read_deck(file, units); });
}

} // namespace

TEST_CASE("every particle comes back from a deck, in each format and system of units", "[decks]")
{
  const TemporaryFolder folder;
  const Particles bird = sample_bird(6);
  for (const std::string& format : deck_format_names())
    for (const std::string& units : deck_unit_names()) {
      INFO(format << ", " << units);
      DeckOptions options;
      options.format = deck_format(format);
      options.units = units;
      check_same(there_and_back(folder, bird, options), bird, options);
    }
}

TEST_CASE("numbers of nodes and parts start where they are told", "[decks]")
{
  const TemporaryFolder folder;
  const Particles bird = sample_bird(4);
  for (const std::string& format : deck_format_names()) {
    DeckOptions options;
    options.format = deck_format(format);
    options.first_id = 5000001;
    options.first_part = 71;
    check_same(there_and_back(folder, bird, options), bird, options);
  }
}

TEST_CASE("masses and velocities that differ come back", "[decks]")
{
  const TemporaryFolder folder;
  Particles bird = sample_bird(5);
  for (std::size_t i = 0; i < bird.size(); ++i) {
    bird.mass[i] *= 1 + 0.01 * static_cast<double>(i % 7);
    bird.vx[i] += static_cast<double>(i % 3);
    bird.vz[i] -= 0.25 * static_cast<double>(i % 2);
  }
  for (const std::string& format : deck_format_names()) {
    INFO(format);
    DeckOptions options;
    options.format = deck_format(format);
    check_same(there_and_back(folder, bird, options), bird, options);
  }
}

TEST_CASE("names that a solver would not take are changed into some that it does", "[decks]")
{
  const TemporaryFolder folder;
  Particles bird = sample_bird(4);
  const char* names[] = {"*left wing", "1st leg", "Fl\xc3\xbcgel", "*LEFT WING"};
  for (std::size_t k = 0; k < 4; ++k)
    bird.parts[k].name = names[k];
  for (const std::string& format : deck_format_names()) {
    DeckOptions options;
    options.format = deck_format(format);
    options.title = "*title\nof two lines";
    const DeckBird read = there_and_back(folder, bird, options);
    CHECK(read.size() == bird.size());
    REQUIRE(read.part_names.size() == 4);
    CHECK(read.part_names[0] == (format == "abaqus" ? "P___left_wing" : "_*left wing"));
    CHECK(read.part_names[2] == "Fl__gel");
    CHECK(read.part_names[3] != read.part_names[0]);
  }
}

TEST_CASE("decks of other hands: commas, volumes, titles and other elements", "[decks]")
{
  const TemporaryFolder folder;
  const auto dyna = folder.write("a.k", R"($ before the deck
*KEYWORD
*NODE
7,0.0,1.0,2.0
8,3.0,4.0,5.0
       9             6.0             7.0             8.0
*ELEMENT_SHELL
       1       1       7       8       9       9
*ELEMENT_SPH
       7       3         -2.0E-9
8, 3, 0.5
*PART
gel
         3         1         5         5
*MAT_NULL_TITLE
a title
         5 9.50E+02
*INITIAL_VELOCITY_GENERATION
         3         2       0.0      10.0       0.0       0.0
*END
)");
  const DeckBird bird = read_deck(dyna, "kg-m-s");
  REQUIRE(bird.size() == 2);
  CHECK(bird.mass[0] == Approx(950 * 2e-9));
  CHECK(bird.mass[1] == 0.5);
  CHECK(bird.position[1] == Vector3(3, 4, 5));
  CHECK(bird.velocity[1] == Vector3(10, 0, 0));
  CHECK(bird.part_names == std::vector<std::string>{"gel"});
  CHECK(bird.part_density[0] == 950);
  CHECK(complaint(dyna).find("does not say its units; give them, one of kg-m-s") != std::string::npos);
  CHECK(complaint(dyna, "ell").find("no system of units \"ell\"") != std::string::npos);

  const auto radioss = folder.write("b_0000.rad", R"(#RADIOSS STARTER
/BEGIN
b
      2019         0
                   g                  cm                 mus
                   g                  cm                 mus
/NODE
         1                  1.                  2.                  3.
/PROP/SPH/2
cells
                 0.5                   2                   1                   0         0
/MAT/HYDRO/4
gel
                 .95
/PART/9
gel
         2         4
/SPHCEL/9
         1
/END
)");
  const DeckBird cell = read_deck(radioss);
  REQUIRE(cell.size() == 1);
  CHECK(cell.units == "g-cm-us");
  CHECK(cell.mass[0] == Approx(5e-4));
  CHECK(cell.position[0].isApprox(Vector3(0.01, 0.02, 0.03)));
  CHECK(cell.part_density[0] == Approx(950));

  const auto abaqus = folder.write("c.inp", R"(*Heading
 a bird
** unit system: kg-m-s
*Node
 5, 1., 0., 0.
*Element, type=PC3D, elset=Gel
 5, 5
*Solid Section, elset=GEL, material="my gel"
 0.005,
*Material, name="My Gel"
*Density
 950.,
)");
  const DeckBird gel = read_deck(abaqus);
  REQUIRE(gel.size() == 1);
  CHECK(gel.mass[0] == Approx(950e-6));
  CHECK(gel.part_names[0] == "Gel");
  CHECK(gel.velocity[0] == Vector3(0, 0, 0));
}

TEST_CASE("decks that cannot be read say why and where", "[decks]")
{
  const TemporaryFolder folder;
  const auto dyna = [&](const std::string& body) {
    return complaint(folder.write("bad.k", "*KEYWORD\n$ unit system: t-mm-s\n" + body + "*END\n"));
  };
  CHECK(complaint(folder / "none.k").find("does not exist") != std::string::npos);
  CHECK(complaint(folder.write("empty.k", "")).find("deck file") != std::string::npos);
  CHECK(complaint(folder.write("binary.k", std::string("*KEY\0WORD", 9))).find("is not text") !=
        std::string::npos);
  CHECK(complaint(folder.write("mesh.obj", "v 0 0 0\n")).find("is none of LS-DYNA") != std::string::npos);
  CHECK(dyna("*NODE\n").find("no SPH particles") != std::string::npos);
  CHECK(dyna("*NODE\n       1             1.0             x.0             0.0\n")
            .find("line 4: a coordinate is 'x.0' and should be a number") != std::string::npos);
  CHECK(dyna("*ELEMENT_SPH\n       1       1          1.0E-9\n").find("particle 1 has no node") !=
        std::string::npos);
  CHECK(dyna("*NODE\n       1             1.0             1.0             0.0\n"
             "       1             1.0             1.0             0.0\n")
            .find("line 5: node 1 comes a second time") != std::string::npos);
  CHECK(dyna("*NODE\n       1             1.0             1.0             0.0\n"
             "*ELEMENT_SPH\n       1       1          1.0E-9\n       1       1          1.0E-9\n")
            .find("particle 1 comes a second time") != std::string::npos);
  CHECK(dyna("*ELEMENT_SPH\n       1       1          1.0E-9         9\n").find("from one node to another") !=
        std::string::npos);
  CHECK(dyna("*INCLUDE\nother.k\n").find("*INCLUDE is not followed") != std::string::npos);
  CHECK(complaint(folder.write("long.k", "*KEYWORD LONG=Y\n*END\n")).find("long format") !=
        std::string::npos);
  CHECK(complaint(folder.write("unit_0000.rad",
                               "#RADIOSS STARTER\n/BEGIN\nunit\n      2022         0\n"
                               "                  lb                   m                   s\n"))
            .find("line 5: the unit 'lb' of /BEGIN is not known") != std::string::npos);
  CHECK(
      complaint(folder.write("mass.inp", "*HEADING\n** unit system: t-mm-s\n*NODE, NSET=A\n1, 0.0, 0.0, 0.0\n"
                                         "*ELEMENT, TYPE=PC3D, ELSET=B\n1, 1\n"))
          .find("have no *SOLID SECTION") != std::string::npos);
}

TEST_CASE("a deck that is cut anywhere or damaged is an error or a smaller bird, never a crash", "[decks]")
{
  const TemporaryFolder folder;
  const Particles bird = sample_bird(3);
  std::mt19937 random(11);
  for (const std::string& format : deck_format_names()) {
    DeckOptions options;
    options.format = deck_format(format);
    const auto file = write_deck(bird, options, folder / ("bird" + deck_extension(options.format)))[0];
    const std::string whole = text_of(file);
    int errors = 0;
    for (int i = 0; i < 150; ++i) {
      std::string text = whole;
      if (i % 2 == 0)
        text.resize(random() % whole.size());
      else
        for (int k = 0; k < 5; ++k)
          text[random() % text.size()] = static_cast<char>(' ' + random() % 95);
      const auto damaged = folder.write("damaged.txt", text);
      try {
        const std::size_t read =
            read_deck(damaged).size(); // apart: CHECK would take the exception for a failure
        CHECK(read <= bird.size());
      } catch (const InputError& error) {
        ++errors;
        CHECK(std::string(error.what()).find("deck file") != std::string::npos);
      }
    }
    CHECK(errors > 40);
  }
}
