//! Whether an answer depends on the tangential stiffness of contacts. A setup is a grasp with its questions. A motion counts as small as long as it
//! stays within the limits up to which the linear theory is trusted.

use super::setup::Setup;
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::inside;

/// Relative change of any number of an answer beyond which the answer counts as dependent on the tangential stiffness.
const DEPENDS: f64 = 0.05;

impl<const C: usize> Setup<C> {
    /// Indices of the questions whose answers change by more than 5 % if tangential stiffnesses change. In the first trial the tangential stiffness
    /// of all contacts is divided by ten, in the second it is multiplied by ten. In each further trial that of a single contact is multiplied by ten.
    /// The limits of [small motions](crate::Settings::small_motions) stay in force in all trials.
    ///
    /// # Errors
    /// An [`Error`] for a malformed setup or question.
    pub fn depends_on_tangential_stiffness(&self) -> Result<Vec<usize>, Error> {
        inside(self).where_tangential_springs_matter()
    }
}

impl Setup<3> {
    /// Indices of the questions whose answers depend on the tangential stiffness, in the plane or in space. Vectors have three components; in the
    /// plane the third is zero.
    fn where_tangential_springs_matter(&self) -> Result<Vec<usize>, Error> {
        // If the tangential stiffness of all contacts changes alike, they share a tangential load as before. One contact that is stiffer than the
        // others takes more of this load, so each contact is also made stiffer alone.
        let mut trials = vec![self.with_tangential(0.1, &|_| true)?, self.with_tangential(10.0, &|_| true)?];
        for contact in 0..self.entries().count() {
            trials.push(self.with_tangential(10.0, &|i| i == contact)?);
        }
        self.questions_that_depend(&trials, &Grasp::clone, &|_| false, DEPENDS)
    }

    /// This setup, in which the tangential stiffness of some contacts is multiplied by `times`. `is_meant` selects these contacts by their index.
    #[cfg_attr(
        not(feature = "mesh"),
        allow(clippy::unnecessary_wraps, reason = "a pad on a mesh can be faulty")
    )]
    fn with_tangential(&self, times: f64, is_meant: &dyn Fn(usize) -> bool) -> Result<Self, Error> {
        let mut setup = self.clone();
        let of_fingers = setup.fingers.iter_mut().flat_map(|finger| &mut finger.contacts);
        let all = setup.contacts.iter_mut().chain(of_fingers).enumerate();
        for (_, entry) in all.filter(|(index, _)| is_meant(*index)) {
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
