// SPDX-License-Identifier: BSD-3-Clause
// Which elements may be near a particle: bins over the boxes of the elements, made larger by what is near.
#pragma once

#include "core/contact/contact_surface.h"

#include <array>

namespace birdstrike {

//! A grid of cubes over the elements that are not gone; each cube lists the elements whose box, widened by the reach and a
//! skin, it touches. A look-up costs the same whatever the number of elements, and the grid is used again until a node
//! could have left its skin: O(particles + elements).
class ElementBins
{
public:
  //! \param near  how far from an element a particle may be and still be listed [m]
  //! \param skin  how far nodes may move before the bins are made again [m]
  ElementBins(double near, double skin) : near_(near), skin_(skin) {}

  //! Make the bins again if they no longer hold.
  void update(const ContactSurface& surface);

  //! Elements that may be within reach of \p p, and some that are not; each once, always in the same order.
  std::span<const std::int32_t> at(const Vector3& p) const
  {
    std::size_t cell = 0;
    for (int k = 0; k < 3; ++k) {
      if (!(p[k] >= low_[k] && p[k] < high_[k])) // a NaN is nowhere
        return {};
      const auto index = std::min(static_cast<std::size_t>((p[k] - low_[k]) * per_width_), count_[k] - 1);
      cell = cell * count_[k] + index;
    }
    return {elements_.data() + begin_[cell], elements_.data() + begin_[cell + 1]};
  }

  //! Could the element be nearer to \p p than \p range [m]? By the ball around it, without a look at its nodes.
  bool may_reach(std::int32_t element, const Vector3& p, double range) const
  {
    const Ball& ball = balls_[static_cast<std::size_t>(element)];
    const double far = ball.radius + range;
    return (p - ball.middle).squaredNorm() <= far * far;
  }

  //! No listed element is nearer to \p p than this and the reach; 0 within the grid's box [m].
  double distance_to_box(const Vector3& p) const
  {
    return (low_ - p).cwiseMax(p - high_).cwiseMax(0.0).norm();
  }

  bool is_used(std::size_t node) const
  {
    return used_[node];
  } //!< by an element that was there when the bins were made
  long builds() const { return builds_; }

private:
  struct Ball
  {
    Vector3 middle;
    double radius; // with the skin [m]
  };
  double near_, skin_;
  double per_width_ = 0; // cubes over a length [1/m]
  Vector3 low_ = Vector3::Zero(), high_ = Vector3::Zero();
  std::array<std::size_t, 3> count_{};
  std::vector<std::size_t> begin_;
  std::vector<std::int32_t> elements_;
  std::vector<Ball> balls_;        // one an element
  std::vector<std::uint8_t> used_; // nodes of elements that are not gone
  std::vector<Vector3> built_at_;  // positions of the nodes then [m]
  long builds_ = 0;

  bool holds(const ContactSurface& surface) const;
  void build(const ContactSurface& surface);
};

} // namespace birdstrike
