"""Holds the program's particles against those of the reference: compare.py PROGRAM.

Runs every case below by the program and by mpm.py from the same start, and compares position, velocity and deformation
gradient of each particle, by id, after the last step. Prints a line for each case, and exits 1 when one differs.
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import types
import xml.etree.ElementTree

import numpy as np

sys.dont_write_bytecode = True  # nothing is left in the tree
from mpm import Body
from problems import BODY_FORCES, WALLS

TOLERANCE = 1e-12  # of the largest position, velocity and deformation gradient

# `update` has the order of xpic and fmpm behind a colon. A boundary of `-` is the problem's own.
#
# One case has a tolerance of its own: with cpgimp between planes of symmetry particles next to a plane grow over it by
# little, which gives nodes beyond it next to no mass. What rounding does to their velocities grows from step to step.
CASES = """
problem  cells ppc cfl steps basis    integrator update  boundary further
bar         11   2 0.2    12 linear   usl        flip    periodic
bar         11   2 0.2    12 bspline2 usf        flip    periodic
bar         11   3 0.4    12 bspline3 usavg      xpic:3  periodic
bar         11   2 0.2    12 gimp     cd         flip    periodic
bar         11   2 0.2    12 cpgimp   usl        fmpm:4  periodic
bar         11   2 0.2    12 cpdi     usl        pic     periodic
bar         11   2 0.2    12 bspline2 usl        apic    periodic
bar         11   2 0.2    12 bspline3 usl        apic    mirror
bar         11   2 0.2    12 bspline2 usl+       flip    mirror
bar         11   2 0.2    12 gimp     usavg+     fmpm:2  mirror
bar         11   2 0.2    12 bspline2 usl        fmpm:3  symmetry
bar         11   2 0.2    12 bspline3 cd         flip    dirichlet
square       6   2 0.2    10 linear   usf        flip    symmetry
square       6   2 0.2    10 bspline2 usl        flip    symmetry position=second-order
square       6   2 0.2    10 bspline2 usl        xpic:3  symmetry
square       6   2 0.2    10 bspline2 usl        fmpm:3  symmetry wall-method=elimination
square       6   2 0.2    10 bspline3 usl        flip    symmetry position=particle
square       6   2 0.2    10 gimp     cd         flip    symmetry
square       8   2 0.2    10 cpgimp   usl        flip    symmetry tolerance=1e-10
square       6   2 0.2    10 cpgimp   usavg      fmpm:2  mirror
square       6   3 0.4    10 bspline2 usavg      fmpm:5  mirror
square       6   2 0.2    10 bspline3 usl        apic    mirror
square       8   2 0.2     8 cpdi     usl        flip    mirror
square       8   2 0.2     8 cpdi     usavg      xpic:2  symmetry
square       6   2 0.2    10 bspline2 cd         flip    dirichlet
square       6   2 0.2    10 linear   usl        fmpm:2  dirichlet
square       6   2 0.2    10 bspline2 usl        apic    dirichlet
square       6   2 0.2    10 gimp     usl        pic     dirichlet
square       6   2 0.2    10 bspline2 usl        xpic:4  xmin=symmetry,xmax=mirror,ymin=free,ymax=symmetry
square       6   2 0.2    10 bspline3 usavg      pic     xmin=dirichlet,xmax=free,ymin=mirror,ymax=symmetry
square       6   2 0.2    10 bspline2 usl        flip    symmetry wall-acceleration=difference
square       6   2 0.2    10 linear   usl        flip    dirichlet wall-acceleration=difference
square       6   2 0.2    10 gimp     rk4        flip    symmetry
square       6   2 0.2    10 b2gimp   uvf        flip    mirror
square       6   2 0.2    10 ugimp    usavg+     flip    symmetry smoothing-length=0.6
ring         8   2 0.2    12 bspline2 usl        flip    free
ring         8   2 0.2    12 bspline3 rk4        flip    free
ring         8   2 0.2    12 bspline2 usl        apic    free
ring         8   2 0.2    12 cpdi     usavg      xpic:3  free
ring         8   2 0.2    12 gimp     usl        fmpm:2  free
ring         8   2 0.2    12 cpgimp   usf        flip    free
vortex       8   2 0.1    12 bspline3 usl        flip    free deformation=exponential
vortex       8   2 0.1    12 cpdi     cd         flip    free
translation  6   2 0.4    20 bspline2 usl        fmpm:2  periodic
swing        5   2 0.2    12 bspline2 usl        flip    -
swing        5   2 0.2    12 linear   usf        flip    -
swing        5   2 0.2    12 gimp     usavg      fmpm:4  - wall-method=lumped
swing        5   2 0.2    12 bspline2 usl        fmpm:4  - wall-method=velocity
swing        5   2 0.2    12 bspline2 usl        fmpm:4  - wall-method=combined
swing        5   2 0.2    12 bspline3 usavg      fmpm:3  - wall-method=elimination
swing        5   2 0.2    12 bspline2 usl        xpic:4  - wall-method=elimination
swing        5   2 0.2    12 bspline2 usl        apic    -
swing        5   2 0.2    12 bspline2 usavg+     flip    - wall-gradient=estimated
swing        5   2 0.2    12 b2cpdi   usl        xpic:2  - wall-gradient=zero
swing        6   2 0.2    12 cpgimp   usl+       flip    - wall-gradient=estimated wall-depth=2
stretch-1d   2   2 0.2    20 linear   usl        fmpm:3  -
stretch      2   2 0.2    20 bspline2 usl        flip    - wall-gradient=estimated
stretch      2   2 0.2    20 cpdi     usavg      xpic:3  - deformation=exponential
bar         11   2 0.2    12 bspline2-open usl   flip    symmetry
bar         11   2 0.2    12 bspline3-open cd    flip    dirichlet
bar         11   3 0.2     6 bspline3-open usavg xpic:3  free
square       6   2 0.2    10 bspline2-open usf   fmpm:3  symmetry wall-method=elimination
square       6   2 0.2    10 bspline3-open usl+  flip    dirichlet wall-acceleration=difference
square       6   3 0.2     6 bspline3-open rk4   flip    xmin=free,xmax=dirichlet,ymin=free,ymax=symmetry
ring         8   2 0.2    12 bspline3-open usl   fmpm:2  free
stretch      2   2 0.2    20 bspline2-open usavg fmpm:3  - wall-gradient=estimated
stretch      2   2 0.2    20 bspline3-open usl   xpic:2  - wall-depth=2
cube         4   2 0.2     3 bspline2-open usl   flip    symmetry
cube         4   2 0.2     3 bspline3-open usavg fmpm:2  dirichlet
impact       2   2 0.4    60 bspline2 usl        xpic:2  free
wave         6   2 0.2    12 bspline2 uvf        flip    symmetry
wave         6   2 0.2    12 gimp     usl        fmpm:2  mirror material=neo-hookean-log
cube         4   2 0.2     3 bspline2 usl        flip    periodic
cube         5   1 0.2     3 cpdi     usl        fmpm:2  periodic
cube         4   2 0.2     3 bspline2 rk4        flip    periodic
cube         4   2 0.2     3 bspline3 cd         flip    periodic
cube         4   1 0.2     3 bspline2 usl        apic    periodic
cube         5   2 0.2     3 linear   usavg      flip    symmetry
cube         5   2 0.2     3 gimp     usf        xpic:2  mirror
cube         5   2 0.2     3 cpgimp   usl        pic     dirichlet
"""


def cases():
    """Each line of the table: its columns by their heads, and what else it sets."""
    head, *lines = CASES.strip().splitlines()
    names = head.split()[:-1]
    for line in lines:
        words = line.split()
        case = dict(zip(names, words))
        case["update"], _, case["order"] = case["update"].partition(":")
        yield line, case, dict(word.split("=") for word in words[len(names):])


def arguments_of(case, further):
    """The command line's words for a case."""
    case = dict(case, **further)
    arguments = ["--whole"]
    for name, value in case.items():
        if name != "steps" and value not in ("", "-"):
            arguments += ["--" + ("velocity-update" if name == "update" else name), value]
    return arguments


def answer(program, *arguments):
    return subprocess.run([program, *arguments], check=True, stdout=subprocess.PIPE, text=True).stdout


def start_of(program, arguments):
    """The particles that a case starts with, its material, grid and time step."""
    case = json.loads(answer(program, "particles", *arguments, "--json"))
    rows = list(csv.DictReader(answer(program, "particles", *arguments).splitlines()))
    D = case["dimension"]
    axes = "xyz"[:D]

    def columns(*names):
        return np.array([[float(row[name]) for name in names] for row in rows])

    boundary = case["grid"]["boundary"]
    return types.SimpleNamespace(
        id=columns("id")[:, 0], X=columns(*axes.upper()), x=columns(*axes), v=columns(*("v_" + c for c in axes)),
        F=columns(*("F_" + r + c for r in axes for c in axes)).reshape(-1, D, D),
        m=columns("m")[:, 0], V0=columns("V")[:, 0], h=case["h"], dt=case["dt"], law=case["material"],
        lam=case["lambda"], mu=case["mu"],
        lower=np.array(case["grid"]["lower"]), cells=case["grid"]["cells"],
        faces=[(boundary[c + "min"], boundary[c + "max"]) for c in axes])


def program_end(program, arguments, steps, D):
    """The particles after the last step: id, position, velocity, deformation gradient, and the time."""
    with tempfile.TemporaryDirectory() as folder:
        answer(program, "run", *arguments, "--steps", str(steps), "--vtu", folder)
        last = max(pathlib.Path(folder).glob("*.vtu"))
        arrays = {}
        for array in xml.etree.ElementTree.parse(last).iter("DataArray"):
            numbers = np.array(array.text.split(), float)
            arrays[array.get("Name")] = numbers.reshape(-1, int(array.get("NumberOfComponents", 1)))
    F = arrays["deformation_gradient"].reshape(-1, 3, 3)[:, :D, :D]
    return (arrays["id"][:, 0], arrays["position"][:, :D], arrays["velocity"][:, :D], F, arrays["TimeValue"][0, 0])


def reference_end(start, case, further):
    """The same particles after the same steps of the reference."""
    words = {name.replace("-", "_"): float(value) if value[0].isdigit() else value
             for name, value in further.items() if name != "material"}  # the start has that
    body = Body(start, WALLS.get(case["problem"], {}), BODY_FORCES.get(case["problem"]), case["basis"],
                case["integrator"], case["update"], int(case["order"] or 1), **words)
    for _ in range(int(case["steps"])):
        body.step()
    return body


def difference(program, case, further):
    """The largest difference in a field, relative to the field's largest value."""
    arguments = arguments_of(case, further)
    start = start_of(program, arguments)
    id, x, v, F, time = program_end(program, arguments, case["steps"], start.x.shape[1])
    body = reference_end(start, case, further)
    assert abs(time / body.t - 1) < 1e-12, f"the program ended at {time}, not {body.t}: {arguments}"
    assert sorted(id) == sorted(start.id), f"the program ended with other particles: {arguments}"
    row = {number: k for k, number in enumerate(start.id)}
    order = [row[number] for number in id]
    apart = x - body.x[order]
    for d, (word, _) in enumerate(start.faces):
        if word == "periodic":  # a particle on one face is on the other
            length = start.cells[d] * start.h
            apart[:, d] -= length * np.round(apart[:, d] / length)
    fields = ((apart, x), (v - body.v[order], v), (F - body.F[order], F))
    return np.max([abs(apart).max() / abs(values).max() for apart, values in fields])


def main(program):
    differing = 0
    for line, case, further in cases():
        tolerance = float(further.pop("tolerance", TOLERANCE))
        largest = difference(program, case, further)
        same = largest <= tolerance
        differing += not same
        print(f"{line:108} {largest:.1e} {'ok' if same else 'differs'}", flush=True)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
