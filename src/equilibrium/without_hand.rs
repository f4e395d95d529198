//! An equilibrium as seen from the object: contacts and their forces, without the joints behind them.

use super::answer::{Equilibrium, LocalAnswer};
use crate::grasp::Twist;

impl<const D: usize, const C: usize> Equilibrium<D, C> {
    /// This equilibrium in the coordinates of the object alone, for what only looks at object and contacts. Joints stay in their list.
    pub(crate) fn without_hand<const N: usize>(&self) -> Equilibrium<N, C> {
        let contacts = self.contacts.len();
        Equilibrium {
            load: self.load.resized(),
            twist: self.twist.resized(),
            contacts: self.contacts.clone(),
            joints: self.joints.clone(),
            tendons: self.tendons.clone(),
            rule: self.rule,
            stored_energy: self.stored_energy,
            free_motions: self.free_motions.iter().map(Twist::resized).collect(),
            neutral_motions: self.neutral_motions.iter().map(Twist::resized).collect(),
            residuals: self.residuals,
            work: self.work.clone(),
            cone: self.cone,
            change_from_polygon: self.change_from_polygon,
            local: LocalAnswer {
                states: self.local.states[..contacts].to_vec(),
                drive_forces: Vec::new(),
                twist: self.local.twist.fixed_rows::<N>(0).into_owned(),
                drives: self.local.drives[..contacts].to_vec(),
                slips: self.local.slips[..contacts].to_vec(),
            },
        }
    }
}
