// SPDX-License-Identifier: BSD-3-Clause
// Largest or smallest value that each point or cell of a dataset has had, and when.
#pragma once

#include "vtkType.h"

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;

class RunningPeaks
{
public:
  //! Take in the values of a time step.
  //! \param values     one for each row
  //! \param component  of a vector; below 0 its length
  //! \param ids        whole numbers that rows keep from step to step; null: the row's number
  //! \return false if the number of rows has changed and there are no ids, or they come and go
  bool Add(double time, vtkDataArray* values, int component, vtkDataArray* ids, bool smallest);

  //! Put the arrays \p name and "time_of_" + \p name for rows with these \p ids; NaN where a row had no value. The data's own
  //! array of that name is kept: "_of_frames" is then added to both names.
  void Put(vtkDataSetAttributes* data, const std::string& name, vtkDataArray* ids, vtkIdType rows) const;

  std::size_t Rows() const { return this->Peak.size(); }

private:
  std::unordered_map<long long, std::size_t> Places; // by id
  bool ById = false;
  std::vector<double> Peak, Time;
};
