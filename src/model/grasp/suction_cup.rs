//! Suction cups: a lip (the rim), and the vacuum inside it.

use core::f64::consts::PI;

use super::contact::Contact;
use super::fingertip::{SoftFingertip, check};
use crate::error::{Error, LARGEST};
use crate::prelude::*;

/// A suction cup: a vacuum pulls the object onto a lip. The lip is a ring of points that share the stiffness and friction of one contact.
///
/// The vacuum acts between cup and object with a constant force V while the lip is closed. It is not part of the caller's load: the load of an
/// object that hangs from a cup is its weight alone. The lip presses with V less the pull on the object. With the radius R and the friction
/// coefficient μ, the lip first opens or slides, under a load of one kind alone, at
///
/// | load | value at first opening or slip | mode |
/// |---|---|---|
/// | a force away from the cup | V | the whole lip opens |
/// | a force in the plane of the lip | μ V | the whole lip slides |
/// | a moment about an axis in the plane of the lip | V R/2 | one point opens |
/// | a moment about the normal | μ V R | the whole lip slides |
///
/// A real lip lets air in as soon as its first point opens. In this model the vacuum is lost when the whole lip is open:
///
/// | question | answer |
/// |---|---|
/// | [`hold`](crate::ask::Grasp::hold), [`need`](crate::ask::Grasp::need) | the cup lets go ([`WayOut::LetsGo`](crate::hold::WayOut::LetsGo)), and the object is lost |
/// | [`follow`](crate::ask::Grasp::follow), maps of held loads | the path ends ([`LossKind::LetsGo`](crate::load_path::LossKind::LetsGo)) |
/// | [`onset`](crate::ask::Grasp::onset), also of a turn | [`beyond`](crate::ask::Grasp::beyond) returns [`Beyond::WithoutVacuum`](crate::load_path::Beyond::WithoutVacuum) |
/// | [`solve`](crate::ask::Grasp::solve) and every equilibrium | [`open_cups`](crate::equilibrium::Equilibrium::open_cups) lists the cup: the equilibrium fails |
/// | [`least_squeeze`](crate::ask::Grasp::least_squeeze), the [weakest direction](crate::ask::Grasp::weakest_direction), the
/// [reserve](crate::ask::Grasp::reserve) | cannot occur: every lip touches and sticks in these answers |
/// | [`statics`](crate::ask::Statics) | limits include the vacuum forces; closure by cups alone is an error |
/// | [`follow_in_steps`](crate::ask::Grasp::follow_in_steps) | not detected: the vacuum stays on; check the contact states |
///
/// ```
/// use grasp_lcp::spatial::{Contact, Grasp, SuctionCup, Wrench};
///
/// // A cup of 40 mm at 60 kPa on top of a plate of 2 kg.
/// let lip = Contact::new([0.0; 3], [0.0, 0.0, -1.0]).name("cup").series_stiffness(8e3, 4e3).friction(0.5);
/// let cup = SuctionCup::of_pressure(0.02, 12, 60e3)?;
/// assert!((cup.force() - 75.398).abs() < 1e-3);
/// let plate = Grasp::new(cup.contacts(&lip)?)?;
/// let hangs = plate.hold(Wrench::force([0.0, 0.0, -19.62]))?;
/// assert_eq!(hangs.to_string(), "HOLDS, everything sticks: 75.3982 N (3.84292 times this load) until it is lost, as cup opens");
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SuctionCup {
    lip: SoftFingertip<3>,
    force: f64,
}

impl SuctionCup {
    /// A cup whose lip is a ring of this radius (m) with `points` points. The vacuum pulls with this force (N): the pressure difference times
    /// the area within the lip, or a measured force.
    ///
    /// # Errors
    /// [`Error::Fingertip`] unless the radius is from 1e-50 to 1e50, the points are from 3 to [`SoftFingertip::MOST_POINTS`], and the force is from 0
    /// to 1e50.
    pub fn of_force(radius: f64, points: usize, force: f64) -> Result<Self, Error> {
        check((0.0..=LARGEST).contains(&force), "force of the vacuum", force, "from 0 to 1e50")?;
        Ok(Self { lip: SoftFingertip::ring(radius, points)?, force })
    }

    /// A cup with this pressure below ambient, Pa. Its vacuum force is `π R²` times the pressure, N.
    ///
    /// # Errors
    /// [`Error::Fingertip`] unless the radius is from 1e-50 to 1e50, the points are from 3 to [`SoftFingertip::MOST_POINTS`], and the pressure and
    /// the force are from 0 to 1e50.
    pub fn of_pressure(radius: f64, points: usize, pressure: f64) -> Result<Self, Error> {
        check((0.0..=LARGEST).contains(&pressure), "pressure of the vacuum", pressure, "from 0 to 1e50")?;
        Self::of_force(radius, points, PI * radius * radius * pressure)
    }

    /// Force of the vacuum, N.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.force
    }

    /// The lip of the cup, a ring of contact points.
    #[must_use]
    pub fn lip(&self) -> &SoftFingertip<3> {
        &self.lip
    }

    /// The points of the lip, which share the springs of `contact` and the vacuum force.
    ///
    /// # Errors
    /// [`Error::Contact`] with index 0 if `contact` has a number that is out of range.
    pub fn contacts(&self, contact: &Contact<3>) -> Result<Vec<Contact<3>>, Error> {
        self.lip.contacts(&contact.clone().suction(self.force))
    }
}
