"""A second implementation of the step, in dense matrices and numpy, to be read beside docs/theory.md.

It follows that page and shares no line with the solver, and has neither stencils nor blocks nor threads.
Equations are cited as there: S for Steffen et al. (2008), W for Wallstedt and Guilkey (2008), N for Nairn and
Hammerquist (2021). Arrays have a row for each particle (index p) or for each node (index i).
"""
import numpy as np

from bases import Grid, weights
from boundaries import Boundaries
from consistent_mass import ConsistentMass
from mie_gruneisen import MieGruneisen


def elastic_stress(law, lam, mu):
    """The Kirchhoff stress as a function of F."""
    def kirchhoff_stress(F):
        I = np.eye(F.shape[1])
        F_T = F.transpose(0, 2, 1)
        J = np.linalg.det(F)[:, None, None]
        if law == "neo-hookean-log":  # S (46), W (55)
            return mu * F @ F_T + (lam * np.log(J) - mu) * I
        if law == "neo-hookean-square":  # N (6)
            return mu * F @ F_T + (lam / 2 * (J**2 - 1) - mu) * I
        strain = (F + F_T) / 2 - I  # linear-elastic, N 3.3
        return (lam * np.trace(strain, axis1=1, axis2=2)[:, None, None] * I + 2 * mu * strain) @ F_T

    return kirchhoff_stress


class Body:
    """Particles, and how they go forward by a time step. Words are those of the command line."""

    def __init__(self, given, walls, b, loads, basis, integrator, update, order=1, position="first-order",
                 deformation="linear", wall_method="combined", wall_depth=1.0, wall_gradient="given",
                 wall_acceleration="zero", smoothing_length=None, mass="lumped", body_force="particles", cfl_x=None,
                 start="half"):
        self.basis, self.smoothing_length = basis, smoothing_length
        self.integrator, self.update, self.order, self.position = integrator, update, order, position
        self.deformation, self.wall_method, self.wall_acceleration = deformation, wall_method, wall_acceleration
        self.b, self.body_force, self.loads = b, body_force, loads
        self.dt, self.t = given.dt, 0.0
        if given.law == "mie-gruneisen":
            self.kirchhoff_stress = MieGruneisen(given).kirchhoff_stress
        else:
            self.kirchhoff_stress = elastic_stress(given.law, given.lam, given.mu)
        self.X, self.x, self.v, self.F, self.m, self.V0 = given.X, given.x, given.v, given.F, given.m, given.V0
        self.R0 = given.R0
        self.C = np.zeros_like(self.F)  # the affine fields of apic
        self.grid = Grid(given, basis)
        self.boundaries = Boundaries(self.grid, given.faces, walls, wall_depth, wall_gradient)
        full_cell = self.m.sum() / self.V0.sum() * self.grid.h ** self.x.shape[1]
        self.mass_cutoff = (1e-12 if basis in ("linear", "cpdi") else 1e-16) * full_cell
        self.consistent = ConsistentMass(self.boundaries, full_cell) if mass == "consistent" else None
        self.steps, self.half_start = 0, start == "half"
        self.expands_every = round(cfl_x / given.cfl) if cfl_x else 1

    def weights(self):
        self.x_of_weights = self.x
        return weights(self.basis, self.grid, self.x, self.F, self.V0, self.R0, self.smoothing_length)

    @property
    def holds_the_grid(self):
        """What fmpm expands is held before the expansion by all wall methods but `velocity`."""
        return not (self.update == "fmpm" and self.wall_method == "velocity")

    def to_grid(self, q):
        """The sums over p of N_ip q_p, folded at the faces."""
        return self.boundaries.fold(self.S.T @ q)

    def by_mass(self, q, cutoff=0.0):
        """q_i / m_i where there is mass beyond the cutoff."""
        enough = self.m_i > cutoff
        return np.where(enough[:, None], q / np.where(enough, self.m_i, 1)[:, None], 0)

    def map_velocities(self):
        """S (1), (2), W (8): the lumped masses, momenta and velocities of the nodes."""
        self.m_i = self.to_grid(self.m)
        if self.update == "apic":  # Jiang et al. (2015)
            affine = self.v[:, None] + (self.grid.x - self.x_of_weights[:, None]) @ self.C.transpose(0, 2, 1)
            self.p_i = self.boundaries.fold(np.einsum("pi,p,pid->id", self.S, self.m, affine))
        else:
            self.p_i = self.to_grid(self.m[:, None] * self.v)
        v_i = self.by_mass(self.p_i)
        self.boundaries.estimate_gradients(v_i, self.m_i)
        if self.consistent:
            self.consistent.begin_step(self.S, self.m, self.m_i)
        return self.solved(self.p_i, self.boundaries.hold(v_i) if self.holds_the_grid else v_i)

    def solved(self, q, lumped, cutoff=0.0):
        """By the consistent mass, where that counts."""
        return self.consistent.solve(q, lumped, cutoff) if self.consistent else lumped

    def forces(self):
        """S (3), (4), (16), W (14): f_i = sum of N_ip m_p b_p - V0_p tau_p grad N_ip."""
        tau = self.kirchhoff_stress(self.F)
        f_i = -sum(G_d.T @ (self.V0[:, None] * tau[:, :, d]) for d, G_d in enumerate(self.G))
        if self.b and self.body_force == "particles":
            f_i = f_i + self.S.T @ (self.m[:, None] * self.b(self.X, self.t))
        if self.loads:
            f_i = f_i + self.surface_weights().T @ self.loads.force(self.t)
        f_i = self.boundaries.fold(f_i)
        if self.b and self.body_force == "grid":
            X_i = self.b.reference_points(self.grid.x, self.t)
            f_i = f_i + self.m_i[:, None] * self.b(X_i, self.t)
        return f_i

    def surface_weights(self):
        """N_ip + (F_p d) . grad N_ip, a row for each part of the surface."""
        p = self.loads.particle
        reach = np.einsum("sij,sj->si", self.F[p], self.loads.d)
        return self.S[p] + sum(reach[:, e, None] * G_e[p] for e, G_e in enumerate(self.G))

    def velocity_gradients(self, v_i):
        """L_p = sum of v_i grad N_ip."""
        return np.stack([G_d @ v_i for G_d in self.G], 2)

    def update_deformation(self, v_i, dt):
        """S (7), (8), W (11): F' = (I + dt L) F; or, N table 1, F' = exp(dt L) F, the exponential by its series."""
        L = self.velocity_gradients(v_i)
        term = self.F
        for k in range(1, 2 if self.deformation == "linear" else 13):
            term = (dt / k * L) @ term
            self.F = self.F + term

    def expanded(self, v_i):
        """N 2.2 in Horner's form: w <- v + w - S+ S w, with nothing added on held nodes for `elimination`."""
        w = v_i
        for _ in range(self.order - 1):
            change = v_i - self.by_mass(self.to_grid(self.m[:, None] * (self.S @ w)))
            w = w + (self.boundaries.hold_at_zero(change) if self.wall_method == "elimination" else change)
        return w

    def stress_velocity(self, v_i):
        """N 2.3: fmpm expands the velocities of the stress updates, too; the walls hold what comes out."""
        if self.update != "fmpm" or self.consistent:
            return v_i
        w = self.expanded(v_i)
        return w if self.wall_method == "lumped" else self.boundaries.hold(w)

    def step(self):
        if self.expands_every > 1:  # N 3.1: between its steps fmpm is flip
            self.update = "flip" if self.steps % self.expands_every else "fmpm"
            self.position = "second-order"
        if self.integrator == "rk4":
            self.step_rk4()
        else:
            self.step_once()
        self.t += self.dt
        self.steps += 1
        for d, (word, _) in enumerate(self.boundaries.faces):
            if word == "periodic":
                low, length = self.grid.lower[d], self.grid.cells[d] * self.grid.h
                self.x[:, d] = low + (self.x[:, d] - low) % length

    def step_rk4(self):
        """The classical Runge-Kutta method on the state (x_p, v_p, F_p), each stage with its own weights and forces."""
        start, t, dt = (self.x, self.v, self.F), self.t, self.dt
        sums = [0, 0, 0]
        rates = [0, 0, 0]
        for offset, weight in ((0, 1 / 6), (dt / 2, 1 / 3), (dt / 2, 1 / 3), (dt, 1 / 6)):
            self.x, self.v, self.F = (state + offset * rate for state, rate in zip(start, rates))
            self.t = t + offset
            rates = self.rates()
            sums = [total + weight * rate for total, rate in zip(sums, rates)]
        self.x, self.v, self.F = (state + dt * total for state, total in zip(start, sums))
        self.t = t

    def rates(self):
        """The derivatives of x_p, v_p and F_p by time."""
        self.S, self.G = self.weights()
        self.boundaries.begin_step(self.t)
        v_i = self.map_velocities()
        f_i = self.forces()
        a_i = self.boundaries.hold_at_zero(self.by_mass(f_i, self.mass_cutoff))
        a_i = self.solved(f_i, a_i, self.mass_cutoff)
        return self.S @ v_i, self.S @ a_i, self.velocity_gradients(v_i) @ self.F

    def step_once(self):
        dt, integrator = self.dt, self.integrator
        self.S, self.G = self.weights()
        self.boundaries.begin_step(self.t)
        if integrator in ("usf", "usavg", "usavg+"):  # W (8) to (18); N 2.3
            v_F = self.stress_velocity(self.map_velocities())
            self.update_deformation(v_F, dt if integrator == "usf" else dt / 2)

        self.boundaries.t_held = self.t + dt  # v+ is that of the step's end
        v_i = self.map_velocities()
        f_i = self.forces()
        a_i = self.by_mass(f_i, self.mass_cutoff)  # S (5), W (15)
        if integrator in ("cd", "uvf") and self.t == 0 and self.half_start:  # S (11) to (15): v half a step behind
            f_i, a_i = f_i / 2, a_i / 2
        if self.holds_the_grid:
            a_i = self.boundaries.hold_at_zero(a_i)
        a_i = self.solved(f_i, a_i, self.mass_cutoff)
        v_plus = v_i + dt * a_i
        if self.holds_the_grid:
            v_plus = self.boundaries.hold(v_plus)
            a_i = self.boundaries.held_accelerations(a_i, v_plus, self.p_i, self.m_i, dt,
                                                     self.wall_acceleration == "difference")
        self.boundaries.t_mapped = self.t + dt  # momenta that are mapped from here on are those of the step's end
        v_F = self.move_particles(v_plus, a_i)

        if integrator in ("usl", "cd", "uvf", "usavg"):  # S (1) to (10), W (40) to (51); N 2.3
            self.update_deformation(v_F, dt / 2 if integrator == "usavg" else dt)
        if integrator in ("usl+", "usavg+"):  # N 2.3, with the weights of the step's start
            self.update_deformation(self.stress_velocity(self.map_velocities()), dt if integrator == "usl+" else dt / 2)

    def move_particles(self, v_plus, a_i):
        """N table 1: new velocities and positions. Returns the grid velocity that F follows."""
        dt, S, v = self.dt, self.S, self.v
        if self.update == "flip":
            self.v = v + dt * S @ a_i
            if self.integrator == "uvf":  # W (51)
                v_plus = self.map_velocities()
            drift = {"first-order": S @ v_plus, "second-order": S @ (v_plus - dt / 2 * a_i),
                     "particle": (v + self.v) / 2}[self.position]
        elif self.update in ("pic", "apic"):
            drift = self.v = S @ v_plus
            if self.update == "apic":
                self.C = self.affine_fields(v_plus)
        elif self.update == "xpic":  # V' = S (m_k^-1 p + dt a)
            w = self.expanded(v_plus - dt * a_i) + dt * a_i
            self.v = S @ (w if self.wall_method == "lumped" else self.boundaries.hold(w))
            drift = S @ (v_plus - dt * a_i) + (self.v - v) / 2
        elif self.update == "fmpm":  # V' = S m_k^-1 p+
            v_plus = self.stress_velocity(v_plus)
            self.v = S @ v_plus
            drift = (v + self.v) / 2
        self.x = self.x + dt * drift
        return v_plus

    def affine_fields(self, v_plus):
        """Jiang et al. (2015): C_p = sum of N_ip v_i (x_i - x_p)^T D_p^-1, with D_p the sum of N_ip times
        (x_i - x_p)(x_i - x_p)^T."""
        distance = self.grid.x - self.x[:, None]
        weighted = self.S[:, :, None] * distance
        D_p = weighted.transpose(0, 2, 1) @ distance
        return (weighted.transpose(0, 2, 1) @ v_plus).transpose(0, 2, 1) @ np.linalg.inv(D_p)
