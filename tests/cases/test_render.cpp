// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike render as a user calls it: pictures, montages, films, and what contradicts itself.
#include "cases/render_texts.h"
#include "cases/series_frames.h"
#include "core/error.h"
#include "scratch.h"
#include "tests/vtkio/made_run.h"
#include "vtkio/film_writer.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/series_writer.h"
#include "vtkio/shells_to_vtk.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <vtkImageData.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
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
  for (const auto& file : fs::directory_iterator(run.folder.path))
    CHECK(file.path().extension() != ".tmp");
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
