"""Siconos' own solvers on one of its files: a line each of solver, its relative error, seconds.

``/usr/bin/python3 python/examples/siconos_times.py FILE`` needs Debian's ``python3-siconos``, which has no HDF5;
``fclib_to_text.py`` makes text of such files first. The report ``friction_problems`` prints these lines beside the crate's.
"""

from __future__ import annotations

import sys
import time

import numpy as np
import siconos.numerics as sn


def of_file(path: str) -> None:
    """Gauss–Seidel and Newton's method of Alart and Curnier, each asked for 1e-6 and for 1e-12."""
    problem = sn.frictionContactProblemFromFile(path)
    if problem.dimension != 3:
        return  # Its Python has no solvers for the plane.
    size = 3 * problem.numberOfContacts
    solvers = [
        ("NSGS", sn.fc3d_nsgs, sn.SICONOS_FRICTION_3D_NSGS, 20_000),
        ("NSN_AC", sn.fc3d_nonsmooth_Newton_AlartCurnier, sn.SICONOS_FRICTION_3D_NSN_AC, 200),
    ]
    for name, solve, identifier, most in solvers:
        for tolerance in (1e-6, 1e-12):
            r, u = np.zeros(size), np.zeros(size)
            options = sn.SolverOptions(identifier)
            options.dparam[sn.SICONOS_DPARAM_TOL] = tolerance
            options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = most
            begin = time.perf_counter()
            solve(problem, r, u, options)
            seconds = time.perf_counter() - begin
            print(f"{name}, asked for {tolerance:.0e};{options.dparam[sn.SICONOS_DPARAM_RESIDU]:.1e};{seconds:.6f}", flush=True)


if __name__ == "__main__":
    of_file(sys.argv[1])
