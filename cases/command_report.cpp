// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike report: a run as one page.
#include "cases/commands.h"
#include "cases/log.h"
#include "cases/report.h"
#include "core/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace birdstrike {
namespace {

struct Options
{
  std::filesystem::path folder, output;
  ViewOptions view;
  bool quiet = false;
};

void report(const Options& options)
{
  require(options.view.frames >= 2, fmt::format("--frames {}: two or more are needed", options.view.frames));
  require(options.view.particles >= 1,
          fmt::format("--particles {}: one or more are needed", options.view.particles));
  Log log(options.quiet);
  std::filesystem::path folder = options.folder;
  if (!folder.has_filename() && folder.has_parent_path()) // "out/goose/"
    folder = folder.parent_path();
  const std::filesystem::path page = options.output.empty() ? folder / "report.html" : options.output;
  const ReportResult result = write_report(folder, page, options.view);
  for (const std::string& gap : result.gaps)
    log.warn(gap);
  if (result.turning)
    log.info(fmt::format("{} of {} frames, {} of {} particles in the view", result.view.frames,
                         result.view.all_frames, result.view.particles, result.view.all_particles));
  log.info(fmt::format("{} ({:.1f} MB{})", page.string(), 1e-6 * static_cast<double>(result.bytes),
                       result.complete ? "" : "; of a run that is not complete"));
}

} // namespace

void add_report_command(CLI::App& program)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "report", "A run as one HTML file: balances, tables, curves, pictures and a view that can be turned");
  command->add_option("DIR", options->folder, "Folder of a run")->required();
  command->add_option("-o,--output", options->output, "The page (default: report.html in that folder)");
  command->add_option("--frames", options->view.frames, "States in the view, at most")->capture_default_str();
  command
      ->add_option("--particles", options->view.particles, "Particles in the view, at most; evenly thinned")
      ->capture_default_str();
  command->add_flag("--quiet", options->quiet, "Say nothing on the screen but warnings and errors");
  command->footer("The page needs no network and no other file.");
  command->callback([options] { report(*options); });
}

} // namespace birdstrike
