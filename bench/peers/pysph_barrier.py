"""A debris flow against a rigid barrier, computed with PySPH (Debian: python3-pysph).

  pysph_barrier.py --case CASE.json --result RESULT.json [options of PySPH]

CASE is a case of Parapet with its defaults filled in (the entry "case" of a result of Parapet). The script
computes the same equations with the parts that PySPH ships, and writes what bench/peers/run compares.

From PySPH: the boundary condition of Adami, Hu and Adams (2012) for velocity and pressure (no tension at
walls), continuity and pressure gradient in the form of the same paper, a kick-drift-kick integrator with one
evaluation of the forces a step, the diffusion of density of delta-SPH, the kernel Wendland C2, and the form of
the viscous term. Ours, because PySPH has no Herschel-Bulkley fluid: corrected gradients, apparent viscosity,
the viscous term with it, and the force on the barrier. Numbers of equations are those of Adami et al.

Settings: h = 1.33 spacings, as in Parapet; sound speed as in the case (10 times the largest speed
expected); delta = 0.1. The step is the smallest of 0.25 h/(1.1 c), 0.25 sqrt(h/g) and 0.125 h^2 rho/eta_max,
the rules of PySPH's schemes; the last one rules, because some material is always below its yield stress. For
this kernel on a square lattice its limit is 0.316.
"""
import json
import math
import resource
import time

import numpy as np
from pysph.base.kernels import WendlandQuintic
from pysph.base.utils import get_particle_array
from pysph.solver.application import Application
from pysph.solver.solver import Solver
from pysph.sph.equation import Group, MultiStageEquations
from pysph.sph.wc.basic import ContinuityEquationDeltaSPH
from pysph.sph.wc.edac import ClampWallPressure
from pysph.sph.wc.gtvf import GTVFIntegrator
from pysph.sph.wc.transport_velocity import (
    ContinuityEquation, ContinuitySolid, MomentumEquationPressureGradient, SetWallVelocity,
    SolidWallPressureBC, StateEquation, VolumeFromMassDensity)

from pysph_equations import (
    BarrierForce, FluidGradients, FluidViscosity, HerschelBulkley, KickDriftKick, WallGradients,
    WallViscosity)

SMOOTHING_RATIO = 1.33
DELTA = 0.1
VISCOUS_STEP = 0.125  # of h^2 rho/eta_max
WALL_LAYERS = 3  # the kernel reaches 2.66 spacings
FRONT_SHARE = 0.005  # of the released mass is at the front or ahead of it
READ_EVERY = 10  # steps between two readings of force and positions


def plate_particles(case, spacing):
    """Wall particles of the first barrier and the area for which each stands.

    Layers follow the faces of Parapet's outline (`barrier_outline`, geometry.cpp), mitred at the crest. A
    plate of 15 mm takes two layers at 10 mm and three at 5 mm: less than the kernel's reach at 10 mm.
    """
    slope = math.radians(case["channel"]["slope_deg"])
    barrier = case["barriers"][0]
    thickness, height = barrier["thickness_m"], barrier["height_m"]
    stem = np.array([-math.sin(slope), math.cos(slope)])
    downstream = np.array([stem[1], -stem[0]])
    foot = np.array([barrier["foot_x_m"], 0.0])
    deflector = barrier["deflector"]
    mitre = 0.0
    if deflector:
        angle = math.radians(deflector["angle_deg"]) - slope
        plate = np.array([-math.cos(angle), math.sin(angle)])
        upper = np.array([plate[1], -plate[0]])
        mitre = float(downstream @ upper)
        mitre = math.sqrt((1.0 - mitre)/(1.0 + mitre))  # tangent of half the turn
    layers = math.ceil(thickness/spacing - 1e-9)
    points = []
    for layer in range(layers):
        depth = (layer + 0.5)*thickness/layers
        along = height + mitre*depth - spacing/2
        while True:  # from the crest down to the bed
            point = foot + along*stem + depth*downstream
            if point[1] < 0.0:
                break
            points.append(point)
            along -= spacing
        if deflector:
            length = deflector["length_m"] + mitre*depth
            count = round(length/spacing)
            for k in range(count):
                along = (k + 0.5)*length/count - mitre*depth
                points.append(foot + height*stem + along*plate + depth*upper)
    return np.array(points), spacing*thickness/layers


def channel_particles(case, spacing):
    """The bed and the back wall of the reservoir, in layers behind the face."""
    reach = WALL_LAYERS*spacing
    x = np.arange(-reach + spacing/2, case["channel"]["length_m"] + reach, spacing)
    z = -np.arange(spacing/2, reach, spacing)
    bed = np.array(np.meshgrid(x, z)).reshape(2, -1)
    wall_z = np.arange(spacing/2, 1.5*case["reservoir"]["height_m"], spacing)
    wall = np.array(np.meshgrid(z, wall_z)).reshape(2, -1)
    return np.hstack([bed, wall]).T


def block_particles(case, spacing):
    columns = round(case["reservoir"]["length_m"]/spacing)
    rows = round(case["reservoir"]["height_m"]/spacing)
    x = (np.arange(columns) + 0.5)*spacing
    z = (np.arange(rows) + 0.5)*spacing
    return np.array(np.meshgrid(x, z)).reshape(2, -1).T


class BarrierFlow(Application):
    def add_user_options(self, group):
        group.add_argument("--case", required=True)
        group.add_argument("--result", required=True)
        group.add_argument("--tip-time", type=float, default=1.05)

    def consume_user_options(self):
        with open(self.options.case) as file:
            self.case = json.load(file)
        numerics, material = self.case["numerics"], self.case["material"]
        slope = math.radians(self.case["channel"]["slope_deg"])
        gravity = self.case["channel"]["gravity_m_s2"]
        self.gx, self.gz = gravity*math.sin(slope), -gravity*math.cos(slope)
        self.spacing = numerics["spacing_m"]
        self.h = SMOOTHING_RATIO*self.spacing
        self.c = numerics["sound_speed_m_s"]
        self.rho = material["density_kg_m3"]
        self.rate_min = material["cutoff_shear_rate_per_s"]
        eta_max = (material["yield_stress_pa"]/self.rate_min
                   + material["consistency_pa_sn"]*self.rate_min**(material["flow_index"] - 1.0))
        self.dt = min(0.25*self.h/(1.1*self.c), 0.25*math.sqrt(self.h/gravity),
                      VISCOUS_STEP*self.h**2*self.rho/eta_max)
        self.end = self.case["run"]["stop_time_s"]
        self.readings = []  # time, force along the bed, share of the mass downstream, tip
        self.left = 0
        self.tip = self.front = None
        self.began = time.time()

    def create_particles(self):
        dx, rho = self.spacing, self.rho
        points = block_particles(self.case, dx)
        depth = self.case["reservoir"]["height_m"] - points[:, 1]
        density = rho*(1.0 - self.gz*depth/self.c**2)  # hydrostatic
        fluid = get_particle_array(
            name="fluid", x=points[:, 0], y=points[:, 1], h=self.h, rho=density, m=rho*dx**2,
            additional_props=["V", "arho", "auhat", "avhat", "awhat", "eta"])
        for name, stride in (("grad", 4), ("moment", 4), ("moment_fluid", 4), ("gradrho", 3)):
            fluid.add_property(name, stride=stride)
        self.released = len(points)
        wall_properties = ["V", "wij", "uf", "vf", "wf", "ug", "vg", "wg", "force_x", "force_z"]
        points = channel_particles(self.case, dx)
        wall = get_particle_array(name="wall", x=points[:, 0], y=points[:, 1], h=self.h, rho=rho,
                                  m=rho*dx**2, additional_props=wall_properties)
        points, area = plate_particles(self.case, dx)
        barrier = get_particle_array(name="barrier", x=points[:, 0], y=points[:, 1], h=self.h, rho=rho,
                                     m=rho*area, additional_props=wall_properties)
        return [fluid, wall, barrier]

    def create_equations(self):
        material = self.case["material"]
        stiffness = self.c**2*self.rho
        walls = ["wall", "barrier"]
        velocity = Group([SetWallVelocity(one, ["fluid"]) for one in walls])
        # the gradient of the density is that of the last forces: neither has moved since
        density = Group([
            ContinuityEquation("fluid", ["fluid"]),
            ContinuitySolid("fluid", walls),
            ContinuityEquationDeltaSPH("fluid", ["fluid"], c0=self.c, delta=DELTA),
        ])
        state = Group([StateEquation("fluid", None, p0=stiffness, rho0=self.rho),
                       VolumeFromMassDensity("fluid", None)])
        wall_pressure = Group([
            SolidWallPressureBC(one, ["fluid"], rho0=self.rho, p0=stiffness, gx=self.gx, gy=self.gz)
            for one in walls])
        wall_state = Group([equation(one, None) for one in walls
                            for equation in (ClampWallPressure, VolumeFromMassDensity)])
        gradients = Group([FluidGradients("fluid", ["fluid"]), WallGradients("fluid", walls)])
        rheology = Group([HerschelBulkley(
            "fluid", None, material["yield_stress_pa"], material["consistency_pa_sn"],
            material["flow_index"], self.rate_min)])
        forces = Group([
            MomentumEquationPressureGradient("fluid", ["fluid", *walls], pb=0.0, gx=self.gx, gy=self.gz),
            FluidViscosity("fluid", ["fluid"]),
            WallViscosity("fluid", walls),
            BarrierForce("barrier", ["fluid"]),
        ])
        return MultiStageEquations([
            [velocity, density],
            [state, velocity, wall_pressure, wall_state, gradients, rheology, forces]])

    def create_solver(self):
        return Solver(dim=2, kernel=WendlandQuintic(dim=2), dt=self.dt, tf=self.end, pfreq=10**9,
                      integrator=GTVFIntegrator(fluid=KickDriftKick()), adaptive_timestep=False,
                      output_at_times=[0.3, 0.45, 0.6, 0.8, self.options.tip_time, 1.2])

    def post_step(self, solver):
        if solver.count % READ_EVERY and solver.t < self.end - 1.5*self.dt:
            return
        fluid, _, barrier = self.particles
        x, z = fluid.x, fluid.y
        if not np.isfinite(x).all():
            raise FloatingPointError(f"positions are not finite at {solver.t} s")
        channel = self.case["channel"]
        gone = np.flatnonzero((x > channel["length_m"]) | (z > channel["height_m"]) | (z < -self.spacing))
        if gone.size:
            self.left += gone.size
            fluid.remove_particles(gone)
            x, z = fluid.x, fluid.y
        slope = math.radians(channel["slope_deg"])
        offset = (x - self.case["barriers"][0]["foot_x_m"])*math.cos(slope) + z*math.sin(slope)
        passed = (np.count_nonzero(offset >= 0.0) + self.left)/self.released
        self.readings.append((solver.t, float(barrier.force_x.sum()), passed, float(x.max())))
        if self.tip is None and solver.t >= self.options.tip_time:
            self.tip = float(x.max())
            ahead = math.ceil(FRONT_SHARE*self.released - 1e-9) - self.left
            self.front = float(np.sort(x)[-ahead]) if ahead > 0 else channel["length_m"]

    def write_result(self, steps):
        usage = resource.getrusage(resource.RUSAGE_SELF)
        result = {
            "end_s": self.readings[-1][0], "retention": 1.0 - self.readings[-1][2], "tip_m": self.tip,
            "front_m": self.front,
            "force": [[round(t, 6), round(force, 3)] for t, force, _, _ in self.readings],
            "retention_series": [[round(t, 4), 1.0 - p] for t, _, p, _ in self.readings[::100]],
            "particles": self.released, "left": self.left, "steps": steps, "time_step_s": self.dt,
            "user_s": usage.ru_utime, "wall_s": time.time() - self.began}
        with open(self.options.result, "w") as file:
            json.dump(result, file)


if __name__ == "__main__":
    application = BarrierFlow()
    application.run()
    application.write_result(application.solver.count)
