// SPDX-License-Identifier: BSD-3-Clause
// The datasets in a data object, with their names.
#pragma once

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

struct DatasetLeaf
{
  vtkDataSet* Data;
  std::string
      Name; //!< of its block, or of the next around it; "dataset_<k>" if none has one, k counting from 0
  unsigned int Index = 0; //!< VTK's flat index; 0 if there is only one dataset
  bool IsPiece = false;   //!< a part of a partitioned dataset
  unsigned int Whole = 0; //!< flat index of the composite around it
};

//! All leaf datasets of composite data in their order, or the dataset itself.
std::vector<DatasetLeaf> DatasetLeaves(vtkDataObject* data);

//! Shallow copies of all leaves in the same structure, so that arrays can be added to them.
void CopyLeaves(vtkDataObject* from, vtkDataObject* to);

//! "; it has the point arrays 'a', 'b' and the cell array 'c'", of all leaves, for a message that asks for one; empty if there
//! is none.
std::string ArraysOf(const std::vector<DatasetLeaf>& leaves);

//! Whether it is a cloud of points: no cells at all, or none but vertices.
bool IsPointCloud(vtkDataSet* data);

//! Smoothing length over spacing of data that do not tell it; what most SPH codes use, this toolkit among them.
constexpr double SmoothingOverSpacing = 1.2;

//! The field array "spacing" [m], the distance of neighbours when they were made; 0 if there is none.
double SpacingOf(vtkDataSet* data);
