# SPDX-License-Identifier: GPL-3.0-or-later
"""The impact of bird_impact.h, computed and timed by PySPH (Debian: python3-pysph); bench_peers runs this.

A cylinder with hemispherical ends (L/D = 2, 0.55 kg, 900 kg/m3, 200 m/s) of weakly compressible fluid hits a rigid
frictionless plane (z = 0) normally: Tait's equation of state, density by continuity, Monaghan's viscosity (alpha 1,
beta 2), cubic spline with h = 1.25 spacings, one evaluation of the forces a step, fixed time step.

    OMP_NUM_THREADS=2 python3 pysph_bird.py --openmp --spacing 3e-3 --steps 100

The last line printed is a JSON object with the members of measurement.h. PySPH compiles at its first run, before
anything is timed. --no-openmp is for one thread; all other options are PySPH's own.
"""
import json
import math
import os
import tempfile
import time

import numpy as np
from cyarray.api import UIntArray
from pysph.base.kernels import CubicSpline
from pysph.base.utils import get_particle_array_wcsph
from pysph.solver.application import Application
from pysph.solver.solver import Solver
from pysph.sph.basic_equations import ContinuityEquation
from pysph.sph.equation import Group
from pysph.sph.integrator import PECIntegrator
from pysph.sph.integrator_step import IntegratorStep
from pysph.sph.wc.basic import MomentumEquation, TaitEOS

MASS, DENSITY, SPEED, SOUND, SMOOTHING = 0.55, 900.0, 200.0, 1400.0, 1.25


class BirdStep(IntegratorStep):
    """Predict to the middle, evaluate, correct from the start; what crosses the plane z = 0 is thrown back."""

    def initialize(self, d_idx, d_x0, d_y0, d_z0, d_x, d_y, d_z, d_u0, d_v0, d_w0, d_u, d_v, d_w, d_rho0, d_rho):
        d_x0[d_idx] = d_x[d_idx]
        d_y0[d_idx] = d_y[d_idx]
        d_z0[d_idx] = d_z[d_idx]
        d_u0[d_idx] = d_u[d_idx]
        d_v0[d_idx] = d_v[d_idx]
        d_w0[d_idx] = d_w[d_idx]
        d_rho0[d_idx] = d_rho[d_idx]

    def stage1(self, d_idx, d_x0, d_y0, d_z0, d_x, d_y, d_z, d_u0, d_v0, d_w0, d_u, d_v, d_w, d_rho0, d_rho, d_au,
               d_av, d_aw, d_arho, dt):
        half = 0.5*dt
        d_u[d_idx] = d_u0[d_idx] + half*d_au[d_idx]
        d_v[d_idx] = d_v0[d_idx] + half*d_av[d_idx]
        d_w[d_idx] = d_w0[d_idx] + half*d_aw[d_idx]
        d_x[d_idx] = d_x0[d_idx] + half*d_u[d_idx]
        d_y[d_idx] = d_y0[d_idx] + half*d_v[d_idx]
        d_z[d_idx] = d_z0[d_idx] + half*d_w[d_idx]
        d_rho[d_idx] = d_rho0[d_idx] + half*d_arho[d_idx]

    def stage2(self, d_idx, d_x0, d_y0, d_z0, d_x, d_y, d_z, d_u0, d_v0, d_w0, d_u, d_v, d_w, d_rho0, d_rho, d_au,
               d_av, d_aw, d_arho, dt):
        d_u[d_idx] = d_u0[d_idx] + dt*d_au[d_idx]
        d_v[d_idx] = d_v0[d_idx] + dt*d_av[d_idx]
        d_w[d_idx] = d_w0[d_idx] + dt*d_aw[d_idx]
        d_x[d_idx] = d_x0[d_idx] + dt*d_u[d_idx]
        d_y[d_idx] = d_y0[d_idx] + dt*d_v[d_idx]
        d_z[d_idx] = d_z0[d_idx] + dt*d_w[d_idx]
        d_rho[d_idx] = d_rho0[d_idx] + dt*d_arho[d_idx]
        if d_z[d_idx] < 0.0:
            d_z[d_idx] = -d_z[d_idx]
            d_w[d_idx] = -d_w[d_idx]


def capsule(spacing):
    """Centres of the lattice's cells inside the bird, whose tip touches z = 0, as three arrays [m]."""
    diameter = (MASS/DENSITY/(math.pi*(1/4 + 1/6)))**(1/3)
    radius = 0.5*diameter
    n = math.ceil(radius/spacing)
    across = (np.arange(-n, n) + 0.5)*spacing
    along = (np.arange(0, math.ceil(2*diameter/spacing)) + 0.5)*spacing
    x, y, z = (a.ravel() for a in np.meshgrid(across, across, along, indexing="ij"))
    axis = np.clip(z, radius, radius + diameter)
    inside = x*x + y*y + (z - axis)**2 < radius*radius
    return x[inside], y[inside], z[inside]


def peak_memory():
    """Of this process [bytes]. The maximum of getrusage would hold that of the parent, too."""
    with open("/proc/self/status", encoding="ascii") as status:
        return next(int(line.split()[1])*1024 for line in status if line.startswith("VmHWM"))


class Bird(Application):
    def add_user_options(self, group):
        group.add_argument("--spacing", type=float, default=3e-3, dest="spacing")
        group.add_argument("--steps", type=int, default=100, dest="steps")
        group.add_argument("--warm-up", type=int, default=5, dest="warm_up")

    def create_particles(self):
        spacing = self.options.spacing
        x, y, z = capsule(spacing)
        bird = get_particle_array_wcsph(name="bird", x=x, y=y, z=z, w=-SPEED, m=DENSITY*spacing**3, rho=DENSITY,
                                        h=SMOOTHING*spacing)
        self.found = {"solver": "pysph", "spacing": spacing, "particles": bird.get_number_of_particles(),
                      "steps": self.options.steps, "kinetic_start": self.kinetic(bird)}
        return [bird]

    def create_equations(self):
        a = dict(dest="bird", sources=["bird"])
        return [Group([TaitEOS(dest="bird", sources=None, rho0=DENSITY, c0=SOUND, gamma=7.0)], real=False),
                Group([ContinuityEquation(**a), MomentumEquation(c0=SOUND, alpha=1.0, beta=2.0, **a)])]

    def create_solver(self):
        dt = 0.25*SMOOTHING*self.options.spacing/(SOUND + SPEED)
        return Solver(kernel=CubicSpline(dim=3), dim=3, integrator=PECIntegrator(bird=BirdStep()), dt=dt,
                      tf=(self.options.warm_up + self.options.steps + 0.5)*dt, adaptive_timestep=False, pfreq=10**9)

    def post_step(self, solver):
        if solver.count == self.options.warm_up:
            self.found["neighbours_start"] = self.mean_neighbours()
            self.start = time.perf_counter()
        elif solver.count == self.options.warm_up + self.options.steps:
            self.found["wall"] = time.perf_counter() - self.start
            self.found["peak_memory"] = peak_memory()
            self.found["kinetic_end"] = self.kinetic(self.particles[0])
            self.found["neighbours_end"] = self.mean_neighbours()
            self.found["time"] = solver.t
            self.found["rebuilds"] = None  # found anew in every step

    def mean_neighbours(self):
        """Particles within 2h of one, itself not counted."""
        self.nnps.update_domain()
        self.nnps.update()
        found, total, count = UIntArray(), 0, self.found["particles"]
        for i in range(count):
            self.nnps.get_nearest_particles(0, 0, i, found)
            total += found.length - 1
        return total/count

    @staticmethod
    def kinetic(bird):
        return 0.5*float(np.sum(bird.m*(bird.u**2 + bird.v**2 + bird.w**2)))


def main():
    with tempfile.TemporaryDirectory() as folder:
        app = Bird(fname="pysph_bird", output_dir=os.path.join(folder, "output"))
        app.run()
        found = {key: None if isinstance(value, float) and not math.isfinite(value) else value
                 for key, value in app.found.items()}
        print("\n" + json.dumps(found), flush=True)


if __name__ == "__main__":
    main()
