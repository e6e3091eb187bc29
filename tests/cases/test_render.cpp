// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike render as a user calls it: pictures, montages, films, and what contradicts itself.
#include "cases/render_extent.h"
#include "cases/render_texts.h"
#include "core/error.h"
#include "scratch.h"
#include "tests/vtkio/made_run.h"
#include "vtkio/film_writer.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/series_writer.h"
#include "vtkio/shells_to_vtk.h"
#include "vtkio/shown_array.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>

using namespace birdstrike;
using Catch::Matchers::Contains;
using scratch::Outcome;
using scratch::program;

namespace {

//! A made-up series of seven frames, 0 to 3 ms, in a folder of its own.
struct MadeRun
{
  scratch::Folder folder;
  MadeRun()
  {
    SeriesWriter series(folder.path / "run");
    for (int k = 0; k < 7; ++k) {
      const double time = 0.5e-3 * k;
      series.write_frame(time, *particles_to_vtk(made_bird(0.016, k / 8.0), time),
                         plate_to_vtk(made_plate(), time));
    }
    folder.write("run/case.toml", "title = \"A made-up bird\"\n");
  }
  Outcome render(const std::string& options) const { return program(folder.path, "render run " + options); }
};

std::array<int, 2> size_of(const fs::path& png)
{
  auto reader = vtkSmartPointer<vtkPNGReader>::New();
  reader->SetFileName(png.c_str());
  reader->Update();
  return {reader->GetOutput()->GetDimensions()[0], reader->GetOutput()->GetDimensions()[1]};
}

} // namespace

TEST_CASE("render draws scenes at the times asked for, in the sizes asked for", "[cases][render]")
{
  const MadeRun run;
  Outcome outcome = run.render("-o a --scene cut --scene top --colour-by velocity_x --range '0 m/s,150 m/s' "
                               "--target-colour contact_pressure --times '0.4 ms,2.1 ms' --size 320x180 "
                               "--background dark --fit all");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  for (const char* scene : {"cut", "top"})
    for (const int k : {0, 1})
      CHECK(size_of(run.folder.path / "a" /
                    fmt::format("{}_by_velocity_x_target_by_contact_pressure_{}.png", scene, k)) ==
            std::array<int, 2>{320, 180});
  CHECK(std::distance(fs::directory_iterator(run.folder.path / "a"), {}) == 4);

  outcome = run.render("-o b --montage 2x2 --print '60 mm x 40 mm' --dpi 200");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  CHECK(size_of(run.folder.path / "b" / "side_by_part.png") == std::array<int, 2>{472, 315});
  CHECK(std::distance(fs::directory_iterator(run.folder.path / "b"), {}) == 1);

  outcome = run.render("-o c --frames 1 --no-bird --target-colour contact_force --singles --size 200x100");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  CHECK(fs::exists(run.folder.path / "c" / "side_target_by_contact_force_0.png"));
}

TEST_CASE("options of render that cannot be meant are refused with the remedy", "[cases][render][errors]")
{
  const MadeRun run;
  const std::pair<const char*, std::vector<const char*>> wrong[] = {
      {"--scene back", {"no scene \"back\"", "isometric, behind, cut"}},
      {"--colour-by heat", {"cannot colour by \"heat\"", "velocity_x", "pressure"}},
      {"--target-colour heat", {"cannot colour the target by \"heat\"", "contact_pressure"}},
      {"--range '0 MPa,1 MPa'", {"--range", "--colour-by pressure"}},
      {"--colour-by pressure --range '0,1'", {"\"0\"", "50 MPa"}},
      {"--colour-by pressure --range '0 kg,1 kg'", {"\"0 kg\"", "50 MPa"}},
      {"--colour-by pressure --range '2 MPa,1 MPa'", {"larger"}},
      {"--colour-by id --range '0 mm,1 mm'", {"id has no unit"}},
      {"--target-range '0 MPa,1 MPa'", {"--target-colour"}},
      {"--times '5 ms'", {"no frame at 5 ms", "0 to 3 ms"}},
      {"--times '1'", {"--times", "unit is missing"}},
      {"--times '1 ms' --frames 3", {"excludes"}},
      {"--frames none", {"--frames", "all"}},
      {"--montage 2x2 --frames 5", {"4 panels", "5 frames"}},
      {"--montage 2", {"--montage", "2x4"}},
      {"--size 20x20", {"20 x 20", "64"}},
      {"--size 100000x100000", {"--size", "1 to 16384"}},
      {"--size 3x99999999999999", {"--size", "1 to 16384"}},
      {"--size 2x", {"--size", "two whole numbers"}},
      {"--size 200x200 --print '20 mm'", {"excludes"}},
      {"--print '1 mm'", {"--print", "pixels"}},
      {"--dpi 100", {"--dpi", "--print"}},
      {"--cut-plane 'q = 1'", {"--cut-plane", "y = 12 mm"}},
      {"--cut-plane 'y = 1 mm' --scene side", {"--cut-plane", "--scene cut"}},
      {"--background sky", {"light, dark"}},
      {"--no-bird --no-target", {"nothing to draw"}},
      {"--no-bird --colour-by pressure", {"--colour-by"}},
      {"--view top --scene side", {"--view", "--scene"}},
      {"--fps 4", {"--film"}},
      {"--film f.avi", {".mp4"}},
      {"--film f.mp4 --montage 2x2", {"excludes"}},
      {"--film f.mp4 --scene side --scene top", {"one scene"}},
      {"--film f.mp4 --slow-down 10 --duration '1 s'", {"excludes"}},
  };
  for (const auto& [options, words] : wrong) {
    const Outcome outcome = run.render(std::string("-o out ") + options);
    INFO(options << ": " << outcome.output);
    CHECK(outcome.status == 2);
    CHECK(outcome.output.starts_with("birdstrike: error: "));
    for (const char* word : words)
      CHECK_THAT(outcome.output, Contains(word));
  }
  CHECK_FALSE(fs::exists(run.folder.path / "out"));
  CHECK_FALSE(fs::exists(run.folder.path / "f.mp4"));
  CHECK_THAT(run.render("--scene side").output, Contains("-o is missing"));
  CHECK_THAT(program(run.folder.path, "render . -o out").output, Contains("not the folder of a run"));
  CHECK_THAT(program(run.folder.path, "render run/case.toml -o out").output,
             Contains("run/case.toml is a case and not a run") && Contains("birdstrike run run/case.toml"));
  run.folder.write("run/histories.csv", "time[s],a[m]\n0,1\n1,2\n");
  CHECK_THAT(program(run.folder.path, "plot run --column a -o p.png --size 10x10").output,
             Contains("--size: \"10x10\"") && Contains("64 to 16384"));
}

TEST_CASE("VTK's own marks are no fields to colour by, and a series of others is told what it lacks",
          "[cases][render][errors]")
{
  const MadeRun run;
  const auto plate = plate_to_vtk(made_plate(), 0);
  auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghosts->SetName("vtkGhostType");
  for (vtkIdType k = 0; k < plate->GetNumberOfCells(); ++k)
    ghosts->InsertNextValue(0);
  plate->GetCellData()->AddArray(ghosts);
  const std::string names = names_of_arrays(*plate->GetCellData());
  CHECK_THAT(names, !Contains("vtkGhostType") && Contains("contact_pressure"));

  const std::string pvd = "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0\" part=\"0\" "
                          "file=\"run/frames/bird_0000.vtu\"/></Collection></VTKFile>";
  run.folder.write("foreign.pvd", pvd);
  for (const char* options : {"-o out", "-o out --scene side"}) {
    const Outcome outcome = program(run.folder.path, std::string("render foreign.pvd ") + options);
    INFO(outcome.output);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.output, Contains("in this series") && Contains("name=\"bird\"") && Contains("target"));
  }
}

TEST_CASE("a picture that is empty or cut off is warned of, debris is held", "[cases][render]")
{
  const MadeRun run;
  const Outcome empty = run.render("-o a --scene cut --cut-plane 'y = 12 m' --times '0 ms' --quiet");
  CHECK(empty.status == 0);
  CHECK_THAT(empty.output, Contains("cut_by_part_0.png: it is empty"));
  CHECK(run.render("-o b --scene front --scene isometric --quiet").output.empty());

  // A bird that slides along its target, further than its own length: no part of it is left out, whatever is fitted.
  {
    SeriesWriter series(run.folder.path / "slide");
    for (int k = 0; k < 4; ++k) {
      Particles bird = made_bird(0.016);
      for (std::size_t i = 0; i < bird.z.size(); ++i)
        bird.z[i] -= k * (0.2 + 0.8 * static_cast<double>(i) / static_cast<double>(bird.z.size()));
      series.write_frame(1e-3 * k, *particles_to_vtk(bird, 1e-3 * k), plate_to_vtk(made_plate(), 1e-3 * k));
    }
    SeriesFrames frames(run.folder.path / "slide" / "run.pvd", true, true);
    for (const Fit fit : {Fit::all, Fit::bird}) {
      const SeriesExtent extent = picture_extent(frames, {0, 1, 2}, {}, fit);
      const SnapshotOptions side =
          with_window(frames, {0, 1, 2}, extent, scene_options("side", extent.look), fit);
      double bounds[6];
      frames.get(2).bird->GetBounds(bounds);
      REQUIRE(side.window);
      CHECK((*side.window)[2] <= bounds[4] + 1e-6);
    }
  }

  // The same bird; a jet of 1 % of it ahead of the rest, and a tenth of it that flies off.
  for (const auto& [name, share, away] : {std::tuple("jet", 100, 0.25), std::tuple("burst", 10, 9.0)}) {
    SeriesWriter series(run.folder.path / name);
    for (int k = 0; k < 2; ++k) {
      Particles bird = made_bird(0.016);
      for (std::size_t i = 0; k == 1 && i < bird.x.size(); i += static_cast<std::size_t>(share))
        bird.z[i] += away;
      series.write_frame(1e-3 * k, *particles_to_vtk(bird, 1e-3 * k), plate_to_vtk(made_plate(), 1e-3 * k));
    }
    SeriesFrames frames(run.folder.path / name / "run.pvd", true, true);
    const SeriesExtent extent = picture_extent(frames, {0, 1}, {}, Fit::all);
    const SnapshotOptions side =
        with_window(frames, {0, 1}, extent, scene_options("side", extent.look), Fit::all);
    REQUIRE(side.window);
    double highest = -1;
    vtkUnstructuredGrid& bird = *frames.get(1).bird;
    for (vtkIdType i = 0; i < bird.GetNumberOfPoints(); ++i)
      highest = std::max(highest, bird.GetPoint(i)[2]);
    const std::string output =
        program(run.folder.path, fmt::format("render {} -o c --scene side --quiet", name)).output;
    if (away < 1) {
      CHECK((*side.window)[3] >= highest - 1e-9);
      CHECK(output.empty());
    } else {
      CHECK((*side.window)[3] < highest);
      CHECK_THAT(output, Contains("side_by_part_1.png") && Contains("cut off: 10 % of the bird's particles"));
    }
  }
}

TEST_CASE("without options a run's own histories are drawn, else what its frames tell", "[cases][render]")
{
  const MadeRun run;
  Outcome outcome = run.render("-o frames --quiet");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  CHECK(fs::exists(run.folder.path / "frames/maximum_pressure.png"));
  CHECK_FALSE(fs::exists(run.folder.path / "frames/contact_force.png"));
  CHECK_FALSE(fs::exists(run.folder.path / "frames/deflection.png")); // the plate is rigid
  run.folder.write("run/histories.csv", "time[s],max_pressure_all[Pa],contact_force_x[N],max_deflection[m]\n"
                                        "0,0,0,0\n1e-3,9e9,5e3,2e-3\n3e-3,1e6,0,1e-3\n");
  outcome = run.render("-o steps --quiet");
  REQUIRE(outcome.status == 0);
  CHECK(outcome.output.empty());
  CHECK(fs::exists(run.folder.path / "steps/contact_force.png"));
  CHECK(fs::exists(run.folder.path / "steps/deflection.png"));
  run.folder.write("run/histories.csv", "time[s],max_pressure_all[Pa]\n0,0\nno number,1\n1,2\n");
  outcome = run.render("-o damaged --quiet");
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.output, Contains("histories.csv") && Contains("frames of the series instead"));
}

TEST_CASE("a film has every frame, its size, and nothing is left of one that fails", "[cases][render]")
{
  const MadeRun run;
  Outcome outcome = scratch::shell(run.folder.path, "PATH=/nowhere '" + std::string(BIRDSTRIKE_PROGRAM) +
                                                        "' render run --film f.mp4");
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.output, Contains("ffmpeg is not installed") && Contains("apt install ffmpeg"));

  // One that reads nothing and gives up: its words are told, a broken pipe does not end the program.
  run.folder.write("fake/ffmpeg", "#!/bin/sh\necho 'no such encoder' >&2\nexit 1\n");
  fs::permissions(run.folder.path / "fake/ffmpeg", fs::perms::owner_all);
  outcome = scratch::shell(run.folder.path, "PATH=$PWD/fake:$PATH '" + std::string(BIRDSTRIKE_PROGRAM) +
                                                "' render run --film f.mp4");
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.output, Contains("cannot make the film f.mp4") && Contains("no such encoder"));
  for (const auto& file : fs::directory_iterator(run.folder.path))
    CHECK(file.path().filename().string().find("f.mp4") == std::string::npos);

  if (!have_ffmpeg()) {
    WARN("ffmpeg is not installed: no film was made");
    return;
  }
  const auto probe = [&](const std::string& entry) {
    return scratch::shell(run.folder.path, "ffprobe -v error -count_frames -of csv=p=0 -select_streams v:0 "
                                           "-show_entries stream=" +
                                               entry + " f.mp4")
        .output;
  };
  outcome = run.render("--film f.mp4 --scene top --size 319x181"); // rounded up to even
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  CHECK(probe("width,height") == "320,182\n");
  CHECK(probe("nb_read_frames") == "7\n");
  CHECK(probe("pix_fmt") == "yuv420p\n");
  CHECK(probe("r_frame_rate") == "10/1\n");
  CHECK(run.render("--film f.mp4 --slow-down 500 --fps 20 --size 160x90").status == 0);
  CHECK(probe("nb_read_frames") == "30\n"); // 3 ms of impact, 1.5 s of film
  CHECK(run.render("-o films --film f.mp4 --size 160x90").status == 0);
  CHECK(fs::exists(run.folder.path / "films" / "f.mp4"));
  const auto without_temporaries = [&] {
    for (const auto& file : fs::directory_iterator(run.folder.path))
      CHECK(file.path().extension() != ".tmp");
  };
  without_temporaries();

  // Stopped half way: an ffmpeg that takes its time, and says when it has begun.
  run.folder.write("fake/ffmpeg", "#!/bin/sh\necho begun > begun\nexec sleep 20\n");
  for (const char* signal : {"HUP", "TERM"}) { // a shell has its jobs ignore SIGINT
    outcome = scratch::shell(
        run.folder.path, fmt::format("rm -f begun; (exec env PATH=$PWD/fake:$PATH '{}' render run --film "
                                     "g.mp4) & film=$!; until [ -e begun ]; do sleep 0.05; done; "
                                     "[ -e g.mp4.tmp ] && echo there; kill -{} $film; wait $film; echo $?",
                                     BIRDSTRIKE_PROGRAM, signal));
    INFO(signal << ": " << outcome.output);
    CHECK_THAT(outcome.output, Contains("there"));
    without_temporaries();
    CHECK_FALSE(fs::exists(run.folder.path / "g.mp4"));
  }
}

TEST_CASE("frames are those nearest to the times, or evenly spaced", "[cases][render]")
{
  SeriesIndex index;
  for (int k = 0; k <= 10; ++k)
    index.steps.push_back({k * 1e-4, {}});
  using Steps = std::vector<std::size_t>;
  CHECK(chosen_steps(index, {2.4e-4, 9.6e-4}, 0) == Steps{2, 10});
  CHECK(chosen_steps(index, {3e-4, 3.1e-4}, 0) == Steps{3}); // once
  CHECK(chosen_steps(index, {}, 3) == Steps{0, 5, 10});
  CHECK(chosen_steps(index, {}, -1).size() == 11);
  CHECK(chosen_steps(index, {}, 99).size() == 11);
  CHECK(chosen_steps(index, {}, 1) == Steps{10});
  CHECK_THROWS_WITH(chosen_steps(index, {1.2e-3}, 0), Contains("no frame at 1.2 ms"));
}

TEST_CASE("colours mean the same in all pictures, and nothing is out of sight", "[cases][render]")
{
  const MadeRun run;
  SeriesFrames frames(run.folder.path / "run" / "run.pvd", true, true);
  SnapshotOptions look;
  look.colour_by = "pressure";
  look.target_field = "contact_force";
  const SeriesExtent all = extent_of(frames, {0, 3, 6}, look, Fit::all);
  REQUIRE(all.look.range);
  REQUIRE(all.look.target_range);
  for (const std::size_t step : {0, 3, 6}) {
    vtkUnstructuredGrid& bird = *frames.get(step).bird;
    int above = 0, outside = 0;
    vtkDataArray& pressure = *bird.GetPointData()->GetArray("pressure");
    for (vtkIdType i = 0; i < bird.GetNumberOfPoints(); ++i) {
      above += pressure.GetComponent(i, 0) > (*all.look.range)[1];
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (bird.GetPoint(i)[axis] < all.bounds[2 * axis] ||
            bird.GetPoint(i)[axis] > all.bounds[2 * axis + 1]) {
          ++outside;
          break;
        }
    }
    CHECK(above <= 0.021 * static_cast<double>(bird.GetNumberOfPoints()));
    CHECK(outside <= 0.061 * static_cast<double>(bird.GetNumberOfPoints()));
  }
  look.range = std::array<double, 2>{1, 2};
  CHECK(extent_of(frames, {0}, look, Fit::target).look.range == look.range); // what is fixed stays
  const Bounds of_target = extent_of(frames, {0}, look, Fit::target).bounds;
  CHECK(of_target[3] - of_target[2] == Approx(0.6));
  CHECK(extent_of(frames, {0}, look, Fit::bird).bounds[1] < 0);
}

TEST_CASE("texts of ranges, planes and sizes", "[cases][render]")
{
  CHECK(parse_range("0 MPa, 7.25 ksi", "--range", "pressure")[1] == Approx(49.987e6).epsilon(1e-4));
  CHECK(parse_range("-2 mm,1 cm", "--range", "displacement_x")[0] == Approx(-0.002));
  CHECK(parse_range("0,1.5", "--range", "plastic_strain")[1] == 1.5);
  CHECK_THROWS_AS(parse_range("0 MPa", "--range", "pressure"), InputError);
  CHECK_THROWS_AS(parse_range("0 MPa,inf MPa", "--range", "pressure"), InputError);
  CHECK_THROWS_AS(parse_range("0 MPa,5 bogus", "--range", "pressure"), InputError);
  CHECK(parse_plane("z=-3 cm").at == Approx(-0.03));
  CHECK(parse_plane("z=-3 cm").axis == 2);
  CHECK(parse_print("25.4 mm", 320) == std::array<int, 2>{320, 180});
  CHECK_THROWS_WITH(parse_print("2 m", 1000), Contains("78740 pixels"));
  CHECK(parse_pair("2x4", "--montage", "") == std::array<int, 2>{2, 4});
  for (const char* text : {"", "x", "2x", "x4", "0x4", "2x-4", "2x4x6", "2.5x4"})
    CHECK_THROWS_AS(parse_pair(text, "--montage", ""), InputError);
}
