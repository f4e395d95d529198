//! Grasps by hands read from a file: how many coordinates they have is known when they are read.
//!
//! A [`Grasp`] says its coordinates in its type. Of the sizes compiled here the first that is large enough is taken; what is
//! left over is held, at some cost in time and none in the answer.

use super::setup::Setup;
use crate::error::Error;
use crate::grasp::Grasp;

/// Coordinates of small hands: four fingers of two joints in space.
const SMALL: usize = 16;
/// Coordinates of large hands: 24 joints in space, all of which may stall.
const LARGE: usize = 56;

/// Something that is done with the grasp of a [`Setup`], however many coordinates it has; see [`Setup::with_grasp`].
pub trait WithGrasp<const C: usize> {
    /// What comes of it.
    type Output;
    /// Does it. The grasp has `W` coordinates.
    fn with<const W: usize>(self, grasp: &Grasp<W, C>) -> Self::Output;
}

/// Whether the grasp can be built is all that is asked.
struct Built;

impl<const C: usize> WithGrasp<C> for Built {
    type Output = ();
    fn with<const W: usize>(self, _: &Grasp<W, C>) {}
}

impl<const D: usize, const C: usize> Setup<D, C> {
    /// Whether the hand that holds the object can be built, and is one of those compiled here.
    pub(super) fn check_hand(&self) -> Result<(), Error> {
        self.with_grasp(Built)
    }

    /// Does something with the grasp: for scenes with and without a hand alike.
    ///
    /// ```
    /// use grasp_lcp::grasp::Grasp;
    /// use grasp_lcp::planar::hand::{Joint, Wrench};
    /// use grasp_lcp::planar::Contact;
    /// use grasp_lcp::scene::{Finger, Setup, WithGrasp};
    ///
    /// /// The torques that the joints need to hold a load of 1 N.
    /// struct Torques;
    /// impl WithGrasp<2> for Torques {
    ///     type Output = Result<Vec<f64>, grasp_lcp::Error>;
    ///     fn with<const W: usize>(self, grasp: &Grasp<W, 2>) -> Self::Output {
    ///         let outcome = grasp.solve(&Wrench::force([-1.0, 0.0]))?;
    ///         let joints = outcome.equilibrium().map(|state| state.joints.iter().map(|joint| joint.torque).collect());
    ///         Ok(joints.unwrap_or_default())
    ///     }
    /// }
    ///
    /// let jaw = |side: f64| {
    ///     let slide = Joint::prismatic([-side, 0.0]).stiffness(1e3).command(0.01);
    ///     Finger::new([slide]).contact(Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e6, 1e6).friction(0.5))
    /// };
    /// let torques = Setup::<3, 2>::new([]).finger(jaw(-1.0)).finger(jaw(1.0)).with_grasp(Torques)??;
    /// assert!((torques[0] - torques[1] - 1.0).abs() < 1e-12);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::grasp`]; [`Error::Coordinates`] for a hand of more than 56 coordinates.
    pub fn with_grasp<V: WithGrasp<C>>(&self, what: V) -> Result<V::Output, Error> {
        if !self.is_held_by_a_hand() {
            return Ok(what.with(&self.grasp()?));
        }
        let needed = self.hand()?.coordinates();
        if needed <= SMALL {
            Ok(what.with(&self.grasp_by_hand::<SMALL>()?))
        } else if needed <= LARGE {
            Ok(what.with(&self.grasp_by_hand::<LARGE>()?))
        } else {
            Err(Error::Coordinates { given: LARGE, needed })
        }
    }
}
