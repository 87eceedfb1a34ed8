#!/usr/bin/env python3
"""A small MPM code: 1D and 2D (plane strain), neo-Hookean, explicit, velocities half a step behind.

Usage: small_mpm.py INPUT | --version. INPUT has a word and its values in a line; the particles come last. It knows
nothing of the harness that runs it, and shares no formula with it.
"""
import math
import sys

VERSION = "1.0"


def read(name):
    """The words with their values, and the particles: a list of numbers each, then its force where it has one."""
    words, particles = {}, []
    for line in open(name, encoding="utf-8"):
        if line.startswith("particle "):
            numbers, *force = line[9:].split("|")
            particles.append(([float(n) for n in numbers.split()], [f.strip() for f in force]))
        elif line.strip():
            word, _, rest = line.partition(" ")
            words[word] = rest.strip()
    return words, particles


def function(arguments, expressions):
    """Expressions of the arguments as one function that returns all."""
    names = dict(vars(math), math=math)
    return eval("lambda {}: ({},)".format(arguments, ", ".join(expressions)), names)  # the user's own input


def linear(s):
    """Nodes from the floor of s on: weights, and gradients by s."""
    i = math.floor(s)
    r = s - i
    return i, ((1 - r, -1.0), (r, 1.0))


def quadratic(s):
    i = math.floor(s - 0.5)
    r = s - i - 1  # from the middle node, -1/2 to 1/2
    return i, ((0.5 * (0.5 - r) ** 2, r - 0.5), (0.75 - r * r, -2 * r), (0.5 * (0.5 + r) ** 2, r + 0.5))


class Body:
    """Particles on a background grid. Matrices are lists row by row."""

    def __init__(self, words, particles):
        self.d = d = int(words["dimension"])
        self.h, self.dt = float(words["h"]), float(words["dt"])
        self.lam, self.mu = float(words["lambda"]), float(words["mu"])
        self.low = [float(x) for x in words["lower"].split()]
        self.cells = [int(n) for n in words["cells"].split()]
        self.boundary = words["boundary"]  # periodic, symmetry or free
        self.shape = {"linear": linear, "quadratic": quadratic}[words["shape"]]
        self.room = [n + {"periodic": 0, "symmetry": 1, "free": 3}[self.boundary] for n in self.cells]  # nodes on an axis
        rows = [numbers for numbers, _ in particles]
        self.X, self.x, self.v = ([r[k * d:(k + 1) * d] for r in rows] for k in range(3))
        self.m, self.V = [r[3 * d] for r in rows], [r[3 * d + 1] for r in rows]
        self.F = [r[3 * d + 2:] for r in rows]
        self.force_at = words["force"]  # an expression of X, of x, or one for each particle
        if self.force_at != "particle":
            names = {"reference": "XYZ", "current": "xyz"}[self.force_at]
            self.force = function(", ".join(names[:d]) + ", t", words["b"].split("|"))
        self.own_force = [function("t", force) for _, force in particles if force]

    def b(self, p, t):
        if self.force_at == "particle":
            return self.own_force[p](t)
        return self.force(*(self.X if self.force_at == "reference" else self.x)[p], t)

    def axis(self, k, x):
        """Node, weight and gradient along an axis, and -1 for nodes behind a plane of symmetry, which are its images."""
        first, weights = self.shape((x - self.low[k]) / self.h)
        n, nodes = self.cells[k], [(first + j, w, g / self.h) for j, (w, g) in enumerate(weights)]
        if self.boundary == "periodic":
            return [(i % n, w, g, 1) for i, w, g in nodes]
        if first < -1 or first + len(weights) - 1 > n + 1:
            sys.exit("particle left the grid")
        if self.boundary == "free":
            return [(i + 1, w, g, 1) for i, w, g in nodes]
        return [(n - abs(n - abs(i)), w, g, 1 if 0 <= i <= n else -1) for i, w, g in nodes]

    def stencil(self, x):
        """Nodes with weight, gradient and the sign of each component there."""
        if self.d == 1:
            return [(i, w, (g,), (s,)) for i, w, g, s in self.axis(0, x[0])]
        across, n = self.axis(0, x[0]), self.room[0]
        return [(i + n * j, wi * wj, (gi * wj, wi * gj), (si, sj))
                for j, wj, gj, sj in self.axis(1, x[1]) for i, wi, gi, si in across]

    def walls(self):
        """Nodes on planes of symmetry, with the component that is zero there."""
        if self.boundary != "symmetry":
            return []
        n = self.room
        if self.d == 1:
            return [(0, 0), (0, n[0] - 1)]
        sides = [(0, i + n[0] * j) for j in range(n[1]) for i in (0, n[0] - 1)]
        return sides + [(1, i + n[0] * j) for i in range(n[0]) for j in (0, n[1] - 1)]

    def pull(self, F):
        """Kirchhoff stress: mu (F F' - 1) + lambda ln J."""
        if self.d == 1:
            return (self.mu * (F[0] * F[0] - 1) + self.lam * math.log(F[0]),)
        a, b, c, e = F
        J = a * e - b * c
        s = self.lam * math.log(J) - self.mu
        return (self.mu * (a * a + b * b) + s, self.mu * (a * c + b * e),
                self.mu * (a * c + b * e), self.mu * (c * c + e * e) + s)

    def step(self, t, share):
        """One step; the velocities gain `share` of the time step's acceleration."""
        d, axes, dt = self.d, range(self.d), self.dt
        size = math.prod(self.room)
        mass, momentum, force = [0.0] * size, [[0.0] * size for _ in axes], [[0.0] * size for _ in axes]
        stencils = [self.stencil(x) for x in self.x]
        for p, stencil in enumerate(stencils):
            m, v, b, V = self.m[p], self.v[p], self.b(p, t), self.V[p]
            tau = self.pull(self.F[p])
            for i, w, g, s in stencil:
                wm = w * m
                mass[i] += wm
                for k in axes:
                    momentum[k][i] += s[k] * wm * v[k]
                    inner = tau[k * d] * g[0] + tau[k * d + 1] * g[1] if d == 2 else tau[0] * g[0]
                    force[k][i] += s[k] * (wm * b[k] - V * inner)
        gain = [[share * dt * f / m if m > 0 else 0.0 for f, m in zip(force[k], mass)] for k in axes]
        speed = [[q / m + a if m > 0 else 0.0 for q, m, a in zip(momentum[k], mass, gain[k])] for k in axes]
        for k, i in self.walls():
            gain[k][i] = speed[k][i] = 0.0
        for p, stencil in enumerate(stencils):
            F = self.F[p]
            for k in axes:
                self.v[p][k] += sum(w * s[k] * gain[k][i] for i, w, _, s in stencil)
                self.x[p][k] += dt * sum(w * s[k] * speed[k][i] for i, w, _, s in stencil)
            L = [dt * sum(s[k] * speed[k][i] * g[j] for i, _, g, s in stencil) + (k == j) for k in axes for j in axes]
            self.F[p] = [sum(L[k * d + l] * F[l * d + j] for l in axes) for k in axes for j in axes]
            if not all(map(math.isfinite, self.F[p])) or (self.F[p][0] if d == 1 else 1) <= 0:
                sys.exit("the motion blew up")

    def write(self, name, t):
        with open(name, "w", encoding="utf-8") as out:
            out.write("id," + ",".join("xy"[:self.d]) + ",m,time\n")
            for p, x in enumerate(self.x):
                out.write("{},{},{!r},{!r}\n".format(p + 1, ",".join(map(repr, x)), self.m[p], t))


def main():
    if sys.argv[1:] == ["--version"]:
        return print("small_mpm", VERSION)
    words, particles = read(sys.argv[1])
    body, steps = Body(words, particles), int(words["steps"])
    try:
        for n in range(steps):
            body.step(n * body.dt, 0.5 if n == 0 else 1.0)
    except (ValueError, OverflowError):  # the logarithm of a J below zero
        sys.exit("the motion blew up")
    body.write("particles.csv", steps * body.dt)


main()
