"""What the program says of a case: the particles at its start and at its end, and its record."""
import csv
import json
import pathlib
import subprocess
import tempfile
import types
import xml.etree.ElementTree

import numpy as np

import rows


def arguments_of(case, further):
    """The command line's words for a case; a setting without a value is a word alone."""
    arguments = []
    for name, value in dict(case, **further).items():
        if name in further or name != "steps" and value not in ("", "-"):
            arguments += ["--" + ("velocity-update" if name == "update" else name), *value.split()]
    return arguments


def answer(program, *arguments):
    return subprocess.run([program, *arguments], check=True, stdout=subprocess.PIPE, text=True).stdout


def start_of(program, arguments):
    """The particles that a case starts with, its material, grid and time step."""
    with tempfile.TemporaryDirectory() as folder:
        particles = pathlib.Path(folder, "particles.csv")
        case = json.loads(answer(program, "particles", *arguments, "--json", "--csv", str(particles)))
        lines = list(csv.DictReader(particles.read_text().splitlines()))
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
    start.R0 = rows.domains(start) if "conforming" in arguments else start.V0[:, None, None] ** (1 / D) * np.eye(D)
    return start


def end_of(program, arguments, steps, D):
    """The whole body's particles after the last step: id, position, velocity, deformation gradient, and the time."""
    with tempfile.TemporaryDirectory() as folder:
        answer(program, "run", *arguments, "--steps", str(steps), "--vtu", folder)
        last = max(pathlib.Path(folder).glob("*.vtu"))
        arrays = {}
        for array in xml.etree.ElementTree.parse(last).iter("DataArray"):
            numbers = np.array(array.text.split(), float)
            arrays[array.get("Name")] = numbers.reshape(-1, int(array.get("NumberOfComponents", 1)))
    F = arrays["deformation_gradient"].reshape(-1, 3, 3)[:, :D, :D]
    return (arrays["id"][:, 0], arrays["position"][:, :D], arrays["velocity"][:, :D], F, arrays["TimeValue"][0, 0])


def record_of(program, arguments, steps):
    return json.loads(answer(program, "run", *arguments, "--steps", str(steps), "--json"))


def displacements(program, problem, parameters, X, t):
    """The solution's at the reference points X."""
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as points:
        np.savetxt(points, X, "%.17g", ",", header=",".join("XYZ"[:X.shape[1]]), comments="")
        points.flush()
        words = [word for name, value in parameters.items() for word in ("--param", f"{name}={value!r}")]
        text = answer(program, "solution", "--problem", problem, "--points", points.name, "--time", repr(t),
                      "--fields", "u", *words)
    return np.array([[float(row["u_" + c]) for c in "xyz"[:X.shape[1]]] for row in csv.DictReader(text.splitlines())])
