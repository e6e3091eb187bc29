// SPDX-License-Identifier: GPL-3.0-or-later
// Small writers of every mesh format that the importer reads.
#include "mesh_files.h"

#include "geometry/shapes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace birdstrike::test {

namespace {

std::ostringstream text_stream()
{
  std::ostringstream text;
  text.precision(9);
  return text;
}

template <class T>
void put(std::string& bytes, T value, bool reversed = false)
{
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (reversed)
    std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

SurfacePart joined(const SurfaceMesh& mesh)
{
  SurfacePart all;
  for (const SurfacePart& part : mesh) {
    const int first = int(all.points.size());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (const auto& t : part.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

std::string base64(const std::string& bytes)
{
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? letters[three >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::uint32_t crc32(const std::string& bytes)
{
  std::uint32_t crc = ~0u;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit)
      crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0u);
  }
  return ~crc;
}

//! Files in a zip archive, stored: APPNOTE.TXT of PKWARE, 4.3.7 and 4.3.12 to 4.3.16.
std::string zip(const std::vector<std::pair<std::string, std::string>>& files)
{
  std::string archive, directory;
  for (const auto& [name, content] : files) {
    std::string common; // what both headers share
    for (const std::uint16_t field : {20, 0, 0, 0, 33})
      put(common, field); // version, flags, stored, time, 1 January 1980
    put(common, crc32(content));
    put(common, std::uint32_t(content.size()));
    put(common, std::uint32_t(content.size()));
    put(common, std::uint16_t(name.size()));
    put(common, std::uint16_t(0));
    const auto offset = std::uint32_t(archive.size());
    put(archive, std::uint32_t(0x04034b50));
    archive += common + name + content;
    put(directory, std::uint32_t(0x02014b50));
    put(directory, std::uint16_t(20));
    directory += common;
    for (int i = 0; i < 3; ++i)
      put(directory, std::uint16_t(0));
    put(directory, std::uint32_t(0));
    put(directory, offset);
    directory += name;
  }
  const auto start = std::uint32_t(archive.size());
  archive += directory;
  put(archive, std::uint32_t(0x06054b50));
  for (const std::size_t field : {std::size_t(0), std::size_t(0), files.size(), files.size()})
    put(archive, std::uint16_t(field));
  put(archive, std::uint32_t(directory.size()));
  put(archive, start);
  put(archive, std::uint16_t(0));
  return archive;
}

} // namespace

std::string obj_bytes(const SurfaceMesh& mesh, char keyword, bool materials)
{
  std::ostringstream text = text_stream();
  int first = 1;
  for (const SurfacePart& part : mesh) {
    if (keyword != ' ')
      text << keyword << " " << part.name << "\n";
    for (const Vector3& p : part.points)
      text << "v " << p.transpose() << "\n";
    for (std::size_t t = 0; t < part.triangles.size(); ++t) {
      if (materials && (t == 0 || t == part.triangles.size() / 2))
        text << "usemtl paint_" << t << "\n";
      const auto& corners = part.triangles[t];
      text << "f " << corners[0] + first << " " << corners[1] + first << " " << corners[2] + first << "\n";
    }
    first += int(part.points.size());
  }
  return text.str();
}

std::string stl_text(const SurfaceMesh& mesh)
{
  std::ostringstream text = text_stream();
  for (const SurfacePart& part : mesh) {
    text << "solid " << part.name << "\n";
    for (const auto& t : part.triangles) {
      text << "facet normal 0 0 0\nouter loop\n";
      for (int corner : t)
        text << "vertex " << part.points[corner].transpose() << "\n";
      text << "endloop\nendfacet\n";
    }
    text << "endsolid " << part.name << "\n";
  }
  return text.str();
}

std::string stl_bytes(const SurfaceMesh& mesh, const std::string& header)
{
  const SurfacePart all = joined(mesh);
  std::string bytes = header;
  bytes.resize(80, '\0');
  put(bytes, std::uint32_t(all.triangles.size()));
  for (const auto& t : all.triangles) {
    for (int i = 0; i < 3; ++i)
      put(bytes, 0.0f);
    for (int corner : t)
      for (int i = 0; i < 3; ++i)
        put(bytes, float(all.points[corner][i]));
    put(bytes, std::uint16_t(0));
  }
  return bytes;
}

std::string ply_bytes(const SurfaceMesh& mesh, PlyKind kind)
{
  const SurfacePart all = joined(mesh);
  std::ostringstream text = text_stream();
  const char* formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  text << "ply\nformat " << formats[int(kind)] << " 1.0\nelement vertex " << all.points.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << all.triangles.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  if (kind == PlyKind::text) {
    for (const Vector3& p : all.points)
      text << p.transpose() << "\n";
    for (const auto& t : all.triangles)
      text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
    return text.str();
  }
  std::string bytes = text.str();
  const bool reversed = kind == PlyKind::big_endian;
  for (const Vector3& p : all.points)
    for (int i = 0; i < 3; ++i)
      put(bytes, float(p[i]), reversed);
  for (const auto& t : all.triangles) {
    put(bytes, std::uint8_t(3));
    for (int corner : t)
      put(bytes, std::int32_t(corner), reversed);
  }
  return bytes;
}

std::string off_bytes(const SurfaceMesh& mesh)
{
  const SurfacePart all = joined(mesh);
  std::ostringstream text = text_stream();
  text << "OFF\n" << all.points.size() << " " << all.triangles.size() << " 0\n";
  for (const Vector3& p : all.points)
    text << p.transpose() << "\n";
  for (const auto& t : all.triangles)
    text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  return text.str();
}

std::string gltf_bytes(const SurfaceMesh& mesh, const std::string& generator, const std::string& nodes,
                       const std::string& roots)
{
  std::string data;
  std::ostringstream views = text_stream(), accessors = text_stream(), meshes = text_stream(),
                     default_nodes = text_stream(), default_roots = text_stream();
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const SurfacePart& part = mesh[i];
    const char* comma = i == 0 ? "" : ",";
    Vector3 lower = part.points[0], upper = lower;
    const std::size_t start = data.size();
    for (const Vector3& p : part.points) {
      lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
      for (int k = 0; k < 3; ++k)
        put(data, float(p[k]));
    }
    const std::size_t middle = data.size();
    for (const auto& t : part.triangles)
      for (int corner : t)
        put(data, std::uint32_t(corner));
    views << comma << R"({"buffer":0,"byteOffset":)" << start << R"(,"byteLength":)" << middle - start
          << R"(},{"buffer":0,"byteOffset":)" << middle << R"(,"byteLength":)" << data.size() - middle << "}";
    accessors << comma << R"({"bufferView":)" << 2 * i << R"(,"componentType":5126,"type":"VEC3","count":)"
              << part.points.size() << R"(,"min":[)" << lower.x() << "," << lower.y() << "," << lower.z()
              << R"(],"max":[)" << upper.x() << "," << upper.y() << "," << upper.z() << R"(]},{"bufferView":)"
              << 2 * i + 1 << R"(,"componentType":5125,"type":"SCALAR","count":)" << 3 * part.triangles.size()
              << "}";
    meshes << comma << R"({"name":")" << part.name << R"(","primitives":[{"attributes":{"POSITION":)" << 2 * i
           << R"(},"indices":)" << 2 * i + 1 << "}]}";
    default_nodes << comma << R"({"name":")" << part.name << R"(","mesh":)" << i << "}";
    default_roots << comma << i;
  }
  std::ostringstream text;
  text << R"({"asset":{"version":"2.0","generator":")" << generator << R"("},"scene":0,"scenes":[{"nodes":[)"
       << (roots.empty() ? default_roots.str() : roots) << R"(]}],"nodes":[)"
       << (nodes.empty() ? default_nodes.str() : nodes) << R"(],"meshes":[)" << meshes.str()
       << R"(],"accessors":[)" << accessors.str() << R"(],"bufferViews":[)" << views.str()
       << R"(],"buffers":[{"byteLength":)" << data.size()
       << R"(,"uri":"data:application/octet-stream;base64,)" << base64(data) << "\"}]}";
  return text.str();
}

std::string dae_bytes(const SurfaceMesh& mesh, const std::string& asset)
{
  std::ostringstream geometries = text_stream(), nodes;
  for (const SurfacePart& part : mesh) {
    const std::string& id = part.name;
    geometries << "<geometry id=\"" << id << "-mesh\"><mesh><source id=\"" << id << "-p\"><float_array id=\""
               << id << "-a\" count=\"" << 3 * part.points.size() << "\">";
    for (const Vector3& p : part.points)
      geometries << p.transpose() << " ";
    geometries << "</float_array><technique_common><accessor source=\"#" << id << "-a\" count=\""
               << part.points.size()
               << "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
                  "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source><vertices id=\""
               << id << "-v\"><input semantic=\"POSITION\" source=\"#" << id
               << "-p\"/></vertices><triangles count=\"" << part.triangles.size()
               << "\"><input semantic=\"VERTEX\" source=\"#" << id << "-v\" offset=\"0\"/><p>";
    for (const auto& t : part.triangles)
      geometries << t[0] << " " << t[1] << " " << t[2] << " ";
    geometries << "</p></triangles></mesh></geometry>\n";
    nodes << "<node id=\"" << id << "\" name=\"" << id << "\"><instance_geometry url=\"#" << id
          << "-mesh\"/></node>";
  }
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<COLLADA "
         "xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\"><asset>" +
         asset + "</asset><library_geometries>" + geometries.str() +
         "</library_geometries><library_visual_scenes><visual_scene id=\"Scene\" name=\"Scene\">" +
         nodes.str() +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
         "url=\"#Scene\"/></scene></COLLADA>";
}

std::string mf3_bytes(const SurfaceMesh& mesh, const std::string& unit)
{
  std::ostringstream model = text_stream();
  model << R"(<?xml version="1.0" encoding="UTF-8"?><model )"
        << (unit.empty() ? "" : "unit=\"" + unit + "\" ")
        << R"(xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>)";
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    model << R"(<object id=")" << i + 1 << R"(" type="model" name=")" << mesh[i].name
          << R"("><mesh><vertices>)";
    for (const Vector3& p : mesh[i].points)
      model << R"(<vertex x=")" << p.x() << R"(" y=")" << p.y() << R"(" z=")" << p.z() << "\"/>";
    model << "</vertices><triangles>";
    for (const auto& t : mesh[i].triangles)
      model << R"(<triangle v1=")" << t[0] << R"(" v2=")" << t[1] << R"(" v3=")" << t[2] << "\"/>";
    model << "</triangles></mesh></object>";
  }
  model << "</resources><build>";
  for (std::size_t i = 0; i < mesh.size(); ++i)
    model << R"(<item objectid=")" << i + 1 << "\"/>";
  model << "</build></model>";
  const std::string relations =
      R"(<?xml version="1.0" encoding="UTF-8"?><Relationships )"
      R"(xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship )"
      R"(Target="/3D/3dmodel.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>)"
      R"(</Relationships>)";
  return zip({{"_rels/.rels", relations}, {"3D/3dmodel.model", model.str()}});
}

std::vector<SampleFile> sample_files(const SurfaceMesh& mesh)
{
  return {{"sample.obj", obj_bytes(mesh)},
          {"sample_o.obj", obj_bytes(mesh, 'o', true)},
          {"sample_text.stl", stl_text(mesh)},
          {"sample.stl", stl_bytes(mesh)},
          {"sample.ply", ply_bytes(mesh)},
          {"sample_little.ply", ply_bytes(mesh, PlyKind::little_endian)},
          {"sample_big.ply", ply_bytes(mesh, PlyKind::big_endian)},
          {"sample.off", off_bytes(mesh)},
          {"sample.gltf", gltf_bytes(mesh)},
          {"sample.dae", dae_bytes(mesh)},
          {"sample.3mf", mf3_bytes(mesh)}};
}

SurfaceMesh small_bird()
{
  const auto place = [](SurfacePart part, const char* name, const Vector3& middle) {
    part.name = name;
    for (Vector3& p : part.points)
      p += middle;
    return part;
  };
  return {place(make_box({0.40, 0.16, 0.14}), "torso", {0, 0, 0}),
          place(make_box({0.20, 0.06, 0.07}), "head", {0.29, 0, 0.03}),
          place(make_box({0.12, 0.20, 0.02}), "tail", {-0.25, 0, 0.02}),
          place(make_box({0.20, 0.68, 0.03}), "wing_left", {0.05, 0.41, 0.05}),
          place(make_box({0.20, 0.68, 0.03}), "wing_right", {0.05, -0.41, 0.05})};
}

} // namespace birdstrike::test
