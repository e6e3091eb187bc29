// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike histories: the VTK filters without ParaView.
#include "cases/commands.h"
#include "cases/series_histories.h"
#include "vtkio/table_to_csv.h"

#include <CLI/CLI.hpp>
#include <vtkTable.h>

#include <memory>

namespace birdstrike {

void add_histories_command(CLI::App& program)
{
  struct Options
  {
    std::filesystem::path series, output;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("histories", "Maximum pressure and target deflection over time, from a series");
  command->add_option("RUN.pvd", options->series, "Series of a run")->required();
  command->add_option("-o,--output", options->output, "Table (.csv)")->required();
  command->callback([options] { write_csv(*histories_of_series(options->series), options->output); });
}

} // namespace birdstrike
