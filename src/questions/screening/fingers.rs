//! One grasp, checked and prepared for screening: all that does not depend on the load is computed once. Screening computes the load factor of first
//! slip, at which the first contact ceases to stick. A command is the displacement that a finger would make if there were no object. A clearance is
//! the gap between finger and object before the command; it is negative if they overlap. The verdict says why there is no load factor, for example
//! because a contact does not stick before the load grows.

use super::block::MOST_SCREENED;
use super::gradient::GradientOf;
use super::gradient_row::GradientRow;
use super::kernels::Kernels;
use super::load_cases::LoadCases;
use super::one_grasp::OneGrasp;
use super::pull::Pull;
use super::screened::Screened;
use super::screened_gradient::ScreenedGradients;
use super::screened_squeeze::ScreenedSqueeze;
use crate::error::Error;
use crate::grasp::Contact;
use crate::prelude::*;

/// A grasp of `N` contacts, two to five, prepared for screening. The contact forces due to the commands and the factorised stiffness are computed
/// once for all loads.
///
/// `C` is 2 in the plane ([`planar::Fingers`](crate::planar::Fingers)) and 3 in space ([`spatial::Fingers`](crate::spatial::Fingers)).
///
/// ```
/// use grasp_lcp::planar::{Contact, Fingers, Pull, Wrench};
///
/// let jaw = |side: f64| {
///     Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).command([0.01, 0.0])
/// };
/// let fingers = Fingers::new(&[jaw(-1.0), jaw(1.0)])?;
/// // Each jaw presses with 10 N and holds half of what hangs on it.
/// let onset = fingers.onset(&Pull::new(&Wrench::ZERO, &Wrench::force([0.0, -1.0]))?);
/// assert!((onset.factor().unwrap() - 10.0).abs() < 1e-13);
/// assert!(onset.leaving().eq([0, 1]));
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Fingers<const C: usize, const N: usize> {
    pub(super) grasp: OneGrasp<C>,
}

impl<const C: usize, const N: usize> Fingers<C, N> {
    /// The grasp with these contacts, checked and prepared for screening. With fewer than two or more than five contacts, the call does not compile.
    ///
    /// # Errors
    /// [`Error::Contact`] naming the first contact, field and value that is out of range. In space the stiffness of a contact must be equal along
    /// both tangents. A contact must not have a given constant force or suction.
    pub fn new(contacts: &[Contact<C>; N]) -> Result<Self, Error> {
        const { assert!(2 <= N && N <= MOST_SCREENED, "screening is for two to five contacts") };
        (Kernels::get().prepare)(contacts).map(|grasp| Self { grasp })
    }

    /// The load factor at which the first contact ceases to stick as the load grows, and the contacts that cease to stick at this factor. If
    /// screening has no factor, the verdict says why.
    #[must_use]
    pub fn onset(&self, pull: &Pull<C>) -> Screened {
        Kernels::get().pull.ask(&self.grasp, pull)
    }

    /// Derivatives of the load factor of first slip with respect to all data of the grasp and the load. There is one gradient for each contact that
    /// ceases to stick at first slip, in rising order of contacts. The list is empty if [`Self::onset`] has no load factor.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Fingers, Pull, Wrench};
    ///
    /// let jaw = |side: f64| {
    ///     Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).command([0.01, 0.0])
    /// };
    /// let fingers = Fingers::new(&[jaw(-1.0), jaw(1.0)])?;
    /// let gradients = fingers.onset_gradients(&Pull::new(&Wrench::ZERO, &Wrench::force([0.0, -1.0]))?);
    /// // Each jaw presses with 10 N. Both leave together, at 2 μ N: each by its own friction.
    /// assert_eq!(gradients.len(), 2);
    /// for (jaw, gradient) in gradients.iter().enumerate() {
    ///     assert!(gradient.is_one_sided() && gradient.contact() == Some(jaw));
    ///     assert!((gradient.friction(jaw) - 20.0).abs() < 1e-12 && gradient.friction(1 - jaw) == 0.0);
    /// }
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn onset_gradients(&self, pull: &Pull<C>) -> ScreenedGradients<C> {
        let numbers = GradientRow::<C>::numbers(N);
        let leaving: Vec<usize> = self.onset(pull).leaving().collect();
        let mut gradients = vec![f64::NAN; leaving.len() * numbers];
        for (row, contact) in gradients.chunks_exact_mut(numbers).zip(leaving) {
            let question = GradientOf { pull: *pull, contact: Some(contact) };
            (Kernels::get().gradient.one)(&self.grasp, &question, row);
        }
        ScreenedGradients { contacts: N, numbers: gradients }
    }

    /// Derivatives of the load factor of first slip, written into storage that is reused. Afterwards `gradients` holds only the first gradient of
    /// [`Self::onset_gradients`]; it is NaN if there is no load factor. Nothing is allocated if `gradients` held as many numbers before.
    pub fn onset_gradient_into(&self, pull: &Pull<C>, gradients: &mut ScreenedGradients<C>) {
        gradients.contacts = N;
        gradients.numbers.clear();
        gradients.numbers.resize(GradientRow::<C>::numbers(N), f64::NAN);
        let question = GradientOf { pull: *pull, contact: None };
        (Kernels::get().gradient.one)(&self.grasp, &question, &mut gradients.numbers);
    }

    /// The least factor s for which, with all commands multiplied by s, every contact touches and sticks under each of the loads. Clearances are not
    /// scaled. If screening has no factor, the verdict says why.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Fingers, LoadCases, Wrench};
    ///
    /// // Palms that press with 1 N each, μ = 0.5. Upright 12 N need 12 times as much: 6 N of friction at each. On its side 6 N of
    /// // squeeze are enough.
    /// let palm = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(1.0);
    /// let palms = Fingers::new(&[palm(-1.0), palm(1.0)])?;
    /// let cases = LoadCases::new(&[Wrench::force([-12.0, 0.0]), Wrench::force([0.0, -12.0])])?;
    /// let squeeze = palms.least_squeeze(&cases);
    /// assert!((squeeze.factor().unwrap() - 12.0).abs() < 1e-13);
    /// assert_eq!(squeeze.binding().unwrap().1, 1);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn least_squeeze(&self, cases: &LoadCases<C>) -> ScreenedSqueeze {
        Kernels::get().load_cases.ask(&self.grasp, cases)
    }
}
