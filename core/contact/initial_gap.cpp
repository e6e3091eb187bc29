// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/initial_gap.h"

#include "core/contact/closest_point.h"
#include "core/contact/contact_stiffness.h"
#include "core/error.h"
#include "core/format_text.h"

#include <numeric>

namespace birdstrike {

namespace {

//! Boxes around boxes around elements; each holds the elements of a range of order_.
class BoxTree
{
public:
  BoxTree(const ContactSurface& surface, double spacing) : surface_(surface), spacing_(spacing)
  {
    for (std::size_t e = 0; e < surface.mesh.elements.size(); ++e)
      if (!surface.gone[e])
        order_.push_back(static_cast<std::int32_t>(e));
    require(!order_.empty(), "the target has no element that a particle could touch");
    grow(0, order_.size());
  }

  //! Smallest gap below \p gap from \p p to any element; both are left as they are if there is none.
  void search(const Vector3& p, double& gap, std::int32_t& element, std::size_t k = 0) const
  {
    const Branch& branch = branches_[k];
    if (gap_to(branch, p) >= gap)
      return;
    if (branch.left == 0) {
      for (std::size_t i = branch.first; i < branch.last; ++i) {
        const auto e = static_cast<std::size_t>(order_[i]);
        const double here = distance_to_element(p, {surface_.mesh.elements[e], surface_.position}) -
                            contact_distance(spacing_, surface_.thickness[e]);
        if (here < gap) {
          gap = here;
          element = order_[i];
        }
      }
      return;
    }
    const bool left_first = gap_to(branches_[branch.left], p) < gap_to(branches_[branch.right], p);
    search(p, gap, element, left_first ? branch.left : branch.right);
    search(p, gap, element, left_first ? branch.right : branch.left);
  }

private:
  struct Branch
  {
    Vector3 low, high; // of the midsurfaces [m]
    double reach;      // largest contact distance [m]
    std::size_t first, last;
    std::size_t left = 0, right = 0; // none: a leaf
  };
  const ContactSurface& surface_;
  double spacing_;
  std::vector<std::int32_t> order_;
  std::vector<Branch> branches_;

  static double gap_to(const Branch& branch, const Vector3& p)
  {
    return (branch.low - p).cwiseMax(p - branch.high).cwiseMax(0.0).norm() - branch.reach;
  }

  Vector3 middle(std::int32_t element) const
  {
    Vector3 sum = Vector3::Zero();
    for (const std::int32_t node : surface_.mesh.elements[static_cast<std::size_t>(element)])
      sum += surface_.position[static_cast<std::size_t>(node)];
    return sum;
  }

  std::size_t grow(std::size_t first, std::size_t last)
  {
    Branch branch{Vector3::Constant(1e300), Vector3::Constant(-1e300), 0, first, last};
    for (std::size_t i = first; i < last; ++i) {
      const auto e = static_cast<std::size_t>(order_[i]);
      branch.reach = std::max(branch.reach, contact_distance(spacing_, surface_.thickness[e]));
      for (const std::int32_t node : surface_.mesh.elements[e]) {
        branch.low = branch.low.cwiseMin(surface_.position[static_cast<std::size_t>(node)]);
        branch.high = branch.high.cwiseMax(surface_.position[static_cast<std::size_t>(node)]);
      }
    }
    const std::size_t self = branches_.size();
    branches_.push_back(branch);
    if (last - first > 4) {
      int axis = 0;
      (branch.high - branch.low).maxCoeff(&axis);
      const std::size_t half = (first + last) / 2;
      const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
      std::nth_element(at(first), at(half), at(last), [&](std::int32_t a, std::int32_t b) {
        const double xa = middle(a)[axis], xb = middle(b)[axis];
        return xa < xb || (xa == xb && a < b);
      });
      const std::size_t left = grow(first, half), right = grow(half, last);
      branches_[self].left = left;
      branches_[self].right = right;
    }
    return self;
  }
};

} // namespace

InitialGap find_initial_gap(const Particles& p, const ContactSurface& surface)
{
  const BoxTree tree(surface, p.spacing);
  const double touching = -1e-9 * p.spacing; // resting on the surface is no overlap
  InitialGap found;
  found.gap = 1e300;
  for (std::size_t i = 0; i < p.size(); ++i) {
    double gap = std::max(found.gap, touching);
    std::int32_t element = -1;
    tree.search(p.position(i), gap, element);
    if (element < 0)
      continue;
    if (gap < touching)
      ++found.too_near;
    if (gap < found.gap) {
      found.gap = gap;
      found.particle = p.id[i];
      found.element = element;
      found.row = i;
    }
  }
  return found;
}

InitialGap require_initial_gap(const Particles& p, const ContactSurface& surface)
{
  const InitialGap found = find_initial_gap(p, surface);
  if (found.too_near == 0)
    return found;
  const auto e = static_cast<std::size_t>(found.element);
  const double thickness = surface.thickness[e], reach = contact_distance(p.spacing, thickness);
  const Vector3 at = p.position(found.row);
  throw InputError(format_text(
      "the bird and the target overlap at the start: particle %d (part %s) at x = %.6g, y = %.6g, z = %.6g m "
      "is %.4g mm "
      "from the middle of element %d (part %s), where half a particle spacing and half the thickness need "
      "%.4g mm; %ld of "
      "%ld particles are too near; increase bird.gap by %.4g mm or more, or move the target",
      found.particle, p.parts[p.part[found.row]].name.c_str(), at[0], at[1], at[2], 1e3 * (reach + found.gap),
      found.element, surface.mesh.parts.at(surface.mesh.part_of(e)).name.c_str(), 1e3 * reach, found.too_near,
      static_cast<long>(p.size()), -1e3 * found.gap));
}

} // namespace birdstrike
