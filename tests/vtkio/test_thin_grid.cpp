// SPDX-License-Identifier: BSD-3-Clause
// What of a state goes into the series: fields, precision, compression, and files that frames share.
#include "vtkio/thin_grid.h"

#include "tests/vtkio/made_run.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/series_reader.h"
#include "vtkio/series_writer.h"
#include "vtkio/shells_to_vtk.h"

#include <catch2/catch.hpp>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>

using namespace birdstrike;
namespace fs = std::filesystem;

TEST_CASE("single precision keeps seven digits and halves the numbers", "[series]")
{
  const auto bird = particles_to_vtk(made_bird(0.03), 0);
  SeriesOptions options;
  options.single_precision = true;
  const auto thin = thin_grid(*bird, options);
  CHECK(thin->GetPoints()->GetDataType() == VTK_FLOAT);
  vtkDataArray* pressure = thin->GetPointData()->GetArray("pressure");
  REQUIRE(pressure->GetDataType() == VTK_FLOAT);
  CHECK(thin->GetPointData()->GetArray("id")->GetDataType() == VTK_INT);
  for (vtkIdType i = 0; i < bird->GetNumberOfPoints(); ++i) {
    const double exact = bird->GetPointData()->GetArray("pressure")->GetComponent(i, 0);
    REQUIRE(std::abs(pressure->GetComponent(i, 0) - exact) <= std::ldexp(std::abs(exact), -24));
  }
  CHECK(bird->GetPointData()->GetArray("pressure")->GetDataType() == VTK_DOUBLE); // untouched
}

TEST_CASE("only the fields that are wanted are kept, and what tells parts apart", "[series]")
{
  SeriesOptions options;
  options.fields = {"density", "contact_force"};
  const auto bird = thin_grid(*particles_to_vtk(made_bird(0.03), 0), options);
  CHECK(bird->GetPointData()->GetNumberOfArrays() == 4);
  for (const char* name : {"density", "pressure", "part", "id"})
    CHECK(bird->GetPointData()->HasArray(name));
  CHECK(bird->GetFieldData()->HasArray("part_names"));
  const auto target = thin_grid(*plate_to_vtk(made_plate(), 0), options);
  CHECK(target->GetCellData()->GetNumberOfArrays() == 1);
  CHECK(target->GetPointData()->HasArray("displacement"));
}

TEST_CASE("every compression gives the same state back", "[series]")
{
  const auto bird = particles_to_vtk(made_bird(0.03), 0);
  std::uintmax_t plain = 0;
  for (const Compression kind : {Compression::none, Compression::lz4, Compression::zlib, Compression::lzma}) {
    TemporaryFolder folder;
    SeriesOptions options;
    options.compression = kind;
    SeriesWriter writer(folder.path, options);
    writer.write_frame(0, *bird);
    const auto read = read_frame(read_series_index(folder.path), 0).bird; // a folder is enough
    CHECK(same_state(*read, *bird));
    if (kind == Compression::none)
      plain = writer.bytes();
    else
      CHECK(writer.bytes() < plain);
  }
}

TEST_CASE("same_state sees every change but that of the time", "[series]")
{
  const auto make = [] { return plate_to_vtk(made_plate(), 0); };
  CHECK(same_state(*make(), *plate_to_vtk(made_plate(), 1e-3)));
  const auto moved = make(), loaded = make(), shorter = make();
  moved->GetPoints()->SetPoint(7, 0, 0, 1e-9);
  CHECK_FALSE(same_state(*moved, *make()));
  loaded->GetCellData()->GetArray("contact_force")->SetComponent(5, 2, 1e-9);
  CHECK_FALSE(same_state(*loaded, *make()));
  shorter->GetCellData()->RemoveArray("contact_force");
  CHECK_FALSE(same_state(*shorter, *make()));
}

TEST_CASE("while a target does not change, its file is written once", "[series]")
{
  TemporaryFolder folder;
  SeriesWriter writer(folder.path);
  RigidPlate plate = made_plate();
  for (int k = 0; k < 5; ++k) {
    if (k == 3)
      plate.force[4] *= 2;
    writer.write_frame(k * 1e-4, *particles_to_vtk(made_bird(0.03), k * 1e-4), plate_to_vtk(plate, k * 1e-4));
  }
  const SeriesIndex index = read_series_index(writer.path());
  std::vector<std::string> targets;
  for (const SeriesStep& step : index.steps)
    targets.push_back(step.pieces.at(1).file.filename());
  CHECK(targets == std::vector<std::string>{"target_0000.vtu", "target_0000.vtu", "target_0000.vtu",
                                            "target_0003.vtu", "target_0003.vtu"});
  CHECK_FALSE(fs::exists(folder.path / "frames" / "target_0001.vtu"));
  CHECK(same_state(*read_frame(index, 4).target, *plate_to_vtk(plate, 0)));
}

TEST_CASE("a packed series is one file that the same readers open", "[series][packed]")
{
  TemporaryFolder folder;
  SeriesOptions options;
  options.vtu = false;
  options.packed = true;
  SeriesWriter writer(folder.path, options);
  for (int k = 0; k < 3; ++k)
    writer.write_frame(k * 1e-4, *particles_to_vtk(made_bird(0.03, 0.1 * k), k * 1e-4),
                       plate_to_vtk(made_plate(), k * 1e-4));
  CHECK(writer.path() == folder.path / "run.bss");
  CHECK(writer.bytes() == fs::file_size(writer.path()));
  CHECK_FALSE(fs::exists(folder.path / "frames"));
  for (const fs::path& place : {folder.path, writer.path()}) {
    const SeriesIndex index = read_series_index(place);
    REQUIRE(index.steps.size() == 3);
    const Frame frame = read_frame(index, 2);
    CHECK(frame.time == 2e-4);
    CHECK(frame.bird->GetNumberOfPoints() == particles_to_vtk(made_bird(0.03), 0)->GetNumberOfPoints());
    CHECK(frame.target->GetNumberOfCells() == 120);
  }
}
