// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike run: the impact.
#include "cases/case.h"
#include "cases/commands.h"
#include "cases/log.h"
#include "cases/run_case.h"
#include "cases/share_folder.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace birdstrike {

void add_run_command(CLI::App& program)
{
  struct Options
  {
    std::string file;
    RunOptions run;
    std::vector<std::string> overrides;
    bool quiet = false, no_figures = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("run", "Run the impact of a case");
  command->add_option("CASE", options->file, "Case file (.toml), or a name of the catalogue")->required();
  command->add_option("-o,--output", options->run.output,
                      "Folder of the results; default out/<name of the case>");
  command
      ->add_option("--set", options->overrides,
                   "KEY=VALUE replaces a key of the case, for example --set bird.spacing=\"8 mm\"")
      ->allow_extra_args(false);
  command
      ->add_option("--threads", options->run.threads, "Number of threads; 0, the default, for all processors")
      ->check(CLI::Range(0, 1024));
  command->add_flag("--quiet", options->quiet, "Say nothing on the screen but warnings and errors");
  command->add_flag("--no-figures", options->no_figures,
                    "Leave the pictures out; birdstrike render makes them later");
  command->callback([options] {
    Log log(options->quiet);
    const Case parsed = read_case(find_case(options->file), options->overrides);
    if (options->run.output.empty())
      options->run.output = std::filesystem::path("out") / parsed.file.stem();
    options->run.figures = !options->no_figures;
    run_case(parsed, options->run, log);
  });
}

} // namespace birdstrike
