"""The consistent mass of docs/theory.md: its regularised matrix, and the conjugate gradients that solve with it."""
import numpy as np

EPSILON, THETA = 0.01, 0.25
RESIDUAL = 1e-5  # of that of the lumped solution, at which iterations end
MOST_ITERATIONS = int(np.ceil(np.log(2 / (RESIDUAL * np.sqrt(EPSILON))) / (2 * np.sqrt(EPSILON))))


def ratio(a, b):
    """Nothing of a component that is solved."""
    return np.divide(a, b, out=np.zeros_like(a), where=b > 0)


class ConsistentMass:
    def __init__(self, boundaries, full_cell):
        self.boundaries = boundaries
        self.full = full_cell * self.halves()
        self.share = 1 / boundaries.fold(np.ones(len(self.full)))

    def halves(self):
        """A half on each face that is neither periodic nor mirror."""
        grid = self.boundaries.grid
        halves = np.ones(grid.shape)
        for d in range(halves.ndim):
            for word, face, _ in self.boundaries.places(d):
                if word not in ("periodic", "mirror"):
                    np.moveaxis(halves, d, 0)[face] /= 2
        return halves.ravel()

    def begin_step(self, S, m_p, m_i):
        self.S, self.m_p, self.m_i = S, m_p, m_i
        self.c = np.sqrt(1 - EPSILON) * np.minimum(1, m_i / (THETA * self.full))
        self.row_sums = self.unregularised(self.c)

    def unregularised(self, u):
        """The sums over j of M_ij u_j."""
        return self.boundaries.fold((self.S.T * self.m_p) @ (self.S @ u))

    def times(self, u):
        """C^T M^ u with M^ u = m_i u_i - c_i times the sum over j of M_ij c_j (u_i - u_j)."""
        c = self.c[:, None]
        q = self.m_i[:, None] * u - c * (u * self.row_sums[:, None] - self.unregularised(c * u))
        return self.boundaries.hold_transposed(q)

    def inverse_diagonal(self, shape, cutoff):
        """Of C^T diag(m) C; nothing where nodes keep what they have."""
        m = np.where(self.m_i > cutoff, self.m_i, 0)[:, None]
        diagonal = self.boundaries.hold_transposed(m * self.boundaries.hold_at_zero(np.ones(shape)))
        return np.divide(1, diagonal, out=np.zeros(shape), where=diagonal > 0)

    def solve(self, b, u, cutoff):
        """C^T M^ u = C^T b for a u that holds what is held, C being `hold_at_zero`, from one that does."""
        inverse = self.inverse_diagonal(u.shape, cutoff)

        def dot(p, q):
            """By components; nodes that faces make one count once."""
            return (self.share[:, None] * p * q).sum(0)

        r = self.boundaries.hold_transposed(b) - self.times(u)
        p, beta, norm = 0, 0, dot(r, inverse * r)
        end = RESIDUAL**2 * norm.sum()
        for _ in range(MOST_ITERATIONS):
            if norm.sum() <= end:
                break
            p = self.boundaries.hold_at_zero(inverse * r + beta * p)
            q = self.times(p)
            alpha = ratio(norm, dot(p, q))
            u, r = u + alpha * p, r - alpha * q
            before, norm = norm, dot(r, inverse * r)
            beta = ratio(norm, before)
        return u
