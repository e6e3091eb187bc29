// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/calculix.h"

#include "tests/core/shell_samples.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace birdstrike::samples {

namespace {

//! Bricks of 20 nodes on a grid of 2 elements + 1 lines each way.
class Bricks
{
public:
  Bricks(const PulsedPlate& plate, int elements, int layers)
      : plate_(plate), elements_(elements), layers_(layers)
  {
    // Corners below, above, then the middles of sides below, above, and upright, as ccx has them.
    constexpr std::array<std::array<int, 3>, 20> places{
        {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
         {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
         {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}};
    for (int k = 0; k < layers; ++k)
      for (int j = 0; j < elements; ++j)
        for (int i = 0; i < elements; ++i) {
          bricks_.emplace_back();
          for (const auto& p : places)
            bricks_.back().push_back(number({2 * i + p[0], 2 * j + p[1], 2 * k + p[2]}));
        }
  }
  void write(std::ostream& out) const
  {
    out.precision(12);
    out << "*NODE,NSET=ALL\n";
    for (const auto& [at, id] : numbers_)
      out << id << ',' << plate_.half_side * plate_.line(0.5 * at[0] / elements_) << ','
          << plate_.half_side * plate_.line(0.5 * at[1] / elements_) << ','
          << plate_.thickness * (0.5 * at[2] / layers_ - 0.5) << '\n';
    out << "*ELEMENT,TYPE=C3D20R,ELSET=PLATE\n";
    for (std::size_t e = 0; e < bricks_.size(); ++e) {
      out << e + 1;
      for (std::size_t k = 0; k < bricks_[e].size(); ++k)
        out << ',' << (k == 12 ? "\n" : "") << bricks_[e][k];
      out << '\n';
    }
    const auto set = [&](const char* name, const auto& holds) {
      out << "*NSET,NSET=" << name << '\n';
      for (const auto& [at, id] : numbers_)
        if (holds(at))
          out << id << ",\n";
    };
    set("X0", [](const Place& p) { return p[0] == 0; });
    set("Y0", [](const Place& p) { return p[1] == 0; });
    set("RIM", [this](const Place& p) { return p[0] == 2 * elements_ || p[1] == 2 * elements_; });
    set("MIDDLE", [this](const Place& p) { return p[0] == 0 && p[1] == 0 && p[2] == layers_; });
    out << "*ELSET,ELSET=TOP,GENERATE\n"
        << elements_ * elements_ * (layers_ - 1) + 1 << ',' << elements_ * elements_ * layers_ << '\n';
  }

private:
  using Place = std::array<int, 3>;
  PulsedPlate plate_;
  int elements_, layers_;
  std::map<Place, int> numbers_;
  std::vector<std::vector<int>> bricks_;

  int number(const Place& p)
  {
    return numbers_.emplace(p, static_cast<int>(numbers_.size()) + 1).first->second;
  }
};

void write_deck(const PulsedPlate& plate, int elements, int layers, double step, const std::string& path)
{
  std::ofstream out(path);
  Bricks(plate, elements, layers).write(out);
  out << "*MATERIAL,NAME=METAL\n*ELASTIC\n"
      << plate.young << ',' << plate.poisson << "\n*DENSITY\n"
      << plate.density << '\n';
  if (plate.hardening)
    out << "*PLASTIC\n"
        << plate.hardening->yield << ",0\n"
        << plate.hardening->yield + 10 * plate.hardening->plastic_modulus << ",10\n";
  out << "*SOLID SECTION,ELSET=PLATE,MATERIAL=METAL\n"
         "*BOUNDARY\nRIM,1,3\nX0,1,1\nY0,2,2\n"
         "*AMPLITUDE,NAME=PULSE\n0,0,"
      << plate.rise << ",1," << 2 * plate.rise << ",0,1,0\n"
      << "*STEP,NLGEOM,INC=100000\n*DYNAMIC,DIRECT,ALPHA=-0.05\n"
      << step << ',' << plate.end << "\n*DLOAD,AMPLITUDE=PULSE\nTOP,P2," << plate.pressure
      << "\n*NODE PRINT,NSET=MIDDLE,FREQUENCY=1\nU\n*END STEP\n";
}

//! "... and time  0.2E-04" a step, then "node ux uy uz".
PlateHistory read_displacements(const std::string& path)
{
  PlateHistory history{{0}, {0}};
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    const std::size_t at = line.find("and time");
    std::istringstream words(at == std::string::npos ? line : line.substr(at + 8));
    double values[4];
    if (at != std::string::npos && words >> values[0])
      history.time.push_back(values[0]);
    else if (words >> values[0] >> values[1] >> values[2] >> values[3])
      history.deflection.push_back(-values[3]);
  }
  return history;
}

} // namespace

double PulsedPlate::line(double u) const { return 1 - std::pow(1 - u, 1.5); }

PlateHistory run_calculix(const PulsedPlate& plate, int elements, int layers, double step,
                          const std::string& name)
{
  if (std::system("command -v ccx > /dev/null 2>&1") != 0)
    throw std::runtime_error(
        "CalculiX is needed for this test and its program ccx is not there: apt-get install calculix-ccx, or "
        "share/install-dependencies");
  const std::filesystem::path folder = std::filesystem::current_path() / "calculix" / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  write_deck(plate, elements, layers, step, (folder / "plate.inp").string());
  const std::string command =
      "cd '" + folder.string() + "' && OMP_NUM_THREADS=1 timeout 900 ccx plate > ccx.log 2>&1";
  if (const int status = std::system(command.c_str()); status != 0)
    throw std::runtime_error("ccx ended with status " + std::to_string(status) + "; see " +
                             (folder / "ccx.log").string());
  const PlateHistory history = read_displacements((folder / "plate.dat").string());
  if (history.time.size() != history.deflection.size() || history.time.back() < 0.999 * plate.end)
    throw std::runtime_error("ccx did not come to the end; see " + (folder / "ccx.log").string());
  return history;
}

PlateHistory run_shells(const PulsedPlate& plate, int elements, int points, bool triangles,
                        double& hourglass_share)
{
  const ShellMesh mesh = patch(
      elements, elements,
      [&](double u, double v) {
        return Vector3(plate.half_side * plate.line(u), plate.half_side * plate.line(v), 0);
      },
      triangles);
  ShellMaterial metal = elastic(plate.young, plate.poisson, plate.density);
  if (plate.hardening)
    metal.hardening = *plate.hardening;
  ShellLoads loads;
  loads.surfaces.push_back({plate.pressure});
  loads.surfaces[0].history = [rise = plate.rise](double t) {
    return std::max(0.0, 1 - std::abs(t - rise) / rise);
  };
  Shells s(mesh, {{metal, plate.thickness, points}},
           {clamped(nodes_of(mesh, {"u1", "v1"})), symmetric(mesh.node_sets.at("u0"), 0),
            symmetric(mesh.node_sets.at("v0"), 1)},
           loads);
  PlateHistory history{{0}, {0}};
  hourglass_share = 0;
  run(s, plate.end, [&](double time) {
    history.time.push_back(time);
    history.deflection.push_back(-s.position[0].z());
    const ShellEnergy e = s.energy();
    if (time > 2 * plate.rise)
      hourglass_share = std::max(hourglass_share, e.hourglass / e.internal);
  });
  return history;
}

} // namespace birdstrike::samples
