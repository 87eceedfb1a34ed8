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
    count = max(1, int(np.floor(start.ppc * (outer - inner) / start.h + 0.5)))
    thickness = (outer - inner) / count
    r = inner + thickness * np.floor((np.linalg.norm(start.X, axis=1) - inner) / thickness)
    return r, r + thickness


def domains(start):
    """R0: edges of the row's thickness along e_R, and across what makes the volume, in proportion to the angles."""
    r, s = row_radii(start)
    D = start.X.shape[1]
    e_R = start.X / np.linalg.norm(start.X, axis=1)[:, None]
    east = np.zeros_like(e_R)
    east[:, :2] = np.stack([-e_R[:, 1], e_R[:, 0]], 1) / np.hypot(e_R[:, 0], e_R[:, 1])[:, None]
    angles = start.V0 / ((s**D - r**D) / D)
    across = [(angles, east)]
    if D == 3:  # bands of latitude
        band = np.pi / 2 / np.floor(np.pi / 2 * (r + s) / 2 / (s - r) + 0.5)
        across = [(band, np.cross(east, e_R)), (angles / band, east)]
    scale = (start.V0 / (s - r) / angles) ** (1 / (D - 1))
    return np.stack([(s - r)[:, None] * e_R, *((scale * angle)[:, None] * e for angle, e in across)], 2)


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
