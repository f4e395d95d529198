//! A grasp, and what it can be asked.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};

use super::energy::Energy;
use super::engines;
use super::questions::Questions;
use super::sensitivity::Sensitivity;
use super::statics::Statics;
use crate::equilibrium::{Equilibrium, Outcome, Settings};
use crate::error::Error;
use crate::grasp::{Contact, Hand, HandPart, WholeContact, WholeContacts, Wrench};
use crate::hold::Verdict;
use crate::load_path::{
    Beyond, Leg, LoadPath, Onset, OnsetEvent, PatchPath, Ramp, SteppedPath, StickingRange, Turn, TurnOnset,
};
use crate::squeeze::{Bounds, LeastOnset, LeastSqueeze, Loads, WeakestDirection};

/// An object held by elastic fingers: a checked list of contacts, and the joints behind them if a [`Hand`] holds it.
///
/// The reference point of wrenches and twists is the origin of the coordinates in which the contact
/// points are given. `C` is the number of axes of a contact: 2 in the plane ([`planar::Grasp`](crate::planar::Grasp)), 3 in space
/// ([`spatial::Grasp`](crate::spatial::Grasp)).
///
/// | what you want | method |
/// |---|---|
/// | does it hold, and how much more would it take | [`hold`](Self::hold) |
/// | where the object goes and what contacts carry under a load, or the proof that nothing holds | [`solve`](Self::solve) |
/// | the load at first slip | [`onset_of_sliding`](Self::onset_of_sliding), with commands [`onset`](Self::onset) |
/// | the angle at which it slides while a weight is tilted | [`onset_of_turn`](Self::onset_of_turn) |
/// | what comes just beyond an onset | [`beyond`](Self::beyond), [`state_at_onset`](Self::state_at_onset) |
/// | every event of a load program, with slip memory | [`follow`](Self::follow); thousands of contacts [`follow_patch`](Self::follow_patch); on the round cone in steps [`follow_in_steps`](Self::follow_in_steps) |
/// | how much squeeze, friction, load, arm or angle it takes | [`need`](Self::need); for squeeze in closed form [`least_squeeze`](Self::least_squeeze) |
/// | the direction in which the least force slides | [`weakest_direction`](Self::weakest_direction) |
/// | how an answer changes with the data | [`sensitivity`](crate::ask::Sensitivity::of) |
/// | how far an onset spreads where data are not known exactly | [`robust_onset`](Self::robust_onset), [`least_onset_within`](Self::least_onset_within) |
/// | whether fingers could hold it at all | [`statics`](Self::statics) |
/// | all equilibria under a load, the error of one | [`equilibria`](Self::equilibria), [`accuracy`](Self::accuracy), [`distinct`](Self::distinct) |
/// | many questions on all cores | [`solve_each`](Self::solve_each), [`onset_each`](Self::onset_each), [the room](crate::sweep) |
/// | what the paper's quadratic program says | [`energy`](Self::energy) |
/// | any of these for another cone, or with other budgets | [`with`](Self::with) settings |
#[derive(Debug, Clone)]
pub struct Grasp<const C: usize> {
    pub(super) engine: Arc<dyn Questions<C>>,
    pub(super) settings: Settings,
}

impl<const C: usize> Grasp<C> {
    /// Checks the contacts and lays out their frames.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp};
    /// use grasp_lcp::{Error, Field};
    ///
    /// let contact = |mu| Contact::new([0.0, 0.0], [1.0, 0.0]).series_stiffness(1.0, 1.0).friction(mu);
    /// assert_eq!(Grasp::new([contact(0.3), contact(0.5)])?.len(), 2);
    ///
    /// let refused = Grasp::new([contact(0.3), contact(-0.5).name("thumb")]).unwrap_err();
    /// assert!(matches!(refused, Error::Contact { field: Field::Friction, value: -0.5, .. }));
    /// assert_eq!(refused.to_string(), "contact 1 (thumb): friction coefficient is -0.5, must be from 0 to 1e50, or infinite");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::EmptyGrasp`], or [`Error::Contact`] naming the first contact, field and value that
    /// is out of range.
    pub fn new(contacts: impl IntoIterator<Item = Contact<C>>) -> Result<Self, Error> {
        engines::of_contacts(contacts.into_iter().collect()).map(Self::of)
    }

    pub(crate) fn of(engine: Arc<dyn Questions<C>>) -> Self {
        Self { engine, settings: Settings::default() }
    }

    /// This grasp asked with other [`Settings`]: for another cone, with other budgets. Contacts and factors are shared with this one, not copied.
    ///
    /// ```
    /// use grasp_lcp::spatial::{Contact, Grasp, Wrench};
    /// use grasp_lcp::{Fit, PolygonCone, Settings};
    ///
    /// // Four fingers on a ring, 10 N each, μ = 0.5: the round cone carries 20 N upwards whatever the frames.
    /// let finger = |x: f64, y: f64| {
    ///     Contact::new([x, y, 0.0], [-x, -y, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).command([0.01, 0.0, 0.0])
    /// };
    /// let grasp = Grasp::new([finger(1.0, 0.0), finger(0.0, 1.0), finger(-1.0, 0.0), finger(0.0, -1.0)])?;
    /// let up = Wrench::force([0.0, 0.0, 19.9]);
    /// assert!(grasp.solve(&up)?.equilibrium().is_some());
    ///
    /// // A triangle in the cone, its corner pointing sideways, does not.
    /// let triangle = Settings::default().on_the_polygon().with_cone(PolygonCone::new(3, Fit::Inscribed)?);
    /// assert!(grasp.with(&triangle).solve(&up)?.equilibrium().is_none());
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn with(&self, settings: &Settings) -> Self {
        Self { engine: self.engine.clone(), settings: *settings }
    }

    /// Contacts as people count them, of those that are meant: a soft fingertip is one, with so many of its points.
    #[must_use]
    pub fn whole_contacts(&self, is_meant: impl Fn(usize) -> bool) -> Vec<WholeContact> {
        WholeContacts::of(self.contacts()).with(is_meant)
    }

    /// The settings with which it is asked.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Does it hold? The load is put on from rest, and the [`Verdict`] says in a sentence what becomes of it: it holds and everything
    /// sticks, or some contacts slide, or it is lost at such a part of it, and how. Beside that stand first slip and gross slip as multiples of the
    /// load, looked for up to [`Settings::most_load`].
    ///
    /// A load is a [`Wrench`], put on from nothing, or a [`Ramp`] with a base load and changes of commands. It is followed as by [`Self::follow`]; nothing
    /// is searched for, so that it is undecided only where that path is. Where the load is lost, [`Lost::nothing_near`](crate::hold::Lost::nothing_near)
    /// proves that nothing holds it near there.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two jaws that each press with 10 N; μ = 0.5.
    /// let jaw = |x: f64, name| Contact::new([x, 0.0], [-x, 0.0]).name(name).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let gripper = Grasp::new([jaw(-0.03, "left"), jaw(0.03, "right")])?;
    ///
    /// let verdict = gripper.hold(Wrench::force([0.0, -4.0]))?;
    /// assert_eq!(verdict.to_string(), "HOLDS, everything sticks: 2.5 times this load until it is lost, as left and right slide");
    /// assert!((verdict.lost.expect("both slide at once").factor - 2.5).abs() < 1e-12);
    ///
    /// let verdict = gripper.hold(Wrench::force([0.0, -12.0]))?;
    /// let words = verdict.to_string();
    /// assert!(words.starts_with("SLIPS OUT at 10 N of 12 N: the object moves along −y, left and right slide (gross slip)"), "{words}");
    /// assert_eq!(verdict.holds(), Some(false));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::onset`].
    #[doc(alias = "gross slip", alias = "limit load", alias = "grip", alias = "payload", alias = "reserve")]
    pub fn hold(&self, load: impl Into<Ramp<C>>) -> Result<Verdict<C>, Error> {
        self.engine.hold(&load.into(), &self.settings)
    }

    /// The equilibrium under a load.
    ///
    /// Where several equilibria exist, the one in which everything sticks comes first; else see [`Rung`](crate::equilibrium::Rung).
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Outcome, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // 4 N downwards stretch two tangential springs of 800 N/m; each contact carries half.
    /// let outcome = grasp.solve(&Wrench::force([0.0, -4.0]))?;
    /// let held = outcome.equilibrium().expect("friction carries up to 10 N");
    /// assert!((held.twist.translation()[1] - -4.0 / 1600.0).abs() < 1e-15);
    /// assert!((held.contacts[0].friction_used() - 2.0 / 10.0).abs() < 1e-15);
    ///
    /// assert!(matches!(grasp.solve(&Wrench::force([0.0, -11.0]))?, Outcome::NoEquilibrium(_)));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn solve(&self, load: &Wrench<C>) -> Result<Outcome<C>, Error> {
        self.engine.solve(load, &self.settings)
    }

    /// The onset of sliding from a base load along a load direction: exact in the plane, on
    /// the round cone in space. See [`Self::onset`].
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // Both contacts slide when half the load is μ N = 5 N.
    /// let onset = grasp.onset_of_sliding(&Wrench::ZERO, &Wrench::force([0.0, -1.0]))?;
    /// let event = onset.event().expect("friction is finite");
    /// assert!((event.factor - 10.0).abs() < 1e-14);
    /// assert_eq!(event.leaving.len(), 2);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load is not finite, or beyond 1e50.
    #[doc(alias = "first slip")]
    pub fn onset_of_sliding(&self, base: &Wrench<C>, direction: &Wrench<C>) -> Result<Onset<C>, Error> {
        self.onset(&Ramp::load(*base, *direction))
    }

    /// The factor at which the first contact stops sticking along a [`Ramp`], and which contacts leave and how: in
    /// the plane exact, in space on the round cone. No stepping and no bisection: a linear equation for each facet in the plane, a quadratic
    /// one for each contact on the round cone.
    ///
    /// The equilibrium there and what comes next are one call further: [`Self::state_at_onset`], [`Self::beyond`].
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // The fingers let go under 4 N: F_t = 2 N needs F_n = 4 N, which is left after 6 mm.
    /// let release = Ramp::commands(Wrench::force([0.0, -4.0]), [[-1.0, 0.0]; 2]);
    /// let factor = grasp.onset(&release)?.factor().expect("sticks at first");
    /// assert!((factor - 0.006).abs() < 1e-16);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load of the ramp, [`Error::Contact`] if a command change is not finite or beyond 1e50; [`Error::Size`] if
    /// there are more or fewer command changes than contacts.
    #[doc(alias = "first slip", alias = "slip margin", alias = "incipient slip")]
    pub fn onset(&self, ramp: &Ramp<C>) -> Result<Onset<C>, Error> {
        self.engine.onset(ramp, &self.settings)
    }

    /// The equilibrium at an onset: everything sticks, the leaving contacts stand on the edge of their cone. `None` for the event of a grasp
    /// with another number of contacts.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let onset = grasp.onset_of_sliding(&Wrench::ZERO, &Wrench::force([0.0, -1.0]))?;
    ///
    /// let state = grasp.state_at_onset(onset.event().expect("slides")).expect("its own event");
    /// assert!((state.contacts[0].friction_used() - 0.5).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn state_at_onset(&self, event: &OnsetEvent<C>) -> Option<Equilibrium<C>> {
        self.engine.state_at_onset(event)
    }

    /// What comes after an onset; see [`Self::beyond`].
    #[doc(alias = "gross slip")]
    #[must_use]
    pub fn beyond(&self, event: &OnsetEvent<C>) -> Option<Beyond<C>> {
        self.engine.beyond(event, &self.settings)
    }

    /// The angle at which the first contact stops sticking while a load turns: in the plane exact, in space on
    /// the round cone. No stepping: each margin's roots are isolated between its turning points, so that none is lost.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Onset, Turn};
    ///
    /// // A box of 2 N between two palms that press with 10 N each, μ = 0.5, tilted: its weight comes to lie on one of them.
    /// let palm = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let palms = Grasp::new([palm(-1.0), palm(1.0)])?;
    /// let light = palms.onset_of_turn(&Turn::tilting([0.0, -2.0], [0.0, 0.0]))?;
    /// assert!(matches!(light.onset, Onset::Never));
    ///
    /// // 12 N would slide at once on its side: the palm above carries F_n = 10 - 6 sin θ and F_t = 6 cos θ. μ F_n = F_t where
    /// // 6 cos θ + 3 sin θ = 5; upright it needs 6 N of 5 N.
    /// let heavy = palms.onset_of_turn(&Turn::tilting([0.0, -12.0], [0.0, 0.0]))?;
    /// assert!(matches!(heavy.onset, Onset::AlreadySliding(_) | Onset::NoBase(_)));
    /// let from_its_side = Turn::tilting([12.0, 0.0], [0.0, 0.0]).reversed();
    /// let onset = palms.onset_of_turn(&from_its_side)?.onset;
    /// // 6 sin θ + 3 cos θ = 5 there.
    /// let closed = (5.0 / 45_f64.sqrt()).asin() - 3_f64.atan2(6.0);
    /// assert!((onset.factor().expect("slides") - closed).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a part of the load is not finite, or beyond 1e50. [`Error::Argument`] unless the angle is more than zero, and at
    /// most 1e6.
    pub fn onset_of_turn(&self, turn: &Turn<C>) -> Result<TurnOnset<C>, Error> {
        self.engine.onset_of_turn(turn, &self.settings)
    }

    /// Follows a load program from the equilibrium under `start` (that of [`Self::solve`]) with the finger commands of the grasp, on the
    /// exact cone: in space the round one. Nothing is computed beyond the start until the path is asked for an event. See [`LoadPath`],
    /// and [`Leg`] for an example. For hundreds of contacts and more there are [`Self::follow_patch`] and [`Self::follow_in_steps`].
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load, [`Error::Contact`] if a command of a leg is not finite or beyond 1e50; [`Error::Size`] if a leg has more
    /// or fewer commands than there are contacts. That there is no equilibrium to start from is [`PathEnd::NoStart`](crate::load_path::PathEnd::NoStart).
    #[doc(alias = "gross slip")]
    pub fn follow(&self, start: &Wrench<C>, legs: &[Leg<C>]) -> Result<LoadPath<'_, C>, Error> {
        self.engine.follow(start, legs, &self.settings)
    }

    /// Follows a load program from the equilibrium under `start` with the finger commands of the
    /// grasp, for any number of contacts. An event costs about as much as the contacts that it
    /// concerns. In space on the default polygonal cone, 8 facets inside the round one; for the round one
    /// there is [`Self::follow_in_steps`]. See [`PatchPath`].
    ///
    /// # Errors
    /// As for [`Self::follow`]; [`Error::NotForHands`]; [`Error::StraightOnly`] if the load of a leg turns.
    pub fn follow_patch(&self, start: &Wrench<C>, legs: &[Leg<C>]) -> Result<PatchPath<'_, C>, Error> {
        self.engine.follow_patch(start, legs, &self.settings)
    }

    /// Follows a load program in steps from the equilibrium under `start`, for any number of contacts on the round cone: a patch that is
    /// sheared and twisted. `error` is the estimated error of forces over the largest one that a leg may add, such as 1e-5. A step costs
    /// a few passes over all contacts, by several threads with the same bits; steps are as long as the square root of the error. See [`SteppedPath`].
    ///
    /// Where no step leads on the path is [lost](crate::load_path::PathEnd::Lost), if the speed of the object or the rates of what stands on an edge tell how; else it is
    /// [undecided](crate::load_path::PathEnd::Undecided).
    ///
    /// In the plane nothing turns, and [`Self::follow_patch`] tells every event exactly.
    ///
    /// ```
    /// use grasp_lcp::load_path::PathEnd;
    /// use grasp_lcp::spatial::{Contact, Grasp, Leg, Wrench};
    ///
    /// // A ring of a hundred springs under a body of 100 N, μ = 0.5: 50 N m turn it. It is sheared and twisted, and let go.
    /// let spring = |i: i32| {
    ///     let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 100.0).sin_cos();
    ///     Contact::new([cos, sin, 0.0], [0.0, 0.0, 1.0]).series_stiffness(1e3, 8e2).friction(0.5)
    /// };
    /// let ring = Grasp::new((0..100).map(spring))?;
    /// let pulled = |shear: f64, torsion: f64| Wrench::new([shear, 0.0, -100.0], [0.0, 0.0, torsion]);
    /// let legs = [Leg::load_to(pulled(25.0, 35.0)), Leg::load_to(pulled(0.0, 0.0))];
    ///
    /// let mut path = ring.follow_in_steps(&pulled(0.0, 0.0), &legs, 1e-4)?;
    /// assert!(path.by_ref().any(|step| step.sliding > 0));
    /// path.by_ref().for_each(drop);
    /// assert!(matches!(path.end(), Some(PathEnd::Completed)) && path.step_error() < 3e-4);
    /// // What has slipped stays slipped.
    /// let left = path.state().expect("completed");
    /// assert!(left.twist.rotation()[2] > 1e-6 && left.residuals.worst() < 1e-10);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::follow`]; [`Error::NotForHands`]; [`Error::Argument`] unless `error` is from 1e-9 to 1.
    pub fn follow_in_steps(
        &self,
        start: &Wrench<C>,
        legs: &[Leg<C>],
        error: f64,
    ) -> Result<SteppedPath<'_, C>, Error> {
        self.engine.follow_in_steps(start, legs, error, &self.settings)
    }

    /// The range of factors of a ramp, around 0, in which everything that touches sticks: for an affine choice of load or
    /// commands all the values that a planner may take without sliding. Two onsets, one each way. `None` where at 0 something slides, nothing
    /// holds, or neither is known.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let ramp = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
    /// let range = grasp.sticking_range(&ramp)?.expect("sticks without load");
    /// assert!((range.from - -10.0).abs() < 1e-13 && (range.to - 10.0).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::onset`].
    pub fn sticking_range(&self, ramp: &Ramp<C>) -> Result<Option<StickingRange>, Error> {
        self.engine.sticking_range(ramp, &self.settings)
    }

    /// The least common factor of all finger commands with which every contact touches and sticks under each of a set of loads. On the round
    /// cone in space.
    ///
    /// Every condition is linear in the factor or concave, so what suffices is an interval. A condition that is broken at one factor gives
    /// another that is needed at least, where the next step begins: what is needed and what suffices meet in one number. Clearances stay as
    /// they are.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, LeastSqueeze, Loads, Turn, Wrench};
    ///
    /// // Two palms that press with 1 N each, μ = 0.5, hold a box. Carried upright, 12 N need 12 times as much: 6 N of friction at each.
    /// let palm = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(1.0);
    /// let palms = Grasp::new([palm(-1.0), palm(1.0)])?;
    /// let needed = |loads: Loads| match palms.least_squeeze(&loads)? {
    ///     LeastSqueeze::Factor { factor, .. } => Ok::<f64, grasp_lcp::Error>(factor),
    ///     other => panic!("{other:?}"),
    /// };
    /// assert!((needed(Loads::Each(vec![Wrench::force([0.0, -12.0])]))? - 12.0).abs() < 1e-14);
    /// // Turned over it needs more, where a palm is half below: F_t = 6 cos θ, F_n = s - 6 sin θ.
    /// let turned = needed(Loads::Turn(Turn::tilting([0.0, -12.0], [0.0, 0.0])))?;
    /// assert!((turned - 180_f64.sqrt()).abs() < 1e-13);
    /// // So it does for 12 N of any direction.
    /// let any = Loads::AnyForce { base: Wrench::ZERO, size: 12.0, point: [0.0, 0.0] };
    /// assert!((needed(any)? - turned).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load, [`Error::Argument`] if another number of the set is out of range or the set is empty.
    /// [`Error::NotForHands`] for a grasp by a hand.
    #[doc(alias = "grip force", alias = "clamp preload", alias = "gripping force")]
    pub fn least_squeeze(&self, loads: &Loads<C>) -> Result<LeastSqueeze<C>, Error> {
        self.engine.least_squeeze(loads, &self.settings)
    }

    /// The least onset of sliding along a ramp over all commands and loads within bounds, with the case in which it is. On the round cone
    /// in space. Exact, not by sampling: see [`Bounds`].
    ///
    /// Of friction the worst case is the least: ask a grasp with that. Stiffness and geometry do not enter linearly;
    /// [`Self::robust_onset`] has them to first order.
    ///
    /// ```
    /// use grasp_lcp::planar::{Bounds, Contact, Grasp, LeastOnset, Ramp, Wrench};
    ///
    /// // Two fingers that press with 1000 N/m · 10 mm = 10 N, μ = 0.5, to 1 mm; a pull down of up to 2 N beside the weight.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let weight = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
    /// let bounds = Bounds::none().with_commands([[0.001, 0.0]; 2]).with_base(Wrench::force([0.0, 2.0]));
    /// // 2 μ · 9 N less 2 N.
    /// let LeastOnset::At { factor, .. } = grasp.least_onset_within(&weight, &bounds)? else { panic!("it slides") };
    /// assert!((factor - 7.0).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::onset`]; [`Error::Argument`] or [`Error::Size`] for bounds below zero or beyond 1e50, or of another number of contacts;
    /// [`Error::NotForHands`] for a grasp by a hand.
    pub fn least_onset_within(&self, ramp: &Ramp<C>, bounds: &Bounds<C>) -> Result<LeastOnset<C>, Error> {
        self.engine.least_onset_within(ramp, bounds, &self.settings)
    }

    /// The direction in which the least force through a point (m) makes a contact stop sticking, beside a base load. On the round cone in
    /// space.
    ///
    /// Of each facet the worst direction is known in closed form: with forces `F⁰ + A x` it is `x` along `-Aᵀa`, of size `a·F⁰ / |Aᵀa|`.
    ///
    /// The round cone has a facet at every angle. The least is found where a trigonometric polynomial falls below zero, see [the room](crate::squeeze).
    /// So it is least over all directions up to rounding, whatever the number of minima.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, WeakestDirection, Wrench};
    ///
    /// // Two fingers that press with 10 N, μ = 0.5: along the line of the fingers 20 N open one, across 10 N make both slide. Between, a
    /// // finger carries F_n = 10 + x/2, F_t = y/2: y/2 = 5 + x/4 is nearest at x = -4, y = 8.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 1000.0).friction(0.5).pressed_with(10.0);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let WeakestDirection::Force { size, direction, .. } = grasp.weakest_direction(&Wrench::ZERO, [0.0, 0.0])? else { panic!("it slides") };
    /// assert!((size - 80_f64.sqrt()).abs() < 1e-14);
    /// assert!((direction[0].abs() - 0.2_f64.sqrt()).abs() < 1e-15 && (direction[1].abs() - 0.8_f64.sqrt()).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the base load, [`Error::Argument`] if the point is not finite or beyond 1e50.
    pub fn weakest_direction(
        &self,
        base: &Wrench<C>,
        point: impl Into<[f64; C]>,
    ) -> Result<WeakestDirection<C>, Error> {
        self.engine.weakest_direction(base, point.into(), &self.settings)
    }

    /// Whether some drive pushes at rest.
    #[cfg(feature = "serde")]
    pub(crate) fn presses(&self) -> bool {
        self.engine.presses()
    }

    /// Which loads any contact forces could balance, whatever springs and commands.
    #[must_use]
    pub fn statics(&self) -> Statics<'_, C> {
        Statics(self)
    }

    /// How answers change with the data.
    #[must_use]
    pub fn sensitivity(&self) -> Sensitivity<'_, C> {
        Sensitivity(self)
    }

    /// The paper's quadratic programs and other laws of friction beside Coulomb's, and stability.
    #[must_use]
    pub fn energy(&self) -> Energy<'_, C> {
        Energy(self)
    }

    /// Number of contacts, at least 1.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a grasp is never empty")]
    pub fn len(&self) -> usize {
        self.contacts().len()
    }

    /// The contacts as they were given, their commands in the contact frames.
    #[must_use]
    pub fn contacts(&self) -> &[Contact<C>] {
        self.engine.contacts()
    }

    /// The contact frames, orthonormal columns n, t (and t₂): `frame * force` is along the
    /// coordinate axes. In space each is a rotation,
    /// [`Rotation3::from_matrix_unchecked`](nalgebra::Rotation3::from_matrix_unchecked) takes it;
    /// in the plane it is a reflection, since `t = (n_y, -n_x)` lies clockwise of n.
    ///
    /// ```
    /// use grasp_lcp::nalgebra::{Rotation3, Vector3};
    /// use grasp_lcp::spatial::{Contact, Grasp};
    ///
    /// let grasp = Grasp::new([Contact::new([0.0; 3], [0.0, 0.0, -2.0]).series_stiffness(1.0, 1.0)])?;
    /// for frame in grasp.frames() {
    ///     assert_eq!(frame.column(0), -Vector3::z());
    ///     assert_eq!(Rotation3::from_matrix_unchecked(*frame).matrix().determinant(), 1.0);
    /// }
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn frames(&self) -> impl ExactSizeIterator<Item = &SMatrix<f64, C, C>> {
        (0..self.len()).map(|contact| self.engine.frame(contact))
    }

    /// Commands of the joints of the hand, then of its tendons, rad and m; empty without a hand.
    #[must_use]
    pub fn joint_commands(&self) -> &[f64] {
        self.engine.joint_commands()
    }

    /// How pictures and messages call a part of the hand: its name, or what it is and its number.
    #[must_use]
    pub fn label_of(&self, part: HandPart) -> String {
        self.engine.label_of(part)
    }

    /// Ends of the hand's links, from revolute joint to revolute joint and on to the contacts, m, before anything moves: for pictures.
    #[must_use]
    pub fn links(&self) -> &[[SVector<f64, C>; 2]] {
        self.engine.links()
    }

    /// Where each joint of the hand turns, m, before anything moves: for pictures. `None` for what slides, or is known by Jacobians alone.
    #[must_use]
    pub fn joint_centres(&self) -> &[Option<SVector<f64, C>>] {
        self.engine.joint_centres()
    }
}

impl<const C: usize> Hand<C> {
    /// The grasp of an object by this hand, whatever its number of joints.
    ///
    /// # Errors
    /// [`Error::EmptyGrasp`] without contacts; [`Error::Hand`] naming joint, tendon or finger, the field and what is
    /// allowed; [`Error::Contact`] as for [`Grasp::new`].
    pub fn grasp(self) -> Result<Grasp<C>, Error> {
        engines::of_hand(self).map(Grasp::of)
    }
}
