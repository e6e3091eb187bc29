// SPDX-License-Identifier: BSD-3-Clause
// Mean of vectors over the end of a series, and how far they swing about it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

class TrailingMean
{
public:
  using Vector = std::array<double, 3>;

  //! Begin anew. The window holds the steps with last time - time <= share (last time - first time), at least
  //! the last one.
  //! \param times  of all steps [s], rising
  //! \param share  of the whole time that the window takes, 0 to 1
  void Start(const std::vector<double>& times, double share);

  //! Take in the vectors of a step; steps outside the window are passed over. A count that differs from that
  //! of the steps before ends it: Complete stays false.
  void Add(std::size_t step, const std::vector<Vector>& values);

  //! Whether every step of the window has been taken in.
  bool Complete() const { return this->Fine && this->Added == this->Weights.size() && this->Added > 0; }
  std::size_t Count() const { return this->Sums.size(); }

  //! Time mean with values on straight lines between steps (trapezoidal rule). NaN where one value is.
  Vector Mean(std::size_t i) const;

  //! Length of the vector whose components are the largest distances of the components from their means. That
  //! is the amplitude of a vibration along any one line, and never less than the largest distance from the
  //! mean. NaN where one value is, and from a single step.
  double Amplitude(std::size_t i) const;

private:
  std::size_t First = 0;       // step of the window
  std::vector<double> Weights; // of the steps in the window; their sum is 1
  std::size_t Added = 0;
  bool Fine = true; // the counts agree
  std::vector<Vector> Sums, Lows, Highs;
};
