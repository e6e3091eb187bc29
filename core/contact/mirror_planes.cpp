// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/mirror_planes.h"

#include "core/contact/closest_point.h"
#include "core/parallel.h"

namespace birdstrike {

namespace {

// Cosine between the line to the particle and the element's normal: beside a free edge it falls, and the mirror fades.
constexpr double full_from = 0.9, none_below = 0.7;

} // namespace

//! Take the element's nearest point if it is within reach and nearer than the one there is.
void MirrorSearch::look_at(std::int32_t element, const Vector3& place, const ContactSurface& surface,
                           Nearest& nearest) const
{
  const auto e = static_cast<std::size_t>(element);
  const ElementPieces pieces(surface.mesh.elements[e], surface.position);
  const auto& x = pieces.corner;
  const Vector3 low = x[0].cwiseMin(x[1]).cwiseMin(x[2].cwiseMin(x[3])),
                high = x[0].cwiseMax(x[1]).cwiseMax(x[2].cwiseMax(x[3]));
  const double range = reach_ + 0.5 * surface.thickness[e], most = std::min(range * range, nearest.distance2);
  if ((low - place).cwiseMax(place - high).cwiseMax(0.0).squaredNorm() > most)
    return;
  for (int k = 0; k < pieces.count; ++k) {
    const auto [a, b, c] = pieces.piece(k);
    const TrianglePoint point = closest_on_triangle(place, a, b, c);
    if (point.distance2 < std::min(range * range, nearest.distance2))
      nearest = {point.distance2, element, pieces.node_weights(k, point.weight), point.point,
                 (b - a).cross(c - a).normalized()};
  }
}

void MirrorPlanes::resize(std::size_t count)
{
  for (auto* array : {&normal_x, &normal_y, &normal_z, &offset, &speed, &open})
    array->resize(count);
  element.resize(count, -1);
  weight.resize(count);
}

void MirrorSearch::find(const Particles& p, const ContactSurface& surface, MirrorPlanes& planes)
{
  bins_.update(surface);
  planes.resize(p.size());
  for_each_row(p.size(), [&](std::size_t i) {
    const Vector3 place = p.position(i);
    const std::int32_t guess =
        planes.element[i]; // of the last time, so that most others are seen to be farther off
    planes.element[i] = -1;
    planes.normal_x[i] = planes.normal_y[i] = planes.normal_z[i] = planes.offset[i] = planes.speed[i] =
        planes.open[i] = 0;
    const std::span<const std::int32_t> listed = bins_.at(place);
    if (listed.empty())
      return;
    Nearest nearest;
    if (guess >= 0 && !surface.gone[static_cast<std::size_t>(guess)])
      look_at(guess, place, surface, nearest);
    for (const std::int32_t element : listed)
      if (element != guess && !surface.gone[static_cast<std::size_t>(element)])
        look_at(element, place, surface, nearest);
    if (nearest.element < 0)
      return;
    const double half = 0.5 * surface.thickness[static_cast<std::size_t>(nearest.element)];
    const double distance = std::sqrt(nearest.distance2);
    if (distance <= half) // in the wall: the springs see to it
      return;
    const Vector3 normal = (place - nearest.foot) / distance;
    const double open =
        std::clamp((std::abs(normal.dot(nearest.face)) - none_below) / (full_from - none_below), 0.0, 1.0);
    if (open <= 0)
      return;
    Vector3 velocity = Vector3::Zero();
    const ShellElement& nodes = surface.mesh.elements[static_cast<std::size_t>(nearest.element)];
    for (std::size_t k = 0; k < 4; ++k)
      velocity += nearest.weight[k] * surface.velocity[static_cast<std::size_t>(nodes[k])];
    planes.normal_x[i] = normal[0];
    planes.normal_y[i] = normal[1];
    planes.normal_z[i] = normal[2];
    planes.offset[i] = nearest.foot.dot(normal) + half;
    planes.speed[i] = velocity.dot(normal);
    planes.open[i] = open;
    planes.element[i] = nearest.element;
    planes.weight[i] = nearest.weight;
  });
}

} // namespace birdstrike
