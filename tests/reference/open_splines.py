"""The open splines of docs/theory.md, "Bases": Cox and de Boor's recursion, S (22), (23), with M1's end knots."""
import numpy as np


def degree_of(basis):
    return int(basis[len("bspline")])


def knots(lower, h, cells, degree):
    """Those of one axis: each end `degree` + 1 times."""
    inner = lower + h * np.arange(cells + 1)
    return np.concatenate([[inner[0]] * degree, inner, [inner[-1]] * degree])


def places(t, degree):
    """The Greville abscissae: of each function the mean of its inner knots."""
    return np.array([t[i + 1:i + 1 + degree].mean() for i in range(len(t) - degree - 1)])


def over(numbers, width):
    """A term of S (22): without knots between its ends it is zero."""
    return np.divide(numbers, width, out=np.zeros_like(numbers), where=width > 0)


def functions(t, degree, x):
    """S (22), (23): a row of all functions for each of the points x, and their derivatives; closed at the last knot."""
    x = x[:, None]
    phi = ((t[:-1] <= x) & ((x < t[1:]) | (x == t[-1]) & (t[1:] == t[-1]) & (t[:-1] < t[-1]))).astype(float)
    for k in range(1, degree + 1):
        rising, falling = phi[:, :-1], phi[:, 1:]
        start, end, width = t[:-k - 1], t[k + 1:], t[k:] - t[:-k]
        slope = k * (over(rising, width[:-1]) - over(falling, width[1:]))
        phi = over(rising * (x - start), width[:-1]) + over(falling * (end - x), width[1:])
    return phi, slope
