// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBirdSurface.h"

#include "tests/filters/made_cloud.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkMath.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkStringArray.h>
#include <vtkTriangle.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

using Catch::Matchers::Contains;

namespace {

//! A target: one square, nothing else.
vtkSmartPointer<vtkPolyData> made_plate()
{
  auto plate = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  points->InsertNextPoint(0, 1, 1);
  points->InsertNextPoint(0, 0, 1);
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({0, 1, 2, 3});
  plate->SetPoints(points);
  plate->SetPolys(quads);
  return plate;
}

struct Measures
{
  double area = 0, volume = 0;
  bool closed = true;
};

Measures measure(vtkPolyData& surface)
{
  Measures m;
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges; // directed
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < surface.GetNumberOfCells(); ++t) {
    surface.GetCellPoints(t, corners);
    REQUIRE(corners->GetNumberOfIds() == 3);
    double p[3][3];
    for (int k = 0; k < 3; ++k) {
      surface.GetPoint(corners->GetId(k), p[k]);
      ++edges[{corners->GetId(k), corners->GetId((k + 1) % 3)}];
    }
    m.area += vtkTriangle::TriangleArea(p[0], p[1], p[2]);
    m.volume += vtkMath::Determinant3x3(p[0], p[1], p[2]) / 6;
  }
  // Each edge is run through once in each direction.
  for (const auto& [edge, times] : edges)
    m.closed = m.closed && times == 1 && edges.count({edge.second, edge.first}) == 1;
  return m;
}

vtkSmartPointer<vtkMultiBlockDataSet> skins_of(vtkDataObject* data,
                                               const std::function<void(vtkBirdSurface&)>& set = {})
{
  vtkNew<vtkBirdSurface> filter;
  filter->SetInputDataObject(data);
  if (set)
    set(*filter);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> skin_of(vtkDataObject* data,
                                     const std::function<void(vtkBirdSurface&)>& set = {})
{
  auto blocks = skins_of(data, set);
  REQUIRE(blocks->GetNumberOfBlocks() == 1);
  return vtkPolyData::SafeDownCast(blocks->GetBlock(0));
}

} // namespace

TEST_CASE("the skin of a ball has its area and volume, closed, and a better volume the finer",
          "[filters][surface]")
{
  constexpr double radius = 0.1, pi = 3.14159265358979;
  double last = 1;
  for (const double spacing : {0.02, 0.01, 0.005}) {
    INFO("spacing " << spacing);
    const Cloud cloud = made_ball(radius, spacing);
    const auto skin = skin_of(to_data(cloud));
    const Measures m = measure(*skin);
    CHECK(m.closed);
    // Volume that the particles stand for; the skin's error is a share of the spacing, so of first order.
    const double filled = static_cast<double>(cloud.size()) * spacing * spacing * spacing;
    const double error = std::abs(m.volume / filled - 1);
    CHECK(error < 0.1 * 3 * spacing / radius); // a tenth of a spacing in radius
    CHECK(error < 0.6 * last);
    last = error;
    CHECK(m.area == Approx(4 * pi * radius * radius).epsilon(0.03)); // the steps of the lattice remain
    auto* normals = skin->GetPointData()->GetNormals();
    REQUIRE(normals);
    double worst = 1;
    for (vtkIdType i = 0; i < skin->GetNumberOfPoints(); ++i) {
      std::array<double, 3> p, n;
      skin->GetPoint(i, p.data());
      normals->GetTuple(i, n.data());
      worst = std::min(worst, vtkMath::Dot(p.data(), n.data()) / vtkMath::Norm(p.data()));
    }
    CHECK(worst > 0.8); // outwards
  }
}

TEST_CASE("a lone particle and a sheet of one layer keep their skin and about their volume",
          "[filters][surface]")
{
  const auto fine = [](vtkBirdSurface& f) { f.SetGridShare(0.1); };
  Cloud one{{.place = {1, 2, 3}, .h = 0.012}};
  const Measures lone = measure(*skin_of(to_data(one), fine));
  CHECK(lone.closed);
  CHECK(lone.volume / 1e-6 == Approx(1).epsilon(0.2)); // a cube of 10 mm

  const Cloud sheet = made_cloud(0.105, 0.01, [](const auto& p) { return std::abs(p[0] - 0.005) < 1e-6; });
  REQUIRE(sheet.size() > 400);
  const Measures layer = measure(*skin_of(to_data(sheet)));
  CHECK(layer.closed);
  CHECK(layer.volume / (static_cast<double>(sheet.size()) * 1e-6) == Approx(1).epsilon(0.3));
}

TEST_CASE("debris at random has a closed skin, far apart in little memory", "[filters][surface]")
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-0.15, 0.15), h(0.008, 0.016);
  Cloud cloud;
  for (int i = 0; i < 2500; ++i)
    cloud.push_back({.place = {at(random), at(random), at(random)}, .h = h(random)});
  const auto near = skin_of(to_data(cloud));
  CHECK(measure(*near).closed);

  for (std::size_t i = 0; i < 100; ++i) // each on its own, a dense grid would have 1e21 cells
    cloud[i].place = {1e4 * static_cast<double>(i), -1e4 * static_cast<double>(i), 1e3};
  const auto far = skin_of(to_data(cloud), [](vtkBirdSurface& f) { f.SetMemoryLimit(200); });
  CHECK(far->GetNumberOfCells() > near->GetNumberOfCells() / 2);
  CHECK(measure(*far).closed);
}

TEST_CASE("a constant is carried exactly, a linear field within the noise of the lattice, whole numbers by "
          "majority",
          "[filters][surface]")
{
  Cloud cloud = made_ball(0.05, 0.005);
  for (CloudParticle& p : cloud) {
    p.mass = 0.25;
    p.velocity = {3 + 2 * p.place[0], 10 * p.place[1], -p.place[2]};
    p.part = p.place[2] > 0 ? 7 : 3;
  }
  const auto skin = skin_of(to_data(cloud));
  vtkPointData& data = *skin->GetPointData();
  REQUIRE(data.GetArray("velocity"));
  REQUIRE(data.GetArray("part"));
  CHECK(data.GetArray("part")->GetDataType() == VTK_INT);
  double mass_error = 0, velocity_error = 0;
  vtkIdType wrong = 0;
  for (vtkIdType i = 0; i < skin->GetNumberOfPoints(); ++i) {
    std::array<double, 3> p, v;
    skin->GetPoint(i, p.data());
    data.GetArray("velocity")->GetTuple(i, v.data());
    mass_error = std::max(mass_error, std::abs(data.GetArray("mass")->GetComponent(i, 0) - 0.25));
    // Neighbours all lie on the inner side: the mean is that of a place one or two spacings deeper.
    velocity_error = std::max(velocity_error, std::abs(v[1] - 10 * p[1]) / 10);
    const double part = data.GetArray("part")->GetComponent(i, 0);
    wrong += std::abs(p[2]) > 0.005 && part != (p[2] > 0 ? 7 : 3) ? 1 : 0;
  }
  CHECK(mass_error < 1e-14);
  CHECK(velocity_error < 2 * 0.005);
  CHECK(wrong == 0);
}

TEST_CASE("moved particles have the moved skin; another order gives the same bits", "[filters][surface]")
{
  Cloud cloud = made_ball(0.04, 0.005);
  std::mt19937 random(5);
  std::normal_distribution<double> jolt(0, 0.001);
  for (CloudParticle& p : cloud)
    for (double& x : p.place)
      x += jolt(random);
  const auto skin = skin_of(to_data(cloud));

  Cloud shuffled = cloud;
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  const auto same = skin_of(to_data(shuffled));
  REQUIRE(same->GetNumberOfPoints() == skin->GetNumberOfPoints());
  REQUIRE(same->GetNumberOfCells() == skin->GetNumberOfCells());
  vtkIdType different = 0;
  for (vtkIdType i = 0; i < skin->GetNumberOfPoints(); ++i) {
    std::array<double, 3> a, b;
    skin->GetPoint(i, a.data());
    same->GetPoint(i, b.data());
    const auto value = [i](vtkPolyData& d) {
      return d.GetPointData()->GetArray("smoothing_length")->GetComponent(i, 0);
    };
    different += a != b || value(*skin) != value(*same) ? 1 : 0;
  }
  CHECK(different == 0);

  Cloud moved = cloud;
  for (CloudParticle& p : moved)
    p.place[0] += 0.0123, p.place[1] -= 0.77, p.place[2] += 3;
  const Measures before = measure(*skin), after = measure(*skin_of(to_data(moved)));
  CHECK(after.area == Approx(before.area).epsilon(1e-8));
  CHECK(after.volume == Approx(before.volume).epsilon(1e-8));
}

TEST_CASE("every part has a closed skin of its own, that meet, named after it", "[filters][surface]")
{
  Cloud cloud = made_ball(0.05, 0.005);
  double core = 0;
  for (CloudParticle& p : cloud) {
    p.part = vtkMath::Norm(p.place.data()) < 0.025 ? 1 : 0;
    core += p.part * 0.005 * 0.005 * 0.005;
  }
  auto data = to_data(cloud);
  vtkNew<vtkStringArray> names;
  names->SetName("part_names");
  names->InsertNextValue("torso");
  names->InsertNextValue("lungs");
  data->GetFieldData()->AddArray(names);
  const auto blocks = skins_of(data, [](vtkBirdSurface& f) { f.SurfacePerPartOn(); });
  REQUIRE(blocks->GetNumberOfBlocks() == 2);
  CHECK(std::string(blocks->GetMetaData(0u)->Get(vtkCompositeDataSet::NAME())) == "torso");
  CHECK(std::string(blocks->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME())) == "lungs");
  const Measures torso = measure(*vtkPolyData::SafeDownCast(blocks->GetBlock(0)));
  const Measures lungs = measure(*vtkPolyData::SafeDownCast(blocks->GetBlock(1)));
  CHECK(torso.closed);
  CHECK(lungs.closed);
  CHECK(lungs.volume == Approx(core).epsilon(0.08));
  const Measures whole = measure(*skin_of(data));
  CHECK(torso.volume + lungs.volume == Approx(whole.volume).epsilon(0.03)); // the torso is hollow
}

TEST_CASE("of bird and target the target is passed over; chosen arrays alone come along",
          "[filters][surface]")
{
  const auto plate = made_plate();
  auto run = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const auto bird = to_data(made_ball(0.03, 0.005));
  run->SetBlock(0, bird);
  run->SetBlock(1, plate);
  Messages errors;
  const auto skin = skin_of(run, [&](vtkBirdSurface& f) {
    errors.watch(f);
    f.AllArraysOff();
    f.AddArray("velocity");
  });
  CHECK(errors.text().empty());
  CHECK(skin->GetNumberOfCells() == skin_of(bird)->GetNumberOfCells());
  CHECK(skin->GetPointData()->GetNumberOfArrays() == 2); // and Normals
  CHECK(skin->GetPointData()->GetArray("velocity"));
}

TEST_CASE("particles at no finite place are left out with a message", "[filters][surface]")
{
  Cloud cloud = made_ball(0.03, 0.005);
  const auto whole = skin_of(to_data(cloud));
  const double none = std::numeric_limits<double>::quiet_NaN();
  cloud.push_back({.place = {none, 0, 0}, .h = 0.006});
  cloud.push_back({.place = {0, 0, std::numeric_limits<double>::infinity()}, .h = 0.006});
  cloud.push_back({.place = {0, 0, 0}, .h = 0});
  Messages messages;
  const auto skin = skin_of(to_data(cloud), [&](vtkBirdSurface& f) { messages.watch(f); });
  CHECK_THAT(messages.text(), Contains("3 of"));
  CHECK(skin->GetNumberOfCells() == whole->GetNumberOfCells());
}

TEST_CASE("lone particles that slip through the grid are told of", "[filters][surface]")
{
  Cloud cloud = made_ball(0.02, 0.005);
  const auto highest = [](vtkPolyData& skin) { return skin.GetBounds()[5]; };
  const double before = highest(*skin_of(to_data(cloud)));
  // Ball of radius 0.527 h = 0.5 mm; the grid has 3 mm, none of whose points is there.
  cloud.push_back({.place = {0.0015, 0.0015, 0.1015}, .h = 0.001});
  Messages messages;
  const auto watch = [&](vtkBirdSurface& f) { messages.watch(f); };
  CHECK(highest(*skin_of(to_data(cloud), watch)) == before);
  CHECK_THAT(messages.text(), Contains("1 particles of") && Contains("lower Grid Share"));

  Messages fewer;
  const auto fine = skin_of(to_data(cloud), [&](vtkBirdSurface& f) {
    fewer.watch(f);
    f.SetGridShare(0.1); // 0.6 mm: some point is within the ball
  });
  CHECK(fewer.text().empty());
  CHECK(highest(*fine) == Approx(0.1015 + 0.527e-3).margin(0.2e-3));
}

TEST_CASE("other solvers' particles without a smoothing length take it from the spacing",
          "[filters][surface]")
{
  auto data = to_data(made_ball(0.03, 0.005));
  const auto expected = skin_of(data);
  data->GetPointData()->RemoveArray("smoothing_length");
  Messages messages;
  const auto watch = [&](vtkBirdSurface& f) { messages.watch(f); };
  CHECK(skins_of(data, watch)->GetNumberOfBlocks() == 0);
  CHECK_THAT(messages.text(), Contains("'smoothing_length'") && Contains("set Smoothing Length"));

  vtkNew<vtkDoubleArray> spacing;
  spacing->SetName("spacing");
  spacing->InsertNextValue(0.005);
  data->GetFieldData()->AddArray(spacing);
  Messages taken;
  const auto skin = skin_of(data, [&](vtkBirdSurface& f) { taken.watch(f); });
  CHECK_THAT(taken.text(), Contains("0.006 m is taken"));
  CHECK(skin->GetNumberOfCells() == expected->GetNumberOfCells());
  const auto given = skin_of(data, [&](vtkBirdSurface& f) {
    taken.watch(f);
    f.SetSmoothingLength(0.006);
  });
  CHECK(given->GetNumberOfCells() == expected->GetNumberOfCells());
}

TEST_CASE("what cannot be done leaves an empty output and says why", "[filters][surface]")
{
  const auto bird = to_data(made_ball(0.03, 0.005));
  const auto plate = made_plate();
  const auto message = [](vtkDataObject* data, const std::function<void(vtkBirdSurface&)>& set) {
    Messages errors;
    CHECK(skins_of(data, [&](vtkBirdSurface& f) {
            errors.watch(f);
            set(f);
          })->GetNumberOfBlocks() == 0);
    return errors.text();
  };
  CHECK_THAT(message(bird, [](auto& f) { f.SetLevel(1.5); }),
             Contains("Level is 1.5") && Contains("between"));
  CHECK_THAT(message(bird, [](auto& f) { f.SetGridShare(0); }), Contains("Grid Share is 0"));
  CHECK_THAT(message(plate, [](auto&) {}), Contains("'smoothing_length'"));
  CHECK_THAT(message(to_data({}), [](auto&) {}), Contains("no particle"));
  CHECK_THAT(message(to_data(made_ball(0.05, 0.003)),
                     [](auto& f) {
                       f.SetMemoryLimit(1);
                       f.SetGridShare(0.2);
                     }),
             Contains("does not fit into 1 MB") && Contains("raise Grid Share"));
  CHECK_THAT(message(bird,
                     [](auto& f) {
                       f.SurfacePerPartOn();
                       f.SetPartArrayName("organ");
                     }),
             Contains("'organ'"));
}

TEST_CASE("an array named twice is carried once", "[filters][surface]")
{
  const auto skin = skin_of(to_data(made_ball(0.03, 0.005)), [](vtkBirdSurface& f) {
    f.SetAllArrays(false);
    f.AddArray("mass");
    f.AddArray("mass");
  });
  CHECK(skin->GetPointData()->GetNumberOfArrays() == 2); // and Normals
}

TEST_CASE("what is told on the skin of a particle far smaller than the grid is its own", "[filters][surface]")
{
  // A kernel of 1.2 mm around a point of the grid of 12 mm: the skin lies beyond it on all six edges.
  Cloud cloud = made_ball(0.05, 0.01);
  cloud.push_back({.place = {-0.045, -0.045, 0.243}, .mass = 7, .h = 0.0006});
  const auto skin = skin_of(to_data(cloud), [](vtkBirdSurface& f) { f.SetGridShare(1); });
  auto* mass = skin->GetPointData()->GetArray("mass");
  vtkIdType own = 0;
  for (vtkIdType i = 0; i < mass->GetNumberOfTuples(); ++i) {
    REQUIRE(std::isfinite(mass->GetComponent(i, 0)));
    if (skin->GetPoint(i)[2] > 0.2) {
      CHECK(mass->GetComponent(i, 0) == 7);
      double normal[3];
      skin->GetPointData()->GetNormals()->GetTuple(i, normal);
      CHECK(vtkMath::Norm(normal) == Approx(1));
      ++own;
    }
  }
  CHECK(own == 6);
}

TEST_CASE("the skin can be stopped on the way, and shows how far it is", "[filters][surface]")
{
  vtkNew<vtkBirdSurface> filter;
  filter->SetInputDataObject(to_data(made_ball(0.1, 0.005)));
  std::vector<double> shares;
  const bool stop = GENERATE(false, true);
  vtkNew<vtkCallbackCommand> watch;
  auto context = std::pair(&shares, stop);
  watch->SetClientData(&context);
  watch->SetCallback([](vtkObject* object, unsigned long, void* data, void*) {
    auto& [seen, stops] = *static_cast<std::pair<std::vector<double>*, bool>*>(data);
    auto* self = vtkAlgorithm::SafeDownCast(object);
    seen->push_back(self->GetProgress());
    if (stops && self->GetProgress() > 0.15)
      self->SetAbortExecute(1);
  });
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  if (stop) {
    CHECK(filter->GetOutput()->GetNumberOfBlocks() == 0);
    CHECK(std::count_if(shares.begin(), shares.end(), [](double s) { return s > 0.15 && s < 1; }) == 1);
  } else {
    CHECK(shares.size() > 20);
    CHECK(filter->GetOutput()->GetNumberOfBlocks() == 1);
  }
}
