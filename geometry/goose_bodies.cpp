// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes of a goose's parts as implicit bodies.
#include "geometry/anatomy.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace birdstrike {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double wing_nose =
    0.7; // radius of a wing section's nose over half its thickness; blunt, as a bird's arm is

Vector3 mirrored(const Vector3& p) { return {p.x(), std::abs(p.y()), p.z()}; }

Implicit head_body(const GooseAnatomy& a)
{
  const Implicit bill = chain(a.bill, 4);
  const double middle = a.bill.back().centre.z(), flat = a.bill_flatness;
  // A bill is wider than high at its tip: stretch z there before asking the round one.
  const Implicit flat_bill = [=](const Vector3& p) {
    return bill({p.x(), p.y(), middle + (p.z() - middle) / flat});
  };
  return unite({ellipsoid(a.skull_centre, a.skull_axes), ellipsoid(a.brow_centre, a.brow_axes), flat_bill},
               a.head_blend);
}

Implicit wing_body(const GooseAnatomy& a)
{
  std::vector<double> y, front, rear, z, thickness;
  for (const WingSection& s : a.wing) {
    y.push_back(s.y);
    front.push_back(s.leading_edge);
    rear.push_back(s.trailing_edge);
    z.push_back(s.z);
    thickness.push_back(s.thickness);
  }
  const MonotoneCurve x_front(y, front), x_rear(y, rear), z_chord(y, z), full(y, thickness);
  const double tip = y.back(), root = y.front(), camber = a.wing_camber, thin = a.wing_trailing_radius;
  return [=](const Vector3& p) {
    const double at = std::clamp(p.y(), root, tip), beyond = p.y() - at;
    const double chord = x_front(at) - x_rear(at), thick = 0.5 * full(at), nose = wing_nose * thick;
    // The section is what balls along its middle line sweep; the one above or below the point stands for all.
    const double share = std::clamp((x_front(at) - p.x()) / chord, nose / chord, 1 - thin / chord);
    const double top = 0.4, to_top = (share - top) / (share < top ? top : 1 - top);
    const double rise = camber * chord * (1 - to_top * to_top);
    const double widest = 0.28, along = (share - widest) / (share < widest ? widest : 1 - widest);
    const double radius = share < widest ? nose + (thick - nose) * (1 - along * along)
                                         : thin + (thick - thin) * (1 - std::pow(along, 1.6));
    const double value =
        std::hypot(p.x() - (x_front(at) - share * chord), p.z() - (z_chord(at) + rise)) - radius;
    return beyond != 0 ? std::hypot(std::max(value + thin, 0.0), beyond) - thin : value;
  };
}

//! Where a ray from the torso's middle line crosses the level -depth of the torso.
class Skin
{
public:
  Skin(const GooseAnatomy& a, Implicit torso) : torso_(std::move(torso))
  {
    std::vector<double> x, z;
    for (const Section& s : a.torso) {
      x.push_back(s.x);
      z.push_back(s.middle);
    }
    middle_ = std::make_shared<MonotoneCurve>(x, z);
  }
  //! \param angle  0 is sideways (+y), pi/2 is up
  Vector3 below(double depth, double x, double angle) const
  {
    const Vector3 start{x, 0, (*middle_)(x)}, direction{0, std::cos(angle), std::sin(angle)};
    double inside = 0, outside = 0.3;
    for (int i = 0; i < 40; ++i) {
      const double half = 0.5 * (inside + outside);
      (torso_(start + half * direction) < -depth ? inside : outside) = half;
    }
    return start + inside * direction;
  }

private:
  Implicit torso_;
  std::shared_ptr<MonotoneCurve> middle_;
};

Implicit rod_along(const std::vector<Vector3>& line, double radius)
{
  std::vector<Ball> balls;
  for (const Vector3& p : line)
    balls.push_back({p, radius});
  return chain(balls, 3);
}

//! A body that costs little to ask far away from it: the distance to a box around it stands in.
Implicit bounded(Implicit body, const std::vector<Vector3>& line, double reach)
{
  Vector3 lower = line.front(), upper = line.front();
  for (const Vector3& p : line) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  return [=, body = std::move(body)](const Vector3& p) {
    const Vector3 outside = (lower - p).cwiseMax(p - upper).cwiseMax(0.0);
    const double away = outside.norm();
    return away > 2 * reach ? away - reach : body(p);
  };
}

std::vector<Vector3> rib_line(const GooseAnatomy& a, const Skin& skin, double x, double sternum_z)
{
  std::vector<Vector3> line;
  constexpr int steps = 9;
  for (int i = 0; i <= steps; ++i) {
    const double share = double(i) / steps, angle = pi / 2 - share * pi * 0.80;
    const double here = x - a.rib_sweep * std::sin(0.5 * pi * share);
    // Out of the spine it rises to its own depth below the skin.
    const double depth = a.rib_depth + (a.spine_depth - a.rib_depth) * std::max(0.0, 1 - 3 * share);
    const Vector3 p = skin.below(depth, here, angle);
    if (p.z() < sternum_z + 3 * a.rib_radius) // leaves the wall for the plate of the sternum
      break;
    line.push_back(p);
  }
  const double end = std::clamp(line.back().x(), a.sternum_rear + 0.015, a.sternum_front - 0.020);
  line.push_back({end, 0.75 * a.sternum_half_width, sternum_z});
  return line;
}

Implicit bones_body(const GooseAnatomy& a, const Skin& skin)
{
  std::vector<Implicit> bones;
  std::vector<Vector3> spine;
  constexpr int steps = 14;
  for (int i = 0; i <= steps; ++i)
    spine.push_back(
        skin.below(a.spine_depth, a.spine_rear + (a.spine_front - a.spine_rear) * i / steps, pi / 2));
  bones.push_back(rod_along(spine, a.spine_radius));

  Vector3 pelvis = skin.below(a.spine_depth, a.pelvis_x, pi / 2);
  bones.push_back(ellipsoid(pelvis, a.pelvis_axes));

  // The sternum's plate: a flat ellipsoid; its keel: a blade of rods down to just above the skin of the
  // breast.
  const double middle_x = 0.5 * (a.sternum_front + a.sternum_rear);
  const double half_length = 0.5 * (a.sternum_front - a.sternum_rear);
  const double sternum_z = skin.below(0, middle_x, -pi / 2).z() + a.sternum_height;
  bones.push_back(elliptic_plate({middle_x, 0, sternum_z}, half_length, a.sternum_half_width, a.rib_radius));
  std::vector<Vector3> keel;
  for (int i = 0; i <= 8; ++i) {
    const double x = a.sternum_rear + 0.02 + (2 * half_length - 0.03) * i / 8;
    Vector3 edge = skin.below(a.keel_depth + a.rib_radius, x, -pi / 2);
    const double share = i / 8.0; // deep in front, running out towards the rear
    edge.z() = sternum_z + (edge.z() - sternum_z) * std::clamp(0.25 + 1.6 * share, 0.0, 1.0);
    keel.push_back(edge);
  }
  const double half_blade = a.rib_radius;
  bones.push_back([=](const Vector3& p) {
    const double at = std::clamp(p.x(), keel.front().x(), keel.back().x());
    const auto next = std::upper_bound(keel.begin() + 1, keel.end() - 1, at,
                                       [](double x, const Vector3& k) { return x < k.x(); });
    const Vector3 &k0 = *(next - 1), &k1 = *next;
    const double low = k0.z() + (k1.z() - k0.z()) * (at - k0.x()) / (k1.x() - k0.x());
    const double z = std::clamp(p.z(), std::min(low, sternum_z), sternum_z);
    return Vector3(p.x() - at, p.y(), p.z() - z).norm() - half_blade;
  });

  for (int r = 0; r < a.rib_pairs; ++r) {
    const double x = a.first_rib + (a.last_rib - a.first_rib) * r / (a.rib_pairs - 1);
    const auto line = rib_line(a, skin, x, sternum_z);
    bones.push_back(bounded(rod_along(line, a.rib_radius), line, 0.02));
  }
  // Coracoid: from the sternum's front up to the shoulder joint.
  const std::vector<Vector3> coracoid{{a.sternum_front - 0.012, 0.010, sternum_z},
                                      {a.sternum_front - 0.002, 0.035, 0.5 * (sternum_z + 0.03)},
                                      {a.sternum_front - 0.018, 0.052, 0.030}};
  bones.push_back(bounded(rod_along(coracoid, a.rib_radius + 0.0005), coracoid, 0.02));
  const Implicit all = unite(bones, a.bone_blend);
  return [=](const Vector3& p) { return all(mirrored(p)); };
}

} // namespace

GooseBodies make_goose_bodies(const GooseAnatomy& a)
{
  GooseBodies goose;
  goose.torso = loft(a.torso, a.torso_exponent, a.edge_radius);
  goose.neck = chain(a.neck, 5);
  goose.head = head_body(a);
  goose.wing = cut(wing_body(a), goose.torso, -a.wing_overlap, a.cut_blend);
  goose.bones = bones_body(a, Skin(a, goose.torso));
  const Implicit lobe = ellipsoid(a.lung_centre, a.lung_axes);
  goose.lungs =
      cut([=](const Vector3& p) { return lobe(mirrored(p)); }, goose.bones, a.lung_clearance, a.cut_blend);
  return goose;
}

} // namespace birdstrike
