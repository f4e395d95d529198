//! A bound that shows, without an equilibrium, that a grasp in which everything sticks does not buckle. It costs as little as reading the contacts.
//!
//! Contacts with forces F_i at arms r_i take at most `Σ |F_i| |r_i|` of the stiffness against rotation; see `equilibrium/left_out`. If contact i is
//! at least as stiff as k_i in every direction, the springs resist rotations about the centroid of the k_i with at least the least eigenvalue λ of
//! `Σ k_i (|r_i|² 1 - r_i r_iᵀ)`. A contact that is at most as stiff as K_i stores the energy `½ |F_i|² / K_i` or more, so that `Σ |F_i| |r_i| <=
//! √(Σ K_i |r_i|²) √(Σ |F_i|² / K_i)`. The last sum is at most twice the energy of the commands plus that of the load.

use nalgebra::{SMatrix, SVector};

use crate::grasp::{Contact, Wrench};

/// The bound must stay below this fraction of the resistance. Rounding and the settling of `pressed_with` are far smaller than the rest to 1.
const SURELY: f64 = 0.99;

/// Whether forces surely leave resistance to rotation under both loads, with all commands multiplied by `squeeze`. If false, buckling is to be asked
/// of the equilibria. False also if neither commands nor the last load act, since the object may then lie loose.
pub(crate) fn surely_stable<const C: usize>(
    contacts: &[Contact<C>],
    squeeze: f64,
    loads: [Wrench<C>; 2],
) -> bool {
    let (mut stiffness, mut centre) = (0.0, SVector::<f64, C>::zeros());
    let least_and_most = |contact: &Contact<C>| {
        let k = contact.series_stiffness_of_axes();
        (k.min(), k.max())
    };
    for contact in contacts {
        let (least, _) = least_and_most(contact);
        stiffness += least;
        centre += contact.point * least;
    }
    centre /= stiffness;
    let (mut spread, mut stretched, mut arms) = (SMatrix::<f64, C, C>::zeros(), 0.0, 0.0);
    for contact in contacts {
        if contact.at_rest.is_some() || contact.force.is_some() || contact.suction != 0.0 {
            return false;
        }
        let ((least, most), arm) = (least_and_most(contact), contact.point - centre);
        spread += arm * arm.transpose() * least;
        arms += most * arm.norm_squared();
        stretched += match contact.press {
            Some(force) => force * force / contact.series_stiffness_of_axes()[0],
            None => most * (contact.command.norm() + contact.clearance.abs()).powi(2),
        };
    }
    // The largest eigenvalue of the spread is at most its norm. In the plane, the only rotation is about the third axis.
    let resists = spread.trace() - if C == 3 { spread.norm() } else { 0.0 };
    let takes = |load: &Wrench<C>| {
        let force = load.force_part();
        let about_centre = *load + Wrench::force_through(&centre, &-force);
        let moment =
            SVector::<f64, 3>::from_fn(|k, _| about_centre.components().get(C + k).copied().unwrap_or(0.0));
        let by_load = force.norm_squared() / stiffness + moment.norm_squared() / resists;
        // Of a force of which only the line is known, verdicts do not ask what its point of action adds.
        let of_load = load.points_of_action().moved(&force, &-centre).most_stiffness().unwrap_or(0.0);
        arms.sqrt() * (squeeze * stretched.sqrt() + by_load.sqrt()) + of_load
    };
    let acts = squeeze * stretched > 0.0 || loads[1] != Wrench::ZERO;
    acts && resists > 0.0 && loads.iter().all(|load| takes(load) < SURELY * resists)
}
