// SPDX-License-Identifier: BSD-3-Clause
// Reads back what SeriesWriter wrote: the list of frames, and a frame.
#include "vtkio/series_reader.h"

#include "core/error.h"
#include "filters/series/PackedFile.h"
#include "vtkio/vtk_errors.h"

#include <vtkErrorCode.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>

namespace birdstrike {

namespace fs = std::filesystem;

namespace {

void require_readable(const fs::path& file)
{
  require(fs::exists(file), "cannot read " + file.string() + ": there is no such file");
  require(fs::is_regular_file(file), "cannot read " + file.string() + ": it is not a file");
  require(std::ifstream(file).good(), "cannot read " + file.string() + ": permission denied");
}

double read_time(const char* text, const fs::path& pvd)
{
  const std::string value = text ? text : "";
  double time = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), time);
  require(error == std::errc() && end == value.data() + value.size() && std::isfinite(time),
          pvd.string() + ": a DataSet has timestep=\"" + value + "\"; it must be a number of seconds");
  return time;
}

} // namespace

std::size_t SeriesIndex::nearest(double time) const
{
  const auto closer = [&](const SeriesStep& a, const SeriesStep& b) {
    return std::abs(a.time - time) < std::abs(b.time - time);
  };
  return static_cast<std::size_t>(std::min_element(steps.begin(), steps.end(), closer) - steps.begin());
}

namespace {

SeriesIndex open_packed(const fs::path& file)
{
  SeriesIndex index{file, {}, nullptr, {}};
  try {
    index.packed = std::make_shared<PackedFile>(file.string());
  } catch (const std::runtime_error& error) {
    throw InputError("cannot read " + file.string() + ": " + error.what());
  }
  for (const double time : index.packed->Times())
    index.steps.push_back({time, {}});
  index.warning = index.packed->Complaint();
  return index;
}

} // namespace

SeriesIndex read_series_index(const fs::path& series)
{
  std::error_code ignored;
  fs::path pvd = series;
  if (fs::is_directory(series, ignored)) {
    pvd = series / "run.pvd";
    if (!fs::exists(pvd, ignored))
      pvd = series / "run.bss";
    require(fs::exists(pvd, ignored),
            "cannot read a series in " + series.string() + ": the folder has neither run.pvd nor run.bss");
  }
  require_readable(pvd);
  if (pvd.extension() == ".bss")
    return open_packed(pvd);
  auto errors = vtkSmartPointer<VtkErrors>::New();
  auto parser = vtkSmartPointer<vtkXMLDataParser>::New();
  errors->watch(*parser);
  parser->SetFileName(pvd.string().c_str());
  const bool parsed = parser->Parse() == 1 && !errors->any();
  vtkXMLDataElement* root = parsed ? parser->GetRootElement() : nullptr;
  vtkXMLDataElement* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
  require(collection, pvd.string() + " is not a ParaView series (.pvd): " +
                          (errors->any() ? errors->first() : std::string("it has no Collection")));

  std::map<double, std::vector<SeriesPiece>> steps;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement* entry = collection->GetNestedElement(i);
    if (std::string(entry->GetName()) != "DataSet")
      continue;
    const char* file = entry->GetAttribute("file");
    require(file && *file, pvd.string() + ": a DataSet names no file");
    const char* name = entry->GetAttribute("name");
    const char* part = entry->GetAttribute("part");
    steps[read_time(entry->GetAttribute("timestep"), pvd)].push_back(
        {name && *name ? name : std::string("part_") + (part ? part : "0"), pvd.parent_path() / file});
  }
  require(!steps.empty(), pvd.string() + " lists no frames");

  SeriesIndex index{pvd, {}, nullptr, {}};
  for (auto& [time, pieces] : steps)
    index.steps.push_back({time, std::move(pieces)});
  return index;
}

vtkSmartPointer<vtkUnstructuredGrid> read_grid(const fs::path& vtu)
{
  require_readable(vtu);
  auto errors = vtkSmartPointer<VtkErrors>::New();
  auto reader = vtkSmartPointer<vtkXMLUnstructuredGridReader>::New();
  errors->watch(*reader);
  reader->SetReaderErrorObserver(errors);
  reader->SetParserErrorObserver(errors);
  reader->SetFileName(vtu.string().c_str());
  reader->Update();
  require(
      !errors->any() && reader->GetErrorCode() == vtkErrorCode::NoError,
      "cannot read " + vtu.string() + ": it is damaged or is not a .vtu file (" +
          (errors->any() ? errors->first() : vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode())) +
          "); run the case again, or take its line out of the .pvd");
  return reader->GetOutput();
}

std::vector<std::pair<std::string, vtkSmartPointer<vtkUnstructuredGrid>>>
read_pieces(const SeriesIndex& index, std::size_t step)
{
  require(step < index.steps.size(), index.pvd.string() + " has " + std::to_string(index.steps.size()) +
                                         " frames; there is no frame number " + std::to_string(step));
  if (index.packed) {
    try {
      return index.packed->Read(step);
    } catch (const std::runtime_error& error) {
      throw InputError("cannot read " + index.pvd.string() + ": " + error.what());
    }
  }
  std::vector<std::pair<std::string, vtkSmartPointer<vtkUnstructuredGrid>>> grids;
  for (const SeriesPiece& piece : index.steps[step].pieces)
    grids.emplace_back(piece.name, read_grid(piece.file));
  return grids;
}

Frame read_frame(const SeriesIndex& index, std::size_t step)
{
  Frame frame{0, nullptr, nullptr};
  for (const auto& [name, grid] : read_pieces(index, step)) {
    if (name == "bird")
      frame.bird = grid;
    else if (name == "target")
      frame.target = grid;
  }
  frame.time = index.steps[step].time;
  return frame;
}

} // namespace birdstrike
