// SPDX-License-Identifier: BSD-3-Clause
// The force of one particle, spread over the elements below its cell.
//
// A lattice of particles that presses evenly would else load those elements more below which a row more of them happens to
// stand: four particles over one node can all be taken for one element, which then shows four times the pressure.
#pragma once

#include "core/shells/mesh.h"

#include <array>
#include <span>
#include <vector>

namespace birdstrike {

class Footprint
{
public:
  //! \param spacing  side of the square that a particle stands for [m]
  Footprint(const ShellMesh& mesh, double spacing);

  struct Share
  {
    std::int32_t element;
    double part; //!< [-]
  };
  //! Up to nine, which add up to 1.
  struct Shares
  {
    std::array<Share, 9> share;
    int count = 0;
    void add(std::int32_t element, double part)
    {
      if (part > 0)
        share[static_cast<std::size_t>(count++)] = {element, part};
    }
  };

  //! By the overlap of the square with a quadrilateral and its neighbours, taken as equal rectangles along its two middle
  //! lines; of elements smaller than the spacing only these nine take part. A triangle keeps all, and so does the element
  //! where a neighbour is missing or gone.
  //! \param weight  of the element's nodes at the foot
  Shares of(const ShellMesh& mesh, std::int32_t element, const std::array<double, 4>& weight,
            std::span<const Vector3> position, std::span<const std::uint8_t> gone) const;

private:
  double spacing_;
  std::vector<std::array<std::int32_t, 4>> across_; // element beyond side k (corner k to k + 1), or -1
  std::vector<std::array<std::int32_t, 4>> beyond_; // element beyond corner k that shares no side, or -1
};

} // namespace birdstrike
