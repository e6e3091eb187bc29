// SPDX-License-Identifier: BSD-3-Clause
// Who acts on whom: particles sorted along pencils of space, quads of up to four, one list of partners a quad.
#pragma once

#include "core/particles/pair_schedule.h"
#include "core/particles/pair_units.h"
#include "core/particles/particles.h"

#include <vector>

namespace birdstrike {

//! Particles are sorted into square pencils along x (two spacings wide, ordered by y, then z) and along x
//! within a pencil, so that four consecutive ones are close to each other; where they are not (debris), a quad
//! has fewer. The list holds every pair within h_i + h_j + skin_i + skin_j once and is used again until motion could
//! have brought a pair in from outside: that is measured against the bird's mean motion, so free flight costs no
//! rebuild. Skins widen where lists do not last, and shrink where they last long.
class Neighbours
{
public:
  //! \param skin    mean of the particles' skins, at first [m]
  //! \param period  lengths after which space repeats; 0 for none [m]
  Neighbours(double skin, Period period) : skin_(skin), first_skin_(skin), period_(period) {}

  //! Could a pair that is not in the list interact by now? Asked once a step, which tells how long lists last.
  bool is_stale(const Particles& particles);

  //! The order that sorts the particles: new row k holds old row order[k].
  //! \throw RunError if a position is not finite
  const std::vector<std::int32_t>& sort(const Particles& particles);

  //! The lists; \p particles must have been put in the order of sort().
  void build(const Particles& particles);

  const std::vector<Quad>& quads() const { return quads_; }
  const std::vector<std::int32_t>& partners() const { return partners_; }
  const PairSchedule& schedule() const { return schedule_; }
  PairUnits units(double spacing) const { return pair_units(spacing, period_); }
  long rebuilds() const { return rebuilds_; }
  double mean_neighbours() const { return mean_neighbours_; } //!< closer than h_i + h_j at the last build

private:
  struct Box
  {
    double low[3], high[3]; // [m]
  };
  struct Found // by one block of quads
  {
    std::vector<std::int32_t> partners;
    std::int64_t neighbours = 0;
    std::size_t offset = 0;
  };

  double skin_, first_skin_; // [m]
  Period period_;
  long steps_ = 0; // that the present lists have been asked for

  // Pencil (iy, iz) holds rows [pencil_begin_[k], pencil_begin_[k + 1]) with k = iz * pencils_y_ + iy.
  double width_y_ = 0, width_z_ = 0, origin_y_ = 0, origin_z_ = 0; // [m]
  int pencils_y_ = 0, pencils_z_ = 0;
  std::vector<std::int32_t> pencil_begin_, pencil_of_, order_, next_;

  std::vector<Quad> quads_;
  std::vector<std::int32_t> quad_begin_; // of each pencil
  std::vector<Box> boxes_;               // of each quad
  std::vector<QuadPlace> places_;        // at the last build
  std::vector<float> rest_density_;      // of each quad; NaN where its rows differ
  std::vector<std::int32_t> partners_;
  std::vector<Found> found_;
  PairSchedule schedule_;
  PairUnits found_unit_; // of places_
  double found_spacing_ = 0;
  long rebuilds_ = 0;
  double mean_neighbours_ = 0;

  int pencil_at(double value, double origin, double width, int count) const;
  void adapt_skin();
  void cut_quads(const Particles& particles);
  double place_quads(const Particles& particles);
  void search(std::size_t quad, double longest_reach, Found& found);
  void part_into_tasks();
};

//! Put all arrays of the particles in a new order: row k becomes what row order[k] was.
void reorder(Particles& particles, const std::vector<std::int32_t>& order);

//! The same for one array.
template <class T>
void reorder(std::vector<T>& array, const std::vector<std::int32_t>& order, std::vector<T>& scratch)
{
  scratch.resize(order.size());
#pragma omp parallel for schedule(static) if (order.size() > 1000)
  for (std::size_t k = 0; k < order.size(); ++k)
    scratch[k] = array[static_cast<std::size_t>(order[k])];
  array.swap(scratch);
}

} // namespace birdstrike
