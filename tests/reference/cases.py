"""The cases in which the program and the reference are compared."""

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
square       6   2 0.2    10 bspline2 usl        fmpm:3  symmetry cfl-x=0.6
square       6   2 0.2    10 gimp     usavg+     fmpm:2  mirror cfl-x=0.8
swing        5   2 0.2    12 bspline2 usl        fmpm:4  - wall-method=velocity cfl-x=0.4
bar         11   2 0.2    12 linear   usl        flip    periodic body-force=grid
square       6   2 0.2     8 bspline2 rk4        flip    mirror body-force=grid
square       6   2 0.2    10 bspline3 usavg      xpic:2  symmetry body-force=grid
swing        5   2 0.2    12 gimp     usl        fmpm:2  - body-force=grid
ring         6   2 0.2     8 bspline2 usl        flip    free
ring         6   2 0.2     8 bspline3 rk4        flip    free
ring         6   2 0.2     8 bspline2 usl        apic    free
ring         6   2 0.2     8 cpdi     usavg      xpic:3  free
ring         6   2 0.2     8 gimp     usl        fmpm:2  free
ring         6   2 0.2     8 cpgimp   usf        flip    free
ring         5   2 0.2     8 bspline2 usl        flip    free fill=conforming param=poissons_ratio=0.3
ring         5   2 0.2     8 linear   usf        xpic:2  free fill=conforming param=poissons_ratio=0.3
ring         6   2 0.2     6 bspline3 rk4        flip    free fill=conforming param=poissons_ratio=0.3
ring         6   2 0.2     6 cpdi     usavg      flip    free fill=conforming param=poissons_ratio=0.3
shell        3   1 0.2     3 bspline2 usl        flip    free fill=conforming param=poissons_ratio=0.3
shell        3   1 0.2     3 linear   usf        fmpm:2  free
vortex       6   2 0.1     6 cpdi     usl        flip    free fill=conforming
pulse        1   2 0.2    60 linear   usl        flip    free
pulse        1   2 0.2    60 bspline2 usavg+     flip    free
pulse        1   2 0.2    60 gimp     cd         flip    free grid-offset=0.3
pulse        1   2 0.2    60 bspline3 rk4        flip    free param=stress=5e5
pulse        1   2 0.2    60 cpdi     usf        fmpm:2  free
pulse        1   2 0.2   140 bspline2 usl        xpic:2  free
vortex       6   2 0.1     8 bspline3 usl        flip    free deformation=exponential
vortex       6   2 0.1     8 cpdi     cd         flip    free
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
ring         6   2 0.2     8 bspline3-open usl   fmpm:2  free
stretch      2   2 0.2    20 bspline2-open usavg fmpm:3  - wall-gradient=estimated
stretch      2   2 0.2    20 bspline3-open usl   xpic:2  - wall-depth=2
cube         4   2 0.2     3 bspline2-open usl   flip    symmetry
cube         4   2 0.2     3 bspline3-open usavg fmpm:2  dirichlet
bar         11   2 0.2    12 linear   usl        flip    periodic mass=consistent
bar         11   2 0.2    12 bspline2 usf        fmpm    mirror mass=consistent
bar         11   2 0.2    12 bspline3-open usavg flip    symmetry mass=consistent
square       6   2 0.2     6 bspline2 usl        flip    symmetry mass=consistent position=second-order
square       6   2 0.2     6 gimp     usavg+     fmpm    dirichlet mass=consistent
square       6   2 0.2     6 bspline2 usl+ flip xmin=symmetry,xmax=mirror,ymin=free,ymax=dirichlet mass=consistent
square       6   2 0.2     4 bspline3 rk4        flip    symmetry mass=consistent
square       8   2 0.2     4 cpdi     cd         flip    symmetry mass=consistent
ring         6   2 0.2     6 bspline2 uvf        flip    free mass=consistent
swing        5   2 0.2     6 bspline2 usl        fmpm    - mass=consistent
stretch      2   2 0.2    10 linear   usavg      fmpm    - mass=consistent
pulse        1   2 0.2    20 linear   usl        fmpm    free mass=consistent
cube         4   2 0.2     2 bspline2 usl        fmpm    periodic mass=consistent
cube         4   2 0.2     2 linear   usf        flip    symmetry mass=consistent
impact       2   2 0.4    60 bspline2 usl        xpic:2  free
shock        4   2 0.2     5 linear   usl        flip    -
shock        4   2 0.2     5 bspline2 usf        xpic:2  -
shock        4   2 0.2     5 gimp     usavg+     fmpm:4  - wall-gradient=estimated wall-depth=1.5
wave         6   2 0.2    12 bspline2 uvf        flip    symmetry
wave         6   2 0.2    12 gimp     usl        fmpm:2  mirror material=neo-hookean-log
cube         4   2 0.2     3 bspline2 usl        flip    periodic
cube         5   1 0.2     3 cpdi     usl        fmpm:2  periodic
cube         4   1 0.2     3 bspline2 rk4        flip    periodic
cube         4   2 0.2     3 bspline3 cd         flip    periodic
cube         4   1 0.2     3 bspline2 usl        apic    periodic
cube         4   2 0.2     3 linear   usavg      flip    symmetry
cube         4   2 0.2     3 gimp     usf        xpic:2  mirror
cube         4   2 0.2     3 cpgimp   usl        pic     dirichlet
"""


def cases():
    """Each line of the table: its columns by their heads, and what else it sets."""
    head, *lines = CASES.strip().splitlines()
    names = head.split()[:-1]
    for line in lines:
        words = line.split()
        case = dict(zip(names, words))
        case["update"], _, case["order"] = case["update"].partition(":")
        yield line, case, dict(word.split("=", 1) for word in words[len(names):])
