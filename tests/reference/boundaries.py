"""The faces of docs/theory.md, "Boundaries" and "Moving walls", as matrices along the axes."""
import functools

import numpy as np


class HeldNodes:
    """What a wall holds through a step: the velocities along axis d of the nodes up to `depth` cells inside it. N 2.5.

    Nodes without mass outside the wall count as held, too: no particle sees them.
    """

    def __init__(self, grid, d, end, wall, t, depth, gradient):
        self.grid, self.d, self.wall = grid, d, wall
        self.distance = grid.x[:, d] - wall.place(t)
        self.inside = self.distance if end == 0 else -self.distance
        self.nodes = self.inside <= (depth + 1e-9) * grid.h
        self.estimated = gradient == "estimated"
        self.gradient = np.full(len(grid.x), wall.gradient(t) if gradient == "given" else 0.0)

    def estimate_gradient(self, v, m, v_wall):
        """N (4): over the last free node and the first held one inside, along each line of nodes through the wall."""
        if not self.estimated:
            return
        innermost = self.inside[self.nodes].max()
        next_to_it = self.inside[~self.nodes].min()
        counts = (self.inside > 0) & (m > 0) & ((self.inside == innermost) | (self.inside == next_to_it))

        def line_sums(q):
            q = np.where(counts, q, 0).reshape(self.grid.shape).sum(self.d, keepdims=True)
            return np.broadcast_to(q, self.grid.shape).ravel()

        squares = line_sums(self.distance**2)
        products = line_sums((v[:, self.d] - v_wall) * self.distance)
        self.gradient = np.where(squares > 0, products / np.where(squares > 0, squares, 1), 0)

    def velocities(self, t):
        return self.wall.velocity(t) + self.gradient * self.distance


class Boundaries:
    """What faces make of mapped data (`fold`) and of grid velocities and accelerations (`hold`)."""

    def __init__(self, grid, faces, walls, wall_depth, wall_gradient):
        """`faces` has a pair of words for each axis; `walls` maps (axis, end) to a wall's motion."""
        self.grid, self.faces, self.walls = grid, faces, walls
        self.wall_depth, self.wall_gradient = wall_depth, wall_gradient

    def places(self, d):
        """Of each end of an axis: the word, the index of the node on the face, and the step outwards."""
        g, size = self.grid.layers, self.grid.shape[d]
        return [(self.faces[d][0], g, -1), (self.faces[d][1], size - 1 - g, 1)]

    @functools.cache
    def fold_matrix(self, d, normal):
        size, n = self.grid.shape[d], self.grid.cells[d]
        if self.faces[d][0] == "periodic":  # nodes a period apart are one: S 5.2
            i = np.arange(size)
            return ((i[:, None] - i) % n == 0).astype(float)
        matrix = np.eye(size)
        for word, face, _ in self.places(d):
            if word == "mirror":  # ghosts onto their images, nodes on the plane onto themselves
                for k in range(-self.grid.layers, self.grid.layers + 1):
                    matrix[face + k, face - k] += -1 if normal else 1
        return matrix

    @functools.cache
    def hold_matrix(self, d, normal):
        matrix = np.eye(self.grid.shape[d])
        for word, face, out in self.places(d):
            for k in range(self.grid.layers + 1):
                if word == "dirichlet":  # every component: S 3.4
                    matrix[face + k * out] = 0
                elif word == "symmetry" and normal:  # minus the mirror image's: S 3.4.2
                    matrix[face + k * out] = 0
                    if k:
                        matrix[face + k * out, face - k * out] = -1
        return matrix

    def along_axes(self, field, component, matrix):
        """A matrix for each axis on a component of a field; `matrix` takes the axis and whether it is its own."""
        field = field.reshape(self.grid.shape)
        for d in range(field.ndim):
            field = np.moveaxis(np.tensordot(matrix(d, d == component), field, (1, d)), 0, d)
        return field.ravel()

    def fold(self, field):
        """Mapped data: a scalar, or a vector for each node."""
        if field.ndim == 1:
            return self.along_axes(field, None, self.fold_matrix)
        return np.stack([self.along_axes(column, c, self.fold_matrix) for c, column in enumerate(field.T)], 1)

    def begin_step(self, t):
        """Walls stand where they are at t. Momenta that are mapped, and velocities that walls hold, are those of t."""
        self.t_mapped = self.t_held = t
        self.held_by_walls = [HeldNodes(self.grid, d, end, wall, t, self.wall_depth, self.wall_gradient)
                              for (d, end), wall in self.walls.items()]

    def estimate_gradients(self, v, m):
        for held in self.held_by_walls:
            held.estimate_gradient(v, m, held.wall.velocity(self.t_mapped))

    def without_held(self, q, matrix):
        q = np.stack([self.along_axes(column, c, matrix) for c, column in enumerate(q.T)], 1)
        for held in self.held_by_walls:
            q[held.nodes, held.d] = 0
        return q

    def hold_at_zero(self, q):
        """Accelerations, and changes of velocities."""
        return self.without_held(q, self.hold_matrix)

    def hold_transposed(self, q):
        """The transpose of `hold_at_zero`: a force on a node that moves against another is one the other way there."""
        return self.without_held(q, lambda *axis: self.hold_matrix(*axis).T)

    def hold(self, v):
        """Velocities: those that walls hold are the walls' own."""
        v = self.hold_at_zero(v)
        for held in self.held_by_walls:
            v[held.nodes, held.d] = held.velocities(self.t_held)[held.nodes]
        return v

    def held_accelerations(self, a, v, p, m, dt, difference):
        """(v_i - p_i/m_i)/dt on nodes that walls hold, N 2.4; with `difference` on all that are held, S (30)."""
        for c in range(v.shape[1]):
            held = np.zeros(len(v), bool)
            for wall in self.held_by_walls:
                if wall.d == c:
                    held |= wall.nodes & (m > 0)
            if difference:
                held |= ~self.untouched(c) & (m > 0)
            a[held, c] = (v[held, c] - p[held, c] / m[held]) / dt
        return a

    @functools.cache
    def untouched(self, component):
        """Whether `hold_matrix` leaves a component of a node as it is."""
        free = np.ones(self.grid.shape, bool)
        for d in range(free.ndim):
            own = np.diag(self.hold_matrix(d, d == component)) == 1
            free &= own.reshape([-1 if e == d else 1 for e in range(free.ndim)])
        return free.ravel()
