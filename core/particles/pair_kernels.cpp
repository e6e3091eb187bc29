// SPDX-License-Identifier: BSD-3-Clause
// Compiled once for each instruction set: BIRDSTRIKE_ISA_NAME is plain, avx2 or avx512. All but the table at
// the end has internal linkage, so that no build can borrow another's instructions.
#include "core/particles/pair_kernels.h"
#include "core/simd.h"

#include <algorithm>
#include <numbers>

namespace birdstrike {
namespace {

//! One partner, broadcast to all lanes, or as many particles of a cluster as there are lanes.
template <class Number>
struct Side
{
  Number x, y, z, vx, vy, vz, h, weight, stress, sound_speed, inertia, rest_density, limiter;
  Number strain_rate[6];
};

[[gnu::always_inline]] inline Side<Pack> load_side(const PairInput& in, int row)
{
  return {load(in.x + row),
          load(in.y + row),
          load(in.z + row),
          load(in.vx + row),
          load(in.vy + row),
          load(in.vz + row),
          load(in.h + row),
          load(in.weight + row),
          load(in.stress + row),
          load(in.sound_speed + row),
          load(in.inertia + row),
          load(in.rest_density + row),
          load(in.limiter + row),
          {load(in.strain_rate[0] + row), load(in.strain_rate[1] + row), load(in.strain_rate[2] + row),
           load(in.strain_rate[3] + row), load(in.strain_rate[4] + row), load(in.strain_rate[5] + row)}};
}

struct Sums
{
  Pack fx{}, fy{}, fz{}, gradient[9]{}, number{}, pressure{}, work{}, heating{}, mu{}, wall{}, wall_y{},
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
  Pack x, y, z;
};

//! R_ij of artificial_viscosity.h but for its share: the harmonic mean of d.G d on both sides, zero where they disagree in
//! sign. The plate turns the sign of the shears that cross it; in general the image of G is that of d.
//! \param turned  d mirrored in the wall
template <Seen seen>
[[gnu::always_inline]] inline Pack explained(const Side<Pack>& i, const PairInput& in, int j, Pack dx,
                                             Pack dy, Pack dz, [[maybe_unused]] const Vector& turned)
{
  const Pack xx = dx * dx, yy = dy * dy, zz = dz * dz, xy = dx * dy, xz = dx * dz, yz = dy * dz;
  const Pack a = xx * i.strain_rate[0] + yy * i.strain_rate[1] + zz * i.strain_rate[2] +
                 xy * i.strain_rate[3] + xz * i.strain_rate[4] + yz * i.strain_rate[5];
  Pack b;
  if constexpr (seen == Seen::in_wall) {
    const auto& [ex, ey, ez] = turned;
    b = ex * ex * in.strain_rate[0][j] + ey * ey * in.strain_rate[1][j] + ez * ez * in.strain_rate[2][j] +
        ex * ey * in.strain_rate[3][j] + ex * ez * in.strain_rate[4][j] + ey * ez * in.strain_rate[5][j];
  } else {
    constexpr double turn = seen == Seen::in_plate ? -1 : 1;
    b = xx * in.strain_rate[0][j] + yy * in.strain_rate[1][j] + zz * in.strain_rate[2][j] +
        xy * (turn * in.strain_rate[3][j]) + xz * (turn * in.strain_rate[4][j]) + yz * in.strain_rate[5][j];
  }
  const Pack product = a * b, zero{};
  return product > 0.0 ? 2.0 * product / (a + b) : zero;
}

//! Add what partner j does to the lanes i. d is x_i - x_j, vx ... v_i - v_j; an image's own values stand at j. A lane
//! whose support does not reach j, or that is j itself, gets exactly nothing.
//! \param open  1 where the pair may act, 0 where something stands between
template <Seen seen, bool limited>
[[gnu::always_inline]] inline void
add_pair(Sums& sum, const Side<Pack>& i, const PairInput& in, int j, Pack dx, Pack dy, Pack dz, Pack vx,
         Pack vy, Pack vz, const PairSettings& s, [[maybe_unused]] Pack open, const Vector& turned = Vector())
{
  const Pack zero{};
  const Pack h = 0.5 * (i.h + in.h[j]);
  const Pack r2 = dx * dx + dy * dy + dz * dz;
  const Pack r = max(sqrt(r2), 1e-9 * h);
  // Their inverses, and those of two more numbers, from one division.
  const Pack third = limited ? i.inertia + in.inertia[j] : r2 + 0.01 * h * h;
  const Pack fourth = i.rest_density + in.rest_density[j];
  const Pack hr = h * r, last = third * fourth, inverse = 1.0 / (hr * last);
  const Pack inverse_h = inverse * r * last, inverse_r = inverse * h * last,
             inverse_third = inverse * hr * fourth, inverse_fourth = inverse * hr * third;

  // (1/r) dW/dr of 4.13 in truncated powers: -3/4 [(2-q)^2 - 4 (1-q)^2] / (pi h^4 r)
  const Pack q = r * inverse_h;
  const Pack a = max(2.0 - q, zero), b = max(1.0 - q, zero);
  const Pack inverse_h2 = inverse_h * inverse_h;
  Pack slope = (a * a - 4.0 * b * b) * inverse_h2 * inverse_h2 * inverse_r * (-0.75 / std::numbers::pi);
  Pack value = (0.25 * a * a * a - b * b * b) * inverse_h2 * inverse_h;
  if constexpr (seen != Seen::direct) {
    slope *= open;
    value *= open;
  }

  const Pack closing = dx * vx + dy * vy + dz * vz; // v_ij.d
  const Pack approach = min(closing, zero);
  const Pack sound_speed = 0.5 * (i.sound_speed + in.sound_speed[j]);
  Pack speed, viscosity; // U or |mu|, and Q of artificial_viscosity.h
  if constexpr (limited) {
    const Pack smooth = explained<seen>(i, in, j, dx, dy, dz, turned);
    const Pack share = 1.0 - 0.5 * (i.limiter + in.limiter[j]);
    speed = min(max(share * smooth - approach, zero), -approach) * inverse_r;
    viscosity =
        2.0 * i.inertia * in.inertia[j] * inverse_third * speed * (s.alpha * sound_speed + s.beta * speed);
  } else {
    speed = -approach * h * inverse_third;
    viscosity = 0.25 * (i.inertia + in.inertia[j]) * (i.limiter + in.limiter[j]) * speed *
                (s.alpha * sound_speed + s.beta * speed);
  }

  const double weight = in.weight[j];
  const Pack counted = (weight / std::numbers::pi) * value;
  sum.number += counted;
  sum.pressure += counted * in.pressure[j];
  const Pack k = weight * slope;
  const Pack share_i = 2.0 * in.rest_density[j] * inverse_fourth,
             share_j = 2.0 * i.rest_density * inverse_fourth;
  const Pack push = -k * (share_i * i.stress + share_j * in.stress[j] + viscosity);
  sum.work += share_i * k * closing;
  sum.fx += push * dx;
  sum.fy += push * dy;
  sum.fz += push * dz;
  if constexpr (seen == Seen::in_plate || seen == Seen::in_wall)
    sum.wall += push * dx;
  if constexpr (seen == Seen::in_wall) {
    sum.wall_y += push * dy;
    sum.wall_z += push * dz;
  }
  const Pack gx = k * dx, gy = k * dy, gz = k * dz;
  sum.gradient[0] -= vx * gx;
  sum.gradient[1] -= vx * gy;
  sum.gradient[2] -= vx * gz;
  sum.gradient[3] -= vy * gx;
  sum.gradient[4] -= vy * gy;
  sum.gradient[5] -= vy * gz;
  sum.gradient[6] -= vz * gx;
  sum.gradient[7] -= vz * gy;
  sum.gradient[8] -= vz * gz;
  sum.heating += (0.5 * k) * viscosity * approach;
  sum.mu = max(sum.mu, slope < 0.0 ? speed : zero);
}

//! Nearest image of a difference in a box that repeats.
[[gnu::always_inline]] inline Pack nearest_image(Pack d, double length)
{
  if (length > 0) {
    const Pack half = Pack{} + 0.5 * length;
    d = d > half ? d - length : d;
    d = d < -half ? d + length : d;
  }
  return d;
}

//! 1, less where a wall stands between the lanes and j: each behind the other's, and these face apart.
[[gnu::always_inline]] inline Pack open_past_walls(const Side<Pack>& i, const PairInput& in, int row, int j)
{
  const Pack zero{}, one = zero + 1.0;
  if (in.wall_open[j] <= 0)
    return one;
  const Pack nx = load(in.wall_x + row), ny = load(in.wall_y + row), nz = load(in.wall_z + row);
  const Pack of_j = in.x[j] * nx + in.y[j] * ny + in.z[j] * nz - load(in.wall_at + row);
  const Pack of_i = i.x * in.wall_x[j] + i.y * in.wall_y[j] + i.z * in.wall_z[j] - in.wall_at[j];
  const Pack facing = in.wall_x[j] * nx + in.wall_y[j] * ny + in.wall_z[j] * nz;
  Pack shut = min(load(in.wall_open + row), zero + in.wall_open[j]);
  shut = of_j < 0.0 ? shut : zero;
  shut = of_i < 0.0 ? shut : zero;
  shut = facing < 0.0 ? shut : zero;
  return one - shut;
}

template <bool periodic, bool limited, bool walls>
Sums sum_direct(const Side<Pack>& i, [[maybe_unused]] int row, const std::int32_t* partners, int count,
                const PairInput& in, const PairSettings& s)
{
  Sums sum;
  for (int n = 0; n < count; ++n) {
    const int j = partners[n];
    Pack dy = i.y - in.y[j], dz = i.z - in.z[j];
    if constexpr (periodic) {
      dy = nearest_image(dy, s.period.y);
      dz = nearest_image(dz, s.period.z);
    }
    Pack open{};
    if constexpr (walls)
      open = open_past_walls(i, in, row, j);
    add_pair<walls ? Seen::past_wall : Seen::direct, limited>(
        sum, i, in, j, i.x - in.x[j], dy, dz, i.vx - in.vx[j], i.vy - in.vy[j], i.vz - in.vz[j], s, open);
  }
  return sum;
}

//! The images of the partners behind the plate. An image is never nearer than its original, so the cluster's
//! own list holds all that can matter. A pair acts where the line from lane to image passes through the
//! plate, which is the same point for i and the image of j as for j and the image of i: action stays equal to
//! reaction at the rim.
template <bool periodic, bool limited>
void add_images(Sums& sum, const Side<Pack>& i, const std::int32_t* partners, int count, const PairInput& in,
                const PairSettings& s)
{
  const Pack zero{}, one = zero + 1.0;
  for (int n = 0; n < count; ++n) {
    const int j = partners[n];
    if (in.x[j] >= 0)
      continue;
    Pack dy = i.y - in.y[j], dz = i.z - in.z[j];
    if constexpr (periodic) {
      dy = nearest_image(dy, s.period.y);
      dz = nearest_image(dz, s.period.z);
    }
    const Pack dx = i.x + in.x[j];                   // x_i - (-x_j) < 0
    const Pack share = i.x / min(dx, zero - 1e-300); // of the way to the image
    const Pack cross_y = i.y - share * dy, cross_z = i.z - share * dz;
    Pack open = i.x < 0.0 ? one : zero;
    if constexpr (!periodic) {
      open = max(cross_y, -cross_y) <= s.plate.half_y ? open : zero;
      open = max(cross_z, -cross_z) <= s.plate.half_z ? open : zero;
    }
    add_pair<Seen::in_plate, limited>(sum, i, in, j, dx, dy, dz, i.vx + in.vx[j], i.vy - in.vy[j],
                                      i.vz - in.vz[j], s, open);
  }
}

//! The images of the partners in the lanes' own walls. A pair acts where both stand before walls that face one way.
template <bool limited>
void add_wall_images(Sums& sum, const Side<Pack>& i, int row, const std::int32_t* partners, int count,
                     const PairInput& in, const PairSettings& s)
{
  constexpr double same_way = 0.5; // cosine between the normals: the other side of an edge has its own flow
  const Pack zero{};
  const Pack nx = load(in.wall_x + row), ny = load(in.wall_y + row), nz = load(in.wall_z + row),
             at = load(in.wall_at + row), speed = load(in.wall_speed + row),
             open_i = load(in.wall_open + row);
  const Pack height_i = i.x * nx + i.y * ny + i.z * nz - at;
  for (int n = 0; n < count; ++n) {
    const int j = partners[n];
    if (in.wall_open[j] <= 0)
      continue;
    const Pack height = in.x[j] * nx + in.y[j] * ny + in.z[j] * nz - at; // of j above the lane's wall
    const Pack facing = in.wall_x[j] * nx + in.wall_y[j] * ny + in.wall_z[j] * nz;
    Pack open = min(open_i, zero + in.wall_open[j]);
    open = height > 0.0 ? open : zero;
    open = height_i > 0.0 ? open : zero;
    open = facing > same_way ? open : zero;
    const Pack lift = 2.0 * height;
    const Pack dx = i.x - in.x[j] + lift * nx, dy = i.y - in.y[j] + lift * ny, dz = i.z - in.z[j] + lift * nz;
    const Pack away = 2.0 * (in.vx[j] * nx + in.vy[j] * ny + in.vz[j] * nz - speed);
    const Pack across = 2.0 * (dx * nx + dy * ny + dz * nz);
    add_pair<Seen::in_wall, limited>(sum, i, in, j, dx, dy, dz, i.vx - in.vx[j] + away * nx,
                                     i.vy - in.vy[j] + away * ny, i.vz - in.vz[j] + away * nz, s, open,
                                     {dx - across * nx, dy - across * ny, dz - across * nz});
  }
}

[[gnu::always_inline]] inline void store(double* to, Pack pack, int count)
{
  std::memcpy(to, &pack, static_cast<std::size_t>(count) * sizeof(double));
}

//! The lanes row ... row + count - 1 of a cluster.
template <bool periodic, bool limited>
void rates_of(const Cluster& cluster, int row, int count, const std::int32_t* all_partners,
              const PairInput& in, const PairSettings& s, const PairOutput& out)
{
  const std::int32_t* partners = all_partners + cluster.first;
  const Side<Pack> i = load_side(in, row);
  bool wall = false; // does one of the lanes stand before one?
  for (int l = 0; in.wall_open && l < count; ++l)
    wall = wall || in.wall_open[row + l] > 0;
  Sums sum = wall ? sum_direct<periodic, limited, true>(i, row, partners, cluster.partners, in, s)
                  : sum_direct<periodic, limited, false>(i, row, partners, cluster.partners, in, s);

  if (s.plate.present) {
    double nearest = -1e300;
    for (int l = 0; l < count; ++l)
      nearest = i.x[l] < 0 && i.x[l] > nearest ? i.x[l] : nearest;
    if (nearest > -s.plate.reach)
      add_images<periodic, limited>(sum, i, partners, cluster.partners, in, s);
  }

  if (in.wall_open) {
    if (wall)
      add_wall_images<limited>(sum, i, row, partners, cluster.partners, in, s);
    store(out.wall_y + row, sum.wall_y, count);
    store(out.wall_z + row, sum.wall_z, count);
  }

  store(out.fx + row, sum.fx, count);
  store(out.fy + row, sum.fy, count);
  store(out.fz + row, sum.fz, count);
  for (int c = 0; c < 9; ++c)
    store(out.gradient[c] + row, sum.gradient[c], count);
  store(out.number + row, sum.number, count);
  store(out.pressure + row, sum.pressure, count);
  store(out.work + row, sum.work, count);
  store(out.heating + row, sum.heating, count);
  store(out.mu + row, sum.mu, count);
  store(out.wall + row, sum.wall, count);
}

template <bool periodic, bool limited>
void rates_as(const Cluster* clusters, int begin, int end, const std::int32_t* partners, const PairInput& in,
              const PairSettings& settings, const PairOutput& out)
{
  for (int c = begin; c < end; ++c)
    for (int lane = 0; lane < clusters[c].count; lane += lanes) {
      const int row = clusters[c].begin + lane, count = std::min(lanes, clusters[c].count - lane);
      rates_of<periodic, limited>(clusters[c], row, count, partners, in, settings, out);
    }
}

void rates(const Cluster* clusters, int begin, int end, const std::int32_t* partners, const PairInput& in,
           const PairSettings& settings, const PairOutput& out)
{
  const bool periodic = settings.period.y > 0 || settings.period.z > 0;
  const auto loop = settings.limited ? (periodic ? rates_as<true, true> : rates_as<false, true>)
                                     : (periodic ? rates_as<true, false> : rates_as<false, false>);
  loop(clusters, begin, end, partners, in, settings, out);
}

int search(const Cluster& cluster, int begin, int end, const double* x, const double* y, const double* z,
           const double* h, const double* reach, Period period, std::int32_t* found, std::int64_t* neighbours)
{
  constexpr int most_packs = cluster_size / lanes;
  const int packs = (cluster.count + lanes - 1) / lanes;
  Pack xi[most_packs]{}, yi[most_packs]{}, zi[most_packs]{}, hi[most_packs]{}, reach_i[most_packs]{};
  for (int k = 0; k < packs; ++k) {
    const int row = cluster.begin + k * lanes;
    xi[k] = load(x + row), yi[k] = load(y + row), zi[k] = load(z + row), hi[k] = load(h + row),
    reach_i[k] = load(reach + row);
    for (int l = 0; l < lanes; ++l)
      if (k * lanes + l >= cluster.count)
        hi[k][l] = reach_i[k][l] = -1e300; // idle lanes reach nothing
  }
  int count = 0;
  PackMask close{};
  for (int j = begin; j < end; ++j) {
    PackMask reached{};
    for (int k = 0; k < packs; ++k) {
      const Pack dx = xi[k] - x[j];
      const Pack dy = nearest_image(yi[k] - y[j], period.y), dz = nearest_image(zi[k] - z[j], period.z);
      const Pack r2 = dx * dx + dy * dy + dz * dz;
      const Pack support = max(hi[k] + h[j], Pack{}), listed = max(reach_i[k] + reach[j], Pack{});
      close -= r2 < support * support; // true is -1
      reached |= r2 < listed * listed;
    }
    if (any(reached))
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
