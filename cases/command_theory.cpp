// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike theory: what an impact must show, without a simulation.
#include "cases/case.h"
#include "cases/commands.h"
#include "cases/quantity.h"
#include "cases/share_folder.h"
#include "cases/theory_figures.h"
#include "cases/theory_table.h"
#include "core/error.h"
#include "core/material/porous_bird.h"
#include "vtkio/atomic_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>

namespace birdstrike {
namespace {

constexpr const char* standing_shock_note =
    "Standing shock or Bernoulli: 6.21, integral of dp/rho = u^2/2, "
    "takes the steady jet to rest without loss, which needs "
    "the plate's pressure to reach upstream. Sound in porous water "
    "is slow (some 30 m/s at z = 0.4), so the jet is "
    "supersonic, M = u/c0 > 1, and a shock stands before the plate. "
    "Across it rho0 u = rho2 u2 and p2 + rho2 u2^2 = rho0 "
    "u^2 with p2 = p(rho2); from there 6.21 holds, integral of "
    "dp/rho from p2 = u2^2/2. The shock turns part of the "
    "motion into heat, so this pressure is the lower one (z = 0.4, "
    "200 m/s: 16.2 against 19.3 MPa), and it is the one that "
    "a steady simulation follows. Where sound outruns the flow all the way to rest both are the same.";

struct Options
{
  std::string speed, angle = "90 deg", mass, diameter, length, target_density, target_shock_speed;
  std::string eos = "impact-event", case_file, csv, json, figures;
  std::optional<double> porosity, length_over_diameter;
  bool fits = false;
};

std::optional<double> quantity(const char* name, const std::string& text, Dimension dimension)
{
  if (text.empty())
    return {};
  double value = 0;
  try {
    value = parse_quantity(text, dimension);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} \"{}\": {}", name, text, error.what()));
  }
  require(value > 0, fmt::format("{} \"{}\": allowed is above 0", name, text));
  return value;
}

TheoryInput input_of(const Options& options)
{
  TheoryInput input{.speed = 0,
                    .law_name = options.eos,
                    .law = Linear{1, 1},
                    .porosity = {},
                    .mass = {},
                    .diameter = {},
                    .length = {},
                    .target_density = {},
                    .target_shock_speed = {}};
  const auto speed = quantity("--speed", options.speed, Dimension::velocity);
  require(speed.has_value(), "--speed is missing: for example --speed \"200 m/s\"");
  input.speed = *speed;
  input.angle = *quantity("--angle", options.angle, Dimension::angle);
  require(input.angle <= std::numbers::pi / 2 * (1 + 1e-9),
          fmt::format("--angle \"{}\": allowed is above 0, at most 90 deg, which is normal to the plate",
                      options.angle));

  const auto porous = porous_law_names();
  const bool is_porous = std::find(porous.begin(), porous.end(), options.eos) != porous.end();
  require(
      is_porous || !options.porosity,
      fmt::format("--porosity has no meaning for the law \"{}\", which has its own density", options.eos));
  if (is_porous)
    input.porosity = options.porosity.value_or(0);
  Case parsed;
  if (!options.case_file.empty())
    parsed = read_case(find_case(options.case_file));
  try {
    input.law = natural_law(options.eos, input.porosity.value_or(0), parsed.laws, parsed.file.parent_path());
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("--eos {}: {}{}", options.eos, error.what(),
                    is_porous || !options.case_file.empty() ? "" : "; --case FILE adds those of a case"));
  }

  input.mass = quantity("--mass", options.mass, Dimension::mass);
  input.diameter = quantity("--diameter", options.diameter, Dimension::length);
  input.length = quantity("--length", options.length, Dimension::length);
  input.target_density = quantity("--target-density", options.target_density, Dimension::density);
  input.target_shock_speed =
      quantity("--target-shock-speed", options.target_shock_speed, Dimension::velocity);
  require(!options.length_over_diameter || *options.length_over_diameter > 0,
          "--length-over-diameter: allowed is above 0");
  complete_cylinder(input, options.length_over_diameter);
  return input;
}

//! To the screen for "-".
void put(const std::string& text, const std::string& file)
{
  if (file == "-")
    std::cout << text;
  else
    write_text_atomically(file, text);
}

void show_theory(const Options& options)
{
  if (options.fits)
    std::cout << fit_table();
  if (!options.figures.empty())
    for (const auto& file : write_theory_figures(options.figures))
      std::cerr << file.string() << '\n';
  if (options.speed.empty() && (options.fits || !options.figures.empty()))
    return;
  require(options.csv != "-" || options.json != "-", "only one of --csv and --json can go to the screen");
  const TheoryInput input = input_of(options);
  const std::vector<TheoryRow> rows = theory_rows(input);
  if (options.csv != "-" && options.json != "-")
    std::cout << theory_text(input, rows);
  if (!options.csv.empty())
    put(theory_csv(rows), options.csv);
  if (!options.json.empty())
    put(theory_json(input, rows), options.json);
}

} // namespace

void add_theory_command(CLI::App& program)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "theory", "Closed-form pressures, times and forces of an impact on a flat plate");
  command->add_option("--speed", options->speed, "Impact speed, for example \"200 m/s\"");
  command->add_option("--porosity", options->porosity, "Volume share of air z; default 0");
  command->add_option(
      "--eos", options->eos,
      "Law: impact-event (default), impact-event-table, shock, isentropic, or an [eos.NAME] of --case");
  command->add_option("--case", options->case_file, "Case whose tables [eos.NAME] --eos may name");
  command->add_option("--angle", options->angle, "Between flight and plate; default \"90 deg\"");
  command->add_option("--mass", options->mass, "Of the bird, a cylinder");
  command->add_option("--length-over-diameter", options->length_over_diameter,
                      "Of the cylinder; 2 with --mass alone");
  command->add_option("--diameter", options->diameter, "Of the cylinder");
  command->add_option("--length", options->length, "Of the cylinder, along the flight");
  command->add_option("--target-density", options->target_density, "Of a target that gives way (2.4)");
  command->add_option("--target-shock-speed", options->target_shock_speed,
                      "In a target that gives way (2.4)");
  command->add_option("--csv", options->csv, "The table as CSV, in SI; - is the screen");
  command->add_option("--json", options->json, "The table as JSON, in SI; - is the screen");
  command->add_option("--figures", options->figures,
                      "Folder for figures 6.1 to 6.5 and the stagnation pressures");
  command->add_flag("--fits", options->fits, "How well the cubic of section 6.3 fits, over porosity");
  command->footer(standing_shock_note);
  command->callback([options] { show_theory(*options); });
}

} // namespace birdstrike
