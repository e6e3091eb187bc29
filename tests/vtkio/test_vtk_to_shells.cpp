// SPDX-License-Identifier: BSD-3-Clause
#include "vtkio/vtk_to_shells.h"

#include "core/contact/rigid_plate.h"
#include "core/error.h"
#include "tests/geometry/shell_decks.h"
#include "vtkio/shells_to_vtk.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <unistd.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetWriter.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

using namespace birdstrike;
namespace fs = std::filesystem;

namespace {

struct Folder
{
  fs::path path = fs::temp_directory_path() / ("birdstrike-vtk-to-shells-" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder()
  {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  std::string operator/(const std::string& name) const { return (path / name).string(); }
};

template <class Array>
void add_array(vtkFieldData& data, const char* name, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  for (const double value : values)
    array->InsertNextTuple1(value);
  data.AddArray(array);
}

vtkSmartPointer<vtkPoints> deck_points()
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const Vector3& p : test::deck_mesh().points)
    points->InsertNextPoint((1e3 * p).eval().data());
  return points;
}

//! The mesh of all decks, in millimetres.
template <class Data>
void add_arrays(Data& data)
{
  add_array<vtkIntArray>(*data.GetCellData(), "PartId", {1, 2, 2});
  add_array<vtkDoubleArray>(*data.GetCellData(), "thickness", {2, 1.5, 1.5});
  add_array<vtkIntArray>(*data.GetPointData(), "node_set_set_1", {1, 1, 1, 0, 0, 0, 0});
}

vtkSmartPointer<vtkUnstructuredGrid> deck_grid()
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(deck_points());
  const vtkIdType cells[3][4] = {{0, 3, 4, 1}, {1, 4, 5, 2}, {4, 6, 5, 5}};
  grid->InsertNextCell(VTK_QUAD, 4, cells[0]);
  grid->InsertNextCell(VTK_QUAD, 4, cells[1]);
  grid->InsertNextCell(VTK_TRIANGLE, 3, cells[2]);
  add_arrays(*grid);
  return grid;
}

vtkSmartPointer<vtkPolyData> deck_surface()
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(deck_points());
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->InsertNextCell({0, 3, 4, 1});
  cells->InsertNextCell({1, 4, 5, 2});
  cells->InsertNextCell({4, 6, 5});
  surface->SetPolys(cells);
  add_arrays(*surface);
  return surface;
}

template <class Writer, class Data>
void write(const std::string& file, Data& data)
{
  auto writer = vtkSmartPointer<Writer>::New();
  writer->SetFileName(file.c_str());
  writer->SetInputData(&data);
  REQUIRE(writer->Write() == 1);
}

std::string text_of(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

template <class Action>
std::string input_error(Action action)
{
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

} // namespace

TEST_CASE("VTK files give the mesh of the decks", "[vtk_to_shells]")
{
  const Folder folder;
  write<vtkXMLUnstructuredGridWriter>(folder / "mesh.vtu", *deck_grid());
  write<vtkXMLPolyDataWriter>(folder / "mesh.vtp", *deck_surface());
  write<vtkDataSetWriter>(folder / "grid.vtk", *deck_grid());
  write<vtkDataSetWriter>(folder / "surface.vtk", *deck_surface());
  for (const char* name : {"mesh.vtu", "mesh.vtp", "grid.vtk", "surface.vtk"}) {
    INFO(name);
    const ShellImport import = read_vtk_shells(folder / name, 1e-3);
    CHECK(test::same_mesh(import.mesh, test::deck_mesh(), name[0] == 'm' ? 1e-15 : 1e-9));
    CHECK(import.warnings.empty());
  }
}

TEST_CASE("a frame of a run is a target again", "[vtk_to_shells]")
{
  const RigidPlate plate = make_rigid_plate(0.6, 0.4, 0.003, 6, 4);
  const ShellImport import = to_shells(*plate_to_vtk(plate, 0), 1.0, "frame");
  const ShellMesh expected = to_mesh(plate);
  CHECK(import.mesh.elements == expected.elements);
  CHECK(import.mesh.points.size() == expected.points.size());
  REQUIRE(import.mesh.parts.size() == 1);
  CHECK(import.mesh.parts[0].thickness == 0.003);
}

TEST_CASE("strips, pixels and polygons keep their outer side; other cells are counted", "[vtk_to_shells]")
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  auto points = vtkSmartPointer<vtkPoints>::New();
  for (int k = 0; k < 8; ++k)
    points->InsertNextPoint(k & 1, (k >> 1) & 1, k >> 2);
  grid->SetPoints(points);
  const vtkIdType row[] = {0, 1, 2, 3, 4, 5, 6, 7}, around[] = {0, 1, 3, 2};
  grid->InsertNextCell(VTK_PIXEL, 4, row);
  grid->InsertNextCell(VTK_TRIANGLE_STRIP, 4, row);
  grid->InsertNextCell(VTK_POLYGON, 4, around);
  grid->InsertNextCell(VTK_VOXEL, 8, row);
  grid->InsertNextCell(VTK_LINE, 2, row);
  grid->InsertNextCell(VTK_LINE, 2, row);
  const ShellImport import = to_shells(*grid, 1.0, "cells");
  CHECK(import.mesh.elements ==
        std::vector<ShellElement>{{0, 1, 3, 2}, {0, 1, 2, 2}, {2, 1, 3, 3}, {0, 1, 3, 2}});
  CHECK(import.warnings == std::vector<std::string>{"vtkVoxel: 1 skipped", "vtkLine: 2 skipped",
                                                    "elements on the same corners as one before: 1 kept",
                                                    "nodes of no shell element: 4 left out"});

  const vtkIdType five[] = {0, 1, 3, 2, 4};
  grid->InsertNextCell(VTK_POLYGON, 5, five);
  CHECK(input_error([&] { to_shells(*grid, 1.0, "cells"); }) ==
        "target file 'cells': cell 6 is a polygon of 5 corners; divide polygons into triangles and quads");
}

TEST_CASE("a part with two thicknesses becomes two", "[vtk_to_shells]")
{
  const auto grid = deck_grid();
  grid->GetCellData()->GetArray("thickness")->SetTuple1(2, 4);
  const ShellImport import = to_shells(*grid, 1e-3, "x");
  REQUIRE(import.mesh.parts.size() == 3);
  CHECK(import.mesh.parts[0].name == "part_1");
  CHECK(import.mesh.parts[1].name == "part_2_1");
  CHECK(import.mesh.parts[2].name == "part_2_2");
  CHECK(import.mesh.parts[2].thickness == 4e-3);
  grid->GetCellData()->GetArray("thickness")->SetTuple1(2, -4);
  CHECK_THAT(input_error([&] { to_shells(*grid, 1e-3, "x"); }),
             Catch::Contains("cell 2 has the thickness -4"));
}

TEST_CASE("damaged VTK files are refused by name", "[vtk_to_shells]")
{
  const Folder folder;
  write<vtkXMLUnstructuredGridWriter>(folder / "mesh.vtu", *deck_grid());
  write<vtkXMLPolyDataWriter>(folder / "mesh.vtp", *deck_surface());
  write<vtkDataSetWriter>(folder / "grid.vtk", *deck_grid());
  const auto message = [&](const std::string& name) {
    return input_error([&] { read_vtk_shells(folder / name); });
  };
  CHECK_THAT(message("none.vtu"), Catch::Contains("does not exist"));
  CHECK_THAT(message("../"), Catch::Contains("is not a file"));
  std::mt19937 random(11);
  for (const char* name : {"mesh.vtu", "mesh.vtp", "grid.vtk"}) {
    const std::string whole = text_of(folder / name);
    const auto attempt = [&](const std::string& text) {
      const std::string bad = std::string("bad") + fs::path(name).extension().string();
      std::ofstream(folder / bad, std::ios::binary) << text;
      return message(bad);
    };
    INFO(name);
    CHECK_THAT(attempt(""), Catch::Contains("is empty"));
    for (int k = 1; k < 8; ++k)
      CHECK_THAT(attempt(whole.substr(0, whole.size() * k / 9)), Catch::Contains("target file"));
    for (int k = 0; k < 10; ++k) {
      std::string noise(300, ' ');
      for (char& c : noise)
        c = static_cast<char>(random());
      CHECK_THAT(attempt(noise), Catch::Contains("target file"));
    }
  }
}
