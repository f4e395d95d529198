//! The onset of sliding while a load turns.
//!
//! While everything rolls, `F(θ) = F⁰ + F^c cos θ + F^s sin θ`: three linear solves. A contact reaches the edge of its cone where its
//! margin, a trigonometric polynomial, first falls below zero: one of degree one for each facet, one of degree two on the round cone.

use super::course::Course;
use super::first_to_leave::{WhileTurning, first_to_leave_on_turn};
use super::onset::Onset;
use super::onset_workspace::OnsetMemory;
use super::turn::{Touch, Turn};
use crate::error::Error;
use crate::grasp::Grasp;
use crate::search::Settings;

/// The answer to "at which angle does the first contact leave rolling?"
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct TurnOnset<const D: usize, const C: usize> {
    /// When that is; its factor is the angle, rad. [`Onset::Never`] holds for the angle that was asked for.
    pub onset: Onset<D, C>,
    /// Where contacts come as near to the edge of their cone as rounding without crossing it, up to the onset. Where there are some, the last
    /// digits of the question may make one of them the onset.
    pub touches: Vec<Touch>,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The angle at which the first contact leaves rolling while a load turns, with default [`Settings`]: in the plane exact, in space on
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
    pub fn onset_of_turn(&self, turn: &Turn<D, C>) -> Result<TurnOnset<D, C>, Error> {
        self.onset_of_turn_with(turn, &Settings::default())
    }

    /// The same with other [`Settings`], which say for which cone.
    ///
    /// # Errors
    /// As for [`Self::onset_of_turn`].
    pub fn onset_of_turn_with(
        &self,
        turn: &Turn<D, C>,
        settings: &Settings,
    ) -> Result<TurnOnset<D, C>, Error> {
        turn.check()?;
        let inside = turn.inside(self);
        let mut memory = OnsetMemory::default();
        memory.change = self.drive_changes(None, None);
        let segment = memory.segment(self, settings, Course::Turn { load: inside, angle: 1.0 });
        if let Some(happens) = first_to_leave_on_turn(&segment, turn, &inside) {
            let onset = match happens {
                WhileTurning::Never => Onset::Never,
                WhileTurning::First(first) => {
                    let load = turn.load_at(first.factor);
                    first.onset(segment, load, &mut memory)
                }
            };
            return Ok(TurnOnset { onset, touches: Vec::new() });
        }
        let course = Course::Turn { load: turn.load, angle: 1.0 };
        Ok(self.walked(segment, (course, turn.angle), settings))
    }
}
