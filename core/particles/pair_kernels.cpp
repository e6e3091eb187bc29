// SPDX-License-Identifier: BSD-3-Clause
// Compiled once for each instruction set: BIRDSTRIKE_ISA_NAME is plain, avx2 or avx512. All but the table at
// the end has internal linkage, so that no build can borrow another's instructions.
#include "core/particles/pair_kernels.h"
#include "core/simd.h"

#include <algorithm>

namespace birdstrike {
namespace {

constexpr int rows_at_once = lanes / quad_size; // of the quad whose sums are made

//! A quad's numbers, one particle a group of four lanes (ours) or one a lane of each group (the partners').
struct Side
{
  Ints x, y, z;
  Floats vx, vy, vz, support, stress, sound_speed, inertia, limiter;
  Floats strain_rate[6];
  Floats rest_density;
};

//! Rows row ... row + rows_at_once - 1 of a quad.
BIRDSTRIKE_INLINE Side spread_side(const QuadState& q, int row)
{
  Side side{spread<Ints>(q.x + row),
            spread<Ints>(q.y + row),
            spread<Ints>(q.z + row),
            spread<Floats>(q.vx + row),
            spread<Floats>(q.vy + row),
            spread<Floats>(q.vz + row),
            spread<Floats>(q.support + row),
            spread<Floats>(q.stress + row),
            spread<Floats>(q.sound_speed + row),
            spread<Floats>(q.inertia + row),
            spread<Floats>(q.limiter + row),
            {},
            spread<Floats>(q.rest_density + row)};
  for (int c = 0; c < 6; ++c)
    side.strain_rate[c] = spread<Floats>(q.strain_rate[c] + row);
  return side;
}

struct Sums
{
  Floats fx{}, fy{}, fz{}, gradient[9]{}, number{}, pressure{}, work{}, heating{}, mu{}, wall{}, wall_y{},
      wall_z{};
};

//! What partner j is: itself, its image in the plate x = 0, or its image in a plane of the lane's own.
enum class Seen
{
  direct,
  past_wall, //!< itself, but for what a wall between the two hides
  in_plate,
  in_wall
};

struct Vector
{
  Floats x, y, z;
};

//! d.G d, from the symmetric part of G.
BIRDSTRIKE_INLINE Floats along(const Vector& d, const Floats (&g)[6])
{
  return d.x * d.x * g[0] + d.y * d.y * g[1] + d.z * d.z * g[2] + d.x * d.y * g[3] + d.x * d.z * g[4] +
         d.y * d.z * g[5];
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
  else if constexpr (seen == Seen::in_plate)
    b = d.x * d.x * g[0] + d.y * d.y * g[1] + d.z * d.z * g[2] - d.x * d.y * g[3] - d.x * d.z * g[4] +
        d.y * d.z * g[5];
  else
    b = along(d, g);
  const Floats product = a * b;
  return product > 0.0f ? product / (a + b) : zero;
}

//! Add what the four of quad q do to the lanes i. d is x_i - x_j, v v_i - v_j; an image's own values stand at j. A lane
//! whose support does not reach j, or that is j itself, gets exactly nothing. Factors that all terms share are left to
//! store().
//! \param open  1 where the pair may act, 0 where something stands between
template <Seen seen, bool limited, bool mixed>
BIRDSTRIKE_INLINE void add_pairs(Sums& sum, const Side& i, const QuadState& q, const Vector& d,
                                 const Vector& v, float beta, [[maybe_unused]] Floats open,
                                 const Vector& turned = Vector())
{
  const Floats zero{};
  const Floats reach = i.support + tile(q.support); // 2 h_ij: where the kernel ends
  const Floats r2 = max(d.x * d.x + d.y * d.y + d.z * d.z, zero + 1e-12f);
  const Floats inverse_r = 1.0f / sqrt(r2);
  const Floats inverse_reach = 1.0f / reach;

  // 4.13 in truncated powers of s = r / (2h): W = 8 (2 A^3 - B^3) / (pi (2h)^3), A = 1 - s, B = 1 - 2s,
  // and -(1/r) dW/dr = 48 (A^2 - B^2) / (pi (2h)^4 r)
  const Floats s = r2 * inverse_r * inverse_reach;
  const Floats a = max(1.0f - s, zero), b = max(1.0f - 2.0f * s, zero);
  const Floats a2 = a * a, b2 = b * b, inverse_reach2 = inverse_reach * inverse_reach;
  const Floats weight = tile(q.weight);
  Floats k = weight * (a2 - b2) * (inverse_reach2 * inverse_reach2) * inverse_r; // a sixth of -V (1/r) dW/dr
  Floats counted = weight * (2.0f * a * a2 - b * b2) * (inverse_reach2 * inverse_reach);
  if constexpr (seen != Seen::direct) {
    k *= open;
    counted *= open;
  }

  const Floats closing = d.x * v.x + d.y * v.y + d.z * v.z; // v_ij.d
  const Floats approach = min(closing, zero);
  const Floats sound_speed = i.sound_speed + tile(q.sound_speed); // times alpha
  const Floats inertia_j = tile(q.inertia);
  Floats speed, viscosity; // U or |mu|, and Q of artificial_viscosity.h
  if constexpr (limited) {
    const Floats smooth = explained<seen>(i, q, d, turned);
    const Floats share = 2.0f - (i.limiter + tile(q.limiter)); // doubled, as smooth is halved
    speed = min(max(share * smooth - approach, zero), -approach) * inverse_r;
    viscosity = 2.0f * i.inertia * inertia_j / (i.inertia + inertia_j) * speed * (sound_speed + beta * speed);
  } else {
    speed = -0.5f * approach * reach / (r2 + 0.0025f * reach * reach);
    viscosity = 0.25f * (i.inertia + inertia_j) * (i.limiter + tile(q.limiter)) * speed *
                (sound_speed + beta * speed);
  }

  sum.number += counted;
  sum.pressure += counted * tile(q.pressure);
  Floats push;
  if constexpr (mixed) {
    const Floats rest_j = tile(q.rest_density), inverse = 2.0f / (i.rest_density + rest_j);
    const Floats share_i = rest_j * inverse, share_j = i.rest_density * inverse;
    push = k * (share_i * i.stress + share_j * tile(q.stress) + viscosity);
    sum.work += share_i * k * closing;
  } else {
    push = k * (i.stress + tile(q.stress) + viscosity);
    sum.work += k * closing;
  }
  sum.fx += push * d.x;
  sum.fy += push * d.y;
  sum.fz += push * d.z;
  if constexpr (seen == Seen::in_plate || seen == Seen::in_wall)
    sum.wall += push * d.x;
  if constexpr (seen == Seen::in_wall) {
    sum.wall_y += push * d.y;
    sum.wall_z += push * d.z;
  }
  const Floats gx = k * d.x, gy = k * d.y, gz = k * d.z;
  sum.gradient[0] += v.x * gx;
  sum.gradient[1] += v.x * gy;
  sum.gradient[2] += v.x * gz;
  sum.gradient[3] += v.y * gx;
  sum.gradient[4] += v.y * gy;
  sum.gradient[5] += v.y * gz;
  sum.gradient[6] += v.z * gx;
  sum.gradient[7] += v.z * gy;
  sum.gradient[8] += v.z * gz;
  sum.heating += k * viscosity * approach;
  sum.mu = max(sum.mu, k > 0.0f ? speed : zero);
}

struct Unit
{
  float x, y, z;
};

BIRDSTRIKE_INLINE Vector difference(const Side& i, const QuadState& q, const Unit& unit)
{
  return {to_floats(i.x - tile(q.x)) * unit.x, to_floats(i.y - tile(q.y)) * unit.y,
          to_floats(i.z - tile(q.z)) * unit.z};
}
BIRDSTRIKE_INLINE Vector relative_velocity(const Side& i, const QuadState& q)
{
  return {i.vx - tile(q.vx), i.vy - tile(q.vy), i.vz - tile(q.vz)};
}

//! The lanes' own walls.
struct Walls
{
  Floats x, y, z, height, speed, open;
};
BIRDSTRIKE_INLINE Walls spread_walls(const QuadWalls& w, int row)
{
  return {spread<Floats>(w.x + row),      spread<Floats>(w.y + row),     spread<Floats>(w.z + row),
          spread<Floats>(w.height + row), spread<Floats>(w.speed + row), spread<Floats>(w.open + row)};
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

template <bool limited, bool mixed, bool walls>
void add_direct(Sums& sum, const Side& i, [[maybe_unused]] const Walls& wall, const std::int32_t* partners,
                int count, const PairInput& in, const Unit& unit, float beta)
{
  for (int n = 0; n < count; ++n) {
    const QuadState& q = in.quads[partners[n]];
    const Vector d = difference(i, q, unit);
    Floats open{};
    if constexpr (walls)
      open = open_past_walls(wall, in.walls[partners[n]], d);
    add_pairs<walls ? Seen::past_wall : Seen::direct, limited, mixed>(sum, i, q, d, relative_velocity(i, q),
                                                                      beta, open);
  }
}

//! The images of the partners behind the plate. An image is never nearer than its original, so the quad's
//! own list holds all that can matter. A pair acts where the line from lane to image passes through the
//! plate, which is the same point for i and the image of j as for j and the image of i: action stays equal to
//! reaction at the rim.
template <bool limited, bool mixed>
void add_images(Sums& sum, const Side& i, Floats absolute_y, Floats absolute_z, const std::int32_t* partners,
                int count, const PairInput& in, const Unit& unit, const PairSettings& s)
{
  const Floats zero{}, one = zero + 1.0f;
  const Floats own_x = to_floats(i.x) * unit.x;
  const auto half_y = static_cast<float>(s.plate.half_y), half_z = static_cast<float>(s.plate.half_z);
  for (int n = 0; n < count; ++n) {
    const QuadState& q = in.quads[partners[n]];
    Vector d = difference(i, q, unit), v = relative_velocity(i, q);
    const Floats x_j = to_floats(tile(q.x)) * unit.x;
    d.x = own_x + x_j; // x_i - (-x_j) < 0
    v.x = i.vx + tile(q.vx);
    Floats open = own_x < 0.0f ? one : zero;
    open = x_j < 0.0f ? open : zero;
    if (!s.plate.endless) {
      const Floats share = own_x / min(d.x, zero - 1e-30f); // of the way to the image
      const Floats cross_y = absolute_y - share * d.y, cross_z = absolute_z - share * d.z;
      open = max(cross_y, -cross_y) <= half_y ? open : zero;
      open = max(cross_z, -cross_z) <= half_z ? open : zero;
    }
    add_pairs<Seen::in_plate, limited, mixed>(sum, i, q, d, v, static_cast<float>(s.beta), open);
  }
}

//! The images of the partners in the lanes' own walls. A pair acts where both stand before walls that face one way.
template <bool limited, bool mixed>
void add_wall_images(Sums& sum, const Side& i, const Walls& wall, const std::int32_t* partners, int count,
                     const PairInput& in, const Unit& unit, float beta)
{
  constexpr float same_way = 0.5f; // cosine between the normals: the other side of an edge has its own flow
  const Floats zero{};
  for (int n = 0; n < count; ++n) {
    const QuadState& q = in.quads[partners[n]];
    const QuadWalls& w = in.walls[partners[n]];
    if (!any_open(w))
      continue;
    const Vector direct = difference(i, q, unit), apart = relative_velocity(i, q);
    const Floats height = // of j above the lane's wall
        wall.height - (direct.x * wall.x + direct.y * wall.y + direct.z * wall.z);
    const Floats facing = tile(w.x) * wall.x + tile(w.y) * wall.y + tile(w.z) * wall.z;
    Floats open = min(wall.open, tile(w.open));
    open = height > 0.0f ? open : zero;
    open = wall.height > 0.0f ? open : zero;
    open = facing > same_way ? open : zero;
    const Floats lift = 2.0f * height;
    const Vector d{direct.x + lift * wall.x, direct.y + lift * wall.y, direct.z + lift * wall.z};
    const Floats away = 2.0f * (tile(q.vx) * wall.x + tile(q.vy) * wall.y + tile(q.vz) * wall.z - wall.speed);
    const Vector v{apart.x + away * wall.x, apart.y + away * wall.y, apart.z + away * wall.z};
    const Floats across = 2.0f * (d.x * wall.x + d.y * wall.y + d.z * wall.z);
    add_pairs<Seen::in_wall, limited, mixed>(
        sum, i, q, d, v, beta, open, {d.x - across * wall.x, d.y - across * wall.y, d.z - across * wall.z});
  }
}

//! Lanes of one row together, times what the terms left out.
BIRDSTRIKE_INLINE void store(const Sums& sum, QuadSums& to, int row)
{
  const auto add = [](Floats a, Floats b) { return a + b; };
  const auto total = [&](Floats a, float factor, float* out) { fold(factor * a, out + row, add); };
  total(sum.fx, 6, to.fx);
  total(sum.fy, 6, to.fy);
  total(sum.fz, 6, to.fz);
  for (int c = 0; c < 9; ++c)
    total(sum.gradient[c], 6, to.gradient[c]);
  total(sum.number, 1, to.number);
  total(sum.pressure, 1, to.pressure);
  total(sum.work, -6, to.work);
  total(sum.heating, -3, to.heating);
  fold(sum.mu, to.mu + row, [](Floats a, Floats b) { return max(a, b); });
  total(sum.wall, 6, to.wall);
  total(sum.wall_y, 6, to.wall_y);
  total(sum.wall_z, 6, to.wall_z);
}

template <bool limited, bool mixed>
void rates_of(int quad, const Quad& list, const std::int32_t* all_partners, const PairInput& in,
              const PairSettings& s, QuadSums& sums)
{
  const std::int32_t* partners = all_partners + list.first;
  const Unit unit{static_cast<float>(s.unit.x), static_cast<float>(s.unit.y), static_cast<float>(s.unit.z)};
  const auto beta = static_cast<float>(s.beta);
  const QuadState& own = in.quads[quad];
  const bool before_wall = in.walls && any_open(in.walls[quad]);
  for (int row = 0; row < list.count; row += rows_at_once) {
    const Side i = spread_side(own, row);
    Sums sum;
    if (before_wall) {
      const Walls wall = spread_walls(in.walls[quad], row);
      add_direct<limited, mixed, true>(sum, i, wall, partners, list.partners, in, unit, beta);
      add_wall_images<limited, mixed>(sum, i, wall, partners, list.partners, in, unit, beta);
    } else {
      add_direct<limited, mixed, false>(sum, i, Walls(), partners, list.partners, in, unit, beta);
    }
    if (s.plate.present && in.ahead[quad])
      add_images<limited, mixed>(sum, i, spread<Floats>(in.absolute_y + quad * quad_size + row),
                                 spread<Floats>(in.absolute_z + quad * quad_size + row), partners,
                                 list.partners, in, unit, s);
    store(sum, sums, row);
  }
}

void rates(const Quad* quads, int begin, int end, const std::int32_t* partners, const PairInput& in,
           const PairSettings& settings, QuadSums* sums)
{
  const FlushToZero flush;
  for (int q = begin; q < end; ++q) {
    const bool mixed = quads[q].mixed;
    const auto sum = settings.limited ? (mixed ? rates_of<true, true> : rates_of<true, false>)
                                      : (mixed ? rates_of<false, true> : rates_of<false, false>);
    sum(q, quads[q], partners, in, settings, sums[q - begin]);
  }
}

int search(const QuadPlace& quad, const QuadPlace* places, int begin, int end, const PairUnits& unit,
           std::int32_t* found, std::int64_t* neighbours)
{
  const FlushToZero flush;
  const Floats zero{};
  const auto ux = static_cast<float>(unit.x), uy = static_cast<float>(unit.y),
             uz = static_cast<float>(unit.z);
  Ints x[quad_size / rows_at_once], y[quad_size / rows_at_once], z[quad_size / rows_at_once];
  Floats support[quad_size / rows_at_once], reach[quad_size / rows_at_once];
  for (int k = 0; k < quad_size / rows_at_once; ++k) {
    const int row = k * rows_at_once;
    x[k] = spread<Ints>(quad.x + row), y[k] = spread<Ints>(quad.y + row), z[k] = spread<Ints>(quad.z + row);
    support[k] = spread<Floats>(quad.support + row), reach[k] = spread<Floats>(quad.reach + row);
  }
  int count = 0;
  Ints close{};
  for (int j = begin; j < end; ++j) {
    const QuadPlace& p = places[j];
    Ints listed{};
    for (int k = 0; k < quad_size / rows_at_once; ++k) {
      const Floats dx = to_floats(x[k] - tile(p.x)) * ux, dy = to_floats(y[k] - tile(p.y)) * uy,
                   dz = to_floats(z[k] - tile(p.z)) * uz;
      const Floats r2 = dx * dx + dy * dy + dz * dz;
      const Floats near = max(support[k] + tile(p.support), zero), far = max(reach[k] + tile(p.reach), zero);
      close -= r2 < near * near; // true is -1
      listed |= r2 < far * far;
    }
    bool any = false;
    for (int l = 0; l < lanes; ++l)
      any = any || listed[l] != 0;
    if (any)
      found[count++] = j;
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
