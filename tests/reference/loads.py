"""Surface loads of docs/theory.md, "Body forces and surface loads": forces P N dA on the parts of a body's surface."""
import types

import numpy as np

import rows


def join(*surfaces):
    """Of surfaces whose parts belong to the same body: particles, places from them, and forces at a time."""
    return types.SimpleNamespace(particle=np.concatenate([s.particle for s in surfaces]),
                                 d=np.concatenate([s.d for s in surfaces]),
                                 force=lambda t: np.concatenate([s.force(t) for s in surfaces]))


def pulse_end(start, outward):
    """The left or the right end of `pulse`: squares of a lattice, with the tension sigma tri((t - X/c)/duration)."""
    sigma, duration = start.parameters["stress"], start.parameters["duration"]
    width, end = start.h / start.ppc, 0.2 if outward > 0 else 0.0
    particle = np.flatnonzero(abs(start.X[:, 0] - end) < width)

    def force(t):
        q = (t - end / start.wave_speed) / duration
        tension = sigma * max(0.0, 1 - abs(2 * q - 1))
        return np.tile([outward * tension * width, 0.0], (len(particle), 1))

    return types.SimpleNamespace(particle=particle, d=np.tile([outward * width / 2, 0.0], (len(particle), 1)),
                                 force=force)


def loads(problem, start):
    """Of the problems that have any, by what they start from."""
    if problem == "pulse":
        return join(pulse_end(start, -1), pulse_end(start, 1))
    if problem in ("ring", "shell") and start.lam != 0:
        return join(rows.side(start, -1), rows.side(start, 1))
    return None
