"""Answers to questions about a grasp. Data are read from the native module when an attribute is first used."""

from __future__ import annotations

import html
import json
import math
from collections.abc import Mapping
from functools import cached_property
from typing import Any, Literal, TypeVar, cast

from . import _grasp_lcp
from ._grasp_lcp import LazyAnswer, words_of, words_of_number
from ._views import Array, Tree, View, array, axes_of, label_of, load_of, motion_of, number, optional_number, rows
from .equilibrium import Equilibrium

AnswerT = TypeVar("AnswerT", bound="Answer")


class Proof(View):
    """The proof that no equilibrium exists."""

    @property
    def kind(self) -> str:
        """Kind of proof: ``"free_motion"``, ``"separating_motion"``, ``"every_state_tried"`` or ``"every_case_contradicted"``."""
        return str(self._tree["proof"])

    @cached_property
    def motion(self) -> Array | None:
        """Unit motion of the object that no contact resists, m and rad, shape (d,); None if the proof is not by a motion."""
        found = self._tree.get("motion")
        return None if found is None else motion_of(found)

    @property
    def work(self) -> float | None:
        """Work of the load on the unit motion, positive, J; None without a motion."""
        return optional_number(self._tree.get("work"))

    def __repr__(self) -> str:
        return f"<Proof: {words_of_proof(self._tree)}>"


def words_of_proof(tree: Tree) -> str:
    """The sentence that the crate prints for a proof."""
    axes = len(tree["motion"]["translation"]) if "motion" in tree else 2
    return words_of("proof", json.dumps(tree), axes)


class Leaving(View):
    """A contact that stops sticking at an onset, or changes its state on a path."""

    @property
    def contact(self) -> int:
        """Index among the contacts of the grasp, from 0."""
        return int(self._tree["contact"])

    @property
    def label(self) -> str:
        """Name of the contact, or "contact" and its index."""
        label = label_of(self._tree, "contact")
        return f"{label}, point {self._tree['point']}" if "point" in self._tree else label

    @property
    def how(self) -> Literal["slides", "opens", "sticks", "reverses", "turns", "closes", "closes_sliding"]:
        """Change of the contact: ``"slides"`` or ``"opens"``. On a path also ``"sticks"``, ``"reverses"``, ``"turns"``, ``"closes"`` or
        ``"closes_sliding"``."""
        word: Literal["slides", "opens", "sticks", "reverses", "turns", "closes", "closes_sliding"]
        word = self._tree["how"] if "how" in self._tree else self._tree["what"]
        return word

    @cached_property
    def direction(self) -> Array | None:
        """Unit direction in which the finger slips over the body, coordinate axes, shape (c,); None unless it slides."""
        found = self._tree.get("direction")
        return None if found is None else array(found)

    def __repr__(self) -> str:
        return f"<{self.label} {self.how.replace('_', ' ')}>"


class Beyond(View):
    """Behaviour just beyond an onset or the end of a path."""

    @property
    def what(self) -> str:
        """Outcome: ``"continues"``, ``"limit_load"``, ``"snap"``, ``"ends"`` or ``"undecided"``."""
        return str(self._tree["what"])

    @property
    def states(self) -> tuple[str, ...]:
        """State of every contact just beyond, if the equilibrium continues; otherwise empty."""
        return tuple(str(tree["state"]) for tree in self._tree.get("states", ()))

    @cached_property
    def force_rates(self) -> Array | None:
        """Rates of the contact forces per unit of the factor, contact frames, N, shape (n, c); None unless the equilibrium continues."""
        found = self._tree.get("force_rates")
        return None if found is None else rows(found, len(found[0]))

    @cached_property
    def twist_rate(self) -> Array | None:
        """Rate of the object's motion per unit of the factor, m and rad, shape (d,); None unless the equilibrium continues."""
        found = self._tree.get("twist_rate")
        return None if found is None else motion_of(found)

    def __repr__(self) -> str:
        return f"<Beyond: {self.what.replace('_', ' ')}>"


class Answer(View):
    """An answer of a grasp. Read :attr:`outcome` first: quantities that do not belong to an outcome are None."""

    def __init__(self, told: LazyAnswer | str | Tree, grasp: _grasp_lcp.Grasp | None = None) -> None:
        # The tree of data is parsed when it is first read. The grasp is needed for pictures only.
        self._told = told
        self._grasp = grasp

    @cached_property
    def _tree(self) -> Tree:
        told = self._told
        if isinstance(told, dict):
            return told
        tree: Tree = json.loads(self.to_json())
        return tree

    def to_json(self) -> str:
        """The answer as JSON text in the format of scenes. Reading it back gives the same bits of every number."""
        told = self._told
        if isinstance(told, str):
            return told
        return told.json() if isinstance(told, LazyAnswer) else json.dumps(told)

    @property
    def outcome(self) -> str:
        """Outcome, as a word of the scene format."""
        told = self._told
        return told.outcome if isinstance(told, LazyAnswer) else str(self._tree["outcome"])

    @cached_property
    def state(self) -> Equilibrium | None:
        """The equilibrium of the answer; None without one."""
        found = self._tree.get("state")
        return None if found is None else Equilibrium(found)

    @cached_property
    def proof(self) -> Proof | None:
        """The proof that no equilibrium exists; None without a proof."""
        found = self._tree if "proof" in self._tree else self._tree.get("reason")
        return None if found is None else Proof(found)

    @property
    def doubt(self) -> str | None:
        """The reason why the question is undecided; None for other outcomes."""
        found = self._tree.get("doubt")
        return None if found is None else str(found)

    # The name of the question in the scene format; empty if the answer's data contain the sentence.
    _kind = ""

    @property
    def says(self) -> str:
        """The answer in a sentence: the first line that the program prints. For an onset it states the load factor instead of the load."""
        tree = self._tree
        return str(tree["says"]) if "says" in tree else words_of("answer", json.dumps({self._kind: tree}), axes_of(tree) or 2)

    def __str__(self) -> str:
        return self.says

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.says}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return (_restored, (type(self), self.to_json(), None if self._grasp is None else self._grasp.json()))

    def _drawn(self, page: bool) -> str | None:
        told, title = self._told, self._title()
        if isinstance(told, LazyAnswer):
            return told.page(title) if page else told.svg(title)
        if self._grasp is None:
            return None
        return self._grasp.drawn(None if self.state is None else self.state.to_json(), title, page)

    def _repr_svg_(self) -> str | None:
        """Picture of the grasp with its forces, for notebooks; at rest if the answer has no equilibrium. None if the answer was read from JSON."""
        return self._drawn(False)

    def _repr_html_(self) -> str | None:
        """A page with a spatial grasp that can be rotated, for notebooks."""
        page = self._drawn(True)
        if page is None:
            return None
        return f'<iframe srcdoc="{html.escape(page)}" width="100%" height="620" style="border:0"></iframe>'

    def _title(self) -> str:
        return self.outcome.replace("_", " ").capitalize()


def _restored(kind: type[AnswerT], text: str, grasp: str | None) -> AnswerT:
    return kind(text, None if grasp is None else _grasp_lcp.Grasp.of_json(grasp))


class Sentence(Answer):
    """An answer whose sentence is the title of its picture."""

    def _title(self) -> str:
        return self.says.partition("\n")[0].partition(". ")[0]


class Verdict(Sentence):
    """The answer to "does it hold?": ``"sticks"``, ``"slides"``, ``"turns_over"``, ``"loose"``, ``"lost"``, ``"no_rest"``, ``"lost_at_rest"``
    or ``"undecided"``. It prints as a sentence."""

    @property
    def outcome(self) -> Literal["sticks", "slides", "turns_over", "loose", "lost", "no_rest", "lost_at_rest", "undecided"]:
        """Outcome, in a word of the scene format."""
        word: Literal["sticks", "slides", "turns_over", "loose", "lost", "no_rest", "lost_at_rest", "undecided"] = self._tree["holding"]
        return word

    @property
    def holds(self) -> bool | None:
        """Whether the grasp holds the whole load; None if undecided, or if :attr:`left_out` is -1 or less, so that the grasp may buckle."""
        if self.outcome in ("sticks", "slides"):
            return None if (self.left_out or 0.0) <= -1.0 else True
        return None if self.outcome == "undecided" else False

    def __bool__(self) -> bool:
        """As :attr:`holds`, and False if undecided, for ``if grasp.hold(load):``."""
        return self.holds is True

    @property
    def first_slip(self) -> float | None:
        """Multiple of the load at which the first contact stops sticking; None if no contact does so up to where the load was followed.

        It is None also where contacts slide from the beginning, or close and slide at once: the outcome is then not ``"sticks"``.
        """
        found = self._tree.get("first_slip")
        return None if found is None else number(found["factor"])

    @property
    def lost(self) -> float | None:
        """Multiple of the load at which equilibrium is lost or motions cease to be small; None if neither happens while the load is followed."""
        found = self._tree.get("lost")
        return None if found is None else number(found["factor"])

    @property
    def everything_slides(self) -> float | None:
        """Multiple of the load from which every pressing contact with friction slides, up to the whole load or to the end of the verdict.

        None if one of these contacts sticks.
        """
        found = self._tree.get("everything_slides")
        return None if found is None else number(found)

    @property
    def small_motions(self) -> bool:
        """Whether motions stay small up to the whole load or its loss, within ``small_motions`` of the settings.

        If not, :attr:`lost` is where they cease to be small: 0.1 rad, or a tenth of the size of the grasp, by default.
        """
        found = {} if self.holds else self._tree.get("lost") or self._tree.get("at_rest") or {}
        return "too_far" not in found and "too_far" not in (self._tree.get("state") or {})

    @property
    def left_out(self) -> float | None:
        """Geometric stiffness that the theory of small motions neglects, relative to the stiffness of the springs along the motion.

        The points at which forces at rest act turn with the object, which reduces its resistance (negative) or increases it. None if the change is
        at most a tenth, and for several bodies.
        """
        found = self._tree.get("left_out")
        return None if found is None else number(found)

    @property
    def swing(self) -> Array | None:
        """Motion of the object from rest to where it hangs under the load, m and rad, shape (d,); None unless it swings. Forces there are not
        computed, so that ``holds`` is False."""
        found = self._tree.get("swing")
        return None if found is None else motion_of(found.get("object", found))


class Shaken(Sentence):
    """Long-term behaviour under a load that repeats: ``"rests"``, ``"dies_out"``, ``"alternates"``, ``"walks"``, ``"lost"``, ``"no_rest"`` or
    ``"undecided"``. It prints as a sentence."""

    @property
    def outcome(self) -> Literal["rests", "dies_out", "alternates", "walks", "lost", "no_rest", "undecided"]:
        """Outcome, in a word of the scene format."""
        word: Literal["rests", "dies_out", "alternates", "walks", "lost", "no_rest", "undecided"] = self._tree["repeats"]
        return word

    @property
    def rests(self) -> bool | None:
        """Whether slipping ceases, after finitely many cycles or in the limit, and no suction cup leaks; None if undecided."""
        if self.leaks:
            return False
        return None if self.outcome == "undecided" else self.outcome in ("rests", "dies_out")

    @property
    def stays(self) -> bool | None:
        """Whether the object stays: slipping ceases, or it moves to and fro without net motion, and no suction cup leaks; None if undecided."""
        return True if self.outcome == "alternates" and not self.leaks else self.rests

    @property
    def opens(self) -> list[str]:
        """Names of the contacts that open and close again in every period."""
        return [part["label"] for part in self._tree.get("opens", [])]

    @property
    def leaks(self) -> list[str]:
        """Names of the suction cups of which a point of the lip is open in some cycle, so that air flows in."""
        return [part["label"] for part in self._tree.get("leaks", [])]

    @property
    def jumps(self) -> bool:
        """Whether the object jumps in a cycle until a contact catches it. Its momentum is not counted."""
        return bool(self._tree.get("jumps", False))

    @property
    def cycles(self) -> int:
        """Number of cycles until the outcome is reached."""
        return int(self._tree["cycles"])

    @property
    def every(self) -> int:
        """Period in cycles. It is one, unless kinetic friction is less than static friction."""
        return int(self._tree.get("every", 1))


class Shakedown(Sentence):
    """Whether slipping ceases under loads that repeat in any order: ``"rests"``, ``"never_rests"``, ``"may_rest"`` (the order decides) or
    ``"undecided"``. It prints as a sentence."""

    @property
    def outcome(self) -> str:
        """Outcome, in a word of the stream format."""
        words = {True: "rests", False: "never_rests", None: "may_rest"}
        return "undecided" if self.factor is None else words[self.rests]

    @property
    def rests(self) -> bool | None:
        """Whether slipping ceases whatever the order of the loads; None if this depends on the order, or if the question is undecided."""
        return self._tree.get("rests")

    @property
    def factor(self) -> float | None:
        """The largest multiple of the loads at which some slips keep all contacts from sliding; ``inf`` without a limit, None if undecided."""
        found = self._tree.get("factor")
        return None if found is None else number(found)

    @property
    def slips_change_normal_forces(self) -> bool | None:
        """Whether slips change normal forces; None if undecided. If they do, the factor is only an upper bound: slipping may go on below it."""
        return self._tree.get("slips_change_normal_forces")


class Comparison(Sentence):
    """Comparison of the equilibrium with the minimum of energy of the paper's quadratic program. It prints as a sentence."""

    @property
    def outcome(self) -> Literal["agree", "two_equilibria", "out_of_equilibrium", "no_equilibrium", "unknown", "no_minimum", "unsolved"]:
        """``"agree"``, ``"two_equilibria"``, ``"out_of_equilibrium"``, ``"no_equilibrium"``, ``"unknown"``, ``"no_minimum"`` or ``"unsolved"``."""
        verdict = self._tree["verdict"]
        name = verdict if isinstance(verdict, str) else next(iter(verdict))
        return cast("Literal['agree', 'two_equilibria', 'out_of_equilibrium', 'no_equilibrium', 'unknown', 'no_minimum', 'unsolved']", name)

    @property
    def agrees_up_to(self) -> float | None:
        """Multiple of the load up to which the minimum is the equilibrium: ``inf`` without a limit, None if they differ at rest or if unknown."""
        found = self._tree.get("agrees_up_to")
        return None if found is None else number(found)


class Needed(Sentence):
    """The amount of a quantity that a grasp needs: ``"bound"``, ``"any"``, ``"none"`` or ``"undecided"``. It prints as a sentence."""

    @property
    def outcome(self) -> Literal["bound", "any", "none", "undecided"]:
        """Outcome, in a word of the scene format."""
        word: Literal["bound", "any", "none", "undecided"] = next(iter(self._tree["amount"]))
        return word

    @property
    def amount(self) -> float | None:
        """The amount that suffices: a multiple of the given squeeze or load, a friction coefficient, m or rad. None unless the outcome is a bound."""
        found = self._tree["amount"].get("bound")
        return None if found is None else number(found["sufficient"])

    @property
    def until(self) -> float | None:
        """The largest amount that suffices, if larger ones fail, such as a squeeze beyond the limit of a motor; None if none was found to fail."""
        found = (self._tree["amount"].get("bound") or {}).get("until")
        return None if found is None else number(found["sufficient"])

    @property
    def sticks(self) -> float | None:
        """The amount with which nothing slides; None unless there is such an amount with a bound."""
        found = (self._tree.get("sticks") or {}).get("bound")
        return None if found is None else number(found["sufficient"])

    @property
    def safe(self) -> float | None:
        """The amount that suffices with reduced friction and squeeze, or with larger loads; None unless that outcome is a bound."""
        found = (self._tree.get("safe") or {}).get("bound")
        return None if found is None else number(found["sufficient"])

    @property
    def jumps(self) -> bool:
        """Whether the object jumps with this amount while the load is put on, until a contact catches it. Its momentum is not counted."""
        return bool(self._tree.get("jumps", False))

    @property
    def presses(self) -> tuple[float, ...]:
        """Normal force of each contact at rest under the squeeze found, N; empty for other quantities."""
        found = self._tree["amount"].get("bound") or {}
        return tuple(number(press["force"]) for press in found.get("presses", ()))


class Estimate(View):
    """One quantity that was estimated from slips, with its standard error."""

    @property
    def name(self) -> str:
        """Name of the quantity."""
        return str(self._tree["name"])

    @property
    def value(self) -> float:
        """A friction coefficient, a force in N, or a multiple of the given value. If the slips do not determine it, one of many possible values."""
        return number(self._tree["value"])

    @property
    def is_fixed(self) -> bool:
        """Whether the slips determine the quantity."""
        return bool(self._tree["is_fixed"])

    @property
    def standard_error(self) -> float | None:
        """Standard error; None if the slips do not determine the quantity, or if their scatter is unknown."""
        return optional_number(self._tree.get("standard_error"))

    @property
    def interval(self) -> tuple[float, float] | None:
        """95 % confidence interval; None without a standard error."""
        found = self._tree.get("interval")
        return None if found is None else (number(found[0]), number(found[1]))

    @property
    def degrees_of_freedom(self) -> float | None:
        """Degrees of freedom of Student's distribution behind the interval; None for a normal distribution or without an interval."""
        return optional_number(self._tree.get("degrees_of_freedom"))

    def __repr__(self) -> str:
        error = "" if self.standard_error is None else f" ± {self.standard_error:.2g}"
        return f"<Estimate: {self.name} {self.value:.6g}{error}>" if self.is_fixed else f"<Estimate: {self.name} not fixed>"


class Identified(Answer):
    """Quantities identified from observed slips: ``"converged"``, ``"not_converged"`` or ``"not_predicted"``. It prints as a sentence."""

    @property
    def outcome(self) -> Literal["converged", "not_converged", "not_predicted"]:
        """Ending of the search, in a word of the scene format."""
        word: Literal["converged", "not_converged", "not_predicted"] = self._tree["ending"]
        return word

    @cached_property
    def estimates(self) -> tuple[Estimate, ...]:
        """The estimates, in the order of the unknowns."""
        return tuple(Estimate(tree) for tree in self._tree["estimates"])

    @cached_property
    def assignments(self) -> tuple[tuple[Estimate, ...], ...]:
        """The estimates for each assignment of slips to contacts that fits equally well, the best first; empty if there is only one.

        The contact that slips first depends on the quantities. A quantity on which the assignments disagree is not determined.
        """
        return tuple(tuple(Estimate(tree) for tree in each) for each in self._tree.get("assignments", ()))

    @property
    def groups(self) -> int | None:
        """Number of groups of slips that may share errors; None if no groups were given."""
        found = self._tree.get("groups")
        return None if found is None else int(found)

    @property
    def scatter(self) -> float | None:
        """Estimated relative scatter of loads or angles; None if it was given."""
        return optional_number(self._tree.get("scatter"))

    @property
    def misfit(self) -> float | None:
        """Ratio of observed to given scatter; None if scatter was estimated. If it is far above one, the model or the given scatter is wrong."""
        return optional_number(self._tree.get("misfit"))

    @property
    def not_fixed(self) -> tuple[str, ...]:
        """Combinations of unknowns that the slips do not determine, one sentence each."""
        return tuple(str(tree["says"]) for tree in self._tree.get("free", ()))

    @cached_property
    def residuals(self) -> Array:
        """Logarithms of the ratio of observed to predicted load or angle, shape (k,)."""
        return array(self._tree["residuals"])

    @cached_property
    def weights(self) -> Array:
        """Huber weights of the slips, shape (k,): less than 1 for an outlier."""
        return array(self._tree["weights"])


class Improved(Answer):
    """Improved places and squeezes of the fingers. It prints as a sentence.

    The search ends with ``"optimum"`` if Lagrange multipliers prove that to first order no grasp nearby is better; otherwise with ``"stalled"``,
    ``"out_of_steps"``, ``"unbalanced"``, ``"nothing_slides"`` or ``"no_start"``.
    """

    @property
    def outcome(self) -> Literal["optimum", "stalled", "out_of_steps", "unbalanced", "nothing_slides", "no_start"]:
        """Ending of the search, in a word of the scene format."""
        word: Literal["optimum", "stalled", "out_of_steps", "unbalanced", "nothing_slides", "no_start"] = self._tree["search"]
        return word

    @property
    def goal(self) -> str:
        """The quantity in ``before`` and ``after``: ``"first_slip"``, a multiple of the loads, or ``"reserve"``, the friction reserve, N."""
        return str(self._tree["goal"])

    @property
    def before(self) -> float | None:
        """Value for the given grasp. None if a contact slides at rest or none presses, and for a reserve if a contact slides under the loads."""
        return optional_number(self._tree.get("before"))

    @property
    def after(self) -> float | None:
        """Value for the best grasp. None if every grasp that was tried slides at rest, ``inf`` if no contact slides at any load."""
        return optional_number(self._tree.get("after"))

    @property
    def is_locally_best(self) -> bool:
        """Whether Lagrange multipliers prove that to first order no places and squeezes nearby are better."""
        return self.outcome == "optimum"

    @property
    def residual(self) -> float | None:
        """Residual of first-order optimality, relative to the first slip or to the greatest force at rest; None without multipliers."""
        return optional_number(self._tree.get("residual"))

    @property
    def at_their_limit(self) -> list[str]:
        """Names of the contacts that use all their friction at rest. With a little less, or rounded places, the grasp is lost before any load."""
        return [part["label"] for part in self._tree.get("at_their_limit", [])]

    def _placed(self, name: str) -> Array:
        return array([placed[name] for placed in self._tree["contacts"]])

    @property
    def points(self) -> Array:
        """Contact points, m, shape (n, c)."""
        return self._placed("point")

    @property
    def normals(self) -> Array:
        """Unit normals into the object, shape (n, c)."""
        return self._placed("normal")

    @property
    def tangents(self) -> Array:
        """Unit first tangents, shape (n, c)."""
        return self._placed("tangent")

    @property
    def commands(self) -> Array:
        """Commands in the contact frames, m, shape (n, c)."""
        return self._placed("command")

    @property
    def normal_forces(self) -> Array:
        """Normal forces at rest, N, shape (n,)."""
        return self._placed("normal_force")

    @property
    def in_the_way(self) -> tuple[Mapping[str, Any], ...]:
        """Active constraints, events and bounds, that prevent a larger value: each has a ``contact``, its kind as ``what``, and its multiplier."""
        return tuple(self._tree["in_the_way"])


class Solution(Answer):
    """The answer to "does it hold under this load?": ``"equilibrium"``, ``"no_equilibrium"`` (with its proof) or ``"undecided"``."""

    @property
    def outcome(self) -> Literal["equilibrium", "no_equilibrium", "undecided"]:
        """Outcome, in a word of the scene format."""
        return cast("Literal['equilibrium', 'no_equilibrium', 'undecided']", super().outcome)

    @cached_property
    def equilibrium(self) -> Equilibrium | None:
        """The equilibrium; None for other outcomes."""
        if self.outcome != "equilibrium":
            return None
        told = self._told
        return Equilibrium(told) if isinstance(told, LazyAnswer) and "_tree" not in self.__dict__ else Equilibrium(self._tree)

    @cached_property
    def state(self) -> Equilibrium | None:
        """The same as :attr:`equilibrium`."""
        return self.equilibrium

    _kind = "solve"


class _First(Answer):
    """The onset of sliding as a load grows or turns."""

    @cached_property
    def load(self) -> Array | None:
        """The load at the onset, N and N m, shape (d,); None unless the outcome is ``"at"``."""
        return load_of(self._tree["load"]) if self.outcome == "at" else None

    @cached_property
    def leaving(self) -> tuple[Leaving, ...]:
        """All contacts that stop sticking at the onset; empty for outcomes other than ``"at"``."""
        return tuple(Leaving(tree) for tree in self._tree.get("leaving", ()))

    @property
    def drives(self) -> tuple[str, ...]:
        """Joints and tendons of a hand whose drives change state at the onset, one text each."""
        return tuple(_drive(tree) for tree in self._tree.get("drives", ()))

    @cached_property
    def beyond(self) -> Beyond | None:
        """Behaviour just beyond the onset; None unless the outcome is ``"at"``."""
        found = self._tree.get("beyond")
        return None if found is None else Beyond(found)

    _kind = "onset"


class Onset(_First):
    """The onset of sliding as a load grows.

    The outcome is ``"at"`` (a factor), ``"never"``, ``"already_sliding"`` (at factor 0), ``"no_base"`` (no equilibrium at factor 0),
    ``"gives_way"`` (no contact stops sticking, but beyond a factor no contact resists the load) or ``"undecided"``.
    """

    @property
    def outcome(self) -> Literal["at", "never", "already_sliding", "no_base", "gives_way", "undecided"]:
        """Outcome, in a word of the scene format."""
        return cast("Literal['at', 'never', 'already_sliding', 'no_base', 'gives_way', 'undecided']", super().outcome)

    @property
    def factor(self) -> float | None:
        """The factor up to which every contact sticks: that of the onset, or that at which the object gives way; ``inf`` for ``"never"``. None for
        all other outcomes: read :attr:`outcome` first."""
        told = self._told
        if isinstance(told, LazyAnswer):
            return told.factor
        return float("inf") if self.outcome == "never" else optional_number(self._tree.get("factor"))

    def _title(self) -> str:
        return f"Onset of sliding, factor {self.factor:.6g}" if self.outcome == "at" else super()._title()


class TurnOnset(_First):
    """The onset of sliding while a load turns. The outcomes are as for :class:`Onset`, with an angle in place of the factor."""

    @property
    def outcome(self) -> Literal["at", "never", "already_sliding", "no_base", "gives_way", "undecided"]:
        """Outcome, in a word of the scene format."""
        return cast("Literal['at', 'never', 'already_sliding', 'no_base', 'gives_way', 'undecided']", super().outcome)

    _kind = "onset_of_turn"

    @property
    def angle(self) -> float | None:
        """Angle by which the load has turned at the onset, rad; for ``"gives_way"`` the angle up to which the grasp holds. None for all other
        outcomes, also for ``"never"``, since angles beyond the turn are not considered."""
        told = self._told
        if isinstance(told, LazyAnswer):
            return told.factor if told.outcome != "never" else None
        return optional_number(self._tree.get("angle_rad"))

    @property
    def touches(self) -> tuple[Tree, ...]:
        """Contacts and drives that reach the edge of their cone or their limit without exceeding it, each with the angle, rad."""
        return tuple(self._tree["touches"])

    def _title(self) -> str:
        degrees = words_of_number(math.degrees(self.angle or 0.0))
        return f"Onset of sliding, turned by {degrees}°" if self.outcome == "at" else super()._title()


class Event(View):
    """A place on a load path at which contacts or drives change their state."""

    @property
    def leg(self) -> int:
        """Index of the leg, from 0."""
        return int(self._tree["leg"])

    @property
    def fraction(self) -> float:
        """Fraction of the leg at the event, from 0 to 1."""
        return number(self._tree["fraction"])

    @cached_property
    def load(self) -> Array:
        """The load at the event, N and N m, shape (d,)."""
        return load_of(self._tree["load"])

    @cached_property
    def changes(self) -> tuple[Leaving, ...]:
        """Changes of contacts at the event."""
        return tuple(Leaving(tree) for tree in self._tree["changes"])

    @property
    def drives(self) -> tuple[str, ...]:
        """Joints and tendons of a hand whose drives change state, one text each."""
        return tuple(_drive(tree) for tree in self._tree.get("drives", ()))

    @cached_property
    def state(self) -> Equilibrium:
        """The equilibrium at the event, with the contact states before the event."""
        return Equilibrium(self._tree["state"])

    def __repr__(self) -> str:
        return f"<Event on {self._words('event', len(self._tree['load']['force']))}>"


class Path(Answer):
    """A load program followed to its end: ``"completed"``, ``"lost"`` (the equilibrium ends), ``"no_start"`` or ``"undecided"``."""

    @property
    def outcome(self) -> Literal["completed", "lost", "no_start", "undecided"]:
        """Outcome, in a word of the scene format."""
        return cast("Literal['completed', 'lost', 'no_start', 'undecided']", super().outcome)

    @cached_property
    def events(self) -> tuple[Event, ...]:
        """All events, in the order of the path; empty for a path in steps."""
        return tuple(Event(tree) for tree in self._tree["events"])

    @cached_property
    def steps(self) -> tuple[Mapping[str, Any], ...]:
        """Steps of a path in steps: leg, fraction, load, number of contacts sliding and open, and estimated error of the forces."""
        return tuple(self._tree.get("steps", ()))

    @cached_property
    def energies(self) -> tuple[Mapping[str, float], ...]:
        """Energies of every leg, J: load_work, finger_work, stored, dissipated; and the relative residual of their balance."""
        return tuple({name: number(value) for name, value in tree.items()} for tree in self._tree["energies"])

    @property
    def step_error(self) -> float:
        """Sum of the estimated relative errors of the steps along sliding arcs, 0 if every piece is straight; for a path in steps, its error."""
        return number(self._tree["step_error"])

    @property
    def kind(self) -> str | None:
        """The kind of loss of equilibrium: ``"fold"``, ``"corner"``, ``"asymptote"``, ``"gives_way"`` or ``"lets_go"``; None for other outcomes."""
        found = self._tree.get("kind")
        return None if found is None else str(found)

    @property
    def leg(self) -> int | None:
        """Index of the leg on which a path ends early, from 0; None if it does not."""
        found = self._tree.get("leg")
        return None if found is None else int(found)

    @property
    def fraction(self) -> float | None:
        """Fraction of that leg at the end of the path, from 0 to 1."""
        return optional_number(self._tree.get("fraction"))

    @cached_property
    def load(self) -> Array | None:
        """The load at which a lost path ends, N and N m, shape (d,); None for other outcomes."""
        found = self._tree.get("load")
        return None if found is None else load_of(found)

    @cached_property
    def beyond(self) -> Beyond | None:
        """Whether another equilibrium exists just beyond the end of a lost path."""
        found = self._tree.get("beyond")
        return None if found is None else Beyond(found)

    _kind = "follow"

    def __repr__(self) -> str:
        return "\n".join([f"<Path: {self.says}", *(f"  {event!r}" for event in self.events)]) + ">"


def _drive(tree: Mapping[str, Any]) -> str:
    kind = "joint" if "joint" in tree else "tendon"
    return f"{label_of(tree, kind)} {tree['what']}"
