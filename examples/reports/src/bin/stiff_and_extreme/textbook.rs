//! The sticking problem by the textbook's formulas: `q = (G K Gᵀ)⁻¹ (G K a + W)`, `F = K (a - Gᵀ q)`, in double precision, by Gaussian elimination.
//! G are the grasp maps, K the stiffnesses, a the commands, W the load, q the twist of the object and F the contact forces.

use grasp_lcp::ask::Grasp;
use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use support::dyadic::Dyadic;
use support::scene::{Scene, wrench};
use support::truth::Truth;

/// Largest error of a contact force over the largest force. `None` if the matrix has no inverse.
pub(crate) fn error<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    grasp: &Grasp<C>,
    truth: &Truth<C>,
) -> Option<f64> {
    let maps: Vec<SMatrix<f64, D, C>> = scene
        .contacts
        .iter()
        .zip(grasp.frames())
        .map(|(datum, frame)| {
            let column = |a: usize| wrench::<D, C>(&datum.point, &frame.column(a).into_owned());
            SMatrix::from_columns(&std::array::from_fn::<_, C, _>(column))
        })
        .collect();
    let (mut matrix, mut side) = (SMatrix::<f64, D, D>::zeros(), scene.load);
    for (map, datum) in maps.iter().zip(&scene.contacts) {
        let stiff = SMatrix::<f64, C, C>::from_diagonal(&datum.stiffness);
        matrix += map * stiff * map.transpose();
        side += map * (stiff * datum.drive());
    }
    let side = DVector::from_column_slice(side.as_slice());
    let twist = DMatrix::from_column_slice(D, D, matrix.as_slice()).lu().solve(&side)?;
    let twist = SVector::<f64, D>::from_column_slice(twist.as_slice());
    let mut worst = 0.0_f64;
    for ((map, datum), exact) in maps.iter().zip(&scene.contacts).zip(&truth.forces) {
        let force = datum.stiffness.component_mul(&(datum.drive() - map.tr_mul(&twist)));
        let off = |a: usize| (&Dyadic::new(force[a]) - &exact[a]).float();
        let off = (0..C).map(off).fold(0.0, |h: f64, x| h.hypot(x));
        worst = worst.max(off / truth.largest);
    }
    Some(worst)
}
