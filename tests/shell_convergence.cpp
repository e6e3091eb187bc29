// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the benchmarks of tests/core/shell_benchmarks.h on meshes of several sizes, prints a table in Markdown for
// share/doc/make-shell-benchmarks, and draws their errors and the two curves with published values.
#include "tests/core/shell_benchmarks.h"
#include "vtkio/plot.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>

using namespace birdstrike;
using namespace birdstrike::samples;

namespace {

struct Shape
{
  const char* name;
  bool triangles, warping;
};
constexpr Shape shapes[] = {
    {"quads", false, true}, {"quads, no warping terms", false, false}, {"triangles", true, true}};

double hourglass = 0; // largest share of all

//! A table row for each mesh and a series for the plot.
struct Static
{
  const char* name;
  std::function<BenchmarkAnswer(const BenchmarkChoice&)> run;
  double published;
  const char* unit;
  std::vector<int> sizes;
  double tolerance;
  bool warps; //!< has elements that are not flat
};

void run_static(const Static& s, Plot& plot)
{
  std::printf("### %s\n\nPublished: %g %s.\n\n| elements a side |", s.name, s.published, s.unit);
  for (const Shape& shape : shapes)
    if (s.warps || shape.warping)
      std::printf(" %s | over published | hourglass |", shape.name);
  std::printf("\n|---|");
  for (const Shape& shape : shapes)
    if (s.warps || shape.warping)
      std::printf("---|---|---|");
  std::printf("\n");
  std::vector<PlotSeries> series(2);
  for (const int n : s.sizes) {
    std::printf("| %d |", n);
    for (const Shape& shape : shapes) {
      if (!s.warps && !shape.warping)
        continue;
      BenchmarkChoice choice;
      choice.n = n;
      choice.triangles = shape.triangles;
      choice.warping = shape.warping;
      choice.tolerance = s.tolerance;
      const BenchmarkAnswer answer = s.run(choice);
      std::printf(" %.5g | %.4f | %.2f %% |", answer.value, answer.value / s.published,
                  100 * answer.hourglass_share);
      std::fflush(stdout);
      hourglass = std::max(hourglass, answer.hourglass_share);
      if (shape.warping) {
        series[shape.triangles].x.push_back(n);
        series[shape.triangles].y.push_back(answer.value / s.published);
      }
    }
    std::printf("\n");
  }
  std::printf("\n");
  for (PlotSeries& one : series) {
    const bool triangles = &one == &series[1];
    one.name = triangles ? "" : s.name;
    static const char* colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7"};
    one.colour = colours[plot.series.size() / 2 % 4];
    one.style = triangles ? LineStyle::dashed : LineStyle::solid;
    one.marker = triangles ? Marker::diamond : Marker::circle;
    plot.series.push_back(one);
  }
}

BenchmarkChoice choice_of(int n, bool triangles, double load)
{
  BenchmarkChoice choice;
  choice.n = n;
  choice.triangles = triangles;
  choice.load = load;
  return choice;
}

void run_peak(const char* name, const std::function<BenchmarkCurve(const BenchmarkChoice&)>& run, double end,
              double published, double published_time, const char* unit)
{
  std::printf("### %s\n\nPublished: %g %s at %g ms.\n\n| elements a side of a quarter | load | elements | "
              "peak [%s] | over published | at [ms] "
              "| hourglass |\n|---|---|---|---|---|---|---|\n",
              name, published, unit, 1e3 * published_time, unit);
  for (const double load : {0.01, 1.0})
    for (const bool triangles : {false, true})
      for (const int n : {4, 8, 16}) {
        const BenchmarkCurve curve = run(choice_of(n, triangles, load));
        const auto peak = curve.extremum(0, end, 1);
        std::printf("| %d | %g | %s | %.4f | %.4f | %.4f | %.2f %% |\n", n, load,
                    triangles ? "triangles" : "quads", peak.value, peak.value / published, 1e3 * peak.time,
                    100 * curve.hourglass_share);
        std::fflush(stdout);
        hourglass = std::max(hourglass, curve.hourglass_share);
      }
  std::printf("\n");
}

void run_cap(const std::string& folder)
{
  struct Published
  {
    double value, from, to;
    int sign;
  };
  constexpr Published extrema[] = {{-0.05180, 0.10, 0.20, -1},
                                   {-0.04197, 0.17, 0.30, 1},
                                   {-0.08687, 0.30, 0.42, -1},
                                   {0.04821, 0.45, 0.70, 1},
                                   {-0.09646, 0.70, 0.95, -1}};
  std::printf(
      "### Clamped spherical cap under a step of 600 psi\n\nApex deflection [in]; share of the published "
      "extremum in "
      "brackets. The published curve is of linear theory and so are the rows of a hundredth of the load; "
      "those of "
      "the whole load show what large displacements do.\n\n| elements a side of a block | load | elements |");
  for (const Published& e : extrema)
    std::printf(" %.5f |", e.value);
  std::printf(" hourglass |\n|---|---|---|---|---|---|---|---|---|\n");
  Plot plot;
  plot.title = "Clamped spherical cap, step of 600 psi";
  plot.x_label = "time [ms]";
  plot.y_label = "apex deflection [in]";
  for (const double load : {0.01, 1.0})
    for (const bool triangles : {false, true})
      for (const int n : {4, 8, 12, 16}) {
        const BenchmarkCurve curve = spherical_cap(choice_of(n, triangles, load));
        std::printf("| %d | %g | %s |", n, load, triangles ? "triangles" : "quads");
        for (const Published& e : extrema) {
          const auto found = curve.extremum(1e-3 * e.from, 1e-3 * e.to, e.sign);
          std::printf(" %.5f (%.3f) |", found.value, found.value / e.value);
        }
        std::printf(" %.2f %% |\n", 100 * curve.hourglass_share);
        std::fflush(stdout);
        hourglass = std::max(hourglass, curve.hourglass_share);
        if (n == 16) {
          PlotSeries s;
          s.name =
              std::string(triangles ? "triangles" : "quads") + (load < 1 ? ", small load" : ", whole load");
          for (std::size_t k = 0; k < curve.time.size(); ++k) {
            s.x.push_back(1e3 * curve.time[k]);
            s.y.push_back(curve.value[k]);
          }
          s.style = triangles ? LineStyle::dashed : LineStyle::solid;
          s.colour = load < 1 ? (triangles ? "#56b4e9" : "#0072b2") : (triangles ? "#e69f00" : "#d55e00");
          plot.series.push_back(s);
        }
      }
  std::printf("\n");
  PlotSeries published;
  published.name = "published, linear";
  published.x = {0.05, 0.10,  0.170, 0.20, 0.233, 0.30,  0.362, 0.40,
                 0.50, 0.573, 0.60,  0.70, 0.80,  0.842, 1.00};
  published.y = {-0.00709, -0.02472, -0.05180, -0.04689, -0.04197, -0.06432, -0.08687, -0.08150,
                 0.00089,  0.04821,  0.03869,  -0.05646, -0.09040, -0.09646, -0.00252};
  published.colour = "#000000";
  published.style = LineStyle::points;
  published.marker = Marker::open_circle;
  plot.series.push_back(published);
  plot.y_range = {{-0.12, 0.1}};
  write_plot(plot, folder + "/shell-benchmarks-cap.png");
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 2) {
    std::fprintf(stderr, "shell_convergence FOLDER: folder for the pictures\n");
    return 2;
  }
  const std::string folder = argv[1];
  Plot plot;
  plot.title = "Convergence of static benchmarks: quads solid, triangles dashed";
  plot.x_label = "elements a side";
  plot.y_label = "deflection over published";
  plot.x_log = true;
  plot.y_range = {{0.5, 1.25}};
  std::printf("## Statics, by relaxation\n\n");
  run_static({"Scordelis-Lo roof", scordelis_lo, 0.3024, "ft", {4, 8, 16, 32}, 5e-4, false}, plot);
  run_static({"Pinched hemisphere, 18-degree hole",
              pinched_hemisphere,
              0.0935,
              "in",
              {4, 8, 12, 16, 24},
              5e-4,
              false},
             plot);
  run_static(
      {"Pinched cylinder with diaphragms", pinched_cylinder, 1.82488e-5, "in", {8, 16, 32, 48}, 5e-4, false},
      plot);
  run_static({"Clamped hyperbolic paraboloid", clamped_hypar, -9.3355e-5, "m", {8, 16, 32, 48}, 5e-4, true},
             plot);
  write_plot(plot, folder + "/shell-benchmarks.png");
  Plot none;
  run_static(
      {"Square plate of large deflection", large_deflection_plate, 1.8687, "", {4, 8, 16}, 5e-4, false},
      none);
  run_static({"Cantilever strip", cantilever, 1, "F L^3 / (3 E I)", {4, 8, 16}, 5e-4, false}, none);
  std::printf("## Dynamics\n\n");
  run_peak("NAFEMS 21T", nafems_21t, 0.02, 4.524, 0.01086, "mm");
  run_peak("Simply supported plate under a step of 300 psi", step_plate, 1e-3, 0.213, 0.53e-3, "in");
  run_cap(folder);
  std::printf("Largest hourglass energy of all these runs: %.2f %% of internal energy.\n", 100 * hourglass);
  return 0;
}
