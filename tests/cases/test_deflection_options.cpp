// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike histories on a made series of a plate that bends: columns, screen, wrong options.
#include "cases/deflection_options.h"

#include "cases/series_histories.h"
#include "core/error.h"
#include "scratch.h"
#include "tests/vtkio/made_run.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/series_writer.h"
#include "vtkio/shells_to_vtk.h"

#include <catch2/catch.hpp>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

using namespace birdstrike;
using Catch::Matchers::Contains;
using scratch::Outcome;
using scratch::program;

namespace {

// 0.6 m x 0.5 m of 12 x 10 elements that move by t metres along x at 10 ms a frame, from the middle frame on 30 mm.
void write_bent_series(const fs::path& folder, bool target = true, bool changes = false)
{
  SeriesWriter writer(folder);
  for (int k = 0; k <= 10; ++k) {
    const double t = 0.01 * k, u = k < 5 ? t : 0.03;
    const auto plate = plate_to_vtk(changes && k == 10 ? make_rigid_plate(0.6, 0.5, 0.01, 3, 3)
                                                       : birdstrike::RigidPlate(made_plate()),
                                    t);
    for (vtkIdType i = 0; i < plate->GetNumberOfPoints(); ++i) {
      double p[3];
      plate->GetPoint(i, p);
      plate->GetPoints()->SetPoint(i, p[0] + u, p[1], p[2]);
      plate->GetPointData()->GetArray("displacement")->SetTuple3(i, u, 0, 0);
    }
    writer.write_frame(t, *particles_to_vtk(made_bird(0.04), t), target ? plate : nullptr);
  }
}

} // namespace

TEST_CASE("points and directions are read from text", "[cases][deflection]")
{
  const DeflectionPoint plain = deflection_point_from_text("0.1,-0.2, 3e-1");
  CHECK(plain.name.empty());
  CHECK(plain.place == std::array<double, 3>{0.1, -0.2, 0.3});
  const DeflectionPoint named = deflection_point_from_text(" tip = 0, 50 mm, -1 cm");
  CHECK(named.name == "tip");
  CHECK(named.place[1] == Approx(0.05));
  CHECK(named.place[2] == Approx(-0.01));
  CHECK_THROWS_WITH(deflection_point_from_text("0,0"),
                    Contains("\"0,0\" is not a point") && Contains("metres"));
  CHECK_THROWS_WITH(deflection_point_from_text("=0,0,0"), Contains("is not a point"));
  CHECK_THROWS_WITH(deflection_point_from_text("0,0,0,"), Contains("is not a point"));
  CHECK_THROWS_WITH(deflection_point_from_text("0,y,0"), Contains("\"y\"") && Contains("a length is needed"));
  CHECK_THROWS_WITH(deflection_point_from_text("0,nan,0"), Contains("\"nan\""));
  CHECK(direction_from_text("0, -2, 0") == std::array<double, 3>{0, -2, 0});
  for (const char* wrong : {"x", "0,0,0", "1,0", "1,0,inf", "1,0,0 m", ""})
    CHECK_THROWS_WITH(direction_from_text(wrong), Contains("is not a direction"));
}

TEST_CASE("histories writes the deflection at chosen points and tells which are used", "[cases][deflection]")
{
  scratch::Folder folder;
  write_bent_series(folder.path / "run");
  const Outcome outcome = program(
      folder.path, "histories run/run.pvd -o h.csv --deflection-at 0,0.01,0 --deflection-at 'rim=0,300 mm,0' "
                   "--deflection-at -0.01,0,0 --deflection-along -1,0,0 --set-window 0.3");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.output, Contains("deflection at 0 (0, 0.01, 0) m: point") && Contains("10 mm away") &&
                                 Contains("deflection at rim"));
  const std::string csv = scratch::read(folder.path / "h.csv");
  for (const char* column :
       {"max_deflection[m]", "max_deflection_along[m]", "permanent_set[m]", "residual_amplitude[m]",
        "deflection_at_0[m]", "deflection_x_at_rim[m]", "deflection_along_at_2[m]", "distance_at_rim[m]"})
    CHECK_THAT(csv, Contains(column));

  DeflectionOptions options;
  options.points.push_back({"", {0, 0.01, 0}});
  options.along = {-1, 0, 0};
  const auto table = histories_of_series(folder.path / "run/run.pvd", options);
  REQUIRE(table->GetNumberOfRows() == 11);
  CHECK(table->GetValueByName(4, "deflection_x_at_0[m]").ToDouble() == Approx(0.04));
  CHECK(table->GetValueByName(4, "deflection_along_at_0[m]").ToDouble() == Approx(-0.04));
  CHECK(table->GetValueByName(0, "permanent_set[m]").ToDouble() == Approx(0.03));
  CHECK(table->GetValueByName(0, "residual_amplitude[m]").ToDouble() == Approx(0).margin(1e-12));
  CHECK(table->GetValueByName(0, "distance_at_0[m]").ToDouble() == Approx(0.01));
}

TEST_CASE("histories without a fitting target says why", "[cases][deflection]")
{
  scratch::Folder folder;
  write_bent_series(folder.path / "run", false);
  write_bent_series(folder.path / "changed", true, true);
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = program(folder.path, "histories " + arguments + " -o h.csv");
    INFO(outcome.output);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.output, Contains(words));
    CHECK_FALSE(fs::exists(folder.path / "h.csv"));
  };
  refused("run/run.pvd --deflection-at 0,0,0", "run/run.pvd: no deflection can be made of it");
  refused("run/run.pvd --deflection-at 0,0", "\"0,0\" is not a point");
  refused("run/run.pvd --deflection-along 0,0,0", "is not a direction");
  refused("run/run.pvd --set-window 2", "--set-window 2: a share");
  refused("changed/run.pvd --deflection-at a=0,0,0 --deflection-at a=0,1,0", "'a'");
  CHECK(program(folder.path, "histories run/run.pvd -o bird.csv").status == 0);

  const Outcome changed = program(folder.path, "histories changed/run.pvd -o c.csv --quiet");
  INFO(changed.output);
  CHECK(changed.status == 0);
  CHECK_THAT(changed.output, Contains("16 points at 0.1 s") && Contains("143 before"));
}
