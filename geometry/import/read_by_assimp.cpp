// SPDX-License-Identifier: GPL-3.0-or-later
// Polygon files into named triangles, by assimp.
#include "core/error.h"
#include "geometry/import/formats.h"
#include "geometry/write_surface.h"

#include <assimp/Importer.hpp>
#include <assimp/commonMetaData.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <unordered_map>

namespace birdstrike {

namespace {

constexpr unsigned steps = aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_SortByPType;

std::string file_text(const std::filesystem::path& file) { return "mesh file '" + file.string() + "'"; }

std::string lower_extension(const std::filesystem::path& file)
{
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

//! Whether write_surface() made the file: its first line says so, and nobody has saved it anew since.
bool says_our_axes(const std::filesystem::path& file)
{
  std::string start(160, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), std::streamsize(start.size()));
  return start.find(axes_line) != std::string::npos;
}

//! Names that assimp's readers invent for files without names look like <STL_BINARY> or are one of these.
std::string name_of(const aiString& text)
{
  const std::string name = text.C_Str();
  return name.empty() || name[0] == '<' || name == "defaultobject" || name == "ROOT" ? std::string() : name;
}

class Collector
{
public:
  //! An OBJ's meshes carry names of materials: only its nodes are objects. Solids of an STL are objects even
  //! without a name.
  Collector(const aiScene& scene, const std::filesystem::path& file, const std::string& extension)
      : scene_(scene), file_(file), nodes_only_(extension == ".obj"), nameless_apart_(extension == ".stl")
  {
  }

  void visit(const aiNode& node, const aiMatrix4x4& above)
  {
    const aiMatrix4x4 place = above * node.mTransformation;
    for (unsigned m = 0; m < node.mNumMeshes; ++m)
      add(*scene_.mMeshes[node.mMeshes[m]], node, place);
    for (unsigned c = 0; c < node.mNumChildren; ++c)
      visit(*node.mChildren[c], place);
  }
  RawScene result;

private:
  SurfacePart& part_named(const std::string& name)
  {
    if (name.empty() && nameless_apart_)
      return result.parts.emplace_back();
    const auto [at, is_new] = row_.try_emplace(name, result.parts.size());
    if (is_new)
      result.parts.push_back({name, {}, {}});
    return result.parts[at->second];
  }

  void add(const aiMesh& mesh, const aiNode& node, const aiMatrix4x4& place)
  {
    if (!(mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE))
      return;
    std::string name = name_of(node.mName);
    if (name.empty() && !nodes_only_)
      name = name_of(mesh.mName);
    SurfacePart& part = part_named(name);
    const std::string where = file_text(file_) + (name.empty() ? "" : ", part '" + name + "'");
    require(part.points.size() + mesh.mNumVertices <= 3 * largest_part &&
                part.triangles.size() + mesh.mNumFaces <= largest_part,
            where + " has more than 700 million triangles; export it coarser");
    const int first = int(part.points.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D p = place * mesh.mVertices[v];
      require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
              where + " has a coordinate that is not a finite number; export it again");
      part.points.emplace_back(p.x, p.y, p.z);
    }
    const bool mirrored = place.Determinant() < 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3)
        continue;
      for (int k = 0; k < 3; ++k)
        require(face.mIndices[k] < mesh.mNumVertices,
                where + " has a triangle with a corner that is not there; export it again");
      const int a = first + int(face.mIndices[0]), b = first + int(face.mIndices[1]),
                c = first + int(face.mIndices[2]);
      part.triangles.push_back(mirrored ? std::array{a, c, b} : std::array{a, b, c});
    }
  }

  const aiScene& scene_;
  const std::filesystem::path& file_;
  bool nodes_only_, nameless_apart_;
  std::unordered_map<std::string, std::size_t> row_;
};

//! assimp keeps single precision: 0.001 comes as 0.00100000005.
double six_digits(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::strtod(text, nullptr);
}

//! A binary STL that begins with the word "solid", or has bytes after its triangles, is text to assimp. What the
//! count of triangles asks for, if this is such a file, else nothing.
std::string misleading_binary_stl(const std::filesystem::path& file)
{
  constexpr std::size_t head = 84, facet = 50;
  std::ifstream stream(file, std::ios::binary);
  char start[head];
  if (!stream.read(start, head))
    return {};
  std::uint32_t count = 0;
  std::memcpy(&count, start + 80, 4); // little-endian, as this machine
  const std::size_t size = std::size_t(std::filesystem::file_size(file)), wanted = head + facet * count;
  const bool is_text =
      std::all_of(start, start + head, [](unsigned char c) { return std::isprint(c) || std::isspace(c); });
  if (count == 0 || size <= wanted || is_text)
    return {};
  std::string bytes(wanted, '\0');
  stream.seekg(0);
  stream.read(bytes.data(), std::streamsize(wanted));
  std::memset(bytes.data(), ' ', 5); // no "solid" at the start
  return stream ? bytes : std::string();
}

//! An OBJ in which a name has blanks, with "_" in their place: assimp would take the first word alone, so that "wing L" and
//! "wing R" became one. Several groups of one face become one name likewise. Empty if no name has any.
std::string obj_with_blank_names(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string text, line;
  bool any = false;
  while (std::getline(stream, line)) {
    if (line.starts_with("mtllib"))
      continue; // lies beside the file; nobody needs it
    if (line.starts_with("o ") || line.starts_with("g ")) {
      const auto from = line.find_first_not_of(" \t", 1), to = line.find_last_not_of(" \t\r");
      for (std::size_t i = from; from != std::string::npos && i < to; ++i)
        if (line[i] == ' ' || line[i] == '\t') {
          line[i] = '_';
          any = true;
        }
    }
    text += line + '\n';
  }
  return any ? text : std::string();
}

//! Without its last line the header of a PLY keeps assimp waiting for ever.
void require_whole_ply_header(const std::filesystem::path& file)
{
  constexpr std::size_t longest = 1 << 20;
  std::string start(longest, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), std::streamsize(longest));
  start.resize(std::size_t(stream.gcount()));
  require(start.rfind("ply", 0) == 0 && (start.find("\nend_header\n") != std::string::npos ||
                                         start.find("\rend_header\r") != std::string::npos ||
                                         start.find("\nend_header\r\n") != std::string::npos),
          file_text(file) +
              " cannot be read (its header has no end); it is cut short or damaged: export it again");
}

} // namespace

bool assimp_knows(const std::string& extension)
{
  return !extension.empty() && Assimp::Importer().IsExtensionSupported(extension);
}

RawScene read_by_assimp(const std::filesystem::path& file)
{
  const std::string extension = lower_extension(file);
  if (extension == ".ply")
    require_whole_ply_header(file);
  Assimp::Importer importer;
  const aiScene* scene = nullptr;
  std::string reason;
  try {
    const std::string bytes = extension == ".stl"   ? misleading_binary_stl(file)
                              : extension == ".obj" ? obj_with_blank_names(file)
                                                    : std::string();
    scene = bytes.empty()
                ? importer.ReadFile(file.string(), steps)
                : importer.ReadFileFromMemory(bytes.data(), bytes.size(), steps, extension.c_str() + 1);
    reason = importer.GetErrorString();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    reason = error.what();
  }
  if (reason.find("bad_alloc") != std::string::npos)
    throw std::bad_alloc();
  if (!scene || !scene->mRootNode)
    throw InputError(
        file_text(file) + " cannot be read (" + reason +
        "); it may be cut short, empty of faces, or not what its extension says: export it again");

  Collector collector(*scene, file, extension);
  RawScene& result = collector.result;
  aiMatrix4x4 above;
  if (extension == ".dae") { // the root turns to +y up and scales to metres: undo the latter
    result.unit = six_digits(std::cbrt(std::abs(scene->mRootNode->mTransformation.Determinant())));
    require(std::isfinite(result.unit) && result.unit > 0, file_text(file) + " has a length unit of zero");
    result.unit_source = "its header";
    result.up = std::string("+y");
    aiMatrix4x4::Scaling(aiVector3D(float(1 / result.unit)), above);
  } else if (extension == ".gltf" || extension == ".glb") {
    result.unit = 1;
    result.unit_source = "glTF";
    result.up = std::string("+y");
    aiString generator;
    if (scene->mMetaData && scene->mMetaData->Get(AI_METADATA_SOURCE_GENERATOR, generator))
      result.finished = std::string(generator.C_Str()).rfind("BirdStrike", 0) == 0;
    if (result.finished) { // undo what write_glb() does for viewers
      above = scene->mRootNode->mTransformation;
      above.Inverse();
      result.up = std::string("+z");
    }
  } else if (says_our_axes(file)) {
    result.unit = 1;
    result.unit_source = "its header";
    result.up = std::string("+z");
    result.finished = true;
  }
  collector.visit(*scene->mRootNode, above);
  return std::move(collector.result);
}

} // namespace birdstrike
