// SPDX-License-Identifier: GPL-3.0-or-later
// A wing open to the side: spread, or half folded.
#include "geometry/birds/fit_volume.h"
#include "geometry/birds/slab.h"
#include "geometry/birds/wings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike {

namespace {

// The wing seen from above and from the front, in metres, by the distance y from the bird's middle.
struct Sheet
{
  MonotoneCurve front, rear, height;
  double tip;   // y
  double chord; // mean [m]
};

Sheet make_sheet(const std::vector<double>& y, const std::vector<double>& front,
                 const std::vector<double>& rear, const std::vector<double>& height, double chord)
{
  return {MonotoneCurve(y, front), MonotoneCurve(y, rear), MonotoneCurve(y, height), y.back(), chord};
}

double mean_row_chord(const Proportions& shape)
{
  std::vector<double> out, chord;
  for (const WingRow& row : shape.wing) {
    out.push_back(row.out);
    chord.push_back(row.chord);
  }
  const MonotoneCurve c(out, chord);
  constexpr int steps = 400;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    sum += c((i + 0.5) / steps) / steps;
  return sum;
}

struct Shoulder
{
  double x, z;
};
Shoulder shoulder_of(const Proportions& shape, const WingSite& site)
{
  const double x = shape.shoulder * site.frame.core;
  return {x, site.middle(0) + 0.42 * site.frame.half_height};
}

Sheet spread_sheet(const Biometry& size, const Proportions& shape, const WingSite& site)
{
  const double half_span = 0.5 * size.wingspan.typical;
  const double mean_chord = size.wing_area / size.wingspan.typical, unit = mean_chord / mean_row_chord(shape);
  const Shoulder s = shoulder_of(shape, site);
  std::vector<double> y, front, rear, height;
  for (const WingRow& row : shape.wing) {
    y.push_back(row.out * half_span);
    front.push_back(s.x + row.front * half_span);
    rear.push_back(front.back() - row.chord * unit);
    height.push_back(s.z + row.up * half_span);
  }
  return make_sheet(y, front, rear, height, mean_chord);
}

// Wrist forward, hand swept back; feathers slide over each other, so that the area shrinks. Lengths over half
// the span, chords over the mean chord; chosen.
Sheet half_folded_sheet(const Biometry& size, const Proportions& shape, const WingSite& site)
{
  struct Row
  {
    double out, front, up;
  };
  static constexpr Row rows[] = {{0, 0, 0},
                                 {0.09, 0.045, 0.030},
                                 {0.18, 0.085, 0.055},
                                 {0.26, 0.100, 0.066},
                                 {0.32, 0.085, 0.068},
                                 {0.38, 0.020, 0.064},
                                 {0.44, -0.115, 0.056},
                                 {0.49, -0.270, 0.048},
                                 {0.52, -0.400, 0.044}};
  constexpr double wrist = 0.26, tip = 0.52, tip_chord = 0.03;
  const double half_span = 0.5 * size.wingspan.typical;
  const double mean_chord = size.wing_area / size.wingspan.typical, unit = mean_chord / mean_row_chord(shape);
  const Shoulder s = shoulder_of(shape, site);
  const double root = shape.wing.front().chord * unit;
  std::vector<double> y, front, rear, height;
  const double rear_wrist = s.x + 0.100 * half_span - 1.10 * root;
  const double rear_tip = std::min(s.x - (0.400 + tip_chord) * half_span, rear_wrist - 0.02 * half_span);
  for (const Row& row : rows) {
    y.push_back(row.out * half_span);
    front.push_back(s.x + row.front * half_span);
    const double inner = s.x - root + (rear_wrist - s.x + root) * row.out / wrist;
    const double outer = rear_wrist + (rear_tip - rear_wrist) * (row.out - wrist) / (tip - wrist);
    rear.push_back(row.out < wrist ? inner : outer);
    height.push_back(s.z + row.up * half_span);
  }
  return make_sheet(y, front, rear, height, mean_chord);
}

// Half the thickness along the chord, over the largest: a round nose, thick over the arm's bones and muscles,
// thin feathers behind.
double profile(double share)
{
  constexpr double thickest = 0.22, trailing = 0.34;
  if (share < thickest)
    return std::sqrt(1 - std::pow(1 - share / thickest, 2));
  return 1 - (1 - trailing) * std::pow((share - thickest) / (1 - thickest), 1.2);
}

constexpr double camber = 0.05;      // rise of the middle line over the chord (chosen)
constexpr double tip_thinning = 0.6; // how much thinner the wing is at its tip (chosen)

// Where the wing ends at a place on the chord: round, or with free primaries parted by slots.
double wing_end(const Proportions& shape, double share, double tip)
{
  if (shape.fingers == 0)
    return tip;
  constexpr double longest = 0.36; // place of the longest primary
  const double round = 1 - 0.26 * std::pow(std::abs(share - longest) / (1 - longest), 2.2);
  const double in_finger = share * shape.fingers; // slots at whole numbers
  const double to_slot = std::abs(in_finger - std::round(in_finger));
  const bool edge = in_finger < 0.5 || in_finger > shape.fingers - 0.5;
  const double slot = edge ? 0.0 : std::pow(std::max(0.0, 1 - to_slot / 0.24), 0.8);
  return tip * (round - shape.slot * slot * (0.35 + 0.65 * (1 - share)));
}

class OpenWing
{
public:
  OpenWing(Sheet sheet, const Proportions& shape, bool slotted, const WingSite& site)
      : sheet_(std::move(sheet)), shape_(shape), slotted_(slotted && shape.fingers > 0), site_(site)
  {
    const double half_core = 0.5 * site.frame.half_width;
    columns_ = std::clamp(int(std::lround(sheet_.chord / site.edge)), 8, 400) + 1;
    if (slotted_)
      columns_ = std::max(columns_, 12 * shape.fingers + 1);
    rows_ = std::clamp(int(std::lround((sheet_.tip - half_core) / site.edge)), 12, 2000) + 1;
  }

  SurfacePart mesh(double thickness) const
  {
    PointGrid upper{rows_, columns_, {}}, lower{rows_, columns_, {}};
    upper.points.resize(std::size_t(rows_) * columns_);
    lower.points.resize(upper.points.size());
    for (int j = 0; j < columns_; ++j) {
      const double even = double(j) / (columns_ - 1);
      const double share = slotted_ ? even : std::pow(even, 1.35); // closer together at the nose
      const double first = root(share, thickness),
                   last = slotted_ ? wing_end(shape_, share, sheet_.tip) : sheet_.tip;
      for (int i = 0; i < rows_; ++i) {
        const double y = first + (last - first) * i / (rows_ - 1);
        upper.at(i, j) = point(share, y, thickness, 1);
        lower.at(i, j) = point(share, y, thickness, -1);
      }
    }
    return close_slab("wing_left", upper, lower);
  }

private:
  Vector3 point(double share, double y, double thickness, double side) const
  {
    const double front = sheet_.front(y), chord = front - sheet_.rear(y);
    const double rise = camber * chord * (1 - std::pow(2 * share - 1, 2));
    const double half = 0.5 * thickness * (1 - tip_thinning * y / sheet_.tip) * profile(share);
    return {front - share * chord, y, sheet_.height(y) + rise + side * half};
  }

  // The y at which all of the wing's depth has just gone \p overlap deep into the torso.
  double root(double share, double thickness) const
  {
    const auto outside = [&](double y) {
      double worst = -1e30;
      for (double side : {-1.0, 0.0, 1.0})
        worst = std::max(worst, site_.torso(point(share, y, thickness, side)) + site_.overlap);
      return worst > 0;
    };
    // A wing wider than the torso is long has its rear part beside the tail's base: it ends there freely.
    double inside = 0.25 * site_.frame.half_width, beyond = 1.2 * site_.frame.half_width;
    if (outside(inside))
      return 0.5 * site_.frame.half_width;
    for (int k = 0; k < 30; ++k) {
      const double half = 0.5 * (inside + beyond);
      (outside(half) ? beyond : inside) = half;
    }
    return inside;
  }

  Sheet sheet_;
  const Proportions& shape_;
  bool slotted_;
  const WingSite& site_;
  int rows_, columns_;
};

} // namespace

SurfacePart open_wing(const Biometry& size, const Proportions& shape, bool half_folded, const WingSite& site,
                      double volume)
{
  const OpenWing wing(half_folded ? half_folded_sheet(size, shape, site) : spread_sheet(size, shape, site),
                      shape, !half_folded, site);
  const double guess = 2.5 * volume / size.wing_area * (half_folded ? 1.8 : 1);
  return fit_volume([&](double t) { return wing.mesh(t); }, volume, guess);
}

double planform_area(const Biometry& size, const Proportions& shape)
{
  const double half_span = 0.5 * size.wingspan.typical;
  const double unit = size.wing_area / size.wingspan.typical / mean_row_chord(shape);
  double sum = 0; // trapezia between rows
  for (std::size_t i = 0; i + 1 < shape.wing.size(); ++i)
    sum += (shape.wing[i + 1].out - shape.wing[i].out) * half_span * unit *
           (shape.wing[i].chord + shape.wing[i + 1].chord);
  return sum;
}

} // namespace birdstrike
