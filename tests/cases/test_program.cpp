// SPDX-License-Identifier: GPL-3.0-or-later
// The real program on wrong input: exit status, message, and nothing left that looks complete.
#include "scratch.h"

#include "vtkio/series_reader.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <vtkUnstructuredGrid.h>

#include <sstream>

using scratch::box;
using scratch::box_case;
using scratch::Outcome;
using scratch::program;

namespace {

struct Refusal
{
  scratch::Folder folder;

  Refusal()
  {
    folder.write("case.toml", box_case);
    folder.write("box.obj", box("torso", 0.1, 0.05, 0.05));
  }

  //! The run is refused with that status and one line that holds all of \p words.
  void expect(const std::string& arguments, int status, const std::vector<std::string>& words) const
  {
    const Outcome outcome = program(folder.path, "run case.toml -o out --quiet " + arguments);
    INFO(outcome.output);
    CHECK(outcome.status == status);
    std::istringstream lines(outcome.output);
    int errors = 0;
    for (std::string line; std::getline(lines, line);) { // warnings about the mesh may come before
      errors += line.starts_with("birdstrike: error: ");
      CHECK((line.starts_with("birdstrike: error: ") ||
             (errors == 0 && line.starts_with("birdstrike: warning: "))));
    }
    CHECK(errors == 1);
    for (const std::string& word : words)
      CHECK_THAT(outcome.output, Catch::Contains(word));
    CHECK_FALSE(fs::exists(folder.path / "out"));
  }
};

} // namespace

TEST_CASE("wrong keys and values end with status 2 and one sentence", "[cases][program][errors]")
{
  const Refusal run;
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = box_case;
    text.replace(text.find(from), from.size(), to);
    run.folder.write("case.toml", text);
  };
  with("spacing", "spcing");
  run.expect("", 2, {"case.toml:5: unknown key bird.spcing; did you mean bird.spacing?"});
  with("\"10 mm\"", "\"10\"");
  run.expect("", 2, {"case.toml:5: bird.spacing", "the unit is missing", "for example \"6 mm\""});
  with("\"10 mm\"", "\"6 kg\"");
  run.expect("", 2, {"case.toml:5: bird.spacing = \"6 kg\": a length is needed, for example \"6 mm\""});
  with("\"10 mm\"", "\"-10 mm\"");
  run.expect("", 2, {"case.toml:5: bird.spacing = \"-10 mm\": allowed is above 0 m"});
  with("\"10 mm\"", "\"0 mm\"");
  run.expect("", 2, {"case.toml:5: bird.spacing = \"0 mm\": allowed is above 0 m"});
}

TEST_CASE("wrong meshes end with status 2 and one sentence", "[cases][program][errors]")
{
  const Refusal run;
  run.expect("--set bird.mesh=none.obj", 2,
             {"case.toml: bird.mesh = \"none.obj\": no such file; looked for", "share/meshes"});

  run.folder.write("empty.obj", "o torso\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  run.expect("--set bird.mesh=empty.obj", 2, {"empty.obj", "empty of faces"});
  run.folder.write("nothing.obj", "");
  run.expect("--set bird.mesh=nothing.obj", 2, {"nothing.obj"});
  run.folder.write("text.obj", "this is not a mesh at all\n");
  run.expect("--set bird.mesh=text.obj", 2, {"text.obj"});

  run.folder.write("open.obj", box("torso", 0.1, 0.05, 0.05, 5));
  run.expect("--set bird.mesh=open.obj --set bird.strict=true", 2, {"open.obj", "torso", "open"});
}

TEST_CASE("a spacing that the memory cannot hold ends with status 2", "[cases][program][errors]")
{
  const Refusal run;
  run.expect("--set bird.spacing='0.01 mm'", 2, {"case.toml: bird.spacing: ", "particles", "fits"});
  run.expect("--set bird.spacing='1 nm'", 2, {"case.toml: bird.spacing: ", "particles", "fits"});
  run.folder.write("case.toml", scratch::read(BIRDSTRIKE_SOURCE_DIR "/cases/goose-on-rigid-plate.toml"));
  run.expect("--set bird.spacing='100 mm'", 2, {"case.toml: bird.spacing: ", "'head'", "or less"});
}

TEST_CASE("an output folder that cannot be written ends with status 1", "[cases][program][errors]")
{
  const Refusal run;
  run.folder.write("file", "x");
  for (const char* place : {"file", "file/below", "/proc/nowhere"}) {
    const Outcome outcome = program(run.folder.path, std::string("run case.toml --quiet -o ") + place);
    INFO(outcome.output);
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.output, Catch::Contains("birdstrike: error: " + std::string(place)));
    CHECK_THAT(outcome.output, Catch::Contains("choose another one with -o"));
  }
  CHECK(scratch::read(run.folder.path / "file") == "x");
}

TEST_CASE("a run that is killed or fails leaves no summary, and its successor leaves no mix",
          "[cases][program]")
{
  const Refusal run;
  const fs::path out = run.folder.path / "out";
  REQUIRE(program(run.folder.path, "run case.toml -o out --quiet --no-figures --threads 1").status == 0);
  REQUIRE(fs::exists(out / "summary.json"));
  run.folder.write("out/mine.txt", "keep");

  // Too long to end; killed when it has written more frames than the first run had.
  const Outcome killed =
      scratch::killed_program(run.folder.path,
                              "run case.toml -o out --quiet --no-figures --threads 1 --set run.end='1 s' "
                              "--set run.frames=100000 --set series.format=both",
                              "out/frames/bird_0009.vtu");
  CHECK(killed.status == 128 + 9);
  CHECK_FALSE(fs::exists(out / "summary.json"));
  CHECK(fs::exists(out / "run.pvd"));
  CHECK(scratch::read(out / "histories.csv").starts_with("time[s],"));
  CHECK(fs::exists(out / "mine.txt"));

  // The series of the killed run can be read as far as it goes.
  const Outcome histories = program(run.folder.path, "histories out/run.pvd -o killed.csv");
  INFO(histories.output);
  CHECK(histories.status == 0);
  CHECK(scratch::read(run.folder.path / "killed.csv").find("max_pressure_torso[Pa]") != std::string::npos);

  const auto packed = birdstrike::read_series_index(out / "run.bss");
  REQUIRE(packed.steps.size() >= 9);
  CHECK(birdstrike::read_frame(packed, packed.steps.size() - 1).bird->GetNumberOfPoints() > 0);

  REQUIRE(program(run.folder.path, "run case.toml -o out --quiet --no-figures --threads 1").status == 0);
  CHECK(fs::exists(out / "summary.json"));
  CHECK_FALSE(fs::exists(out / "frames/bird_0005.vtu"));
  CHECK_FALSE(fs::exists(out / "run.bss"));
  CHECK(fs::exists(out / "mine.txt"));
}

TEST_CASE("misuse of the command line ends with status 2, help with 0", "[cases][program][errors]")
{
  const scratch::Folder folder;
  for (const char* arguments :
       {"", "fly", "run", "run nothing.toml", "run goose-on-rigid-plate --set", "bird x.obj",
        "run goose-on-rigid-plate --threads=-1", "cases --show nothing", "histories nothing.pvd -o h.csv",
        "render nothing.pvd -o d", "cases --keys --show x"})
  {
    const Outcome outcome = program(folder.path, arguments);
    INFO(arguments << "\n" << outcome.output);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.output, Catch::StartsWith("birdstrike: error: "));
  }
  CHECK(fs::is_empty(folder.path));
  for (const char* arguments : {"--help", "--version", "run --help", "bird --help", "histories --help",
                                "render --help", "report --help", "cases --help", "cases --keys"})
  {
    INFO(arguments);
    CHECK(program(folder.path, arguments).status == 0);
  }
}

TEST_CASE("the catalogue lists its cases and prints them", "[cases][program]")
{
  const scratch::Folder folder;
  CHECK_THAT(program(folder.path, "cases").output,
             Catch::Contains("goose-on-rigid-plate") &&
                 Catch::Contains("4 kg goose at 150 m/s on a rigid plate"));
  CHECK(program(folder.path, "cases --show goose-on-rigid-plate").output ==
        scratch::read(BIRDSTRIKE_SOURCE_DIR "/cases/goose-on-rigid-plate.toml"));
}

TEST_CASE("a bare mesh becomes particles", "[cases][program]")
{
  const scratch::Folder folder;
  folder.write("box.obj", box("torso", 0.1, 0.05, 0.05));
  const Outcome wrong = program(folder.path, "bird box.obj -o bird.vtu --spacing '10 kg' --mass '0.8 kg'");
  CHECK(wrong.status == 2);
  CHECK_THAT(wrong.output, Catch::Contains("--spacing: bird.spacing = \"10 kg\": a length is needed"));
  CHECK_FALSE(fs::exists(folder.path / "bird.vtu"));
  const Outcome made = program(folder.path, "bird box.obj -o bird.vtu --spacing '10 mm' --mass '0.8 kg'");
  INFO(made.output);
  CHECK(made.status == 0);
  CHECK_THAT(made.output, Catch::Contains("torso") && Catch::Contains("2000") && Catch::Contains("0.60"));
  CHECK_THAT(scratch::read(folder.path / "bird.vtu"), Catch::Contains("NumberOfPoints=\"2000\""));
}

TEST_CASE("a run never writes over its own case file", "[cases][program][errors]")
{
  const Refusal run;
  const std::string before = scratch::read(run.folder.path / "case.toml");
  const Outcome outcome = program(run.folder.path, "run case.toml -o . --quiet");
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.output, Catch::Contains("this very file"));
  CHECK(scratch::read(run.folder.path / "case.toml") == before);
}

TEST_CASE("without a mass a bare mesh weighs what its materials give", "[cases][program]")
{
  const scratch::Folder folder;
  folder.write("box.obj", box("torso", 0.1, 0.05, 0.05));
  const Outcome made = program(folder.path, "bird box.obj -o bird.csv --spacing '10 mm' --report bird.json");
  INFO(made.output);
  CHECK(made.status == 0);
  const auto report = nlohmann::json::parse(scratch::read(folder.path / "bird.json"));
  CHECK(report.at("mass").get<double>() == Approx(0.002 * (0.4 * 1000 + 0.6 * 1.225)));
  CHECK(report.at("mesh_inertia")[0][0].get<double>() ==
        Approx(report.at("mass").get<double>() * (0.01 + 0.01) / 12)); // 0.1 m wide and high
  CHECK_THAT(scratch::read(folder.path / "bird.csv"), Catch::Contains("x[m]"));
}

TEST_CASE("a bird goes to surfaces, decks of three solvers and a picture", "[cases][program]")
{
  const scratch::Folder folder;
  folder.write("head.obj", box("a", 0.02, 0.02, 0.02, 6));
  folder.write("torso.obj", box("b", 0.1, 0.05, 0.05));
  const Outcome made =
      program(folder.path,
              "bird torso.obj --mesh-unit '1 m' --nose +x --up +z --spacing '10 mm' --velocity '100 m/s' "
              "--set bird.parts.torso.porosity=0.4 --set 'bird.parts.torso.objects=[\"b\"]' -o bird.vtp "
              "-o bird.obj --export dyna --export radioss --export abaqus --snapshot bird.png --points");
  INFO(made.output);
  CHECK(made.status == 0);
  for (const char* file :
       {"bird.vtp", "bird.obj", "bird.k", "bird_0000.rad", "bird_0001.rad", "bird.inp", "bird.png"})
    CHECK(fs::file_size(folder.path / file) > 150);
  const Outcome wrong = program(folder.path, "bird torso.obj -o bird.vtu --export ansys");
  CHECK(wrong.status == 2);
  CHECK_THAT(wrong.output, Catch::Contains("dyna") && Catch::Contains("ansys"));
  const Outcome nothing = program(folder.path, "bird torso.obj");
  CHECK(nothing.status == 2);
  CHECK_THAT(nothing.output, Catch::Contains("nothing to write"));
}

TEST_CASE("options of bird are keys of the case, and wrong endings and folders are refused",
          "[cases][program][errors]")
{
  const Refusal run;
  const Outcome mass = program(run.folder.path, "bird case.toml --mass '1.3 kg' -o bird.vtu");
  INFO(mass.output);
  CHECK(mass.status == 0);
  CHECK_THAT(mass.output, Catch::Contains("1.3 kg"));
  const Outcome ending = program(run.folder.path, "bird case.toml -o bird.docx");
  CHECK(ending.status == 2);
  CHECK_THAT(ending.output, Catch::Contains("bird.docx") && Catch::Contains(".vtu") && Catch::Contains(".k"));
  const Outcome folder = program(run.folder.path, "bird case.toml -o none/bird.vtu");
  CHECK(folder.status == 1);
  CHECK_THAT(folder.output, Catch::StartsWith("birdstrike: error: none/bird.vtu"));
}

TEST_CASE("a shape alone becomes a number of particles, or says what it lacks", "[cases][program]")
{
  const scratch::Folder folder;
  folder.write("shape.toml", "[bird]\nshape = \"capsule\"\nmass = \"0.5 kg\"\nparticles = 4000\n");
  const Outcome bare = program(folder.path, "bird shape.toml -o bird.vtu");
  CHECK(bare.status == 2);
  CHECK_THAT(bare.output, Catch::Contains("bird.parts is missing"));
  CHECK_FALSE(fs::exists(folder.path / "bird.vtu"));
  folder.write("shape.toml",
               "[bird]\nshape = \"capsule\"\nmass = \"0.5 kg\"\nparticles = 4000\n[bird.parts]\n"
               "torso = { porosity = 0.4 }\n");
  const Outcome made = program(folder.path, "bird shape.toml -o bird.vtu --report bird.json");
  INFO(made.output);
  REQUIRE(made.status == 0);
  const auto report = nlohmann::json::parse(scratch::read(folder.path / "bird.json"));
  CHECK(std::abs(report.at("particles").get<double>() / 4000 - 1) < 0.03);
  CHECK(report.at("mass").get<double>() == Approx(0.5).epsilon(1e-9));
}

TEST_CASE("no output is written where one of them cannot be made", "[cases][program][errors]")
{
  const scratch::Folder folder;
  folder.write("box.obj", box("torso", 0.1, 0.05, 0.05));
  const Outcome outcome = program(folder.path, "bird box.obj --spacing '1 nm' -o bird.glb -o bird.vtu");
  CHECK(outcome.status == 2);
  CHECK_FALSE(fs::exists(folder.path / "bird.glb"));
}

TEST_CASE("an unknown command is answered with the nearest, a wrong option with its command's help",
          "[cases][program][errors]")
{
  const scratch::Folder folder;
  const Outcome wrong = program(folder.path, "rendr out");
  CHECK(wrong.status == 2);
  CHECK_THAT(wrong.output, Catch::Contains("no command \"rendr\"; did you mean render?"));
  const Outcome option = program(folder.path, "report out --frame 5");
  CHECK(option.status == 2);
  CHECK_THAT(option.output, Catch::Contains("--frame") && Catch::Contains("birdstrike report --help"));
  CHECK(program(folder.path, "").status == 2);
}
