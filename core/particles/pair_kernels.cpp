// SPDX-License-Identifier: BSD-3-Clause
// Compiled once for each instruction set: BIRDSTRIKE_ISA_NAME is plain, avx2 or avx512. All but the table at
// the end has internal linkage, so that no build can borrow another's instructions.
#include "core/particles/pair_kernels.h"
#include "core/simd.h"

namespace birdstrike {
namespace {

constexpr int rows_at_once = lanes / quad_size; // of the quad whose sums are made

//! A quad's numbers, one particle a group of four lanes (ours) or one a lane of each group (the partners').
struct Side
{
  Ints x, y, z;
  Floats vx, vy, vz, support, weight, pressure, stress, sound_speed, lightness, smooth;
  Floats strain_rate[6];
  Floats rest_density;
};

//! Rows row ... row + rows_at_once - 1 of a quad.
BIRDSTRIKE_INLINE Side spread_side(const QuadState& q, int row)
{
  Side side{spread(q.x + row),           spread(q.y + row),
            spread(q.z + row),           spread(q.vx + row),
            spread(q.vy + row),          spread(q.vz + row),
            spread(q.support + row),     spread(q.weight + row),
            spread(q.pressure + row),    spread(q.stress + row),
            spread(q.sound_speed + row), spread(q.lightness + row),
            spread(q.smooth + row),      {},
            spread(q.rest_density + row)};
  for (int c = 0; c < 6; ++c)
    side.strain_rate[c] = spread(q.strain_rate[c] + row);
  return side;
}

struct Sums
{
  Floats fx{}, fy{}, fz{}, number{}, gradient[9]{}, pressure{}, heating{}, extra_work{}, wall{}, wall_y{},
      wall_z{}, mu{};

  BIRDSTRIKE_INLINE void operator+=(const Sums& more)
  {
    fx += more.fx, fy += more.fy, fz += more.fz, number += more.number;
    for (int c = 0; c < 9; ++c)
      gradient[c] += more.gradient[c];
    pressure += more.pressure, heating += more.heating, extra_work += more.extra_work;
    wall += more.wall, wall_y += more.wall_y, wall_z += more.wall_z;
    mu = max(mu, more.mu);
  }
};

//! What partner j is: itself, its image in the plate x = 0, or its image in a plane of the lane's own.
enum class Seen
{
  direct,
  in_plate,
  in_wall
};

struct Vector
{
  Floats x, y, z;
};

struct Sum
{
  template <class T>
  BIRDSTRIKE_INLINE T operator()(T a, T b) const
  {
    return a + b;
  }
};
struct Largest
{
  template <class T>
  BIRDSTRIKE_INLINE T operator()(T a, T b) const
  {
    return a > b ? a : b;
  }
};

//! Pairs of a partner of which at least one is nearer than the kernel reaches: what the geometry has to say.
struct Near
{
  Vector d;         //!< x_i - x_j [spacings]
  Floats r2;        //!< d.d
  Floats open;      //!< 1 where the pair may act, 0 where something stands between; set where anything may
  Floats inverse_r; //!< 1 / |d|
  Floats number;    //!< V_j W times the weight of i
  Floats
      k; //!< a sixth of -V_j (1/r) dW/dr times the weight of i; exactly nothing where the support does not reach j
  Floats push;       //!< k times all stresses [Pa]
  Floats heating;    //!< \see QuadSums
  Floats extra_work; //!< of j, \see QuadSums; set where rest densities differ
  std::int32_t partner;
};
constexpr int near_at_once = 12; // stays in the nearest cache

//! Is any pair within reach?
template <bool gated>
BIRDSTRIKE_INLINE bool meet(const Side& i, const QuadState& q, std::int32_t partner, const Vector& d,
                            [[maybe_unused]] Floats open, Near& to)
{
  const Floats reach = i.support + tile(q.support);       // 2 h_ij: where the kernel ends
  to.r2 = d.z * d.z + (d.y * d.y + (d.x * d.x + 1e-12f)); // never zero
  to.d.x = d.x, to.d.y = d.y, to.d.z = d.z;
  if constexpr (gated)
    to.open = open;
  to.partner = partner;
  return any_positive(reach * reach - to.r2);
}

//! Kernel and gradient, and the sums that need no more.
template <bool gated>
BIRDSTRIKE_INLINE void weigh(Sums& sum, const Side& i, const QuadState& q, Near& near)
{
  const Floats zero{};
  const Floats inverse_reach = reciprocal(i.support + tile(q.support));
  const Floats inverse_r = inverse_root(near.r2);

  // 4.13 in truncated powers of s = r / (2h): W = 8 (2 A^3 - B^3) / (pi (2h)^3), A = 1 - s, B = 1 - 2s,
  // and -(1/r) dW/dr = 48 (A^2 - B^2) / (pi (2h)^4 r)
  const Floats s = near.r2 * inverse_r * inverse_reach;
  const Floats a = max(1.0f - s, zero), b = max(1.0f - 2.0f * s, zero);
  const Floats a2 = a * a, b2 = b * b, inverse_reach2 = inverse_reach * inverse_reach;
  Floats weight = i.weight * tile(q.weight) * (inverse_reach2 * inverse_reach);
  if constexpr (gated)
    weight *= near.open;
  near.number = weight * (2.0f * a * a2 - b * b2);
  sum.number += near.number;
  sum.pressure += near.number * tile(q.pressure);
  near.inverse_r = inverse_r;
  near.k = weight * inverse_reach * (a2 - b2) * inverse_r;
}

//! d.G d, from the symmetric part of G; \p turned turns the sign of the shears that cross the plate.
template <bool turned = false>
BIRDSTRIKE_INLINE Floats along(const Vector& d, const Floats (&g)[6])
{
  const Floats stretch = d.x * d.x * g[0] + d.y * d.y * g[1] + d.z * d.z * g[2];
  const Floats crossing = d.x * d.y * g[3] + d.x * d.z * g[4], shear = d.y * d.z * g[5];
  return turned ? stretch + (shear - crossing) : stretch + (shear + crossing);
}

//! Half of the harmonic mean of d.G d on both sides, zero where they disagree in sign: R_ij of artificial_viscosity.h but
//! for its share. The plate turns the sign of the shears that cross it; in general the image of G is that of d.
//! \param turned  d mirrored in the wall
template <Seen seen>
BIRDSTRIKE_INLINE Floats explained(const Side& i, const QuadState& q, const Vector& d,
                                   [[maybe_unused]] const Vector& turned)
{
  Floats g[6];
  for (int c = 0; c < 6; ++c)
    g[c] = tile(q.strain_rate[c]);
  const Floats a = along(d, i.strain_rate), zero{};
  Floats b;
  if constexpr (seen == Seen::in_wall)
    b = along(turned, g);
  else
    b = along<seen == Seen::in_plate>(d, g);
  const Floats product = a * b;
  return product > 0.0f ? product * reciprocal(a + b) : zero;
}

//! The stresses between the lanes i and the four of quad q: near.push, and what comes of them alone. Factors that all terms
//! share are left out, see QuadSums.
//! \param other  sums of the partners; null where they get none
//! \param v      v_j - v_i; an image's own values stand at j
template <Seen seen, bool limited, bool mixed>
BIRDSTRIKE_INLINE void find_stress(Sums& sum, QuadSums* other, const Side& i, const QuadState& q, Near& near,
                                   const Vector& v, float beta, const Vector& turned = Vector())
{
  const Floats zero{}, k = near.k;
  const Vector& d = near.d;
  const Floats parting = d.x * v.x + d.y * v.y + d.z * v.z; // (v_j - v_i).d > 0: they approach
  const Floats approach = max(parting, zero);
  const Floats sound_speed = i.sound_speed + tile(q.sound_speed); // times alpha
  const Floats lightness_j = tile(q.lightness);
  Floats speed, viscosity; // U or |mu|, and Q of artificial_viscosity.h
  if constexpr (limited) {
    const Floats share = i.smooth + tile(q.smooth); // doubled, as what is explained is halved
    speed = min(max(share * explained<seen>(i, q, d, turned) + approach, zero), approach) * near.inverse_r;
    viscosity = reciprocal(i.lightness + lightness_j) * (speed + speed) * (sound_speed + beta * speed);
  } else {
    const Floats reach = i.support + tile(q.support), r2 = d.x * d.x + d.y * d.y + d.z * d.z;
    speed = 0.5f * approach * reach * reciprocal(r2 + 0.0025f * reach * reach);
    const Floats inertia = (i.lightness + lightness_j) * reciprocal(i.lightness * lightness_j);
    viscosity = 0.25f * inertia * (2.0f - (i.smooth + tile(q.smooth))) * speed * (sound_speed + beta * speed);
  }

  if constexpr (mixed) {
    const Floats rest_j = tile(q.rest_density), inverse = 2.0f * reciprocal(i.rest_density + rest_j);
    const Floats share_i = rest_j * inverse, share_j = i.rest_density * inverse;
    near.push = k * (share_i * i.stress + share_j * tile(q.stress) + viscosity);
    const Floats work = k * parting;
    sum.extra_work += share_i * work - work;
    near.extra_work = share_j * work - work;
  } else {
    near.push = k * (i.stress + tile(q.stress) + viscosity);
  }
  near.heating = k * viscosity * approach;
  sum.heating += near.heating;
  const Floats mu = k > 0.0f ? speed : zero;
  sum.mu = max(sum.mu, mu);
  if (other)
    combine_groups(mu, other->row(QuadSums::mu), Largest());
}

//! Force and velocity gradient of the lanes i, and all sums of their partners. As seen from j, d and v are opposite; in the
//! plate, along y and z only.
template <Seen seen, bool mixed>
BIRDSTRIKE_INLINE void add_pairs(Sums& sum, QuadSums* other, const Side& i, const Near& near, const Vector& v)
{
  const Vector& d = near.d;
  const Floats fx = near.push * d.x, fy = near.push * d.y, fz = near.push * d.z;
  sum.fx += fx, sum.fy += fy, sum.fz += fz;
  if constexpr (seen != Seen::direct)
    sum.wall += fx;
  if constexpr (seen == Seen::in_wall)
    sum.wall_y += fy, sum.wall_z += fz;
  const Floats gx = near.k * d.x, gy = near.k * d.y, gz = near.k * d.z;
  const Floats g[9] = {v.x * gx, v.x * gy, v.x * gz, v.y * gx, v.y * gy,
                       v.y * gz, v.z * gx, v.z * gy, v.z * gz};
  for (int c = 0; c < 9; ++c)
    sum.gradient[c] += g[c];
  if constexpr (seen != Seen::in_wall)
    if (other) {
      constexpr bool image = seen == Seen::in_plate;
      const auto turned = [](Floats a) { return image ? -a : a; };
      add_groups({image ? fx : -fx, -fy, -fz, near.number}, other->row(QuadSums::fx));
      add_groups({g[0], turned(g[1]), turned(g[2]), turned(g[3])}, other->row(QuadSums::gradient));
      add_groups({g[4], g[5], turned(g[6]), g[7]}, other->row(QuadSums::gradient + 4));
      add_groups({g[8], near.number * i.pressure, near.heating, mixed ? near.extra_work : Floats{}},
                 other->row(QuadSums::gradient + 8));
      if constexpr (image)
        combine_groups(fx, other->row(QuadSums::wall), Sum());
    }
}

struct Unit
{
  float x, y, z;
};

BIRDSTRIKE_INLINE Vector difference(const Side& i, const QuadState& q, const Unit& unit)
{
  return {to_floats(whole_difference(i.x, tile(q.x))) * unit.x,
          to_floats(whole_difference(i.y, tile(q.y))) * unit.y,
          to_floats(whole_difference(i.z, tile(q.z))) * unit.z};
}
BIRDSTRIKE_INLINE Vector relative_velocity(const Side& i, const QuadState& q)
{
  return {tile(q.vx) - i.vx, tile(q.vy) - i.vy, tile(q.vz) - i.vz};
}

//! The lanes' own walls.
struct Walls
{
  Floats x, y, z, height, speed, open;
};
BIRDSTRIKE_INLINE Walls spread_walls(const QuadWalls& w, int row)
{
  return {spread(w.x + row),      spread(w.y + row),     spread(w.z + row),
          spread(w.height + row), spread(w.speed + row), spread(w.open + row)};
}

BIRDSTRIKE_INLINE bool has_images(std::int32_t quad, const PairInput& in, const MirrorPlate& plate)
{
  return plate.present && in.gap[quad] < static_cast<float>(plate.reach);
}

BIRDSTRIKE_INLINE bool any_open(const QuadWalls& w)
{
  return w.open[0] > 0 || w.open[1] > 0 || w.open[2] > 0 || w.open[3] > 0;
}

//! 1, less where a wall stands between the lanes and j: each behind the other's, and these face apart.
BIRDSTRIKE_INLINE Floats open_past_walls(const Walls& i, const QuadWalls& w, const Vector& d)
{
  const Floats zero{}, one = zero + 1.0f;
  const Floats x = tile(w.x), y = tile(w.y), z = tile(w.z);
  const Floats of_j = i.height - (d.x * i.x + d.y * i.y + d.z * i.z);
  const Floats of_i = tile(w.height) + (d.x * x + d.y * y + d.z * z);
  const Floats facing = x * i.x + y * i.y + z * i.z;
  Floats shut = min(i.open, tile(w.open));
  shut = of_j < 0.0f ? shut : zero;
  shut = of_i < 0.0f ? shut : zero;
  shut = facing < 0.0f ? shut : zero;
  return one - shut;
}

//! Which quads a quad meets, and what it takes to do so.
struct Meeting
{
  std::int32_t self;
  const std::int32_t* partners;
  int count;
  QuadSums* sums; //!< of all quads
  const PairInput& in;
  const PairSettings& settings;
  Unit unit;
  float beta;

  //! Where the partner's share goes; null for the quad itself, all of whose pairs are seen from both sides anyway.
  QuadSums* other(std::int32_t partner) const { return partner == self ? nullptr : sums + partner; }
};

//! \p find of all partners, then \p weigh, \p stress and \p add of those that are near. Each loop keeps its numbers in registers
//! and is short enough for the processor to work on several partners at once; and what would add nothing is left out.
template <class Find, class Weigh, class Stress, class Add>
BIRDSTRIKE_INLINE void for_near(const Meeting& meeting, const Find& find, const Weigh& weigh,
                                const Stress& stress, const Add& add)
{
  Near near[near_at_once];
  for (int next = 0; next < meeting.count;) {
    int count = 0;
    for (; next < meeting.count && count < near_at_once; ++next)
      count += find(meeting.partners[next], near[count]);
    for (int n = 0; n < count; ++n)
      weigh(near[n]);
    for (int n = 0; n < count; ++n)
      stress(near[n]);
    for (int n = 0; n < count; ++n)
      add(near[n]);
  }
}

template <bool limited, bool mixed, bool walls>
void add_direct(Sums& total, const Side& i, [[maybe_unused]] const Walls& wall, const Meeting& meeting)
{
  const PairInput& in = meeting.in;
  Sums sum; // in registers
  for_near(
      meeting,
      [&](std::int32_t partner, Near& near) {
        const QuadState& q = in.quads[partner];
        const Vector d = difference(i, q, meeting.unit);
        Floats open{};
        if constexpr (walls)
          open = open_past_walls(wall, in.walls[partner], d);
        return meet<walls>(i, q, partner, d, open, near);
      },
      [&](Near& near) { weigh<walls>(sum, i, in.quads[near.partner], near); },
      [&](Near& near) {
        const QuadState& q = in.quads[near.partner];
        find_stress<Seen::direct, limited, mixed>(sum, meeting.other(near.partner), i, q, near,
                                                  relative_velocity(i, q), meeting.beta);
      },
      [&](const Near& near) {
        add_pairs<Seen::direct, mixed>(sum, meeting.other(near.partner), i, near,
                                       relative_velocity(i, in.quads[near.partner]));
      });
  total += sum;
}

//! The images of the partners behind the plate, and those of the quad's own rows as the partners see them: both are as far
//! apart. An image is never nearer than its original, so the quad's own list holds all that can matter. A pair acts where
//! the line from lane to image passes through the plate, which is the same point for i and the image of j as for j and the
//! image of i: action stays equal to reaction at the rim.
template <bool limited, bool mixed>
void add_images(Sums& total, const Side& i, Floats absolute_y, Floats absolute_z, const Meeting& meeting)
{
  const PairInput& in = meeting.in;
  const MirrorPlate& plate = meeting.settings.plate;
  const Floats zero{}, one = zero + 1.0f;
  const Floats own_x = to_floats(i.x) * meeting.unit.x;
  const float image_reach = static_cast<float>(plate.reach) - in.gap[meeting.self];
  // Both sides of a pair within the quad find the crossing for themselves, right to single precision: one that is on the
  // rim counts for both.
  constexpr float rim = 1 + 4e-7f;
  const float half_y = rim * static_cast<float>(plate.half_y),
              half_z = rim * static_cast<float>(plate.half_z);
  const auto velocity_of = [&](const QuadState& q) { // of the image
    const Vector v = relative_velocity(i, q);
    return Vector{-i.vx - tile(q.vx), v.y, v.z};
  };
  Sums sum; // in registers
  for_near(
      meeting,
      [&](std::int32_t partner, Near& near) {
        if (in.gap[partner] >= image_reach)
          return false;
        const QuadState& q = in.quads[partner];
        Vector d = difference(i, q, meeting.unit);
        const Floats x_j = to_floats(tile(q.x)) * meeting.unit.x;
        d.x = own_x + x_j; // x_i - (-x_j) < 0
        Floats open = own_x < 0.0f ? one : zero;
        open = x_j < 0.0f ? open : zero;
        if (!plate.endless) {
          const Floats share = own_x / min(d.x, zero - 1e-30f); // of the way to the image
          const Floats cross_y = absolute_y - share * d.y, cross_z = absolute_z - share * d.z;
          open = max(cross_y, -cross_y) <= half_y ? open : zero;
          open = max(cross_z, -cross_z) <= half_z ? open : zero;
        }
        return meet<true>(i, q, partner, d, open, near);
      },
      [&](Near& near) { weigh<true>(sum, i, in.quads[near.partner], near); },
      [&](Near& near) {
        const QuadState& q = in.quads[near.partner];
        find_stress<Seen::in_plate, limited, mixed>(sum, meeting.other(near.partner), i, q, near,
                                                    velocity_of(q), meeting.beta);
      },
      [&](const Near& near) {
        add_pairs<Seen::in_plate, mixed>(sum, meeting.other(near.partner), i, near,
                                         velocity_of(in.quads[near.partner]));
      });
  total += sum;
}

//! The images of the partners in the lanes' own walls, for the lanes alone: walls differ. A pair acts where both stand
//! before walls that face one way.
template <bool limited, bool mixed>
void add_wall_images(Sums& total, const Side& i, const Walls& wall, const Meeting& meeting)
{
  constexpr float same_way = 0.5f; // cosine between the normals: the other side of an edge has its own flow
  const PairInput& in = meeting.in;
  const Floats zero{};
  const auto velocity_of = [&](const QuadState& q) { // of the image
    const Vector v = relative_velocity(i, q);
    const Floats away = 2.0f * (tile(q.vx) * wall.x + tile(q.vy) * wall.y + tile(q.vz) * wall.z - wall.speed);
    return Vector{v.x - away * wall.x, v.y - away * wall.y, v.z - away * wall.z};
  };
  Sums sum; // in registers
  for_near(
      meeting,
      [&](std::int32_t partner, Near& near) {
        const QuadState& q = in.quads[partner];
        const QuadWalls& w = in.walls[partner];
        if (!any_open(w))
          return false;
        const Vector direct = difference(i, q, meeting.unit);
        const Floats height = // of j above the lane's wall
            wall.height - (direct.x * wall.x + direct.y * wall.y + direct.z * wall.z);
        const Floats facing = tile(w.x) * wall.x + tile(w.y) * wall.y + tile(w.z) * wall.z;
        Floats open = min(wall.open, tile(w.open));
        open = height > 0.0f ? open : zero;
        open = wall.height > 0.0f ? open : zero;
        open = facing > same_way ? open : zero;
        const Floats lift = 2.0f * height;
        const Vector d{direct.x + lift * wall.x, direct.y + lift * wall.y, direct.z + lift * wall.z};
        return meet<true>(i, q, partner, d, open, near);
      },
      [&](Near& near) { weigh<true>(sum, i, in.quads[near.partner], near); },
      [&](Near& near) {
        const QuadState& q = in.quads[near.partner];
        const Vector& d = near.d;
        const Floats across = 2.0f * (d.x * wall.x + d.y * wall.y + d.z * wall.z);
        find_stress<Seen::in_wall, limited, mixed>(
            sum, nullptr, i, q, near, velocity_of(q), meeting.beta,
            {d.x - across * wall.x, d.y - across * wall.y, d.z - across * wall.z});
      },
      [&](const Near& near) {
        add_pairs<Seen::in_wall, mixed>(sum, nullptr, i, near, velocity_of(in.quads[near.partner]));
      });
  total += sum;
}

//! Adds up the lanes of each row.
BIRDSTRIKE_INLINE void store(const Sums& sum, bool images, QuadSums& to, int row)
{
  const Floats(&g)[9] = sum.gradient;
  add_within_groups({sum.fx, sum.fy, sum.fz, sum.number}, to.row(QuadSums::fx) + row);
  add_within_groups({g[0], g[1], g[2], g[3]}, to.row(QuadSums::gradient) + row);
  add_within_groups({g[4], g[5], g[6], g[7]}, to.row(QuadSums::gradient + 4) + row);
  add_within_groups({g[8], sum.pressure, sum.heating, sum.extra_work}, to.row(QuadSums::gradient + 8) + row);
  if (images)
    add_within_groups({sum.wall, sum.wall_y, sum.wall_z, Floats{}},
                      to.row(QuadSums::wall) + row); // nothing to mu
  find_largest_within_groups(sum.mu, to.row(QuadSums::mu) + row);
}

//! Partners that have the quad's rest density, or those that have not.
template <bool limited, bool mixed>
BIRDSTRIKE_INLINE void meet_all(Sums& sum, const Side& i, int row, const Meeting& meeting)
{
  const PairInput& in = meeting.in;
  if (in.walls && any_open(in.walls[meeting.self])) {
    const Walls wall = spread_walls(in.walls[meeting.self], row);
    add_direct<limited, mixed, true>(sum, i, wall, meeting);
    add_wall_images<limited, mixed>(sum, i, wall, meeting);
  } else {
    add_direct<limited, mixed, false>(sum, i, Walls(), meeting);
  }
  if (has_images(meeting.self, in, meeting.settings.plate))
    add_images<limited, mixed>(sum, i, spread(in.absolute_y + meeting.self * quad_size + row),
                               spread(in.absolute_z + meeting.self * quad_size + row), meeting);
}

//! The images of the quad's rows in its partners' walls.
template <bool limited, bool mixed>
void add_wall_images_of_partners(const Quad* quads, const Meeting& meeting)
{
  const PairInput& in = meeting.in;
  for (int n = 0; n < meeting.count; ++n) {
    const std::int32_t partner = meeting.partners[n];
    if (partner == meeting.self || !any_open(in.walls[partner]))
      continue;
    Meeting back = meeting;
    back.self = partner, back.partners = &meeting.self, back.count = 1;
    for (int row = 0; row < quads[partner].count; row += rows_at_once) {
      Sums sum;
      add_wall_images<limited, mixed>(sum, spread_side(in.quads[partner], row),
                                      spread_walls(in.walls[partner], row), back);
      if (any_positive(sum.number))
        store(sum, true, meeting.sums[partner], row);
    }
  }
}

template <bool limited>
void rates_of(const Quad* quads, std::int32_t quad, const std::int32_t* all_partners, const PairInput& in,
              const PairSettings& s, QuadSums* sums)
{
  const Quad& list = quads[quad];
  const std::int32_t* const partners = all_partners + list.first;
  const Unit unit{static_cast<float>(s.unit.x), static_cast<float>(s.unit.y), static_cast<float>(s.unit.z)};
  const auto beta = static_cast<float>(s.beta);
  const Meeting alike{quad, partners, list.alike, sums, in, s, unit, beta};
  const Meeting unlike{quad, partners + list.alike, list.partners - list.alike, sums, in, s, unit, beta};
  const bool before_wall = in.walls && any_open(in.walls[quad]), ahead = has_images(quad, in, s.plate);
  for (int row = 0; row < list.count; row += rows_at_once) {
    const Side i = spread_side(in.quads[quad], row);
    Sums sum;
    meet_all<limited, false>(sum, i, row, alike);
    if (unlike.count > 0)
      meet_all<limited, true>(sum, i, row, unlike);
    store(sum, before_wall || ahead, sums[quad], row);
  }
  if (before_wall) {
    add_wall_images_of_partners<limited, false>(quads, alike);
    add_wall_images_of_partners<limited, true>(quads, unlike);
  }
}

void rates(const Quad* quads, std::int32_t quad, const std::int32_t* partners, const PairInput& in,
           const PairSettings& settings, QuadSums* sums)
{
  const FlushToZero flush;
  const auto sum = settings.limited ? rates_of<true> : rates_of<false>;
  sum(quads, quad, partners, in, settings, sums);
}

int search(const QuadPlace& quad, const QuadPlace* places, const QuadRun* runs, int run_count,
           const PairUnits& unit, std::int32_t* found, std::int64_t* neighbours)
{
  const FlushToZero flush;
  constexpr int parts = quad_size / rows_at_once;
  const Floats zero{};
  const auto ux = static_cast<float>(unit.x), uy = static_cast<float>(unit.y),
             uz = static_cast<float>(unit.z);
  Ints x[parts], y[parts], z[parts];
  Floats support[parts], reach[parts];
  for (int k = 0; k < parts; ++k) {
    const int row = k * rows_at_once;
    x[k] = spread(quad.x + row), y[k] = spread(quad.y + row), z[k] = spread(quad.z + row);
    support[k] = spread(quad.support + row), reach[k] = spread(quad.reach + row);
  }
  int count = 0;
  Ints close{};
  for (int r = 0; r < run_count; ++r)
    for (int j = runs[r].begin; j < runs[r].end; ++j) {
      const QuadPlace& p = places[j];
      bool listed = false;
      for (int k = 0; k < parts; ++k) {
        const Floats dx = to_floats(whole_difference(x[k], tile(p.x))) * ux,
                     dy = to_floats(whole_difference(y[k], tile(p.y))) * uy,
                     dz = to_floats(whole_difference(z[k], tile(p.z))) * uz;
        const Floats r2 = dx * dx + dy * dy + dz * dz;
        const Floats near = max(support[k] + tile(p.support), zero),
                     far = max(reach[k] + tile(p.reach), zero);
        close -= r2 < near * near; // true is -1
        listed |= any_positive(far * far - r2);
      }
      found[count] = j;
      count += listed;
    }
  for (int l = 0; l < lanes; ++l)
    *neighbours += close[l];
  return count;
}

#define BIRDSTRIKE_TEXT(name) #name
#define BIRDSTRIKE_STRING(name) BIRDSTRIKE_TEXT(name)
#define BIRDSTRIKE_JOIN(a, b) a##b
#define BIRDSTRIKE_TABLE(name) BIRDSTRIKE_JOIN(pair_kernels_, name)

} // namespace

extern const PairKernels BIRDSTRIKE_TABLE(BIRDSTRIKE_ISA_NAME);
const PairKernels BIRDSTRIKE_TABLE(BIRDSTRIKE_ISA_NAME){BIRDSTRIKE_STRING(BIRDSTRIKE_ISA_NAME), rates,
                                                        search};

} // namespace birdstrike
