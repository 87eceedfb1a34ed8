"""Motions and body forces of docs/problems.md, from its formulas."""
import numpy as np
from numpy import cos, pi, sin

E, RHO0 = 1e4, 1.0
C = np.sqrt(E / RHO0)


def lame(nu):
    return E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))


class AlongTheAxes:
    """The body force of a motion whose displacement along each axis depends on that coordinate alone.

    W (52) with P_d = (lambda K + mu (F_d^2 - 1))/F_d, K = ln J, as in W (58) and (59), gives
    rho0 b_d = rho0 a_d - [lambda (1 - K)/F_d^2 + mu (1 + 1/F_d^2)] u_d''.
    """

    def __init__(self, u, stretch, second_derivative, acceleration, nu):
        self.u, self.stretch, self.second_derivative, self.acceleration = u, stretch, second_derivative, acceleration
        self.lam, self.mu = lame(nu)

    def __call__(self, X, t):
        F = 1 + self.stretch(X, t)
        K = np.log(F).sum(1)[:, None]
        stress_gradient = (self.lam * (1 - K) / F**2 + self.mu * (1 + F**-2)) * self.second_derivative(X, t)
        return self.acceleration(X, t) - stress_gradient / RHO0

    def reference_points(self, x, t):
        """The X at x = X + u(X, t), by Newton's method."""
        X = x
        for _ in range(50):
            X = X - (X + self.u(X, t) - x) / (1 + self.stretch(X, t))
        return X


def standing(amplitude, k, course, nu):
    """u_d = A sin(k pi X_d) course_d(t), where course has the circular frequency C pi."""
    def u(X, t):
        return amplitude * sin(k * pi * X) * course(t)

    return AlongTheAxes(u, lambda X, t: k * pi * amplitude * cos(k * pi * X) * course(t),
                        lambda X, t: -(k * pi) ** 2 * u(X, t), lambda X, t: -(C * pi) ** 2 * u(X, t), nu)


def swing():
    """u_x = A cos(pi X) sin(C pi t), u_y = V t + A sin(2 pi Y) sin(C pi t)."""
    A, drift = 0.05, np.array([0.0, 30.0])

    def moving(X, t):
        return A * np.stack([cos(pi * X[:, 0]), sin(2 * pi * X[:, 1])], 1) * sin(C * pi * t)

    def stretch(X, t):
        return A * pi * np.stack([-sin(pi * X[:, 0]), 2 * cos(2 * pi * X[:, 1])], 1) * sin(C * pi * t)

    return AlongTheAxes(lambda X, t: moving(X, t) + drift * t, stretch,
                        lambda X, t: -np.array([1, 4]) * pi**2 * moving(X, t),
                        lambda X, t: -(C * pi) ** 2 * moving(X, t), 0.3)


class SwingingWall:
    """Of `swing`: it moves by A sin(C pi t), or the opposite, without a gradient."""

    def __init__(self, X, sign):
        self.X, self.amplitude = X, sign * 0.05

    def place(self, t):
        return self.X + self.amplitude * sin(C * pi * t)

    def velocity(self, t):
        return self.amplitude * C * pi * cos(C * pi * t)

    def gradient(self, t):
        return 0.0


class PullingWall:
    """Of `stretch`: u_x = rate t X."""

    def __init__(self, X, rate=0.0025):
        self.X, self.rate = X, rate

    def place(self, t):
        return self.X * (1 + self.rate * t)

    def velocity(self, t):
        return self.X * self.rate

    def gradient(self, t):
        return self.rate / (1 + self.rate * t)


class RammingWall:
    """Of `shock`: it moves at a constant speed, without a gradient."""

    def __init__(self, X, speed):
        self.X, self.speed = X, speed

    def place(self, t):
        return self.X + self.speed * t

    def velocity(self, t):
        return self.speed

    def gradient(self, t):
        return 0.0


def radial(lam, mu):
    """Of `ring` and `shell`: W (60) to (62) with R_I = 1/2 and R_O = 1, and with a Poisson's ratio."""
    A, R_I, R_O = 0.1, 0.5, 1.0
    c3 = -2 / (R_O**2 * (R_O - 3 * R_I))
    c2 = 3 * (R_O + R_I) / (R_O**2 * (R_O - 3 * R_I))
    c1 = -6 * R_I / (R_O * (R_O - 3 * R_I))

    def body_force(X, t):
        R, others = np.linalg.norm(X, axis=1), X.shape[1] - 1
        w, dw, ddw = c3 * R**3 + c2 * R**2 + c1 * R, 3 * c3 * R**2 + 2 * c2 * R + c1, 6 * c3 * R + 2 * c2
        T = A * cos(C * pi * t)
        F_R, F_theta = 1 + T * dw, 1 + T * w / R
        M = mu + lam * (1 - np.log(F_R * F_theta**others))
        b = -T / RHO0 * (pi**2 * E * w + ddw * (mu + M / F_R**2)
                         + others * (2 * c3 * R + c2) * (mu + M / (F_R * F_theta)))
        return b[:, None] * X / R[:, None]

    return body_force


def vortex(X, t):
    """Kamojjala et al. (2015): A = 1 rad, radii 3/4 and 5/4, period 1, E = 1000, nu = 0.3, rho0 = 1000."""
    c2 = 1000 / (2 * 1.3) / 1000  # mu / rho0
    R = np.hypot(*X.T)
    s = 2 * (R - 1)
    H, H_R, H_RR = (1 - 4 * s**2) ** 2, -32 * s * (1 - 4 * s**2), -64 * (1 - 12 * s**2)
    angle, angle_R, angle_RR = sin(pi * t) * H, sin(pi * t) * H_R, sin(pi * t) * H_RR
    angle_t, angle_tt = pi * cos(pi * t) * H, -pi**2 * sin(pi * t) * H
    tangential = R * angle_tt - c2 * (3 * angle_R + R * angle_RR)
    radial = -R * (angle_t**2 - c2 * angle_R**2)
    e_R = X.T / R
    e_theta = np.stack([-e_R[1], e_R[0]])
    b = tangential * e_theta + radial * e_R
    return np.stack([cos(angle) * b[0] - sin(angle) * b[1], sin(angle) * b[0] + cos(angle) * b[1]], 1)


PHASES = 2 * pi / 3 * np.arange(3)

BODY_FORCES = {
    "bar": standing(0.05, 2, lambda t: cos(C * pi * t), 0.0),
    "square": standing(0.1, 1, lambda t: np.array([cos(C * pi * t), sin(C * pi * t)]), 0.3),
    "cube": standing(0.05, 2, lambda t: sin(C * pi * t + PHASES), 0.3),
    "swing": swing(),
    "vortex": vortex,
}


def body_force_of(problem, start):
    if problem in ("ring", "shell"):
        return radial(start.lam, start.mu)
    return BODY_FORCES.get(problem)


WALLS = {
    "swing": {(0, 0): SwingingWall(0.0, 1), (0, 1): SwingingWall(1.0, -1)},
    "shock": {(0, 0): RammingWall(0.0, 0.0), (0, 1): RammingWall(0.05, -1840.0)},
    "stretch-1d": {(0, 0): PullingWall(-10.0), (0, 1): PullingWall(10.0)},
    "stretch": {(0, 0): PullingWall(-10.0), (0, 1): PullingWall(10.0)},
}
