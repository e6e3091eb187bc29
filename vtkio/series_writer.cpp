// SPDX-License-Identifier: BSD-3-Clause
// A run's frames on disk, as a series that ParaView opens at any moment.
#include "vtkio/series_writer.h"

#include "core/error.h"
#include "vtkio/atomic_file.h"
#include "vtkio/write_vtk_xml.h"

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike {

namespace fs = std::filesystem;

namespace {

// Of one of our own frames, whole or half written: bird_0012.vtu, target_0003.vtu.tmp
bool is_frame(const std::string& name)
{
  return (name.starts_with("bird_") || name.starts_with("target_")) &&
         (name.ends_with(".vtu") || name.ends_with(".vtu.tmp"));
}

// An older run's frames would stay behind a shorter new series, so they go; the index goes first, so that no
// moment has an index without its frames.
void remove_old_series(const fs::path& folder)
{
  std::error_code error;
  fs::remove(folder / "run.pvd", error);
  if (error)
    throw OutputError("cannot replace " + (folder / "run.pvd").string() + ": " + error.message());
  for (const auto& entry : fs::directory_iterator(folder / "frames", error))
    if (is_frame(entry.path().filename().string()))
      fs::remove(entry.path(), error);
  if (error)
    throw OutputError("cannot clear the folder " + (folder / "frames").string() + ": " + error.message());
}

std::string write_vtu(vtkUnstructuredGrid& grid, const fs::path& file)
{
  return write_vtk_xml(*vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New(), grid, file);
}

} // namespace

SeriesWriter::SeriesWriter(fs::path folder) : folder_(std::move(folder))
{
  make_folder(folder_ / "frames");
  remove_old_series(folder_);
}

void SeriesWriter::write_frame(double time, vtkUnstructuredGrid& bird, vtkUnstructuredGrid* target)
{
  std::string entries;
  std::uintmax_t bytes = 0;
  const auto add = [&](vtkUnstructuredGrid& grid, const std::string& name, int part) {
    const std::string piece = fmt::format("frames/{}_{:04}.vtu", name, frames_);
    write_atomically(folder_ / piece, [&](const fs::path& file) { return write_vtu(grid, file); });
    entries += fmt::format("    <DataSet timestep=\"{:.17g}\" part=\"{}\" name=\"{}\" file=\"{}\"/>\n", time,
                           part, name, piece);
    bytes += fs::file_size(folder_ / piece);
  };
  if (!std::isfinite(time))
    throw OutputError(fmt::format("cannot write a frame at time {}: it is not finite", time));
  add(bird, "bird", 0);
  if (target)
    add(*target, "target", 1);

  // Only now, with all its files whole, does the frame count.
  write_text_atomically(pvd(), "<?xml version=\"1.0\"?>\n"
                               "<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n" +
                                   entries_ + entries + "  </Collection>\n</VTKFile>\n");
  entries_ += entries;
  bytes_ += bytes;
  ++frames_;
}

} // namespace birdstrike
