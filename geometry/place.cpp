// SPDX-License-Identifier: GPL-3.0-or-later
// Where a bird starts and which way it looks.
#include "geometry/place.h"

#include "core/error.h"
#include "geometry/measure.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace birdstrike {

namespace {

Eigen::Matrix3d turn_of(const Attitude& attitude)
{
  using Turn = Eigen::AngleAxisd;
  // A right-handed turn about y lowers the head, hence the sign of pitch.
  return (Turn(attitude.yaw, Vector3::UnitZ()) * Turn(-attitude.pitch, Vector3::UnitY()) *
          Turn(attitude.roll, Vector3::UnitX()))
      .toRotationMatrix();
}

} // namespace

void rotate(SurfaceMesh& mesh, const Attitude& attitude)
{
  if (attitude.yaw == 0 && attitude.pitch == 0 && attitude.roll == 0)
    return;
  const Eigen::Matrix3d turn = turn_of(attitude);
  for (SurfacePart& part : mesh)
    for (Vector3& p : part.points)
      p = turn * p;
}

void rotate(std::vector<Seed>& seeds, const Attitude& attitude)
{
  if (seeds.empty())
    return;
  const Eigen::Matrix3d turn = turn_of(attitude);
  Vector3 centre = Vector3::Zero();
  for (const Seed& seed : seeds)
    centre += seed.position;
  centre /= double(seeds.size());
  for (Seed& seed : seeds)
    seed.position = centre + turn * (seed.position - centre);
}

void move_in_front(std::vector<Seed>& seeds, double gap)
{
  require(!seeds.empty(), "there are no particles to place in front of the target");
  double foremost = seeds.front().position.x();
  for (const Seed& seed : seeds)
    foremost = std::max(foremost, seed.position.x());
  for (Seed& seed : seeds)
    seed.position.x() = (seed.position.x() - foremost) - gap; // exact for the foremost
}

void translate(std::vector<Seed>& seeds, const Vector3& by)
{
  for (Seed& seed : seeds)
    seed.position += by;
}

void translate(SurfaceMesh& mesh, const Vector3& by)
{
  for (SurfacePart& part : mesh)
    for (Vector3& p : part.points)
      p += by;
}

void scale(SurfaceMesh& mesh, double factor)
{
  require(factor > 0, "the scale of a mesh must be positive");
  for (SurfacePart& part : mesh)
    for (Vector3& p : part.points)
      p *= factor;
}

void recentre(SurfaceMesh& mesh) { translate(mesh, -bounding_box(mesh).centre()); }

} // namespace birdstrike
