// SPDX-License-Identifier: BSD-3-Clause
#include "core/gauges/target_history.h"

#include "shell_samples.h"

#include <catch2/catch.hpp>

#include <set>

using namespace birdstrike;

namespace {

//! The only row, by name.
struct Row
{
  History history;

  Row(const MeshTarget& target, const std::vector<DeflectionGauge>& points, const Ledger& ledger, long leaked,
      double time = 0)
  {
    add_target_columns(history, points);
    record_target(history, target, points, ledger, leaked, time);
    REQUIRE(history.values.size() == history.columns.size());
  }
  double operator[](const std::string& name) const
  {
    const std::size_t column = history.find(name);
    INFO(name);
    REQUIRE(column < history.columns.size());
    return history.at(0, column);
  }
};

} // namespace

TEST_CASE("columns of a target have names of their own and units", "[target_history]")
{
  History history;
  add_target_columns(history, {{"middle", 0}, {"tip", 1}});
  std::set<std::string> names;
  for (const auto& column : history.columns) {
    CHECK(names.insert(column.name).second);
    CHECK_FALSE(column.unit.empty());
  }
  CHECK(history.columns[history.find("deflection_tip")].unit == "m");
  CHECK(history.columns[history.find("plastic_energy")].unit == "J");
  CHECK(history.columns[history.find("support_impulse_z")].unit == "N s");
}

TEST_CASE("the largest deflection has its length and the place before the load", "[target_history]")
{
  MeshTarget target = samples::strip();
  const std::size_t dent = samples::node_at(target.mesh(), {0, 0.2, 0.1});
  target.shells()->position[dent] += Vector3(0.003, -0.004, 0);
  const Row row(target, {{"dent", dent}, {"corner", 0}}, {}, 0);
  CHECK(row["max_deflection"] == Approx(0.005));
  CHECK(row["max_deflection_x"] == 0);
  CHECK(row["max_deflection_y"] == Approx(0.2));
  CHECK(row["max_deflection_z"] == Approx(0.1));
  CHECK(row["deflection_dent"] == Approx(0.003)); // along x, with its sign
  CHECK(row["deflection_corner"] == 0);
}

TEST_CASE("fragments of eroded elements are no deflection", "[target_history]")
{
  MeshTarget target = samples::strip();
  const std::size_t end = samples::node_at(target.mesh(), {0, 0.4, 0});
  target.shells()->position[end] += Vector3(5, 0, 0); // torn off with the last element
  target.shells()->position[0] += Vector3(0.001, 0, 0);
  CHECK(Row(target, {}, {}, 0)["max_deflection"] == Approx(5));
  target.shells()->gone[3] = 1;
  const Row row(target, {{"end", end}}, {}, 0);
  CHECK(row["max_deflection"] == Approx(0.001));
  CHECK(row["deflection_end"] == Approx(5)); // a gauge follows its node wherever it goes
}

TEST_CASE("a target that only spins has no deflection", "[target_history]")
{
  ShellMesh mesh = samples::patch(4, 1, [](double u, double v) { return Vector3(0, 0.4 * u, 0.1 * v); });
  ShellSettings settings;
  settings.spin = SteadySpin{Vector3(0, 0, -0.5), {300, 0, 0}};
  MeshTarget target(
      Shells(std::move(mesh), {{samples::elastic(70e9, 0.3, 2700), 0.002, 3}}, {}, {}, settings));
  const Vector3 from = target.position(0) - settings.spin->centre;
  const double angle = 300 * 2e-3;
  for (Vector3& point : target.shells()->position) {
    const Vector3 arm = point - settings.spin->centre;
    point = settings.spin->centre + Vector3(arm[0], std::cos(angle) * arm[1] - std::sin(angle) * arm[2],
                                            std::sin(angle) * arm[1] + std::cos(angle) * arm[2]);
  }
  CHECK((target.position(0) - settings.spin->centre - from).norm() > 0.2);
  CHECK(Row(target, {{"root", 0}}, {}, 0, 2e-3)["max_deflection"] < 1e-14);
}

TEST_CASE("what the ledger books goes into its columns", "[target_history]")
{
  Ledger ledger;
  ledger.target = {
      .kinetic = 1, .internal = 2, .plastic = 3, .hourglass = 4, .damped = 5, .eroded = 6, .external = 7};
  ledger.contact = 8;
  ledger.friction = 9;
  ledger.support_impulse = {10, 11, 12};
  const Row row(samples::strip(), {}, ledger, 13);
  CHECK(row["target_kinetic_energy"] == 1);
  CHECK(row["target_internal_energy"] == 2);
  CHECK(row["plastic_energy"] == 3);
  CHECK(row["hourglass_energy"] == 4);
  CHECK(row["eroded_energy"] == 6);
  CHECK(row["external_work"] == 7);
  CHECK(row["contact_energy"] == 8);
  CHECK(row["friction_energy"] == 9);
  CHECK(row["support_impulse_x"] == 10);
  CHECK(row["support_impulse_y"] == 11);
  CHECK(row["support_impulse_z"] == 12);
  CHECK(row["leaked_particles"] == 13);
  CHECK(row["eroded_elements"] == 0);
}

TEST_CASE("a rigid mesh has the columns, and zeros in them", "[target_history]")
{
  ShellMesh mesh = samples::patch(2, 2, [](double u, double v) { return Vector3(0.1, u, v); });
  mesh.parts.front().thickness = 0.002;
  const Row row(MeshTarget(mesh), {{"here", 3}}, {}, 0);
  CHECK(row["max_deflection"] == 0);
  CHECK(row["deflection_here"] == 0);
  CHECK(row["eroded_elements"] == 0);
}
