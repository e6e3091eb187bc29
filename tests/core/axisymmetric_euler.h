// SPDX-License-Identifier: BSD-3-Clause
// An independent solver for one question: a flat-ended cylinder of a barotropic fluid on a rigid plate.
//
// The Euler equations in cylindrical coordinates on a fixed grid: finite volumes, piecewise linear reconstruction with
// minmod, HLL fluxes, Heun's method (E. F. Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed., 10.3,
// 13.4). Nothing of it is shared with the particles but the law: no lattice, no kernel, no artificial viscosity, another
// way to treat the wall and the free surface (matter below its reference density has no pressure).
#pragma once

#include "core/material/equation_of_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace birdstrike::samples {

class AxisymmetricImpact
{
public:
  //! The cylinder's front lies in x = 0, on the plate, at t = 0.
  //! \param radius, length  of the cylinder [m]
  //! \param cell            of the square grid [m]
  AxisymmetricImpact(const EquationOfState& eos, double speed, double radius, double length, double cell)
      : eos_(eos),
        rest_(reference_density(eos)),
        cell_(cell),
        columns_(static_cast<int>(1.1 * length / cell)),
        rows_(static_cast<int>(2.2 * radius / cell)),
        state_(static_cast<std::size_t>(columns_ * rows_)),
        wall_(static_cast<std::size_t>(rows_))
  {
    const auto covered = [cell](double size, int k) {
      return std::clamp((size - k * cell) / cell, 0.0, 1.0);
    };
    for (int i = 0; i < columns_; ++i)
      for (int j = 0; j < rows_; ++j) {
        const double density = std::max(nothing, rest_ * covered(length, i) * covered(radius, j));
        at(state_, i, j) = {density, -density * speed, 0};
      }
  }

  //! One step; \return its duration [s].
  double advance()
  {
    double fastest = 0;
    for (const Cell& c : state_)
      if (c[0] > 10 * nothing)
        fastest = std::max(fastest, std::max(std::abs(c[1]), std::abs(c[2])) / c[0] + law(c[0]).sound_speed);
    const double step = 0.4 * cell_ / fastest;
    std::vector<Cell> first = rates(state_), middle = state_;
    const std::vector<double> wall = wall_;
    add(middle, first, step);
    const std::vector<Cell> second = rates(middle);
    for (std::size_t k = 0; k < first.size(); ++k)
      for (std::size_t m = 0; m < 3; ++m)
        first[k][m] = 0.5 * (first[k][m] + second[k][m]);
    add(state_, first, step);
    wall_ = wall;
    return step;
  }

  //! Mean pressure on the plate within \p radius of the axis, at the start of the last step [Pa].
  double wall_pressure(double radius) const
  {
    double force = 0, area = 0;
    for (int j = 0; j < rows_ && (j + 0.5) * cell_ < radius; ++j) {
      force += wall_[static_cast<std::size_t>(j)] * (j + 0.5);
      area += j + 0.5;
    }
    return force / area;
  }

private:
  using Cell = std::array<double, 3>;     // density, momentum along x and along r, per volume
  static constexpr double nothing = 1e-3; // density that stands for empty space [kg/m3]

  EquationOfState eos_;
  double rest_, cell_;
  int columns_, rows_; // along x and along r
  std::vector<Cell> state_;
  std::vector<double> wall_;

  Cell& at(std::vector<Cell>& cells, int i, int j) const
  {
    return cells[static_cast<std::size_t>(i * rows_ + j)];
  }

  LawPoint law(double density) const { return density > rest_ ? evaluate(eos_, density) : LawPoint{0, 0}; }

  static void add(std::vector<Cell>& cells, const std::vector<Cell>& rates, double step)
  {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      for (std::size_t m = 0; m < 3; ++m)
        cells[k][m] += step * rates[k][m];
      if (cells[k][0] < nothing)
        cells[k] = {nothing, 0, 0};
    }
  }

  //! Density and velocities; mirrored at the plate and at the axis, empty behind the bird, open outwards.
  Cell primitive(const std::vector<Cell>& cells, int i, int j) const
  {
    if (i >= columns_)
      return {nothing, 0, 0};
    const double across = i < 0 ? -1 : 1, outwards = j < 0 ? -1 : 1;
    const int column = i < 0 ? -1 - i : i, row = j < 0 ? -1 - j : std::min(j, rows_ - 1);
    const Cell& c = cells[static_cast<std::size_t>(column * rows_ + row)];
    return {c[0], across * c[1] / c[0], outwards * c[2] / c[0]};
  }

  //! HLL flux between the second and the third of four cells in a row along \p axis, 1 or 2.
  Cell flux(const std::array<Cell, 4>& c, std::size_t axis) const
  {
    const auto minmod = [](double a, double b) { return a * b <= 0 ? 0 : std::abs(a) < std::abs(b) ? a : b; };
    std::array<Cell, 2> side;
    for (std::size_t m = 0; m < 3; ++m) {
      side[0][m] = c[1][m] + 0.5 * minmod(c[1][m] - c[0][m], c[2][m] - c[1][m]);
      side[1][m] = c[2][m] - 0.5 * minmod(c[2][m] - c[1][m], c[3][m] - c[2][m]);
    }
    std::array<Cell, 2> conserved, physical;
    std::array<double, 2> sound;
    for (std::size_t k = 0; k < 2; ++k) {
      side[k][0] = std::max(side[k][0], nothing);
      const LawPoint point = law(side[k][0]);
      sound[k] = point.sound_speed;
      conserved[k] = {side[k][0], side[k][0] * side[k][1], side[k][0] * side[k][2]};
      for (std::size_t m = 0; m < 3; ++m)
        physical[k][m] = conserved[k][m] * side[k][axis] + (m == axis ? point.pressure : 0);
    }
    const double left = std::min(side[0][axis] - sound[0], side[1][axis] - sound[1]);
    const double right = std::max(side[0][axis] + sound[0], side[1][axis] + sound[1]);
    if (left >= 0)
      return physical[0];
    if (right <= 0)
      return physical[1];
    Cell f;
    for (std::size_t m = 0; m < 3; ++m)
      f[m] = (right * physical[0][m] - left * physical[1][m] +
              left * right * (conserved[1][m] - conserved[0][m])) /
             (right - left);
    return f;
  }

  std::vector<Cell> rates(const std::vector<Cell>& cells)
  {
    std::vector<Cell> rate(cells.size(), Cell{0, 0, 0});
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i <= columns_; ++i) {
        const Cell f = flux({primitive(cells, i - 2, j), primitive(cells, i - 1, j), primitive(cells, i, j),
                             primitive(cells, i + 1, j)},
                            1);
        if (i == 0)
          wall_[static_cast<std::size_t>(j)] = f[1];
        for (std::size_t m = 0; m < 3; ++m) {
          if (i > 0)
            at(rate, i - 1, j)[m] -= f[m] / cell_;
          if (i < columns_)
            at(rate, i, j)[m] += f[m] / cell_;
        }
      }
    for (int i = 0; i < columns_; ++i)
      for (int j = 0; j <= rows_; ++j) {
        const Cell f = flux({primitive(cells, i, j - 2), primitive(cells, i, j - 1), primitive(cells, i, j),
                             primitive(cells, i, j + 1)},
                            2);
        for (std::size_t m = 0; m < 3; ++m) { // r G over r, with the radius of the face over that of the cell
          if (j > 0)
            at(rate, i, j - 1)[m] -= f[m] * j / ((j - 0.5) * cell_);
          if (j < rows_)
            at(rate, i, j)[m] += f[m] * j / ((j + 0.5) * cell_);
        }
        if (j < rows_)
          at(rate, i, j)[2] +=
              law(cells[static_cast<std::size_t>(i * rows_ + j)][0]).pressure / ((j + 0.5) * cell_);
      }
    return rate;
  }
};

} // namespace birdstrike::samples
