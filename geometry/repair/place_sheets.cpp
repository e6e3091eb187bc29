// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets beside closed shells: which are dropped, which become solids.
#include "geometry/repair/place_sheets.h"

#include "geometry/half_edges.h"
#include "geometry/join_points.h"
#include "geometry/measure.h"
#include "geometry/repair/describe.h"
#include "geometry/repair/nearest.h"
#include "geometry/repair/sheets.h"
#include "geometry/repair/wrap.h"
#include "geometry/self_intersections.h"
#include "geometry/topology.h"
#include "geometry/winding.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

namespace {

constexpr std::size_t most_probes = 32, most_sheets_compared = 40;
constexpr double most_stray_area = 0.05; // of the part's area, all strays together

Vector3 middle(const SurfacePart& part, const std::array<int, 3>& t)
{
  return (part.points[t[0]] + part.points[t[1]] + part.points[t[2]]) / 3;
}

// Do all of a sheet's triangles (of some of many) pass the test?
template <class Test>
bool all_of_sheet(const SurfacePart& sheet, Test test)
{
  const std::size_t step = 1 + sheet.triangles.size() / most_probes;
  for (std::size_t i = 0; i < sheet.triangles.size(); i += step)
    if (!test(middle(sheet, sheet.triangles[i])))
      return false;
  return true;
}

bool is_small(const SurfacePart& sheet, double total_area)
{
  const double share = surface_area(sheet) / total_area;
  return share < 1e-3 || (sheet.triangles.size() <= 2 && share < 0.02);
}

// Share of the border's length that lies within `reach` of another sheet.
double shared_border(const std::vector<SurfacePart>& sheets, double reach)
{
  std::vector<std::unique_ptr<Nearest>> nearest;
  for (const SurfacePart& sheet : sheets)
    nearest.push_back(std::make_unique<Nearest>(sheet));
  double near = 0, total = 0;
  for (std::size_t s = 0; s < sheets.size(); ++s)
    visit_edges(sorted_half_edges(sheets[s]), [&](std::span<const HalfEdge> edge) {
      if (edge.size() != 1)
        return;
      const Vector3 &p = sheets[s].points[edge[0].low], &q = sheets[s].points[edge[0].high], m = (p + q) / 2;
      total += (p - q).norm();
      for (std::size_t other = 0; other < sheets.size(); ++other)
        if (other != s && nearest[other]->distance(m) < reach) {
          near += (p - q).norm();
          break;
        }
    });
  return total > 0 ? near / total : 1; // without any border: one-sided
}

bool seem_to_surround(const std::vector<SurfacePart>& sheets, const RepairSizes& sizes)
{
  if (sheets.size() > most_sheets_compared)
    return true;
  double area = 0;
  for (const SurfacePart& sheet : sheets)
    area += surface_area(sheet);
  return shared_border(sheets, std::max(2 * sizes.spacing, 0.05 * std::sqrt(area))) > 0.5;
}

} // namespace

void append(SurfacePart& part, const SurfacePart& other)
{
  const int first = int(part.points.size());
  part.points.insert(part.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles)
    part.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

std::optional<Wrapped> wrap_as_solid(const SurfacePart& soup, const RepairSizes& sizes)
{
  const double diagonal = bounding_box(soup).diagonal(), area = surface_area(soup);
  for (double alpha = std::max(2 * sizes.spacing, finest_wrap * diagonal); alpha <= 0.25 * diagonal;
       alpha *= 2) {
    const double offset = alpha / 20;
    Wrapped wrapped{alpha_wrap(soup, alpha, offset), alpha, offset};
    if (signed_volume(wrapped.skin) > 2 * 2 * offset * area) {
      shrink_onto(wrapped.skin, soup, offset);
      return wrapped;
    }
  }
  return {};
}

Wrapped wrap_as_sheet(const SurfacePart& soup, const RepairSizes& sizes)
{
  const double wanted = sizes.thickness, finest = finest_wrap * bounding_box(soup).diagonal();
  const double alpha = std::max(wanted, finest), offset = sizes.thickness / 2;
  return {alpha_wrap(soup, alpha, offset), alpha, offset, wanted < finest ? wanted : 0};
}

std::string describe(const Wrapped& wrapped)
{
  return "alpha " + length_text(wrapped.alpha) + ", offset " + length_text(wrapped.offset) +
         (wrapped.refused > 0 ? "; alpha " + length_text(wrapped.refused) + " would take too long" : "");
}

SheetWork place_sheets(std::vector<SurfacePart> sheets, const SurfacePart& body, double total_area,
                       const RepairSizes& sizes)
{
  SheetWork work;
  if (!body.triangles.empty()) {
    const Nearest nearest(body);
    const double touching = 10 * coincidence_tolerance(body);
    const auto drop = [&](auto test, const std::string& one, const std::string& many) {
      if (const std::size_t dropped = std::erase_if(sheets, test); dropped > 0)
        work.actions.push_back("dropped " + count_text(dropped, one, many));
    };
    drop(
        [&](const SurfacePart& sheet) {
          return all_of_sheet(sheet, [&](const Vector3& p) { return nearest.distance(p) < touching; });
        },
        "piece that lies on the surface", "pieces that lie on the surface");
    drop(
        [&](const SurfacePart& sheet) {
          return all_of_sheet(sheet, [&](const Vector3& p) { return winding_number(body, p) > 0.5; });
        },
        "inner wall", "inner walls");
  }
  // Strays are small, and together still little: a wing of a thousand loose feathers is no heap of strays.
  double small_area = 0;
  for (const SurfacePart& sheet : sheets)
    small_area += is_small(sheet, total_area) ? surface_area(sheet) : 0;
  std::size_t triangles = 0, strays = 0;
  if (small_area < most_stray_area * total_area)
    strays = std::erase_if(sheets, [&](const SurfacePart& sheet) {
      const bool stray = is_small(sheet, total_area);
      triangles += stray ? sheet.triangles.size() : 0;
      return stray;
    });
  if (strays > 0)
    work.actions.push_back("dropped " + count_text(strays, "stray piece", "stray pieces") + " (" +
                           count_text(triangles, "triangle", "triangles") + ")");
  work.used.name = body.name;
  for (const SurfacePart& sheet : sheets)
    append(work.used, sheet);

  const bool bordered = sheets.size() != 1 || find_topology(sheets.front()).open_edges > 0;
  if (sheets.size() > 1 ? seem_to_surround(sheets, sizes) : !bordered)
    if (auto wrapped = wrap_as_solid(work.used, sizes)) {
      work.actions.push_back("wrapped " + count_text(sheets.size(), "piece", "pieces") + " as one body (" +
                             describe(*wrapped) + ")");
      work.solids.push_back(std::move(wrapped->skin));
      return work;
    }

  std::size_t by_wrap = 0;
  for (const SurfacePart& sheet : sheets) {
    SurfacePart solid = thicken(sheet, sizes.thickness);
    const bool sound = find_topology(sheet).open_edges > 0 && encloses_volume(solid) &&
                       count_self_intersections(solid, 1).pairs == 0;
    if (!sound) {
      solid = wrap_as_sheet(sheet, sizes).skin;
      ++by_wrap;
    }
    work.solids.push_back(std::move(solid));
  }
  if (!sheets.empty())
    work.actions.push_back("thickened " + count_text(sheets.size(), "sheet", "sheets") + " to " +
                           length_text(sizes.thickness) +
                           (by_wrap > 0 ? " (" + std::to_string(by_wrap) + " by wrapping)" : ""));
  return work;
}

} // namespace birdstrike
