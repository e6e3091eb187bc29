// SPDX-License-Identifier: GPL-3.0-or-later
// 3MF into named triangles. assimp 5.2 reads the shapes of 3MF, but neither its unit nor its names.
// Source: 3MF Core Specification 1.3, chapters 3 and 4; Production Extension 1.1, chapter 2 (p:path).
#include "core/error.h"
#include "geometry/import/formats.h"

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <minizip/unzip.h>
#include <pugixml.hpp>
#include <sstream>

namespace birdstrike {

namespace {

constexpr std::size_t deepest = 64; // components in components

struct CloseZip
{
  void operator()(void* zip) const { unzClose(zip); }
};

class Package
{
public:
  explicit Package(const std::filesystem::path& file)
      : text_("mesh file '" + file.string() + "'"), stem_(file.stem().string()), zip_(unzOpen64(file.c_str()))
  {
    if (!zip_)
      fail("it is no zip archive");
  }

  RawScene read()
  {
    const std::string path = root_path();
    const pugi::xml_node model = this->model(path);
    const std::string unit = model.attribute("unit").as_string("millimeter");
    static const std::map<std::string, double> units{{"micron", 1e-6},     {"millimeter", 1e-3},
                                                     {"centimeter", 1e-2}, {"inch", 0.0254},
                                                     {"foot", 0.3048},     {"meter", 1}};
    const auto known = units.find(unit);
    if (known == units.end())
      fail("its unit '" + unit + "' is unknown");
    scene_.unit = known->second;
    scene_.unit_source = model.attribute("unit") ? "its header" : "3MF";
    for (const pugi::xml_node item : model.child("build").children("item"))
      add(item, path, Eigen::Affine3d::Identity(), "", 0);
    return std::move(scene_);
  }

private:
  [[noreturn]] void fail(const std::string& reason) const
  {
    throw InputError(text_ + " cannot be read (" + reason +
                     "); it may be cut short or not what its extension says: export it again");
  }

  std::string unpack(std::string path) const
  {
    if (!path.empty() && path[0] == '/')
      path.erase(0, 1);
    std::string bytes;
    if (unzLocateFile(zip_.get(), path.c_str(), 2) != UNZ_OK || unzOpenCurrentFile(zip_.get()) != UNZ_OK)
      fail("'" + path + "' is not in it");
    std::vector<char> block(1 << 16);
    int got = 0;
    while ((got = unzReadCurrentFile(zip_.get(), block.data(), unsigned(block.size()))) > 0)
      bytes.append(block.data(), std::size_t(got));
    if (unzCloseCurrentFile(zip_.get()) != UNZ_OK || got < 0)
      fail("'" + path + "' in it is damaged");
    return bytes;
  }

  void parse(const std::string& path, pugi::xml_document& document) const
  {
    const std::string bytes = unpack(path);
    const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
    if (!parsed)
      fail("'" + path + "' in it: " + parsed.description());
  }

  std::string root_path() const
  {
    pugi::xml_document relations;
    parse("_rels/.rels", relations);
    for (const pugi::xml_node one : relations.child("Relationships").children("Relationship"))
      if (std::string(one.attribute("Type").value()).ends_with("/3dmodel"))
        return one.attribute("Target").value();
    fail("it names no 3D model");
  }

  pugi::xml_node model(const std::string& path)
  {
    const auto [at, is_new] = models_.try_emplace(path);
    if (is_new)
      parse(path, at->second);
    const pugi::xml_node model = at->second.child("model");
    if (!model)
      fail("'" + path + "' in it holds no model");
    return model;
  }

  //! "m00 m01 m02 m10 ... m32", which act on row vectors.
  Eigen::Affine3d transform(const pugi::xml_node& node) const
  {
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    if (const pugi::xml_attribute given = node.attribute("transform")) {
      std::istringstream text(given.value());
      for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 3; ++column)
          text >> place.matrix()(column, row);
      if (!text)
        fail("a transform has fewer than twelve numbers");
    }
    return place;
  }

  //! What an <item> or a <component> refers to.
  void add(const pugi::xml_node& reference, std::string path, const Eigen::Affine3d& above,
           const std::string& name_above, std::size_t depth)
  {
    if (depth > deepest)
      fail("its components hold each other");
    if (const pugi::xml_attribute other = reference.attribute("p:path"))
      path = other.value();
    const Eigen::Affine3d place = above * transform(reference);
    const std::string id = reference.attribute("objectid").value();
    const pugi::xml_node object =
        model(path).child("resources").find_child_by_attribute("object", "id", id.c_str());
    if (!object)
      fail("object " + id + " is not in it");
    if (const std::string type = object.attribute("type").as_string("model");
        type != "model" && type != "solidsupport")
      return;
    const std::string own = object.attribute("name").value(), name = own.empty() ? name_above : own;
    if (const pugi::xml_node mesh = object.child("mesh"))
      add_mesh(mesh, place, name);
    for (const pugi::xml_node component : object.child("components").children("component"))
      add(component, path, place, name, depth + 1);
  }

  double number(const pugi::xml_node& node, const char* name) const
  {
    const double value = node.attribute(name).as_double(NAN);
    if (!std::isfinite(value))
      fail("a vertex has no finite coordinate " + std::string(name));
    return value;
  }

  void add_mesh(const pugi::xml_node& mesh, const Eigen::Affine3d& place, const std::string& name)
  {
    const auto [at, is_new] = row_.try_emplace(name, scene_.parts.size());
    if (is_new)
      scene_.parts.push_back({name, {}, {}});
    SurfacePart& part = scene_.parts[at->second];
    const std::size_t first = part.points.size();
    for (const pugi::xml_node v : mesh.child("vertices").children("vertex"))
      part.points.push_back(place * Vector3(number(v, "x"), number(v, "y"), number(v, "z")));
    const std::size_t count = part.points.size() - first;
    const bool mirrored = place.linear().determinant() < 0;
    for (const pugi::xml_node t : mesh.child("triangles").children("triangle")) {
      std::array<int, 3> corners{};
      const char* names[] = {"v1", "v2", "v3"};
      for (int k = 0; k < 3; ++k) {
        const long long corner = t.attribute(names[k]).as_llong(-1);
        if (corner < 0 || std::size_t(corner) >= count || part.points.size() > 3 * largest_part)
          fail("a triangle has a corner that is not there");
        corners[k] = int(first + std::size_t(corner));
      }
      if (mirrored)
        std::swap(corners[1], corners[2]);
      part.triangles.push_back(corners);
    }
  }

  std::string text_, stem_;
  std::unique_ptr<void, CloseZip> zip_;
  std::map<std::string, pugi::xml_document> models_;
  std::map<std::string, std::size_t> row_;
  RawScene scene_;
};

} // namespace

RawScene read_3mf(const std::filesystem::path& file) { return Package(file).read(); }

} // namespace birdstrike
