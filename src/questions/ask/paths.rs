//! Load paths of load programs, followed from event to event or in steps, and loads that repeat. A leg is a section of a load program. An event is a
//! change of contact states at one point of a load path.

use super::grasp::Grasp;
use crate::error::Error;
use crate::grasp::{Wrench, all_inside, inside, outside};
use crate::load_path::{Leg, LoadPath, SteppedPath, path_outside};
use crate::shake::Shaken;

impl<const C: usize> Grasp<C> {
    /// Follows a load program from the equilibrium under `start` that [`Self::solve`] finds with the finger commands of the grasp. In space the
    /// friction cone is round. Events after the start are computed only when the returned [`LoadPath`] is iterated. [`Leg`] has an example.
    ///
    /// The path ends as soon as a suction cup is open all around. If nothing resists the object any more, the object moves freely until a gap closes.
    /// If this free motion is small, the path continues after it ([`Jump::reaches`](crate::load_path::Jump::reaches)). For hundreds of contacts and
    /// more use [`Self::follow_in_steps`].
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load, [`Error::Contact`] if a command of a leg is not finite or beyond 1e50; [`Error::Size`] if a leg has more or fewer
    /// commands than there are contacts. A missing equilibrium at the start is no error: the path ends with
    /// [`PathEnd::NoStart`](crate::load_path::PathEnd::NoStart).
    #[doc(alias = "gross slip")]
    pub fn follow(&self, start: impl Into<Wrench<C>>, legs: &[Leg<C>]) -> Result<LoadPath<'_, C>, Error> {
        Ok(path_outside(self.engine.follow(&inside(&start.into()), &all_inside(legs), &self.settings)?))
    }

    /// Whether the grasp survives a load that repeats. From rest under `base`, a closed cycle of legs (sections of a load program) is followed again
    /// and again. The grasp may come to rest, or contacts slide to and fro for ever. Or the object walks, by the same motion in every cycle, or is
    /// lost in some cycle. [`Shaken`] says in a sentence which of these happens; the module [`shake`](crate::shake) describes the method. At most
    /// [`Settings::most_cycles`](crate::Settings::most_cycles) cycles are followed.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
    ///
    /// // A block of 10 N on two feet 2 m apart, μ = 0.5, that is pulled sideways by 3.5 N: put on once, 5 N are held.
    /// let foot = |x: f64, name| Contact::new([x, 0.0], [0.0, 1.0]).name(name).series_stiffness(1000.0, 1000.0).friction(0.5);
    /// let block = Grasp::new([foot(-1.0, "left"), foot(1.0, "right")])?;
    /// let pulled = Wrench::new([3.5, -10.0], 0.0);
    /// assert_eq!(block.hold(pulled)?.sticks(), Some(true));
    ///
    /// // Rocked by 4 N m it leans on one foot and then on the other. The foot that carries 3 N slides, and the other one next time.
    /// let cycle = [4.0, -4.0].map(|rocked| Leg::there_and_back(Wrench::new([0.0, 0.0], rocked))).concat();
    /// let shaken = block.shake(&pulled, &cycle)?;
    /// let words = shaken.to_string();
    /// assert!(words.starts_with("WALKS: the object moves 1 mm along +x in every cycle, left and right slide"), "{words}");
    /// assert_eq!(shaken.stays(), Some(false));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load, [`Error::Contact`] if a command of a leg is not finite or beyond 1e50; [`Error::Size`] if a leg has more or fewer
    /// commands than there are contacts; [`Error::NotClosed`] for a cycle that does not end where it begins.
    #[doc(alias = "shakedown", alias = "ratcheting", alias = "vibration", alias = "cyclic load")]
    pub fn shake(&self, base: impl Into<Wrench<C>>, cycle: &[Leg<C>]) -> Result<Shaken<C>, Error> {
        self.engine.shake(&inside(&base.into()), &all_inside(cycle), &self.settings).map(outside)
    }

    /// Follows a load program in steps from the equilibrium under `start`, for any number of contacts on the round cone, such as a patch under shear
    /// and torsion. `error` is the estimated error that one leg may add to the contact forces, relative to the largest of them, such as 1e-5. A step
    /// costs a few passes over all contacts. The result is the same for any number of threads. The length of a step is proportional to the square
    /// root of `error`. Suction cups keep their vacuum even if their lips open. A path in steps ends as soon as nothing resists the object any more.
    /// The answer is a [`SteppedPath`].
    ///
    /// If no step continues the path, its end is either [lost](crate::load_path::PathEnd::Lost) or [undecided](crate::load_path::PathEnd::Undecided).
    /// It is lost if the speed of the object, per unit of load, grows without bound towards the end. It is also lost if the forces and the motion
    /// have no rates with any combination of states of the contacts whose forces are on the boundaries of their cones.
    ///
    /// In the plane friction forces do not turn: a step errs only if contacts begin to slide, stop, open or close within it.
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
    /// The errors of [`Self::follow`]; [`Error::NotForHands`]; [`Error::KineticFriction`]; [`Error::Argument`] unless `error` is from 1e-9 to 1.
    pub fn follow_in_steps(
        &self,
        start: impl Into<Wrench<C>>,
        legs: &[Leg<C>],
        error: f64,
    ) -> Result<SteppedPath<'_, C>, Error> {
        let path =
            self.engine.follow_in_steps(&inside(&start.into()), &all_inside(legs), error, &self.settings)?;
        Ok(path_outside(path))
    }
}
