// SPDX-License-Identifier: GPL-3.0-or-later
// Head, neck, torso, bones and lungs of a species.
#include "geometry/birds/body.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

namespace {

constexpr double before_thickest = 0.45; // share of the core that lies ahead of its thickest section

// The core: half width, half height and middle over those of the thickest section, by place from rear to front.
struct CoreRow
{
  double along, width, height, middle;
};
constexpr CoreRow core_rows[] = {
    {0.00, 0.52, 0.24, 0.30},  {0.10, 0.60, 0.42, 0.20},  {0.24, 0.79, 0.70, 0.05}, {0.40, 0.94, 0.91, -0.08},
    {0.55, 1.00, 1.00, -0.13}, {0.70, 0.97, 0.96, -0.10}, {0.82, 0.83, 0.83, 0.00}};
constexpr double front_middle = 0.22; // of the core's front end, likewise

// The goose of geometry/anatomy.h, from whose bones and lungs those of the others are scaled.
constexpr double goose_core = 0.465;

std::vector<Section> torso_sections(const BodyFrame& f, const Proportions& shape, double length)
{
  const double tail = f.rear - f.tail_tip, thin = shape.tail_half_thickness * length;
  const double rear_middle = core_rows[0].middle * f.half_height, tip_middle = rear_middle + 0.03 * tail;
  const double rear_height = core_rows[0].height * f.half_height;
  std::vector<Section> sections;
  for (const TailRow& row : shape.tail_rows) {
    const double s = row.from_tip;
    sections.push_back({f.tail_tip + s * tail, tip_middle + s * (rear_middle - tip_middle),
                        row.half_width * length, thin + (rear_height - thin) * s * s * s});
  }
  for (const CoreRow& row : core_rows)
    sections.push_back({f.rear + row.along * f.core, row.middle * f.half_height, row.width * f.half_width,
                        row.height * f.half_height});
  // From the shoulders into the neck.
  const double end = shape.neck_base * f.radius, z = front_middle * f.half_height;
  const CoreRow& last = core_rows[std::size(core_rows) - 1];
  const auto toward = [&](double from, double share) { return from + share * (end - from); };
  sections.push_back({f.rear + 0.92 * f.core, 0.6 * z, toward(last.width * f.half_width, 0.5),
                      toward(last.height * f.half_height, 0.5)});
  sections.push_back({f.front, z, 0.99 * end, 0.99 * end}); // the neck goes on from here
  return sections;
}

void set_neck(GooseAnatomy& a, const BodyFrame& f, const Proportions& shape, NeckPose pose, double skull,
              double bill)
{
  const double z = front_middle * f.half_height, base = shape.neck_base * f.radius;
  const double top = shape.neck_top * shape.skull_half_width * skull;
  const double nape_out = f.bill_tip - bill - skull, length = std::max(nape_out - f.front, 0.0);
  if (pose == NeckPose::out) {
    const double rise = std::min(0.10 * length, 0.3 * f.radius);
    const double start = f.front - 0.06 * f.core, end = nape_out + 0.28 * skull;
    const double shares[] = {0, 0.15, 0.35, 0.6, 0.85, 1};
    a.neck.clear();
    for (double s : shares)
      a.neck.push_back(
          {{start + s * (end - start), 0, z + rise * s}, base + (top - base) * std::pow(s, 0.7)});
    a.skull_centre = {nape_out + 0.5 * skull, 0, z + rise + 0.10 * shape.skull_half_height * skull};
    return;
  }
  // Drawn in: an S below and behind the head; what the neck loses in length it gains in girth.
  const double gap = std::max(0.30 * length, std::min(0.6 * length, 0.5 * skull)), nape = f.front + gap;
  const double rise = std::min(0.45 * (length - gap), 0.75 * f.radius);
  const double thicker =
      std::clamp(std::sqrt((length + 0.3 * skull) / (gap + rise + 0.3 * skull)), 1.0, 1.35);
  const double wide_top = std::min(top * thicker, 0.97 * shape.skull_half_width * skull);
  const auto girth = [&](double s) { return base + (wide_top - base) * s; };
  a.neck = {{{f.front - 0.08 * f.core, 0, z - 0.05 * f.radius}, girth(0)},
            {{f.front + 0.15 * gap, 0, z}, girth(0.15)},
            {{f.front + 0.55 * gap, 0, z + 0.45 * rise}, girth(0.55)},
            {{nape + 0.02 * skull, 0, z + 0.90 * rise}, girth(0.85)},
            {{nape + 0.28 * skull, 0, z + rise}, girth(1)}};
  a.skull_centre = {nape + 0.5 * skull, 0, z + rise + 0.06 * shape.skull_half_height * skull};
}

void set_head(GooseAnatomy& a, const Proportions& shape, double skull, double bill)
{
  const double wide = shape.skull_half_width * skull, high = shape.skull_half_height * skull;
  const Vector3 c = a.skull_centre;
  a.skull_axes = {0.50 * skull, wide, high};
  a.brow_centre = c + Vector3(0.27 * skull, 0, -0.16 * high);
  a.brow_axes = {0.33 * skull, 0.66 * wide, 0.64 * high};
  const double base = c.x() + 0.5 * skull, tip = base + bill, z = c.z() - 0.20 * high;
  const double droop = shape.bill_droop * bill;
  a.bill = {{{base - 0.14 * skull, 0, z}, shape.bill_base * bill},
            {{base + 0.45 * bill, 0, z - 0.35 * droop}, shape.bill_middle * bill},
            {{tip - shape.bill_tip * bill, 0, z - droop}, shape.bill_tip * bill}};
  a.bill_flatness = shape.bill_flatness;
  a.head_blend = 0.26 * wide + 0.04 * bill;
}

// Bones and lungs of the goose, scaled along and across.
void set_inside(GooseAnatomy& a, const BodyFrame& f)
{
  const GooseAnatomy goose;
  const double along = f.core / goose_core, across = f.radius / goose_radius;
  for (double GooseAnatomy::*x :
       {&GooseAnatomy::first_rib, &GooseAnatomy::last_rib, &GooseAnatomy::rib_sweep,
        &GooseAnatomy::spine_front, &GooseAnatomy::spine_rear, &GooseAnatomy::pelvis_x,
        &GooseAnatomy::sternum_front, &GooseAnatomy::sternum_rear})
    a.*x = along * goose.*x;
  for (double GooseAnatomy::*r :
       {&GooseAnatomy::rib_radius, &GooseAnatomy::rib_depth, &GooseAnatomy::spine_radius,
        &GooseAnatomy::spine_depth, &GooseAnatomy::sternum_height, &GooseAnatomy::sternum_half_width,
        &GooseAnatomy::keel_depth, &GooseAnatomy::bone_blend, &GooseAnatomy::lung_clearance,
        &GooseAnatomy::cut_blend})
    a.*r = across * goose.*r;
  const Vector3 scale(along, across, across);
  a.pelvis_axes = goose.pelvis_axes.cwiseProduct(scale);
  a.lung_centre = goose.lung_centre.cwiseProduct(scale);
  a.lung_axes = goose.lung_axes.cwiseProduct(scale);
}

Box around(const Vector3& lower, const Vector3& upper, double margin)
{
  return {lower - Vector3::Constant(margin), upper + Vector3::Constant(margin)};
}

} // namespace

BodyFrame body_frame(const Biometry& size, const Proportions& shape, double radius)
{
  const double length = size.length.typical;
  BodyFrame f{};
  f.radius = radius;
  f.half_width = radius * std::sqrt(shape.flatness);
  f.half_height = radius / std::sqrt(shape.flatness);
  f.core = shape.core * length;
  f.front = before_thickest * f.core;
  f.rear = f.front - f.core;
  f.tail_tip = f.rear - shape.tail * length;
  f.bill_tip = f.tail_tip + length;
  return f;
}

double torso_volume(const Biometry& size, const Proportions& shape, double radius)
{
  const std::vector<Section> rows =
      torso_sections(body_frame(size, shape, radius), shape, size.length.typical);
  std::vector<double> x, w, h;
  for (const Section& s : rows) {
    x.push_back(s.x);
    w.push_back(s.half_width);
    h.push_back(s.half_height);
  }
  const MonotoneCurve width(x, w), height(x, h);
  const double n = GooseAnatomy{}.torso_exponent; // area of a superellipse: 4 w h G(1+1/n)^2 / G(1+2/n)
  const double shape_factor = 4 * std::pow(std::tgamma(1 + 1 / n), 2) / std::tgamma(1 + 2 / n);
  constexpr int steps = 400;
  const double dx = (x.back() - x.front()) / steps;
  double volume = 0;
  for (int i = 0; i < steps; ++i) {
    const double at = x.front() + (i + 0.5) * dx;
    volume += shape_factor * width(at) * height(at) * dx;
  }
  return volume;
}

GooseAnatomy body_anatomy(const Biometry& size, const Proportions& shape, NeckPose neck, double radius)
{
  const BodyFrame f = body_frame(size, shape, radius);
  const double length = size.length.typical, skull = shape.skull * length, bill = size.bill.typical;
  GooseAnatomy a;
  a.torso = torso_sections(f, shape, length);
  a.edge_radius = 0.92 * shape.tail_half_thickness * length;
  set_neck(a, f, shape, neck, skull, bill);
  set_head(a, shape, skull, bill);
  set_inside(a, f);
  return a;
}

HeadJoint head_joint(const GooseAnatomy& a)
{
  const double skull = 2 * a.skull_axes.x(), nape = a.skull_centre.x() - a.skull_axes.x();
  const auto share_of_width =
      [&](double width) { // of the skull's length from its rear, by half width over the largest
        const double w = std::min(width, 1.0);
        return 0.5 * (1 - std::sqrt(1 - w * w));
      };
  const double neck = a.neck.back().radius / a.skull_axes.y();
  const double from = share_of_width(0.88 * neck), full = share_of_width(neck);
  return {nape + from * skull, nape + std::clamp(full, from + 0.06, from + 0.10) * skull};
}

Implicit between(Implicit body, double rear, double front, double blend)
{
  return [=, body = std::move(body)](const Vector3& p) {
    return blended_maximum(body(p), std::max(rear - p.x(), p.x() - front), blend);
  };
}

Implicit stretched_across(Implicit body, double factor)
{
  return [=, body = std::move(body)](const Vector3& p) {
    return std::min(1.0, factor) * body({p.x(), p.y() / factor, p.z() / factor});
  };
}

Box head_box(const GooseAnatomy& a, double margin)
{
  Vector3 lower = a.skull_centre - a.skull_axes, upper = a.skull_centre + a.skull_axes;
  for (const Ball& b : a.bill) {
    const double r =
        b.radius * std::max(1.0, a.bill_flatness) + std::abs(b.centre.z() - a.bill.back().centre.z());
    lower = lower.cwiseMin(b.centre - Vector3::Constant(r));
    upper = upper.cwiseMax(b.centre + Vector3::Constant(r));
  }
  return around(lower, upper, margin + a.head_blend);
}

Box neck_box(const GooseAnatomy& a, double margin)
{
  Vector3 lower = a.neck.front().centre, upper = lower;
  for (const Ball& b : a.neck) {
    lower = lower.cwiseMin(b.centre - Vector3::Constant(b.radius));
    upper = upper.cwiseMax(b.centre + Vector3::Constant(b.radius));
  }
  return around(lower, upper, margin);
}

Box torso_box(const GooseAnatomy& a, double margin)
{
  Vector3 lower(a.torso.front().x, 0, 0), upper(a.torso.back().x, 0, 0);
  for (const Section& s : a.torso) {
    lower = lower.cwiseMin(Vector3(s.x, -s.half_width, s.middle - s.half_height));
    upper = upper.cwiseMax(Vector3(s.x, s.half_width, s.middle + s.half_height));
  }
  return around(lower, upper, margin);
}

} // namespace birdstrike
