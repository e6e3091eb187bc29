// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike series: a series in another form.
#include "cases/commands.h"
#include "cases/log.h"
#include "cases/series_form.h"
#include "core/error.h"
#include "vtkio/series_reader.h"
#include "vtkio/series_writer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <cstdio>
#include <memory>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

struct Options
{
  fs::path input, output;
  SeriesForm form;
  int every = 1;
  bool quiet = false;
};

bool has_field(vtkUnstructuredGrid* grid, const std::string& name)
{
  return grid &&
         (grid->GetPointData()->HasArray(name.c_str()) || grid->GetCellData()->HasArray(name.c_str()));
}

void convert(const Options& options)
{
  Log log(options.quiet);
  const SeriesIndex index = read_series_index(options.input);
  if (!index.warning.empty())
    log.warn(index.warning);
  std::error_code ignored;
  require(
      !fs::equivalent(index.pvd.parent_path().empty() ? "." : index.pvd.parent_path(), options.output,
                      ignored),
      fmt::format("{}: the series would be written over the one that is read; choose another folder with -o",
                  options.output.string()));
  for (const char* own : {"summary.json", "case.toml"})
    require(!fs::exists(options.output / own, ignored),
            fmt::format("{}: the folder holds a run ({}), whose frames would be lost; choose another with -o",
                        options.output.string(), own));
  const Frame first = read_frame(index, 0); // before anything is touched on the disk
  require(
      first.bird != nullptr,
      fmt::format("{}: there is no bird in this series: no piece of its first frame has the name \"bird\"",
                  index.pvd.string()));
  for (const std::string& field : options.form.fields)
    require(has_field(first.bird, field) || has_field(first.target, field),
            fmt::format("--fields {}: the series of {} does not have it; leave it out", field,
                        index.pvd.string()));
  SeriesWriter writer(options.output, series_options(options.form));
  const std::size_t last = index.steps.size() - 1, every = static_cast<std::size_t>(options.every);
  try {
    for (std::size_t step = 0; step <= last; ++step) {
      if (step % every != 0 && step != last)
        continue;
      const Frame frame = read_frame(index, step);
      require(frame.bird != nullptr, fmt::format("{}: the frame at {:g} s has no bird, and others have one; "
                                                 "write the run's series anew",
                                                 index.pvd.string(), frame.time));
      writer.write_frame(frame.time, *frame.bird, frame.target);
    }
    writer.finish();
  } catch (...) { // half a series would look like a whole one
    try {
      writer.discard();
    } catch (const OutputError&) { // the first error is the one to tell
    }
    throw;
  }
  log.info(fmt::format("{}: {} frames, {:.1f} MB", writer.path().string(), writer.frames(),
                       1e-6 * static_cast<double>(writer.bytes())));
}

} // namespace

void add_series_command(CLI::App& program)
{
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("series", "A series in another form: smaller, or for other programs");
  command->add_option("RUN", options->input, "Series (run.pvd, run.bss) or folder of a run")->required();
  command->add_option("-o,--output", options->output, "Folder of the new series")->required();
  command
      ->add_option(
          "--format", options->form.format,
          "vtu opens everywhere; packed is one small file, which this program and the ParaView plugin read")
      ->check(CLI::IsMember(series_formats()))
      ->capture_default_str();
  command->add_option("--precision", options->form.precision, "single or double")
      ->check(CLI::IsMember(series_precisions()))
      ->capture_default_str();
  command->add_option("--compression", options->form.compression, "of .vtu files: none, lz4, zlib, lzma")
      ->check(CLI::IsMember(series_compressions()))
      ->capture_default_str();
  command
      ->add_option("--accuracy", options->form.accuracy,
                   "of packed frames: largest error, over the largest value of the field so far")
      ->check(CLI::Range(0.0, 0.1))
      ->capture_default_str();
  command
      ->add_option("--fields", options->form.fields,
                   "Fields that are wanted besides part, id, pressure and displacement; all if not given")
      ->check(CLI::IsMember(series_fields()))
      ->delimiter(',');
  command->add_option("--every", options->every, "Every how many frames one is taken; the last one always is")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_flag("--quiet", options->quiet, "Say nothing on the screen but errors");
  command->callback([options, command] {
    for (const auto& [option, form] : {std::pair("--compression", "packed"), std::pair("--accuracy", "vtu")})
      require(command->count(option) == 0 || options->form.format != form,
              fmt::format("{} says nothing of --format {}; leave it out", option, form));
    convert(*options);
  });
}

} // namespace birdstrike
