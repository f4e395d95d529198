//! A rectangular soft pad in space: the jaw of a gripper.

use nalgebra::SVector;

use super::contact::Contact;
use super::fingertip::{PatchPoint, SoftFingertip, along_a_line, check, usable};
use super::pressure::Pressure;
use crate::error::Error;
use crate::numerics::{Each, Space};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

impl SoftFingertip<3> {
    /// A rectangular pad with sides a, b (m) along the first and the second tangent, under uniform pressure. Half of each side is divided into
    /// the given number of strips, and two points represent each strip. `[1, 1]` gives 16 points, four of them on every edge.
    ///
    /// Let k_n, k_t be the normal and tangential stiffness, N the normal force and μ the coefficient of friction. The points reproduce the uniform
    /// pad to rounding for any number of strips:
    ///
    /// | | formula |
    /// |---|---|
    /// | tilting stiffness about the first, the second tangent, N m/rad | k_n b²/12, k_n a²/12 |
    /// | torsional stiffness, N m/rad | k_t (a² + b²)/12 |
    /// | first opening under a moment (M_1, M_2) about the tangents, N m | 6 M_1/b + 6 M_2/a = N, with the absolute values of M_1 and M_2 |
    /// | torsion at which the corners begin to slide, N m | μ N √(a² + b²)/6 |
    ///
    /// Friction carries at most the moment `μ N ⟨r⟩` about the normal, where ⟨r⟩ is the mean distance from the centre. For the points this limit is
    /// lower than for the uniform pad, by at most 2.2 % for one strip and 0.4 % for two.
    ///
    /// ```
    /// use grasp_lcp::spatial::{Contact, SoftFingertip};
    ///
    /// // A jaw of 20 mm by 12 mm, 30 kN/m.
    /// let jaw = Contact::new([0.0; 3], [1.0, 0.0, 0.0]).tangent([0.0, 1.0, 0.0]).series_stiffness(30e3, 10e3).friction(0.8);
    /// let pad = SoftFingertip::rectangle([0.020, 0.012], [1, 1])?;
    /// assert_eq!(pad.contacts(&jaw)?.len(), 16);
    /// let [about_first, about_second] = pad.tilting_stiffnesses(&jaw);
    /// assert!((about_first - 30e3 * 0.012_f64.powi(2) / 12.0).abs() < 1e-13);
    /// assert!((about_second - 30e3 * 0.020_f64.powi(2) / 12.0).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Fingertip`] unless the sides are from 1e-50 to 1e50, there is at least one strip along each, and there are at most
    /// [`Self::MOST_POINTS`] points.
    pub fn rectangle(sides: [f64; 2], strips: [usize; 2]) -> Result<Self, Error> {
        let halves = [usable(sides[0], "first side")? * 0.5, usable(sides[1], "second side")? * 0.5];
        check(strips[0] >= 1, "number of strips along the first side", strips[0] as f64, "at least 1")?;
        check(strips[1] >= 1, "number of strips along the second side", strips[1] as f64, "at least 1")?;
        let all = strips[0].saturating_mul(4).saturating_mul(strips[1].saturating_mul(4));
        check(all <= Self::MOST_POINTS, "number of points", all as f64, "at most 4096")?;
        let layers = strips.each(|count| Pressure::Uniform.layers(Space::Planar, count));
        let mut points = Vec::with_capacity(all);
        for (x, weight) in along_a_line(&layers[0]) {
            for (y, other) in along_a_line(&layers[1]) {
                let offset = SVector::from([0.0, x * halves[0], y * halves[1]]);
                points.push(PatchPoint { offset, weight: weight * other });
            }
        }
        Ok(Self { radius: halves[0].hypot(halves[1]), points })
    }

    /// Tilting stiffnesses about the first and about the second tangent, N m/rad: `k_n ⟨y²⟩` and `k_n ⟨x²⟩`. Here k_n is the normal stiffness. The
    /// coordinates x and y of the points run along the first and the second tangent. The mean ⟨ ⟩ over all points is weighted by their fractions of
    /// the stiffness. Both stiffnesses are equal for rings and discs.
    #[must_use]
    pub fn tilting_stiffnesses(&self, contact: &Contact<3>) -> [f64; 2] {
        [2, 1].each(|axis| contact.series_stiffness_of_axes()[0] * self.square(axis))
    }
}
