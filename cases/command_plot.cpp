// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike plot: histories of several runs, one over the other.
#include "cases/commands.h"
#include "cases/figures.h"
#include "cases/plot_runs.h"
#include "cases/render_texts.h"
#include "core/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace birdstrike {

void add_plot_command(CLI::App& program)
{
  struct Options
  {
    RunPlotOptions plot;
    std::filesystem::path output;
    std::string size = "1280x720";
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("plot", "Histories of one or several runs in one plot");
  command->add_option("RUN", options->plot.runs, "Folders of runs")->required();
  command->add_option("-o,--output", options->output, "The picture, .png")->required();
  command
      ->add_option(
          "--column", options->plot.columns,
          "Column of histories.csv or transducers.csv, without unit: max_pressure_all; may be repeated")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--unit", options->plot.unit, "To show it in; default MPa, kN, mm, else SI");
  command->add_option("--x", options->plot.x, "Column along x")->capture_default_str();
  command->add_option("--x-unit", options->plot.x_unit, "To show that in; default ms");
  command
      ->add_option("--label", options->plot.labels,
                   "Name of a run in the legend, in their order; may be repeated")
      ->allow_extra_args(false);
  command->add_flag(
      "--theory", options->plot.theory,
      "Hugoniot and stagnation pressure as lines: of a part for max_pressure_<part>, else of the bird's "
      "hardest part");
  command->add_option("--title", options->plot.title, "Above the plot");
  command->add_option("--size", options->size, "Pixels")->capture_default_str();
  command->callback([options] {
    require(options->output.extension() == ".png",
            fmt::format("-o {}: a name that ends in .png is needed", options->output.string()));
    Plot plot = plot_of_runs(options->plot);
    plot.title = fitting_title(plot.title);
    const std::array<int, 2> size = parse_pair(options->size, "--size", "1280x720");
    for (const int side : size)
      require(side >= 64, fmt::format("--size: \"{}\": each side must be 64 to 16384 pixels", options->size));
    plot.width = size[0];
    plot.height = size[1];
    write_plot(plot, options->output);
  });
}

} // namespace birdstrike
