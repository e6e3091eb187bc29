// SPDX-License-Identifier: BSD-3-Clause
// What particles carry, told on a surface.
#pragma once

#include "SphField.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkPointData;

//! A row of one of several datasets.
struct ParticleRow
{
  std::size_t Leaf;
  vtkIdType Row;
};

/**
 * The point arrays of particles. Numbers with a decimal point are means weighted by V W of 4.13 over the sum of
 * the weights, which gives constants exactly; whole numbers (part, id) are that of the largest sum of weights, since
 * a mean of names says nothing.
 */
class CarriedArrays
{
public:
  //! Those of \p names (null: all) that every leaf has with equal numbers of components, one tuple a point.
  CarriedArrays(const std::vector<vtkDataSet*>& leaves, const std::vector<std::string>* names);

  //! Names asked for that some leaf lacks.
  const std::vector<std::string>& GetMissing() const { return this->Missing; }

  /**
   * \param field  of the particles
   * \param rows   row of each of its particles
   * \param places where the values are wanted; within reach of a particle
   * \param to     one array of each is added, and "Normals": downhill of the field, of length 1
   * \param goOn   as of ParallelFor; stopped, the values mean nothing
   */
  void Interpolate(const SphField& field, const std::vector<ParticleRow>& rows,
                   const std::vector<Vector3d>& places, vtkPointData* to,
                   const std::function<bool(double)>& goOn = {}) const;

private:
  struct Array
  {
    std::string Name;
    std::vector<vtkDataArray*> Of; // each leaf
    int Components;
    bool Average;
  };
  std::vector<Array> Arrays;
  std::vector<std::string> Missing;
};
