"""The array program of `onset_factor` beside the crate: statuses, factors, derivatives of all orders, devices."""

import importlib.util
import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from grasp_lcp import OnsetStatus, onset_gradients, onsets
from grasp_lcp._arrays.program import Kind, among_rows, gradients
from grasp_lcp._arrays.program import onsets as array_program

REPORT = Path(__file__).parents[1] / "benches" / "accelerator.py"
EPSILON = float(np.finfo(float).eps)
NAMES = ("points", "normals", "friction", "series_stiffness", "command_world", "base", "direction")


@pytest.fixture(scope="module")
def report() -> ModuleType:
    spec = importlib.util.spec_from_file_location("accelerator", REPORT)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["accelerator"] = module
    spec.loader.exec_module(module)
    return module


def jars(report: ModuleType, axes: int, contacts: int, rows: int, kind: str = "sheared") -> dict[str, np.ndarray]:
    """Grasps whose contacts all stick at rest."""
    data = report.grasps(kind, axes, contacts, 4 * rows + 20, np.random.default_rng(8))
    leaves = onsets(**data).status == OnsetStatus.LEAVES
    return {name: each[leaves][:rows] for name, each in data.items()}


def in_double(jax: Any) -> Any:
    """A context in which JAX computes in double precision; older versions keep it elsewhere."""
    return jax.enable_x64(True) if hasattr(jax, "enable_x64") else jax.experimental.enable_x64()


def asked(onset_factor: Any, *data: Any, **others: Any) -> Any:
    points, normals, friction, stiffness, command, base, direction = data
    return onset_factor(
        points, normals, direction, base, friction=friction, series_stiffness=stiffness, command_world=command, native=True, **others
    )  # fmt: skip


@pytest.mark.parametrize(("axes", "contacts"), [(2, 2), (2, 3), (2, 5), (3, 2), (3, 3), (3, 4), (3, 5)])
def test_statuses_and_factors_are_those_of_the_crate(report: ModuleType, axes: int, contacts: int) -> None:
    for number, kind in enumerate(report.KINDS):
        found = report.compared(report.grasps(kind, axes, contacts, 300, np.random.default_rng([axes, contacts, number])))
        assert found.statuses == found.bits == 0, (kind, found)


@pytest.mark.parametrize(("axes", "contacts"), [(2, 2), (2, 3)])
def test_jax_compiles_to_the_bits_of_the_crate(report: ModuleType, axes: int, contacts: int) -> None:
    """No product is contracted with a sum. In double precision nothing else may differ."""
    pytest.importorskip("jax")
    answers = report.in_jax(axes, contacts)
    for number, kind in enumerate(report.KINDS):
        found = report.compared(report.grasps(kind, axes, contacts, 300, np.random.default_rng([axes, contacts, number])), answers)
        assert found.statuses == found.bits == 0, (kind, found)


@pytest.mark.parametrize(("axes", "contacts"), [(2, 2), (2, 3), (2, 5), (3, 2), (3, 3), (3, 4), (3, 5)])
def test_torch_has_the_bits_of_the_crate(report: ModuleType, axes: int, contacts: int) -> None:
    """Sums over contacts have the order of the crate, and square roots are rounded correctly."""
    pytest.importorskip("torch")
    answers = report.in_torch(axes, contacts)
    for number, kind in enumerate(report.KINDS):
        found = report.compared(report.grasps(kind, axes, contacts, 300, np.random.default_rng([axes, contacts, number])), answers)
        assert found.statuses == found.bits == 0, (kind, found)


@pytest.mark.parametrize("kind", ["loaded", "even", "infinite or no friction", "slim"])
@pytest.mark.parametrize(
    ("axes", "contacts", "stacked"), [(2, 2, False), (2, 3, True), (3, 2, False), (3, 3, False), (3, 3, True), (3, 5, False)]
)
def test_slopes_are_those_of_the_crate(report: ModuleType, axes: int, contacts: int, stacked: bool, kind: str) -> None:
    """Also at ties, where they are those of the first contact that leaves. About the line between two hard fingers the object turns freely."""
    is_pinch = (axes, contacts) == (3, 2)
    data = jars(report, axes, contacts, 200, "opposed" if is_pinch else kind)
    program = Kind(("unilateral",) * contacts, True, stacked)
    found = array_program(np, EPSILON, program, [each.copy() for each in data.values()], among_rows)
    slopes = dict(zip(NAMES, gradients(np, EPSILON, program, list(data.values()), found), strict=True))
    crate = onset_gradients(**data)
    assert len(crate.contact) > 20 and np.array_equal(found.contact, crate.contact)
    along = (data["command_world"] * data["normals"]).sum(axis=-1, keepdims=True)
    pressed = (crate.command_world * data["normals"]).sum(axis=-1, keepdims=True)
    for name in NAMES:
        if is_pinch and name in ("points", "normals", "base", "direction"):
            assert np.isnan(slopes[name]).all()
            continue
        expected = getattr(crate, name)
        if name == "normals":
            # There, commands tilt with the contact frame.
            expected = expected - (crate.command_world * along - data["command_world"] * pressed)
        size = np.abs(expected).reshape(len(expected), -1).max(axis=1)
        off = np.abs(slopes[name] - expected).reshape(len(expected), -1).max(axis=1)
        assert (off <= 1e-7 * size).all() and np.median(off) <= 1e-12 * np.median(size), name


def test_holds_and_many_points(report: ModuleType) -> None:
    """Contacts one after the other or as an axis, up to the sixteen points of a pad, against the method of single grasps."""
    for contacts, hold in (
        (4, ("bonded", "kept_closed", "unilateral", "unilateral")),
        (8, ("unilateral",) * 8),
        (16, ("unilateral",) * 16),
    ):
        data = report.grasps("jar", 3, contacts, 200, np.random.default_rng(3))
        expected = onsets(**data, hold=hold, complete=True)
        leaves = expected.status == OnsetStatus.LEAVES
        for stacked in (False, True):
            found = array_program(np, EPSILON, Kind(hold, False, stacked), [each.copy() for each in data.values()], among_rows)
            both = leaves & (found.status == OnsetStatus.LEAVES)
            # Where a contact slides at rest, the crate goes on from there.
            assert both.sum() > 20 and (leaves == both)[found.status != OnsetStatus.NOT_STICKING].all()
            assert np.allclose(found.factor[both], expected.factor[both], rtol=1e-10)
            assert np.array_equal(found.contact[both], expected.leaving[both].argmax(axis=1))


def test_a_pinch_is_never_held_against_rotation(report: ModuleType) -> None:
    """About the line between two hard fingers nothing resists: a load that turns the object about it always gives way, one through it may be held."""
    data = report.grasps("jar", 3, 2, 2000, np.random.default_rng(4))
    factor, status = report.in_numpy(data)
    sticks = status != OnsetStatus.NOT_STICKING
    assert sticks.sum() > 1500 and (status[sticks] == OnsetStatus.GIVES_WAY).all() and np.isnan(factor).all()
    # Forces at the midpoint, without a moment about it.
    middle = data["points"].mean(axis=1)
    data["direction"][:, 3:] = np.cross(middle, data["direction"][:, :3])
    factor, status = report.in_numpy(data)
    assert (status[sticks] == OnsetStatus.LEAVES).all() and np.isfinite(factor[sticks]).all()


def test_torch_has_derivatives_of_all_kinds(report: ModuleType) -> None:
    torch = pytest.importorskip("torch")
    from grasp_lcp.torch import onset_factor

    units = {"series_stiffness": 1e3, "command_world": 1e-3, "points": 1e-2}
    for axes, contacts in ((2, 3), (3, 3)):
        data = jars(report, axes, contacts, 2)
        scales = [units.get(name, 1.0) for name in NAMES]
        given = [torch.tensor(data[name] / scale, requires_grad=True) for name, scale in zip(NAMES, scales, strict=True)]

        def scaled(*given: Any, scales: list[float] = scales) -> Any:
            return asked(onset_factor, *(each * scale for each, scale in zip(given, scales, strict=True)))

        assert torch.autograd.gradcheck(scaled, given, check_forward_ad=True, fast_mode=True, atol=1e-5, rtol=1e-5)
        assert torch.autograd.gradgradcheck(scaled, given, fast_mode=True, atol=1e-4, rtol=1e-4)
        single = [each.detach()[0] for each in given]
        mapped = torch.func.vmap(lambda points, rest=single: scaled(points, *rest[1:]))(given[0].detach())
        assert torch.allclose(mapped[0], scaled(*single))
        bends = torch.func.hessian(lambda points, rest=single: scaled(points, *rest[1:]))(single[0])
        assert torch.allclose(bends, bends.movedim((2, 3), (0, 1)), rtol=1e-8) and (bends != 0).any()


def test_pads_in_torch(report: ModuleType) -> None:
    """Factors are those of the crate, and derivatives differences of them: a pad moves with its contact and turns with the tangents of its normal."""
    torch = pytest.importorskip("torch")
    from grasp_lcp.torch import onset_factor

    soft = {"disc": {"radius": 0.004, "annuli": 1, "points": 4}}
    data = report.grasps("jar", 3, 3, 40, np.random.default_rng(5))
    exact = onsets(**data, soft=soft)
    leaves = exact.status == OnsetStatus.LEAVES
    given = {name: torch.tensor(each) for name, each in data.items()}
    asked = [given[name].requires_grad_() for name in ("points", "normals", "series_stiffness")]
    factor, status = onset_factor(**given, soft=soft, with_status=True)
    assert leaves.sum() > 20 and np.array_equal(status.numpy(), exact.status)
    assert np.allclose(factor.detach().numpy()[leaves], exact.factor[leaves], rtol=1e-12)
    slopes = torch.autograd.grad(torch.where(factor.isfinite(), factor, torch.zeros_like(factor)).sum(), asked)
    for name, slope, step in zip(("points", "normals", "series_stiffness"), slopes, (1e-8, 1e-7, 1e-3), strict=True):
        change = np.random.default_rng(6).normal(size=data[name].shape)
        sides = [onsets(**data | {name: data[name] + side * step * change}, soft=soft).factor for side in (1, -1)]
        expected = (sides[0] - sides[1])[leaves] / (2 * step)
        found = (slope.numpy() * change).reshape(len(change), -1).sum(axis=1)[leaves]
        assert np.median(np.abs(found - expected)) < 1e-5 * np.abs(expected).max(), name
    with pytest.raises(ValueError, match="native: False given beside soft"):
        onset_factor(**given, soft=soft, native=False)


def test_torch_in_single_precision_with_status(report: ModuleType) -> None:
    torch = pytest.importorskip("torch")
    from grasp_lcp.torch import onset_factor

    data = report.grasps("jar", 3, 4, 2000, np.random.default_rng(2))
    data["points"][7, 2, 1], data["friction"][8] = np.nan, -1.0
    exact = onsets(**data)
    double, status = asked(onset_factor, *(torch.tensor(each) for each in data.values()), with_status=True)
    assert np.array_equal(status.numpy(), exact.status) and status[7] == OnsetStatus.NOT_A_NUMBER and status[8] == OnsetStatus.MALFORMED
    assert torch.equal(status, onset_factor(
        torch.tensor(data["points"]), torch.tensor(data["normals"]), data["direction"], friction=data["friction"], native=False,
        series_stiffness=data["series_stiffness"], command_world=data["command_world"], with_status=True)[1])  # fmt: skip
    given = [torch.tensor(each, dtype=torch.float32, requires_grad=True) for each in data.values()]
    single, status = asked(onset_factor, *given, with_status=True)
    both = (status == OnsetStatus.LEAVES) & torch.tensor(exact.status == OnsetStatus.LEAVES)
    off = (single.double() / double - 1).abs()[both]
    assert both.sum() > 1000 and off.median() < 1e-6 and off.max() < 0.1
    # Rows that single precision cannot answer are open, not wrong.
    wrong = (status < OnsetStatus.UNCLEAR) & (status != torch.tensor(exact.status))
    assert wrong.sum() == 0
    torch.where(single.isfinite(), single, 0.0).sum().backward()
    assert all(each.grad.isfinite().all() and (each.grad[status != OnsetStatus.LEAVES] == 0).all() for each in given)


@pytest.mark.parametrize("kind", ["slim", "malformed", "anywhere", "on the edge"])
def test_torch_derivatives_are_zero_in_rows_without_a_factor(report: ModuleType, kind: str) -> None:
    """First and second ones, and finite in all others; slim triangles are answered by another method among all the rest."""
    torch = pytest.importorskip("torch")
    from grasp_lcp.torch import onset_factor

    data = report.grasps(kind, 3, 3, 1000, np.random.default_rng(6))
    given = [torch.tensor(each, requires_grad=True) for each in data.values()]
    factor, status = asked(onset_factor, *given, with_status=True)
    expected, statuses = report.in_numpy(data)
    assert np.array_equal(status.numpy(), statuses) and np.allclose(factor.detach(), expected, rtol=1e-9, equal_nan=True)
    slopes = torch.autograd.grad(torch.where(factor.isfinite(), factor, 0.0).sum(), given, create_graph=True)
    bends = torch.autograd.grad(sum((each * each.detach()).sum() for each in slopes), given)
    for derivatives in (slopes, bends):
        assert all(each.isfinite().all() and (each[status != OnsetStatus.LEAVES] == 0).all() for each in derivatives)


def test_jax_has_derivatives_of_all_kinds(report: ModuleType) -> None:
    """Of a pair in the plane, for which everything is compiled in seconds."""
    jax = pytest.importorskip("jax")
    from grasp_lcp.jax import onset_factor

    data = jars(report, 2, 2, 3)
    points, rest = data["points"], list(data.values())[1:]
    rng, step = np.random.default_rng(3), 1e-6
    way = rng.normal(size=points.shape)

    def along(points: Any) -> Any:
        return jax.jvp(lambda points: asked(onset_factor, points, *rest), (points,), (way,))[1]

    def steepest(points: Any) -> Any:
        return jax.grad(lambda points: asked(onset_factor, points, *rest).sum())(points)

    with in_double(jax):
        mapped = jax.jit(jax.vmap(lambda *given: asked(onset_factor, *given)))(*data.values())
        assert np.allclose(mapped, onsets(**data).factor, rtol=1e-12)
        # First derivatives, forwards and backwards, against differences.
        sides = [onsets(**data | {"points": points + side * step * way}).factor for side in (1, -1)]
        expected = (sides[0] - sides[1]) / (2 * step)
        slope = jax.jit(steepest)
        assert np.allclose(jax.jit(along)(points), expected, rtol=1e-6)
        assert np.allclose((slope(points) * way).sum(axis=(1, 2)), expected, rtol=1e-6)
        # Second derivatives, backwards over backwards and forwards over backwards.
        bends = (slope(points + step * way) - slope(points - step * way)) / (2 * step)
        backwards = jax.jit(jax.grad(lambda points: (steepest(points) * way).sum()))(points)
        forwards = jax.jit(lambda points: jax.jvp(steepest, (points,), (way,))[1])(points)
        size = np.abs(bends).max()
        assert np.abs(backwards - bends).max() < 1e-5 * size and np.abs(forwards - bends).max() < 1e-5 * size


def test_jax_answers_and_slopes_in_space(report: ModuleType) -> None:
    jax = pytest.importorskip("jax")
    import jax.numpy as jnp

    from grasp_lcp.jax import onset_factor

    data = report.grasps("slim", 3, 3, 1000, np.random.default_rng(5))
    data["points"][3, 1, 1] = np.nan
    exact, slopes = onsets(**data), onset_gradients(**data)
    leaves = exact.status == OnsetStatus.LEAVES
    assert leaves.sum() > 50

    def total(*given: Any) -> Any:
        factor, status = asked(onset_factor, *given, with_status=True)
        return jnp.where(jnp.isfinite(factor), factor, 0.0).sum(), (factor, status)

    with in_double(jax):
        by, (factor, status) = jax.jit(jax.grad(total, argnums=(0, 4), has_aux=True))(*(jnp.asarray(each) for each in data.values()))
        assert np.array_equal(status, exact.status)
        assert np.allclose(factor[leaves], exact.factor[leaves], rtol=1e-8)
        for found, expected in zip(by, (slopes.points, slopes.command_world), strict=True):
            assert np.isfinite(found).all() and (np.asarray(found)[~leaves] == 0).all()
            size = np.abs(expected[leaves]).max(axis=(1, 2), keepdims=True)
            assert np.abs((found[leaves] - expected[leaves]) / size).max() < 1e-6


ON_DEVICES = """
import jax, numpy as np
import jax.numpy as jnp
from jax.sharding import Mesh, PartitionSpec
if hasattr(jax, "shard_map"):
    shard_map = jax.shard_map
else:
    from jax.experimental.shard_map import shard_map
from grasp_lcp import onsets
from grasp_lcp.jax import onset_factor
assert len(jax.devices()) == 4
jax.config.update("jax_enable_x64", True)
rng = np.random.default_rng(1)
height, friction = rng.uniform(-0.01, 0.01, (4000, 2)), rng.uniform(0.3, 0.9, (4000, 2))
points = np.stack(np.broadcast_arrays([-0.04, 0.04], height), axis=-1)
same = {"series_stiffness": [1e3, 8e2], "pressed_with": 8.0}
asked = lambda points, friction: onset_factor(points, [[1.0, 0.0], [-1.0, 0.0]], [0.1, -1.0], friction=friction, native=True, **same)
slope = lambda points, friction: jax.grad(lambda points: asked(points, friction).sum())(points)
mesh, rows = Mesh(np.array(jax.devices()), ("grasps",)), PartitionSpec("grasps")
for asks, name in ((asked, "factors"), (slope, "slopes")):
    spread = jax.jit(shard_map(asks, mesh=mesh, in_specs=(rows, rows), out_specs=rows))(points, friction)
    assert len(spread.sharding.device_set) == 4
    assert np.allclose(spread, jax.jit(asks)(points, friction), rtol=1e-12), name
exact = onsets(points, [[1.0, 0.0], [-1.0, 0.0]], [0.1, -1.0], friction=friction, **same).factor
assert np.allclose(jax.jit(asked)(points, friction), exact, rtol=1e-12)
print("same")
"""


def test_jax_spreads_rows_over_devices() -> None:
    pytest.importorskip("jax")
    environment = os.environ | {"XLA_FLAGS": "--xla_force_host_platform_device_count=4", "JAX_PLATFORMS": "cpu"}
    done = subprocess.run([sys.executable, "-c", ON_DEVICES], env=environment, capture_output=True, text=True)
    assert done.stdout == "same\n", done.stderr


def test_the_report_runs() -> None:
    done = subprocess.run([sys.executable, str(REPORT), "--quick", "--rows", "2000"], check=True, capture_output=True, text=True)
    all_of_them = next(line for line in done.stdout.splitlines() if line.startswith("  all: "))
    assert ", 0 statuses differ; " in all_of_them and all_of_them.endswith(" factors, 0 differ by more than 1e-12, 0 differ in some bit"), (
        done.stdout
    )


def test_the_example_climbs_and_certifies() -> None:
    pytest.importorskip("jax")
    example = REPORT.parents[1] / "examples" / "improve_on_accelerator.py"
    done = subprocess.run([sys.executable, str(example), "--quick"], check=True, capture_output=True, text=True)
    lines = done.stdout.splitlines()
    before, after = [float(line.split("hold ")[1].split(",")[1]) for line in lines[1:3]]
    assert after > 2 * before and lines[3].startswith("the best 100 that are certified hold "), done.stdout
