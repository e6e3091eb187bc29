// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike histories: the VTK filters without ParaView.
#include "cases/commands.h"
#include "cases/log.h"
#include "cases/series_histories.h"
#include "core/error.h"
#include "vtkio/table_to_csv.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <vtkTable.h>

#include <memory>

namespace birdstrike {
namespace {

struct Options
{
  std::filesystem::path series, output;
  std::vector<std::string> points;
  std::string along;
  double window = DeflectionOptions().window;
  bool quiet = false;
};

void write_histories(const Options& options)
{
  Log log(options.quiet);
  DeflectionOptions deflection;
  for (const std::string& point : options.points)
    deflection.points.push_back(deflection_point_from_text(point));
  if (!options.along.empty())
    deflection.along = direction_from_text(options.along);
  require(options.window >= 0 && options.window <= 1,
          fmt::format("--set-window {:g}: a share of the series' time is needed, 0 to 1", options.window));
  deflection.window = options.window;
  const auto histories =
      histories_of_series(options.series, deflection, [&](const std::string& warning) { log.warn(warning); });
  write_csv(*histories, options.output);
  for (const std::string& line : mesh_points_used(*histories, deflection))
    log.info(line);
}

} // namespace

void add_histories_command(CLI::App& program)
{
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("histories", "Maximum pressure and target deflection over time, from a series");
  command->add_option("RUN.pvd", options->series, "Series of a run")->required();
  command->add_option("-o,--output", options->output, "Table (.csv)")->required();
  command
      ->add_option("--deflection-at", options->points,
                   "[NAME=]X,Y,Z in metres, before the impact: also the deflection there; can be repeated")
      ->allow_extra_args(false);
  command->add_option("--deflection-along", options->along,
                      "X,Y,Z: also the deflection's component in this direction; 1,0,0 is the bird's flight");
  command
      ->add_option("--set-window", options->window,
                   "Last share of the series whose mean is the permanent set, 0 to 1")
      ->capture_default_str();
  command->add_flag("--quiet", options->quiet, "Say nothing on the screen but warnings and errors");
  command->footer("Deflections are lengths in metres; components are positive along their axis, x along the "
                  "bird's flight.");
  command->callback([options] { write_histories(*options); });
}

} // namespace birdstrike
