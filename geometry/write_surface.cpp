// SPDX-License-Identifier: GPL-3.0-or-later
// Named surfaces into OBJ, PLY, STL and OFF files.
#include "geometry/write_surface.h"

#include "core/error.h"
#include "geometry/write_glb.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>

namespace birdstrike {

namespace {

std::size_t count_points(const SurfaceMesh& mesh)
{
  std::size_t count = 0;
  for (const SurfacePart& part : mesh)
    count += part.points.size();
  return count;
}
std::size_t count_triangles(const SurfaceMesh& mesh)
{
  std::size_t count = 0;
  for (const SurfacePart& part : mesh)
    count += part.triangles.size();
  return count;
}

// Lowest bytes first, whatever the machine.
void put(std::string& text, std::uint32_t value, int bytes = 4)
{
  for (int k = 0; k < bytes; ++k)
    text += char(value >> (8 * k) & 0xff);
}
void put(std::string& text, const Vector3& p)
{
  for (int k = 0; k < 3; ++k) {
    const float single = float(p[k]);
    std::uint32_t bits;
    static_assert(sizeof bits == sizeof single);
    std::copy_n(reinterpret_cast<const char*>(&single), sizeof bits, reinterpret_cast<char*>(&bits));
    put(text, bits);
  }
}
void print(std::string& text, const char* before, const Vector3& p)
{
  char line[120];
  std::snprintf(line, sizeof line, "%s%.9g %.9g %.9g\n", before, p.x(), p.y(), p.z());
  text += line;
}
void print(std::string& text, const char* before, const std::array<int, 3>& t, std::size_t first)
{
  text += before;
  for (int k = 0; k < 3; ++k)
    text += std::to_string(first + std::size_t(t[k])) + (k < 2 ? ' ' : '\n');
}

std::string obj(const SurfaceMesh& mesh)
{
  std::string text = "# " + std::string(axes_line) + "\n";
  std::size_t first = 1;
  for (const SurfacePart& part : mesh) {
    std::string name = part.name; // a blank would end it
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isspace(c); }, '_');
    text += "o " + name + "\ng " + name + "\n";
    for (const Vector3& p : part.points)
      print(text, "v ", p);
    for (const auto& t : part.triangles)
      print(text, "f ", t, first);
    first += part.points.size();
  }
  return text;
}

std::string off(const SurfaceMesh& mesh)
{
  std::string text =
      "OFF\n" + std::to_string(count_points(mesh)) + " " + std::to_string(count_triangles(mesh)) + " 0\n";
  for (const SurfacePart& part : mesh)
    for (const Vector3& p : part.points)
      print(text, "", p);
  std::size_t first = 0;
  for (const SurfacePart& part : mesh) {
    for (const auto& t : part.triangles)
      print(text, "3 ", t, first);
    first += part.points.size();
  }
  return text;
}

std::string ply(const SurfaceMesh& mesh)
{
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment " + std::string(axes_line) +
                     "\nelement vertex " + std::to_string(count_points(mesh)) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(count_triangles(mesh)) +
                     "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const SurfacePart& part : mesh)
    for (const Vector3& p : part.points)
      put(text, p);
  std::size_t first = 0;
  for (const SurfacePart& part : mesh) {
    for (const auto& t : part.triangles) {
      text += char(3);
      for (int corner : t)
        put(text, std::uint32_t(first + std::size_t(corner)));
    }
    first += part.points.size();
  }
  return text;
}

std::string stl(const SurfaceMesh& mesh)
{
  std::string text(axes_line); // must not begin with "solid"
  text.resize(80, ' ');
  put(text, std::uint32_t(count_triangles(mesh)));
  for (const SurfacePart& part : mesh)
    for (const auto& t : part.triangles) {
      const Vector3 &a = part.points[t[0]], &b = part.points[t[1]], &c = part.points[t[2]];
      const Vector3 normal = (b - a).cross(c - a);
      put(text, normal.norm() > 0 ? Vector3(normal.normalized()) : Vector3::Zero().eval());
      for (const Vector3* p : {&a, &b, &c})
        put(text, *p);
      put(text, 0, 2);
    }
  return text;
}

void write_whole(const std::string& text, const std::filesystem::path& file)
{
  const std::filesystem::path draft = file.string() + ".part";
  std::error_code error, ignored;
  {
    std::ofstream stream(draft, std::ios::binary);
    stream.write(text.data(), std::streamsize(text.size()));
    stream.close();
    if (!stream)
      error = std::make_error_code(std::errc::io_error);
  }
  if (!error)
    std::filesystem::rename(draft, file, error);
  if (error) {
    std::filesystem::remove(draft, ignored);
    throw OutputError("mesh file '" + file.string() +
                      "' cannot be written; check the folder and the free space");
  }
}

} // namespace

std::vector<std::string> surface_formats() { return {".glb", ".obj", ".ply", ".stl", ".off"}; }

void write_surface(const SurfaceMesh& mesh, const std::filesystem::path& file)
{
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  const bool known =
      ending == ".glb" || ending == ".obj" || ending == ".ply" || ending == ".stl" || ending == ".off";
  require(
      known,
      "mesh file '" + file.string() +
          "': surfaces are written as .glb, .obj, .ply, .stl or .off; give the file one of these endings");
  require(count_triangles(mesh) > 0, "mesh file '" + file.string() + "': there is no triangle to write");
  require(count_points(mesh) < std::size_t(std::numeric_limits<std::int32_t>::max()),
          "mesh file '" + file.string() + "': the mesh has more points than these formats can number");
  if (ending == ".glb")
    write_glb(mesh, file);
  else
    write_whole(ending == ".obj"   ? obj(mesh)
                : ending == ".ply" ? ply(mesh)
                : ending == ".stl" ? stl(mesh)
                                   : off(mesh),
                file);
}

} // namespace birdstrike
