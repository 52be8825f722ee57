"""What PySPH does not have: equations of a Herschel-Bulkley fluid at walls, used by pysph_barrier.py.

PySPH translates these classes to C: `declare` and `sqrt` are known there, and no other names are.
Numbers of equations are those of Adami, Hu and Adams (2012).
"""
from pysph.sph.equation import Equation
from pysph.sph.integrator_step import IntegratorStep


class KickDriftKick(IntegratorStep):
    """Eqs. 14 to 18: half a kick; density and positions with that velocity; half a kick with the new forces."""

    def stage1(self, d_idx, d_u, d_v, d_au, d_av, dt):
        d_u[d_idx] += 0.5*dt*d_au[d_idx]
        d_v[d_idx] += 0.5*dt*d_av[d_idx]

    def stage2(self, d_idx, d_x, d_y, d_u, d_v, d_rho, d_arho, dt):
        d_rho[d_idx] += dt*d_arho[d_idx]
        d_x[d_idx] += dt*d_u[d_idx]
        d_y[d_idx] += dt*d_v[d_idx]

    def stage3(self, d_idx, d_u, d_v, d_au, d_av, dt):
        d_u[d_idx] += 0.5*dt*d_au[d_idx]
        d_v[d_idx] += 0.5*dt*d_av[d_idx]


class FluidGradients(Equation):
    """Sums for the gradients of velocity and density over the fluid, with their moment matrices."""

    def initialize(self, d_idx, d_grad, d_moment, d_gradrho, d_moment_fluid):
        i = declare('int')
        for i in range(4):
            d_grad[4*d_idx + i] = 0.0
            d_moment[4*d_idx + i] = 0.0
            d_moment_fluid[4*d_idx + i] = 0.0
        for i in range(3):
            d_gradrho[3*d_idx + i] = 0.0

    def loop(self, d_idx, s_idx, d_grad, d_moment, d_gradrho, d_moment_fluid, d_rho, s_rho, s_m,
             VIJ, XIJ, DWIJ):
        V = s_m[s_idx]/s_rho[s_idx]
        d_grad[4*d_idx] -= V*VIJ[0]*DWIJ[0]
        d_grad[4*d_idx + 1] -= V*VIJ[0]*DWIJ[1]
        d_grad[4*d_idx + 2] -= V*VIJ[1]*DWIJ[0]
        d_grad[4*d_idx + 3] -= V*VIJ[1]*DWIJ[1]
        d_moment[4*d_idx] -= V*XIJ[0]*DWIJ[0]
        d_moment[4*d_idx + 1] -= V*XIJ[0]*DWIJ[1]
        d_moment[4*d_idx + 2] -= V*XIJ[1]*DWIJ[0]
        d_moment[4*d_idx + 3] -= V*XIJ[1]*DWIJ[1]
        d_moment_fluid[4*d_idx] -= V*XIJ[0]*DWIJ[0]
        d_moment_fluid[4*d_idx + 1] -= V*XIJ[0]*DWIJ[1]
        d_moment_fluid[4*d_idx + 2] -= V*XIJ[1]*DWIJ[0]
        d_moment_fluid[4*d_idx + 3] -= V*XIJ[1]*DWIJ[1]
        d_gradrho[3*d_idx] += V*(s_rho[s_idx] - d_rho[d_idx])*DWIJ[0]
        d_gradrho[3*d_idx + 1] += V*(s_rho[s_idx] - d_rho[d_idx])*DWIJ[1]


class WallGradients(Equation):
    """The share of the walls in the gradient of velocity, with the mirrored velocities of Eq. 23."""

    def loop(self, d_idx, s_idx, d_grad, d_moment, d_u, d_v, s_ug, s_vg, s_m, s_rho, XIJ, DWIJ):
        V = s_m[s_idx]/s_rho[s_idx]
        u = d_u[d_idx] - s_ug[s_idx]
        v = d_v[d_idx] - s_vg[s_idx]
        d_grad[4*d_idx] -= V*u*DWIJ[0]
        d_grad[4*d_idx + 1] -= V*u*DWIJ[1]
        d_grad[4*d_idx + 2] -= V*v*DWIJ[0]
        d_grad[4*d_idx + 3] -= V*v*DWIJ[1]
        d_moment[4*d_idx] -= V*XIJ[0]*DWIJ[0]
        d_moment[4*d_idx + 1] -= V*XIJ[0]*DWIJ[1]
        d_moment[4*d_idx + 2] -= V*XIJ[1]*DWIJ[0]
        d_moment[4*d_idx + 3] -= V*XIJ[1]*DWIJ[1]


class HerschelBulkley(Equation):
    """Corrects the gradients and sets eta = tau_y/g + K g^(N-1), g = sqrt(2 S:S), cut off below g_min."""

    def __init__(self, dest, sources, yield_stress, consistency, index, cutoff):
        self.yield_stress = yield_stress
        self.consistency = consistency
        self.index = index
        self.cutoff = cutoff
        super(HerschelBulkley, self).__init__(dest, sources)

    def loop(self, d_idx, d_grad, d_moment, d_gradrho, d_moment_fluid, d_eta):
        a, b, c, d, det, gx, gy, ux, uz, wx, wz, rate = declare('double', 12)
        # sum (x_j - x_i) x gradW V = M, so that the raw sums are gradient . M
        a = d_moment[4*d_idx]
        b = d_moment[4*d_idx + 1]
        c = d_moment[4*d_idx + 2]
        d = d_moment[4*d_idx + 3]
        det = a*d - b*c
        ux = d_grad[4*d_idx]
        uz = d_grad[4*d_idx + 1]
        wx = d_grad[4*d_idx + 2]
        wz = d_grad[4*d_idx + 3]
        # droplets of a few particles have no gradient to correct
        if det > 0.05:
            gx = (ux*d - uz*c)/det
            gy = (uz*a - ux*b)/det
            ux = gx
            uz = gy
            gx = (wx*d - wz*c)/det
            gy = (wz*a - wx*b)/det
            wx = gx
            wz = gy
        rate = sqrt(2.0*ux*ux + 2.0*wz*wz + (uz + wx)*(uz + wx))
        rate = max(rate, self.cutoff)
        d_eta[d_idx] = self.yield_stress/rate + self.consistency*pow(rate, self.index - 1.0)

        a = d_moment_fluid[4*d_idx]
        b = d_moment_fluid[4*d_idx + 1]
        c = d_moment_fluid[4*d_idx + 2]
        d = d_moment_fluid[4*d_idx + 3]
        det = a*d - b*c
        if det > 0.05:
            gx = (d_gradrho[3*d_idx]*d - d_gradrho[3*d_idx + 1]*c)/det
            gy = (d_gradrho[3*d_idx + 1]*a - d_gradrho[3*d_idx]*b)/det
            d_gradrho[3*d_idx] = gx
            d_gradrho[3*d_idx + 1] = gy


class FluidViscosity(Equation):
    """PySPH's MomentumEquationViscosity with a viscosity of each particle: harmonic mean of the two."""

    def loop(self, d_idx, s_idx, d_eta, s_eta, d_m, d_V, s_V, d_au, d_av, VIJ, XIJ, DWIJ, R2IJ, EPS):
        Vi, Vj, eta, factor = declare('double', 4)
        Vi = 1.0/d_V[d_idx]
        Vj = 1.0/s_V[s_idx]
        eta = 2.0*d_eta[d_idx]*s_eta[s_idx]/(d_eta[d_idx] + s_eta[s_idx])/(R2IJ + EPS)/d_m[d_idx]
        factor = eta*(Vi*Vi + Vj*Vj)*(XIJ[0]*DWIJ[0] + XIJ[1]*DWIJ[1])
        d_au[d_idx] += factor*VIJ[0]
        d_av[d_idx] += factor*VIJ[1]


class WallViscosity(Equation):
    """The same at a wall, which takes the viscosity of the particle and the velocity of Eq. 23."""

    def loop(self, d_idx, s_idx, d_eta, d_u, d_v, s_ug, s_vg, d_m, d_V, s_V, d_au, d_av,
             XIJ, DWIJ, R2IJ, EPS):
        Vi, Vj, eta, factor, u, v = declare('double', 6)
        Vi = 1.0/d_V[d_idx]
        Vj = 1.0/s_V[s_idx]
        u = d_u[d_idx] - s_ug[s_idx]
        v = d_v[d_idx] - s_vg[s_idx]
        eta = d_eta[d_idx]/(R2IJ + EPS)/d_m[d_idx]
        factor = eta*(Vi*Vi + Vj*Vj)*(XIJ[0]*DWIJ[0] + XIJ[1]*DWIJ[1])
        d_au[d_idx] += factor*u
        d_av[d_idx] += factor*v


class BarrierForce(Equation):
    """Force of the fluid on each particle of the barrier: what pressure and viscosity take there, reversed."""

    def initialize(self, d_idx, d_force_x, d_force_z):
        d_force_x[d_idx] = 0.0
        d_force_z[d_idx] = 0.0

    def loop(self, d_idx, s_idx, d_ug, d_vg, s_u, s_v, s_eta, d_V, s_V, d_rho, s_rho, d_p, s_p,
             d_force_x, d_force_z, XIJ, DWIJ, R2IJ, EPS):
        Vi, Vj, eta, factor, pressure, u, v = declare('double', 7)
        Vi = 1.0/d_V[d_idx]
        Vj = 1.0/s_V[s_idx]
        pressure = (s_rho[s_idx]*d_p[d_idx] + d_rho[d_idx]*s_p[s_idx])/(s_rho[s_idx] + d_rho[d_idx])
        pressure *= Vi*Vi + Vj*Vj
        d_force_x[d_idx] -= pressure*DWIJ[0]
        d_force_z[d_idx] -= pressure*DWIJ[1]
        u = d_ug[d_idx] - s_u[s_idx]
        v = d_vg[d_idx] - s_v[s_idx]
        eta = s_eta[s_idx]/(R2IJ + EPS)
        factor = eta*(Vi*Vi + Vj*Vj)*(XIJ[0]*DWIJ[0] + XIJ[1]*DWIJ[1])
        d_force_x[d_idx] += factor*u
        d_force_z[d_idx] += factor*v
