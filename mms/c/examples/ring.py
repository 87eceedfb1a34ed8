#!/usr/bin/env python3
"""Displacement and body force of a ring at three points: for each a line with X, u and b.

Usage: ring.py LIBRARY, the path of libmpmvv_mms.so.
"""
import ctypes
import sys

try:
    import numpy
except ImportError:
    numpy = None

doubles = ctypes.POINTER(ctypes.c_double)


class Solution:
    """A solution of libmpmvv_mms; its fields take lists of points, or NumPy arrays of shape (n, D) without a copy."""

    def __init__(self, library, name, **parameters):
        self._library = library
        library.mpmvv_message.restype = ctypes.c_char_p
        names = (ctypes.c_char_p * len(parameters))(*(key.encode() for key in parameters))
        values = (ctypes.c_double * len(parameters))(*parameters.values())
        self._solution = ctypes.c_void_p()
        self._check(library.mpmvv_create(name.encode(), len(parameters), names, values, ctypes.byref(self._solution)))
        self.dimension = library.mpmvv_dimension(self._solution)

    def __del__(self):
        self._library.mpmvv_destroy(self._solution)

    def _check(self, status):
        if status != 0:
            raise ValueError(self._library.mpmvv_message().decode())

    def _vectors(self, function, X, t):
        if numpy is not None:
            X = numpy.ascontiguousarray(X, dtype=float)
            if X.ndim != 2 or X.shape[1] != self.dimension:
                raise ValueError(f"points of shape {X.shape} (those of n points: (n, {self.dimension}))")
            out = numpy.empty_like(X)
            self._check(function(self._solution, ctypes.c_size_t(len(X)), X.ctypes.data_as(doubles),
                                 ctypes.c_double(t), out.ctypes.data_as(doubles)))
            return out
        if any(len(point) != self.dimension for point in X):
            raise ValueError(f"points of another dimension than {self.dimension}")
        flat = [coordinate for point in X for coordinate in point]
        points, out = (ctypes.c_double * len(flat))(*flat), (ctypes.c_double * len(flat))()
        self._check(function(self._solution, ctypes.c_size_t(len(X)), points, ctypes.c_double(t), out))
        d = self.dimension
        return [list(out[p * d:(p + 1) * d]) for p in range(len(X))]

    def displacement(self, X, t):
        return self._vectors(self._library.mpmvv_displacement, X, t)

    def body_force(self, X, t):
        return self._vectors(self._library.mpmvv_body_force, X, t)


def main():
    ring = Solution(ctypes.CDLL(sys.argv[1]), "ring", amplitude=0.05, poissons_ratio=0.3)
    X, t = [[0.6, 0.0], [0.3, 0.7], [-0.5, -0.5]], 0.004
    for point, u, b in zip(X, ring.displacement(X, t), ring.body_force(X, t)):
        print(*(f"{number:.17g}" for number in (*point, *u, *b)))


main()
