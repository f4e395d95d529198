//! The follower in steps: what it stands on, and how it starts.

use nalgebra::SVector;

use super::coarse::Coarse;
use super::one_step::{Standing, StepProblem};
use super::pace::Pace;
use super::walking::Places;
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::load_path::event::PathEnd;
use crate::load_path::follower::{Came, Edge, Follower};
use crate::load_path::journey::Journey;
use crate::load_path::leg::Leg;
use crate::load_path::path::Path;
use crate::object::Problem;
use crate::search::{Found, Settings};

/// A load program being followed in steps: an iterator over them, so that the caller may look at each and stop at any. Made by
/// [`Grasp::follow_in_steps`]; when the iterator has ended, [`end`](Self::end) says how the path did.
///
/// The law is that of [`LoadPath`](crate::load_path::LoadPath), on the round cone, with slip memory: contacts stick, slide in directions that turn, open
/// and close again. Their events are not told one by one; [`state`](Self::state) tells the equilibrium where the path stands.
pub type SteppedPath<'g, const D: usize, const C: usize> = Path<'g, D, C, Steps<'g, D, C>>;

/// The follower of a [`SteppedPath`].
#[derive(Debug)]
pub struct Steps<'g, const D: usize, const C: usize> {
    /// What a step solves.
    pub(super) along: StepProblem<'g, D, C>,
    /// Where the path stands.
    pub(super) standing: Standing<D, C>,
    /// Where the last step tried leads.
    pub(super) places: Places<D, C>,
    /// How the steps of the leg go.
    pub(super) pace: Pace<D>,
    /// What was asked for.
    pub(super) error: f64,
    /// The path of the same steps made at once.
    pub(super) coarse: Coarse<D, C>,
    /// The largest error that both paths may have alike.
    pub(super) unseen: f64,
    /// How far forces have gone, over the largest one.
    pub(super) way: f64,
}

/// One step of a [`SteppedPath`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Step<const D: usize, const C: usize> {
    /// The leg, from 0.
    pub leg: usize,
    /// How much of the leg has been gone at its end, up to 1.
    pub fraction: f64,
    /// The load there, about the origin, N and N m.
    pub load: Wrench<D, C>,
    /// How many contacts slide there.
    pub sliding: usize,
    /// How many are open.
    pub open: usize,
    /// The estimated error of the forces that this step has made, over the largest force.
    pub error: f64,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Follows a load program in steps from the equilibrium under `start`, for any number of contacts on the round cone: a patch that is
    /// sheared and twisted. `error` is the estimated error of forces over the largest one that a leg may add, such as 1e-5. A step costs
    /// a few passes over all contacts, by several threads with the same bits; steps are as long as the square root of the error. See [`SteppedPath`].
    ///
    /// Where no step leads on the path is [lost](PathEnd::Lost), if the speed of the object or the rates of what stands on an edge tell how; else it is
    /// [undecided](PathEnd::Undecided).
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
        start: &Wrench<D, C>,
        legs: &[Leg<D, C>],
        error: f64,
    ) -> Result<SteppedPath<'_, D, C>, Error> {
        self.follow_in_steps_with(start, legs, error, &Settings::default())
    }

    /// [`Self::follow_in_steps`] with other [`Settings`]: [`Settings::most_steps`] bounds the steps of a leg.
    ///
    /// # Errors
    /// As for [`Self::follow_in_steps`].
    pub fn follow_in_steps_with(
        &self,
        start: &Wrench<D, C>,
        legs: &[Leg<D, C>],
        error: f64,
        settings: &Settings,
    ) -> Result<SteppedPath<'_, D, C>, Error> {
        self.refuse_hands("follow_in_steps")?;
        if !(1e-9..=1.0).contains(&error) {
            return Err(Error::Argument { what: "error of a leg", value: error, allowed: "from 1e-9 to 1" });
        }
        let settings = Settings { round: true, ..*settings };
        Path::start(self, (start, legs), &settings, |journey, problem| {
            let standing = at_start(problem, journey.start(problem)?);
            let along = StepProblem::along(journey);
            let pace = Pace::along(&along.course);
            let coarse = Coarse::starting_at(&standing);
            let places = Places::nowhere();
            Ok(Steps { along, standing, places, pace, error, coarse, unseen: 0.0, way: 0.0 })
        })
    }
}

/// What an equilibrium is to a path: its slips are memory.
fn at_start<const D: usize, const C: usize>(
    problem: &Problem<'_, D, C>,
    found: Found<D, C>,
) -> Standing<D, C> {
    let slip = |(i, state): (usize, &crate::contact::State<C>)| {
        let springs = &problem.sites[i].springs;
        if state.is_rolling() || !springs.resists_tangentially() {
            return SVector::zeros();
        }
        springs.slip(&problem.stretch(i, &found.twist), &found.forces[i])
    };
    let slips = found.states.iter().enumerate().map(slip).collect();
    Standing { fraction: 0.0, twist: found.twist, slips, forces: found.forces, states: found.states }
}

impl<const D: usize, const C: usize> SteppedPath<'_, D, C> {
    /// Estimated error of the forces, over the largest one, wherever the path has been. It is how far the path has been from one of the same steps,
    /// each made at once instead of in two halves. To that comes what both may miss alike where a contact stops, opens or closes. As a rule
    /// the error is a third of it.
    #[must_use]
    pub fn step_error(&self) -> f64 {
        self.follower.as_ref().map_or(0.0, |steps| steps.coarse.farthest + steps.unseen)
    }
}

impl<'g, const D: usize, const C: usize> Follower<'g, D, C> for Steps<'g, D, C> {
    type Told = Step<D, C>;

    fn set_out(&mut self, journey: &Journey<'g, D, C>) -> Result<(), PathEnd<D, C>> {
        self.along.set_out(journey);
        self.pace.set_out(&self.along.course);
        self.standing.fraction = 0.0;
        self.coarse.standing.fraction = 0.0;
        Ok(())
    }

    fn go_on(&mut self, journey: &Journey<'g, D, C>) -> Result<Came<Step<D, C>>, PathEnd<D, C>> {
        if self.standing.fraction >= 1.0 { Ok(Came::ToTheEndOfTheLeg) } else { self.try_a_step(journey) }
    }

    fn fraction(&self) -> f64 {
        self.standing.fraction
    }

    fn state(&self, journey: &Journey<'g, D, C>) -> Option<Equilibrium<D, C>> {
        Some(self.standing.equilibrium(journey))
    }

    fn forces(&self, _: &Journey<'g, D, C>) -> Vec<SVector<f64, C>> {
        self.standing.forces.clone()
    }

    fn edge(&self, journey: &Journey<'g, D, C>) -> Edge<'g, D, C> {
        self.standing.edge(journey)
    }
}
