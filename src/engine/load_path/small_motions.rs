//! The point of a load path where a motion exceeds its limit of small motions, and the point from which on all contacts slide. A leg is a section of
//! the load program. A piece is a part of a leg on which all contacts keep their states.
//!
//! While contacts keep their states, rotations, slips and gaps are affine in the fraction of the leg that is done. Their largest value is then at an
//! end of the piece. While the load turns, each of them is a constant plus terms with the cosine and sine of the angle (a harmonic). The first point
//! beyond a limit is then a root of a trigonometric polynomial. On arcs directions of sliding turn, and the path is integrated in steps. These steps
//! are checked at their ends. If a motion is beyond its limit there, regula falsi finds the point within the piece or step.

use core::f64::consts::{FRAC_PI_2, PI};

use super::piecewise_follower::PiecewiseFollower;
use super::program_run::ProgramRun;
use super::stored_piece::StoredPiece;
use crate::contact::WEIGHTLESS;
use crate::equilibrium::{AnswerFor, CountedMotion, MotionData, TooFar, farthest};
use crate::grasp::{Engine, Hold};
use crate::numerics::tolerances::ROUNDED_SUM;
use crate::numerics::{FirstZero, Harmonic, Trigonometric, largest, numbered, regula_falsi};
use crate::search::SmallMotions;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The point of a load path where motions cease to be [small](crate::Settings::small_motions), a suction cup leaks, or the grasp buckles. Beyond it,
/// answers still assume the undeformed geometry and cups that keep their vacuum, and say little about the real object.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct EndOfSmallMotions {
    /// Index of the leg, from 0.
    pub leg: usize,
    /// Fraction of the leg that is done, from 0 to 1.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub fraction: f64,
    /// The motion that exceeds its limit beyond this fraction of the leg, the leak or the buckling.
    pub what: TooFar,
}

/// A fraction of the leg, and the rotation, slip or opening that exceeds its limit of small motions beyond it.
type Place = (f64, CountedMotion);

impl<'g> PiecewiseFollower<'g> {
    /// Updates the largest ratio of a rotation, slip or opening to its limit of small motions. Records the first point of the path where such a
    /// motion exceeds its limit. Must be called at the start and after each piece of the path.
    pub(super) fn record_motion_ratio(&mut self, run: &ProgramRun<'g>) {
        let (grasp, answer_for) = (self.segment.grasp, self.segment.answer_for);
        let offsets = self.segment.offsets(self.factor);
        let (slips, states) = (&self.segment.problem.slips, &self.node.states);
        let (forces, twist) = (&self.node.at.forces, &self.node.at.twist);
        let motions = grasp.counted_motions(
            &answer_for.small,
            &MotionData { offsets: &offsets, slips, states, forces, twist },
        );
        let here = farthest(&motions).copied();
        self.farthest = here.map_or(self.farthest, |motion| self.farthest.max(motion.over_the_limit()));
        if self.end_of_small_motions.is_some() {
            return;
        }
        let here = here.filter(|motion| motion.over_the_limit() > 1.0);
        let found = match self.behind.last() {
            None => here.map(|motion| (self.factor, motion)),
            Some(last) => {
                let turning = last.turns_too_far(grasp, &answer_for.small);
                turning.or_else(|| Some(last.first_too_far(grasp, answer_for, here?)))
            }
        };
        let leg = self.behind.last().map_or(run.program.leg, |last| last.leg);
        let (from, states) =
            self.behind.last().map_or((self.factor, states), |last| (last.from, &last.states));
        if let Some(cup) = grasp.leaking_cup(&|i| states[i].is_open()) {
            self.end_of_small_motions =
                Some(EndOfSmallMotions { leg, fraction: from, what: TooFar::Leaks { cup } });
            return;
        }
        let end = |(fraction, motion): Place| {
            Some(EndOfSmallMotions { leg, fraction, what: grasp.too_far(&motion) })
        };
        self.end_of_small_motions = found.and_then(end);
    }

    /// The place from which on, up to the place `until`, every contact slides that has friction and carries a force. A place is a leg (from 0) and
    /// the fraction of it that is done. The result is the beginning of a stored piece of the path. `None` if one of these contacts sticks just before
    /// `until`.
    pub(super) fn pieces_all_slide_from(&self, until: (usize, f64)) -> Option<(usize, f64)> {
        let mut since = None;
        for piece in self.behind.iter().rev() {
            if piece.to <= piece.from || (piece.leg, piece.from) >= until {
                continue;
            }
            if !piece.everything_slides(self.segment.grasp) {
                break;
            }
            since = Some((piece.leg, piece.from));
        }
        since
    }
}

impl<'g> StoredPiece<'g> {
    /// The first point of a piece of the path where a rotation, slip or opening exceeds its limit. `at_the_end` is the motion that exceeds its
    /// limit most at the end of the piece.
    fn first_too_far(&self, grasp: &'g Engine, answer_for: AnswerFor, at_the_end: CountedMotion) -> Place {
        // If forces and twist within a step cannot be computed because of rounding, the motion at the end of the step is taken.
        let farthest_at = |fraction: f64| {
            let Some((problem, found)) = self.found_at(grasp, answer_for, fraction) else {
                return at_the_end;
            };
            let motions = grasp.counted_motions(&answer_for.small, &MotionData::found(&problem, &found));
            farthest(&motions).copied().unwrap_or(at_the_end)
        };
        let excess = |motion: &CountedMotion| motion.over_the_limit() - 1.0;
        let start = farthest_at(self.from);
        if excess(&start) > 0.0 {
            return (self.from, start);
        }
        let bracket = [(self.from, -excess(&start)), (self.to, -excess(&at_the_end))];
        let mut which = at_the_end;
        // The root is sought where the largest motion is just at its limit. On an arc each trial repeats the integration step up to the trial
        // fraction. `which` is the motion that reaches its limit at the root.
        let place = regula_falsi(bracket, ROUNDED_SUM, &mut |trial| {
            let motion = farthest_at(trial);
            if excess(&motion) >= 0.0 {
                which = motion;
            }
            -excess(&motion)
        });
        (place.unwrap_or(self.to), which)
    }

    /// For a piece along which the load turns: the first point where a motion exceeds its limit. Each motion is a harmonic function of the angle,
    /// which its values at three angles determine. `None` if no motion exceeds its limit, or if the load does not turn along the piece.
    fn turns_too_far(&self, grasp: &'g Engine, small: &SmallMotions) -> Option<Place> {
        let turned = self.here.turned.as_ref()?;
        let at = |angle: f64| {
            let there = self.here.after(angle / turned.angle);
            let (offsets, slips) = (&self.problem.offsets, &self.problem.slips);
            let (forces, twist) = (&there.forces, &there.twist);
            let standing = MotionData { offsets, slips, states: &self.states, forces, twist };
            grasp.counted_motions(small, &standing)
        };
        let (begin, quarter, half) = (at(0.0), at(FRAC_PI_2), at(PI));
        let most = (self.to - self.from) * turned.angle;
        let mut first: Option<Place> = None;
        for (motion, (quarter, half)) in begin.iter().zip(quarter.iter().zip(&half)) {
            let component = |k: usize| {
                let constant = 0.5 * (motion.shift[k] + half.shift[k]);
                let cosine = 0.5 * (motion.shift[k] - half.shift[k]);
                Harmonic::new([constant, cosine, quarter.shift[k] - constant])
            };
            let square = |x: Harmonic<f64>| Trigonometric::square_of(&x);
            let of = |limit: f64| Harmonic::new([limit, 0.0, 0.0]);
            let margin = if motion.is_opening() {
                Trigonometric::linear(&of(motion.limit)).minus(&Trigonometric::linear(&component(0)))
            } else {
                let limit = square(of(motion.limit));
                (0..3).fold(limit, |margin, k| margin.minus(&square(component(k))))
            };
            if motion.limit.is_finite()
                && let Some(FirstZero::At(angle)) = margin.first_fall(most, 0.0, 0)
                && first.is_none_or(|(fraction, _)| self.from + angle / turned.angle < fraction)
            {
                first = Some((self.from + angle / turned.angle, *motion));
            }
        }
        first
    }

    /// Whether, on this piece of the path, some contact with friction carries a force, and all such contacts slide. A bonded contact that carries a
    /// force is taken as sticking. Links between bodies are left out.
    fn everything_slides(&self, grasp: &Engine) -> bool {
        let force = |i: usize| self.here.lines[i].force.norm().max(self.there.forces[i].norm());
        let largest = largest(&numbered(grasp.len(), &force), &|force| *force);
        let mut any = false;
        for i in 0..grasp.len() {
            let (contact, site) = (&grasp.contacts()[i], &grasp.sites()[i]);
            let is_bonded = site.hold == Hold::Bonded;
            let has_friction = contact.link.is_none() && (is_bonded || !site.friction.is_frictionless());
            if has_friction && force(i) > WEIGHTLESS * largest {
                if !self.states[i].slides() {
                    return false;
                }
                any = true;
            }
        }
        any
    }
}
