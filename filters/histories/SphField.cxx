// SPDX-License-Identifier: BSD-3-Clause
// How much of the space at a place is filled, after the particles around it.
#include "SphField.h"

#include "ParallelFor.h"

#include <utility>

SphField::SphField(std::vector<Vector3d> points, std::vector<double> h)
    : Points(std::move(points)),
      H(std::move(h)),
      Inverse(H.size()),
      Reach(H.size()),
      Scale(H.size(), 1.0),
      Largest(H.empty() ? 1.0 : *std::max_element(H.begin(), H.end())),
      Cells(Points, Support * Largest)
{
  for (std::size_t i = 0; i < this->H.size(); ++i) {
    this->Inverse[i] = 1 / this->H[i];
    this->Reach[i] = Support * Support * this->H[i] * this->H[i];
  }
  // With v = h^3, v W depends on r / h alone, and pi cancels.
  std::vector<double> counted(this->H.size());
  ParallelFor(counted.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      double sum = 0;
      this->ForEachNear(this->Points[i],
                        [&](std::size_t k, double squared) { sum += this->Share(k, squared); });
      counted[i] = sum;
    }
  });
  for (std::size_t i = 0; i < counted.size(); ++i)
    this->Scale[i] = 1 / counted[i];
}
