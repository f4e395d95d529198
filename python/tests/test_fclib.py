"""Files of FCLIB become text with the same problem: contacts by themselves, and with their bodies."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

h5py = pytest.importorskip("h5py")
sparse = pytest.importorskip("scipy.sparse")

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "examples"))

W = np.array([[2.0, 0.5, 0.0], [0.0, 3.0, 0.0], [0.25, 0.0, 4.0]])
Q = np.array([-1.0, 0.3, 0.1])


def write_matrix(group: object, name: str, matrix: object, nz: int) -> None:
    inside = group.create_group(name)
    rows, columns = matrix.shape
    for key, value in {"m": rows, "n": columns, "nz": nz, "nzmax": matrix.nnz}.items():
        inside[key] = [value]
    coordinates = (matrix.row, matrix.col) if nz >= 0 else (matrix.indices, matrix.indptr)
    inside["i"], inside["p"], inside["x"] = *coordinates, matrix.data


def numbers(path: Path) -> list[float]:
    from fclib_to_text import read

    return [float(word) for word in read(str(path)).text().split()]


EXPECTED = [3, 1, 0, 3, 3, 3, 3, *W.T.ravel(), *Q, 0.5]


@pytest.mark.parametrize("nz", [-1, -2, 0])
def test_contacts_by_themselves(tmp_path: Path, nz: int) -> None:
    matrix = {-1: sparse.csc_matrix, -2: sparse.csr_matrix, 0: sparse.coo_matrix}[nz](W)
    with h5py.File(tmp_path / "local.hdf5", "w") as file:
        group = file.create_group("fclib_local")
        write_matrix(group, "W", matrix, nz or matrix.nnz)
        group["spacedim"] = [3]
        group["vectors/q"], group["vectors/mu"] = Q, [0.5]
    assert numbers(tmp_path / "local.hdf5") == EXPECTED


def test_contacts_of_bodies(tmp_path: Path) -> None:
    """M and H such that Hᵀ M⁻¹ H = W, and f, w such that q = Hᵀ M⁻¹ f + w."""
    with h5py.File(tmp_path / "global.hdf5", "w") as file:
        group = file.create_group("fclib_global")
        write_matrix(group, "M", sparse.csc_matrix(np.linalg.inv(W)), -1)
        write_matrix(group, "H", sparse.csc_matrix(np.eye(3)), -1)
        group["spacedim"] = [3]
        group["vectors/f"], group["vectors/w"], group["vectors/mu"] = np.ones(3), Q - W @ np.ones(3), [0.5]
    assert np.allclose(numbers(tmp_path / "global.hdf5"), EXPECTED, atol=1e-14)
