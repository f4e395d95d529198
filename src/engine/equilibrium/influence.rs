//! The change of each contact force due to a force of any direction at a point, while contacts keep their states. A drive, the spring of a joint or
//! tendon of a hand, is treated like a contact.

use nalgebra::{SMatrix, SVector};

use super::sticking_response::StickingResponse;
use crate::contact::ZERO_SLACK;
use crate::grasp::{Motion, Wrench};
use crate::prelude::*;

/// The influence matrix of a contact: column k is its contact force if a force of 1 N along coordinate axis k acts at a given point.
pub(crate) struct Influence {
    pub(crate) of: SMatrix<f64, 3, 3>,
    /// The rounding scale of the matrix `of`, N: the magnitude of the terms that add up to the contact force, summed over the three unit forces. The
    /// rounding error of the matrix is proportional to it.
    pub(crate) size: f64,
}

impl Influence {
    /// The gradient of a condition `row·F` on the contact force F with respect to a force on the object at the given point. Component k is the change
    /// of `row·F` under 1 N along coordinate axis k. Zero if the gradient is within rounding.
    pub(crate) fn gradient_of(&self, row: &SVector<f64, 3>) -> SVector<f64, 3> {
        let gradient = self.of.tr_mul(row);
        if gradient.norm() > ZERO_SLACK * row.norm() * self.size { gradient } else { SVector::zeros() }
    }
}

impl StickingResponse<'_> {
    /// The influence matrix of each contact and drive: it maps a force on the object at `point` to the force of the contact. The error value is a
    /// motion that no spring resists, but along which a force on one of the coordinate axes does work.
    pub(crate) fn influences(&self, point: &[f64; 3]) -> Result<Vec<Influence>, Motion<3>> {
        let mut influences = Vec::new();
        influences.resize_with(self.edges.len(), || Influence { of: SMatrix::zeros(), size: 0.0 });
        for axis in 0..3 {
            let unit = core::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 });
            let forces = self.by_load(&push(point, &unit))?;
            for ((influence, force), size) in influences.iter_mut().zip(&forces.of).zip(forces.sizes) {
                influence.of.set_column(axis, force);
                influence.size += size;
            }
        }
        Ok(influences)
    }
}

/// The wrench of a force at a point.
pub(crate) fn push(point: &[f64; 3], force: &[f64; 3]) -> Wrench<3> {
    Wrench::force_through(&SVector::from(*point), &SVector::from(*force))
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, Vector3};

    use super::push;
    use crate::equilibrium::{Settings, StickingResponse};
    use crate::grasp::{Contact, Engine, Wrench};

    fn three_fingers() -> Engine {
        let finger = |angle: f64, press: f64| {
            let (sin, cos) = angle.sin_cos();
            let contact = Contact::new([cos, sin, 0.2 * cos], [-cos, -sin, 0.1]);
            contact.series_stiffness(1e3, 7e2).friction(0.6).pressed_with(press)
        };
        Engine::new(vec![finger(0.3, 9.0), finger(2.2, 11.0), finger(4.4, 10.0)]).expect("three fingers")
    }

    /// Returns a direction and a margin, N. A force of 2 N at `point` in this direction leaves the least margin μ F_n - |F_t| at the thumb (contact
    /// 0).
    fn worst_for_the_thumb(grasp: &Engine, weight: &Wrench<3>, point: [f64; 3]) -> (SVector<f64, 3>, f64) {
        let response = StickingResponse::new(grasp, &Settings::default());
        let force = response.forces(&grasp.offsets(), &grasp.load_unchecked(weight)).expect("resists").of[0];
        let influence = &response.influences(&point).expect("resists")[0];
        let margin = |row: &SVector<f64, 3>| row.dot(&force) - 2.0 * influence.gradient_of(row).norm();
        let rows = response.edges[0].least(&margin);
        let worst = rows.into_iter().min_by(|a, b| margin(a).total_cmp(&margin(b))).expect("a cone");
        (-influence.gradient_of(&worst).normalize(), margin(&worst))
    }

    /// If a force is added in the computed worst direction, the thumb (contact 0) has the computed margin μ F_n - |F_t|. None of 400 other directions
    /// of the added force leaves a smaller margin.
    #[test]
    fn no_equilibrium_leaves_less_at_the_thumb() {
        let (grasp, weight, point) =
            (three_fingers(), Wrench::<3>::force([0.3, 0.0, -1.0]), [0.1, 0.2, -0.3]);
        let (worst, least) = worst_for_the_thumb(&grasp, &weight, point);
        let left = |direction: Vector3<f64>| {
            let load = weight + push(&point, &direction.into()) * 2.0;
            let outcome = grasp.solve(&load, &Settings::default()).expect("valid");
            outcome.equilibrium().expect("holds").contacts[0].margin
        };
        assert!((left(worst) - least).abs() <= 1e-12 * least.abs().max(1.0), "{least}");
        for k in 0..400 {
            let (z, turn) = (f64::from(k) / 199.5 - 1.0, 2.4 * f64::from(k));
            let across = (1.0 - z * z).max(0.0).sqrt();
            let other = left(Vector3::new(across * turn.cos(), across * turn.sin(), z));
            assert!(other >= least - 1e-12, "{other} {least}");
        }
    }
}
