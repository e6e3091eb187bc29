// SPDX-License-Identifier: BSD-3-Clause
// Pieces of debris: what they weigh and how they fly.
#pragma once

#include "CellList.h"

#include <cstdint>
#include <vector>

//! A particle or a cell. NaN where something is not known.
struct FragmentItem
{
  std::int64_t Row;  //!< in its dataset
  Vector3d Centre;   //!< [m]
  Vector3d Velocity; //!< [m/s]
  double Mass;       //!< [kg]
  double Energy;     //!< kinetic [J]
};

struct Fragment
{
  std::int64_t Count = 0;
  double Mass = 0;                  //!< [kg]
  Vector3d Centre{};                //!< of mass [m]; mean of the items where there are no masses
  Vector3d Velocity{};              //!< of the centre [m/s]
  Vector3d Momentum{};              //!< [kg m/s]
  double KineticEnergy = 0;         //!< sum over the items [J]
  double KineticEnergyOfCentre = 0; //!< M V^2 / 2 [J]
  double Extent = 0;                //!< largest distance between two of its points [m]
};

struct Fragments
{
  std::vector<Fragment> Rows;   //!< largest mass first
  std::vector<std::int64_t> Of; //!< fragment of each item, -1: of none
};

/**
 * Sums over items that belong together. Ordered by mass, then by number of items, then by their first item: with
 * items in an order of their own, and so sums of the same bits, the order does not depend on that of the file.
 * \param root     a number for each item, equal for those that belong together
 * \param massive  whether the items have masses; if not, all count alike
 * \param minimum  fragments of fewer items are left out
 * Extent is left to the caller.
 */
Fragments SumFragments(const std::vector<FragmentItem>& items, const std::vector<std::size_t>& root,
                       bool massive, std::int64_t minimum);
