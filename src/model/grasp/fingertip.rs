//! Soft fingertips: contacts that extend over a patch.
//!
//! A point contact carries no moment, so an object between two of them turns freely about the line through them. A fingertip touches over a patch and
//! resists moments. The patch is a set of point contacts in the tangent plane that share the springs of the contact that they replace. All questions
//! about contacts therefore apply to fingertips. The engine of the crate computes with vectors of three components, also in the plane.

use core::f64::consts::TAU;

use nalgebra::SVector;

use super::contact::Contact;
use super::face::{Face, face_of_struct, inside, outside};
use super::pressure::{Layer, Pressure};
use crate::error::{Error, LARGEST};
use crate::numerics::{Reals, Space, indexed, largest, mapped, moved};
use crate::prelude::*;

/// A patch of point contacts that models one fingertip; its stiffness and friction limits have closed forms.
///
/// `C` is the number of axes: 2 in the plane, 3 in space; use the short names in [`crate::planar`] and [`crate::spatial`]. [`Self::contacts`]
/// replaces a contact by the patch.
///
/// Point i has the fraction w_i of stiffness and load, `Σ w_i = 1`, and the position ρ_i relative to the centre. With r_i = |ρ_i| the mean of a
/// quantity f is `⟨f⟩ = Σ w_i f(ρ_i)`. The fingertip has the normal and tangential stiffness k_n, k_t (N/m), the radius R (m) and the coefficient of
/// friction μ. It is pressed with the normal force N (N).
///
/// In space:
///
/// | | formula | ring | disc: uniform | parabolic | Hertz |
/// |---|---|---|---|---|---|
/// | normal, tangential stiffness, N/m | k_n, k_t | | | | |
/// | torsional stiffness, N m/rad | k_t ⟨r²⟩ | k_t R² | k_t R²/2 | k_t R²/3 | 2/5 k_t R² |
/// | first sliding under torsion, N m | μ N ⟨r²⟩/R | μ N R | μ N R/2 | μ N R/3 | 2/5 μ N R |
/// | torsional friction limit, N m | μ N ⟨r⟩ | μ N R | 2/3 μ N R | 8/15 μ N R | 3π/16 μ N R |
/// | tilting stiffness, N m/rad | k_n ⟨r²⟩/2 | k_n R²/2 | k_n R²/4 | k_n R²/6 | k_n R²/5 |
/// | first opening under tilting, N m | N ⟨r²⟩/2R | N R/2 | N R/4 | N R/6 | N R/5 |
///
/// For a rectangle with sides a and b under uniform pressure, see its [constructor](SoftFingertip::rectangle).
///
/// In the plane, for a pad of width 2b, with the coordinate x along the tangent:
///
/// | | formula | pair | pad: uniform | parabolic | Hertz |
/// |---|---|---|---|---|---|
/// | turning stiffness, N m/rad | k_n ⟨x²⟩ | k_n b² | k_n b²/3 | k_n b²/5 | k_n b²/4 |
/// | first opening, N m | N ⟨x²⟩/b | N b | N b/3 | N b/5 | N b/4 |
///
/// The tables give the values of the continuum. Patches of points agree with these values to rounding, even the coarsest patches. Every annulus of a
/// disc has its exact share of the load, of ⟨r⟩ and of ⟨r²⟩. One layer of points lies on the rim (see [`Pressure`]). If the tangential stiffnesses
/// k_1 and k_2 differ, their mean replaces k_t in the torsional stiffness. First sliding then comes earlier, by up to the factor mean/max(k_1, k_2).
///
/// Under torsion slip starts at the rim and spreads inwards: at an angle θ all points beyond `r_s = μ N / (k_t θ)` slide. On the uniform disc
/// the moment is `M = μ N R (2/3 - (r_s/R)³/6)`. The continuum reaches its friction limit only asymptotically; a patch of points reaches it when
/// its innermost ring slides. In between, the error of the moment decreases with the square of the number of annuli. On the uniform disc it is
/// at most 0.041, 0.0163 and 0.0056 μ N R for 1, 2 and 4 annuli.
///
/// The pressure profile p holds for a pure normal displacement of any magnitude, and changes as the tip tilts. The patch does not grow with the
/// normal force. To match a measured torsional stiffness k_θ, use a ring of radius √(k_θ/k_t); to match a measured torsional limit τ, use a ring of
/// radius τ/(μ N).
///
/// ```
/// use grasp_lcp::spatial::{Contact, Grasp, Pressure, SoftFingertip, Wrench};
///
/// let finger = |x: f64| {
///     Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0]).series_stiffness(2000.0, 1000.0).friction(0.5).command([0.005, 0.0, 0.0])
/// };
/// let tip = SoftFingertip::disc(0.006, 1, 4, Pressure::Hertz)?;
/// let pinch = Grasp::new([tip.contacts(&finger(-0.03))?, tip.contacts(&finger(0.03))?].concat())?;
///
/// // The two fingertips share a moment (N m) about the line through both. Two single points could not carry this moment.
/// let state = pinch.solve(Wrench::new([0.0; 3], [0.01, 0.0, 0.0]))?;
/// let turn = state.equilibrium().expect("within friction").twist.rotation()[0];
/// let k_theta = 2.0 / 5.0 * 1000.0 * 0.006_f64.powi(2);
/// assert!((turn - 0.01 / (2.0 * k_theta)).abs() < 1e-12);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SoftFingertip<const C: usize> {
    /// Distance of the outermost points from the centre, m.
    pub(super) radius: f64,
    pub(super) points: Vec<PatchPoint<C>>,
}

/// One point of the patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PatchPoint<const C: usize> {
    /// Position relative to the centre, in the contact frame, m; its normal component is zero.
    pub(super) offset: SVector<f64, C>,
    pub(super) weight: f64,
}

face_of_struct! {
    SoftFingertip { radius, points }
    PatchPoint { offset, weight }
}

/// Points across a line contact of half width 1, in ascending order: position, and fraction of the load. Each quadrature node of `layers`, given by
/// its distance from the middle, becomes two points, one on either side.
pub(super) fn along_a_line(layers: &[Layer]) -> Vec<(f64, f64)> {
    let mut all = mapped(layers, &|layer| (-layer.distance, 0.5 * layer.weight));
    all.reverse();
    all.extend(mapped(layers, &|layer| (layer.distance, 0.5 * layer.weight)));
    all
}

impl SoftFingertip<3> {
    /// A ring of points on a circle of this radius (m), each with the same fraction of stiffness and load. `points` is their number. The first point
    /// lies along the first tangent.
    ///
    /// ```
    /// use grasp_lcp::spatial::{Contact, SoftFingertip};
    ///
    /// // A fingertip slips at the measured torsion τ = 0.02 N m under N = 10 N, with μ = 0.5: a ring of radius τ/(μ N).
    /// let finger = Contact::new([0.0; 3], [0.0, 0.0, 1.0]).series_stiffness(2000.0, 1000.0).friction(0.5);
    /// let tip = SoftFingertip::ring(0.02 / (0.5 * 10.0), 6)?;
    /// assert!((tip.torsional_limit(&finger, 10.0) - 0.02).abs() < 1e-16);
    /// assert!((tip.torsional_stiffness(&finger) - 1000.0 * 0.004_f64.powi(2)).abs() < 1e-16);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Fingertip`] unless the radius is from 1e-50 to 1e50 and the points are from 3 (a ring of two tilts freely) to [`Self::MOST_POINTS`].
    pub fn ring(radius: f64, points: usize) -> Result<Self, Error> {
        Self::check_points(1, points)?;
        Self::of_rings(radius, &[Layer { distance: 1.0, weight: 1.0 }], points)
    }

    /// A disc of this radius (m), divided into `annuli` of equal width. Two rings of `points` points represent each annulus. Every other ring is
    /// rotated by half a spacing; the ring on the rim has a point along the first tangent.
    ///
    /// The closed forms in the tables of [`SoftFingertip`] hold for any number of annuli and points. More annuli resolve how slip spreads from the
    /// rim. More points improve the friction of a tip that slides and spins at the same time.
    ///
    /// # Errors
    /// [`Error::Fingertip`] unless the radius is from 1e-50 to 1e50, there is at least one annulus, each ring has at least 3 points, and there are at
    /// most [`Self::MOST_POINTS`] points in all.
    pub fn disc(radius: f64, annuli: usize, points: usize, pressure: Pressure) -> Result<Self, Error> {
        check(annuli >= 1, "number of annuli", annuli as f64, "at least 1")?;
        let rings = annuli.saturating_mul(2);
        Self::check_points(rings, points)?;
        Self::of_rings(radius, &pressure.layers(Space::Spatial, annuli), points)
    }

    fn check_points(rings: usize, points: usize) -> Result<(), Error> {
        check(points >= 3, "number of points on a ring", points as f64, "at least 3")?;
        let all = rings.saturating_mul(points);
        check(all <= Self::MOST_POINTS, "number of points", all as f64, "at most 4096")
    }

    fn of_rings(radius: f64, rings: &[Layer], points: usize) -> Result<Self, Error> {
        let radius = usable(radius, "radius")?;
        let place = |from_rim: usize, ring: &Layer, i: usize| {
            let half_spacings = 2 * i + from_rim % 2;
            let (sin, cos) = (TAU * half_spacings as f64 / (2 * points) as f64).sin_cos();
            // Sines and cosines below 1e-15 would be zero in exact arithmetic: other values of a ring of at most 4096 points are above 3e-4. If a
            // cosine were 6e-17 instead of 0, points of symmetric grasps would slip one after the other instead of together.
            let clean = |x: f64| if x.abs() < 1e-15 { 0.0 } else { x };
            PatchPoint {
                offset: SVector::from([0.0, clean(cos), clean(sin)]) * (ring.distance * radius),
                weight: ring.weight / points as f64,
            }
        };
        let mut all = Vec::new();
        for (j, ring) in rings.iter().enumerate() {
            for i in 0..points {
                all.push(place(rings.len() - 1 - j, ring, i));
            }
        }
        Ok(Self { radius, points: all })
    }

    /// Torsional stiffness about the normal, N m/rad, while no point slides. Point i has the fraction w_i of the tangential stiffnesses k_1, k_2, and
    /// the coordinates x_i along the first and y_i along the second tangent. The stiffness is `Σ w_i (k_1 y_i² + k_2 x_i²)`, which equals `(k_1 +
    /// k_2)/2 ⟨r²⟩` on rings and discs.
    #[must_use]
    pub fn torsional_stiffness(&self, contact: &Contact<3>) -> f64 {
        let k = contact.series_stiffness_of_axes();
        self.mean(|at| k[1] * at[2] * at[2] + k[2] * at[1] * at[1])
    }

    /// Moment about the normal at which the first points slide, N m, under the normal force `normal_force`, N (N in the formula), and no other load.
    /// It is `μ N k_θ / √((k_1 y_i)² + (k_2 x_i)²)` at the point (x_i, y_i) that slides first. Here μ is the coefficient of friction, k_θ the
    /// [torsional stiffness](Self::torsional_stiffness), and k_1, k_2 are the tangential stiffnesses. On a ring with equal tangential stiffnesses all
    /// points slide at once, and the moment equals [`Self::torsional_limit`].
    #[must_use]
    pub fn first_sliding(&self, contact: &Contact<3>, normal_force: f64) -> f64 {
        let k = contact.series_stiffness_of_axes();
        let fastest = self.largest(|at| (k[1] * at[2]).hypot(k[2] * at[1]));
        contact.friction_coefficient() * normal_force * (self.torsional_stiffness(contact) / fastest)
    }

    /// Largest moment about the normal that friction can carry, N m, under the normal force `normal_force`, N (N in the formula), and no other load.
    /// With the coefficient of friction μ and the mean distance ⟨r⟩ of the points from the centre it is `μ N ⟨r⟩`, independent of the springs.
    #[must_use]
    pub fn torsional_limit(&self, contact: &Contact<3>, normal_force: f64) -> f64 {
        contact.friction_coefficient() * normal_force * self.mean(SVector::norm)
    }
}

impl SoftFingertip<2> {
    /// A pad of this width (m) that is represented by two points at its edges, each with half of the stiffness and load.
    ///
    /// # Errors
    /// [`Error::Fingertip`] unless the width is from 1e-50 to 1e50.
    pub fn pair(width: f64) -> Result<Self, Error> {
        SoftFingertip::pair_inside(width).map(Self::from_inside)
    }

    /// A pad of this width (m). Each half is divided into `strips` of equal width, and two points represent each strip, one of them on its outer
    /// edge. The closed forms in the tables of [`SoftFingertip`] hold for any number of strips.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Pressure, SoftFingertip};
    ///
    /// // A pad 12 mm wide, b = 6 mm, under Hertz pressure: turning stiffness k_n b²/4, first opening at the moment N b/4.
    /// let finger = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(2000.0, 1000.0).friction(0.5);
    /// let tip = SoftFingertip::pad(0.012, 2, Pressure::Hertz)?;
    /// assert_eq!(tip.contacts(&finger)?.len(), 8);
    /// assert!((tip.tilting_stiffness(&finger) - 2000.0 * 36e-6 / 4.0).abs() < 1e-15);
    /// assert!((tip.first_opening(10.0) - 10.0 * 0.006 / 4.0).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Fingertip`] unless the width is from 1e-50 to 1e50, there is at least one strip and
    /// there are at most [`Self::MOST_POINTS`] points.
    pub fn pad(width: f64, strips: usize, pressure: Pressure) -> Result<Self, Error> {
        SoftFingertip::pad_inside(width, strips, pressure).map(Self::from_inside)
    }
}

impl SoftFingertip<3> {
    /// The two-point pad of [`SoftFingertip::pair`]; vectors have three components, as in the engine.
    pub(crate) fn pair_inside(width: f64) -> Result<Self, Error> {
        Self::of_layers(width, &[Layer { distance: 1.0, weight: 1.0 }])
    }

    /// The pad of [`SoftFingertip::pad`], divided into strips; vectors have three components, as in the engine.
    pub(crate) fn pad_inside(width: f64, strips: usize, pressure: Pressure) -> Result<Self, Error> {
        check(strips >= 1, "number of strips", strips as f64, "at least 1")?;
        let all = strips.saturating_mul(4);
        check(all <= Self::MOST_POINTS, "number of points", all as f64, "at most 4096")?;
        Self::of_layers(width, &pressure.layers(Space::Planar, strips))
    }

    /// The point contacts that replace `contact` ([`SoftFingertip::contacts`]). Their vectors have three components, also in the plane.
    pub(crate) fn contacts_inside(&self, contact: &Contact<3>) -> Result<Vec<Contact<3>>, Error> {
        contact.check(0)?;
        let frame = contact.frame(0)?;
        let child = |(i, place): (usize, &PatchPoint<3>)| Contact {
            name: contact.name.as_ref().map(|name| format!("{name} {i}").into()),
            point: contact.point + frame * place.offset,
            tangent: Some(frame.column(1).into_owned()),
            stiffness: contact.stiffness.scaled(place.weight),
            press: contact.press.map(|force| force * place.weight),
            force: contact.force.map(|force| force * place.weight),
            suction: contact.suction * place.weight,
            point_of_pad: Some(i),
            ..contact.clone()
        };
        Ok(indexed(&self.points, &child))
    }

    /// A fingertip of the plane with points in ascending order along the tangent, from the quadrature nodes of its half width.
    fn of_layers(width: f64, layers: &[Layer]) -> Result<Self, Error> {
        let radius = 0.5 * usable(width, "width")?;
        let place = |(at, weight)| PatchPoint { offset: SVector::from([0.0, at * radius, 0.0]), weight };
        let points = moved(along_a_line(layers), &place);
        Ok(Self { radius, points })
    }
}

impl<const C: usize> SoftFingertip<C> {
    /// Upper limit of the number of points. A larger number resolves details that the fingertip model does not represent.
    pub const MOST_POINTS: usize = 4096;

    /// The point contacts that replace `contact`.
    ///
    /// Each point has the normal, tangents, friction, command, clearance and [`Hold`](crate::grasp::Hold) of `contact`. Its stiffness (of body and
    /// finger) and its forces are the fraction w_i of the stiffness and forces of `contact`. Its name is the name of `contact` with a number from 0,
    /// as in "thumb 3".
    ///
    /// # Errors
    /// [`Error::Contact`] with index 0 if `contact` has a number that is out of range.
    pub fn contacts(&self, contact: &Contact<C>) -> Result<Vec<Contact<C>>, Error> {
        inside(self).contacts_inside(&inside(contact)).map(outside)
    }

    /// Distance of the outermost points from the centre, m: the radius R of a ring or disc, half the width of a pad, half the diagonal of a
    /// rectangle.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The points, in the order of [`Self::contacts`]. Each has its coordinates relative to the centre along the axes of the contact frame, m,
    /// and its fraction w_i of the stiffness. The normal coordinate is zero.
    #[must_use]
    pub fn points(&self) -> impl ExactSizeIterator<Item = (SVector<f64, C>, f64)> {
        self.points.iter().map(|place| (place.offset, place.weight))
    }

    /// Tilting stiffness about a tangent, N m/rad: `k_n ⟨r²⟩/2` in space, `k_n ⟨x²⟩` in the plane. Here k_n is the normal stiffness. ⟨r²⟩ and ⟨x²⟩
    /// are the mean squares of the points' distances from the centre, weighted by their fractions of the stiffness. For a rectangle it is the smaller
    /// of the [two tilting stiffnesses](SoftFingertip::tilting_stiffnesses).
    #[must_use]
    pub fn tilting_stiffness(&self, contact: &Contact<C>) -> f64 {
        let least = (1..C).map(|axis| self.square(axis)).least();
        contact.series_stiffness_of_axes()[0] * least
    }

    /// Moment about a tangent at which the first point opens, N m, under the normal force `normal_force` (N). It is `N ⟨r²⟩/2R` in space with the
    /// radius R, `N ⟨x²⟩/b` in the plane with half the width b. In space this holds for a tilt towards a point on the rim. For a tilt between two
    /// such points the first point opens later, by up to the factor 1/cos(π/points). For a rectangle it is the smaller of the moments for tilts about
    /// the two tangents; under a tilt towards a corner a point opens earlier.
    #[must_use]
    pub fn first_opening(&self, normal_force: f64) -> f64 {
        let along = |axis: usize| self.square(axis) / self.largest(|at| at[axis].abs());
        normal_force * (1..C).map(along).least()
    }

    /// Mean square of the points' coordinates along a tangent, weighted by their fractions of the stiffness, m². `axis` is 1 or 2.
    pub(super) fn square(&self, axis: usize) -> f64 {
        self.mean(|at| at[axis] * at[axis])
    }

    /// Mean of a function of the position over all points, weighted by their fractions of the stiffness.
    fn mean(&self, f: impl Fn(&SVector<f64, C>) -> f64) -> f64 {
        self.points.iter().map(|place| place.weight * f(&place.offset)).added()
    }

    fn largest(&self, f: impl Fn(&SVector<f64, C>) -> f64) -> f64 {
        largest(&self.points, &|place| f(&place.offset))
    }
}

pub(super) fn usable(length: f64, what: &'static str) -> Result<f64, Error> {
    let usable = (1.0 / LARGEST..=LARGEST).contains(&length);
    check(usable, what, length, "from 1e-50 to 1e50").map(|()| length)
}

pub(super) fn check(good: bool, what: &'static str, value: f64, allowed: &'static str) -> Result<(), Error> {
    if good { Ok(()) } else { Err(Error::Fingertip { what, value, allowed }) }
}
