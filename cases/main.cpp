// SPDX-License-Identifier: GPL-3.0-or-later
// The program birdstrike: picks the command, and turns failures into a message and an exit status.
#include "cases/commands.h"
#include "cases/edit_distance.h"
#include "cases/share_processor.h"
#include "core/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace {

using namespace birdstrike;

//! CLI11 only says that a command is required.
void require_known_command(const CLI::App& program, const std::string& given)
{
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands(nullptr))
    names.push_back(command->get_name());
  if (given.starts_with('-') || std::find(names.begin(), names.end(), given) != names.end())
    return;
  const std::string nearest = nearest_name(given, names);
  throw InputError(fmt::format("there is no command \"{}\"; {}there are {}", given,
                               nearest.empty() ? "" : "did you mean " + nearest + "? ",
                               fmt::join(names, ", ")));
}

//! What shows the options: of the command, if one was given.
std::string help_of(const CLI::App& program)
{
  const std::vector<CLI::App*> given = program.get_subcommands();
  return given.empty() ? "birdstrike --help" : "birdstrike " + given.front()->get_name() + " --help";
}

} // namespace

int main(int argc, char** argv)
{
  sleep_at_barriers(argv);
  CLI::App program(
      "Bird strike by smoothed particle hydrodynamics: from a CAD mesh of a bird to its impact, a ParaView "
      "series, histories and pictures.",
      "birdstrike");
  program.set_version_flag("--version", BIRDSTRIKE_VERSION);
  program.require_subcommand(1);
  program.footer("Exit status: 0 success, 1 the run failed, 2 the input is wrong.");
  add_run_command(program);
  add_study_command(program);
  add_bird_command(program);
  add_histories_command(program);
  add_render_command(program);
  add_series_command(program);
  add_figures_command(program);
  add_plot_command(program);
  add_report_command(program);
  add_cases_command(program);
  add_theory_command(program);

  int status = 1;
  try {
    if (argc > 1)
      require_known_command(program, argv[1]);
    program.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) // --help, --version
      return program.exit(error);
    std::fprintf(stderr, "birdstrike: error: %s; see %s\n", error.what(), help_of(program).c_str());
    return 2;
  } catch (const InputError& error) {
    std::fprintf(stderr, "birdstrike: error: %s\n", error.what());
    status = 2;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "birdstrike: error: the memory is not enough; choose a larger bird.spacing\n");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "birdstrike: error: %s\n", error.what());
  }
  return status;
}
