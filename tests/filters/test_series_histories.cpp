// SPDX-License-Identifier: BSD-3-Clause
// The filters on a series from disk, as the program runs them.
#include "tests/vtkio/made_run.h"
#include "vtkMaximumPressureHistory.h"
#include "vtkTargetDeflectionHistory.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/series_writer.h"
#include "vtkio/shells_to_vtk.h"
#include "vtkio/vtkBirdStrikeSeriesReader.h"
#include "vtkio/vtk_errors.h"

#include <catch2/catch.hpp>
#include <vtkNew.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace birdstrike;
using Catch::Matchers::Contains;

namespace {

double time_of(int k) { return k * (1e-3 / 7); }

void write_series(const std::filesystem::path& folder, int frames)
{
  SeriesWriter writer(folder);
  for (int k = 0; k < frames; ++k)
    writer.write_frame(time_of(k), *particles_to_vtk(made_bird(0.02, 0.2 * k), time_of(k)),
                       plate_to_vtk(made_plate(), time_of(k)));
}

} // namespace

TEST_CASE("the history of a series on disk is that of the particles", "[filters][series]")
{
  TemporaryFolder folder;
  write_series(folder.path, 4);
  vtkNew<vtkBirdStrikeSeriesReader> reader;
  reader->SetFileName((folder.path / "run.pvd").string());
  vtkNew<vtkMaximumPressureHistory> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->Update();
  vtkTable& table = *filter->GetOutput();
  REQUIRE(table.GetNumberOfRows() == 4);
  for (int k = 0; k < 4; ++k) {
    const Particles bird = made_bird(0.02, 0.2 * k);
    CHECK(table.GetValueByName(k, "time[s]").ToDouble() == time_of(k));
    CHECK(table.GetValueByName(k, "max_pressure_all[Pa]").ToDouble() ==
          *std::max_element(bird.pressure.begin(), bird.pressure.end()));
    for (std::size_t part = 0; part < bird.parts.size(); ++part) {
      double largest = -std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < bird.size(); ++i)
        if (bird.part[i] == part)
          largest = std::max(largest, bird.pressure[i]);
      const std::string title = "max_pressure_" + bird.parts[part].name + "[Pa]";
      INFO(title);
      if (std::isinf(largest))
        CHECK(std::isnan(table.GetValueByName(k, title.c_str()).ToDouble()));
      else
        CHECK(table.GetValueByName(k, title.c_str()).ToDouble() == largest);
    }
  }

  vtkNew<vtkTargetDeflectionHistory> deflection;
  deflection->SetInputConnection(reader->GetOutputPort());
  deflection->Update();
  REQUIRE(deflection->GetOutput()->GetNumberOfRows() == 4);
  for (int k = 0; k < 4; ++k)
    CHECK(deflection->GetOutput()->GetValueByName(k, "max_deflection[m]").ToDouble() == 0);
}

TEST_CASE("a damaged frame in the middle gives no table, and the next try starts well", "[filters][series]")
{
  TemporaryFolder folder;
  write_series(folder.path, 4);
  const auto frame = folder.path / "frames" / "bird_0002.vtu";
  std::filesystem::copy_file(frame, folder.path / "good.vtu");
  std::filesystem::resize_file(frame, 2000);
  vtkNew<vtkBirdStrikeSeriesReader> reader;
  reader->SetFileName((folder.path / "run.pvd").string());
  vtkNew<vtkMaximumPressureHistory> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  auto errors = vtkSmartPointer<VtkErrors>::New();
  errors->watch(*reader);
  errors->watch(*filter);
  filter->Update();
  CHECK(filter->GetOutput()->GetNumberOfRows() == 0);
  CHECK_THAT(errors->first(), Contains("bird_0002.vtu"));

  std::filesystem::rename(folder.path / "good.vtu", frame);
  reader->Modified();
  filter->Update();
  REQUIRE(filter->GetOutput()->GetNumberOfRows() == 4);
  CHECK(filter->GetOutput()->GetValueByName(0, "time[s]").ToDouble() == 0);
}
