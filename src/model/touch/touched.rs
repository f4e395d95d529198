//! The contacts of a pad on a part (the mesh of an object to be held), and the quality of the fit.

use nalgebra::Vector3;

use crate::error::Error;
use crate::grasp::Contact;
use crate::numerics::sort_by_number;

/// The contacts at which a pad touches a part, and numbers that tell how well the pad fits: the area that misses the part, and the largest angle
/// between the surfaces.
#[derive(Debug, Clone, PartialEq)]
pub struct Touched {
    pub(super) contacts: Vec<Contact<3>>,
    pub(super) missing: f64,
    pub(super) steepest: f64,
}

impl Touched {
    /// The points at which the pad meets the part, as contacts of one fingertip: "left 0", "left 1" and so on. Points behind the foremost point have
    /// a clearance.
    pub fn contacts(&self) -> &[Contact<3>] {
        &self.contacts
    }

    /// The contacts at which the pad meets the part, moved out of this value.
    #[must_use]
    pub fn into_contacts(self) -> Vec<Contact<3>> {
        self.contacts
    }

    /// Fraction of the pad's area that misses the part, from 0 to 1.
    #[must_use]
    pub fn missing(&self) -> f64 {
        self.missing
    }

    /// Largest angle between the surfaces of pad and part over the points that press, rad. If the pad does not press, only the points that touch
    /// first are considered.
    #[must_use]
    pub fn steepest(&self) -> f64 {
        self.steepest
    }

    /// Whether the angle between the surfaces of pad and part exceeds the friction angle `atan μ`, or 1e-3 rad if that is larger. The pad then
    /// presses on an edge or on an inclined face from which it slips.
    #[must_use]
    pub fn is_over_an_edge(&self) -> bool {
        let friction = self.contacts.first().map_or(0.0, Contact::friction_coefficient);
        // Faces that are flat except for single-precision rounding do not count as an edge, even without friction.
        self.steepest > friction.atan().max(1e-3)
    }
}

/// Advance s of the pad, m, at which the closing force of its points is `force`, N: the sum of their forces along the closing direction. The part
/// does not move. s is measured from the position in which the points have the gaps `gaps`, m.
///
/// Consider a point with the gap g, the stiffnesses k_n and k_t, and the coefficient of friction μ. Its normal makes the angle θ with the closing
/// direction. Once it touches, the point presses with `k_n cos θ (s - g)`. Along the tangent it pulls with the smaller of `k_t sin θ (s - g)` and μ
/// times its normal force. Both are proportional to s - g, so the sum is piecewise linear in s.
pub(super) fn advance_under(
    force: f64,
    points: &[Contact<3>],
    gaps: &[f64],
    closing: &Vector3<f64>,
) -> Result<f64, Error> {
    let mut of_points = Vec::with_capacity(points.len());
    for (point, gap) in points.iter().zip(gaps) {
        let along = point.frame(0)?.tr_mul(closing);
        let k = point.series_stiffness_of_axes();
        let sine = along[1].hypot(along[2]);
        let normal = k[0] * along[0];
        let pull = (k[1] * along[1]).hypot(k[2] * along[2]);
        let tangential = if point.friction > 0.0 { pull.min(point.friction * normal) } else { 0.0 };
        of_points.push((*gap, normal * along[0] + tangential * sine));
    }
    sort_by_number(&mut of_points, &|(gap, _)| *gap);
    let (mut stiffness, mut moment) = (0.0, 0.0);
    let mut advance = of_points.first().map_or(0.0, |(gap, _)| *gap);
    for (i, (gap, k)) in of_points.iter().enumerate() {
        (stiffness, moment) = (stiffness + k, moment + k * gap);
        advance = (force + moment) / stiffness;
        if of_points.get(i + 1).is_none_or(|(next, _)| advance <= *next) {
            break;
        }
    }
    Ok(advance)
}
