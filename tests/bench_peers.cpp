// SPDX-License-Identifier: GPL-3.0-or-later
// Particle updates per second of BirdStrike and of PySPH, measured in one go on the same impact (bench_peers/bird_impact.h):
//   bench_peers [--sizes 3,1.5,0.76] [--threads 1,2] [--steps 500,100,20] [--repeats 3] [--json FILE]
// Exit status 1 if a run had to be rejected, 2 if what was asked for is wrong.
#include "bench_peers/bird_impact.h"
#include "bench_peers/comparison.h"
#include "core/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <omp.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

using namespace birdstrike;
using namespace birdstrike::peers;

namespace {

struct Options
{
  std::vector<double> sizes{3, 1.5, 0.76}; // [mm]
  std::vector<int> threads;
  std::vector<long> steps;
  int repeats = 3;
  double one = 0; // [mm]
  bool skip = false;
  bool no_peer = false;
  std::string pysph, json;
};

//! Into the impact, and some seconds for the slowest solver.
long usual_steps(double millimetres) { return millimetres > 2.5 ? 500 : millimetres > 1.2 ? 100 : 20; }

std::vector<Work> works_of(const Options& options)
{
  require(options.steps.empty() || options.steps.size() == 1 || options.steps.size() == options.sizes.size(),
          fmt::format("--steps has {} numbers for {} of --sizes; give one for all, or one for each",
                      options.steps.size(), options.sizes.size()));
  std::vector<int> threads = options.threads;
  if (threads.empty())
    threads = omp_get_num_procs() > 1 ? std::vector<int>{1, omp_get_num_procs()} : std::vector<int>{1};
  std::vector<Work> works;
  for (std::size_t k = 0; k < options.sizes.size(); ++k)
    for (const int count : threads) {
      const long steps = options.steps.empty()       ? usual_steps(options.sizes[k])
                         : options.steps.size() == 1 ? options.steps.front()
                                                     : options.steps[k];
      works.push_back(
          {.spacing = options.sizes[k] * 1e-3, .steps = steps, .threads = count, .skip = options.skip});
    }
  return works;
}

int run(const Options& options)
{
  if (options.one > 0) {
    Options alone = options;
    alone.sizes = {options.one};
    std::cout << to_line(measure(works_of(alone).front())) << std::endl;
    return 0;
  }
  const std::vector<Work> works = works_of(options);
  std::ofstream file;
  if (!options.json.empty()) { // before the minutes that the runs take
    file.open(options.json);
    if (!file)
      throw OutputError("--json " + options.json + ": cannot be written");
  }

  std::vector<Solver> solvers{birdstrike_solver()};
  std::optional<Python> python;
  if (!options.no_peer) {
    python = find_pysph(options.pysph);
    if (python)
      solvers.push_back(pysph_solver(*python));
    else
      fmt::print(
          "PySPH is not there ({} cannot import pysph), so BirdStrike is measured alone; to compare: apt "
          "install python3-pysph\n",
          options.pysph.empty() ? "python3" : options.pysph);
  }

  double load = 0; // of others: a run on a busy machine says little
  getloadavg(&load, 1);
  const Comparison comparison = compare(solvers, works, options.repeats);
  const std::string machine =
      fmt::format("{} processors, load before the runs {:.2f}", omp_get_num_procs(), load);
  fmt::print("\nBirdStrike and {}: 0.55 kg at 200 m/s on a rigid plate; {}; best of {}.\n",
             python ? "PySPH " + python->version : "no peer", machine, options.repeats);
  fmt::print("{}", to_table(comparison));
  if (file.is_open()) {
    nlohmann::ordered_json all{{"processors", omp_get_num_procs()},
                               {"load_before", load},
                               {"repeats", options.repeats},
                               {"pysph", python ? nlohmann::ordered_json(python->version) : nullptr}};
    all.update(to_json(comparison));
    file << all.dump(2) << std::endl;
    if (!file)
      throw OutputError("--json " + options.json + ": cannot be written");
  }
  return comparison.sound() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  CLI::App app("Particle updates per second of BirdStrike and of PySPH on the same impact.");
  app.add_option("--sizes", options.sizes, "spacings of particles [mm]")
      ->delimiter(',')
      ->check(CLI::Range(0.3, 12.0))
      ->capture_default_str();
  app.add_option("--threads", options.threads, "numbers of threads; default: 1 and all")
      ->delimiter(',')
      ->check(CLI::Range(1, 4096));
  app.add_option(
         "--steps", options.steps,
         "timed steps, one number or one a size; default: 500 above 2.5 mm, 100 above 1.2 mm, else 20")
      ->delimiter(',')
      ->check(CLI::Range(1, 1000000));
  app.add_flag(
      "--skip-undisturbed", options.skip,
      "BirdStrike may leave particles alone that nothing has reached yet, as it does in its own runs; "
      "smoothing lengths are held then");
  app.add_option("--repeats", options.repeats, "runs of each")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--pysph", options.pysph, "Python that has PySPH; default: python3, or Debian's");
  app.add_flag("--no-peer", options.no_peer, "BirdStrike alone");
  app.add_option("--json", options.json, "file for the same as JSON");
  app.add_option("--one", options.one,
                 "one run of BirdStrike at this spacing [mm] in this process, as a line of JSON")
      ->check(CLI::Range(0.3, 12.0));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    return run(options);
  } catch (const InputError& error) {
    std::cerr << "bench_peers: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "bench_peers: " << error.what() << "\n";
    return 1;
  }
}
