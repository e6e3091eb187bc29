// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh file holds: the right reader, in a process of its own.
#include "geometry/import/raw_scene.h"

#include "core/error.h"
#include "geometry/import/formats.h"
#include "geometry/import/isolate.h"
#include "geometry/import/scene_bytes.h"

#include <algorithm>
#include <cctype>

namespace birdstrike {

namespace {

constexpr const char* known_formats =
    "OBJ, glTF/GLB, STL, PLY, OFF, COLLADA (.dae), 3MF, STEP, IGES, X3D, 3DS and FBX";

// What a reader may take. Text of a triangle is some 100 bytes long, its scene some 300; zipped text is ten times
// shorter; the rest is for libraries and their tables.
constexpr std::size_t memory_at_least = std::size_t(2) << 30, memory_per_byte = 100;
// A slow machine reads 1 MB/s; a hundred times more hangs. CAD and glTF may lead to far more than the file's size.
constexpr double seconds_at_least = 10, seconds_of_cad = 120, seconds_per_byte = 2e-5;

std::string lower_extension(const std::filesystem::path& file)
{
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

bool is_one_of(const std::string& extension, std::initializer_list<const char*> list)
{
  return std::find(list.begin(), list.end(), extension) != list.end();
}

bool is_cad(const std::string& extension) { return is_one_of(extension, {".step", ".stp", ".iges", ".igs"}); }

using ReadFile = RawScene (*)(const std::filesystem::path&);

ReadFile reader_of(const std::filesystem::path& file, const std::string& text)
{
  std::error_code error;
  require(std::filesystem::exists(file, error), text + " does not exist; check the path");
  require(std::filesystem::is_regular_file(file, error), text + " is not a file");
  require(std::filesystem::file_size(file, error) > 0 && !error, text + " is empty");
  const std::string extension = lower_extension(file);
  require(!is_one_of(extension, {".brep", ".x_t", ".x_b", ".sat", ".catpart", ".catproduct", ".sldprt",
                                 ".sldasm", ".prt", ".ipt", ".f3d", ".3dm"}),
          text + " is in a format of one CAD program, which cannot be read; export " +
              (cad_is_read() ? "STEP, " : "") + "STL, OBJ or glTF");
  if (is_cad(extension))
    return [](const std::filesystem::path& path) { return read_cad(path); };
  if (extension == ".3mf")
    return read_3mf;
  require(assimp_knows(extension),
          text + " has the unknown format '" + extension + "'; known are " + known_formats);
  return read_by_assimp;
}

//! Names for what has none: the file's, with a number where there are several.
void name_the_nameless(RawScene& scene, const std::string& stem)
{
  scene.named =
      std::any_of(scene.parts.begin(), scene.parts.end(), [](const auto& p) { return !p.name.empty(); });
  const auto nameless =
      std::count_if(scene.parts.begin(), scene.parts.end(), [](const auto& p) { return p.name.empty(); });
  int number = 0;
  for (SurfacePart& part : scene.parts)
    if (part.name.empty())
      part.name = nameless == 1 ? stem : stem + "_" + std::to_string(++number);
}

} // namespace

RawScene read_scene(const std::filesystem::path& file)
{
  const std::string text = "mesh file '" + file.string() + "'";
  const ReadFile read = reader_of(file, text);
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  const std::string extension = lower_extension(file);
  const bool leads_further = is_cad(extension) || extension == ".gltf";
  const IsolationLimits limits{(leads_further ? seconds_of_cad : seconds_at_least) +
                                   seconds_per_byte * double(size),
                               memory_at_least + memory_per_byte * std::size_t(size)};
  const std::string bytes = run_isolated(text, limits, [&] { return encode_scene(read(file)); });
  RawScene scene;
  try {
    scene = decode_scene(bytes);
  } catch (const InputError& damaged) {
    throw InputError(text + ": " + damaged.what() + "; export it again");
  }
  std::erase_if(scene.parts, [](const SurfacePart& part) { return part.triangles.empty(); });
  require(!scene.parts.empty(), text + " holds no triangles; export the surface of each part");
  name_the_nameless(scene, file.stem().string());
  return scene;
}

} // namespace birdstrike
