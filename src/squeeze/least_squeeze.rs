//! The least factor of the commands with which everything rolls under a set of loads.

use super::loads::Loads;
use super::parts::{Condition, Parts};
use super::rolling::Rolling;
use crate::error::Error;
use crate::grasp::{Grasp, Twist, Wrench};
use crate::search::Settings;

/// Each cut raises the factor, by a part that soon is squared; more of them are made by rounding.
const MOST_CUTS: usize = 1000;

/// The answer to "how much squeeze do I need?"
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum LeastSqueeze<const D: usize, const C: usize> {
    /// With the commands of the grasp times this factor everything touches and rolls under every load; with less something does not.
    #[non_exhaustive]
    Factor {
        /// At least zero, exact up to rounding.
        factor: f64,
        /// The contact that stands on the edge of its cone then, from 0, and the load under which it does; `None` if no squeeze is needed.
        binding: Option<(usize, Wrench<D, C>)>,
    },
    /// No factor suffices. Under this load the contact does not roll with this factor, nor with any larger one; smaller ones do not do for another
    /// load or contact.
    #[non_exhaustive]
    NoFactor {
        /// The contact, from 0.
        contact: usize,
        /// The load.
        load: Wrench<D, C>,
        /// What other conditions need at least.
        factor: f64,
    },
    /// Some load works on this motion, which nothing resists however much the fingers press.
    GivesWay {
        /// A unit motion of the object.
        motion: Twist<D, C>,
    },
    /// Rounding keeps the search from ending.
    Undecided,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The least common factor of all finger commands with which every contact touches and rolls under each of a set of loads. On the round
    /// cone in space, with default [`Settings`].
    ///
    /// Every condition is linear in the factor or concave, so what suffices is an interval. A condition that is broken at one factor gives
    /// another that is needed at least, where the next step begins: what is needed and what suffices meet in one number. Clearances stay as
    /// they are.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, LeastSqueeze, Loads, Turn, Wrench};
    ///
    /// // Two palms that press with 1 N each, μ = 0.5, hold a box. Carried upright, 12 N need 12 times as much: 6 N of friction at each.
    /// let palm = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(1.0);
    /// let palms = Grasp::new([palm(-1.0), palm(1.0)])?;
    /// let needed = |loads: Loads| match palms.least_squeeze(&loads)? {
    ///     LeastSqueeze::Factor { factor, .. } => Ok::<f64, grasp_lcp::Error>(factor),
    ///     other => panic!("{other:?}"),
    /// };
    /// assert!((needed(Loads::Each(vec![Wrench::force([0.0, -12.0])]))? - 12.0).abs() < 1e-14);
    /// // Turned over it needs more, where a palm is half below: F_t = 6 cos θ, F_n = s - 6 sin θ.
    /// let turned = needed(Loads::Turn(Turn::tilting([0.0, -12.0], [0.0, 0.0])))?;
    /// assert!((turned - 180_f64.sqrt()).abs() < 1e-13);
    /// // So it does for 12 N of any direction.
    /// let any = Loads::AnyForce { base: Wrench::ZERO, size: 12.0, point: [0.0, 0.0] };
    /// assert!((needed(any)? - turned).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load, [`Error::Argument`] if another number of the set is out of range or the set is empty.
    /// [`Error::NotForHands`] for a grasp by a hand.
    pub fn least_squeeze(&self, loads: &Loads<D, C>) -> Result<LeastSqueeze<D, C>, Error> {
        self.least_squeeze_with(loads, &Settings::default())
    }

    /// The same with other [`Settings`], which say for which cone.
    ///
    /// # Errors
    /// As for [`Self::least_squeeze`].
    pub fn least_squeeze_with(
        &self,
        loads: &Loads<D, C>,
        settings: &Settings,
    ) -> Result<LeastSqueeze<D, C>, Error> {
        self.refuse_hands("least_squeeze")?;
        loads.check(self)?;
        let rolling = Rolling::new(self, settings);
        let parts = match Parts::of(&rolling, loads) {
            Ok(parts) => parts,
            Err(motion) => return Ok(LeastSqueeze::GivesWay { motion }),
        };
        let (mut factor, mut binding) = (0.0, None);
        for _ in 0..MOST_CUTS {
            let Some((contact, Condition { row, value, load, .. })) = parts.broken(&rolling, factor) else {
                return Ok(LeastSqueeze::Factor { factor, binding });
            };
            let gain = parts.gain(contact, &row);
            if gain <= 0.0 {
                return Ok(LeastSqueeze::NoFactor { contact, load, factor });
            }
            let next = factor - value / gain;
            if next.is_nan() || next <= factor {
                break;
            }
            (factor, binding) = (next, Some((contact, load)));
        }
        Ok(LeastSqueeze::Undecided)
    }
}
