// SPDX-License-Identifier: BSD-3-Clause
// Targets that bend and break, in pictures.
#include "vtkio/target_actors.h"

#include "core/error.h"
#include "tests/vtkio/made_run.h"
#include "tests/vtkio/pixels.h"
#include "vtkio/montage.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/shells_to_vtk.h"
#include "vtkio/slab.h"
#include "vtkio/snapshot.h"
#include "vtkio/visible_shell.h"

#include <catch2/catch.hpp>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

using namespace birdstrike;
using Catch::Matchers::Contains;

namespace {

constexpr double depth = 0.08;

// 0.6 m x 0.5 m of 24 x 20 elements, 6 mm thick, with a dent of 80 mm in the middle; where asked for, the elements
// within 0.07 m of the middle have eroded.
vtkSmartPointer<vtkUnstructuredGrid> made_dent(bool hole)
{
  auto grid = plate_to_vtk(make_rigid_plate(0.6, 0.5, 0.006, 24, 20), 0);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
    double p[3];
    grid->GetPoint(i, p);
    const double u = depth * std::exp(-(p[1] * p[1] + p[2] * p[2]) / 0.02);
    grid->GetPoints()->SetPoint(i, p[0] + u, p[1], p[2]);
    grid->GetPointData()->GetArray("displacement")->SetTuple3(i, u, 0, 0);
  }
  vtkNew<vtkDoubleArray> strain;
  vtkNew<vtkUnsignedCharArray> eroded;
  strain->SetName("plastic_strain");
  eroded->SetName("eroded");
  vtkNew<vtkIdList> corners;
  for (vtkIdType k = 0; k < grid->GetNumberOfCells(); ++k) {
    double y = 0, z = 0, p[3];
    grid->GetCellPoints(k, corners);
    for (vtkIdType c = 0; c < 4; ++c) {
      grid->GetPoint(corners->GetId(c), p);
      y += p[1] / 4, z += p[2] / 4;
    }
    const double r = std::hypot(y, z);
    eroded->InsertNextValue(hole && r < 0.07);
    strain->InsertNextValue(hole && r < 0.07 ? 9.0 : 0.2 * std::exp(-r * r / 0.02));
  }
  grid->GetCellData()->AddArray(strain);
  grid->GetCellData()->AddArray(eroded);
  return grid;
}

SnapshotOptions small(View view)
{
  SnapshotOptions options;
  options.view = view;
  options.width = 480;
  options.height = 360;
  options.legend = false;
  return options;
}

bool is_yellow(const unsigned char* c) { return c[0] > 120 && c[1] > 0.8 * c[0] && c[2] < 90; }
bool is_violet(const unsigned char* c) { return c[2] > c[1] + 10 && c[0] > c[1] && c[0] < 120; }
bool is_light_grey(const unsigned char* c) { return c[0] > 140 && c[0] < 245 && std::abs(c[2] - c[0]) < 25; }

double area(vtkUnstructuredGrid& shell)
{
  double sum = 0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType k = 0; k < shell.GetNumberOfCells(); ++k) {
    shell.GetCellPoints(k, corners);
    double normal[3];
    sum +=
        vtkPolygon::ComputeArea(shell.GetPoints(), corners->GetNumberOfIds(), corners->GetPointer(0), normal);
    CHECK(normal[0] < 0); // towards the bird, as before
  }
  return sum;
}

} // namespace

TEST_CASE("what has eroded is left out, with its points", "[target]")
{
  auto plate = plate_to_vtk(make_rigid_plate(0.4, 0.4, 0.01, 4, 4), 0);
  vtkNew<vtkUnsignedCharArray> eroded;
  eroded->SetName("eroded");
  for (int k = 0; k < 16; ++k)
    eroded->InsertNextValue(k == 5 || k == 6 || k == 9 || k == 10);
  plate->GetCellData()->AddArray(eroded);
  const auto visible = visible_shell(*plate, false);
  CHECK(visible->GetNumberOfCells() == 12);
  CHECK(visible->GetNumberOfPoints() == 24); // the one in the middle is gone
  CHECK(area(*visible) == Approx(0.16 - 0.04));
  CHECK(thickness_of(*visible) == 0.01);
  eroded->SetName("vtkGhostType");
  for (int k = 0; k < 16; ++k)
    eroded->SetValue(k, 32 * eroded->GetValue(k));
  CHECK(visible_shell(*plate, false)->GetNumberOfCells() == 12);
  eroded->FillValue(32);
  const auto nothing = visible_shell(*plate, false);
  CHECK(nothing->GetNumberOfCells() == 0);
  CHECK(make_slab(*nothing, 0.01)->GetNumberOfCells() == 0);
}

TEST_CASE("the cut at y = 0 halves elements and keeps data on straight lines", "[target]")
{
  for (const int across : {4, 5}) { // a line of points on the plane, and none
    auto plate = plate_to_vtk(make_rigid_plate(0.4, 0.4, 0.01, across, 4), 0);
    vtkNew<vtkDoubleArray> linear;
    linear->SetName("linear");
    for (vtkIdType i = 0; i < plate->GetNumberOfPoints(); ++i)
      linear->InsertNextValue(3 * plate->GetPoint(i)[1] + 7 * plate->GetPoint(i)[2] + 1);
    plate->GetPointData()->AddArray(linear);
    const auto half = visible_shell(*plate, true);
    CHECK(half->GetNumberOfCells() == 4 * ((across + 1) / 2));
    CHECK(area(*half) == Approx(0.08));
    vtkDataArray* values = half->GetPointData()->GetArray("linear");
    REQUIRE(values->GetNumberOfTuples() == half->GetNumberOfPoints());
    for (vtkIdType i = 0; i < half->GetNumberOfPoints(); ++i) {
      const double* p = half->GetPoint(i);
      CHECK(p[1] >= 0);
      CHECK(values->GetComponent(i, 0) == Approx(3 * p[1] + 7 * p[2] + 1));
    }
  }
}

TEST_CASE("a slab carries the data of its shell, and may lie about the middle surface", "[target]")
{
  const auto grid = made_dent(false);
  auto slab = make_slab(*grid, 0.006);
  vtkDataArray* u = slab->GetPointData()->GetArray("displacement");
  REQUIRE(u);
  REQUIRE(u->GetNumberOfTuples() == slab->GetNumberOfPoints());
  const vtkIdType count = grid->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
    CHECK(u->GetComponent(i + count, 0) == u->GetComponent(i, 0));
  CHECK(slab->GetCellData()->GetArray("plastic_strain")->GetNumberOfTuples() == slab->GetNumberOfCells());

  const auto flat = plate_to_vtk(make_rigid_plate(0.4, 0.4, 0.01, 4, 4), 0);
  CHECK(make_slab(*flat, 0.01)->GetBounds()[0] == Approx(0).margin(1e-12));
  vtkNew<vtkDoubleArray> middle;
  middle->SetName("middle_surface");
  middle->InsertNextValue(1);
  flat->GetFieldData()->AddArray(middle);
  slab = make_slab(*flat, 0.01);
  CHECK(slab->GetBounds()[0] == Approx(-0.005));
  CHECK(slab->GetBounds()[1] == Approx(0.005));
  flat->GetFieldData()->RemoveArray("thickness");
  vtkNew<vtkDoubleArray> thickness; // of the elements
  thickness->SetName("thickness");
  for (int k = 0; k < 16; ++k)
    thickness->InsertNextValue(k < 8 ? 0.004 : 0.002);
  flat->GetCellData()->AddArray(thickness);
  CHECK(thickness_of(*flat) == Approx(0.003));
}

TEST_CASE("a hole in the target can be seen through", "[target][snapshot]")
{
  const Frame whole{0, nullptr, made_dent(false)}, broken{0, nullptr, made_dent(true)};
  Snapshot snapshot(small(View::front), bounds_of(whole));
  const auto drawn = [&](const Frame& frame) {
    return count(Pixels(*snapshot.draw(frame)), 0.45, 0.55, 0.4, 0.53, is_drawn);
  };
  CHECK(drawn(whole) > 40 * 40);
  CHECK(drawn(broken) == 0);
  // And around it there is still the plate.
  CHECK(count(Pixels(*snapshot.draw(broken)), 0.2, 0.8, 0.6, 0.85, is_light_grey) > 5000);
}

TEST_CASE("the cut shows the dent from the side, not only the rim", "[target][snapshot]")
{
  const Frame frame{0, nullptr, made_dent(false)};
  SnapshotOptions options = small(View::side);
  options.cut = false;
  Snapshot whole(options, bounds_of(frame));
  options.cut = true;
  Snapshot cut(options, bounds_of(frame));
  // Of the whole plate the back of the bulge is seen. Cut open, its inner side is seen in front of the section, and
  // the section, dark and as thick as the plate, ends it at the back.
  const auto dark = [](const unsigned char* c) { return c[0] > 50 && c[0] < 105 && c[2] > c[0]; };
  struct Row // of pixels at the height of the middle
  {
    int first, last, last_dark;
  };
  const auto middle = [&](const Pixels& p) {
    Row row{p.width, 0, 0};
    const int y = static_cast<int>((p.height - 24) / 2);
    for (int x = 0; x < p.width; ++x) {
      if (is_drawn(p.at(x, y)))
        row.last = x, row.first = std::min(row.first, x);
      if (dark(p.at(x, y)))
        row.last_dark = x;
    }
    return row;
  };
  const auto outside = whole.draw(frame), inside = cut.draw(frame);
  const Pixels o(*outside), p(*inside);
  const Row shut = middle(o), open = middle(p);
  CHECK(shut.last_dark < shut.first + 8); // the rim, in front of the bulge
  CHECK(open.last_dark >= open.last - 1);
  // As deep as the dent is: the picture is 0.5 m high within 4 %.
  const double pixels_per_metre = (p.height - 24.0) / (0.5 * 1.04);
  CHECK(open.last - open.first == Approx(depth * pixels_per_metre).margin(8));
}

TEST_CASE("the target is drawn in the colours of a point or a cell array, with its own bar",
          "[target][snapshot]")
{
  const Frame frame{0, nullptr, made_dent(false)};
  for (const char* field : {"displacement", "plastic_strain"}) {
    INFO(field);
    SnapshotOptions options = small(View::front);
    options.target_field = field;
    options.legend = true;
    Snapshot snapshot(options, bounds_of(frame));
    const auto image = snapshot.draw(frame);
    const Pixels p(*image);
    const double right = 1 - 8.5 * 12 / 480.0; // of the canvas
    CHECK(count(p, 0.45 * right, 0.55 * right, 0.43, 0.5, is_yellow) > 200);
    CHECK(count(p, 0, 0.3 * right, 0.2, 0.9, is_yellow) == 0);
    CHECK(count(p, 0.1, 0.3 * right, 0.2, 0.9, is_violet) > 2000);
    CHECK(count(p, right, 1, 0.1, 0.9, is_yellow) > 20); // the bar
    // A range far above: all in the lowest colour.
    options.target_range = {{100, 200}};
    Snapshot low(options, bounds_of(frame));
    CHECK(count(Pixels(*low.draw(frame)), 0, right, 0, 0.9, is_yellow) == 0);
  }
}

TEST_CASE("a sheet thinner than a pixel is seen from the side wherever it lies", "[target][snapshot]")
{
  const Frame frame{0, nullptr, plate_to_vtk(make_rigid_plate(0.6, 0.5, 2e-4, 24, 20), 0)};
  for (const bool cut : {false, true})
    for (const char* field : {"", "contact_pressure"})
      for (double moved = 0; moved < 1.4e-3; moved += 3e-4) { // a pixel is some 1.5 mm wide
        SnapshotOptions options = small(View::side);
        options.axes = false;
        options.cut = cut;
        options.target_field = field;
        Snapshot snapshot(options, {-0.3 + moved, 0.3 + moved, -0.3, 0.3, -0.25, 0.25});
        CHECK(count(Pixels(*snapshot.draw(frame)), 0.4, 0.6, 0, 0.9, is_drawn) > 300);
      }
}

TEST_CASE("eroded elements have no say in the range", "[target]")
{
  const auto grid = made_dent(true);
  CHECK(range_of_target(*grid, "plastic_strain")[1] < 0.2);
  CHECK(range_of_target(*made_dent(false), "displacement")[1] == Approx(depth));
}

TEST_CASE("bird and bending target share a picture and a montage", "[target][snapshot][montage]")
{
  const Frame first{0, particles_to_vtk(made_bird(0.012), 0), made_dent(false)},
      last{2e-3, particles_to_vtk(made_bird(0.012, 0.4), 2e-3), made_dent(true)};
  SnapshotOptions options = small(View::isometric);
  options.legend = true;
  options.target_field = "plastic_strain";
  Snapshot snapshot(options, bounds_of({first, last}));
  const auto image = snapshot.draw(first);
  const Pixels p(*image);
  const double right = 1 - 8.5 * 12 / 480.0;
  CHECK(count(p, right, 1, 0.5, 0.9, is_drawn) > 300);  // parts above
  CHECK(count(p, right, 1, 0.1, 0.45, is_yellow) > 20); // bar below
  CHECK(count(p, right, 1, 0.55, 0.9, is_yellow) == 0);

  TemporaryFolder folder;
  MontageOptions montage;
  montage.snapshot = options;
  montage.columns = 2;
  write_montage({first, last}, bounds_of({first, last}), montage, folder.path / "m.png");
  auto reader = vtkSmartPointer<vtkPNGReader>::New();
  reader->SetFileName((folder.path / "m.png").string().c_str());
  reader->Update();
  const Pixels m(*reader->GetOutput());
  CHECK(count(m, 0.5, 1, 0, 0.15, is_yellow) > 20);
  CHECK(count(m, 0, 0.5, 0, 0.15, is_yellow) == 0);
}

TEST_CASE("the bounds of frames hold a target that bends", "[target]")
{
  const Frame flat{0, nullptr, plate_to_vtk(make_rigid_plate(0.6, 0.5, 0.006, 4, 4), 0)},
      bent{1, nullptr, made_dent(false)};
  CHECK(bounds_of(flat)[1] == Approx(0.006));
  CHECK(bounds_of(std::vector<Frame>{flat, bent})[1] == Approx(depth + 0.006));
}

TEST_CASE("a field that the target has not is named", "[target][snapshot]")
{
  const Frame frame{0, nullptr, made_dent(false)};
  SnapshotOptions options = small(View::side);
  options.target_field = "strain";
  Snapshot snapshot(options, bounds_of(frame));
  CHECK_THROWS_AS(snapshot.draw(frame), InputError);
  CHECK_THROWS_WITH(snapshot.draw(frame),
                    Contains("\"strain\"") && Contains("displacement") && Contains("plastic_strain"));
  options.target_range = {{2, 2}};
  CHECK_THROWS_WITH(Snapshot(options, bounds_of(frame)), Contains("range"));
}
