// SPDX-License-Identifier: BSD-3-Clause
#include "vtkio/plot.h"

#include "core/error.h"
#include "tests/vtkio/made_run.h"
#include "vtkio/ticks.h"

#include <catch2/catch.hpp>
#include <vtkImageData.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

#include <cmath>

using namespace birdstrike;
using Catch::Matchers::Contains;

static Plot made_plot()
{
  Plot plot;
  plot.title = "Made-up pressure";
  plot.x_label = "time [ms]";
  plot.y_label = "pressure [MPa]";
  plot.width = 640;
  plot.height = 360;
  PlotSeries flat{"flat", {0, 1, 2, 3}, {1, 1, 1, 1}, "#ff0000", LineStyle::solid, 3};
  PlotSeries gap{"gap", {0, 1, 2, 3}, {0, std::nan(""), 2, 2}, "#0000ff", LineStyle::solid, 3};
  plot.series = {flat, gap};
  return plot;
}

// Pixels of one colour in the part of the picture between two shares of its width and height.
static int count(vtkImageData& image, double x0, double x1, double y0, double y1, int r, int g, int b)
{
  const int* size = image.GetDimensions();
  int n = 0;
  for (int y = static_cast<int>(y0 * size[1]); y < static_cast<int>(y1 * size[1]); ++y)
    for (int x = static_cast<int>(x0 * size[0]); x < static_cast<int>(x1 * size[0]); ++x) {
      const auto* c = static_cast<const unsigned char*>(image.GetScalarPointer(x, y, 0));
      n += std::abs(c[0] - r) + std::abs(c[1] - g) + std::abs(c[2] - b) < 60;
    }
  return n;
}

TEST_CASE("a plot shows its lines, leaves gaps at NaN and writes its titles", "[plot]")
{
  TemporaryFolder folder;
  write_plot(made_plot(), folder.path / "figures" / "p.png"); // the folder is made
  auto reader = vtkSmartPointer<vtkPNGReader>::New();
  reader->SetFileName((folder.path / "figures" / "p.png").string().c_str());
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  REQUIRE(image.GetDimensions()[0] == 640);
  REQUIRE(image.GetDimensions()[1] == 360);
  CHECK(count(image, 0.1, 0.85, 0.1, 0.9, 255, 0, 0) > 1000); // red from end to end
  const int blue = count(image, 0.1, 0.85, 0.1, 0.98, 0, 0, 255);
  CHECK(blue > 300);
  CHECK(blue < count(image, 0.1, 0.85, 0.1, 0.9, 255, 0, 0) / 2); // a third of the way: 2 to 3
  CHECK(count(image, 0.85, 1, 0.7, 1, 255, 0, 0) > 5);            // the legend, right of the curves
  CHECK(count(image, 0.3, 0.7, 0, 0.06, 0, 0, 0) > 50);           // x title
  CHECK(count(image, 0, 0.04, 0.2, 0.8, 0, 0, 0) > 50);           // y title
  CHECK(count(image, 0.3, 0.7, 0.94, 1, 0, 0, 0) > 50);           // title
}

TEST_CASE("wrong plots are explained", "[plot]")
{
  TemporaryFolder folder;
  Plot plot = made_plot();
  plot.series[1].y.pop_back();
  CHECK_THROWS_AS(write_plot(plot, folder.path / "p.png"), InputError);
  CHECK_THROWS_WITH(write_plot(plot, folder.path / "p.png"),
                    Contains("\"gap\" has 4 values of x and 3 of y"));
  plot = made_plot();
  plot.series.clear();
  CHECK_THROWS_WITH(write_plot(plot, folder.path / "p.png"), Contains("no series"));
  plot.series = {{"void", {0.0}, {std::nan("")}, "", LineStyle::solid, 2}};
  CHECK_THROWS_WITH(write_plot(plot, folder.path / "p.png"), Contains("has a value"));
  plot = made_plot();
  plot.series[0].colour = "blue";
  CHECK_THROWS_WITH(write_plot(plot, folder.path / "p.png"), Contains("\"blue\""));
  plot = made_plot();
  plot.x_range = {{3, 3}};
  CHECK_THROWS_WITH(write_plot(plot, folder.path / "p.png"), Contains("range"));
  CHECK_THROWS_AS(write_plot(made_plot(), "/proc/nowhere/p.png"), OutputError);
  CHECK(std::filesystem::is_empty(folder.path));
}

TEST_CASE("ticks are round numbers inside the range", "[ticks]")
{
  CHECK(ticks_between(0, 4) == std::vector<double>{0, 1, 2, 3, 4});
  CHECK(ticks_between(-1, 1) == std::vector<double>{-1, -0.5, 0, 0.5, 1});
  for (const double scale : {1e-9, 3e-3, 0.7, 1.0, 42.0, 6e8})
    for (const double low : {-0.3, 0.0, 12.4}) {
      const auto ticks = ticks_between(low * scale, (low + 1) * scale);
      INFO(scale << " " << low);
      CHECK(ticks.size() >= 4);
      CHECK(ticks.size() <= 11);
      CHECK(ticks.front() >= low * scale * (low < 0 ? 1 + 1e-9 : 1 - 1e-9));
      CHECK(ticks.back() <= (low + 1) * scale * (1 + 1e-9));
    }
}

TEST_CASE("ticks of logarithmic axes are few and round", "[plot]")
{
  CHECK(log_ticks_between(0.9, 11) == std::vector<double>{1, 2, 5, 10});
  CHECK(log_ticks_between(1, 1e6) == std::vector<double>{1, 10, 100, 1000, 1e4, 1e5, 1e6});
  CHECK(log_ticks_between(110, 190) == ticks_between(110, 190));
}

TEST_CASE("on logarithmic axes powers are straight, and what is not positive is a gap", "[plot]")
{
  TemporaryFolder folder;
  Plot plot = made_plot();
  // y = x^2 at its ends and in the middle of the logarithms: the marks lie on the line between the ends.
  plot.series = {{"line", {1, 100}, {1, 1e4}, "#ff0000", LineStyle::solid, 3},
                 {"marks", {-5, 10, 0}, {1, 100, 5}, "#0000ff", LineStyle::points, 3}};
  plot.series[1].marker = Marker::open_circle;
  plot.x_log = plot.y_log = true;
  const auto read = [&](const char* name) {
    write_plot(plot, folder.path / name);
    auto reader = vtkSmartPointer<vtkPNGReader>::New();
    reader->SetFileName((folder.path / name).string().c_str());
    reader->Update();
    return reader;
  };
  const auto open = read("open.png");
  vtkImageData& image = *open->GetOutput();
  const int ring = count(image, 0.1, 0.8, 0.1, 0.95, 0, 0, 255);
  CHECK(ring > 10);
  CHECK(ring == count(image, 0.4, 0.55, 0.4, 0.6, 0, 0, 255)); // one mark, in the middle
  plot.series[1].marker = Marker::circle;
  const auto full = read("full.png");
  CHECK(count(*full->GetOutput(), 0.1, 0.8, 0.1, 0.95, 0, 0, 255) > 1.3 * ring);
  // The line hides behind the full mark, so it goes through it.
  CHECK(count(*full->GetOutput(), 0.4, 0.55, 0.4, 0.6, 255, 0, 0) > 50);

  plot.series = {{"none", {-1, 0}, {1, 2}, "", LineStyle::solid, 3}};
  CHECK_THROWS_WITH(write_plot(plot, folder.path / "none.png"), Contains("no series has a value"));
  plot = made_plot();
  plot.x_log = true;
  plot.x_range = {0.0, 1.0};
  CHECK_THROWS_WITH(write_plot(plot, folder.path / "none.png"),
                    Contains("a logarithmic axis begins above 0"));
}
