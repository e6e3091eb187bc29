// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers.h"

#include "child.h"
#include "core/error.h"

#include <fmt/format.h>

#include <filesystem>

namespace birdstrike::peers {

namespace {

Measurement result_of(const Finished& finished)
{
  if (finished.status != 0)
    throw RunError(fmt::format("it ended with status {}: {}", finished.status, last_line(finished.output)));
  return from_output(finished.output);
}

} // namespace

Solver birdstrike_solver()
{
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  return {"birdstrike", [self](const Work& work) {
            std::vector<std::string> command{self,
                                             "--one",
                                             fmt::format("{}", work.spacing * 1e3),
                                             "--steps",
                                             std::to_string(work.steps),
                                             "--threads",
                                             std::to_string(work.threads)};
            if (work.skip)
              command.push_back("--skip-undisturbed");
            return result_of(run_program(command, work.threads));
          }};
}

std::optional<Python> find_pysph(const std::string& wish)
{
  const std::vector<std::string> programs =
      wish.empty() ? std::vector<std::string>{"python3", "/usr/bin/python3"} : std::vector<std::string>{wish};
  for (const std::string& program : programs) {
    const Finished answer = run_program({program, "-c", "import pysph; print(pysph.__version__)"}, 1);
    if (answer.status == 0 && !last_line(answer.output).empty())
      return Python{program, last_line(answer.output)};
  }
  return std::nullopt;
}

Solver pysph_solver(const Python& python)
{
  return {"pysph", [python](const Work& work) {
            return result_of(run_program({python.program, BIRDSTRIKE_PYSPH_SCRIPT, "--spacing",
                                          fmt::format("{}", work.spacing), "--steps",
                                          std::to_string(work.steps), "--warm-up", std::to_string(warm_up),
                                          work.threads > 1 ? "--openmp" : "--no-openmp", "--disable-output"},
                                         work.threads));
          }};
}

} // namespace birdstrike::peers
