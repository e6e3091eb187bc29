// SPDX-License-Identifier: BSD-3-Clause
#include "vtkio/write_particles.h"

#include "core/error.h"
#include "core/fields.h"
#include "tests/vtkio/made_run.h"

#include <catch2/catch.hpp>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <fstream>
#include <sstream>

using namespace birdstrike;

namespace {

template <class Reader>
vtkSmartPointer<vtkPointSet> read(const std::filesystem::path& file)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

void check_same(vtkPointSet& read, const Particles& bird)
{
  REQUIRE(read.GetNumberOfPoints() == static_cast<vtkIdType>(bird.size()));
  for (std::size_t i = 0; i < bird.size(); ++i) {
    const vtkIdType row = bird.id[i];
    double p[3];
    read.GetPoint(row, p);
    REQUIRE((p[0] == bird.x[i] && p[1] == bird.y[i] && p[2] == bird.z[i]));
    REQUIRE(read.GetPointData()->GetArray("part")->GetComponent(row, 0) == bird.part[i]);
    REQUIRE(read.GetPointData()->GetArray("mass")->GetComponent(row, 0) == bird.mass[i]);
    REQUIRE(read.GetPointData()->GetArray("velocity")->GetComponent(row, 2) == bird.vz[i]);
  }
  auto* names = vtkStringArray::SafeDownCast(read.GetFieldData()->GetAbstractArray("part_names"));
  REQUIRE(names);
  CHECK(names->GetValue(2) == "head");
}

std::vector<std::string> cells_of(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');)
    cells.push_back(cell);
  return cells;
}

} // namespace

TEST_CASE("particles written for ParaView read back with VTK, bit for bit", "[write_particles]")
{
  const TemporaryFolder folder;
  const Particles bird = made_bird(0.02);
  for (const bool cells : {true, false}) {
    const vtkIdType count = cells ? static_cast<vtkIdType>(bird.size()) : 0;
    write_particles(bird, folder.path / "bird.vtu", {cells});
    const auto grid = read<vtkXMLUnstructuredGridReader>(folder.path / "bird.vtu");
    check_same(*grid, bird);
    CHECK(grid->GetNumberOfCells() == count);
    write_particles(bird, folder.path / "bird.vtp", {cells});
    const auto points = read<vtkXMLPolyDataReader>(folder.path / "bird.vtp");
    check_same(*points, bird);
    CHECK(vtkPolyData::SafeDownCast(points)->GetNumberOfVerts() == count);
  }
}

TEST_CASE("particles in a spreadsheet have titles with units, and every digit", "[write_particles]")
{
  const TemporaryFolder folder;
  const Particles bird = made_bird(0.03);
  write_particles(bird, folder.path / "bird.csv");
  std::ifstream in(folder.path / "bird.csv");
  std::string line;
  REQUIRE(std::getline(in, line));
  const std::vector<std::string> titles = cells_of(line);
  CHECK(line.starts_with(
      "id,part,x[m],y[m],z[m],velocity_x[m/s],velocity_y[m/s],velocity_z[m/s],pressure[Pa]"));
  const auto column = [&](const std::string& title) {
    const auto found = std::find(titles.begin(), titles.end(), title);
    REQUIRE(found != titles.end());
    return static_cast<std::size_t>(found - titles.begin());
  };
  const std::vector<std::int32_t> row = bird.row_of_id();
  std::size_t id = 0;
  for (; std::getline(in, line); ++id) {
    const std::vector<std::string> cells = cells_of(line);
    REQUIRE(cells.size() == titles.size());
    const auto i = static_cast<std::size_t>(row.at(id));
    REQUIRE(std::stoul(cells[0]) == id);
    REQUIRE(cells[1] == bird.parts[bird.part[i]].name);
    REQUIRE(std::stod(cells[column("y[m]")]) == bird.y[i]);
    REQUIRE(std::stod(cells[column("mass[kg]")]) == bird.mass[i]);
    REQUIRE(std::stod(cells[column("density[kg/m3]")]) == bird.density[i]);
    REQUIRE(std::stod(cells[column("velocity_y[m/s]")]) == bird.vy[i]);
  }
  CHECK(id == bird.size());
}

TEST_CASE("particles that cannot be written leave nothing behind", "[write_particles]")
{
  const TemporaryFolder folder;
  const Particles bird = made_bird(0.05);
  CHECK_THROWS_WITH(write_particles(bird, folder.path / "bird.ply"),
                    Catch::Contains("particles are written as .vtu, .vtp or .csv"));
  for (const std::string& extension : particle_formats()) {
    CHECK_THROWS_AS(write_particles(bird, folder.path / "none" / ("bird" + extension)), OutputError);
    std::filesystem::create_directory(folder.path / ("taken" + extension));
    CHECK_THROWS_AS(write_particles(bird, folder.path / ("taken" + extension)), OutputError);
    std::filesystem::remove(folder.path / ("taken" + extension));
  }
  CHECK(std::filesystem::is_empty(folder.path));
}
