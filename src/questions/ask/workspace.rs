//! Scratch buffers for computing the load factors of many first slips, one after another, in loops that must not wait for an allocator. At first slip
//! the first contact ceases to stick. On a ramp a load, commands of fingers, or both change in proportion to a load factor, in addition to a constant
//! base load. The engine computes with vectors of three components, also in the plane.

use super::grasp::Grasp;
use crate::equilibrium::Settings;
use crate::error::Error;
use crate::grasp::{Wrench, outside};
use crate::load_path::{Onset, Ramp};
use crate::numerics::Memory;

/// Scratch buffers for computing the load factors of many first slips, one after another, in loops that must not wait for an allocator. Grasp and
/// ramp may differ from call to call. The answers equal those of [`Grasp::onset`].
///
/// From the second call on nothing is allocated if the grasp has no more contacts than before, and a single contact ceases to stick first. Buffers
/// are allocated if the forces of several contacts reach the boundaries of their cones together up to rounding, or a gap closes before first slip.
/// They are also allocated if a contact slides under the base load, or sticks there only up to rounding. In these cases contact states have to be
/// searched for. The first call with a grasp allocates its factorised matrices; with more than 256 contacts every call does.
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, OnsetWorkspace, Ramp, Wrench};
///
/// // A box between two fingers of which the second rubs less. Whatever it weighs, it slides there first.
/// let finger = |x: f64, mu: f64| {
///     Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(mu).command([0.01, 0.0])
/// };
/// let grasp = Grasp::new([finger(-1.0, 0.5), finger(1.0, 0.4)])?;
/// let mut workspace = OnsetWorkspace::default();
/// for weight in [1.0, 2.0, 4.0] {
///     let onset = workspace.onset(&grasp, &Ramp::load(Wrench::ZERO, Wrench::force([0.0, -weight])))?;
///     let event = onset.event().expect("slides");
///     assert!((event.factor - 8.0 / weight).abs() < 1e-14);
///     assert_eq!(event.leaving[0].contact.index, 1);
/// }
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct OnsetWorkspace<const C: usize> {
    settings: Settings,
    memory: Memory,
    /// The last answer with vectors of `C` components; `kept` is the same answer with the three components of the engine.
    returned: Option<Onset<C>>,
    kept: Option<Onset<3>>,
    /// The last ramp, with the three components of the engine. The next ramp is written into its buffers.
    ramp: Option<Ramp<3>>,
}

impl<const C: usize> OnsetWorkspace<C> {
    /// A workspace without allocated buffers, for answers with these settings.
    #[must_use]
    pub fn new(settings: Settings) -> Self {
        Self { settings, ..Self::default() }
    }

    /// The load factor of first slip of a grasp along a ramp, computed like [`Grasp::onset`] but with the settings of the workspace. The reference is
    /// valid until the next call; clone the answer to keep it.
    ///
    /// # Errors
    /// The errors of [`Grasp::onset`].
    pub fn onset(&mut self, grasp: &Grasp<C>, ramp: &Ramp<C>) -> Result<&Onset<C>, Error> {
        if let (Some(Onset::At(returned)), Some(Onset::At(kept))) = (&mut self.returned, &mut self.kept) {
            returned.exchange(kept);
        }
        let kept = self.kept.take();
        let inside = self.ramp.get_or_insert_with(|| Ramp::load(Wrench::ZERO, Wrench::ZERO));
        ramp.enter_into(inside);
        let onset = grasp.engine.onset_in(inside, &self.settings, &mut self.memory, kept)?;
        let onset = self.kept.insert(onset);
        match (&mut self.returned, onset) {
            (Some(Onset::At(returned)), Onset::At(kept)) => returned.replace_with(kept),
            (returned, onset) => *returned = Some(outside(onset.clone())),
        }
        Ok(self.returned.get_or_insert(Onset::Never))
    }
}
