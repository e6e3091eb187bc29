// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer's harness of the importer: any bytes become parts or an InputError.
//
//   fuzz_import -max_total_time=60 corpus seeds
//
// Readers of files run in a process of their own, where the fuzzer sees no coverage; so the code behind them is also
// fed directly, with scenes and triangles made of the bytes.
#include "core/error.h"
#include "fuzz_formats.h"
#include "geometry/check.h"
#include "geometry/import/find_axes.h"
#include "geometry/import/formats.h"
#include "geometry/import/import_mesh.h"
#include "geometry/import/mend_units.h"
#include "geometry/import/scene_bytes.h"
#include "geometry/import/weld.h"
#include "geometry/topology.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <unistd.h>

using namespace birdstrike;

namespace {

constexpr std::size_t most_triangles = 2000; // a slow input teaches nothing

//! One folder a process, gone at its end.
struct Folder
{
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("birdstrike-fuzz-" + std::to_string(::getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

std::filesystem::path write(const char* extension, const std::uint8_t* data, std::size_t size)
{
  static const Folder folder;
  const std::filesystem::path file = folder.path / (std::string("input") + extension);
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), std::streamsize(size));
  return file;
}

void look_at(const SurfaceMesh& parts)
{
  for (const SurfacePart& part : parts)
    if (part.triangles.size() <= most_triangles) {
      split_components(part, find_topology(part));
      check_surface(part);
    }
}

//! Everything that happens to parts between the reader and the fill.
void treat(SurfaceMesh parts)
{
  mend_units(parts, "fuzz");
  weld_parts(parts);
  find_axes(parts, {"", "", "+y"});
  look_at(parts);
}

//! Bytes: number of points, then coordinates as floats, then corners as bytes; names from a short list.
SurfaceMesh triangles_of(const std::uint8_t* data, std::size_t size)
{
  const char* names[] = {"torso", "head", "wing_left", "wing_right", "legs"};
  SurfaceMesh parts;
  while (size > 16 && parts.size() < 5) {
    SurfacePart part{names[parts.size()], {}, {}};
    const std::size_t points = std::min<std::size_t>(1 + data[0] % 32, (size - 2) / 12), triangles = data[1];
    data += 2, size -= 2;
    for (std::size_t i = 0; i < points; ++i, data += 12, size -= 12) {
      float xyz[3];
      std::memcpy(xyz, data, 12);
      part.points.emplace_back(xyz[0], xyz[1], xyz[2]);
    }
    for (std::size_t i = 0; i < triangles && size >= 3; ++i, data += 3, size -= 3)
      part.triangles.push_back({data[0] - 1, data[1], data[2]}); // -1 and rows that are not there, too
    parts.push_back(std::move(part));
  }
  return parts;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size < 2)
    return 0;
  const std::string format = fuzz_formats[data[0] % fuzz_formats.size()];
  ++data, --size;
  try {
    if (format == "scene bytes")
      treat(decode_scene(signed_bytes(std::string(reinterpret_cast<const char*>(data), size))).parts);
    else if (format == "triangles") {
      SurfaceMesh parts = triangles_of(data, size);
      for (SurfacePart& part : parts)
        weld(part, 0); // refuses corners that are not there and what is not finite
      treat(std::move(parts));
    } else if (format == "3mf in this process")
      treat(read_3mf(write(".3mf", data, size)).parts);
    else
      look_at(import_mesh({write(format.c_str(), data, size)}, {.mass = 4}).parts);
  } catch (const InputError&) {
    // That is what it should do.
  }
  return 0;
}
