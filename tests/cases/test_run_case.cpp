// SPDX-License-Identifier: GPL-3.0-or-later
// The main job, coarse, from its real files to everything that it leaves, by the real program.
#include "scratch.h"

#include "cases/case.h"
#include "core/fields.h"
#include "target_cases.h"
#include "vtkio/series_reader.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <map>
#include <sstream>
#include <vector>

using scratch::Outcome;
using scratch::program;

namespace {

//! Of the bird's momentum: sums over pairs are made in single precision; 1.1e-9 was the most that was seen here.
constexpr double momentum_kept = 5e-9;

//! A CSV file by its titles.
std::map<std::string, std::vector<double>> read_csv(const fs::path& file)
{
  std::map<std::string, std::vector<double>> table;
  std::vector<std::string> titles;
  std::ifstream in(file);
  std::string line, cell;
  std::getline(in, line);
  for (std::istringstream cells(line); std::getline(cells, cell, ',');)
    titles.push_back(cell);
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    for (const std::string& title : titles) {
      std::getline(cells, cell, ',');
      table[title].push_back(cell.empty() ? NAN : std::stod(cell));
    }
  }
  return table;
}

const std::string goose = "run goose-on-rigid-plate --quiet ";

} // namespace

TEST_CASE("the main job leaves everything that it promises", "[cases][run]")
{
  const scratch::Folder folder;
  const Outcome outcome =
      program(folder.path,
              "run goose-on-rigid-plate -o out --threads 1 --set bird.spacing='18 mm' --set run.frames=14");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  const fs::path out = folder.path / "out";

  SECTION("files, summary, histories, echo, log")
  {
    for (const char* name :
         {"case.toml", "run.pvd", "frames/bird_0000.vtu", "frames/bird_0014.vtu", "frames/target_0014.vtu",
          "histories.csv", "summary.json", "run.log", "figures/by_part_0.png", "figures/by_part_7.png",
          "figures/by_part.png", "figures/overview.png", "figures/by_pressure_0.png",
          "figures/by_pressure_7.png", "figures/by_pressure.png", "figures/maximum_pressure.png",
          "figures/contact_force.png"})
    {
      INFO(name);
      CHECK(fs::exists(out / name));
      CHECK((fs::exists(out / name) && fs::file_size(out / name) > 100));
    }
    CHECK_FALSE(fs::exists(out / "frames/bird_0015.vtu"));
    for (const fs::directory_entry& item : fs::recursive_directory_iterator(out))
      CHECK(item.path().extension() != ".tmp");

    const auto summary = nlohmann::json::parse(scratch::read(out / "summary.json"));
    CHECK(std::abs(summary.at("bird").at("mass").get<double>() / 4 - 1) < 1e-12);
    CHECK(summary.at("bird").at("momentum").get<double>() == Approx(600).epsilon(1e-12));
    CHECK(summary.at("impulse_error").get<double>() < momentum_kept);
    const double lost = summary.at("bird").at("momentum").get<double>() -
                        summary.at("bird").at("final_momentum").get<double>();
    CHECK(summary.at("impulse").get<double>() == Approx(lost).epsilon(1e-9));
    CHECK(summary.at("impulse_over_momentum").get<double>() > 0.95); // all of the bird has met the plate
    CHECK(summary.at("impulse_over_momentum").get<double>() < 1.5);
    CHECK(summary.at("energy").at("initial").get<double>() == Approx(0.5 * 4 * 150 * 150).epsilon(1e-12));
    CHECK(summary.at("energy").at("balance_error").get<double>() < 0.01);
    CHECK(summary.at("target").at("leaked_particles") == 0);
    CHECK(summary.at("target").at("max_deflection") == 0);
    for (const char* key : {"particles", "steps", "wall_seconds", "updates_per_second", "density_factor",
                            "contact_time", "shares", "series_bytes"})
      CHECK(summary.contains(key));
    std::uintmax_t bytes = 0;
    for (const fs::directory_entry& item : fs::directory_iterator(out / "frames"))
      bytes += item.file_size();
    CHECK(summary.at("series_bytes").get<std::uintmax_t>() == bytes);

    const auto histories = read_csv(out / "histories.csv");
    CHECK(histories.at("time[s]").size() == summary.at("steps").get<std::size_t>() + 1);
    CHECK(histories.at("time[s]").front() == 0);
    CHECK(histories.at("time[s]").back() == Approx(0.007).epsilon(1e-14));
    for (const char* part : {"all", "head", "neck", "torso", "wings", "bones", "lungs"}) {
      INFO(part);
      const auto& column = histories.at(std::string("max_pressure_") + part + "[Pa]");
      const double peak = *std::max_element(column.begin(), column.end());
      CHECK(summary.at("peak_pressure").at(part).at("value").get<double>() == peak);
      CHECK(peak > 1e6);
    }
    CHECK(histories.at("impulse_x[N s]").back() ==
          Approx(summary.at("impulse").get<double>()).epsilon(1e-12));

    // The echo runs again to the same result.
    const auto echo = birdstrike::read_case(out / "case.toml");
    CHECK(echo.bird.spacing == 0.018);
    CHECK(echo.run.frames == 14);

    // The log has what the screen showed.
    const std::string log = scratch::read(out / "run.log");
    std::istringstream screen(outcome.output);
    for (std::string line; std::getline(screen, line);) {
      if (const std::string mark = "birdstrike: warning: "; line.starts_with(mark))
        line.erase(0, mark.size()); // the file has its own mark
      CHECK(log.find(line) != std::string::npos);
    }
    CHECK_THAT(outcome.output, Catch::Contains(" 50 %") && Catch::Contains("energy balance error"));
  }

  SECTION("the filters see on the frames what was recorded at every step")
  {
    const Outcome filtered = program(folder.path, "histories out/run.pvd -o frames.csv");
    INFO(filtered.output);
    REQUIRE(filtered.status == 0);
    const auto frames = read_csv(folder.path / "frames.csv");
    const auto steps = read_csv(out / "histories.csv");
    REQUIRE(frames.at("time[s]").size() == 15);
    const auto& time = steps.at("time[s]");
    for (const char* part : {"all", "head", "neck", "torso", "wings", "bones", "lungs"}) {
      const std::string title = std::string("max_pressure_") + part + "[Pa]";
      const auto& at_steps = steps.at(title);
      const double peak = *std::max_element(at_steps.begin(), at_steps.end());
      for (std::size_t frame = 0; frame < 15; ++frame) {
        INFO(title << ", frame " << frame);
        const auto step = std::find(time.begin(), time.end(), frames.at("time[s]")[frame]) - time.begin();
        REQUIRE(step < std::ptrdiff_t(time.size()));
        const auto written = [](double value) { return static_cast<double>(static_cast<float>(value)); };
        CHECK(frames.at(title)[frame] == written(at_steps[step])); // series.precision = "single"
        CHECK(frames.at(title)[frame] <= written(peak));
      }
    }
    const auto summary = nlohmann::json::parse(scratch::read(out / "summary.json"));
    const auto& seen = frames.at("max_pressure_all[Pa]");
    CHECK(summary.at("peak_pressure_on_frames").get<double>() ==
          Approx(*std::max_element(seen.begin(), seen.end())).epsilon(1e-7)); // of double precision
    for (const double deflection : frames.at("max_deflection[m]"))
      CHECK(deflection == 0);
  }
}

TEST_CASE("the same case gives the same bytes, with any number of threads", "[cases][run]")
{
  const scratch::Folder folder;
  const std::string run =
      goose + "--no-figures --set bird.spacing='20 mm' --set run.end='3 ms' --set run.frames=3 ";
  REQUIRE(program(folder.path, run + "--threads 1 -o one").status == 0);
  REQUIRE(program(folder.path, run + "--threads 2 -o two").status == 0);
  REQUIRE(program(folder.path, "run one/case.toml --quiet --no-figures --threads 2 -o again").status == 0);
  const std::string one = scratch::read(folder.path / "one/histories.csv");
  CHECK(one.size() > 10000);
  CHECK(one == scratch::read(folder.path / "two/histories.csv"));
  CHECK(one == scratch::read(folder.path / "again/histories.csv"));
  CHECK(scratch::read(folder.path / "one/frames/bird_0003.vtu") ==
        scratch::read(folder.path / "two/frames/bird_0003.vtu"));
}

TEST_CASE("a bird that misses the plate keeps its momentum and the run says so", "[cases][run]")
{
  const scratch::Folder folder;
  folder.write("box.obj", scratch::box("torso", 0.1, 0.05, 0.05));
  folder.write("case.toml", scratch::box_case);
  const Outcome outcome =
      program(folder.path, "run case.toml -o out --no-figures --threads 1 --set bird.gap='1 m'");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.output, Catch::Contains("first contact          none"));
  const auto summary = nlohmann::json::parse(scratch::read(folder.path / "out/summary.json"));
  CHECK(summary.at("impulse") == 0);
  CHECK(summary.at("contact_time").is_null());
}

TEST_CASE("a target that bends leaves its frames, histories and numbers", "[cases][run][target]")
{
  const scratch::Folder folder;
  folder.write("sheet.toml", "name = \"sheet\"\ndensity = \"2.7 g/cm3\"\nyoung = \"70 GPa\"\npoisson = 0.33\n"
                             "[plasticity]\nlaw = \"linear\"\nyield = \"100 MPa\"\n"
                             "[failure]\nlaw = \"plastic-strain\"\nlimit = 0.05\n");
  folder.write("case.toml",
               target_cases::bird + std::string(target_cases::plate) +
                   "rigid = false\nmaterial = \"sheet.toml\"\ncontact = \"penalty\"\nfriction = 0.1\n"
                   "[deflections.middle]\nat = [\"0 m\", \"0 m\", \"0 m\"]\n");
  const Outcome outcome = program(folder.path, "run case.toml -o out --threads 1");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  const fs::path out = folder.path / "out";
  const auto summary = nlohmann::json::parse(scratch::read(out / "summary.json"));
  const auto histories = read_csv(out / "histories.csv");

  SECTION("frames have all fields")
  {
    const auto index = birdstrike::read_series_index(out / "run.pvd");
    REQUIRE(index.steps.size() == 4);
    const auto frame = birdstrike::read_frame(index, 3);
    REQUIRE(frame.target);
    CHECK(frame.target->GetNumberOfCells() == 24);
    for (const auto& field : birdstrike::mesh_target_fields)
      CHECK(frame.target->GetCellData()->HasArray(std::string(field.name).c_str()));
    for (const auto& field : birdstrike::shell_fields)
      CHECK(frame.target->GetCellData()->HasArray(std::string(field.name).c_str()));
    for (const char* name : {"displacement", "velocity"})
      CHECK(frame.target->GetPointData()->HasArray(name));
    for (const char* name : {"target_deflection.png", "target_plastic_strain.png", "deflection.png"})
      CHECK(fs::exists(out / "figures" / name));
  }

  SECTION("histories and summary agree, and the balances hold")
  {
    for (const auto& [title, column] : histories) {
      INFO(title);
      const std::size_t open = title.find('[');
      CHECK((open != std::string::npos && open > 0 && title.ends_with("]") && title.size() > open + 2));
      CHECK(column.size() == summary.at("steps").get<std::size_t>() + 1);
    }
    const auto& deflection = histories.at("max_deflection[m]");
    const auto& target = summary.at("target");
    const auto peak = std::max_element(deflection.begin(), deflection.end());
    CHECK(*peak > 1e-4);
    CHECK(target.at("max_deflection").get<double>() == *peak);
    CHECK(target.at("max_deflection_time").get<double>() ==
          histories.at("time[s]")[std::size_t(peak - deflection.begin())]);
    CHECK(target.at("permanent_set").get<double>() > 0);
    CHECK(target.at("permanent_set").get<double>() <= *peak);
    CHECK(target.at("residual_amplitude").get<double>() > 0); // still moving
    CHECK(target.at("mass").get<double>() == Approx(2700 * 0.2 * 0.3 * 0.002));
    CHECK(target.at("leaked_particles") == 0);
    CHECK(target.at("eroded_elements").get<double>() == histories.at("eroded_elements[-]").back());
    CHECK(target.at("initial_gap").get<double>() ==
          Approx(0.01).epsilon(1e-9)); // a sphere flies straight at a plate
    CHECK(target.at("deflections").at("middle").at("value").get<double>() > 1e-4);
    CHECK(target.at("deflections").at("middle").at("value").get<double>() <= *peak);
    CHECK(target.at("energy").at("plastic").get<double>() == histories.at("plastic_energy[J]").back());
    CHECK(target.at("hourglass_over_internal").get<double>() < 0.2);
    CHECK(summary.at("energy").at("contact").at("friction").get<double>() >= 0);
    CHECK(summary.at("energy").at("balance_error").get<double>() < 0.02);
    CHECK(summary.at("impulse_error").get<double>() < momentum_kept);
    CHECK(summary.at("contact_time").get<double>() == Approx(0.01 / 120).epsilon(1e-12));
    CHECK(summary.at("first_force_time").get<double>() == Approx(0.01 / 120).margin(5e-6));
    CHECK(histories.at("support_impulse_x[N s]").back() < 0);
    CHECK_THAT(outcome.output,
               Catch::Contains("largest deflection") && Catch::Contains("support edges: 20 nodes, clamped"));
    CHECK_THAT(outcome.output, Catch::Contains("about which it still swings by"));
  }

  SECTION("the echo runs again to the same bytes, wherever it stands")
  {
    fs::create_directories(folder.path / "elsewhere");
    fs::copy_file(out / "case.toml", folder.path / "elsewhere/case.toml");
    const Outcome again =
        program(folder.path, "run elsewhere/case.toml -o again --no-figures --threads 2 --quiet");
    INFO(again.output);
    REQUIRE(again.status == 0);
    CHECK(scratch::read(out / "histories.csv") == scratch::read(folder.path / "again/histories.csv"));
    CHECK(scratch::read(out / "frames/target_0003.vtu") ==
          scratch::read(folder.path / "again/frames/target_0003.vtu"));
    CHECK(scratch::read(out / "case.toml") == scratch::read(folder.path / "again/case.toml"));
  }
}

TEST_CASE("every shape runs, rigid and not", "[cases][run][target]")
{
  const scratch::Folder folder;
  folder.write("skin.obj",
               "v 0 -0.1 -0.1\nv 0 0.1 -0.1\nv 0.02 0.1 0.1\nv 0.02 -0.1 0.1\nf 1 2 3\nf 1 3 4\n");
  const std::string few =
      " --no-figures --threads 1 --quiet --set run.end='0.25 ms' --set run.frames=1 --set bird.gap='20 mm'";
  const std::pair<std::string, std::string> shapes[] = {
      {"windshield",
       "windshield = { radius = \"0.5 m\", arc_width = \"0.3 m\", height = \"0.3 m\", elements_width = 6, "
       "elements_height = 6 }\n"},
      {"leading-edge", "leading_edge = { span = \"0.3 m\", elements_around = 12, elements_span = 8 }\n"},
      {"blade", "blade = { elements_chord = 4, elements_span = 10, strips = 2, stagger = \"30 deg\", twist = "
                "\"20 deg\" }\n"},
      {"mesh", "mesh = { file = \"skin.obj\", thickness = \"3 mm\" }\n"}};
  for (const auto& [shape, table] : shapes)
    for (const bool rigid : {true, false}) {
      INFO(shape << ", rigid " << rigid);
      std::string target = target_cases::shape(shape, table);
      if (!rigid)
        target += "rigid = false\nmaterial = \"al-2024-t3\"\n";
      if (!rigid && shape == "mesh")
        target += "supports.rim = { nodes = \"boundary\", fix = \"simply-supported\", low = [\"-1 m\", \"-1 "
                  "m\", \"-1 m\"], "
                  "high = [\"1 m\", \"1 m\", \"-0.09 m\"] }\n";
      folder.write("case.toml", target_cases::bird + target);
      const Outcome outcome = program(folder.path, "run case.toml -o out" + few);
      INFO(outcome.output);
      REQUIRE(outcome.status == 0);
      const auto summary = nlohmann::json::parse(scratch::read(folder.path / "out/summary.json"));
      CHECK(summary.at("impulse").get<double>() > 0);
      CHECK(summary.at("impulse_error").get<double>() < momentum_kept);
      CHECK(summary.at("target").at("leaked_particles") == 0);
      CHECK((summary.at("target").at("max_deflection").get<double>() > 1e-6) == !rigid);
      // Viscosity reaches some 0.7 spacings ahead, across the surface, which leans by up to 45 degrees.
      const double felt = summary.at("first_force_time").get<double>();
      CHECK(felt < 0.02 / 120 + 1e-5);
      CHECK(felt > (0.02 - 1.5 * 0.008) / 120);
    }
}

TEST_CASE("a run into a target that is stopped leaves nothing that looks complete", "[cases][run][target]")
{
  const scratch::Folder folder;
  folder.write("case.toml", target_cases::bird + target_cases::soft_plate());
  scratch::killed_program(folder.path,
                          "run case.toml -o out --threads 1 --set run.end='1 s' --set run.frames=10000",
                          "out/frames/target_0002.vtu");
  CHECK(fs::exists(folder.path / "out/frames/target_0000.vtu"));
  CHECK_FALSE(fs::exists(folder.path / "out/summary.json"));
  const auto index =
      birdstrike::read_series_index(folder.path / "out/run.pvd"); // what there is can be opened
  CHECK(birdstrike::read_frame(index, index.steps.size() - 1).target);
}

TEST_CASE("the main job as shipped", "[cases][run][long]")
{
  const scratch::Folder folder;
  const Outcome outcome = program(folder.path, goose + "-o out");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  const auto summary = nlohmann::json::parse(scratch::read(folder.path / "out/summary.json"));
  CHECK(summary.at("particles").get<int>() >= 20000);
  CHECK(summary.at("impulse_error").get<double>() < momentum_kept);
  CHECK(summary.at("energy").at("balance_error").get<double>() < 0.01);
  CHECK(summary.at("target").at("leaked_particles") == 0);
}
