// SPDX-License-Identifier: GPL-3.0-or-later
// Any mesh of a bird, in metres, nose first, in the middle.
#include "geometry/import/import_mesh.h"

#include "core/error.h"
#include "geometry/import/find_axes.h"
#include "geometry/import/guess_unit.h"
#include "geometry/import/mend_units.h"
#include "geometry/import/number_text.h"
#include "geometry/import/raw_scene.h"
#include "geometry/import/weld.h"
#include "geometry/measure.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace birdstrike {

namespace {

using Path = std::filesystem::path;

std::string list(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
    text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

//! Parts of several files under names that differ: a name that two files use tells nothing, the files' names do.
RawScene join(std::vector<RawScene> scenes, const std::vector<Path>& files)
{
  std::map<std::string, int> uses;
  for (const RawScene& scene : scenes)
    for (const SurfacePart& part : scene.parts)
      ++uses[part.name];
  RawScene all = scenes.front();
  all.parts.clear();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const std::string where = "mesh file '" + files[i].string() + "'";
    require(scenes[i].unit == all.unit,
            where + " has another length unit than '" + files[0].string() +
                "', or one of them has none; give the unit, or export both alike");
    require(scenes[i].up == all.up, where + " has other axes than '" + files[0].string() +
                                        "' by its format; export both in one format");
    all.finished = all.finished && scenes[i].finished;
    for (SurfacePart& part : scenes[i].parts) {
      if (uses[part.name] > 1) {
        const std::string stem = files[i].stem().string();
        part.name = scenes[i].parts.size() == 1 ? stem : stem + "_" + part.name;
      }
      const bool taken = std::any_of(all.parts.begin(), all.parts.end(),
                                     [&](const SurfacePart& other) { return other.name == part.name; });
      require(!taken, where + " holds part '" + part.name +
                          "', as a file before it does; name the files differently");
      all.parts.push_back(std::move(part));
    }
  }
  return all;
}

RawScene read_all(const std::vector<Path>& files, double unit)
{
  require(!files.empty(), "no mesh file is given");
  std::vector<RawScene> scenes;
  for (const Path& file : files) {
    scenes.push_back(read_scene(file));
    if (unit > 0) {
      scenes.back().unit = unit;
      scenes.back().unit_source.clear();
    }
  }
  return scenes.size() == 1 ? std::move(scenes.front()) : join(std::move(scenes), files);
}

class Import
{
public:
  Import(const std::vector<Path>& files, const ImportOptions& options)
      : options_(options), subject_("mesh '" + (files.empty() ? Path() : files.front()).string() + "'")
  {
    require(std::isfinite(options.unit) && options.unit >= 0,
            subject_ + ": its length unit must be positive, or 0 for a unit to be found");
    require(std::isfinite(options.mass) && options.mass >= 0,
            subject_ + ": the mass of the bird must not be negative");
    scene_ = read_all(files, options.unit);
  }

  ImportedMesh run()
  {
    mend();
    find_unit();
    for (SurfacePart& part : scene_.parts)
      for (Vector3& p : part.points)
        p *= result_.unit;
    weld_parts(scene_.parts);
    require(!scene_.parts.empty(), subject_ + " holds no triangles; export the surface of each part");
    const bool as_it_is = scene_.finished && options_.nose.empty() && options_.up.empty();
    if (as_it_is)
      note("written by BirdStrike: its axes and its place are kept");
    else {
      turn();
      if (options_.recentre)
        recentre();
    }
    result_.parts = std::move(scene_.parts);
    return std::move(result_);
  }

private:
  void note(const std::string& text) { result_.notes.push_back(subject_ + ": " + text); }
  void warn(const std::string& text) { result_.warnings.push_back(subject_ + ": " + text); }

  void mend()
  {
    if (scene_.finished)
      return;
    SurfaceMesh before = options_.strict ? scene_.parts : SurfaceMesh();
    const UnitMends mends = mend_units(scene_.parts, subject_);
    for (const UnitMend& mend : mends.done) {
      const bool larger = mend.factor > 1;
      const std::string times = number_text(larger ? mend.factor : 1 / mend.factor);
      const std::string finding = list(mend.objects) + " " + (larger ? "small" : "large") + " by " + times +
                                  " beside the other objects: two units in one scene";
      require(!options_.strict, subject_ + ": " + finding + "; export all objects in one unit");
      note(finding + "; scaled by " + number_text(mend.factor) + " about the origin");
      mended_ = mend.factor;
    }
    if (!mends.strays.empty())
      warn(list(mends.strays) + " lies apart from the other objects; remove it if it is no part of the bird");
  }

  double volume() const
  {
    double sum = 0;
    for (const SurfacePart& part : scene_.parts)
      sum += std::abs(signed_volume(part));
    return sum;
  }

  void find_unit()
  {
    const Box box = bounding_box(scene_.parts);
    const double extent = (box.upper - box.lower).maxCoeff();
    if (scene_.unit == 0) {
      const UnitGuess guess = guess_unit(subject_, extent, options_.mass > 0 ? volume() : 0, options_.mass);
      result_.unit = guess.unit;
      result_.unit_guessed = true;
      note("no length unit, " + guess.reason);
      if (guess.doubtful)
        warn("the mean density that mass and volume give is not a bird's; check the unit (" +
             unit_name(guess.unit) + ") and the mass");
      return;
    }
    result_.unit = scene_.unit;
    const auto is_bird = [&](double unit) {
      return extent * unit >= smallest_span && extent * unit <= largest_span;
    };
    // Of two units in one scene, the one that makes a bird under the unit which the file states is the right one.
    if (mended_ != 1 && !is_bird(result_.unit) && is_bird(result_.unit / mended_)) {
      note("all objects scaled by " + number_text(1 / mended_) +
           ": that makes the whole a bird in the unit " + unit_name(result_.unit));
      result_.unit /= mended_;
    }
    if (!is_bird(result_.unit) && !scene_.finished)
      warn("in the unit " + unit_name(result_.unit) +
           (scene_.unit_source.empty() ? " that is given" : " that " + scene_.unit_source + " says") +
           " it is " + number_text(extent * result_.unit) +
           " m wide; birds span 0.2 m to 3.6 m; give the unit if this is wrong");
    if (!scene_.unit_source.empty() && !scene_.finished)
      note("unit " + unit_name(result_.unit) + ", as " + scene_.unit_source + " says");
  }

  void turn()
  {
    FoundAxes axes = find_axes(scene_.parts, {options_.nose, options_.up, scene_.up});
    for (std::string& text : axes.notes)
      note(text);
    for (std::string& text : axes.warnings)
      warn(text);
    if (axes.turn == Eigen::Matrix3d::Identity())
      return;
    for (SurfacePart& part : scene_.parts)
      for (Vector3& p : part.points)
        p = axes.turn * p;
  }

  void recentre()
  {
    const Box box = bounding_box(scene_.parts);
    const Vector3 middle = box.centre();
    if (middle.norm() <= 1e-9 * box.diagonal())
      return;
    for (SurfacePart& part : scene_.parts)
      for (Vector3& p : part.points)
        p -= middle;
    note("moved by (" + number_text(-middle.x()) + ", " + number_text(-middle.y()) + ", " +
         number_text(-middle.z()) + ") m so that its box is about the origin");
  }

  ImportOptions options_;
  std::string subject_;
  RawScene scene_;
  ImportedMesh result_;
  double mended_ = 1;
};

} // namespace

ImportedMesh import_mesh(const std::vector<std::filesystem::path>& files, const ImportOptions& options)
{
  return Import(files, options).run();
}

} // namespace birdstrike
