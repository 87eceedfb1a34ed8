"""Rings and shells in rows that follow their surfaces, the conforming fill of docs/theory.md, "Filling a body".

A particle X is the centroid of its voxel, between the radii r and s of its row: X V is the integral of R^D dR times M,
where M is the integral of e_R over the voxel's angles.
"""
import types

import numpy as np

from problems import C


def row_radii(start):
    """Between which radii each particle's row lies."""
    inner, outer = start.parameters["inner_radius"], start.parameters["outer_radius"]
    count = max(1, round(start.ppc * (outer - inner) / start.h))
    thickness = (outer - inner) / count
    r = inner + thickness * np.floor((np.linalg.norm(start.X, axis=1) - inner) / thickness)
    return r, r + thickness


def domains(start):
    """R0 in the plane: edges of the row's thickness along e_R, and along e_theta what makes the volume of it."""
    r, s = row_radii(start)
    e_R = start.X / np.hypot(*start.X.T)[:, None]
    e_theta = np.stack([-e_R[:, 1], e_R[:, 0]], 1)
    return np.stack([(s - r)[:, None] * e_R, (start.V0 / (s - r))[:, None] * e_theta], 2)


def side(start, outward):
    """The inner or the outer surface of `ring` and `shell`, under the normal stress lambda ln J: W (60) to (62)."""
    R_s, w = (start.parameters["outer_radius"], 1.0) if outward > 0 else (start.parameters["inner_radius"], 1.25)
    A, D = start.parameters["amplitude"], start.X.shape[1]
    r, s = row_radii(start)
    particle = np.flatnonzero(abs((s if outward > 0 else r) - R_s) < 1e-9)
    X, r, s = start.X[particle], r[particle], s[particle]
    M = start.V0[particle, None] * X / ((s ** (D + 1) - r ** (D + 1)) / (D + 1))[:, None]
    middle = R_s * X / np.linalg.norm(X, axis=1)[:, None]

    def force(t):
        J = (1 + A * np.cos(C * np.pi * t) * w / R_s) ** (D - 1)
        return outward * start.lam * np.log(J) * R_s ** (D - 1) * M

    return types.SimpleNamespace(particle=particle, d=middle - X, force=force)
