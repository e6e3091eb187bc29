// SPDX-License-Identifier: GPL-3.0-or-later
// Where axis-parallel lines pierce a surface, and how often it winds around a point.
#pragma once

#include "geometry/measure.h"
#include "geometry/surface_mesh.h"

#include <cstdint>
#include <vector>

namespace birdstrike {

//! A line goes through the surface.
struct Crossing
{
  double at; //!< coordinate along the line [m]
  int step;  //!< change of the winding number along the line: +1 into the body, -1 out of it
};

//! The triangles of one surface, sorted into columns along one axis.
//! Which triangles a line hits is decided by exact predicates on the line moved by an infinitesimal amount sideways
//! (Edelsbrunner and Mücke, ACM Trans. Graph. 9 (1990) 66), so that a line through a corner or along an edge hits
//! what it should: the steps of every line add up to zero, whatever the surface does to itself, as long as each edge
//! is used equally often in both directions.
class Columns
{
public:
  //! \param axis  of the lines: 0, 1 or 2
  //! \throw InputError naming the part if an edge is used unequally often in its two directions: such a surface has no
  //!        inside
  Columns(const SurfacePart& part, int axis);

  //! All crossings of a line in the order along the axis.
  //! \param u, v  coordinates of the line along the axes that follow \p axis cyclically [m]
  void crossings(double u, double v, std::vector<Crossing>& result) const;

  //! How often the surface winds around a point: 0 outside, 1 inside, 2 where it overlaps itself, -1 where it is
  //! inside out. May be called from many threads at once.
  int winding(const Vector3& point) const;

  const Box& box() const { return box_; }

private:
  struct Flat
  {
    double u, v, w; //!< w along the axis
  };
  int side(const std::array<int, 3>& triangle, double u, double v) const;
  double height(const std::array<int, 3>& triangle, double u, double v) const;
  template <class Visit>
  void visit(double u, double v, Visit&& hit) const;

  int axis_;
  Box box_;
  std::vector<Flat> points_;
  std::vector<std::array<int, 3>> triangles_; //!< those that are not seen edge-on
  std::vector<std::int8_t> facing_;           //!< step of every triangle
  int bins_u_ = 1, bins_v_ = 1;
  double scale_u_ = 0, scale_v_ = 0;  //!< bins per length [1/m]
  std::vector<std::uint32_t> first_;  //!< of each bin in listed_
  std::vector<std::uint32_t> listed_; //!< triangles by bin
};

} // namespace birdstrike
