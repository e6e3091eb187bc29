// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a triangle soup, each with all triangles that use it. Nothing about the soup is taken for granted.
#pragma once

#include "geometry/surface_mesh.h"

#include <cstddef>
#include <span>

namespace birdstrike {

//! One side of one triangle.
struct HalfEdge
{
  int low, high;       //!< end points, sorted
  int triangle;        //!< row of SurfacePart::triangles
  int at_low, at_high; //!< corner (3 triangle + k) that sits at each end
  bool forward;        //!< runs from low to high
};

//! Three rows a triangle; the sides of one edge follow each other, in order of their triangles. A side whose ends are
//! one point is left out.
//! \throw InputError naming the part if a triangle refers to a point that is not there
std::vector<HalfEdge> sorted_half_edges(const SurfacePart& part);

//! Call \p visit with a span of HalfEdge for every undirected edge.
template <class Visit>
void visit_edges(const std::vector<HalfEdge>& sorted, Visit visit)
{
  for (std::size_t first = 0, last; first < sorted.size(); first = last) {
    for (last = first + 1; last < sorted.size() && sorted[last].low == sorted[first].low &&
                           sorted[last].high == sorted[first].high;
         ++last)
      ;
    visit(std::span<const HalfEdge>(sorted.data() + first, last - first));
  }
}

//! Uses from low to high less uses from high to low; 0 on every edge of a surface that bounds something.
inline int balance(std::span<const HalfEdge> edge)
{
  int sum = 0;
  for (const HalfEdge& side : edge)
    sum += side.forward ? 1 : -1;
  return sum;
}

} // namespace birdstrike
