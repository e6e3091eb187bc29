// SPDX-License-Identifier: GPL-3.0-or-later
// Legs that trail below the tail in flight.
#include "geometry/birds/legs.h"

#include "geometry/mesh_implicit.h"

#include <algorithm>

namespace birdstrike {

SurfacePart left_leg(const Biometry& size, const Proportions& shape, const BodyFrame& f, double middle,
                     double edge)
{
  // Everything but the tarsus' length is chosen.
  const double tarsus = size.tarsus.typical, bone = 0.062 * tarsus, y = 0.42 * f.half_width;
  const double belly = middle - f.half_height;
  const Vector3 hip(-0.10 * f.core, y, belly + 0.30 * f.half_height);
  const Vector3 ankle(-0.34 * f.core, y, belly - 0.05 * f.half_height);
  const Vector3 back = Vector3(-1, 0, 0.06).normalized(), foot = ankle + tarsus * back;
  const double thigh = std::max(0.16 * f.radius, 1.4 * bone);
  std::vector<Implicit> pieces{
      chain({{hip, thigh}, {0.5 * (hip + ankle), 0.85 * thigh}, {ankle, 1.25 * bone}}, 4),
      chain({{ankle, 1.25 * bone}, {foot, bone}}, 1)};
  Vector3 lower = ankle.cwiseMin(hip), upper = ankle.cwiseMax(hip);
  const double toe = 0.85 * tarsus;
  for (double turn : {-0.30, 0.0, 0.30}) {
    const Vector3 tip = foot + toe * (1 - 0.4 * turn * turn) * Vector3(-1, turn, -0.10).normalized();
    pieces.push_back(chain({{foot, bone}, {tip, 0.75 * bone}}, 1));
    lower = lower.cwiseMin(tip);
    upper = upper.cwiseMax(tip);
  }
  if (shape.webbed) {
    const Vector3 web = foot + 0.50 * toe * Vector3(-1, 0, -0.10).normalized();
    const Implicit plate = elliptic_plate(Vector3::Zero(), 0.44 * toe, 0.20 * toe, 0.7 * bone);
    pieces.push_back([=](const Vector3& p) {
      const Vector3 d = p - web; // tilted as the toes are
      return 0.99 * plate({d.x(), d.y(), d.z() - 0.10 * d.x()});
    });
  }
  const double margin = 2 * thigh, fine = std::min(edge, 1.1 * bone);
  const Box box{lower - Vector3::Constant(margin), upper + Vector3::Constant(margin)};
  return mesh_implicit("leg_left", unite(pieces, 0.6 * bone), box, fine);
}

} // namespace birdstrike
