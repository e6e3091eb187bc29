// SPDX-License-Identifier: BSD-3-Clause
// A made-up bird, plate and folder for the tests of vtkio.
#pragma once

#include "core/contact/rigid_plate.h"
#include "core/particles/particles.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <unistd.h>

//! A folder that is gone after the test.
struct TemporaryFolder
{
  std::filesystem::path path;
  TemporaryFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "birdstrike-test-XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

//! A bird of ellipsoids with seven parts in front of x = 0, 0.5 m long; rows are not in the order of ids.
//! \param late  from 0 (whole) to 1 (spread over the plate)
inline birdstrike::Particles made_bird(double spacing, double late = 0)
{
  using namespace birdstrike;
  struct Ellipsoid
  {
    const char* name;
    Vector3 centre, half;
  };
  const Ellipsoid shapes[] = {
      {"lungs", {-0.23, 0, 0.015}, {0.05, 0.035, 0.02}},
      {"bones", {-0.26, 0, 0.035}, {0.15, 0.012, 0.012}},
      {"head", {-0.045, 0, 0.06}, {0.035, 0.025, 0.025}},
      {"neck", {-0.1, 0, 0.04}, {0.06, 0.02, 0.022}},
      {"torso", {-0.28, 0, 0}, {0.16, 0.08, 0.075}},
      {"wings_left", {-0.27, 0.2, 0.03}, {0.07, 0.14, 0.012}},
      {"wings_right", {-0.27, -0.2, 0.03}, {0.07, 0.14, 0.012}},
  };
  Particles bird;
  for (const Ellipsoid& shape : shapes)
    bird.parts.push_back({shape.name, Linear{950, 2e9}, 0, 0});
  for (double x = -0.5; x < 0; x += spacing)
    for (double y = -0.4; y < 0.4; y += spacing)
      for (double z = -0.2; z < 0.2; z += spacing) {
        const Vector3 p(x, y, z);
        for (std::size_t k = 0; k < std::size(shapes); ++k)
          if ((p - shapes[k].centre).cwiseQuotient(shapes[k].half).norm() < 1) {
            bird.x.push_back(x), bird.y.push_back(y), bird.z.push_back(z);
            bird.part.push_back(static_cast<std::uint8_t>(k));
            break;
          }
      }
  const std::size_t count = bird.x.size();
  bird.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    bird.id[i] = static_cast<std::int32_t>((i + count / 3) % count);
    bird.mass[i] = 950 * std::pow(spacing, 3);
    bird.density[i] = 950;
    bird.vx[i] = 150 + 0.1 * static_cast<double>(i);
    bird.vy[i] = std::sin(static_cast<double>(i));
    bird.vz[i] = -1.0 / (1.0 + static_cast<double>(i));
    bird.energy[i] = 1e3 * bird.z[i];
    bird.sound_speed[i] = 1450;
    bird.smoothing_length[i] = 1.2 * spacing;
    bird.x[i] += 0.5 * late;
    if (bird.x[i] > -spacing) { // what has arrived flows along the plate
      const double radius = std::hypot(bird.y[i], bird.z[i]) + 1e-9, out = 1 + 2 * (bird.x[i] + spacing);
      bird.y[i] *= out + 0.3 * late * 0.05 / radius;
      bird.z[i] *= out + 0.3 * late * 0.05 / radius;
      bird.x[i] = -spacing * (1 + 8 * std::abs(std::sin(40 * radius)));
    }
    bird.pressure[i] = 40e6 * std::exp(bird.x[i] / 0.05) * std::abs(std::cos(25 * bird.z[i])) - 0.3e6;
  }
  return bird;
}

inline birdstrike::RigidPlate made_plate()
{
  birdstrike::RigidPlate plate = birdstrike::make_rigid_plate(0.6, 0.5, 0.01, 12, 10);
  for (int k = 0; k < plate.element_count(); ++k) {
    const auto e = static_cast<std::size_t>(k);
    plate.force[e] = {1000.0 / (k + 1), 0.1 * k, -k / 3.0};
    plate.impulse[e] = 1e-3 * plate.force[e];
    plate.peak_pressure[e] = 2 * plate.force[e][0] / plate.element_area();
  }
  return plate;
}
