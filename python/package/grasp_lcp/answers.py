"""Answers to what is asked of a grasp. They are read from the native side when an attribute is first asked for."""

from __future__ import annotations

import html
import json
import math
from collections.abc import Mapping
from functools import cached_property
from typing import Any, TypeVar

from ._grasp_lcp import Told, words_of, words_of_number
from ._views import Array, Tree, View, array, label_of, load_of, motion_of, number, optional_number, rows
from .equilibrium import Equilibrium

AnswerT = TypeVar("AnswerT", bound="Answer")


class Proof(View):
    """Why no equilibrium exists, and how that is known."""

    @property
    def kind(self) -> str:
        """``"free_motion"``, ``"separating_motion"``, ``"every_state_tried"`` or ``"every_case_contradicted"``."""
        return str(self._tree["proof"])

    @cached_property
    def motion(self) -> Array | None:
        """Unit motion of the object that nothing resists, m and rad, shape (d,); None where states or cases were tried."""
        found = self._tree.get("motion")
        return None if found is None else motion_of(found)

    @property
    def work(self) -> float | None:
        """Work of the load on that motion, positive, J."""
        return optional_number(self._tree.get("work"))

    def __repr__(self) -> str:
        return f"<Proof: {words_of_proof(self._tree)}>"


def words_of_proof(tree: Tree) -> str:
    """A proof as the crate tells it."""
    axes = len(tree["motion"]["translation"]) if "motion" in tree else 2
    return words_of("proof", json.dumps(tree), axes)


class Leaving(View):
    """A contact that stops sticking at an onset, or changes on a path."""

    @property
    def contact(self) -> int:
        """Its place among the contacts of the grasp, from 0."""
        return int(self._tree["contact"])

    @property
    def label(self) -> str:
        """Its name, or what it is and its number."""
        label = label_of(self._tree, "contact")
        return f"{label}, point {self._tree['point']}" if "point" in self._tree else label

    @property
    def how(self) -> str:
        """``"slides"`` or ``"opens"``; on a path also ``"sticks"``, ``"reverses"``, ``"turns"``, ``"closes"``, ``"closes_sliding"``."""
        return str(self._tree["how"] if "how" in self._tree else self._tree["what"])

    @cached_property
    def direction(self) -> Array | None:
        """Unit direction in which the finger slips over the body, coordinate axes, shape (c,); None unless it slides."""
        found = self._tree.get("direction")
        return None if found is None else array(found)

    def __repr__(self) -> str:
        return f"<{self.label} {self.how.replace('_', ' ')}>"


class Beyond(View):
    """What comes just beyond an onset or the end of a path."""

    @property
    def what(self) -> str:
        """``"continues"``, ``"limit_load"``, ``"snap"``, ``"ends"`` or ``"undecided"``."""
        return str(self._tree["what"])

    @property
    def states(self) -> tuple[str, ...]:
        """What every contact does next, if it continues."""
        return tuple(str(tree["state"]) for tree in self._tree.get("states", ()))

    @cached_property
    def force_rates(self) -> Array | None:
        """Rates of the contact forces per unit of the factor, contact frames, N, shape (n, c); None unless it continues."""
        found = self._tree.get("force_rates")
        return None if found is None else rows(found, len(found[0]))

    @cached_property
    def twist_rate(self) -> Array | None:
        """Rate of the object's motion per unit of the factor, m and rad, shape (d,); None unless it continues."""
        found = self._tree.get("twist_rate")
        return None if found is None else motion_of(found)

    def __repr__(self) -> str:
        return f"<Beyond: {self.what.replace('_', ' ')}>"


class Answer(View):
    """An answer of a grasp. Its outcome comes first; what the outcome does not have is None."""

    def __init__(self, told: Told | str | Tree) -> None:
        # One attribute on the way of every call; the tree is made when it is read.
        self._told = told

    @cached_property
    def _tree(self) -> Tree:
        told = self._told
        if isinstance(told, dict):
            return told
        tree: Tree = json.loads(self.to_json())
        return tree

    def to_json(self) -> str:
        """In JSON, in the format of scenes; numbers come back to the bit."""
        told = self._told
        if isinstance(told, str):
            return told
        return told.json() if isinstance(told, Told) else json.dumps(told)

    @property
    def outcome(self) -> str:
        """How it ended, in the words of the scene format."""
        told = self._told
        return told.outcome if isinstance(told, Told) else str(self._tree["outcome"])

    @cached_property
    def state(self) -> Equilibrium | None:
        """The equilibrium that the answer speaks of, if there is one."""
        found = self._tree.get("state")
        return None if found is None else Equilibrium(found)

    @cached_property
    def proof(self) -> Proof | None:
        """Why there is no equilibrium, where there is none."""
        found = self._tree if "proof" in self._tree else self._tree.get("reason")
        return None if found is None else Proof(found)

    @property
    def doubt(self) -> str | None:
        """Why nothing could be said, of what is undecided."""
        found = self._tree.get("doubt")
        return None if found is None else str(found)

    def _why(self) -> str:
        words = self.outcome.replace("_", " ")
        if self.proof is not None:
            return f"{words}: {words_of_proof(self.proof._tree)}"
        return words if self.doubt is None else f"{words}: {self.doubt.replace('_', ' ')}"

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self._why()}>"

    def _repr_svg_(self) -> str | None:
        """The grasp with its forces, for notebooks; None where there is no equilibrium, or the answer was read from JSON."""
        return self._told.svg(self._title()) if isinstance(self._told, Told) else None

    def _repr_html_(self) -> str | None:
        """A spatial grasp as a page to turn, for notebooks."""
        page = self._told.page(self._title()) if isinstance(self._told, Told) else None
        if page is None:
            return None
        return f'<iframe srcdoc="{html.escape(page)}" width="100%" height="620" style="border:0"></iframe>'

    def _title(self) -> str:
        return self.outcome.replace("_", " ").capitalize()


class Sentence(Answer):
    """An answer that is a sentence when it is printed."""

    @property
    def says(self) -> str:
        """The answer in a sentence."""
        return str(self._tree["says"])

    def __str__(self) -> str:
        return self.says

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.says}>"


class Verdict(Sentence):
    """The answer to "does it hold?", in print a sentence: ``"sticks"``, ``"slides"``, ``"loose"``, ``"lost"``, ``"no_rest"``, ``"undecided"``."""

    @property
    def outcome(self) -> str:
        """How it ended, in the words of the scene format."""
        return str(self._tree["holding"])

    @property
    def holds(self) -> bool | None:
        """Whether all of the load is held; None where that is not known."""
        return None if self.outcome == "undecided" else self.outcome in ("sticks", "slides")

    @property
    def first_slip(self) -> float | None:
        """How many times the load is on when the first contact stops sticking; None if none does as far as it was followed."""
        found = self._tree.get("first_slip")
        return None if found is None else number(found["factor"])

    @property
    def lost(self) -> float | None:
        """How many times the load is on when it is lost, or its motions cease to be small; None if it is not as far as it was followed."""
        found = self._tree.get("lost")
        return None if found is None else number(found["factor"])

    @property
    def everything_slides(self) -> float | None:
        """How many times the load is on from where every contact with friction that presses slides; None where one sticks."""
        found = self._tree.get("everything_slides")
        return None if found is None else number(found)

    @property
    def left_out(self) -> float | None:
        """The part of what resists the motion that the squeeze takes (below 0) or adds as it turns with the object, left out by small motions; None up
        to a tenth."""
        found = self._tree.get("left_out")
        return None if found is None else number(found)


class Shaken(Sentence):
    """What becomes of a load that repeats: ``"rests"``, ``"dies_out"``, ``"alternates"``, ``"walks"``, ``"lost"``, ``"no_rest"`` or
    ``"undecided"``; printed, it is a sentence."""

    @property
    def outcome(self) -> str:
        """How it ended, in the words of the scene format."""
        return str(self._tree["repeats"])

    @property
    def rests(self) -> bool | None:
        """Whether the grasp comes to rest; None where that is not known."""
        return None if self.outcome == "undecided" else self.outcome in ("rests", "dies_out")

    @property
    def stays(self) -> bool | None:
        """Whether the object stays, contacts sliding to and fro under it or not; None where that is not known."""
        return True if self.outcome == "alternates" else self.rests

    @property
    def cycles(self) -> int:
        """How many cycles have passed until then."""
        return int(self._tree["cycles"])

    @property
    def every(self) -> int:
        """After how many cycles everything repeats: one, but where friction is lower once contacts slide."""
        return int(self._tree.get("every", 1))


class Shakedown(Sentence):
    """Whether a grasp comes to rest under loads that repeat in any order: ``"rests"``, ``"never_rests"``, ``"may_rest"`` where the order
    decides, or ``"undecided"``; printed, it is a sentence."""

    @property
    def outcome(self) -> str:
        """How it ended, in the words of the stream."""
        words = {True: "rests", False: "never_rests", None: "may_rest"}
        return "undecided" if self.factor is None else words[self.rests]

    @property
    def rests(self) -> bool | None:
        """Whether it comes to rest in any order; None where the order decides, or nothing is known."""
        return self._tree.get("rests")

    @property
    def factor(self) -> float | None:
        """Up to so many times the loads slips could keep everything from sliding; None where that is not known."""
        found = self._tree.get("factor")
        return None if found is None else number(found)

    @property
    def slips_change_normal_forces(self) -> bool | None:
        """Where slips do, the factor bounds what comes to rest; where they do not, it decides. None where that is not known."""
        return self._tree.get("slips_change_normal_forces")


class Needed(Sentence):
    """How much of a quantity it takes: ``"bound"``, ``"any"``, ``"none"`` or ``"undecided"``; printed, it is a sentence."""

    @property
    def outcome(self) -> str:
        """How it ended, in the words of the scene format."""
        return str(next(iter(self._tree["amount"])))

    @property
    def amount(self) -> float | None:
        """The amount that does: a multiple of the squeeze or load given, a coefficient, m or rad; None unless there is a bound."""
        found = self._tree["amount"].get("bound")
        return None if found is None else number(found["does"])

    @property
    def until(self) -> float | None:
        """Where amounts from there on do no longer, as with a squeeze beyond the limit of a motor; None if they do as far as was looked."""
        found = (self._tree["amount"].get("bound") or {}).get("until")
        return None if found is None else number(found["does"])

    @property
    def safe(self) -> float | None:
        """The same where friction and squeeze are less than said."""
        found = (self._tree.get("safe") or {}).get("bound")
        return None if found is None else number(found["does"])

    @property
    def presses(self) -> tuple[float, ...]:
        """Of a squeeze: what each contact presses with at rest, N."""
        found = self._tree["amount"].get("bound") or {}
        return tuple(number(press["force"]) for press in found.get("presses", ()))


class Estimate(View):
    """One number that slips tell, with its error."""

    @property
    def name(self) -> str:
        """What it is."""
        return str(self._tree["name"])

    @property
    def value(self) -> float:
        """A coefficient of friction, N, or a multiple of what was given; where it is not fixed one of many."""
        return number(self._tree["value"])

    @property
    def is_fixed(self) -> bool:
        """Whether the slips fix it."""
        return bool(self._tree["is_fixed"])

    @property
    def standard_error(self) -> float | None:
        """Its standard error; None where it is not fixed, or the scatter of slips is not known."""
        return optional_number(self._tree.get("standard_error"))

    @property
    def interval(self) -> tuple[float, float] | None:
        """What holds the truth in 95 of 100 cases."""
        found = self._tree.get("interval")
        return None if found is None else (number(found[0]), number(found[1]))

    @property
    def degrees_of_freedom(self) -> float | None:
        """Those of Student's distribution that the interval is from; None where it is normal, or there is none."""
        return optional_number(self._tree.get("degrees_of_freedom"))

    def __repr__(self) -> str:
        error = "" if self.standard_error is None else f" ± {self.standard_error:.2g}"
        return f"<Estimate: {self.name} {self.value:.6g}{error}>" if self.is_fixed else f"<Estimate: {self.name} not fixed>"


class Identified(Answer):
    """What slips that were seen tell: ``"converged"``, ``"not_converged"`` or ``"not_predicted"``; printed, it is a sentence."""

    @property
    def outcome(self) -> str:
        """How the search ended, in the words of the scene format."""
        return str(self._tree["ending"])

    @property
    def says(self) -> str:
        """The answer in a sentence."""
        return str(self._tree["says"])

    @cached_property
    def estimates(self) -> tuple[Estimate, ...]:
        """The numbers, in the order in which they were asked for."""
        return tuple(Estimate(tree) for tree in self._tree["estimates"])

    @property
    def groups(self) -> int | None:
        """How many groups of slips may share errors, where they were told."""
        found = self._tree.get("groups")
        return None if found is None else int(found)

    @property
    def scatter(self) -> float | None:
        """The scatter of loads or angles as a part of them, where it was estimated."""
        return optional_number(self._tree.get("scatter"))

    @property
    def misfit(self) -> float | None:
        """Where the scatter was given: how many times as far off the slips are."""
        return optional_number(self._tree.get("misfit"))

    @property
    def not_fixed(self) -> tuple[str, ...]:
        """What the slips do not fix, a sentence each."""
        return tuple(str(tree["says"]) for tree in self._tree.get("free", ()))

    @cached_property
    def residuals(self) -> Array:
        """Logarithm of what was seen over what is predicted, shape (k,)."""
        return array(self._tree["residuals"])

    @cached_property
    def weights(self) -> Array:
        """What each slip counts, shape (k,): less than 1 where it is far off."""
        return array(self._tree["weights"])

    def __str__(self) -> str:
        return self.says

    def __repr__(self) -> str:
        return f"<Identified: {self.says}>"


class Improved(Answer):
    """Where the fingers should be, and how hard they should press; printed, it is a sentence.

    How the search ended is ``"optimum"`` where multipliers prove that to first order nothing nearby is better, or ``"stalled"``,
    ``"out_of_steps"``, ``"unbalanced"``, ``"nothing_slides"``, ``"no_start"``.
    """

    @property
    def outcome(self) -> str:
        """How the search ended, in the words of the scene format."""
        return str(self._tree["search"])

    @property
    def says(self) -> str:
        """The answer in a sentence."""
        return str(self._tree["says"])

    @property
    def goal(self) -> str:
        """What ``before`` and ``after`` are: ``"first_slip"``, as a multiple of the loads, or ``"reserve"``, the friction that is left, N."""
        return str(self._tree["goal"])

    @property
    def before(self) -> float | None:
        """Of the grasp given; None where something slides at rest, or for a reserve under the loads."""
        return optional_number(self._tree.get("before"))

    @property
    def after(self) -> float | None:
        """Of the best grasp; None where none was found that sticks, ``inf`` where nothing slides."""
        return optional_number(self._tree.get("after"))

    @property
    def is_locally_best(self) -> bool:
        """Whether it is proved that to first order no other place and squeeze nearby is better."""
        return self.outcome == "optimum"

    @property
    def residual(self) -> float | None:
        """What the multipliers leave of zero, as a part of the first slip, or of the greatest force; None where there are none."""
        return optional_number(self._tree.get("residual"))

    def _placed(self, name: str) -> Array:
        return array([placed[name] for placed in self._tree["contacts"]])

    @property
    def points(self) -> Array:
        """Where contacts are, m, shape (n, c)."""
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
        """What stands in the way of more, each a ``contact``, ``what`` it is and its multiplier."""
        return tuple(self._tree["in_the_way"])

    def __str__(self) -> str:
        return self.says

    def __repr__(self) -> str:
        return f"<Improved: {self.says}>"


class Solution(Answer):
    """The answer to "does it hold under this load?": ``"equilibrium"``, ``"no_equilibrium"`` (with its proof) or ``"undecided"``."""

    @cached_property
    def equilibrium(self) -> Equilibrium | None:
        """The equilibrium, or None."""
        return Equilibrium(self._tree) if self.outcome == "equilibrium" else None

    @cached_property
    def state(self) -> Equilibrium | None:
        """The same as :attr:`equilibrium`."""
        return self.equilibrium

    def __repr__(self) -> str:
        if self.equilibrium is None:
            return super().__repr__()
        return repr(self.equilibrium).replace("<Equilibrium", "<Solution: equilibrium", 1)


class _First(Answer):
    """When something stops sticking, as a load grows or turns."""

    @cached_property
    def load(self) -> Array | None:
        """The load there, N and N m, shape (d,)."""
        return load_of(self._tree["load"]) if self.outcome == "at" else None

    @cached_property
    def leaving(self) -> tuple[Leaving, ...]:
        """Which contacts leave, all at once; empty unless something does."""
        return tuple(Leaving(tree) for tree in self._tree.get("leaving", ()))

    @property
    def drives(self) -> tuple[str, ...]:
        """Which joints and tendons of a hand give way there, and how, in words."""
        return tuple(_drive(tree) for tree in self._tree.get("drives", ()))

    @cached_property
    def beyond(self) -> Beyond | None:
        """What comes next; None unless something leaves."""
        found = self._tree.get("beyond")
        return None if found is None else Beyond(found)

    _kind = "onset"

    def _who(self) -> str:
        return self._words(self._kind, len(self._tree["load"]["force"]))


class Onset(_First):
    """The onset of sliding as a load grows.

    The outcome is ``"at"`` (a factor), ``"never"``, ``"already_sliding"`` (at factor 0), ``"no_base"`` (no equilibrium at factor 0),
    ``"gives_way"`` (nothing leaves, and nothing resists from a factor on) or ``"undecided"``.
    """

    @property
    def factor(self) -> float | None:
        """The factor up to which everything sticks, no unit: that of the event, or from which on nothing resists; ``inf`` for never.
        None for all other outcomes: look at :attr:`outcome` first."""
        told = self._told
        if isinstance(told, Told):
            return told.factor
        return float("inf") if self.outcome == "never" else optional_number(self._tree.get("factor"))

    def __repr__(self) -> str:
        if self.outcome == "at":
            return f"<Onset at factor {words_of_number(self.factor or 0.0)}: {self._who()}>"
        return super().__repr__()

    def _title(self) -> str:
        return f"Onset of sliding, factor {self.factor:.6g}" if self.outcome == "at" else super()._title()


class TurnOnset(_First):
    """The onset of sliding while a load turns; outcomes as of :class:`Onset`, with an angle for the factor."""

    _kind = "onset_of_turn"

    @property
    def angle(self) -> float | None:
        """How far the load has turned, rad; of what gives way the angle up to which it holds. None for all other outcomes, never included:
        of what lies beyond the last angle nothing is known."""
        told = self._told
        if isinstance(told, Told):
            return told.factor if told.outcome != "never" else None
        return optional_number(self._tree.get("angle_rad"))

    @property
    def touches(self) -> tuple[Tree, ...]:
        """Where edges are touched and not crossed: who, and the angle, rad."""
        return tuple(self._tree["touches"])

    def __repr__(self) -> str:
        if self.outcome == "at":
            return f"<TurnOnset at {self._degrees()}: {self._who()}>"
        return super().__repr__()

    def _title(self) -> str:
        return f"Onset of sliding, turned by {self._degrees()}" if self.outcome == "at" else super()._title()

    def _degrees(self) -> str:
        return f"{words_of_number(math.degrees(self.angle or 0.0))}°"


class Event(View):
    """Something changes on a load path."""

    @property
    def leg(self) -> int:
        """The leg, from 0."""
        return int(self._tree["leg"])

    @property
    def fraction(self) -> float:
        """How much of the leg has been gone, from 0 to 1."""
        return number(self._tree["fraction"])

    @cached_property
    def load(self) -> Array:
        """The load there, N and N m, shape (d,)."""
        return load_of(self._tree["load"])

    @cached_property
    def changes(self) -> tuple[Leaving, ...]:
        """What changes, contact by contact."""
        return tuple(Leaving(tree) for tree in self._tree["changes"])

    @property
    def drives(self) -> tuple[str, ...]:
        """Which joints and tendons of a hand change what they do, in words."""
        return tuple(_drive(tree) for tree in self._tree.get("drives", ()))

    @cached_property
    def state(self) -> Equilibrium:
        """The equilibrium there; its states are those before the event."""
        return Equilibrium(self._tree["state"])

    def __repr__(self) -> str:
        return f"<Event on {self._words('event', len(self._tree['load']['force']))}>"


class Path(Answer):
    """A load program followed to its end: ``"completed"``, ``"lost"`` (the equilibrium ends), ``"no_start"`` or ``"undecided"``."""

    @cached_property
    def events(self) -> tuple[Event, ...]:
        """What happened on the way, in order."""
        return tuple(Event(tree) for tree in self._tree["events"])

    @cached_property
    def energies(self) -> tuple[Mapping[str, float], ...]:
        """Of every leg, J: load_work, finger_work, stored, dissipated; and the relative residual of their balance."""
        return tuple({name: number(value) for name, value in tree.items()} for tree in self._tree["energies"])

    @property
    def step_error(self) -> float:
        """Sum of the estimated relative errors of the steps along sliding arcs; 0 where every piece is straight."""
        return number(self._tree["step_error"])

    @property
    def kind(self) -> str | None:
        """Of a lost path what ends it: ``"fold"``, ``"corner"``, ``"asymptote"``, ``"gives_way"`` or ``"lets_go"``."""
        found = self._tree.get("kind")
        return None if found is None else str(found)

    @property
    def leg(self) -> int | None:
        """The leg on which a path ends early, from 0."""
        found = self._tree.get("leg")
        return None if found is None else int(found)

    @property
    def fraction(self) -> float | None:
        """How much of that leg it has gone, from 0 to 1."""
        return optional_number(self._tree.get("fraction"))

    @cached_property
    def load(self) -> Array | None:
        """The load at which a lost path ends, N and N m, shape (d,)."""
        found = self._tree.get("load")
        return None if found is None else load_of(found)

    @cached_property
    def beyond(self) -> Beyond | None:
        """Whether another equilibrium exists just beyond the end of a lost path."""
        found = self._tree.get("beyond")
        return None if found is None else Beyond(found)

    def __repr__(self) -> str:
        head = f"<Path {self.outcome.replace('_', ' ')}"
        if self.outcome == "lost" and self.load is not None and self.beyond is not None:
            load = words_of("load", json.dumps(self._tree["load"]), len(self._tree["load"]["force"]))
            head += f" at {load}: {self.kind}, beyond: {self.beyond.what.replace('_', ' ')}"
        told = [f"  {event!r}" for event in self.events]
        return "\n".join([head, *told]) + ">"


def _drive(tree: Mapping[str, Any]) -> str:
    kind = "joint" if "joint" in tree else "tendon"
    return f"{label_of(tree, kind)} {tree['what']}"
