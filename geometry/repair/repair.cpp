// SPDX-License-Identifier: GPL-3.0-or-later
// The ladder of the repair, for every part.
#include "geometry/repair/repair.h"

#include "core/error.h"
#include "geometry/half_edges.h"
#include "geometry/measure.h"
#include "geometry/repair/ladder.h"

#include <cmath>

namespace birdstrike {

namespace {

std::string list(const std::vector<std::string>& texts)
{
  std::string text;
  for (const std::string& t : texts)
    text += (text.empty() ? "" : ", ") + t;
  return text;
}

// With --strict: what would have been done, found by doing it.
std::string without_strict(const SurfacePart& part, const SurfaceReport& report, const RepairSizes& sizes)
{
  try {
    const PartRepair done = climb_ladder(part, report, sizes).report;
    if (done.actions.empty())
      return "without --strict it would be taken as it is" +
             (done.notes.empty() ? std::string() : " (" + list(done.notes) + ")");
    return "without --strict this would be done: " + list(done.actions);
  } catch (const InputError& error) {
    return std::string("without --strict it could not be repaired either: ") + error.what();
  }
}

} // namespace

RepairedMesh repair(const SurfaceMesh& mesh, const RepairOptions& options, const std::filesystem::path& file)
{
  const std::string name = "mesh '" + file.string() + "'";
  require(!mesh.empty(), name + " holds no part to fill");
  require(options.spacing >= 0 && options.thickness >= 0 &&
              std::isfinite(options.spacing + options.thickness),
          name + ": spacing and thickness of the repair must not be negative");
  double area = 0;
  for (const SurfacePart& part : mesh) {
    sorted_half_edges(part); // refuses triangles without points
    area += surface_area(part);
  }
  RepairSizes sizes;
  sizes.spacing = options.spacing > 0 ? options.spacing : std::sqrt(area) / 80;
  sizes.thickness = options.thickness > 0 ? options.thickness : 2 * sizes.spacing;

  RepairedMesh repaired;
  for (const SurfacePart& part : mesh) {
    const std::string where = name + ", part '" + part.name + "': ";
    for (const Vector3& p : part.points)
      require(p.allFinite(), where + "a coordinate is not a finite number; export it again");
    const SurfaceReport report = check_surface(part);
    const std::string what = first_fault(report);
    if (what.empty()) {
      repaired.parts.push_back(part);
      repaired.reports.push_back({report, report, {}, {}, 0, 0});
      continue;
    }
    require(report.triangles > 0, where + what);
    require(!options.strict,
            where + what + "; " + (options.strict ? without_strict(part, report, sizes) : ""));
    try {
      LadderResult result = climb_ladder(part, report, sizes);
      repaired.parts.push_back(std::move(result.part));
      repaired.reports.push_back(std::move(result.report));
    } catch (const InputError& error) {
      throw InputError(where + what + ". This could not be repaired: " + error.what());
    }
  }
  return repaired;
}

} // namespace birdstrike
