// SPDX-License-Identifier: GPL-3.0-or-later
// Writes one seed a format for fuzz_import: make_seeds FOLDER
#include "fuzz_formats.h"
#include "geometry/import/scene_bytes.h"
#include "geometry/write_glb.h"
#include "mesh_files.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace birdstrike;

namespace {

void write(const std::filesystem::path& file, const std::string& format, const std::string& bytes)
{
  const auto at = std::find(fuzz_formats.begin(), fuzz_formats.end(), format);
  std::ofstream(file, std::ios::binary) << char(at - fuzz_formats.begin()) << bytes;
}

} // namespace

int main(int count, char** arguments)
{
  if (count != 2)
    return 2;
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  const SurfaceMesh bird = test::small_bird();
  for (const auto& [name, bytes] : test::sample_files(bird)) {
    const std::string extension = name.substr(name.find('.'));
    write(folder / name, extension, bytes);
    if (extension == ".3mf")
      write(folder / "direct_3mf", "3mf in this process", bytes);
  }
  write_glb(bird, folder / "draft.glb");
  {
    std::ifstream stream(folder / "draft.glb", std::ios::binary);
    write(folder / "sample.glb", ".glb", {std::istreambuf_iterator<char>(stream), {}});
  }
  std::filesystem::remove(folder / "draft.glb");

  RawScene scene;
  scene.parts = bird;
  std::string bytes = encode_scene(scene);
  bytes.resize(bytes.size() - 8); // the harness adds the sum
  write(folder / "scene", "scene bytes", bytes);

  std::string raw;
  for (const SurfacePart& part : bird) {
    raw += char(part.points.size() - 1);
    raw += char(part.triangles.size());
    for (const Vector3& p : part.points)
      for (int i = 0; i < 3; ++i) {
        const auto x = float(p[i]);
        raw.append(reinterpret_cast<const char*>(&x), sizeof x);
      }
    for (const auto& t : part.triangles)
      raw += {char(t[0] + 1), char(t[1]), char(t[2])};
  }
  write(folder / "triangles", "triangles", raw);
}
