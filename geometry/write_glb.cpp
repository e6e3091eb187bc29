// SPDX-License-Identifier: GPL-3.0-or-later
// Named surfaces into one binary glTF file: Khronos glTF 2.0 specification, chapters 3 and 4 (GLB).
#include "geometry/write_glb.h"

#include "core/error.h"
#include "geometry/measure.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

namespace birdstrike {

namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF specification.
constexpr int component_float = 5126, component_ushort = 5123, component_uint = 5125;
constexpr int target_points = 34962, target_triangles = 34963;
constexpr std::uint32_t glb_magic = 0x46546C67, chunk_json = 0x4E4F534A, chunk_binary = 0x004E4942;

// Muted colours that part neighbours well, for linear light; taken in turn.
constexpr double palette[][3] = {{0.10, 0.12, 0.16}, {0.14, 0.16, 0.20}, {0.42, 0.31, 0.20},
                                 {0.38, 0.36, 0.34}, {0.38, 0.36, 0.34}, {0.80, 0.74, 0.58},
                                 {0.66, 0.22, 0.20}};

class Writer
{
public:
  template <class T>
  int add_view(const std::vector<T>& data, int target)
  {
    const std::size_t at = binary.size();
    binary.resize(at + data.size() * sizeof(T));
    std::memcpy(binary.data() + at, data.data(), data.size() * sizeof(T));
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", at}, {"byteLength", data.size() * sizeof(T)}, {"target", target}});
    binary.resize((binary.size() + 3) / 4 * 4);
    return int(json["bufferViews"].size()) - 1;
  }
  int add_accessor(Json accessor)
  {
    json["accessors"].push_back(std::move(accessor));
    return int(json["accessors"].size()) - 1;
  }
  int add_vectors(const std::vector<Vector3>& rows, bool with_range)
  {
    std::vector<float> data;
    Eigen::Vector3f lower = Eigen::Vector3f::Constant(1e30f), upper = -lower;
    for (const Vector3& row : rows) {
      const Eigen::Vector3f single = row.cast<float>();
      data.insert(data.end(), single.data(), single.data() + 3);
      lower = lower.cwiseMin(single);
      upper = upper.cwiseMax(single);
    }
    Json accessor{{"bufferView", add_view(data, target_points)},
                  {"componentType", component_float},
                  {"count", rows.size()},
                  {"type", "VEC3"}};
    if (with_range) {
      accessor["min"] = {lower[0], lower[1], lower[2]};
      accessor["max"] = {upper[0], upper[1], upper[2]};
    }
    return add_accessor(std::move(accessor));
  }
  template <class Index>
  int add_indices(const SurfacePart& part, int component)
  {
    std::vector<Index> data;
    for (const auto& t : part.triangles)
      for (int corner : t)
        data.push_back(Index(corner));
    return add_accessor({{"bufferView", add_view(data, target_triangles)},
                         {"componentType", component},
                         {"count", data.size()},
                         {"type", "SCALAR"}});
  }

  Json json{{"asset", {{"version", "2.0"}, {"generator", "BirdStrike"}}}};
  std::vector<char> binary;
};

std::vector<Vector3> smooth_normals(const SurfacePart& part)
{
  std::vector<Vector3> normals(part.points.size(), Vector3::Zero());
  for (const auto& t : part.triangles) {
    const Vector3 twice_area =
        (part.points[t[1]] - part.points[t[0]]).cross(part.points[t[2]] - part.points[t[0]]);
    for (int corner : t)
      normals[corner] += twice_area;
  }
  for (Vector3& n : normals)
    n = n.norm() > 0 ? n.normalized() : Vector3::UnitZ();
  return normals;
}

void put(std::ostream& stream, std::uint32_t value) // glTF is little-endian
{
  const unsigned char bytes[] = {static_cast<unsigned char>(value), static_cast<unsigned char>(value >> 8),
                                 static_cast<unsigned char>(value >> 16),
                                 static_cast<unsigned char>(value >> 24)};
  stream.write(reinterpret_cast<const char*>(bytes), 4);
}

} // namespace

void write_glb(const SurfaceMesh& mesh, const std::filesystem::path& file)
{
  Writer writer;
  Json& json = writer.json;
  json["scene"] = 0;
  json["scenes"] = Json::array({{{"nodes", {0}}}});
  // The root turns our up, +z, to glTF's, +y: columns of a matrix whose numbers are exact.
  json["nodes"].push_back({{"name", "bird"},
                           {"matrix", {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1}},
                           {"children", Json::array()}});
  for (std::size_t p = 0; p < mesh.size(); ++p) {
    const SurfacePart& part = mesh[p];
    const int points = writer.add_vectors(part.points, true),
              normals = writer.add_vectors(smooth_normals(part), false);
    const int indices = part.points.size() < 65535 ? writer.add_indices<std::uint16_t>(part, component_ushort)
                                                   : writer.add_indices<std::uint32_t>(part, component_uint);
    const auto& colour = palette[p % std::size(palette)];
    json["materials"].push_back({{"name", part.name},
                                 {"pbrMetallicRoughness",
                                  {{"baseColorFactor", {colour[0], colour[1], colour[2], 1.0}},
                                   {"metallicFactor", 0.0},
                                   {"roughnessFactor", 0.8}}}});
    json["meshes"].push_back(
        {{"name", part.name},
         {"primitives", Json::array({{{"attributes", {{"POSITION", points}, {"NORMAL", normals}}},
                                      {"indices", indices},
                                      {"material", p}}})}});
    json["nodes"].push_back({{"name", part.name}, {"mesh", p}});
    json["nodes"][0]["children"].push_back(p + 1);
  }
  json["buffers"] = Json::array({{{"byteLength", writer.binary.size()}}});
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');

  const std::filesystem::path draft = file.string() + ".part";
  std::error_code error;
  {
    std::ofstream stream(draft, std::ios::binary);
    put(stream, glb_magic);
    put(stream, 2);
    put(stream, std::uint32_t(12 + 8 + text.size() + 8 + writer.binary.size()));
    put(stream, std::uint32_t(text.size()));
    put(stream, chunk_json);
    stream << text;
    put(stream, std::uint32_t(writer.binary.size()));
    put(stream, chunk_binary);
    stream.write(writer.binary.data(), std::streamsize(writer.binary.size()));
    stream.close();
    if (stream)
      std::filesystem::rename(draft, file, error);
    else
      error = std::make_error_code(std::errc::io_error);
  }
  if (error) {
    std::error_code ignored;
    std::filesystem::remove(draft, ignored);
    throw OutputError("mesh file '" + file.string() +
                      "' cannot be written; check the folder and the free space");
  }
}

} // namespace birdstrike
