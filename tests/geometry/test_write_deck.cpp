// SPDX-License-Identifier: GPL-3.0-or-later
// Fields are looked up where the manuals have them, in columns counted from 1.
#include "geometry/decks/write_deck.h"

#include "core/error.h"
#include "core/theory/impact_pressures.h"
#include "deck_samples.h"
#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <map>

using namespace birdstrike;
using namespace birdstrike::test;
using namespace birdstrike::test::decks;

namespace {

const std::filesystem::path golden = std::filesystem::path(BIRDSTRIKE_SOURCE_DIR) / "tests/data/decks";

DeckOptions options_of(const std::string& format, const std::string& units = "t-mm-s")
{
  DeckOptions options;
  options.format = deck_format(format);
  options.units = units;
  options.title = "Small bird of four laws";
  options.source = "tests/geometry/deck_samples.h";
  return options;
}

std::vector<std::string> deck_lines(const TemporaryFolder& folder, const DeckOptions& options,
                                    const Particles& bird = sample_bird())
{
  return lines_of(write_deck(bird, options, folder / ("bird" + deck_extension(options.format)))[0]);
}

//! Pressure of a piecewise linear table, as all three solvers read theirs.
double linear(const std::map<double, double>& table, double at)
{
  auto above = table.lower_bound(at);
  if (above == table.begin())
    ++above;
  const auto below = std::prev(above);
  return below->second +
         (at - below->first) / (above->first - below->first) * (above->second - below->second);
}

//! What LS-DYNA makes of a curve: straight lines between points at equal distances.
double resampled(const std::map<double, double>& table, int intervals, double at)
{
  const double first = table.begin()->first, step = (table.rbegin()->first - first) / intervals;
  const double k = std::floor((at - first) / step), low = linear(table, first + k * step);
  return low + ((at - first) / step - k) * (linear(table, first + (k + 1) * step) - low);
}

const std::vector<double> compressions{1.001, 1.01, 1.05, 1.1};

} // namespace

TEST_CASE("decks are those that were checked by eye", "[decks]")
{
  const TemporaryFolder folder;
  for (const std::string& format : deck_format_names()) {
    const DeckOptions options = options_of(format);
    for (const std::filesystem::path& file :
         write_deck(sample_bird(), options, folder / ("small" + deck_extension(options.format))))
    {
      INFO(file.filename() << ": if the change is wanted, look at it and run tests_geometry \"[.golden]\"");
      const std::string now = text_of(file);
      CHECK(now == text_of(golden / file.filename()));
      CHECK(now.size() < 20000);
    }
  }
}

TEST_CASE("write the decks of tests/data/decks again", "[.golden]")
{
  for (const std::string& format : deck_format_names())
    CHECK_FALSE(write_deck(sample_bird(), options_of(format),
                           golden / ("small" + deck_extension(deck_format(format))))
                    .empty());
}

TEST_CASE("an LS-DYNA deck has its fields where the manual has them", "[decks]")
{
  const TemporaryFolder folder;
  const Particles bird = sample_bird();
  const auto lines = deck_lines(folder, options_of("dyna"), bird);
  CHECK(lines.front() == "*KEYWORD");
  CHECK(lines.back() == "*END");
  for (const std::string& line : lines)
    CHECK(line.size() <= (line[0] == '$' ? 81 : 80));

  const auto row = [&](std::int32_t id) {
    return static_cast<std::size_t>(bird.row_of_id()[static_cast<std::size_t>(id)]);
  };
  const auto nodes = blocks(lines, "*NODE").at(0);
  REQUIRE(nodes.size() == bird.size());
  for (std::int32_t id = 0; id < 27; ++id) {
    const std::string& line = nodes[static_cast<std::size_t>(id)];
    CHECK(field(line, 1, 8) == id + 1); // nid, x, y, z: 1-8, 9-24, 25-40, 41-56
    CHECK(field(line, 9, 16) == Approx(1e3 * bird.x[row(id)]).epsilon(1e-9));
    CHECK(field(line, 25, 16) == Approx(1e3 * bird.y[row(id)]).epsilon(1e-9).margin(1e-9));
    CHECK(field(line, 41, 16) == Approx(1e3 * bird.z[row(id)]).epsilon(1e-9));
  }
  const auto elements = blocks(lines, "*ELEMENT_SPH").at(0);
  REQUIRE(elements.size() == bird.size());
  double mass = 0;
  for (const std::string& line : elements) { // nid, pid, mass: 1-8, 9-16, 17-32
    const auto i = row(static_cast<std::int32_t>(field(line, 1, 8)) - 1);
    CHECK(field(line, 9, 8) == bird.part[i] + 1);
    CHECK(field(line, 17, 16) == Approx(1e-3 * bird.mass[i]).epsilon(1e-9));
    mass += field(line, 17, 16);
  }
  CHECK(mass == Approx(1e-3 * total_mass(bird)).epsilon(1e-9));

  const auto parts = blocks(lines, "*PART");
  const auto materials = blocks(lines, "*MAT_NULL");
  REQUIRE(parts.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(parts[k][0] == bird.parts[k].name);
    CHECK(field(parts[k][1], 1, 10) == k + 1); // pid, secid, mid, eosid
    CHECK(field(parts[k][1], 11, 10) == 1);
    CHECK(field(parts[k][1], 21, 10) == k + 1);
    CHECK(field(parts[k][1], 31, 10) == k + 1);
    CHECK(field(materials[k][0], 1, 10) == k + 1); // mid, ro, pc
    CHECK(field(materials[k][0], 11, 10) ==
          Approx(1e-12 * reference_density(bird.parts[k].eos)).epsilon(1e-5));
    CHECK(field(materials[k][0], 21, 10) == -1e-6); // 1 Pa
  }
  const std::string section = blocks(lines, "*SECTION_SPH").at(0)[0];
  CHECK(field(section, 11, 10) == 1.2); // cslh
  const std::string control = blocks(lines, "*CONTROL_SPH").at(0)[0];
  CHECK(field(control, 31, 10) == 3); // idim
  const std::string velocity = blocks(lines, "*INITIAL_VELOCITY_GENERATION").at(0)[0];
  CHECK(field(velocity, 1, 10) == 1);  // id of the set of parts
  CHECK(field(velocity, 11, 10) == 1); // styp: a set of parts
  CHECK(field(velocity, 31, 10) == -116500);
  CHECK(field(velocity, 41, 10) == 3250);
  CHECK(blocks(lines, "*SET_PART_LIST").at(0)[1] == "         1         2         3         4");
  CHECK(field(blocks(lines, "*CONTROL_TERMINATION").at(0)[0], 1, 10) > 0);
}

TEST_CASE("laws in an LS-DYNA deck give the pressures of this solver, in each system of units",
          "[decks][eos]")
{
  const TemporaryFolder folder;
  const Particles bird = sample_bird();
  const auto p = [&](std::size_t part, double ratio, double energy = 0) { // energy per initial volume
    const EquationOfState& eos = bird.parts[part].eos;
    const double rho0 = reference_density(eos);
    return evaluate(eos, ratio * rho0, energy / rho0).pressure;
  };
  for (const DeckUnits& u : deck_unit_systems()) {
    INFO(u.name);
    const auto lines = deck_lines(folder, options_of("dyna", u.name), bird);
    const std::string cubic = blocks(lines, "*EOS_LINEAR_POLYNOMIAL").at(0)[0]; // c0 11-20, c1 21-30 ...
    const std::string shock = blocks(lines, "*EOS_GRUNEISEN").at(0)[0];
    const std::string bones = blocks(lines, "*EOS_MURNAGHAN").at(0)[0];
    CHECK(field(cubic, 1, 10) == 1);
    CHECK(field(shock, 1, 10) == 3);
    CHECK(field(bones, 1, 10) == 4);
    CHECK(field(blocks(lines, "*EOS_LINEAR_POLYNOMIAL").at(0)[1], 11, 10) == 1); // v0
    CHECK(field(bones, 31, 10) == 1);                                            // v0
    CHECK(field(blocks(lines, "*EOS_GRUNEISEN").at(0)[1], 1, 10) == 1);          // v0
    const auto tabulated = blocks(lines, "*EOS_TABULATED").at(0);
    REQUIRE(tabulated.size() == 1);          // with both curves the six cards of ten points are left out
    CHECK(field(tabulated[0], 31, 10) == 1); // v0
    std::map<double, std::map<double, double>> curves;
    std::map<double, int> intervals;
    for (const auto& curve : blocks(lines, "*DEFINE_CURVE")) {
      const double id = field(curve[0], 1, 10);
      intervals[id] = static_cast<int>(field(curve[0], 71, 10));
      for (std::size_t k = 1; k < curve.size(); ++k) {
        CHECK((curves[id].empty() || field(curve[k], 1, 20) > curves[id].rbegin()->first)); // ascending
        curves[id][field(curve[k], 1, 20)] = field(curve[k], 21, 20);
      }
    }
    const double lcc = field(tabulated[0], 41, 10), lct = field(tabulated[0], 51, 10);
    REQUIRE(curves.at(lcc).size() > 10);
    for (const auto& [place, value] : curves.at(lct))
      CHECK(value == 0);

    for (const double ratio : compressions) {
      const double mu = ratio - 1, V = 1 / ratio;
      const double C1 = field(cubic, 21, 10), C2 = field(cubic, 31, 10), C3 = field(cubic, 41, 10);
      CHECK((C1 * mu + C2 * mu * mu + C3 * mu * mu * mu) * u.pressure() == Approx(p(0, ratio)).epsilon(1e-4));
      const double gamma = field(bones, 11, 10), k0 = field(bones, 21, 10);
      CHECK(k0 * (std::pow(ratio, gamma) - 1) * u.pressure() == Approx(p(3, ratio)).epsilon(1e-4));
      const double wing = p(1, ratio),
                   allowed = 0.005 * std::max(wing, 0.02 * hugoniot(bird.parts[3].eos, 116.5).pressure);
      CHECK(std::abs(linear(curves.at(lcc), std::log(V)) * u.pressure() - wing) < allowed);
      CHECK(std::abs(resampled(curves.at(lcc), intervals.at(lcc), std::log(V)) * u.pressure() - wing) <
            allowed);
      // p = rho0 C^2 mu [1 + (1 - g/2) mu - a/2 mu^2] / [1 - (S1 - 1) mu - S2 mu^2/(1 + mu) - S3 mu^3/(1 + mu)^2]^2
      //   + (g + a mu) E, Keyword manual II, *EOS_GRUNEISEN.
      const double C = field(shock, 11, 10), S1 = field(shock, 21, 10), S2 = field(shock, 31, 10),
                   S3 = field(shock, 41, 10), g = field(shock, 51, 10), a = field(shock, 61, 10);
      const double root =
          1 - (S1 - 1) * mu - S2 * mu * mu / (1 + mu) - S3 * mu * mu * mu / ((1 + mu) * (1 + mu));
      const double rho0 = 1000 / u.density(), energy = 3e6; // [J/m3]
      const double law = rho0 * C * C * mu * (1 + (1 - g / 2) * mu - a / 2 * mu * mu) / (root * root) +
                         (g + a * mu) * energy / u.pressure();
      CHECK(law * u.pressure() == Approx(p(2, ratio, energy)).epsilon(1e-4));
    }
  }
}

TEST_CASE("an LS-DYNA deck offers ten points for old versions behind its comment sign", "[decks][eos]")
{
  const TemporaryFolder folder;
  const Particles bird = sample_bird();
  const auto lines = deck_lines(folder, options_of("dyna"), bird);
  const auto card = std::find(lines.begin(), lines.end(), "$*EOS_TABULATED");
  REQUIRE(lines.end() - card > 7);
  CHECK(field(card[1].substr(1), 1, 10) == 2);  // eosid
  CHECK(field(card[1].substr(1), 31, 10) == 1); // v0
  std::map<double, double> table;
  for (int k = 0; k < 10; ++k) { // two cards of five for ln(V), then for C
    const auto value = [&](int first) { return field(card[first + k / 5].substr(1), 1 + 16 * (k % 5), 16); };
    table[value(2)] = value(4);
    CHECK(value(6) == 0); // T
  }
  REQUIRE(table.size() == 10);
  const double range = 2 * hugoniot(bird.parts[3].eos, 116.5).pressure;
  for (const double ratio : {1.1, 1.3, 1.5, 1.6}) {
    const double p = evaluate(bird.parts[1].eos, 600 * ratio).pressure;
    CHECK(std::abs(linear(table, -std::log(ratio)) * 1e6 - p) <
          0.085 * std::max(p, 0.01 * range)); // as the deck says
  }
}

TEST_CASE("a Radioss deck has its fields where its format has them", "[decks]")
{
  const TemporaryFolder folder;
  const Particles bird = sample_bird();
  const auto files = write_deck(bird, options_of("radioss", "kg-mm-ms"), folder / "bird_0000.rad");
  REQUIRE(files.size() == 2);
  CHECK(files[0].filename() == "bird_0000.rad");
  CHECK(files[1].filename() == "bird_0001.rad");
  const auto lines = lines_of(files[0]);
  CHECK(lines.front() == "#RADIOSS STARTER");
  CHECK(lines.back() == "/END");
  for (const std::string& line : lines)
    CHECK(line.size() <= 100);
  const auto begin = blocks(lines, "/BEGIN").at(0);
  CHECK(begin[0] == "bird"); // the name of the files
  CHECK(begin[1] == "      2022         0");
  CHECK(begin[2] == "                  kg                  mm                  ms");
  CHECK(begin[3] == begin[2]);

  const auto nodes = blocks(lines, "/NODE").at(0);
  REQUIRE(nodes.size() == bird.size());
  const std::vector<std::int32_t> row = bird.row_of_id();
  for (std::size_t id = 0; id < bird.size(); ++id) {
    const auto i = static_cast<std::size_t>(row[id]);
    CHECK(field(nodes[id], 1, 10) == id + 1); // 10, then 20 columns each
    CHECK(field(nodes[id], 11, 20) == Approx(1e3 * bird.x[i]).epsilon(1e-12));
    CHECK(field(nodes[id], 31, 20) == Approx(1e3 * bird.y[i]).epsilon(1e-12).margin(1e-12));
    CHECK(field(nodes[id], 51, 20) == Approx(1e3 * bird.z[i]).epsilon(1e-12));
  }
  double mass = 0;
  for (int part = 1; part <= 4; ++part) {
    const std::string number = std::to_string(part);
    const auto cells = blocks(lines, "/SPHCEL/" + number).at(0);
    const auto property = blocks(lines, "/PROP/TYPE34/" + number).at(0);
    mass += static_cast<double>(cells.size()) * field(property[1], 1, 20); // mp
    CHECK(field(property[2], 11, 20) == Approx(1.2 * 6.1));                // h
    for (const std::string& cell : cells)
      CHECK(bird.part[static_cast<std::size_t>(row[static_cast<std::size_t>(field(cell, 1, 10)) - 1])] ==
            part - 1);
    CHECK(blocks(lines, "/PART/" + number).at(0)[1] ==
          "         " + number + "         " + number + "         0");
    const auto material = blocks(lines, "/MAT/LAW6/" + number).at(0);
    CHECK(
        field(material[1], 1, 20) ==
        Approx(1e-9 * reference_density(bird.parts[static_cast<std::size_t>(part - 1)].eos)).epsilon(1e-12));
    CHECK(field(material[2], 21, 20) == -1e-9); // Pmin, 1 Pa: a zero would mean none
  }
  CHECK(mass == Approx(total_mass(bird)).epsilon(1e-12));
  const std::string velocity = blocks(lines, "/INIVEL/TRA/1").at(0)[1];
  CHECK(field(velocity, 1, 20) == -116.5);
  CHECK(field(velocity, 21, 20) == 3.25);
  CHECK(field(velocity, 61, 10) == 1); // group of nodes
  CHECK(blocks(lines, "/GRNOD/PART/1").at(0)[1] == "         1         2         3         4");

  const auto engine = lines_of(files[1]);
  REQUIRE(blocks(engine, "/RUN/bird/1").size() == 1);
  CHECK(std::stod(blocks(engine, "/RUN/bird/1")[0][0]) > 0);
  CHECK(std::find(engine.begin(), engine.end(), "/VERS/2022") != engine.end());
}

TEST_CASE("laws in a Radioss deck give the pressures of this solver", "[decks][eos]")
{
  const TemporaryFolder folder;
  const Particles bird = sample_bird();
  const DeckUnits u = deck_units("lbf-s2/in-in-s");
  const auto lines = deck_lines(folder, options_of("radioss", u.name), bird);
  const auto begin = blocks(lines, "/BEGIN").at(0); // no code for these units: their sizes
  CHECK(field(begin[2], 1, 20) == Approx(175.126835246).epsilon(1e-9));
  CHECK(field(begin[2], 21, 20) == 0.0254);

  const auto cubic = blocks(lines, "/EOS/POLYNOMIAL/1").at(0);
  const auto shock = blocks(lines, "/EOS/GRUNEISEN/3").at(0);
  const auto bones = blocks(lines, "/EOS/MURNAGHAN/4").at(0);
  const auto wings = blocks(lines, "/EOS/TABULATED/2").at(0);
  CHECK(field(cubic[2], 81, 20) * u.density() == Approx(938));
  CHECK(field(shock[2], 61, 20) * u.density() == Approx(1000));
  CHECK(field(bones[1], 81, 20) * u.density() == Approx(1100));
  CHECK(field(wings[3], 41, 20) * u.density() == Approx(600));
  CHECK(field(wings[1], 21, 20) == 1); // XscaleA behind ten blank columns
  CHECK(field(wings[1], 41, 20) == 1); // FscaleA
  CHECK(field(wings[2], 1, 10) == 0);  // no function B
  std::map<double, double> table;
  const auto rows = blocks(lines, "/FUNCT/" + std::to_string(static_cast<int>(field(wings[1], 1, 10)))).at(0);
  for (std::size_t k = 1; k < rows.size(); ++k)
    table[field(rows[k], 1, 20)] = field(rows[k], 21, 20);
  for (const double ratio : compressions) {
    const double mu = ratio - 1;
    const auto p = [&](std::size_t k) {
      return evaluate(bird.parts[k].eos, ratio * reference_density(bird.parts[k].eos)).pressure;
    };
    const double C1 = field(cubic[1], 21, 20), C2 = field(cubic[1], 41, 20), C3 = field(cubic[1], 61, 20);
    CHECK((C1 + (C2 + C3 * mu) * mu) * mu * u.pressure() == Approx(p(0)).epsilon(1e-9));
    const double K0 = field(bones[1], 1, 20), K1 = field(bones[1], 21, 20);
    CHECK(K0 / K1 * (std::pow(ratio, K1) - 1) * u.pressure() == Approx(p(3)).epsilon(1e-9));
    CHECK(std::abs(linear(table, mu) * u.pressure() - p(1)) <
          0.005 * std::max(p(1), 0.02 * hugoniot(bird.parts[3].eos, 116.5).pressure));
    CHECK(field(shock[1], 1, 20) * u.velocity() == Approx(1480));
    CHECK(field(shock[1], 21, 20) == 2.56);
    CHECK(field(shock[2], 1, 20) == 0.4934);
    CHECK(field(shock[2], 21, 20) == 1.3937);
  }
}

TEST_CASE("a slope of Gamma of zero is not left to Radioss, for which zero means Gamma", "[decks][eos]")
{
  const TemporaryFolder folder;
  Particles bird = sample_bird();
  bird.parts[2].eos = MieGrueneisen(1000, {1480, 1.79, 0, 0, 1.65, 0});
  const auto radioss = deck_lines(folder, options_of("radioss"), bird);
  const double a = field(blocks(radioss, "/EOS/GRUNEISEN/3").at(0)[2], 21, 20);
  CHECK(a > 0);
  CHECK(a < 1e-12);
  // A straight shock curve and constant rho Gamma is what Abaqus has, too: p = rho0 c0^2 h (1 - G0 h/2) / (1 - s h)^2 +
  // G0 rho0 e with h = 1 - rho0/rho.
  const auto abaqus = deck_lines(folder, options_of("abaqus", "kg-m-s"), bird);
  const auto block = blocks(abaqus, "*EOS, TYPE=USUP");
  REQUIRE(block.size() == 1);
  CHECK(block[0][0] == "1480.0, 1.79, 1.65");
  for (const double ratio : compressions) {
    const double h = 1 - 1 / ratio, e = 5e3;
    CHECK(1000 * 1480. * 1480. * h * (1 - 1.65 * h / 2) / ((1 - 1.79 * h) * (1 - 1.79 * h)) +
              1.65 * 1000 * e ==
          Approx(evaluate(bird.parts[2].eos, 1000 * ratio, e).pressure).epsilon(1e-9));
  }
}

TEST_CASE("an Abaqus deck gives each particle the volume from which its mass follows", "[decks]")
{
  const TemporaryFolder folder;
  const Particles bird = sample_bird();
  const auto lines = deck_lines(folder, options_of("abaqus"), bird);
  CHECK(lines.front() == "*HEADING");
  CHECK(lines.back() == "*END STEP");
  for (const std::string& line : lines)
    CHECK(line.size() <= 256);
  CHECK(blocks(lines, "*NODE, NSET=BIRD").at(0).size() == bird.size());
  double mass = 0;
  for (const Part& part : bird.parts) {
    const auto elements = blocks(lines, "*ELEMENT, TYPE=PC3D, ELSET=" + part.name).at(0);
    const auto section =
        blocks(lines, "*SOLID SECTION, ELSET=" + part.name + ", MATERIAL=" + part.name).at(0);
    // The volume is a cube of twice the characteristic length.
    mass += static_cast<double>(elements.size()) * 1e-12 * reference_density(part.eos) *
            std::pow(2 * std::stod(section[0]), 3);
  }
  CHECK(mass == Approx(1e-3 * total_mass(bird)).epsilon(1e-12));
  CHECK(blocks(lines, "*INITIAL CONDITIONS, TYPE=VELOCITY").at(0)[0] == "BIRD, 1, -116500.0");
  CHECK(blocks(lines, "*TENSILE FAILURE, ELEMENT DELETION=NO, PRESSURE=DUCTILE, SHEAR=DUCTILE").at(0)[0] ==
        "1.0E-6,");
  CHECK(std::stod(blocks(lines, "*DYNAMIC, EXPLICIT").at(0)[0].substr(1)) > 0);
}

TEST_CASE("tables of an Abaqus deck fall in volumetric strain and hold the laws, with their energy",
          "[decks][eos]")
{
  const TemporaryFolder folder;
  const Particles bird = sample_bird();
  const auto tables =
      blocks(deck_lines(folder, options_of("abaqus", "kg-mm-ms"), bird), "*EOS, TYPE=TABULAR");
  REQUIRE(tables.size() == 4);
  const double least = 0.02 * hugoniot(bird.parts[3].eos, 116.5).pressure;
  for (std::size_t k = 0; k < 4; ++k) {
    std::map<double, double> f1, f2;
    double last = 1;
    for (const std::string& line : tables[k]) {
      const std::size_t comma = line.find(','), second = line.find(',', comma + 1);
      const double strain = std::stod(line.substr(second + 1));
      CHECK(strain < last);
      last = strain;
      f1[strain] = std::stod(line);
      f2[strain] = std::stod(line.substr(comma + 1));
    }
    const double rho0 = reference_density(bird.parts[k].eos);
    for (const double ratio : compressions) {
      const double strain = -std::log(ratio), e = k == 2 ? 4e3 : 0;
      const double p = evaluate(bird.parts[k].eos, ratio * rho0, e).pressure;
      if (evaluate(bird.parts[k].eos, ratio * rho0).pressure < 50 * least)
        CHECK(std::abs(1e9 * linear(f1, strain) + rho0 * linear(f2, strain) * e - p) <
              0.005 * std::max(p, least));
    }
  }
}

TEST_CASE("a deck says its units, its parts and where its tables were cut", "[decks]")
{
  const TemporaryFolder folder;
  for (const std::string& format : deck_format_names()) {
    const auto lines = deck_lines(folder, options_of(format, "g-mm-ms"));
    std::string all;
    for (const std::string& line : lines)
      all += line + '\n';
    for (const char* text : {"unit system: g-mm-ms", "27 particles", "Small bird of four laws", "wings_left",
                             "points; off from the law by at most", "MPa"})
      CHECK(all.find(text) != std::string::npos);
  }
}

TEST_CASE("the tension cut-off is that of the settings", "[decks]")
{
  const TemporaryFolder folder;
  DeckOptions options = options_of("dyna");
  options.tension_cutoff = -2.5e6;
  CHECK(field(blocks(deck_lines(folder, options), "*MAT_NULL").at(1)[0], 21, 10) == -2.5);
  options.format = DeckFormat::abaqus;
  CHECK(blocks(deck_lines(folder, options),
               "*TENSILE FAILURE, ELEMENT DELETION=NO, PRESSURE=DUCTILE, SHEAR=DUCTILE")
            .at(3)[0] == "2.5,");
}

TEST_CASE("what cannot be written is said, and nothing is left behind", "[decks]")
{
  const TemporaryFolder folder;
  const auto error = [&](const Particles& bird, const DeckOptions& options, const std::string& name) {
    return input_error([&] { write_deck(bird, options, folder / name); });
  };
  const Particles bird = sample_bird();
  CHECK(error(Particles{}, options_of("dyna"), "a.k").find("no particles") != std::string::npos);
  CHECK(error(bird, options_of("dyna", "stone"), "a.k").find("no system of units \"stone\"") !=
        std::string::npos);
  CHECK(error(bird, options_of("radioss"), "a.rad").find("4 to 80 characters") != std::string::npos);
  DeckOptions options = options_of("dyna");
  options.tension_cutoff = 1;
  CHECK(error(bird, options, "a.k").find("tension cut-off") != std::string::npos);
  options = options_of("dyna");
  options.first_id = 99999999;
  CHECK(error(bird, options, "a.k").find("99999999") != std::string::npos);

  Particles soft = bird;
  soft.parts[1].eos = Linear{600, 1e3};
  CHECK(error(soft, options_of("abaqus"), "a.inp").find("part wings_left") != std::string::npos);
  soft.parts[1].eos =
      Linear{600, 4e6}; // stiff enough to be stopped, but not for the pressure of its neighbours
  CHECK(error(soft, options_of("abaqus"), "a.inp")
            .find("part wings_left: its equation of state does not reach") != std::string::npos);
  Particles uneven = sample_bird(11);
  for (std::size_t i = 0; i < uneven.size(); ++i)
    uneven.mass[i] *= 1 + 1e-5 * static_cast<double>(i);
  CHECK(error(uneven, options_of("abaqus"), "a.inp").find("1331 different masses") != std::string::npos);
  for (std::size_t i = 0; i < uneven.size(); ++i)
    uneven.vx[i] += 1e-3 * static_cast<double>(i);
  CHECK(error(uneven, options_of("radioss"), "bird.rad").find("more than 1000 different") !=
        std::string::npos);
  CHECK(std::filesystem::is_empty(folder / ""));

  for (const std::string& format : deck_format_names())
    CHECK_THROWS_AS(write_deck(bird, options_of(format), folder / "none/bird.rad"), OutputError);
  CHECK(std::filesystem::is_empty(folder / ""));
  // A folder of that name stands in the way of the finished file.
  std::filesystem::create_directory(folder / "taken.k");
  CHECK_THROWS_AS(write_deck(bird, options_of("dyna"), folder / "taken.k"), OutputError);
  CHECK_FALSE(std::filesystem::exists(folder / "taken.k.tmp"));
}
