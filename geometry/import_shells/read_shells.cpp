// SPDX-License-Identifier: GPL-3.0-or-later
// Shell meshes of users, by the format that the extension tells.
#include "geometry/import_shells/read_shells.h"

#include "core/error.h"
#include "geometry/import/read_mesh.h"
#include "geometry/import_shells/abaqus.h"
#include "geometry/import_shells/dyna.h"
#include "geometry/import_shells/gmsh.h"
#include "geometry/import_shells/nastran.h"
#include "geometry/import_shells/surface_to_shells.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace birdstrike {

namespace {

ShellImport read_surface(const std::filesystem::path& file, double unit)
{
  return surface_to_shells(read_mesh(file, unit), file.string());
}

struct Format
{
  const char* extension;
  ShellImport (*read)(const std::filesystem::path&, double);
};

//! A new format needs a line here.
constexpr Format formats[] = {
    {".msh", read_gmsh},    {".inp", read_abaqus},  {".bdf", read_nastran},  {".nas", read_nastran},
    {".fem", read_nastran}, {".dat", read_nastran}, {".k", read_dyna},       {".key", read_dyna},
    {".dyn", read_dyna},    {".stl", read_surface}, {".obj", read_surface},  {".ply", read_surface},
    {".off", read_surface}, {".glb", read_surface}, {".gltf", read_surface},
};

const Format* format_of(const std::filesystem::path& file)
{
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* const at = std::find_if(std::begin(formats), std::end(formats),
                                      [&](const Format& format) { return extension == format.extension; });
  return at == std::end(formats) ? nullptr : at;
}

} // namespace

std::string shell_formats()
{
  std::string list;
  for (const Format& format : formats)
    list += std::string(list.empty() ? "" : ", ") + format.extension;
  return list;
}

bool is_shell_file(const std::filesystem::path& file) { return format_of(file) != nullptr; }

ShellImport read_shells(const std::filesystem::path& file, double unit)
{
  const Format* const format = format_of(file);
  require(format, "target file '" + file.string() + "' has the unknown format '" + file.extension().string() +
                      "'; known are " + shell_formats());
  return format->read(file, unit);
}

} // namespace birdstrike
