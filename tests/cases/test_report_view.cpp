// SPDX-License-Identifier: GPL-3.0-or-later
// The data of a report's view against the frames that they come from.
#include "cases/report_view.h"
#include "scratch.h"
#include "vtkio/quantise.h"
#include "vtkio/series_reader.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <vtkBase64Utilities.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkZLibDataCompressor.h>

#include <cmath>

using namespace birdstrike;

namespace {

//! What share/report/src/decode.js does.
template <class Whole>
std::vector<Whole> unpacked(const std::string& text, std::size_t count, std::size_t row)
{
  std::vector<unsigned char> small(text.size());
  const std::size_t length = vtkBase64Utilities::DecodeSafely(
      reinterpret_cast<const unsigned char*>(text.data()), text.size(), small.data(), small.size());
  std::vector<unsigned char> bytes(count * sizeof(Whole));
  vtkNew<vtkZLibDataCompressor> zlib;
  REQUIRE(zlib->Uncompress(small.data(), length, bytes.data(), bytes.size()) == bytes.size());
  std::vector<Whole> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t b = 0; b < sizeof(Whole); ++b)
      numbers[i] = static_cast<Whole>(numbers[i] | bytes[b * count + i] << 8 * b);
    if (row > 0 && i >= row)
      numbers[i] = static_cast<Whole>(numbers[i] + numbers[i - row]);
  }
  return numbers;
}

const char* const sheet_case = R"(title = "sheet"
[bird]
shape = "capsule"
mass = "0.05 kg"
spacing = "8 mm"
velocity = "250 m/s"
[bird.parts]
body = { porosity = 0.4 }
[target]
rigid = false
plate = { size = ["0.3 m", "0.3 m"], thickness = "0.5 mm", elements = [10, 10] }
material = "al-2024-t3"
[run]
end = "0.5 ms"
frames = 9
)";

//! A run of a second that the tests of this file share.
const fs::path& sheet_run()
{
  static const scratch::Folder folder;
  static const fs::path run = [] {
    folder.write("sheet.toml", sheet_case);
    const scratch::Outcome outcome =
        scratch::program(folder.path, "run sheet.toml -o out --quiet --no-figures --threads 1");
    INFO(outcome.output);
    REQUIRE(outcome.status == 0);
    return folder.path / "out";
  }();
  return run;
}

//! Eroded cells, or points that only they have.
std::vector<bool> rows_gone(vtkUnstructuredGrid& grid, bool of_cells)
{
  vtkDataArray* eroded = grid.GetCellData()->GetArray("eroded");
  std::vector<bool> cells, points(static_cast<std::size_t>(grid.GetNumberOfPoints()), eroded != nullptr);
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell) {
    cells.push_back(eroded && eroded->GetComponent(cell, 0) == 1);
    for (vtkIdType k = 0; !cells.back() && k < grid.GetCell(cell)->GetNumberOfPoints(); ++k)
      points[static_cast<std::size_t>(grid.GetCell(cell)->GetPointId(static_cast<int>(k)))] = false;
  }
  return of_cells ? cells : points;
}

} // namespace

TEST_CASE("frames and particles are picked evenly, ends included", "[cases][report]")
{
  CHECK(evenly(10, 4) == std::vector<std::size_t>{0, 3, 6, 9});
  CHECK(evenly(3, 40) == std::vector<std::size_t>{0, 1, 2});
  CHECK(evenly(0, 40).empty());
  CHECK(evenly(7, 1) == std::vector<std::size_t>{0});
  const auto many = evenly(100001, 30000);
  REQUIRE(many.size() == 30000);
  CHECK(many.back() == 100000);
  for (std::size_t k = 1; k < many.size(); ++k) {
    const std::size_t step = many[k] - many[k - 1];
    if (step < 3 || step > 4)
      FAIL_CHECK("a step of " << step);
  }
}

TEST_CASE("places and fields of the view are those of the frames within half a step", "[cases][report]")
{
  const fs::path pvd = sheet_run() / "run.pvd";
  const ReportView view = make_report_view(pvd, {4, 1000000});
  REQUIRE(view.gaps.empty());
  CHECK(view.frames == 4);
  CHECK(view.all_frames == 10);
  CHECK(view.target);
  CHECK(view.data.find('<') == std::string::npos); // it stands in a <script>
  const auto json = nlohmann::json::parse(view.data);
  const SeriesIndex index = read_series_index(pvd);
  const std::vector<std::size_t> steps{0, 3, 6, 9};

  for (const std::string piece : {"bird", "target"}) {
    const auto& one = json[piece];
    const std::size_t count = one["count"], cells = one["cells"], row = 3 * count;
    REQUIRE(one["moves"] == true);
    const auto places = unpacked<std::uint16_t>(one["position"], 4 * row, row);
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const Frame frame = read_frame(index, steps[k]);
      CHECK(json["times"][k] == frame.time);
      vtkUnstructuredGrid& grid = piece == "bird" ? *frame.bird : *frame.target;
      REQUIRE(static_cast<std::size_t>(grid.GetNumberOfPoints()) == count);
      double worst = 0; // over half a step
      for (std::size_t i = 0; i < row; ++i) {
        const double low = one["low"][i % 3], high = one["high"][i % 3];
        const double place = from_16_bits(places[k * row + i], low, high);
        const double exact = grid.GetPoint(static_cast<vtkIdType>(i / 3))[i % 3];
        worst =
            std::max(worst, std::abs(place - exact) / ((high - low) / 65535 / 2 + 1e-7 * std::abs(exact)));
      }
      CHECK(worst <= 1.0001);

      for (const auto& field : one["fields"]) {
        const std::string name = field["name"];
        INFO(piece << " " << name << " frame " << k);
        const bool of_cells = field["of"] == "cells";
        vtkDataArray* array = of_cells ? grid.GetCellData()->GetArray(name.c_str())
                                       : grid.GetPointData()->GetArray(name.c_str());
        REQUIRE(array);
        const std::size_t rows = of_cells ? cells : count;
        const auto values = unpacked<std::uint8_t>(field["values"], 4 * rows, rows);
        const double factor = field["unit"] == "MPa"  ? 1e-6
                              : field["unit"] == "mm" ? 1e3
                              : field["unit"] == "%"  ? 100.0
                                                      : 1.0;
        const double low = field["low"], high = field["high"];
        double off = 0;
        bool beyond = false;
        const std::vector<bool> gone = rows_gone(grid, of_cells);
        for (std::size_t i = 0; i < rows; ++i) {
          double exact = 0;
          for (int c = 0; c < array->GetNumberOfComponents(); ++c)
            exact = std::hypot(exact, array->GetComponent(static_cast<vtkIdType>(i), c));
          if (array->GetNumberOfComponents() == 1)
            exact = array->GetComponent(static_cast<vtkIdType>(i), 0);
          if (gone[i]) { // no colour is wasted on what is not shown
            CHECK(values[k * rows + i] == 0);
            continue;
          }
          beyond = beyond || factor * exact > high * (1 + 1e-6);
          exact = std::clamp(factor * exact, low, high);
          off = std::max(off, std::abs(from_8_bits(values[k * rows + i], low, high) - exact));
        }
        CHECK(off <= (high - low) / 255 / 2 * 1.001);
        CHECK((!beyond || field["beyond"] == true));
      }
    }
  }
  // The frames have broken elements, and the view has the same ones.
  const std::size_t cells = json["target"]["cells"];
  const auto gone = unpacked<std::uint8_t>(json["target"]["gone"], 4 * cells, cells);
  const Frame last = read_frame(index, 9);
  int broken = 0;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const double eroded =
        last.target->GetCellData()->GetArray("eroded")->GetComponent(static_cast<vtkIdType>(cell), 0);
    CHECK(gone[3 * cells + cell] == eroded);
    broken += eroded == 1;
  }
  CHECK(broken > 0);
}

TEST_CASE("a thinned bird has larger particles of every part", "[cases][report]")
{
  const fs::path pvd = sheet_run() / "run.pvd";
  const auto whole = nlohmann::json::parse(make_report_view(pvd, {2, 1000000}).data);
  const ReportView few = make_report_view(pvd, {2, 20});
  const auto thin = nlohmann::json::parse(few.data);
  CHECK(few.particles == 20);
  CHECK(few.all_particles == whole["bird"]["count"].get<long>());
  // The volume that the particles stand for stays.
  CHECK(20 * std::pow(thin["bird"]["spacing"].get<double>(), 3) ==
        Approx(few.all_particles * std::pow(whole["bird"]["spacing"].get<double>(), 3)));
  CHECK(whole["bird"]["spacing"].get<double>() == Approx(0.008));
  CHECK(thin["bird"]["parts"][0]["name"] == "body");
}

TEST_CASE("frames that are missing or damaged are left out and told", "[cases][report]")
{
  const scratch::Folder folder;
  fs::copy(sheet_run(), folder.path / "out", fs::copy_options::recursive);
  const fs::path run = folder.path / "out";
  fs::remove(run / "frames/bird_0003.vtu");
  fs::resize_file(run / "frames/target_0006.vtu", 700);
  const ReportView view = make_report_view(run / "run.pvd", {4, 100});
  CHECK(view.frames == 2);
  REQUIRE(view.gaps.size() == 2);
  CHECK_THAT(view.gaps[0], Catch::Contains("Frame 3 is left out") && Catch::Contains("bird_0003.vtu"));
  CHECK_THAT(view.gaps[1], Catch::Contains("Frame 6 is left out") && Catch::Contains("damaged"));
  CHECK(nlohmann::json::parse(view.data)["times"].size() == 2);

  const ReportView none = make_report_view(run / "nothing.pvd", {4, 100});
  CHECK(none.data.empty());
  REQUIRE(none.gaps.size() == 1);
}
