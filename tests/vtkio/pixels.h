// SPDX-License-Identifier: BSD-3-Clause
// What is in a picture, by counting its pixels.
#pragma once

#include <vtkImageData.h>

#include <cstddef>

struct Pixels
{
  int width, height;
  const unsigned char* data;
  explicit Pixels(vtkImageData& image)
      : width(image.GetDimensions()[0]),
        height(image.GetDimensions()[1]),
        data(static_cast<const unsigned char*>(image.GetScalarPointer()))
  {
  }
  const unsigned char* at(int x, int y) const
  {
    return data + 3 * (static_cast<std::ptrdiff_t>(y) * width + x);
  }
};

// Pixels in a rectangle (shares of the picture) for which the test holds.
template <class Test>
int count(const Pixels& p, double x0, double x1, double y0, double y1, Test test)
{
  int n = 0;
  for (int y = static_cast<int>(y0 * p.height); y < static_cast<int>(y1 * p.height); ++y)
    for (int x = static_cast<int>(x0 * p.width); x < static_cast<int>(x1 * p.width); ++x)
      n += test(p.at(x, y));
  return n;
}

inline bool is_drawn(const unsigned char* c) { return c[0] < 250 || c[1] < 250 || c[2] < 250; }
