//! The contacts of one grasp, checked once and made ready.

use super::block::{Block, Parted};
use super::cone::{OPENS_ONLY, STAYS};
use super::forces::Forces;
use super::lanes::Lanes;
use super::load_cases::LoadCases;
use super::method::Method;
use super::prepared::Prepared;
use super::pull::Pull;
use super::question::{Scenes, ScreeningQuestion};
use super::screened::{Screened, ScreenedTurn};
use super::screened_squeeze::ScreenedSqueeze;
use super::turning_pull::TurningPull;
use crate::error::{Error, Field};
use crate::grasp::{Contact, Hold, assert_plane_or_space};

/// A grasp of `N` contacts, two to five, made ready for the question at which load the first of
/// them stops sticking: what does not depend on the load is done once.
///
/// `D` and `C` are 3 and 2 in the plane, 6 and 3 in space; see
/// [`planar::Fingers`](crate::planar::Fingers) and [`spatial::Fingers`](crate::spatial::Fingers).
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
pub struct Fingers<const D: usize, const C: usize, const N: usize> {
    pub(super) block: Block<C, N, 1>,
    pub(super) parted: Parted<N, 1>,
    ready: Prepared<D, C, N, 1>,
    squeezed: Forces<C, N, 1>,
}

impl<const D: usize, const C: usize, const N: usize> Fingers<D, C, N> {
    /// Checks the contacts and makes them ready. Other numbers of contacts than two to five do not
    /// compile.
    ///
    /// # Errors
    /// [`Error::Contact`] naming the first contact, field and value that is out of range. In space
    /// a contact's stiffness must be equal along both tangents, and no force holds a contact.
    pub fn new(contacts: &[Contact<C>; N]) -> Result<Self, Error> {
        const { assert_plane_or_space::<D, C>() };
        const { assert!(2 <= N && N <= 5, "screening is for two to five contacts") };
        let (mut block, mut parted) = (Block::<C, N, 1>::EMPTY, Parted::EMPTY);
        for (index, contact) in contacts.iter().enumerate() {
            contact.check(index)?;
            let suction = Some(contact.suction).filter(|suction| *suction != 0.0);
            for (field, value) in [(Field::Force, contact.force), (Field::Suction, suction)] {
                if let Some(value) = value {
                    let allowed = "left out: screening knows fingers that hold positions";
                    return Err(Error::Contact { contact: contact.label(index), field, value, allowed });
                }
            }
            let frame = contact.frame(index)?;
            let frictionless = contact.springs() == 1;
            let k = contact.series_stiffness_of_axes();
            let tangential = if frictionless { 0.0 } else { k[1] };
            if C == 3 && !frictionless && k[1] != k[C - 1] {
                return Err(Error::Contact {
                    contact: contact.label(index),
                    field: Field::SeriesStiffness,
                    value: k[C - 1],
                    allowed: "the same along both tangents",
                });
            }
            let mut a = contact.commanded();
            block.pressed[index] = Lanes([a[0] - contact.clearance]);
            parted.commanded[index] = Lanes([a[0]]);
            parted.clearance[index] = Lanes([contact.clearance]);
            a[0] = 0.0;
            if C == 3 {
                a = frame * a;
            } else {
                // Along (n_y, -n_x), whichever way the user's tangent points.
                let turned = frame[(0, 1)] * frame[(1, 0)] - frame[(1, 1)] * frame[(0, 0)];
                a.swap_rows(0, 1);
                a[0] *= turned.signum();
            }
            for axis in 0..C {
                block.point[axis][index] = Lanes([contact.point[axis]]);
                block.normal[axis][index] = Lanes([frame[(axis, 0)]]);
                block.sheared[axis][index] = Lanes([a[axis]]);
            }
            block.springs[0][index] = Lanes([k[0]]);
            block.springs[1][index] = Lanes([tangential]);
            let slides = contact.friction > 0.0 && contact.friction.is_finite();
            block.friction[index] = Lanes([match contact.hold {
                Hold::Bonded => STAYS,
                _ if slides => contact.friction,
                Hold::Unilateral => OPENS_ONLY,
                Hold::KeptClosed => STAYS,
            }]);
        }
        if C == 2 && N == 2 {
            super::pair::to_compliances(&mut block, &mut parted);
        } else if C == 3 && N == 3 {
            super::method::to_compliances(&mut block);
        }
        let way = if Method::Edges.of(&block) == [true] { Method::Edges } else { Method::Motions };
        let ready = Prepared::new(&block, way);
        Ok(Self { squeezed: ready.squeezed(&block), ready, block, parted })
    }

    /// When the first contact stops sticking as the load grows, and which ones do; or why screening
    /// does not know.
    #[must_use]
    #[inline(never)]
    pub fn onset(&self, pull: &Pull<C>) -> Screened {
        self.ask(pull)
    }

    /// At which angle the first contact stops sticking while the load turns, and which ones do; or why
    /// screening does not know.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Fingers, Turn, TurningPull};
    /// use grasp_lcp::screening::ScreeningVerdict;
    ///
    /// // Palms that press with 10 N each hold a box of 12 N that begins on its side.
    /// let palm = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(10.0);
    /// let palms = Fingers::new(&[palm(-1.0), palm(1.0)])?;
    /// let from_its_side = Turn::tilting([12.0, 0.0], [0.0, 0.0]).reversed();
    /// let onset = palms.onset_of_turn(&TurningPull::new(&from_its_side)?);
    /// // 6 sin θ + 3 cos θ = 5 there.
    /// let closed = (5.0 / 45_f64.sqrt()).asin() - 3_f64.atan2(6.0);
    /// assert!((onset.angle().unwrap() - closed).abs() < 1e-14);
    ///
    /// let light = palms.onset_of_turn(&TurningPull::new(&Turn::tilting([0.0, -2.0], [0.0, 0.0]))?);
    /// assert_eq!(light.verdict(), ScreeningVerdict::Never);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    #[inline(never)]
    pub fn onset_of_turn(&self, turn: &TurningPull<C>) -> ScreenedTurn {
        self.ask(turn)
    }

    /// The least common factor of all commands with which every contact touches and sticks under each
    /// of the loads; or why screening does not know. Clearances stay as they are.
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
    #[inline(never)]
    pub fn least_squeeze(&self, cases: &LoadCases<C>) -> ScreenedSqueeze {
        self.ask(cases)
    }

    #[inline(always)]
    fn ask<Q: ScreeningQuestion<D, C>>(&self, question: &Q) -> Q::Answer {
        let Self { block, parted, ready, squeezed } = self;
        let [answer] = question.ask(Scenes { block, parted, ready, squeezed });
        answer
    }
}
