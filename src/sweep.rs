//! Many questions at once: answers in the order of the questions, the same bits for any number of threads.
//!
//! Every question is answered on its own by the same serial code; threads (feature `parallel`, rayon's global pool) only
//! decide who does which. Besides this room only the sums over very many contacts of one scene know of threads, and give the same bits, too.

mod progress;
mod uncertainty;

pub use progress::{Progress, map_watched};
pub use uncertainty::Uncertainty;

use crate::equilibrium::{Outcome, Settings};
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::load_path::{Onset, Ramp};
use crate::screening::{Batch, Part, Pull, Screened};

/// Blocks of scenes that one thread screens in one go.
const BLOCKS: usize = 256;

/// `f` of every item, answers in the order of the items: in parallel with the feature `parallel`, one after the other without it.
/// A panic in `f` goes on to the caller.
///
/// ```
/// let squares = grasp_lcp::sweep::map_in_order(&[1, 2, 3], |x| x * x);
/// assert_eq!(squares, [1, 4, 9]);
/// ```
pub fn map_in_order<T: Sync, R: Send>(items: &[T], f: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        items.par_iter().map(f).collect()
    }
    #[cfg(not(feature = "parallel"))]
    {
        items.iter().map(f).collect()
    }
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The equilibria under many loads, each that of [`Self::solve_with`], in the order of the loads; an error in one does not stop the rest.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::Settings;
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let loads = [3.0, 30.0].map(|weight| Wrench::force([0.0, -weight]));
    /// let outcomes = grasp.solve_each(&loads, &Settings::default()).into_iter().collect::<Result<Vec<_>, _>>()?;
    /// assert_eq!([true, false], [0, 1].map(|i| outcomes[i].equilibrium().is_some()));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn solve_each(&self, loads: &[Wrench<D>], settings: &Settings) -> Vec<Result<Outcome<D, C>, Error>> {
        map_in_order(loads, |load| self.solve_with(load, settings))
    }

    /// The onsets of sliding along many ramps, each that of [`Self::onset`], in the order of the ramps; an error in one does not stop the
    /// rest.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    /// use grasp_lcp::Settings;
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let tilted = |angle: f64| Ramp::load(Wrench::ZERO, Wrench::force([angle.sin(), -angle.cos()]));
    /// let onsets = grasp.onset_each(&[tilted(0.0), tilted(0.5)], &Settings::default());
    /// let factors = onsets.into_iter().map(|onset| onset.map(|o| o.factor().expect("slides"))).collect::<Result<Vec<_>, _>>()?;
    /// // The contact that the pull relieves slides first: W cos φ / 2 = μ (10 - W sin φ / 2).
    /// assert!((factors[1] - 10.0 / (0.5_f64.cos() + 0.5 * 0.5_f64.sin())).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn onset_each(&self, ramps: &[Ramp<D, C>], settings: &Settings) -> Vec<Result<Onset<D, C>, Error>> {
        map_in_order(ramps, |ramp| self.onset(ramp, settings))
    }
}

/// The onsets of sliding of many grasps along one ramp, each that of [`Grasp::onset`], in the order of the grasps; an error in one does
/// not stop the rest.
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
/// use grasp_lcp::sweep::onset_of_each;
/// use grasp_lcp::Settings;
///
/// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N: they slide at 2 μ N.
/// let frictions = [0.2, 0.4, 0.8];
/// let pinch = |mu: f64| {
///     let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(mu).command([0.01, 0.0]);
///     Grasp::new([finger(-1.0), finger(1.0)])
/// };
/// let grasps = frictions.into_iter().map(pinch).collect::<Result<Vec<_>, _>>()?;
/// let weight = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
/// for (onset, mu) in onset_of_each(&grasps, &weight, &Settings::default()).into_iter().zip(frictions) {
///     assert!((onset?.factor().expect("slides") - 2.0 * mu * 10.0).abs() < 1e-13);
/// }
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[must_use]
pub fn onset_of_each<const D: usize, const C: usize>(
    grasps: &[Grasp<D, C>],
    ramp: &Ramp<D, C>,
    settings: &Settings,
) -> Vec<Result<Onset<D, C>, Error>> {
    map_in_order(grasps, |grasp| grasp.onset(ramp, settings))
}

/// When the first contact of each grasp of a batch leaves rolling as each of the loads grows: [`Batch::onsets_into`] on all cores. The answers come
/// grasp by grasp, for each in the order of the loads. `answers` is cleared first; its memory is used again. [`Batch`] has an example.
pub fn onsets_of_batch<const D: usize, const C: usize, const N: usize>(
    batch: &Batch<D, C, N>,
    pulls: &[Pull<D>],
    answers: &mut Vec<Screened>,
) {
    let parts = batch.parts(pulls, BLOCKS, answers);
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        let parts: Vec<_> = parts.collect();
        parts.into_par_iter().for_each(Part::screen);
    }
    #[cfg(not(feature = "parallel"))]
    parts.for_each(Part::screen);
}
