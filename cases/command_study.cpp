// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike study: many runs of one case, their numbers in a table and in plots.
#include "cases/commands.h"
#include "cases/log.h"
#include "cases/run_study.h"
#include "cases/study.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace birdstrike {

void add_study_command(CLI::App& program)
{
  struct Options
  {
    std::string file;
    StudyOptions run;
    std::vector<std::string> overrides;
    bool quiet = false, list = false, plot_only = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("study", "Run a case with many values, and plot the numbers");
  command->add_option("STUDY", options->file, "Study file (.toml), or a name of the catalogue")->required();
  command->add_option("-o,--output", options->run.output,
                      "Folder of the results; default out/<name of the study>");
  command
      ->add_option("--set", options->overrides,
                   "KEY=VALUE replaces a key in all runs, for example --set bird.spacing=\"8 mm\"")
      ->allow_extra_args(false);
  command->add_option("--only", options->run.only,
                      "Make only runs whose name holds this, or fits it as a pattern: \"*_200-m-per-s\"");
  command
      ->add_option("--threads", options->run.threads, "Number of threads; 0, the default, for all processors")
      ->check(CLI::Range(0, 1024));
  CLI::Option* list = command->add_flag("--list", options->list, "Show the runs and end");
  command->add_flag("--plot-only", options->plot_only, "Draw the figures of finished runs again and end")
      ->excludes(list);
  command->add_flag("--pictures", options->run.pictures, "Make the pictures of every run, too");
  command->add_flag("--verbose", options->run.verbose, "Show what every run says");
  command->add_flag("--quiet", options->quiet, "Say nothing on the screen but warnings and errors");
  command->footer(
      "Runs that are complete are not made again: a study that was stopped goes on where it was. A run "
      "that fails does not stop the others; the exit status is then 1.");
  command->callback([options] {
    const Study study = read_study(find_study(options->file));
    const std::vector<StudyRun> runs = runs_of_study(study, options->overrides);
    if (options->run.output.empty())
      options->run.output = std::filesystem::path("out") / study.file.stem();
    Log log(options->quiet);
    if (options->list)
      std::cout << list_of_runs(runs, options->run);
    else if (options->plot_only)
      redraw_study(study, runs, options->run.output, log);
    else
      run_study(study, runs, options->run, log);
  });
}

} // namespace birdstrike
