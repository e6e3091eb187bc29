// SPDX-License-Identifier: GPL-3.0-or-later
// The program birdstrike: picks the command, and turns failures into a message and an exit status.
#include "cases/commands.h"
#include "cases/share_processor.h"
#include "core/error.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <new>

int main(int argc, char** argv)
{
  using namespace birdstrike;
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
    program.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) // --help, --version
      return program.exit(error);
    std::fprintf(stderr, "birdstrike: error: %s; see birdstrike --help\n", error.what());
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
