// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRegionTableAlgorithm
 * @brief Base of histories that can be restricted to a region of space.
 *
 * Everywhere; the Sphere of Radius about Center; the Box of BoxSize about Center, along the axes; or the
 * Cylinder of Radius about the line through Center along Axis, of any length: on a plate it is a disc, the face
 * of a pressure transducer. All lengths in metres. The border belongs to the region.
 */
#pragma once

#include "vtkTemporalTableAlgorithm.h"

#include <array>

class BIRDSTRIKEFILTERS_EXPORT vtkRegionTableAlgorithm : public vtkTemporalTableAlgorithm
{
public:
  vtkTypeMacro(vtkRegionTableAlgorithm, vtkTemporalTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum RegionKind
  {
    Everywhere = 0,
    Sphere = 1,
    Box = 2,
    Cylinder = 3
  };

  ///@{ Kind of the region. Default Everywhere.
  vtkSetClampMacro(Region, int, Everywhere, Cylinder);
  vtkGetMacro(Region, int);
  ///@}

  ///@{ Middle of sphere and box, and a point of the cylinder's axis [m]. Default the origin.
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{ Of sphere and cylinder [m]. Default 0.1.
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{ Whole edges of the box along x, y, z [m]. Default 0.2 each.
  vtkSetVector3Macro(BoxSize, double);
  vtkGetVector3Macro(BoxSize, double);
  ///@}

  ///@{ Direction of the cylinder, of any length but zero. Default (1, 0, 0), the bird's flight.
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  ///@}

protected:
  vtkRegionTableAlgorithm() = default;
  ~vtkRegionTableAlgorithm() override = default;

  //! False, and an error has been reported, if the region's numbers are none.
  bool CheckRegion();
  bool IsEverywhere() const { return this->Region == Everywhere; }
  //! Distance of a place from the border of the region, which CheckRegion has found good [m]: below 0 inside, 0 or above
  //! outside; minus infinity everywhere.
  double DistanceTo(const std::array<double, 3>& place) const;
  bool IsInside(const std::array<double, 3>& place) const { return this->DistanceTo(place) <= 0; }

private:
  vtkRegionTableAlgorithm(const vtkRegionTableAlgorithm&) = delete;
  void operator=(const vtkRegionTableAlgorithm&) = delete;

  int Region = Everywhere;
  double Center[3] = {0, 0, 0};
  double Radius = 0.1;
  double BoxSize[3] = {0.2, 0.2, 0.2};
  double Axis[3] = {1, 0, 0};
};
