//! Follows a growing load while contacts stick or slide, with the slips of the sliding contacts as unknowns of the equations. The question `hold`
//! (does the grasp hold a load?) uses this method if every contact has Coulomb friction. The grasp must have no joints, further bodies, suction cups
//! or kinetic friction. Along a ramp the load is a base load, which acts from the start, plus the load factor λ times another load. The onset is the
//! load factor at which the first contact ceases to stick. Motions are small within limits of rotation and slip up to which the linear theory is
//! trusted.
//!
//! As long as no contact opens or closes, forces F and motion are affine in λ and in the slips s_j. F_i⁰ is the force on contact i under the base
//! load, and F_i¹ its rate per unit of λ, both without slip. The matrix R_ij is the change of F_i per unit slip of contact j, N/m, if everything else
//! sticks. A contact slips along its friction force,
//!
//! ```text
//! F_i = F_i⁰ + λ F_i¹ + Σ_j R_ij s_j,     s_j' = γ_j p_j,     p_j = F_t,j / |F_t,j|
//! ```
//!
//! and the slip rates γ_j and λ' are such that the margins `μ F_n - |F_t|` of all sliding contacts stay zero. Thus there is one equation for each
//! sliding contact, where an [arc](super::arc) has one for each coordinate. Arclength is measured along the curve of the slips, divided by a unit of
//! slip, and of λ. The path ends at a fold (a maximum of λ) or a corner (no contact states continue it). In some cases the functions of this file
//! return `None`, and the caller follows a load path instead. This happens if not everything clearly sticks under the base load, or if a sliding
//! contact stops. It also happens if a contact opens, if changes of contact states coincide, or if the path may continue in several ways.

use nalgebra::SVector;

use super::event::{Loss, LossKind};
use super::first_to_leave::{FirstToLeave, first_to_leave};
use super::onset_workspace::OnsetMemory;
use super::pace::Pace;
use super::ramp::Ramp;
use super::slip_rates::{MOST_SLIDING, Slips};
use super::slip_steps::{GOES_ON, GROWS, SMALL};
use super::snapping_over::{StateAfterSnap, a_little};
use super::trajectory::Trajectory;
use crate::equilibrium::{CountedMotion, MotionData, farthest};
use crate::grasp::{Engine, Hold, Site};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{
    Equation, MOST_UNKNOWNS, Reals, Vector, add_times, any_index, cleared_for, largest, numbered, scale,
    solved, summed,
};
use crate::prelude::*;
use crate::search::Settings;

/// The result of following a growing load: the contacts that slide, the load factor from which each slides, and the end of the path.
pub(crate) struct InSlips {
    /// Indices of the contacts that slide, in the order in which they begin to slide, each with the load factor from which it slides.
    pub(crate) slid: Vec<(usize, f64)>,
    /// The load factor from which on all contacts slide; `None` if some contact sticks up to the end.
    pub(crate) all_slide: Option<f64>,
    /// The load factor at the end of the path.
    pub(crate) factor: f64,
    pub(crate) end: SlipEnd,
    /// The contact forces under the base load and at the end of the path, N, in the contact frames.
    pub(crate) forces: [Vec<SVector<f64, 3>>; 2],
    /// The largest ratio of a rotation or slip to its limit of small motions, over the ends of all integration steps.
    pub(crate) farthest: f64,
}

pub(crate) enum SlipEnd {
    /// The grasp holds up to the load factor `most`, the upper limit given by the caller.
    Held,
    /// This motion (a rotation or slip) has reached its limit of small motions.
    TooFar(CountedMotion),
    Lost(Box<Loss<3>>),
}

impl Engine {
    /// Follows a load that grows along `ramp` up to the load factor `most`. The slips begin at the onset, which must be at a load factor below
    /// `most`. `None` in the cases listed at the top of this file, in which the caller follows a `LoadPath` instead.
    pub(crate) fn in_slips(&self, ramp: &Ramp<3>, most: f64, settings: &Settings) -> Option<InSlips> {
        let plain = |site: &Site| {
            let closed = site.hold == Hold::Unilateral && site.springs.resists_tangentially();
            closed && site.friction.has_edges() && site.kinetic.is_none() && site.polygon.is_none()
        };
        let plain = self.sites().iter().all(plain) && self.linkage().is_none() && self.vacuum().is_none();
        settings.small_motions.check().ok()?;
        if !plain || !settings.is_round(self.space()) && self.space().axes() > 2 {
            return None;
        }
        let (base, rate) = (self.load_alone(&ramp.base, "").ok()?, self.inside(&ramp.direction, "").ok()?);
        let mut memory = OnsetMemory::default();
        ramp.offset_changes_into(self, &mut memory.change).ok()?;
        let segment = memory.segment(self, settings, Trajectory::Straight { from: base, rate });
        let FirstToLeave { factor, contact, there, .. } = first_to_leave(&segment, &mut memory)?;
        let (linear_problem, problem) = (segment.problem.trial(), segment.problem);
        let small = settings.small_motions;
        let mut slips = Slips {
            grasp: self,
            forces: Vec::with_capacity((2 + 2 * problem.len().min(MOST_SLIDING)) * problem.len()),
            problem,
            linear_problem,
            twists: Vec::with_capacity(2 + 2 * MOST_SLIDING),
            sliding: Vec::with_capacity(MOST_SLIDING),
            largest: largest(&there.forces, &SVector::norm),
            most,
            unit: 1.0,
            small,
            slip_limit: small.slip * self.size_of_grasp(),
        };
        slips.push(&memory.base);
        slips.push(&memory.rate);
        let (start, begins) = ([1.0, 0.0], vec![1.0, factor]);
        let far = slips.far(&start).max(slips.far(&begins));
        if factor >= most || far > 1.0 - NEGLIGIBLE {
            return None;
        }
        // If finite rotations end the theory before the first slip, the load path finds the load factor.
        let states = slips.problem.trial_states();
        let is_beyond = |at: &[f64]| {
            let (offsets, accumulated) = (&slips.problem.offsets[..], &slips.problem.slips[..]);
            let (forces, twist) =
                (&numbered(slips.contacts(), &|i| slips.force(i, at))[..], &slips.twist(at));
            let standing = MotionData { offsets, slips: accumulated, states: &states, forces, twist };
            self.too_far_with_turned_parts(&small, &standing, &ramp.load_at(at[1])).is_some()
        };
        if is_beyond(&start) || is_beyond(&begins) {
            return None;
        }
        let (forces, end) = ([Vec::new(), Vec::new()], SlipEnd::Held);
        let mut path = InSlips { slid: Vec::new(), all_slide: None, factor, end, forces, farthest: far };
        let at = slips.run((begins, contact), ramp, settings.step_error, (&mut memory, &mut path))?;
        path.forces = [&start[..], &at].map(|at| numbered(slips.contacts(), &|i| slips.force(i, at)));
        Some(path)
    }
}

/// Upper limit of the number of steps after the onset. A load that needs more steps is left to a `LoadPath`, which has implicit steps for directions
/// of friction that turn fast.
const MOST_STEPS: usize = 64;

impl Slips<'_> {
    /// Follows the load from the path point `at` until the path ends, and writes the contacts that slide and the end of the path to `path`. `at`
    /// lists the factors of the forces F⁰, F¹ and R of the head of this file: the number 1, the load factor, and two slip components of each sliding
    /// contact, m. At first no contact slides, and the load factor is the onset, at which the contact `first` begins to slide. Returns the path point
    /// at the end of the path, or `None` in cases that are left to a `LoadPath`.
    fn run(
        &mut self,
        (mut at, first): (Vec<f64>, usize),
        ramp: &Ramp<3>,
        tolerance: f64,
        (memory, path): (&mut OnsetMemory, &mut InSlips),
    ) -> Option<Vec<f64>> {
        let (mut arrives, mut pace, mut rates) = (Some(first), Pace::new(), Vec::new());
        loop {
            if let Some(contact) = arrives.take() {
                path.factor = at[1];
                path.slid.push((contact, at[1]));
                let end = self.begins_to_slide(contact, (&mut at, &mut rates), ramp, memory)?;
                if !matches!(end, SlipEnd::Held) {
                    path.end = end;
                    return Some(at);
                }
                if self.sliding.len() == self.contacts() {
                    path.all_slide = Some(at[1]);
                }
                pace = pace.at_node();
            }
            let length = pace.length.unwrap_or_else(|| self.first_length(&at, &rates));
            if pace.steps > MOST_STEPS {
                return None;
            }
            let end = self.step((&at, &rates), length);
            let missed = end.as_ref().map_or(f64::INFINITY, |end| end.error / tolerance);
            let Some(end) = end.filter(|_| missed <= 1.0) else {
                pace.refuse(length, missed);
                continue;
            };
            let (end, event) = self.up_to_an_event((&at, &rates), end, tolerance)?;
            pace.accept(end.length, end.error / tolerance, event.is_some());
            (at, rates) = (end.at, end.rates);
            path.farthest = path.farthest.max(1.0 - end.values[SMALL]);
            path.factor = at[1];
            let of_sliding = SMALL + 1 + 2 * self.sliding.len();
            match event {
                None => {}
                Some(GOES_ON) => return Some(at),
                Some(GROWS) => {
                    path.end =
                        self.loss_of_kind(LossKind::Fold, &at, &self.twist(&rates).normalize(), ramp)?;
                    return Some(at);
                }
                Some(SMALL) => {
                    path.end = SlipEnd::TooFar(*farthest(&self.motions(&at))?);
                    return Some(at);
                }
                Some(k) if k < of_sliding => return None,
                Some(k) => arrives = self.sticking().nth(k - of_sliding),
            }
        }
    }

    /// Adds a contact that has reached the boundary of its cone to the sliding contacts, and computes the rates of load factor and slips. Returns
    /// `Held` if the path continues with these rates, and `Lost` if no rates of forces and motion satisfy the contact laws. `None` if rounding leaves
    /// open which is true, or if `MOST_SLIDING` contacts slide already.
    fn begins_to_slide(
        &mut self,
        contact: usize,
        (at, rates): (&mut Vec<f64>, &mut Vec<f64>),
        ramp: &Ramp<3>,
        memory: &mut OnsetMemory,
    ) -> Option<SlipEnd> {
        if self.sliding.len() == MOST_SLIDING {
            return None;
        }
        self.sliding.push(contact);
        let OnsetMemory { solution, there: response, offsets, .. } = memory;
        for axis in 1..3 {
            cleared_for(offsets, self.contacts());
            offsets.resize(self.contacts(), SVector::zeros());
            if axis < self.grasp.space().axes() {
                offsets[contact][axis] = -1.0;
            }
            self.linear_problem.solve_roughly_into(offsets, &Vector::zeros(), (solution, response));
            self.push(response);
            at.push(0.0);
        }
        self.unit = 1.0;
        let (count, directions) = (self.sliding.len(), self.directions(at));
        let margins = self.margin_rates(&directions);
        let (margins, directions) = (&margins[..count], &directions[..count]);
        let slips = slid(margins, &|_| true)?;
        let slips = &slips[..count];
        let clear = NEGLIGIBLE * largest(slips, &|slip| slip.abs());
        if slips.iter().any(|slip| slip.abs() <= clear) {
            return None;
        }
        *rates = vec![0.0, 1.0];
        for (slip, p) in slips.iter().zip(directions) {
            rates.extend_from_slice(&[p[1] * slip, p[2] * slip]);
        }
        if slips.iter().all(|slip| *slip > 0.0) {
            // The unit of slip is chosen so that slips and load factor have equal weight in the arclength at the start of sliding.
            self.unit = summed(slips, &|slip| slip * slip).sqrt();
            scale(rates, core::f64::consts::FRAC_1_SQRT_2);
            return Some(SlipEnd::Held);
        }
        // The path may instead continue so that only some of the contacts in `sliding` slip. Bit i of `combination`, from 0, is set if the contact
        // `sliding[i]` slips; otherwise this contact sticks. A combination continues the path if no slip rate is negative and no margin `μ F_n -
        // |F_t|` decreases. If some combination may continue the path, `None` is returned, and the caller follows a load path.
        let holds = |combination: usize| {
            let slips = slid(margins, &|i| combination >> i & 1 == 1)?;
            let mut holds = slips.iter().all(|slip| *slip >= -clear);
            for rates in margins {
                let terms = rates[1..].iter().zip(&slips).map(|(rate, slip)| rate * slip);
                let (sum, size) =
                    terms.fold((rates[0], rates[0].abs()), |(sum, size), x| (sum + x, size + x.abs()));
                holds &= sum >= -NEGLIGIBLE * size;
            }
            Some(holds)
        };
        if any_index((1 << count) - 1, &|others| holds(others) != Some(false)) {
            return None;
        }
        let along: f64 = slips.iter().sum();
        if along.abs() <= NEGLIGIBLE * summed(slips, &|slip| slip.abs()) {
            return None;
        }
        // With the computed rates forces balance the load, but contacts slip opposite to their friction forces, which the contact law forbids. The
        // reversed motion, in which the slips have the directions of the friction forces, is the motion of the object at the loss.
        let twist = self.twist(rates);
        let motion = &twist * (1.0_f64.copysign(along) / twist.norm());
        self.loss_of_kind(LossKind::Corner, at, &motion, ramp)
    }

    /// The end of the path at the path point `at` as a loss of the kind `kind`, a fold or a corner. At this loss the object begins to move along
    /// `motion`. `None` for a malformed ramp, or if the object, in the model of `snapping_over`, comes to rest in another equilibrium under a
    /// slightly larger load.
    fn loss_of_kind(&self, kind: LossKind, at: &[f64], motion: &Vector, ramp: &Ramp<3>) -> Option<SlipEnd> {
        if self.snaps_over(at, ramp) != Some(false) {
            return None;
        }
        let fraction = at[1];
        let (contacts, drives) = self.grasp.sites_apart(self.sliding.clone());
        let loss = Loss {
            leg: 0,
            fraction,
            load: ramp.load_at(fraction),
            kind,
            contacts,
            drives,
            motion: None,
            jumped: Vec::new(),
            against: None,
            leaves: None,
        };
        Some(SlipEnd::Lost(Box::new(loss.leaving(self.grasp, Some(motion)))))
    }

    /// Whether the object comes to rest in another equilibrium under a load factor slightly larger than that of the path point `at`. The object moves
    /// in the artificial model of `snapping_over`, in which viscous dampers act at the contacts. `None` for a malformed ramp.
    fn snaps_over(&self, at: &[f64], ramp: &Ramp<3>) -> Option<bool> {
        let mut change = Vec::new();
        ramp.offset_changes_into(self.grasp, &mut change).ok()?;
        let (mut problem, rate) = (self.problem.clone(), self.grasp.inside(&ramp.direction, "").ok()?);
        let largest = (0..self.contacts()).map(|i| self.force(i, at).norm()).most();
        let base = self.grasp.load_alone(&ramp.base, "").ok()?;
        let most = largest.max((&base + &rate * at[1]).norm());
        let beyond = at[1] + a_little(self.grasp.sites(), &change, rate.clone(), most);
        problem.wrench = base + rate * beyond;
        add_times(&mut problem.offsets, &change, beyond);
        for (i, slip) in self.sliding.iter().zip(at[2..].chunks_exact(2)) {
            let slip = SVector::from([0.0, slip[0], slip[1]]);
            problem.slips[*i] += slip;
            problem.offsets[*i] -= slip;
        }
        Some(StateAfterSnap::near(self.grasp, &self.small, problem, &self.twist(at)).is_some())
    }
}

/// The slip rates of the chosen contacts, per unit of the load factor, with which their margins `μ F_n - |F_t|` stay zero. The slip rates of all
/// other contacts are zero. `margins` has the derivatives of each margin with respect to the load factor and to the slip of each contact. `None` if
/// the equations do not determine the slip rates.
fn slid(margins: &[Equation], is_chosen: &dyn Fn(usize) -> bool) -> Option<[f64; MOST_UNKNOWNS]> {
    let mut equations = [[0.0; MOST_UNKNOWNS + 1]; MOST_UNKNOWNS];
    for (i, (equation, rates)) in equations.iter_mut().zip(margins).enumerate() {
        // If contact i is not chosen, its equation is replaced by the equation that its slip rate is zero.
        equation[i] = rates[i + 1];
        if is_chosen(i) {
            (0..margins.len()).filter(|j| is_chosen(*j)).for_each(|j| equation[j] = rates[j + 1]);
            equation[MOST_UNKNOWNS] = -rates[0];
        }
    }
    solved(&mut equations[..margins.len()])
}
