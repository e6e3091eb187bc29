// SPDX-License-Identifier: BSD-3-Clause
// Fragments as rows of a table and as an array on the data.
#pragma once

#include "Fragment.h"

#include <string>

class vtkDataSetAttributes;
class vtkTable;

//! The columns of vtkFragments, without a row.
void StartFragmentTable(vtkTable* table);

//! A row each.
void AddFragmentRows(vtkTable* table, const std::string& dataset, const Fragments& fragments);

//! The array "fragment"; -1 in rows without an item.
void AddFragmentArray(vtkDataSetAttributes* data, std::int64_t count, const std::vector<FragmentItem>& items,
                      const Fragments& fragments);
