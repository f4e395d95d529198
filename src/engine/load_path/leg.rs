//! Load programs: legs (sections) along which load and finger commands change linearly, or the load turns. A goal is the value of a quantity at the
//! end of a leg, or its change along the leg.

use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Each, IntoList, largest, mapped};
use alloc::borrow::Cow;
use core::ops::Add;

use nalgebra::SVector;

use super::body_loads::BodyGoal;
use super::ramp::{Ramp, vectors};
use super::tolerances::AS_WRITTEN;
use super::trajectory::Trajectory;
use super::turn::Turn;
use crate::error::Error;
use crate::grasp::{Engine, Space, Wrench};
use crate::prelude::*;

/// One leg of a load program: the load, the commands, or both change linearly to their goals, or the load turns.
///
/// To squeeze the object, a leg changes the commands; to load or unload it, a leg changes the load. A quantity that the leg does not mention keeps
/// its value. Loads act on the object (N, N m about the origin). Commands are displacements of the fingers in their contact frames (m), the normal
/// part positive into the object. All points of a soft fingertip follow one command, unless there is one for each point. Loads and commands change in
/// proportion to the fraction of the leg that is done, from 0 to 1.
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
///
/// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
/// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
/// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
///
/// // Squeeze by 5 mm more, hang 12 N on, then release half the squeeze while the load returns to zero.
/// let press = |by: f64| [[by, 0.0]; 2];
/// let legs = [
///     Leg::commands_by(press(0.005)),
///     Leg::load_to(Wrench::force([0.0, -12.0])),
///     Leg::commands_to(press(0.0075)).and_load_to(Wrench::ZERO),
/// ];
/// let mut path = grasp.follow(Wrench::ZERO, &legs)?;
/// assert!(path.run().is_empty()); // 6 N on each side, of 0.5 · 15 N
/// let squeezed = path.state_at(0, 1.0).expect("has passed");
/// assert!((squeezed.contacts[0].normal_force() - 15.0).abs() < 1e-13);
/// let at_last = path.state_at(2, 1.0).expect("has passed");
/// assert!((at_last.contacts[0].normal_force() - 7.5).abs() < 1e-13);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Leg<const C: usize> {
    pub(super) load: LegLoad<C>,
    pub(super) commands: LegGoal<Vec<SVector<f64, C>>>,
    pub(super) joints: LegGoal<Vec<f64>>,
    pub(super) torques: LegGoal<Vec<f64>>,
    /// The bodies whose own loads change along the leg, by name. Each comes with the change of its load, or with its load at the end of the leg.
    pub(super) bodies: Vec<BodyGoal<C>>,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum LegGoal<T> {
    Stay,
    By(T),
    To(T),
}

impl<const C: usize> Leg<C> {
    pub(super) const STAY: Self = Self {
        load: LegLoad::Straight(LegGoal::Stay),
        commands: LegGoal::Stay,
        joints: LegGoal::Stay,
        torques: LegGoal::Stay,
        bodies: Vec::new(),
    };

    /// A leg along which the load changes by `change`, N and N m about the origin.
    pub fn load_by(change: Wrench<C>) -> Self {
        Self { load: LegLoad::Straight(LegGoal::By(change)), ..Self::STAY }
    }

    /// A leg at whose end the load is `load`, N and N m about the origin.
    pub fn load_to(load: Wrench<C>) -> Self {
        Self { load: LegLoad::Straight(LegGoal::To(load)), ..Self::STAY }
    }

    /// A leg along which the load is that of a [`Turn`]. The load before the leg must be the turn's first load, else the leg is refused. A turn that
    /// begins with no load is added to any load. The finger commands stay constant, so that forces are sums of a constant, a cosine and a sine of the
    /// angle. The angles at which contacts change their states are then found without stepping.
    ///
    /// ```
    /// use grasp_lcp::planar::{Change, Contact, Grasp, Leg, Turn, Wrench};
    /// use std::f64::consts::{FRAC_PI_2, TAU};
    ///
    /// // A block on two feet that press with 1 N each, pulled to and fro: 0.6 N times the sine.
    /// let foot = |x: f64, mu: f64| {
    ///     Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(10.0, 10.0).friction(mu).command([0.1, 0.0])
    /// };
    /// let guide = Contact::new([0.0, 0.0], [0.0, -1.0]).series_stiffness(1e3, 1.0);
    /// let block = Grasp::new([foot(-1.0, 0.5), foot(1.0, 0.25), guide])?;
    /// let pull = Turn::new(Wrench::ZERO, Wrench::ZERO, Wrench::force([0.6, 0.0]));
    /// let events = block.follow(Wrench::ZERO, &[Leg::turn(&pull)])?.run();
    /// // The second foot slides when it carries 0.25 · 50/51 N, half of the pull, and sticks where the pull turns back.
    /// let angle = |event: usize| events[event].fraction * TAU;
    /// assert!((angle(0) - (0.5 * 50.0 / 51.0 / 0.6_f64).asin()).abs() < 1e-14);
    /// assert!((angle(1) - FRAC_PI_2).abs() < 1e-14);
    /// assert!(events[1].changes[0].what == Change::Sticks);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    pub fn turn(turn: &Turn<C>) -> Self {
        Self { load: LegLoad::Turn(*turn), ..Self::STAY }
    }

    /// A leg along which the finger commands change by `change`: one displacement for each contact, each in its contact frame (m).
    pub fn commands_by(change: impl IntoIterator<Item = impl Into<[f64; C]>>) -> Self {
        Self { commands: LegGoal::By(vectors(change)), ..Self::STAY }
    }

    /// A leg at whose end the finger commands are `commands`: one displacement for each contact, each in its contact frame (m).
    pub fn commands_to(commands: impl IntoIterator<Item = impl Into<[f64; C]>>) -> Self {
        Self { commands: LegGoal::To(vectors(commands)), ..Self::STAY }
    }

    setters! {
        /// This leg with one more change: along it the load changes by `change`.
        pub fn and_load_by(mut self, change: Wrench<C>) {
            self.load = LegLoad::Straight(LegGoal::By(change));
        }

        /// This leg with one more change: the load becomes `load` at its end.
        pub fn and_load_to(mut self, load: Wrench<C>) { self.load = LegLoad::Straight(LegGoal::To(load)); }

        /// This leg with one more change: along it the finger commands change by `change`, one displacement for each contact in its contact frame, m.
        pub fn and_commands_by(mut self, change: impl IntoIterator<Item = impl Into<[f64; C]>>) {
            self.commands = LegGoal::By(vectors(change));
        }

        /// This leg with one more change: at its end the finger commands are `commands`, one displacement for each contact in its contact frame, m.
        pub fn and_commands_to(mut self, commands: impl IntoIterator<Item = impl Into<[f64; C]>>) {
            self.commands = LegGoal::To(vectors(commands));
        }
    }

    /// A leg along which the joint commands of a hand change by `change`: one displacement for each joint and then each tendon, rad or m.
    ///
    /// ```
    /// use grasp_lcp::planar::hand::{Finger, Hand, Joint};
    /// use grasp_lcp::planar::{Leg, Wrench};
    /// use grasp_lcp::planar::Contact;
    ///
    /// let jaw = |x: f64| {
    ///     Finger::new([Joint::prismatic([-x, 0.0]).stiffness(1e3)])
    ///         .contact(Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 1e3).friction(0.5))
    /// };
    /// let grasp = Hand::new([jaw(-1.0), jaw(1.0)]).grasp()?.with_joint_commands(&[0.01, 0.01])?;
    /// // Close by 10 mm more, then pull: two springs of 1000 N/m in series carry 10 N.
    /// let legs = [Leg::joints_by([0.01, 0.01]), Leg::load_to(Wrench::force([0.0, -20.0]))];
    /// let mut path = grasp.follow(Wrench::ZERO, &legs)?;
    /// path.run();
    /// let lost = path.end().and_then(|end| end.loss()).expect("both slide at last");
    /// assert!((lost.fraction - 0.5).abs() < 1e-14); // at 2 · 0.5 · 10 N
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    pub fn joints_by(change: impl IntoIterator<Item = f64>) -> Self {
        Self::STAY.and_joints_by(change)
    }

    /// A leg at whose end the joint commands of a hand are `commands`: one displacement for each joint and then each tendon, rad or m.
    pub fn joints_to(commands: impl IntoIterator<Item = f64>) -> Self {
        Self::STAY.and_joints_to(commands)
    }

    /// This leg with one more change: along it the joint commands change by `change`, rad or m.
    pub fn and_joints_by(self, change: impl IntoIterator<Item = f64>) -> Self {
        Self { joints: LegGoal::By(change.into_iter().list()), ..self }
    }

    /// This leg with one more change: at its end the joint commands are `commands`, rad or m.
    pub fn and_joints_to(self, commands: impl IntoIterator<Item = f64>) -> Self {
        Self { joints: LegGoal::To(commands.into_iter().list()), ..self }
    }

    /// Whether the load turns along this leg.
    #[cfg(feature = "plot")]
    pub(crate) fn turns(&self) -> bool {
        matches!(self.load, LegLoad::Turn(_))
    }

    /// A leg along which load and commands change as they do along `ramp` while the load factor of the ramp grows by one.
    pub fn along(ramp: &Ramp<C>) -> Self {
        let by = |change: &Vec<_>| LegGoal::By(change.clone());
        Self {
            load: LegLoad::Straight(LegGoal::By(ramp.direction)),
            commands: ramp.command_change.as_ref().map_or(LegGoal::Stay, by),
            joints: ramp.joint_change.as_ref().map_or(LegGoal::Stay, |change| LegGoal::By(change.clone())),
            torques: LegGoal::Stay,
            bodies: Vec::new(),
        }
    }

    /// Two legs: the load changes by `change`, then back again.
    ///
    /// ```
    /// use grasp_lcp::planar::{Leg, Wrench};
    ///
    /// let pull = Wrench::force([2.0, 0.0]);
    /// assert_eq!(Leg::there_and_back(pull), [Leg::load_by(pull), Leg::load_by(pull * -1.0)]);
    /// ```
    pub fn there_and_back(change: Wrench<C>) -> [Self; 2] {
        [Self::load_by(change), Self::load_by(change * -1.0)]
    }
}

impl Leg<3> {
    /// This leg with one command for each contact point. The command of a soft fingertip is repeated for all of its points. A link between bodies has
    /// no entry in the caller's commands: its command stays as it is, so that the link keeps its pretension. Returns an error if the number of
    /// commands is wrong.
    pub(super) fn of_points(&self, grasp: &Engine) -> Result<Self, Error> {
        let (what, none) = ("commands of a leg", SVector::zeros());
        let of_points = |rows: &Vec<_>, at_links: &dyn Fn(usize) -> SVector<f64, 3>| {
            grasp.commands_of_points(rows, at_links, what).map(Cow::into_owned)
        };
        let commands = match &self.commands {
            LegGoal::Stay => LegGoal::Stay,
            LegGoal::By(change) => LegGoal::By(of_points(change, &|_| none)?),
            LegGoal::To(goal) => LegGoal::To(of_points(goal, &|i| grasp.contacts()[i].command)?),
        };
        Ok(Self { commands, ..self.clone() })
    }

    pub(super) fn check(&self, grasp: &Engine) -> Result<(), Error> {
        match &self.load {
            LegLoad::Straight(LegGoal::Stay) => {}
            LegLoad::Straight(LegGoal::By(load) | LegGoal::To(load)) => {
                grasp.inside(load, "load of a leg")?;
            }
            LegLoad::Turn(turn) => {
                turn.check_in(grasp.space())?;
                if self.commands != LegGoal::Stay || self.joints != LegGoal::Stay {
                    return Err(Error::CommandsWhileTurning);
                }
            }
        }
        if let LegGoal::By(commands) | LegGoal::To(commands) = &self.joints {
            grasp.check_joint_commands(commands, "joint commands of a leg")?;
        }
        self.check_torques(grasp)?;
        self.check_bodies(grasp)
    }
}

impl LegLoad<3> {
    /// For a leg whose load turns: checks that the load at the beginning of the turn is the load `before` the leg, or zero. Otherwise returns an error, which names
    /// the leg by its index.
    pub(super) fn check_beginning(&self, before: &Wrench<3>, leg: usize, space: Space) -> Result<(), Error> {
        let Self::Turn(turn) = self else { return Ok(()) };
        let begins = turn.load_at(0.0);
        let size = |load: Wrench<3>| largest(load.components(), &|x| x.abs());
        if size(begins - *before) <= AS_WRITTEN * size(begins)
            || size(begins) <= NEGLIGIBLE * size(turn.parts()[1])
        {
            return Ok(());
        }
        let [begins, before] = [begins, *before]
            .each(|load| mapped(space.components::<3>(), &|place| load.components()[*place]));
        Err(Error::TurnBegins { leg, begins, before })
    }
}

/// The change of the load along a leg: linear in the fraction of the leg, or along a turn.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum LegLoad<const C: usize> {
    Straight(LegGoal<Wrench<C>>),
    /// The load changes along this turn, from its beginning to its last angle.
    Turn(Turn<C>),
}

impl<const C: usize> LegLoad<C> {
    /// The load as a function of the fraction of this leg that is done, if the leg begins with the load `from`. Also the load at the end of the leg.
    pub(super) fn trajectory(&self, from: &Wrench<C>) -> (Trajectory<Wrench<C>>, Wrench<C>) {
        let (rate, to) = match self {
            Self::Straight(LegGoal::Stay) => (Wrench::ZERO, *from),
            Self::Straight(LegGoal::By(change)) => (*change, *from + *change),
            Self::Straight(LegGoal::To(goal)) => (*goal - *from, *goal),
            Self::Turn(turn) => {
                let trajectory = turn.beginning_with(from);
                return (trajectory, trajectory.at(1.0));
            }
        };
        (Trajectory::Straight { from: *from, rate }, to)
    }
}

impl<T: Copy + Add<Output = T>> LegGoal<Vec<T>> {
    /// `commands` has the commands (or torques) at the beginning and at the end of a leg; this function moves on to the next leg. The next leg begins
    /// with the values at the end of the last leg, and ends at this goal.
    pub(super) fn append(&self, commands: &mut [Vec<T>; 2]) {
        commands.swap(0, 1);
        let [from, to] = commands;
        to.clear();
        match self {
            Self::Stay => to.extend_from_slice(from),
            Self::By(change) => from.iter().zip(change).map(|(u, du)| *u + *du).append_to(to),
            Self::To(goal) => to.extend_from_slice(goal),
        }
    }
}
