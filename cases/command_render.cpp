// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike render: the pictures of a series, off-screen.
#include "cases/commands.h"
#include "cases/figures.h"
#include "cases/series_histories.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <vtkTable.h>

#include <cstdio>
#include <memory>

namespace birdstrike {

void add_render_command(CLI::App& program)
{
  struct Options
  {
    std::filesystem::path series, output;
    std::string title, view = "side";
    bool quiet = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("render", "Pictures and plot of a series, off-screen");
  command->add_option("RUN.pvd", options->series, "Series of a run")->required();
  command->add_option("-o,--output", options->output, "Folder of the pictures")->required();
  command->add_option("--title", options->title, "Printed on the pictures");
  command->add_option("--view", options->view, "side, front, top or isometric")->capture_default_str();
  command->add_flag("--quiet", options->quiet, "Do not list the files written");
  command->callback([options] {
    std::vector<std::filesystem::path> files =
        write_pictures(options->series, options->output, options->title, view_from_name(options->view));
    const std::vector<std::filesystem::path> plots =
        write_plots(to_history(*histories_of_series(options->series)), {}, options->output, options->title);
    files.insert(files.end(), plots.begin(), plots.end());
    for (const std::filesystem::path& file : files)
      if (!options->quiet)
        std::puts(file.c_str());
  });
}

} // namespace birdstrike
