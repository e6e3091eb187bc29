// SPDX-License-Identifier: GPL-3.0-or-later
// The objects of a bird as bodies that share out space among the parts.
#pragma once

#include "geometry/columns.h"
#include "geometry/moments.h"

#include <cstdint>
#include <string>
#include <vector>

namespace birdstrike {

//! A stretch of a line that belongs to one object.
struct Span
{
  double from, to; //!< along the line [m]
  int object;      //!< row of the mesh
};

//! Two objects that share space though neither holds the other, or two that leave a thin gap.
struct Meeting
{
  std::string a, b;  //!< names of the objects; b is the larger one
  double volume = 0; //!< shared, or between them [m3]
  double share = 0;  //!< of the volume of a [-]
};

//! How the objects of a mesh fill space. A point belongs to the smallest object around it, so that bones and lungs win
//! over the torso that holds them, and where two merely overlap the smaller one has the overlap.
//! A body's inside is where its surface winds around a point at all: pieces of one object that overlap are one body, a
//! piece turned inwards within another one is a cavity.
class Solids
{
public:
  //! \param axis  of the lines in which it thinks: 0, 1 or 2
  //! \throw InputError as Columns, or naming the object if it encloses no volume or is inside out
  Solids(const SurfaceMesh& mesh, int axis);

  std::size_t size() const { return columns_.size(); }
  const Box& box() const { return box_; }

  //! Who has which stretch of a line, in its order; what nobody has is left out.
  //! \param u, v  coordinates of the line along the axes that follow the axis cyclically [m]
  void spans(double u, double v, std::vector<Span>& result) const;

  //! Row of the object that has a point, or -1.
  int owner(const Vector3& point) const;

  //! Moments at density 1 of what each object has, and where objects overlap or nearly touch.
  struct Shares
  {
    std::vector<Moments> of;       //!< one an object
    bool exact = false;            //!< from the polyhedra themselves; otherwise from lines \p step apart
    std::vector<Meeting> overlaps; //!< by more than a thousandth of the smaller one
    std::vector<Meeting>
        gaps; //!< between objects of different parts, narrower than \p narrow, that touch nowhere
    std::vector<double> doubled; //!< volume that each object's surface winds around more than once [m3]
  };
  //! \param part_of  of each object: gaps and overlaps within one part do not count
  //! \param step     between the lines [m]
  //! \param narrow   widest gap that is one [m]
  Shares shares(const std::vector<std::string>& part_of, double step, double narrow) const;

private:
  struct Event
  {
    double at;
    int rank, step;
  };
  void sweep(double u, double v, std::vector<Event>& events) const;

  int axis_;
  Box box_;
  std::vector<std::string> names_;
  std::vector<Moments> whole_;   //!< of each object's polyhedron
  std::vector<int> by_size_;     //!< objects, smallest first: rank of a claim -> object
  std::vector<Columns> columns_; //!< by rank
};

} // namespace birdstrike
