"""The grid functions of docs/theory.md, "Bases" and "Particle domains", as dense matrices over all nodes."""
import itertools

import numpy as np

import open_splines


class Grid:
    """Nodes on and around the cells; fields on them are matrices, a row for each node."""

    def __init__(self, start, basis):
        self.h, self.lower, self.cells = start.h, start.lower, start.cells
        if basis.endswith("-open"):
            degree = open_splines.degree_of(basis)
            self.layers = 0
            self.knots = [open_splines.knots(low, self.h, n, degree) for low, n in zip(self.lower, self.cells)]
            self.axes = [open_splines.places(knots, degree) for knots in self.knots]
        else:
            self.layers = 4 if basis in ("cpdi", "b2cpdi") else 2  # of ghost nodes beyond each face
            self.axes = [low + self.h * (np.arange(n + 1 + 2 * self.layers) - self.layers)
                         for low, n in zip(self.lower, self.cells)]
        self.shape = [len(axis) for axis in self.axes]
        self.x = np.stack(np.meshgrid(*self.axes, indexing="ij"), -1).reshape(-1, len(self.axes))


def hat(xi):
    """S (17)."""
    return np.maximum(0, 1 - abs(xi))


def hat_gradient(xi):
    """On a node that of the cell to the right."""
    return np.where((-1 <= xi) & (xi < 0), 1.0, np.where((0 <= xi) & (xi < 1), -1.0, 0.0))


def hat_beyond(r):
    """The hat's integral from r >= 0 on."""
    return np.maximum(0, 1 - r) ** 2 / 2


def bspline2(xi):
    """S (19) to (21)."""
    r = abs(xi)
    return np.where(r <= 0.5, 0.75 - r**2, np.maximum(0, 1.5 - r) ** 2 / 2)


def bspline2_gradient(xi):
    r = abs(xi)
    return np.where(r <= 0.5, -2 * xi, -np.sign(xi) * np.maximum(0, 1.5 - r))


def bspline2_beyond(r):
    """The quadratic spline's integral from r >= 0 on."""
    return np.where(r <= 0.5, 0.5 - 0.75 * r + r**3 / 3, np.maximum(0, 1.5 - r) ** 3 / 6)


def bspline3(xi):
    """S (19), (20)."""
    r = abs(xi)
    return np.where(r <= 1, (4 - 6 * r**2 + 3 * r**3) / 6, np.maximum(0, 2 - r) ** 3 / 6)


def bspline3_gradient(xi):
    r = abs(xi)
    return np.sign(xi) * np.where(r <= 1, (9 * r**2 - 12 * r) / 6, -np.maximum(0, 2 - r) ** 2 / 2)


def box(function, beyond, l):
    """The mean over boxes of width l, in cells, and its gradient: S (29), W (6), (7).

    By what is beyond both ends of the box, outwards: that a box barely overlaps the function is not lost in rounding.
    """
    def mean(xi):
        near, far = abs(xi) - l / 2, abs(xi) + l / 2
        return (np.where(near < 0, 1 - beyond(-near), beyond(near)) - beyond(far)) / l

    return mean, lambda xi: (function(xi + l / 2) - function(xi - l / 2)) / l


def product(along_axes):
    """S (18): rows of numbers along each axis make a row of their products."""
    result = along_axes[0]
    for numbers in along_axes[1:]:
        result = (result[:, :, None] * numbers[:, None, :]).reshape(len(result), -1)
    return result


def products(N, dN):
    """Weights and gradients, from those along each axis."""
    D = len(N)
    return product(N), [product([dN[e] if e == d else N[e] for e in range(D)]) for d in range(D)]


def at_points(grid, x, functions):
    """Weights of all nodes at the points x, and gradients by axis; a pair (function, gradient) for each axis."""
    xi = [(x[:, d, None] - axis) / grid.h for d, axis in enumerate(grid.axes)]
    return products([function(distance) for distance, (function, _) in zip(xi, functions)],
                    [gradient(distance) / grid.h for distance, (_, gradient) in zip(xi, functions)])


def cpdi(grid, x, F, R0, corner_functions):
    """Sadeghirad et al. (2011), N 2.1: interpolates between the corners of the particle's domain."""
    D = x.shape[1]
    R = F @ R0
    inverse_transposed = np.linalg.inv(R).transpose(0, 2, 1)
    S, G = 0, [0] * D
    for corner in itertools.product((-1, 1), repeat=D):
        S_c, _ = at_points(grid, x + R @ corner / 2, [corner_functions] * D)
        slope = 2 ** (1 - D) * inverse_transposed @ corner
        S = S + S_c / 2**D
        G = [G[d] + slope[:, d, None] * S_c for d in range(D)]
    return S, G


def weights(basis, grid, x, F, V0, R0, smoothing_length):
    """S, with S_pi = N_ip, and G[d], the component d of the gradients of N_ip."""
    D = x.shape[1]
    if basis.endswith("-open"):
        degree = open_splines.degree_of(basis)
        return products(*zip(*(open_splines.functions(knots, degree, x[:, d]) for d, knots in enumerate(grid.knots))))
    if basis in ("cpdi", "b2cpdi"):
        return cpdi(grid, x, F, R0, (hat, hat_gradient) if basis == "cpdi" else (bspline2, bspline2_gradient))
    width = (V0 ** (1 / D) / grid.h)[:, None]  # of a particle at rest, along every axis
    along = {
        "linear": lambda d: (hat, hat_gradient),
        "bspline2": lambda d: (bspline2, bspline2_gradient),
        "bspline3": lambda d: (bspline3, bspline3_gradient),
        "ugimp": lambda d: box(hat, hat_beyond, smoothing_length),
        "gimp": lambda d: box(hat, hat_beyond, width),
        "cpgimp": lambda d: box(hat, hat_beyond, width * F[:, d, d, None]),  # W (7), (63)
        "b2gimp": lambda d: box(bspline2, bspline2_beyond, width),  # N 2.1
    }[basis]
    return at_points(grid, x, [along(d) for d in range(D)])
