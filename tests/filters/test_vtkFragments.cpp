// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFragments.h"

#include "tests/filters/made_cloud.h"
#include "tests/filters/made_series.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkUnsignedCharArray.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using Catch::Matchers::Contains;

namespace {

Cloud moved(Cloud cloud, const std::array<double, 3>& by, const std::array<double, 3>& velocity)
{
  for (CloudParticle& p : cloud)
    for (std::size_t k = 0; k < 3; ++k) {
      p.place[k] += by[k];
      p.velocity[k] = velocity[k];
    }
  return cloud;
}

Cloud operator+(Cloud a, const Cloud& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

struct Result
{
  vtkSmartPointer<vtkDataObject> data;
  vtkSmartPointer<vtkTable> table;
  std::string messages;
  double at(vtkIdType row, const char* column) const { return value(*table, row, column); }
};

Result fragments_of(vtkDataObject* data, const std::function<void(vtkFragments&)>& set = {})
{
  vtkNew<vtkFragments> filter;
  Messages errors;
  errors.watch(*filter);
  filter->SetInputDataObject(data);
  if (set)
    set(*filter);
  filter->Update();
  return {filter->GetOutputDataObject(0), filter->GetTable(), errors.text()};
}

//! n x n quads of side 0.1 m in the plane x = 0; the velocity is (10, 0, 0).
vtkSmartPointer<vtkPolyData> made_sheet(int n)
{
  auto sheet = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> velocity, thickness;
  velocity->SetName("velocity");
  velocity->SetNumberOfComponents(3);
  thickness->SetName("thickness");
  vtkNew<vtkCellArray> quads;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      points->InsertNextPoint(0, 0.1 * i, 0.1 * j);
      velocity->InsertNextTuple3(10, 0, 0);
    }
  for (vtkIdType j = 0; j < n; ++j)
    for (vtkIdType i = 0; i < n; ++i) {
      const vtkIdType a = j * (n + 1) + i;
      quads->InsertNextCell({a, a + 1, a + n + 2, a + n + 1});
      thickness->InsertNextValue(0.002);
    }
  sheet->SetPoints(points);
  sheet->SetPolys(quads);
  sheet->GetPointData()->AddArray(velocity);
  sheet->GetCellData()->AddArray(thickness);
  return sheet;
}

} // namespace

TEST_CASE("two clouds are two fragments when their gap exceeds the reach, and one when not",
          "[filters][fragments]")
{
  // Balls whose outermost particles are a known gap apart; h = 12 mm, support 24 mm.
  const Cloud big = made_ball(0.05, 0.01), small = made_ball(0.03, 0.01);
  const double right =
      std::max_element(big.begin(), big.end(), [](auto& a, auto& b) { return a.place < b.place; })->place[0];
  const double left = std::min_element(small.begin(), small.end(), [](auto& a, auto& b) {
                        return a.place < b.place;
                      })->place[0];
  const auto with_gap = [&](double gap) {
    // Both have particles at y = z = 5 mm on that side: the gap is the distance of the nearest two.
    return to_data(moved(small, {right - left + gap, 0, 0}, {0, 0, 0}) + big);
  };
  CHECK(fragments_of(with_gap(0.0239)).table->GetNumberOfRows() == 1);
  const Result apart = fragments_of(with_gap(0.0241));
  CHECK(apart.messages.empty());
  REQUIRE(apart.table->GetNumberOfRows() == 2);
  CHECK(apart.at(0, "count") == static_cast<double>(big.size())); // the heavier one first
  CHECK(apart.at(1, "count") == static_cast<double>(small.size()));
  auto* label = vtkPolyData::SafeDownCast(apart.data)->GetPointData()->GetArray("fragment");
  REQUIRE(label);
  CHECK(label->GetDataType() == VTK_INT);
  for (vtkIdType i = 0; i < label->GetNumberOfTuples(); ++i)
    REQUIRE(label->GetComponent(i, 0) == (i < static_cast<vtkIdType>(small.size()) ? 1 : 0));

  CHECK(fragments_of(with_gap(0.0241), [](auto& f) { f.SetReachFactor(2.1); }).table->GetNumberOfRows() == 1);
  const auto few =
      fragments_of(with_gap(0.0241), [&](auto& f) { f.SetMinimumCount(static_cast<int>(small.size()) + 1); });
  REQUIRE(few.table->GetNumberOfRows() == 1);
  CHECK(vtkPolyData::SafeDownCast(few.data)->GetPointData()->GetArray("fragment")->GetComponent(0, 0) == -1);
}

TEST_CASE("masses, momenta and energies are those of direct sums", "[filters][fragments]")
{
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  Cloud cloud;
  for (int piece = 0; piece < 7; ++piece)
    for (int i = 0; i < 20 + 10 * piece; ++i)
      cloud.push_back(
          {.place = {piece + 0.004 * normal(random), 0.004 * normal(random), 0.004 * normal(random)},
           .velocity = {100 * normal(random), 5.0 * piece, normal(random)},
           .mass = 1 + 0.1 * std::abs(normal(random))});
  const Result result = fragments_of(to_data(cloud));
  REQUIRE(result.table->GetNumberOfRows() == 7);
  for (int f = 0; f < 7; ++f) {
    const int piece = 6 - f; // those of more particles are heavier
    double mass = 0, energy = 0, extent = 0;
    std::array<double, 3> centre{}, momentum{};
    for (const CloudParticle& p : cloud) {
      if (std::lround(p.place[0]) != piece)
        continue;
      mass += p.mass;
      for (std::size_t k = 0; k < 3; ++k) {
        centre[k] += p.mass * p.place[k];
        momentum[k] += p.mass * p.velocity[k];
        energy += 0.5 * p.mass * p.velocity[k] * p.velocity[k];
      }
      for (const CloudParticle& q : cloud)
        if (std::lround(q.place[0]) == piece)
          extent = std::max(
              extent, std::hypot(p.place[0] - q.place[0], p.place[1] - q.place[1], p.place[2] - q.place[2]));
    }
    INFO("fragment " << f);
    CHECK(result.at(f, "fragment") == f);
    CHECK(result.at(f, "mass[kg]") == Approx(mass));
    CHECK(result.at(f, "centre_x[m]") == Approx(centre[0] / mass).margin(1e-12));
    CHECK(result.at(f, "centre_z[m]") == Approx(centre[2] / mass).margin(1e-12));
    CHECK(result.at(f, "momentum_x[kg m/s]") == Approx(momentum[0]).margin(1e-9));
    CHECK(result.at(f, "velocity_y[m/s]") == Approx(momentum[1] / mass).margin(1e-12));
    CHECK(result.at(f, "kinetic_energy[J]") == Approx(energy));
    CHECK(result.at(f, "kinetic_energy_of_centre[J]") ==
          Approx((momentum[0] * momentum[0] + momentum[1] * momentum[1] + momentum[2] * momentum[2]) /
                 (2 * mass)));
    CHECK(result.at(f, "extent[m]") == Approx(extent));
  }
}

TEST_CASE("the table is the same, bit for bit, for particles in another order; equals go by place",
          "[filters][fragments]")
{
  Cloud cloud;
  std::mt19937 random(2);
  std::normal_distribution<double> jolt(0, 0.002);
  for (int piece = 0; piece < 5; ++piece) { // equal masses and counts
    Cloud ball = moved(made_ball(0.02, 0.01), {-0.3 * piece, 0, 0}, {0, 0, 0});
    for (CloudParticle& p : ball)
      p.mass = 0.1, p.velocity = {jolt(random), jolt(random), jolt(random)};
    cloud = cloud + ball;
  }
  const Result first = fragments_of(to_data(cloud));
  REQUIRE(first.table->GetNumberOfRows() == 5);
  CHECK(first.at(0, "centre_x[m]") == Approx(-1.2));
  CHECK(first.at(4, "centre_x[m]") == Approx(0).margin(1e-12));
  for (int turn = 0; turn < 3; ++turn) {
    std::shuffle(cloud.begin(), cloud.end(), random);
    const Result again = fragments_of(to_data(cloud));
    REQUIRE(again.table->GetNumberOfRows() == 5);
    for (vtkIdType row = 0; row < 5; ++row)
      for (vtkIdType column = 1; column < first.table->GetNumberOfColumns(); ++column)
        CHECK(again.table->GetValue(row, column).ToDouble() == first.table->GetValue(row, column).ToDouble());
  }
}

TEST_CASE("a chain hangs together from end to end, and falls apart where a link is missing",
          "[filters][fragments]")
{
  Cloud chain;
  for (int i = 0; i < 1000; ++i)
    chain.push_back({.place = {0.0239 * i, 0, 0}});
  const Result whole = fragments_of(to_data(chain));
  REQUIRE(whole.table->GetNumberOfRows() == 1);
  CHECK(whole.at(0, "extent[m]") == Approx(0.0239 * 999));
  chain.erase(chain.begin() + 400);
  const Result broken = fragments_of(to_data(chain));
  REQUIRE(broken.table->GetNumberOfRows() == 2);
  CHECK(broken.at(0, "count") == 599);
  CHECK(broken.at(1, "count") == 400);
}

TEST_CASE("the largest distance is exact for boxes and balls", "[filters][fragments]")
{
  const Cloud box =
      made_cloud(0.2, 0.02, [](const auto& p) { return std::abs(p[1]) < 0.1 && std::abs(p[2]) < 0.05; });
  double furthest = 0;
  for (const CloudParticle& p : box)
    furthest = std::max(furthest, std::hypot(2 * p.place[0], 2 * p.place[1], 2 * p.place[2])); // symmetric
  CHECK(fragments_of(to_data(box)).at(0, "extent[m]") == Approx(furthest));
  double across = 0;
  const Cloud ball = made_ball(0.2, 0.01);
  for (const CloudParticle& p : ball)
    across = std::max(across, 2 * std::hypot(p.place[0], p.place[1], p.place[2]));
  CHECK(fragments_of(to_data(ball)).at(0, "extent[m]") == Approx(across));
}

TEST_CASE("a sheet falls apart where cells have eroded or are hidden", "[filters][fragments]")
{
  const bool hidden = GENERATE(false, true);
  auto sheet = made_sheet(5);
  vtkNew<vtkDoubleArray> eroded;
  eroded->SetName("eroded");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (int cell = 0; cell < 25; ++cell) {
    const bool gone = cell / 5 == 3; // the fourth row: three rows stay on one side, one on the other
    eroded->InsertNextValue(gone ? 1 : 0);
    ghosts->InsertNextValue(gone ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  CHECK(fragments_of(sheet, [](auto& f) { f.SetDensity(2700); }).table->GetNumberOfRows() == 1);
  hidden ? sheet->GetCellData()->AddArray(ghosts) : sheet->GetCellData()->AddArray(eroded);
  const Result result = fragments_of(sheet, [](auto& f) { f.SetDensity(2700); });
  CHECK(result.messages.empty());
  REQUIRE(result.table->GetNumberOfRows() == 2);
  for (const int f : {0, 1}) {
    const double mass = (f == 0 ? 15 : 5) * 0.1 * 0.1 * 0.002 * 2700;
    CHECK(result.at(f, "count") == (f == 0 ? 15 : 5));
    CHECK(result.at(f, "mass[kg]") == Approx(mass));
    CHECK(result.at(f, "momentum_x[kg m/s]") == Approx(10 * mass));
    CHECK(result.at(f, "kinetic_energy[J]") == Approx(50 * mass));
    CHECK(result.at(f, "centre_z[m]") == Approx(f == 0 ? 0.15 : 0.45));
    CHECK(result.at(f, "extent[m]") == Approx(std::hypot(0.5, f == 0 ? 0.3 : 0.1)));
  }
  auto* label = vtkPolyData::SafeDownCast(result.data)->GetCellData()->GetArray("fragment");
  REQUIRE(label);
  CHECK(label->GetComponent(0, 0) == 0);
  CHECK(label->GetComponent(16, 0) == -1);
  CHECK(label->GetComponent(24, 0) == 1);
}

TEST_CASE("a run's bird and target have rows of their own; kinds can be chosen", "[filters][fragments]")
{
  auto run = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  run->SetBlock(0, to_data(made_ball(0.03, 0.01)));
  run->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "bird");
  run->SetBlock(1, made_sheet(2));
  run->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "target");
  const Result both = fragments_of(run, [](auto& f) { f.SetDensity(7800); });
  REQUIRE(both.table->GetNumberOfRows() == 2);
  CHECK(both.table->GetValueByName(0, "dataset").ToString() == "bird");
  CHECK(both.table->GetValueByName(1, "dataset").ToString() == "target");
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(both.data);
  REQUIRE(blocks);
  CHECK(vtkDataSet::SafeDownCast(blocks->GetBlock(0))->GetPointData()->GetArray("fragment"));
  CHECK(vtkDataSet::SafeDownCast(blocks->GetBlock(1))->GetCellData()->GetArray("fragment"));
  CHECK_FALSE(vtkDataSet::SafeDownCast(run->GetBlock(0))
                  ->GetPointData()
                  ->GetArray("fragment")); // the input is left alone
  const Result birds = fragments_of(run, [](auto& f) { f.SetKind(vtkFragments::OnlyParticles); });
  CHECK(birds.messages.empty());
  CHECK(birds.table->GetNumberOfRows() == 1);
}

TEST_CASE("what is missing is NaN and is said once", "[filters][fragments]")
{
  auto cloud = to_data(moved(made_ball(0.03, 0.01), {1, 0, 0}, {0, 0, 0}) + made_ball(0.02, 0.01));
  cloud->GetPointData()->RemoveArray("mass");
  cloud->GetPointData()->RemoveArray("velocity");
  const Result result = fragments_of(cloud);
  CHECK_THAT(result.messages, Contains("'mass'") && Contains("'velocity'"));
  REQUIRE(result.table->GetNumberOfRows() == 2);
  CHECK(std::isnan(result.at(0, "mass[kg]")));
  CHECK(std::isnan(result.at(0, "kinetic_energy[J]")));
  CHECK(result.at(0, "count") > result.at(1, "count"));
  CHECK(result.at(0, "centre_x[m]") == Approx(1));

  const Result sheet = fragments_of(made_sheet(2));
  CHECK_THAT(sheet.messages, Contains("set Target Density"));
  REQUIRE(sheet.table->GetNumberOfRows() == 1);
  CHECK(std::isnan(sheet.at(0, "mass[kg]")));
  CHECK(sheet.at(0, "velocity_x[m/s]") == Approx(10));

  vtkNew<vtkFragments> filter;
  Messages errors;
  errors.watch(*filter);
  auto input = made_sheet(2);
  filter->SetInputDataObject(input);
  filter->Update();
  const std::string once = errors.text();
  input->Modified();
  filter->Update();
  CHECK(errors.text() == once);
}

TEST_CASE("particles at no finite place are in no fragment; wrong settings say so", "[filters][fragments]")
{
  Cloud cloud = made_ball(0.03, 0.01);
  cloud.push_back({.place = {std::numeric_limits<double>::quiet_NaN(), 0, 0}});
  const Result result = fragments_of(to_data(cloud));
  CHECK_THAT(result.messages, Contains("1 particles"));
  REQUIRE(result.table->GetNumberOfRows() == 1);
  CHECK(result.at(0, "count") == static_cast<double>(cloud.size() - 1));

  const auto failed = [&](vtkDataObject* data, const std::function<void(vtkFragments&)>& set) {
    const Result r = fragments_of(data, set);
    CHECK(r.table->GetNumberOfRows() == 0);
    return r.messages;
  };
  auto fine = to_data(made_ball(0.03, 0.01));
  CHECK_THAT(failed(fine, [](auto& f) { f.SetReachFactor(0); }), Contains("Reach Factor is 0"));
  CHECK_THAT(failed(fine, [](auto& f) { f.SetMinimumCount(0); }), Contains("Minimum Count is 0"));
  CHECK_THAT(failed(fine, [](auto& f) { f.SetKind(vtkFragments::OnlyCells); }), Contains("holds cells"));
  fine->GetPointData()->RemoveArray("smoothing_length");
  CHECK_THAT(failed(fine, [](auto&) {}), Contains("set Smoothing Length"));
}

TEST_CASE("an empty dataset and a rigid target are nothing to complain of", "[filters][fragments]")
{
  auto run = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  run->SetBlock(0, to_data(made_ball(0.03, 0.01)));
  run->SetBlock(1, vtkSmartPointer<vtkPolyData>::New());
  auto plate = made_sheet(2);
  plate->GetPointData()->RemoveArray("velocity");
  vtkNew<vtkDoubleArray> rigid;
  rigid->SetName("rigid");
  rigid->InsertNextValue(1);
  plate->GetFieldData()->AddArray(rigid);
  run->SetBlock(2, plate);
  const Result result = fragments_of(run);
  CHECK(result.messages.empty());
  CHECK(result.table->GetNumberOfRows() == 2);
}

TEST_CASE("a dataset without a name has that of the block around it, not of its neighbour",
          "[filters][fragments]")
{
  // As ParaView reads a series of ours: named blocks, with a nameless dataset each.
  auto run = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const char* name : {"bird", "other", ""}) {
    auto inner = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    inner->SetNumberOfBlocks(2); // one of them empty
    inner->SetBlock(1, to_data(made_ball(0.03, 0.01)));
    const unsigned int k = run->GetNumberOfBlocks();
    run->SetBlock(k, inner);
    if (*name)
      run->GetMetaData(k)->Set(vtkCompositeDataSet::NAME(), name);
  }
  const Result result = fragments_of(run);
  REQUIRE(result.table->GetNumberOfRows() == 3);
  CHECK(result.table->GetValueByName(0, "dataset").ToString() == "bird");
  CHECK(result.table->GetValueByName(1, "dataset").ToString() == "other");
  CHECK(result.table->GetValueByName(2, "dataset").ToString() == "dataset_2");
}
