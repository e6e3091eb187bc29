// SPDX-License-Identifier: GPL-3.0-or-later
// CAD and polygon files into named surfaces, through assimp.
#include "geometry/import/read_mesh.h"

#include "core/error.h"
#include "geometry/import/weld.h"
#include "geometry/measure.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace birdstrike {

namespace {

// assimp keeps coordinates in single precision: about 6e-8 of the size. Corners closer than this share of the
// whole mesh's diagonal are the same.
constexpr double weld_share = 1e-6;

constexpr const char* known_formats = "OBJ, glTF/GLB, STL, PLY, OFF, COLLADA (.dae), 3MF, X3D, 3DS and FBX";

std::string lower_extension(const std::filesystem::path& file)
{
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

void require_readable(const std::filesystem::path& file)
{
  const std::string name = "mesh file '" + file.string() + "'";
  std::error_code error;
  require(std::filesystem::exists(file, error), name + " does not exist; check the path");
  require(std::filesystem::is_regular_file(file, error), name + " is not a file");
  require(std::filesystem::file_size(file, error) > 0 && !error, name + " is empty");
  const std::string extension = lower_extension(file);
  for (const char* cad : {".step", ".stp", ".iges", ".igs", ".brep", ".x_t", ".catpart", ".sldprt"})
    require(extension != cad,
            name + " holds curved CAD faces, which cannot be read; export STL, OBJ or glTF");
  require(!extension.empty() && Assimp::Importer().IsExtensionSupported(extension),
          name + " has the unknown format '" + extension + "'; known are " + known_formats);
}

//! Names that assimp's readers invent for files without names look like <STL_BINARY>.
bool is_name(const aiString& text) { return text.length > 0 && text.C_Str()[0] != '<'; }

class Collector
{
public:
  Collector(const aiScene& scene, const std::filesystem::path& file, double unit)
      : scene_(scene), file_(file), unit_(unit)
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
  SurfaceMesh parts;

private:
  SurfacePart& part_named(const std::string& name)
  {
    const auto at = std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.name == name; });
    return at != parts.end() ? *at : parts.emplace_back(SurfacePart{name, {}, {}});
  }

  void add(const aiMesh& mesh, const aiNode& node, const aiMatrix4x4& place)
  {
    if (!(mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE))
      return;
    SurfacePart& part = part_named(is_name(node.mName)   ? node.mName.C_Str()
                                   : is_name(mesh.mName) ? mesh.mName.C_Str()
                                                         : file_.stem().string());
    const int first = int(part.points.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D p = place * mesh.mVertices[v];
      require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
              "mesh file '" + file_.string() + "', part '" + part.name +
                  "' has a coordinate that is not a finite number; export it again");
      part.points.push_back(unit_ * Vector3(p.x, p.y, p.z));
    }
    const bool mirrored = place.Determinant() < 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3)
        continue;
      const int a = first + int(face.mIndices[0]), b = first + int(face.mIndices[1]),
                c = first + int(face.mIndices[2]);
      part.triangles.push_back(mirrored ? std::array{a, c, b} : std::array{a, b, c});
    }
  }

  const aiScene& scene_;
  const std::filesystem::path& file_;
  double unit_;
};

} // namespace

SurfaceMesh read_mesh(const std::filesystem::path& file, double unit)
{
  require(std::isfinite(unit) && unit > 0,
          "the length unit of mesh file '" + file.string() + "' must be positive");
  require_readable(file);

  Assimp::Importer importer;
  const aiScene* scene = nullptr;
  std::string reason;
  try {
    scene = importer.ReadFile(file.string(), aiProcess_ValidateDataStructure | aiProcess_Triangulate |
                                                 aiProcess_SortByPType);
    reason = importer.GetErrorString();
  } catch (const std::exception& error) {
    reason = error.what();
  }
  if (!scene || !scene->mRootNode)
    throw InputError(
        "mesh file '" + file.string() + "' cannot be read (" + reason +
        "); it may be cut short, empty of faces, or not what its extension says: export it again");

  Collector collector(*scene, file, unit);
  collector.visit(*scene->mRootNode, aiMatrix4x4());
  SurfaceMesh parts = std::move(collector.parts);
  const double tolerance = weld_share * bounding_box(parts).diagonal();
  for (SurfacePart& part : parts)
    weld(part, tolerance);
  std::erase_if(parts, [](const SurfacePart& part) { return part.triangles.empty(); });
  require(!parts.empty(),
          "mesh file '" + file.string() + "' holds no triangles; export the surface of each part");
  return parts;
}

} // namespace birdstrike
