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
import rows
from cases import cases
from loads import loads
from mpm import Body
from problems import WALLS, body_force_of

TOLERANCE = 1e-12  # of the largest position, velocity and deformation gradient
OF_THE_START = ("material", "fill", "param", "grid-offset")  # what the reference does not ask for: its start has it


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
    lines = list(csv.DictReader(answer(program, "particles", *arguments).splitlines()))
    D = case["dimension"]
    axes = "xyz"[:D]

    def columns(*names):
        return np.array([[float(row[name]) for name in names] for row in lines])

    boundary = case["grid"]["boundary"]
    start = types.SimpleNamespace(
        id=columns("id")[:, 0], X=columns(*axes.upper()), x=columns(*axes), v=columns(*("v_" + c for c in axes)),
        F=columns(*("F_" + r + c for r in axes for c in axes)).reshape(-1, D, D),
        m=columns("m")[:, 0], V0=columns("V")[:, 0], h=case["h"], ppc=case["ppc"], dt=case["dt"], cfl=case["cfl"],
        law=case["material"], lam=case.get("lambda"), mu=case.get("mu"), wave_speed=case["wave_speed"],
        parameters=case["parameters"],
        lower=np.array(case["grid"]["lower"]), cells=case["grid"]["cells"],
        faces=[(boundary[c + "min"], boundary[c + "max"]) for c in axes])
    conforming = "conforming" in arguments and D == 2
    start.R0 = rows.domains(start) if conforming else start.V0[:, None, None] ** (1 / D) * np.eye(D)
    return start


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
             for name, value in further.items() if name not in OF_THE_START}
    name = case["problem"]
    body = Body(start, WALLS.get(name, {}), body_force_of(name, start), loads(name, start), case["basis"],
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
