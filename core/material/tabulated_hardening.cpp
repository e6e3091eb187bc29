// SPDX-License-Identifier: BSD-3-Clause
#include "core/material/tabulated_hardening.h"

#include "core/error.h"
#include "core/format_text.h"

#include <cmath>

namespace birdstrike {

TabulatedHardening::TabulatedHardening(std::vector<double> plastic_strain, std::vector<double> stress)
    : strain_(std::move(plastic_strain)), stress_(std::move(stress)), slope_(strain_.size(), 0.0)
{
  const std::size_t rows = strain_.size();
  require(rows >= 1 && stress_.size() == rows,
          format_text(
              "tabulated hardening: as many stresses as plastic strains are needed, at least one; there are "
              "%zu and %zu",
              stress_.size(), rows));
  require(strain_[0] == 0,
          format_text("tabulated hardening: the plastic strain of row 1 is %.6g and must be 0, where "
                      "yielding begins",
                      strain_[0]));
  require(std::isfinite(stress_[0]) && stress_[0] > 0,
          "tabulated hardening: the stress of row 1 must be positive");
  for (std::size_t k = 1; k < rows; ++k) {
    require(std::isfinite(strain_[k]) && strain_[k] > strain_[k - 1],
            format_text(
                "tabulated hardening: plastic strain must rise from row to row; row %zu has %.6g after %.6g",
                k + 1, strain_[k], strain_[k - 1]));
    require(std::isfinite(stress_[k]) && stress_[k] >= stress_[k - 1],
            format_text("tabulated hardening: stress must not fall; row %zu has %.6g Pa after %.6g Pa", k + 1,
                        stress_[k], stress_[k - 1]));
    slope_[k - 1] = (stress_[k] - stress_[k - 1]) / (strain_[k] - strain_[k - 1]);
  }
}

std::string TabulatedHardening::describe() const
{
  return format_text(
      "hardening by a table of %zu rows, %.6g MPa to %.6g MPa at a plastic strain of %.4g, constant "
      "from there",
      strain_.size(), stress_.front() / 1e6, stress_.back() / 1e6, strain_.back());
}

} // namespace birdstrike
