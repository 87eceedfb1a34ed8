"""Holds the program's particles against those of the reference: compare.py PROGRAM.

Runs every case of cases.py by the program and by mpm.py from the same start, and compares position, velocity and
deformation gradient of each particle, by id, after the last step. Where the program runs a part of a body whose images
make the whole, it compares what the program's record says of the whole. Prints a line for each case, and exits 1 when
one differs.
"""
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np

sys.dont_write_bytecode = True  # nothing is left in the tree
import runs
from cases import cases
from loads import loads
from mpm import Body
from problems import WALLS, body_force_of

TOLERANCE = 1e-12  # of the largest position, velocity and deformation gradient
OF_THE_START = ("material", "fill", "param", "grid-offset", "quarter")  # the reference has them from there


def reference_end(start, case, further):
    """The same particles after the same steps of the reference."""
    words = {name.replace("-", "_"): float(value) if value[0].isdigit() else value
             for name, value in further.items() if name not in OF_THE_START}
    name = case["problem"]
    body = Body(start, WALLS.get(name, {}), body_force_of(name, start), loads(name, start), case["basis"],
                case["integrator"], case["update"], int(case["order"] or 1), **words)
    for _ in range(int(case["steps"])):
        body.step()
    return body


def to_images(apart, start):
    """A particle on one periodic face is on the other."""
    for d, (word, _) in enumerate(start.faces):
        if word == "periodic":
            length = start.cells[d] * start.h
            apart[:, d] -= length * np.round(apart[:, d] / length)
    return apart


def difference(program, case, further):
    """The largest difference in a field, relative to the field's largest value."""
    arguments = ["--whole", *runs.arguments_of(case, further)]
    start = runs.start_of(program, arguments)
    id, x, v, F, time = runs.end_of(program, arguments, case["steps"], start.x.shape[1])
    body = reference_end(start, case, further)
    assert abs(time / body.t - 1) < 1e-12, f"the program ended at {time}, not {body.t}: {arguments}"
    assert sorted(id) == sorted(start.id), f"the program ended with other particles: {arguments}"
    row = {number: k for k, number in enumerate(start.id)}
    order = [row[number] for number in id]
    fields = ((to_images(x - body.x[order], start), x), (v - body.v[order], v), (F - body.F[order], F))
    return np.max([abs(apart).max() / abs(values).max() for apart, values in fields])


def part_difference(program, case, further, images):
    """Between the record of a part that images make a whole, and the reference's whole.

    The largest of an error of displacements, relative to the largest position, and of the kinetic energy.
    """
    arguments = runs.arguments_of(case, further)
    record = runs.record_of(program, arguments, case["steps"])
    assert record["images"] == images, f"{record['images']} images: {arguments}"
    start = runs.start_of(program, ["--whole", *arguments])
    body = reference_end(start, case, further)
    energy = (body.m[:, None] * body.v**2).sum() / 2
    differences = [abs(record["energy"]["kinetic"] / energy - 1)]
    if record["error"]["l2"] is not None:
        u = runs.displacements(program, case["problem"], start.parameters, start.X, body.t)
        error = np.linalg.norm(to_images(body.x - start.X - u, start), axis=1)
        norms = {"l1": error.mean(), "l2": (error**2).mean() ** 0.5, "linf": error.max()}
        differences += [abs(record["error"][name] - norm) / abs(body.x).max() for name, norm in norms.items()]
    return max(differences)


def compared(program, line, case, further):
    """A line of the answer."""
    images = float(further.pop("images", 0))
    largest = part_difference(program, case, further, images) if images else difference(program, case, further)
    return f"{line:108} {largest:.1e} {'ok' if largest <= TOLERANCE else 'differs'}"


def main(program):
    differing = 0
    with ThreadPoolExecutor(2) as pool:  # one runs the program while the other computes
        for line in pool.map(lambda case: compared(program, *case), cases()):
            print(line, flush=True)
            differing += line.endswith("differs")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
