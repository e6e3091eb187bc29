// SPDX-License-Identifier: GPL-3.0-or-later
// Birds made from numbers: parts are made, weighed and fitted together.
#include "geometry/species.h"

#include "core/error.h"
#include "geometry/birds/legs.h"
#include "geometry/birds/slab.h"
#include "geometry/birds/wings.h"
#include "geometry/check.h"
#include "geometry/mesh_implicit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace birdstrike {

namespace {

// Edge lengths at detail 0 over the torso's radius, about those of the goose of geometry/anatomy.h.
constexpr double torso_share = 0.100, head_share = 0.062, neck_share = 0.075, wing_share = 0.110,
                 lungs_share = 0.080;
constexpr double overlap_share = 0.06;      // how far parts reach into each other, over the torso's radius
constexpr double goose_torso_density = 412; // torso with bones and lungs of that goose [kg/m3]: a first guess

std::string kilograms(double mass)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.4g kg", mass);
  return text;
}

double wanted_mass(const BirdForm& form, const Biometry& size)
{
  return form.mass == 0 ? size.mass.typical : form.mass;
}

void check(const BirdForm& form, const Biometry& size)
{
  const std::string range = kilograms(size.mass.least) + " to " + kilograms(size.mass.largest);
  const double mass = wanted_mass(form, size);
  require(std::isfinite(mass) && mass >= 0.5 * size.mass.least && mass <= 2 * size.mass.largest,
          "a " + std::string(size.english) + " of " + kilograms(form.mass) +
              " cannot be made: the species weighs " + range +
              "; allowed is half to twice that, or take another species");
  const double length = size.length.typical * std::cbrt(mass / size.mass.typical);
  require(std::isfinite(form.detail) && (form.detail == 0 || form.detail >= 1e-3 * length),
          "the detail of a bird is the edge length of its triangles: 0 (by size) or at least a thousandth of "
          "the bird's length");
}

//! Volume that lies in both bodies, by a grid of points.
double common_volume(const Implicit& a, const Implicit& b, const Box& box)
{
  constexpr int steps = 48;
  const Vector3 cell = (box.upper - box.lower) / steps;
  long count = 0;
#pragma omp parallel for reduction(+ : count)
  for (int k = 0; k < steps; ++k)
    for (int j = 0; j < steps; ++j)
      for (int i = 0; i < steps; ++i) {
        const Vector3 p = box.lower + cell.cwiseProduct(Vector3(i + 0.5, j + 0.5, k + 0.5));
        count += a(p) < 0 && b(p) < 0;
      }
  return double(count) * cell.prod();
}

//! mesh_implicit, and again a little finer where its last step folded the surface over
//! itself, or a thin end came off.
SurfacePart sound_mesh(const std::string& name, const Implicit& body, const Box& box, double edge,
                       std::size_t pieces = 1)
{
  for (int attempt = 0;; ++attempt) {
    SurfacePart part = mesh_implicit(name, body, box, edge);
    const SurfaceReport report = check_surface(part);
    if (report.closed && report.oriented && !report.self_intersecting && report.components == pieces)
      return part;
    require(attempt < 5,
            "the bird's part '" + name + "' cannot be meshed soundly; change the detail a little");
    edge *= 0.94;
  }
}

void stretch_across(SurfacePart& part, double factor)
{
  for (Vector3& p : part.points) {
    p.y() *= factor;
    p.z() *= factor;
  }
}

MonotoneCurve middle_line(const GooseAnatomy& a, double factor)
{
  std::vector<double> x, z;
  for (const Section& s : a.torso) {
    x.push_back(s.x);
    z.push_back(factor * s.middle);
  }
  return {x, z};
}

//! The torso's mean radius of a bird of mean mass, by a first guess of the torso's density; head and neck weigh
//! some 7 %.
double radius_of(const Biometry& size, const Proportions& shape)
{
  const double volume = (0.93 - shape.wing_share) * size.mass.typical / goose_torso_density;
  double low = 0.01 * size.length.typical, high = 0.5 * size.length.typical;
  for (int i = 0; i < 50; ++i) {
    const double half = 0.5 * (low + high);
    (torso_volume(size, shape, half) < volume ? low : high) = half;
  }
  return low;
}

//! All lengths times a factor, masses with its cube.
Biometry magnified(Biometry size, double factor)
{
  for (Published Biometry::*length :
       {&Biometry::length, &Biometry::wingspan, &Biometry::wing_chord, &Biometry::bill, &Biometry::tarsus})
    (size.*length).typical *= factor;
  size.wing_area *= factor * factor;
  size.mass.typical *= std::pow(factor, 3);
  return size;
}

//! The bird at the mean mass of its species.
class Maker
{
public:
  //! \param size  made as large as the goose by magnified()
  Maker(const BirdForm& form, const Biometry& size, double detail)
      : form_(form), size_(size), shape_(proportions_of(size.name)), detail_(detail)
  {
  }

  SurfaceMesh run()
  {
    const double mass = size_.mass.typical, wings = shape_.wing_share * mass;
    // First guess of the girth: head and neck weigh some 7 %.
    const double radius = radius_of(size_, shape_);
    const GooseAnatomy a = body_anatomy(size_, shape_, form_.neck, radius);
    GooseBodies bodies = make_goose_bodies(a);
    const HeadJoint joint = head_joint(a);
    const double neck_from = body_frame(size_, shape_, radius).front - overlap_share * radius;
    bodies.neck = between(bodies.neck, neck_from, joint.neck_to, 0.04 * radius);
    bodies.head = between(bodies.head, joint.head_from, size_.length.typical, 0.04 * radius);
    const double margin = 0.4 * radius, rib = a.rib_radius;
    const double fine_tail = 1.9 * a.edge_radius,
                 fine_bill = 1.5 * std::min(1.0, a.bill_flatness) * a.bill.back().radius;
    SurfacePart head =
        sound_mesh("head", bodies.head, head_box(a, 0.3 * radius), edge(head_share * radius, fine_bill));
    SurfacePart neck = sound_mesh("neck", bodies.neck, neck_box(a, 0.3 * radius),
                                  edge(neck_share * radius, 0.6 * a.neck.back().radius));
    SurfacePart torso =
        sound_mesh("torso", bodies.torso, torso_box(a, margin), edge(torso_share * radius, fine_tail));
    SurfacePart bones = sound_mesh("bones", bodies.bones, torso_box(a, 0), edge(1.2 * rib, 1.25 * rib));
    SurfacePart lungs =
        sound_mesh("lungs", bodies.lungs, torso_box(a, 0), edge(lungs_share * radius, 0.25 * radius), 2);

    // Legs stand below the torso and weigh little: made before the torso is fitted to the mass.
    SurfaceMesh legs;
    if (form_.legs) {
      const BodyFrame f = body_frame(size_, shape_, radius);
      legs.push_back(left_leg(size_, shape_, f, middle_line(a, 1)(0), edge(0.08 * radius, radius)));
      legs.push_back(mirrored_left_right(legs[0], "leg_right"));
    }

    // What is still missing is the torso's; points that head or neck share with it are theirs.
    const Box around_neck = neck_box(a, 0);
    const double in_torso = common_volume(bodies.neck, bodies.torso, around_neck);
    const double in_head = common_volume(bodies.neck, bodies.head, around_neck);
    double rest = mass - wings - 700 * (signed_volume(head) + signed_volume(neck) - in_head) + 400 * in_torso;
    for (const SurfacePart& leg : legs)
      rest -= 800 * signed_volume(leg);
    const double vb = signed_volume(bones), vl = signed_volume(lungs);
    const double weight = 400 * (signed_volume(torso) - vb - vl) + 800 * vb + 200 * vl;
    const double factor = std::sqrt(rest / weight);
    for (SurfacePart* part : {&torso, &bones, &lungs})
      stretch_across(*part, factor);

    // A folded wing lies on the torso with all of its length: it may not eat much of it.
    const bool folded = form_.wings == WingPose::folded;
    const WingSite site{body_frame(size_, shape_, factor * radius), stretched_across(bodies.torso, factor),
                        middle_line(a, factor), (folded ? 0.4 : 1) * overlap_share * radius,
                        edge(wing_share * radius, radius)};
    const double volume = 0.5 * wings / 300;
    SurfacePart wing = folded ? folded_wing(site, volume)
                              : open_wing(size_, shape_, form_.wings == WingPose::half_folded, site, volume);
    SurfaceMesh bird{head, neck, torso, wing, mirrored_left_right(wing, "wing_right"), bones, lungs};
    bird.insert(bird.end(), legs.begin(), legs.end());
    return bird;
  }

private:
  double edge(double by_size, double finest_needed) const
  {
    return std::min(detail_ > 0 ? detail_ : by_size, finest_needed);
  }

  const BirdForm& form_;
  Biometry size_;
  const Proportions& shape_;
  double detail_;
};

} // namespace

std::vector<std::string_view> species_names()
{
  std::vector<std::string_view> names;
  for (const Biometry& b : biometry_table())
    names.push_back(b.name);
  return names;
}

SurfaceMesh make_bird(const BirdForm& form)
{
  const Biometry& size = biometry_of(form.species);
  check(form, size);
  // Made with the girth of the goose, for whose size the anatomy of its bones is written; then scaled.
  const double magnification = goose_radius / radius_of(size, proportions_of(size.name));
  const double scale = std::cbrt(wanted_mass(form, size) / size.mass.typical) / magnification;
  SurfaceMesh bird = Maker(form, magnified(size, magnification), form.detail / scale).run();
  for (SurfacePart& part : bird)
    for (Vector3& p : part.points)
      p *= scale;
  return bird;
}

std::string mass_remark(const BirdForm& form)
{
  const Biometry& size = biometry_of(form.species);
  const double mass = wanted_mass(form, size);
  if (mass >= size.mass.least && mass <= size.mass.largest)
    return {};
  return "a " + std::string(size.english) + " weighs " + kilograms(size.mass.least) + " to " +
         kilograms(size.mass.largest) + ", not " + kilograms(mass) +
         "; it is scaled, lengths by the cube root of mass";
}

} // namespace birdstrike
