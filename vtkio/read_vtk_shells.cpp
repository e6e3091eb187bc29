// SPDX-License-Identifier: BSD-3-Clause
// A target from a VTK file.
#include "core/error.h"
#include "vtkio/vtk_errors.h"
#include "vtkio/vtk_to_shells.h"

#include <vtkErrorCode.h>
#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cctype>
#include <fstream>

namespace birdstrike {

namespace {

std::string lower_extension(const std::filesystem::path& file)
{
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

//! Keeps the first complaint that VTK prints without an object that could be watched, instead of printing it.
class Listener : public vtkOutputWindow
{
public:
  static Listener* New() { VTK_STANDARD_NEW_BODY(Listener); }
  void DisplayText(const char* text) override
  {
    if (first.empty() && text)
      first = text;
  }
  std::string first;
};

//! The one listener while it lives.
class Quiet
{
public:
  Quiet() : before_(vtkOutputWindow::GetInstance()), verbosity_(vtkLogger::GetCurrentVerbosityCutoff())
  {
    vtkOutputWindow::SetInstance(listener_);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~Quiet()
  {
    vtkOutputWindow::SetInstance(before_);
    vtkLogger::SetStderrVerbosity(verbosity_);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
  std::string first() const
  {
    std::string line = listener_->first.substr(0, listener_->first.find_last_not_of('\n') + 1);
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
  }

private:
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkLogger::Verbosity verbosity_;
  vtkSmartPointer<Listener> listener_ = vtkSmartPointer<Listener>::New();
};

//! Run a reader that complains instead of printing.
template <class Reader>
vtkSmartPointer<vtkDataSet> read_with(const std::filesystem::path& file)
{
  const Quiet quiet;
  auto errors = vtkSmartPointer<VtkErrors>::New();
  auto reader = vtkSmartPointer<Reader>::New();
  errors->watch(*reader);
  if constexpr (requires { reader->SetReaderErrorObserver(errors); }) {
    reader->SetReaderErrorObserver(errors);
    reader->SetParserErrorObserver(errors);
  }
  reader->SetFileName(file.string().c_str());
  reader->Update();
  vtkDataSet* data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  require(data && !errors->any() && quiet.first().empty() && reader->GetErrorCode() == vtkErrorCode::NoError,
          "target file '" + file.string() + "' is damaged or not what its extension says (" +
              (errors->any() ? errors->first()
               : !quiet.first().empty()
                   ? quiet.first()
                   : std::string(vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()))) +
              "); export it again");
  return data;
}

//! Which reader a legacy file needs stands in its line "DATASET POLYDATA".
vtkSmartPointer<vtkDataSet> read_legacy(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  std::string head(4096, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  require(head.starts_with("# vtk DataFile"),
          "target file '" + file.string() +
              "' is no legacy VTK file: it does not start with '# vtk DataFile'");
  std::transform(head.begin(), head.end(), head.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const std::size_t at = head.find("\nDATASET ");
  const std::string kind =
      at == std::string::npos ? "" : head.substr(at + 9, head.find_first_of(" \r\n", at + 9) - at - 9);
  if (kind == "UNSTRUCTURED_GRID")
    return read_with<vtkUnstructuredGridReader>(file);
  require(kind == "POLYDATA", "target file '" + file.string() + "' holds the data set '" +
                                  kind.substr(0, 40) +
                                  "'; shells are read from UNSTRUCTURED_GRID and POLYDATA");
  return read_with<vtkPolyDataReader>(file);
}

} // namespace

bool is_vtk_file(const std::filesystem::path& file)
{
  const std::string extension = lower_extension(file);
  return extension == ".vtu" || extension == ".vtp" || extension == ".vtk";
}

ShellImport read_vtk_shells(const std::filesystem::path& file, double unit)
{
  const std::string name = "target file '" + file.string() + "'";
  std::error_code error;
  require(std::filesystem::exists(file, error), name + " does not exist; check the path");
  require(std::filesystem::is_regular_file(file, error), name + " is not a file");
  require(std::filesystem::file_size(file, error) > 0 && !error, name + " is empty");
  require(std::ifstream(file).good(), name + " cannot be opened; check its permissions");
  require(is_vtk_file(file), name + " is no .vtu, .vtp or .vtk file");
  const std::string extension = lower_extension(file);
  const auto data = extension == ".vtu"   ? read_with<vtkXMLUnstructuredGridReader>(file)
                    : extension == ".vtp" ? read_with<vtkXMLPolyDataReader>(file)
                                          : read_legacy(file);
  return to_shells(*data, unit, file.string());
}

} // namespace birdstrike
