// SPDX-License-Identifier: BSD-3-Clause
// Reads back what SeriesWriter wrote: the list of frames, and a frame.
#include "vtkio/series_reader.h"

#include "core/error.h"
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

SeriesIndex read_series_index(const fs::path& pvd)
{
  require_readable(pvd);
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

  SeriesIndex index{pvd, {}};
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
          ")");
  return reader->GetOutput();
}

Frame read_frame(const SeriesIndex& index, std::size_t step)
{
  require(step < index.steps.size(), index.pvd.string() + " has " + std::to_string(index.steps.size()) +
                                         " frames; there is no frame number " + std::to_string(step));
  Frame frame{index.steps[step].time, nullptr, nullptr};
  for (const SeriesPiece& piece : index.steps[step].pieces) {
    if (piece.name == "bird")
      frame.bird = read_grid(piece.file);
    else if (piece.name == "target")
      frame.target = read_grid(piece.file);
  }
  return frame;
}

} // namespace birdstrike
