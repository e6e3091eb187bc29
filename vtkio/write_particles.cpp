// SPDX-License-Identifier: BSD-3-Clause
// Particles as a file of their own, for ParaView, spreadsheets and other people's programs.
#include "vtkio/write_particles.h"

#include "core/error.h"
#include "core/fields.h"
#include "vtkio/atomic_file.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/table_to_csv.h"
#include "vtkio/write_vtk_xml.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

namespace birdstrike {

namespace {

void write_vtu(const Particles& particles, const std::filesystem::path& file, bool cells)
{
  auto grid = particles_to_vtk(particles, 0);
  if (!cells)
    grid->SetCells(VTK_VERTEX, vtkSmartPointer<vtkCellArray>::New());
  write_atomically(file, [&](const std::filesystem::path& temporary) {
    return write_vtk_xml(*vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New(), *grid, temporary);
  });
}

void write_vtp(const Particles& particles, const std::filesystem::path& file, bool cells)
{
  auto grid = particles_to_vtk(particles, 0);
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(grid->GetPoints());
  points->GetPointData()->ShallowCopy(grid->GetPointData());
  points->GetFieldData()->ShallowCopy(grid->GetFieldData());
  if (cells)
    points->SetVerts(grid->GetCells());
  write_atomically(file, [&](const std::filesystem::path& temporary) {
    return write_vtk_xml(*vtkSmartPointer<vtkXMLPolyDataWriter>::New(), *points, temporary);
  });
}

template <class Value>
void add_column(vtkTable& table, const std::string& title, vtkIdType count, Value value)
{
  auto column = vtkSmartPointer<vtkDoubleArray>::New();
  column->SetName(title.c_str());
  column->SetNumberOfValues(count);
  for (vtkIdType k = 0; k < count; ++k)
    column->SetValue(k, value(k));
  table.AddColumn(column);
}

void write_table(const Particles& particles, const std::filesystem::path& file)
{
  const auto count = static_cast<vtkIdType>(particles.size());
  const std::vector<std::int32_t> row_of_id = particles.row_of_id();
  const auto row = [&](vtkIdType id) {
    return static_cast<std::size_t>(row_of_id[static_cast<std::size_t>(id)]);
  };

  auto table = vtkSmartPointer<vtkTable>::New();
  auto id = vtkSmartPointer<vtkIntArray>::New();
  auto part = vtkSmartPointer<vtkStringArray>::New();
  id->SetName("id");
  part->SetName("part");
  id->SetNumberOfValues(count);
  part->SetNumberOfValues(count);
  for (vtkIdType k = 0; k < count; ++k) {
    id->SetValue(k, particles.id[row(k)]);
    part->SetValue(k, particles.parts[particles.part[row(k)]].name);
  }
  table->AddColumn(id);
  table->AddColumn(part);
  add_column(*table, "x[m]", count, [&](vtkIdType k) { return particles.x[row(k)]; });
  add_column(*table, "y[m]", count, [&](vtkIdType k) { return particles.y[row(k)]; });
  add_column(*table, "z[m]", count, [&](vtkIdType k) { return particles.z[row(k)]; });
  for (const Field<Particles>& field : particle_fields)
    for (int component = 0; component < field.components; ++component) {
      std::string title(field.name);
      if (field.components > 1)
        title += std::string("_") + "xyz"[component];
      if (field.unit != "-")
        title += "[" + std::string(field.unit) + "]";
      add_column(*table, title, count,
                 [&](vtkIdType k) { return field.value(particles, row(k), component); });
    }
  write_csv(*table, file);
}

} // namespace

std::vector<std::string> particle_formats() { return {".vtu", ".vtp", ".csv"}; }

void write_particles(const Particles& particles, const std::filesystem::path& file,
                     const WriteOptions& options)
{
  const std::string extension = file.extension().string();
  if (extension == ".vtu")
    write_vtu(particles, file, options.cells);
  else if (extension == ".vtp")
    write_vtp(particles, file, options.cells);
  else if (extension == ".csv")
    write_table(particles, file);
  else
    throw InputError(file.string() +
                     ": particles are written as .vtu, .vtp or .csv; give the file one of these endings");
}

} // namespace birdstrike
