// SPDX-License-Identifier: BSD-3-Clause
// Small targets and birds for the tests of contact, and the loop's scheme for bodies that nothing but contact moves.
#pragma once

#include "core/contact/particle_contact.h"
#include "core/material/linear.h"

#include <limits>

namespace birdstrike::samples {

constexpr double endless = std::numeric_limits<double>::infinity();

//! What a ContactSurface looks at.
struct Target
{
  ShellMesh mesh;
  std::vector<Vector3> position, velocity;
  std::vector<double> mass, thickness, modulus;
  std::vector<std::uint8_t> gone;

  explicit Target(ShellMesh m, double t = 0.002, double node_mass = endless, double stiffness = endless)
      : mesh(std::move(m))
  {
    if (mesh.parts.empty())
      mesh.parts.push_back({"skin", t});
    position = mesh.points;
    velocity.assign(position.size(), Vector3::Zero());
    mass.assign(position.size(), node_mass);
    thickness.assign(mesh.elements.size(), t);
    modulus.assign(mesh.elements.size(), stiffness);
    gone.assign(mesh.elements.size(), 0);
  }
  ContactSurface view() const { return {mesh, position, velocity, mass, thickness, modulus, gone}; }
};

//! nu x nv quads; place(u, v) with 0 <= u, v <= 1.
template <class Place>
ShellMesh patch(int nu, int nv, const Place& place)
{
  ShellMesh mesh;
  for (int j = 0; j <= nv; ++j)
    for (int i = 0; i <= nu; ++i)
      mesh.points.push_back(place(double(i) / nu, double(j) / nv));
  const auto at = [nu](int i, int j) { return static_cast<std::int32_t>(j * (nu + 1) + i); };
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i)
      mesh.elements.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return mesh;
}

//! A square in x = 0 around the origin.
inline ShellMesh square(int n, double size)
{
  return patch(n, n, [size](double u, double v) { return Vector3(0, size * (u - 0.5), size * (v - 0.5)); });
}

//! A fold of two squares of n x n along z: both make the angle fold / 2 with the plane x = 0, the particles' side, x < 0, is
//! the inside of the fold.
inline ShellMesh fold(int n, double size, double angle)
{
  return patch(2 * n, n, [=](double u, double v) {
    const double s = 2 * size * (u - 0.5);
    return Vector3(-std::abs(s) * std::sin(angle / 2), s * std::cos(angle / 2), size * (v - 0.5));
  });
}

//! Particles of a fluid with sound of 1500 m/s, at given places, with one velocity.
inline Particles drops(const std::vector<Vector3>& places, double spacing,
                       const Vector3& velocity = {0, 0, 0})
{
  std::vector<Seed> seeds;
  for (const Vector3& place : places)
    seeds.push_back({place, 0});
  return make_particles({{"torso", Linear{1000, 2.25e9}, 0, 0}}, seeds, spacing, velocity, 1.25);
}

//! Particles and target under contact alone, by the scheme of simulation.cpp.
struct Duet
{
  Particles p;
  Target target;
  ParticleContact contact;
  std::vector<double> fx, fy, fz;
  std::vector<Vector3> node_force;
  ElementLoads loads;

  Duet(Particles particles, Target body, const ContactSettings& settings = {})
      : p(std::move(particles)), target(std::move(body)), contact(p, target.view(), settings)
  {
    evaluate(0);
  }

  Vector3 force(std::size_t i) const { return {fx[i], fy[i], fz[i]}; }

  //! With velocities carried to the end of the step by the forces at its start, as in the loop.
  void evaluate(double duration)
  {
    std::vector<double> vx = p.vx, vy = p.vy, vz = p.vz;
    Target now = target;
    if (!fx.empty())
      for (std::size_t i = 0; i < p.size(); ++i) {
        vx[i] += 0.5 * duration * fx[i] / p.mass[i];
        vy[i] += 0.5 * duration * fy[i] / p.mass[i];
        vz[i] += 0.5 * duration * fz[i] / p.mass[i];
      }
    node_force.resize(target.position.size(), Vector3::Zero());
    for (std::size_t n = 0; n < target.position.size(); ++n)
      now.velocity[n] += 0.5 * duration * node_force[n] / target.mass[n];
    std::fill(node_force.begin(), node_force.end(), Vector3(Vector3::Zero()));
    contact.evaluate(p, vx, vy, vz, now.view(), duration, fx, fy, fz, node_force, loads);
  }
  void kick(double dt)
  {
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.vx[i] += dt * fx[i] / p.mass[i];
      p.vy[i] += dt * fy[i] / p.mass[i];
      p.vz[i] += dt * fz[i] / p.mass[i];
    }
    for (std::size_t n = 0; n < target.position.size(); ++n)
      target.velocity[n] += dt * node_force[n] / target.mass[n];
  }
  void drift(double dt)
  {
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.x[i] += dt * p.vx[i];
      p.y[i] += dt * p.vy[i];
      p.z[i] += dt * p.vz[i];
    }
    for (std::size_t n = 0; n < target.position.size(); ++n)
      target.position[n] += dt * target.velocity[n];
  }
  void advance(double dt)
  {
    kick(0.5 * dt);
    drift(dt);
    evaluate(dt);
    kick(0.5 * dt);
  }

  double kinetic() const
  {
    double sum = kinetic_energy(p);
    for (std::size_t n = 0; n < target.position.size(); ++n)
      if (std::isfinite(target.mass[n]))
        sum += 0.5 * target.mass[n] * target.velocity[n].squaredNorm();
    return sum;
  }
  double energy() const { return kinetic() + contact.energy().stored; }
  Vector3 momentum() const
  {
    Vector3 sum = total_momentum(p);
    for (std::size_t n = 0; n < target.position.size(); ++n)
      sum += target.mass[n] * target.velocity[n];
    return sum;
  }
  Vector3 angular_momentum() const
  {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < p.size(); ++i)
      sum += p.mass[i] * p.position(i).cross(p.velocity(i));
    for (std::size_t n = 0; n < target.position.size(); ++n)
      sum += target.mass[n] * target.position[n].cross(target.velocity[n]);
    return sum;
  }
};

} // namespace birdstrike::samples
