// SPDX-License-Identifier: GPL-3.0-or-later
// A run's series as data for the turning view of a report.
#include "cases/report_view.h"

#include "cases/report_tracks.h"
#include "core/error.h"
#include "vtkio/palette.h"
#include "vtkio/series_reader.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vtkFieldData.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace birdstrike {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array bird_fields{
    TrackedField{"pressure", "Pressure", "MPa", 1e-6},
    TrackedField{"mean_pressure", "Mean pressure of neighbours", "MPa", 1e-6},
    TrackedField{"velocity", "Speed", "m/s", 1},
};
constexpr std::array target_fields{
    TrackedField{"contact_pressure", "Contact pressure", "MPa", 1e-6},
    TrackedField{"peak_contact_pressure", "Largest contact pressure so far", "MPa", 1e-6},
    TrackedField{"displacement", "Displacement", "mm", 1e3},
    TrackedField{"von_mises", "Von Mises stress", "MPa", 1e-6},
    TrackedField{"plastic_strain", "Plastic strain", "%", 100},
    TrackedField{"damage", "Damage", "1", 1},
};

std::string hex(const Colour& colour)
{
  const auto byte = [](double part) { return static_cast<int>(std::lround(255 * part)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour[0]), byte(colour[1]), byte(colour[2]));
}

//! Parts of the bird and which one each shown particle belongs to.
void add_parts(Json& json, vtkUnstructuredGrid& bird, const std::vector<std::size_t>& shown)
{
  vtkDataArray* part = bird.GetPointData()->GetArray("part");
  auto* names = vtkStringArray::SafeDownCast(bird.GetFieldData()->GetAbstractArray("part_names"));
  std::vector<std::uint8_t> numbers(shown.size(), 0);
  std::size_t count = 1;
  for (std::size_t i = 0; part && i < shown.size(); ++i) {
    numbers[i] =
        static_cast<std::uint8_t>(std::clamp(part->GetTuple1(static_cast<vtkIdType>(shown[i])), 0.0, 255.0));
    count = std::max<std::size_t>(count, numbers[i] + 1U);
  }
  json["parts"] = Json::array();
  for (std::size_t k = 0; k < count; ++k) {
    const bool named = names && static_cast<vtkIdType>(k) < names->GetNumberOfValues();
    const std::string name =
        named ? names->GetValue(static_cast<vtkIdType>(k)) : fmt::format("part {}", k + 1);
    json["parts"].push_back({{"name", name}, {"colour", hex(part_colour(name, k))}});
  }
  json["part"] = packed(std::span<const std::uint8_t>(numbers), 0);
}

double spacing_of(vtkUnstructuredGrid& bird)
{
  vtkDataArray* spacing = bird.GetFieldData()->GetArray("spacing");
  if (spacing && spacing->GetNumberOfTuples() == 1 && spacing->GetTuple1(0) > 0)
    return spacing->GetTuple1(0);
  return 0.01 * bird.GetLength(); // a series of somebody else
}

//! The faces of the target: the number of corners and the corners of each.
std::string faces_of(vtkUnstructuredGrid& target)
{
  std::vector<std::uint32_t> faces;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < target.GetNumberOfCells(); ++cell) {
    target.GetCellPoints(cell, corners);
    faces.push_back(static_cast<std::uint32_t>(corners->GetNumberOfIds()));
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
      faces.push_back(static_cast<std::uint32_t>(corners->GetId(k)));
  }
  return packed(std::span<const std::uint32_t>(faces), 0);
}

Json colour_map()
{
  const auto map = make_colour_map(0, 1);
  Json colours = Json::array();
  for (int i = 0; i < map->GetNumberOfTableValues(); ++i) {
    const double* c = map->GetTableValue(i);
    colours.push_back(hex({c[0], c[1], c[2]}));
  }
  return colours;
}

//! A text inside <script> may hold neither "</script" nor "<!--".
std::string fit_for_script(std::string text)
{
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
    text.replace(at, 1, "\\u003c");
  return text;
}

} // namespace

std::vector<std::size_t> evenly(std::size_t all, std::size_t shown)
{
  std::vector<std::size_t> numbers;
  shown = std::min(all, std::max<std::size_t>(shown, 1));
  for (std::size_t k = 0; k < shown; ++k)
    numbers.push_back(shown == 1 ? 0 : (k * (all - 1) + (shown - 1) / 2) / (shown - 1));
  return numbers;
}

ReportView make_report_view(const std::filesystem::path& pvd, const ViewOptions& options)
{
  ReportView view;
  SeriesIndex index;
  try {
    index = read_series_index(pvd);
  } catch (const InputError& error) {
    view.gaps.emplace_back(error.what());
    return view;
  }
  view.all_frames = static_cast<int>(index.steps.size());
  if (!index.warning.empty())
    view.gaps.push_back(index.warning + ".");

  std::vector<std::size_t> shown;
  std::unique_ptr<Tracks> bird, target;
  Json json{{"times", Json::array()}};
  bool late_target = false;
  for (const std::size_t step :
       evenly(index.steps.size(), static_cast<std::size_t>(std::max(options.frames, 2))))
  {
    try {
      const Frame frame = read_frame(index, step);
      require(frame.bird != nullptr, fmt::format("{}: frame {} has no bird", pvd.string(), step));
      if (!bird) {
        view.all_particles = frame.bird->GetNumberOfPoints();
        shown = evenly(static_cast<std::size_t>(view.all_particles),
                       static_cast<std::size_t>(std::max(options.particles, 1)));
        view.particles = static_cast<long>(shown.size());
        bird = std::make_unique<Tracks>(*frame.bird, shown, bird_fields);
        json["bird"] = {
            {"count", shown.size()},
            {"spacing", spacing_of(*frame.bird) *
                            std::cbrt(static_cast<double>(view.all_particles) /
                                      static_cast<double>(std::max<std::size_t>(shown.size(), 1)))}};
        add_parts(json["bird"], *frame.bird, shown);
        if (frame.target) {
          target = std::make_unique<Tracks>(
              *frame.target, evenly(static_cast<std::size_t>(frame.target->GetNumberOfPoints()), SIZE_MAX),
              target_fields);
          json["target"] = {{"count", frame.target->GetNumberOfPoints()}, {"faces", faces_of(*frame.target)}};
        }
      }
      bird->check(*frame.bird);
      if (target) {
        require(frame.target != nullptr, fmt::format("{}: frame {} has no target", pvd.string(), step));
        target->check(*frame.target);
        target->append(*frame.target);
      } else if (frame.target) {
        late_target = true;
      }
      bird->append(*frame.bird);
      json["times"].push_back(frame.time);
    } catch (const InputError& error) {
      view.gaps.push_back(fmt::format("Frame {} is left out: {}", step, error.what()));
    }
  }
  if (late_target)
    view.gaps.emplace_back("The target is in later frames but not in the first: the view does not show it.");
  view.frames = static_cast<int>(json["times"].size());
  view.target = target != nullptr;
  if (view.frames == 0)
    return view;
  bird->add_to(json["bird"]);
  if (target)
    target->add_to(json["target"]);
  json["colours"] = colour_map();
  view.data = fit_for_script(json.dump(-1, ' ', false, Json::error_handler_t::replace));
  return view;
}

} // namespace birdstrike
