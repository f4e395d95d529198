//! Whether an answer depends on the stiffness of contacts along their tangents.

use super::setup::Setup;
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::inside;

/// Relative change of a number beyond which an answer depends on the stiffness.
const DEPENDS: f64 = 0.05;

impl<const C: usize> Setup<C> {
    /// Indices of the questions whose answers change by more than 5 % if the tangential stiffness of all contacts is a tenth, or ten times as large.
    /// Each question is answered three times (stiffness as given, a tenth, ten times), with the limits of [small
    /// motions](crate::Settings::small_motions).
    ///
    /// # Errors
    /// As for [`Self::answers`].
    pub fn depends_on_tangential_stiffness(&self) -> Result<Vec<usize>, Error> {
        inside(self).where_tangential_springs_matter()
    }
}

impl Setup<3> {
    /// [`Self::depends_on_tangential_stiffness`] of a setup whose vectors have three components, even if it is planar.
    fn where_tangential_springs_matter(&self) -> Result<Vec<usize>, Error> {
        let (softer, stiffer) = (self.with_tangential(0.1)?, self.with_tangential(10.0)?);
        let trial = |trial: usize| if trial == 1 { softer.clone() } else { stiffer.clone() };
        self.questions_that_depend(&trial, &Grasp::clone, &|_| false, DEPENDS)
    }

    /// This setup with the tangential stiffness of each contact multiplied by `times`.
    #[cfg_attr(
        not(feature = "mesh"),
        allow(clippy::unnecessary_wraps, reason = "a pad on a mesh can be faulty")
    )]
    fn with_tangential(&self, times: f64) -> Result<Self, Error> {
        let mut setup = self.clone();
        let of_fingers = setup.fingers.iter_mut().flat_map(|finger| &mut finger.contacts);
        for entry in setup.contacts.iter_mut().chain(of_fingers) {
            #[cfg(feature = "mesh")]
            if let Some(touches) = &mut entry.touches
                && let Some([normal, tangential]) = touches.pad()?.stiffness()
            {
                touches.layer = None;
                entry.contact = entry.contact.clone().series_stiffness(normal, tangential);
            }
            let mut springs = entry.contact.series_stiffness_of_axes();
            for axis in 1..3 {
                springs[axis] *= times;
            }
            entry.contact = entry.contact.clone().series_stiffness_axes(springs);
        }
        Ok(setup)
    }
}
