"""The layers for PyTorch and JAX, where these are installed: gradients against differences, batches, and what they refuse by name."""

import subprocess
import sys
from typing import Any

import numpy as np
import pytest
from grasps import jar

from grasp_lcp import onsets

DOWN = [0.1, 0.2, -1.0]
NAMES = ("points", "normals", "direction", "base", "friction", "series_stiffness", "pressed_with", "command_world")


def made(rows: int = 4) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(7)
    grasps = [jar(rng) for _ in range(rows)]
    return {
        "points": 10 * np.array([points for points, _ in grasps]),
        "normals": np.array([normals for _, normals in grasps]) * rng.uniform(20, 50, (rows, 3, 1)),
        "direction": np.array(DOWN),
        "base": np.tile([0.05, -0.02, -0.1, 0.0, 0.001, 0.0], (rows, 1)),
        "friction": rng.uniform(0.4, 0.8, (rows, 3)),
        "series_stiffness": rng.uniform(5, 20, (rows, 3, 2)),
        "pressed_with": rng.uniform(5, 8, (rows, 3)),
        "command_world": rng.normal(0, 0.005, (rows, 3, 3)),
    }


def factors(data: dict[str, np.ndarray]) -> np.ndarray:
    """Those of the batch itself."""
    normals = data["normals"] / np.linalg.norm(data["normals"], axis=-1, keepdims=True)
    pressed = data["pressed_with"] / data["series_stiffness"][..., 0]
    told = data["command_world"] + normals * pressed[..., None]
    same = {name: data[name] for name in ("friction", "series_stiffness")}
    return onsets(data["points"], normals, data["direction"], data["base"], command_world=told, **same).factor


def test_nobody_imports_them_unasked() -> None:
    code = "import sys, grasp_lcp; print(sorted({'torch', 'jax'} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert done.stdout.strip() == "[]"


def test_torch_gradients_are_differences() -> None:
    torch = pytest.importorskip("torch")
    from grasp_lcp.torch import onset_factor

    data = made()

    def asked(*given: Any) -> Any:
        return onset_factor(*given[:4], **dict(zip(NAMES[4:], given[4:], strict=True)))

    tensors = [torch.tensor(data[name], requires_grad=True) for name in NAMES]
    assert np.allclose(asked(*tensors).detach().numpy(), factors(data), rtol=1e-12)
    assert torch.autograd.gradcheck(asked, tensors, eps=1e-6, atol=1e-6, rtol=1e-6)


def test_torch_all_directions_for_each_grasp_in_single_precision() -> None:
    torch = pytest.importorskip("torch")
    from grasp_lcp.torch import onset_factor

    data = {name: torch.tensor(value, dtype=torch.float32) for name, value in made().items()}
    points = data["points"][:, None].requires_grad_()
    pulls = torch.tensor([DOWN, [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]], dtype=torch.float32)
    found = onset_factor(points, data["normals"][:, None], pulls, friction=0.6, series_stiffness=10.0, pressed_with=6.0)
    assert found.shape == (4, 3) and found.dtype == torch.float32
    found.sum().backward()
    assert points.grad.shape == (4, 1, 3, 3) and points.grad.isfinite().all() and (points.grad != 0).any()


def test_torch_rows_without_a_factor_leave_others_alone() -> None:
    torch = pytest.importorskip("torch")
    from grasp_lcp.torch import onset_factor

    data = made()
    press = torch.tensor(data["pressed_with"], requires_grad=True)
    scale = torch.tensor([[1.0], [0.0], [1.0], [1.0]], dtype=torch.float64)
    points, normals = torch.tensor(data["points"]), torch.tensor(data["normals"])
    found = onset_factor(points, normals, DOWN, friction=0.6, series_stiffness=10.0, pressed_with=press * scale)
    known = found.isfinite()
    assert known.tolist() == [True, False, True, True]
    torch.where(known, found, torch.zeros_like(found)).sum().backward()
    assert press.grad.isfinite().all() and (press.grad[1] == 0).all() and (press.grad[0] != 0).any()


@pytest.mark.parametrize("native", [False, True])
def test_torch_a_normal_of_zero_length_spoils_no_other_row(native: bool) -> None:
    torch = pytest.importorskip("torch")
    from grasp_lcp.torch import onset_factor

    data = made()
    data["normals"][2, 1] = 0
    normals = torch.tensor(data["normals"], requires_grad=True)
    found, status = onset_factor(
        torch.tensor(data["points"]), normals, DOWN, friction=0.6, series_stiffness=10.0, pressed_with=6.0, native=native, with_status=True
    )  # fmt: skip
    assert status.tolist() == [0, 0, 8, 0]
    found.nansum().backward()
    assert normals.grad.isfinite().all() and (normals.grad[2] == 0).all() and (normals.grad[3] != 0).any()


def test_torch_refuses_second_derivatives_by_name() -> None:
    torch = pytest.importorskip("torch")
    from grasp_lcp.torch import onset_factor

    data = made()
    points = torch.tensor(data["points"], requires_grad=True)
    found = onset_factor(points, torch.tensor(data["normals"]), DOWN, friction=0.6, series_stiffness=10.0, pressed_with=6.0)
    (slope,) = torch.autograd.grad(found.sum(), points, create_graph=True)
    with pytest.raises(RuntimeError, match=r"grasp_lcp\.torch\.onset_factor has no second derivatives"):
        slope.sum().backward()


def test_torch_says_what_a_load_must_be() -> None:
    torch = pytest.importorskip("torch")
    from grasp_lcp.torch import onset_factor

    points = torch.zeros(3, 3)
    with pytest.raises(ValueError, match=r"direction or base: shape \(4,\) given"):
        onset_factor(points, points, [1.0, 0.0, 0.0, 0.0], friction=0.5, series_stiffness=10.0)


@pytest.mark.parametrize("native", [False, True])
def test_torch_takes_any_precision_of_points(native: bool) -> None:
    """Points that are integers leave the factor a fraction; a scalar load and an array of numpy are refused by name."""
    torch = pytest.importorskip("torch")
    from grasp_lcp.torch import onset_factor

    normals = torch.tensor([[1.0, 0.0], [-1.0, 0.0]])
    same = {"friction": 0.5, "series_stiffness": [1e3, 8e2], "pressed_with": 8.0, "native": native}
    points = torch.tensor([[-4, 0], [4, 1]])
    exact = onset_factor(points.double(), normals.double(), [0.1, -1.0], **same)
    for kind, error in ((torch.int64, 1e-5), (torch.float32, 1e-5), (torch.float16, 1e-3)):
        found = onset_factor(points.to(kind), normals, [0.1, -1.0], **same)
        assert found.dtype == (kind if kind.is_floating_point else torch.float32)
        assert abs(found.item() / exact.item() - 1) < error
    with pytest.raises(ValueError, match=r"direction or base: shape \(\) given"):
        onset_factor(points, normals, 1.0, **same)
    with pytest.raises(TypeError, match="points: ndarray given, must be a tensor"):
        onset_factor(points.numpy(), normals, [0.1, -1.0], **same)


def test_jax_gradients_are_differences() -> None:
    jax = pytest.importorskip("jax")
    from jax.test_util import check_grads

    from grasp_lcp.jax import onset_factor

    data = made()
    with jax.experimental.enable_x64() if not hasattr(jax, "enable_x64") else jax.enable_x64(True):

        def asked(*given: Any) -> Any:
            return onset_factor(*given[:4], **dict(zip(NAMES[4:], given[4:], strict=True)))

        given = [data[name] for name in NAMES]
        assert np.allclose(asked(*given), factors(data), rtol=1e-12)
        assert np.allclose(jax.jit(asked)(*given), factors(data), rtol=1e-12)
        check_grads(asked, given, order=1, modes=["fwd", "rev"], atol=1e-6, rtol=1e-6)


def test_jax_maps_and_differentiates_single_grasps() -> None:
    jax = pytest.importorskip("jax")
    from grasp_lcp.jax import onset_factor

    data = made()

    def one(points: Any, normals: Any) -> Any:
        return onset_factor(points, normals, DOWN, friction=0.6, series_stiffness=10.0, pressed_with=6.0)

    mapped = jax.jit(jax.vmap(jax.grad(one)))(data["points"], data["normals"])
    alone = [jax.grad(one)(points, normals) for points, normals in zip(data["points"], data["normals"], strict=True)]
    assert mapped.shape == (4, 3, 3) and np.allclose(mapped, np.array(alone), rtol=1e-5, atol=1e-6)


def test_jax_refuses_second_derivatives_by_name() -> None:
    jax = pytest.importorskip("jax")
    from grasp_lcp.jax import onset_factor

    data = made(1)

    def one(points: Any) -> Any:
        return onset_factor(points, data["normals"], DOWN, friction=0.6, series_stiffness=10.0, pressed_with=6.0).sum()

    with pytest.raises(NotImplementedError, match=r"grasp_lcp\.jax\.onset_factor has no second derivatives"):
        jax.hessian(one)(data["points"])
