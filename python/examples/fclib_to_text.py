"""Frictional contact problems of FCLIB, from HDF5 to the text that ``friction::ReadProblem::from_siconos`` reads.

``python fclib_to_text.py PROBLEM.hdf5 PROBLEM.dat`` needs ``h5py`` and ``scipy``. A problem with bodies (``fclib_global``: M v = H r + f,
u = Hᵀ v + w) becomes one of its contacts: W = Hᵀ M⁻¹ H, q = Hᵀ M⁻¹ f + w.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass

import h5py
import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray
from scipy.sparse.linalg import splu

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Problem:
    """u = W r + q with Coulomb's law at each contact."""

    components: int
    matrix: Array
    vector: Array
    friction: Array

    def text(self) -> str:
        """The form that Siconos writes, W dense, down its columns."""
        size, contacts = len(self.vector), len(self.friction)
        rows = [f"{self.components}", f"{contacts}", "0", f"{size}", f"{size}", f"{size} {size}"]
        rows += [" ".join(map(repr, map(float, column))) for column in self.matrix.T]
        rows += [" ".join(map(repr, map(float, vector))) for vector in (self.vector, self.friction)]
        return "\n".join(rows) + "\n"


def matrix_of(group: h5py.Group) -> sp.csc_matrix:
    """A matrix as CSparse has it: triplets, compressed columns (nz = −1) or compressed rows (nz = −2)."""
    rows, columns, entries = (int(group[name][0]) for name in ("m", "n", "nz"))
    p, i, x = (group[name][...] for name in ("p", "i", "x"))
    if entries == -1:
        return sp.csc_matrix((x, i, p), (rows, columns))
    if entries == -2:
        return sp.csr_matrix((x, i, p), (rows, columns)).tocsc()
    return sp.coo_matrix((x[:entries], (i[:entries], p[:entries])), (rows, columns)).tocsc()


def read(path: str) -> Problem:
    """The problem in a file of FCLIB."""
    with h5py.File(path) as file:
        if "fclib_local" in file:
            group = file["fclib_local"]
            matrix, vector = matrix_of(group["W"]).toarray(), group["vectors/q"][...]
        elif "fclib_global" in file:
            group = file["fclib_global"]
            h, masses = matrix_of(group["H"]), splu(matrix_of(group["M"]))
            matrix = (h.T @ masses.solve(h.toarray())).astype(np.float64)
            vector = h.T @ masses.solve(group["vectors/f"][...]) + group["vectors/w"][...]
        else:
            raise SystemExit(f"{path}: no problem of FCLIB, must have fclib_local or fclib_global")
        return Problem(int(group["spacedim"][0]), matrix, vector, group["vectors/mu"][...])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        raise SystemExit("two files: the problem of FCLIB, and the text that is written")
    with open(sys.argv[2], "w") as text:
        text.write(read(sys.argv[1]).text())
