"""The fluid of docs/theory.md, "Materials", `mie-gruneisen`: a pressure and an artificial viscosity with a history."""
import numpy as np


class MieGruneisen:
    def __init__(self, start):
        named = ("bulk_modulus", "density", "hugoniot_slope", "gamma", "linear_viscosity", "quadratic_viscosity")
        self.K, self.rho0, self.S1, self.gamma0, self.A1, self.A2 = (start.parameters[name] for name in named)
        self.h, self.dt = start.h, start.dt
        self.J = np.ones(len(start.x))
        self.p, self.e = np.zeros((2, len(start.x)))

    def hugoniot(self, eta):
        """The pressure without its thermal part, and its derivative."""
        K, S1, g = self.K, self.S1, self.gamma0 / 2
        squeezed = eta > 0
        top, bottom = eta * (1 - g * eta), 1 - S1 * eta
        p = np.where(squeezed, K * top / bottom**2, K * eta)
        slope = np.where(squeezed, K * ((1 - 2 * g * eta) / bottom**2 + 2 * S1 * top / bottom**3), K)
        return p, slope

    def kirchhoff_stress(self, F):
        """Takes the state forward to F by the trapezoidal rule in p, with q of the middle of the step."""
        J = np.linalg.det(F)
        dJ, middle = J - self.J, (J + self.J) / 2
        _, slope = self.hugoniot(1 - self.J)
        c = np.sqrt(self.J**2 / self.rho0 * (slope + self.gamma0 * self.p))
        rate = self.h * abs(dJ) / (middle * self.dt)
        q = np.where(dJ < 0, self.rho0 / middle * rate * (self.A1 * c + self.A2 * rate), 0)
        cold, _ = self.hugoniot(1 - J)
        # p = cold + gamma0 rho0 e and rho0 (e - self.e) = -((self.p + p)/2 + q) dJ, solved for p
        p = (cold + self.gamma0 * (self.rho0 * self.e - (self.p / 2 + q) * dJ)) / (1 + self.gamma0 / 2 * dJ)
        self.e = self.e - ((self.p + p) / 2 + q) * dJ / self.rho0
        self.J, self.p = J, p
        return -(J * (p + q))[:, None, None] * np.eye(F.shape[1])
