// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike figures: the pictures of the dissertation, their runs included.
#include "cases/commands.h"
#include "cases/draw_figures.h"
#include "cases/log.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace birdstrike {

void add_figures_command(CLI::App& program)
{
  struct Options
  {
    std::filesystem::path file;
    FiguresOptions figures;
    bool quiet = false, list = false;
  };
  auto options = std::make_shared<Options>();
  options->figures.output = std::filesystem::path("out") / "figures";
  CLI::App* command = program.add_subcommand("figures", "Run and draw the pictures of the dissertation");
  command->add_option("FILE", options->file,
                      "File of figures; default dissertation/montages.toml of the catalogue");
  command->add_option("-o,--output", options->figures.output, "Folder of the pictures and their runs")
      ->capture_default_str();
  command->add_option("--only", options->figures.only, "Numbers of figures: 7.2,8.8")->delimiter(',');
  command
      ->add_option("--set", options->figures.overrides,
                   "KEY=VALUE replaces a key in all runs, for example --set bird.spacing=\"10 mm\"")
      ->allow_extra_args(false);
  command
      ->add_option("--threads", options->figures.threads,
                   "Number of threads; 0, the default, for all processors")
      ->check(CLI::Range(0, 1024));
  command->add_flag("--list", options->list, "Show the figures and end");
  command->add_flag("--quiet", options->quiet, "Say nothing on the screen but warnings and errors");
  command->footer(
      "Runs that are complete are not made again: stopped and started again, it goes on where it was.");
  command->callback([options] {
    const MontageFile montages =
        read_montages(options->file.empty() ? montages_of_dissertation() : options->file);
    Log log(options->quiet);
    if (options->list)
      std::cout << list_of_figures(montages, options->figures);
    else
      draw_figures(montages, options->figures, log);
  });
}

} // namespace birdstrike
