// SPDX-License-Identifier: BSD-3-Clause
// Pictures: what is in them, by counting pixels.
#include "vtkio/snapshot.h"

#include "core/error.h"
#include "tests/vtkio/made_run.h"
#include "tests/vtkio/pixels.h"
#include "vtkio/montage.h"
#include "vtkio/palette.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/shells_to_vtk.h"

#include <catch2/catch.hpp>
#include <vtkImageData.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <chrono>

using namespace birdstrike;
using Catch::Matchers::Contains;

namespace {

Frame made_frame(double time = 0, double spacing = 0.008)
{
  return {time, particles_to_vtk(made_bird(spacing, time / 4e-3), time), plate_to_vtk(made_plate(), time)};
}

SnapshotOptions small()
{
  SnapshotOptions options;
  options.width = 480;
  options.height = 270;
  return options;
}

bool is_red(const unsigned char* c) { return c[0] > 80 && c[0] > 2.5 * c[1] && c[0] > 2.5 * c[2]; }
bool is_brown(const unsigned char* c) { return c[0] > 60 && c[0] > 1.2 * c[1] && c[1] > 1.5 * c[2]; }
bool is_slab(const unsigned char* c) // the plate seen edge-on: a bluish dark grey
{
  return c[0] > 50 && c[0] < 140 && c[2] > c[0] && c[2] - c[0] < 30 && std::abs(c[1] - c[0]) < 15;
}

} // namespace

TEST_CASE("a side view holds bird and plate and cuts nothing off", "[snapshot]")
{
  const Frame frame = made_frame();
  Snapshot snapshot(small(), bounds_of(frame));
  const auto image = snapshot.draw(frame);
  const Pixels p(*image);
  REQUIRE(p.width == 480);
  REQUIRE(p.height == 270);
  CHECK(count(p, 0, 0.8, 0, 0.9, is_brown) > 2000);
  CHECK(count(p, 0, 0.8, 0, 0.9, is_slab) > 500);
  CHECK(count(p, 0, 1, 0, 0.012, is_drawn) == 0); // the border is free
  CHECK(count(p, 0, 0.012, 0, 1, is_drawn) == 0);
  CHECK(count(p, 0.99, 1, 0, 1, is_drawn) == 0);
  CHECK(count(p, 0.8, 0.98, 0.92, 1, is_drawn) > 50); // the time
  CHECK(count(p, 0.82, 1, 0.2, 0.9, is_drawn) > 300); // the legend
}

TEST_CASE("flight is to the right: the bird is left of the plate", "[snapshot]")
{
  const Frame frame = made_frame();
  Snapshot snapshot(small(), bounds_of(frame));
  const auto image = snapshot.draw(frame);
  const Pixels p(*image);
  double bird = 0, plate = 0;
  int birds = 0, plates = 0;
  for (int y = 20; y < 240; ++y)
    for (int x = 60; x < 380; ++x) {
      if (is_brown(p.at(x, y)))
        bird += x, ++birds;
      else if (is_slab(p.at(x, y)))
        plate += x, ++plates;
    }
  REQUIRE(birds > 0);
  REQUIRE(plates > 0);
  CHECK(bird / birds + 50 < plate / plates);
}

TEST_CASE("the cut lets the lungs be seen, the whole bird hides them", "[snapshot]")
{
  const Frame frame = made_frame();
  SnapshotOptions options = small();
  options.legend = false;
  Snapshot cut(options, bounds_of(frame));
  CHECK(count(Pixels(*cut.draw(frame)), 0.1, 1, 0.2, 0.9, is_red) > 100);
  options.cut = false;
  Snapshot whole(options, bounds_of(frame));
  CHECK(count(Pixels(*whole.draw(frame)), 0.1, 1, 0.2, 0.9, is_red) == 0);
}

TEST_CASE("particles are shaded as spheres lit from the upper left", "[snapshot]")
{
  // One particle, seen large.
  Particles one;
  one.parts.push_back({"torso", Linear{1000, 2e9}, 0, 0});
  one.resize(1);
  one.x[0] = one.y[0] = one.z[0] = 0;
  one.vx[0] = one.vy[0] = one.vz[0] = one.energy[0] = one.pressure[0] = 0;
  one.sound_speed[0] = one.smoothing_length[0] = 1;
  one.mass[0] = one.density[0] = 1000;
  one.part[0] = 0;
  one.id[0] = 0;
  SnapshotOptions options = small();
  options.legend = false;
  Snapshot snapshot(options, {-1, 1, -1, 1, -1, 1});
  const auto image = snapshot.draw({0, particles_to_vtk(one, 0), nullptr});
  const Pixels p(*image);
  const int x = p.width / 2, y = static_cast<int>(0.5 * (p.height - 2.0 * 10)), r = 40;
  const auto brightness = [&](int i, int j) { return p.at(i, j)[0] + p.at(i, j)[1] + p.at(i, j)[2]; };
  REQUIRE(is_drawn(p.at(x, y)));
  CHECK(brightness(x - r, y + r) > brightness(x, y) + 15);
  CHECK(brightness(x, y) > brightness(x + r, y - r) + 60);
  CHECK_FALSE(is_drawn(p.at(x + 70, y + 70))); // a disc, not a square
  // As wide as the cube that it stands for, within what fills the gaps.
  int wide = 0;
  for (int i = 0; i < p.width; ++i)
    wide += is_drawn(p.at(i, y));
  const double pixels_per_metre = (p.height - 20.0) / 2.08;
  CHECK(wide > 1.0 * pixels_per_metre);
  CHECK(wide < 1.35 * pixels_per_metre);
}

TEST_CASE("a series keeps its frame: the plate stays where it is", "[snapshot]")
{
  const Frame first = made_frame(0), last = made_frame(2.5e-3);
  Snapshot snapshot(small(), bounds_of(first));
  const auto a = snapshot.draw(first), b = snapshot.draw(last);
  const Pixels p(*a), q(*b);
  int changed = 0, plate = 0;
  for (int y = 0; y < p.height * 9 / 10; ++y)
    for (int x = 0; x < p.width * 8 / 10; ++x) {
      plate += is_slab(p.at(x, y)) && x > 250;
      changed += is_slab(p.at(x, y)) && x > 250 && !is_slab(q.at(x, y));
    }
  CHECK(plate > 500);
  CHECK(changed < plate / 20);
  CHECK(count(q, 0.1, 0.8, 0, 0.9, is_brown) > 500);
}

TEST_CASE("pressure is drawn in the colours of its range, with a labelled bar", "[snapshot]")
{
  const Frame frame = made_frame(1e-3);
  SnapshotOptions options = small();
  options.colour_by = "pressure";
  options.range = {{1e9, 2e9}}; // all below: the lowest colour everywhere
  Snapshot low(options, bounds_of(frame));
  const auto yellow = [](const unsigned char* c) { return c[0] > 100 && c[1] > 100 && c[2] < 60; };
  const auto violet = [](const unsigned char* c) { return c[2] > c[1] + 10 && c[0] > c[1]; };
  const auto image = low.draw(frame);
  CHECK(count(Pixels(*image), 0, 0.6, 0.2, 0.9, yellow) == 0);
  CHECK(count(Pixels(*image), 0, 0.6, 0.2, 0.9, violet) > 1000);
  CHECK(count(Pixels(*image), 0.83, 1, 0.1, 0.9, yellow) > 20); // the bar has all colours
  options.range.reset();
  Snapshot own(options, bounds_of(frame));
  CHECK(count(Pixels(*own.draw(frame)), 0, 0.8, 0.2, 0.9, yellow) > 0);
}

TEST_CASE("every view shows the bird and leaves the border free", "[snapshot]")
{
  const Frame frame = made_frame();
  for (const char* name : {"side", "front", "top", "isometric"}) {
    INFO(name);
    SnapshotOptions options = small();
    options.view = view_from_name(name);
    Snapshot snapshot(options, bounds_of(frame));
    const auto image = snapshot.draw(frame);
    CHECK(count(Pixels(*image), 0, 0.8, 0, 0.9, is_brown) > 500);
    CHECK(count(Pixels(*image), 0, 1, 0, 0.012, is_drawn) == 0);
    CHECK(count(Pixels(*image), 0, 0.012, 0, 1, is_drawn) == 0);
  }
}

TEST_CASE("wrong options of a picture are explained", "[snapshot]")
{
  const Frame frame = made_frame(0, 0.03);
  CHECK_THROWS_WITH(view_from_name("below"),
                    Contains("\"below\"") && Contains("side, front, top, isometric"));
  SnapshotOptions options = small();
  options.colour_by = "temperature";
  Snapshot snapshot(options, bounds_of(frame));
  CHECK_THROWS_AS(snapshot.draw(frame), InputError);
  CHECK_THROWS_WITH(snapshot.draw(frame), Contains("\"temperature\"") && Contains("pressure"));
  options = small();
  options.width = 3;
  CHECK_THROWS_WITH(Snapshot(options, bounds_of(frame)), Contains("3 x 270"));
  options = small();
  options.range = {{2, 1}};
  CHECK_THROWS_WITH(Snapshot(options, bounds_of(frame)), Contains("range"));
  Snapshot fine(small(), bounds_of(frame));
  CHECK_THROWS_AS(fine.write(frame, "/proc/nowhere/a.png"), OutputError);
}

TEST_CASE("a montage has its panels, letters and one legend", "[montage]")
{
  std::vector<Frame> frames;
  for (int k = 0; k < 8; ++k)
    frames.push_back(made_frame(0.4e-3 * k, 0.012));
  TemporaryFolder folder;
  MontageOptions options;
  options.snapshot.width = 320;
  options.snapshot.height = 180;
  for (const int columns : {2, 4}) {
    options.columns = columns;
    write_montage(frames, bounds_of(frames[0]), options, folder.path / "m.png");
    auto reader = vtkSmartPointer<vtkPNGReader>::New();
    reader->SetFileName((folder.path / "m.png").string().c_str());
    reader->Update();
    const Pixels p(*reader->GetOutput());
    REQUIRE(p.width == columns * 320);
    const int rows = 8 / columns;
    REQUIRE(p.height > rows * 180);
    for (int k = 0; k < 8; ++k) {
      INFO("panel " << k);
      const double x = static_cast<double>(k % columns) / columns, wide = 1.0 / columns;
      const double y = 1 - (k / columns + 1.0) * 180 / p.height, high = 180.0 / p.height;
      CHECK(count(p, x, x + wide, y, y + 0.8 * high, is_brown) > 30);
      CHECK(count(p, x, x + 0.5 * wide, y + 0.88 * high, y + high, is_drawn) > 30);
    }
    CHECK(count(p, 0, 1, 0, 0.9 * (p.height - rows * 180) / p.height, is_drawn) > 200);
  }
  CHECK_THROWS_WITH(write_montage({frames[0]}, bounds_of(frames[0]), options, folder.path / "x.png"),
                    Contains("2 to 26 frames, not 1"));
}

TEST_CASE("colours are read from text and parts have their roles", "[palette]")
{
  CHECK(colour_from_text("#ff0080") == Colour{1, 0, 128 / 255.0});
  CHECK_THROWS_WITH(colour_from_text("red"), Contains("\"red\"") && Contains("#0072b2"));
  CHECK_THROWS_AS(colour_from_text("#12345g"), InputError);
  CHECK(part_colour("wings_left", 0) == part_colour("wings_right", 5));
  CHECK(part_colour("lungs", 0) != part_colour("bones", 0));
  for (std::size_t a = 0; a < 8; ++a)
    for (std::size_t b = 0; b < a; ++b)
      CHECK(line_colour(a) != line_colour(b));
}
