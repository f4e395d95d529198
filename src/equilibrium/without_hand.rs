//! An equilibrium as seen from the object: contacts and their forces, without the joints behind them.

use nalgebra::SVector;

use super::answer::{Equilibrium, LocalAnswer};
use crate::grasp::{Twist, Wrench};

impl<const D: usize, const C: usize> Equilibrium<D, C> {
    /// This equilibrium in the coordinates of the object alone, for what only looks at object and contacts. Joints stay in their list.
    pub(crate) fn without_hand<const N: usize>(&self) -> Equilibrium<N, C> {
        let twist = |v: &Twist<D, C>| Twist::from_vector(leading::<D, N>(v.as_vector()));
        let contacts = self.contacts.len();
        Equilibrium {
            load: Wrench::from_vector(leading::<D, N>(self.load.as_vector())),
            twist: twist(&self.twist),
            contacts: self.contacts.clone(),
            joints: self.joints.clone(),
            tendons: self.tendons.clone(),
            rule: self.rule,
            stored_energy: self.stored_energy,
            free_motions: self.free_motions.iter().map(twist).collect(),
            neutral_motions: self.neutral_motions.iter().map(twist).collect(),
            residuals: self.residuals,
            work: self.work.clone(),
            cone: self.cone,
            change_from_polygon: self.change_from_polygon,
            local: LocalAnswer {
                states: self.local.states[..contacts].to_vec(),
                drive_forces: Vec::new(),
                twist: leading(&self.local.twist),
                drives: self.local.drives[..contacts].to_vec(),
                slips: self.local.slips[..contacts].to_vec(),
            },
        }
    }
}

fn leading<const D: usize, const N: usize>(v: &SVector<f64, D>) -> SVector<f64, N> {
    SVector::from_fn(|k, _| v[k])
}
