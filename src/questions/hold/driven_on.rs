//! Whether forces drive an object on along a motion that nothing resists. A part that two fingertips pinch below its centre of mass turns over,
//! although every contact sticks; a part that is pinched above its centre of mass hangs.
//!
//! Along a free motion the springs store no energy. Therefore the potential of contact forces and loads alone determines the stability: see
//! `left_out`.

use nalgebra::{DMatrix, SVector};

use crate::equilibrium::{ContactAnswer, ContactState, Equilibrium};
use crate::grasp::{Engine, Motion, Twist, Wrench};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{mapped, symmetric_eigen};
use crate::prelude::*;

impl Engine {
    /// The motion that nothing resists and along which the forces of the equilibrium `there` and its `load` drive the bodies on: the potential of the
    /// forces falls as the bodies turn. It is a combination of the free motions of `there`.
    ///
    /// `None` if there is no such motion, if the point of action of a load is not known, or if a free motion moves a joint or shears a closed
    /// contact. In the last case the potential of the joint or contact would have to be included.
    pub(super) fn driven_on(&self, there: &Equilibrium<3>, load: &Wrench<3>) -> Option<Motion<3>> {
        let free = &there.free_motions;
        if free.is_empty()
            || self.vacuum().is_some()
            || free.iter().any(|motion| !self.turns_in_place(there, motion))
        {
            return None;
        }
        let loads = self.loads_of_bodies(load);
        let mut falls = DMatrix::zeros(free.len(), free.len());
        let mut scale = 0.0;
        for (body, load) in loads.iter().enumerate() {
            load.points_of_action().stiffness()?;
            let centre = self.bodies().map_or(self.origin(), |bodies| &bodies.places[body].centre);
            let matrix = self.stiffness_of_arms(body, centre, there, load);
            let turns: Vec<SVector<f64, 3>> = mapped(free, &|motion| turn_of(motion, body));
            let forces = there.contacts.iter().map(|answer| answer.force_world.norm()).fold(0.0, f64::max);
            for (k, l) in (0..free.len()).flat_map(|k| (0..free.len()).map(move |l| (k, l))) {
                falls[(k, l)] += turns[k].dot(&(matrix * turns[l]));
                scale += forces * self.length() * turns[k].norm() * turns[l].norm();
            }
        }
        let (values, vectors) = symmetric_eigen(&falls);
        // A decrease of the potential is rounding of arms and forces if it is below this fraction of the largest force times the size of the grasp.
        (*values.last()? < -NEGLIGIBLE * scale).then(|| {
            let parts = vectors.column(free.len() - 1);
            combined(free, parts.as_slice())
        })
    }

    /// Whether a motion moves no joint, and at no closed contact displaces the body relative to the finger.
    fn turns_in_place(&self, there: &Equilibrium<3>, motion: &Motion<3>) -> bool {
        let is_still = |i: usize, answer: &ContactAnswer<3>| {
            let point = &self.contacts()[i].point;
            let mut moves = SVector::zeros();
            for body in 0..self.bodies().map_or(1, |bodies| bodies.places.len()) {
                let sign = self.bodies().map_or(1.0, |bodies| bodies.sign(i, body));
                moves += twist_of(motion, body).moves(point) * sign;
            }
            // Free motions have unit length, so a displacement below this is rounding.
            matches!(answer.state, ContactState::Separated) || moves.norm() <= NEGLIGIBLE
        };
        motion.joints.iter().all(|joint| *joint == 0.0)
            && there.contacts.iter().enumerate().all(|(i, answer)| is_still(i, answer))
    }
}

fn twist_of(motion: &Motion<3>, body: usize) -> &Twist<3> {
    motion.bodies.get(body).map_or(&motion.object, |motion| &motion.twist)
}

fn turn_of(motion: &Motion<3>, body: usize) -> SVector<f64, 3> {
    SVector::from_column_slice(&twist_of(motion, body).components()[3..])
}

/// The linear combination of motions with the coefficients `parts`.
fn combined(motions: &[Motion<3>], parts: &[f64]) -> Motion<3> {
    let sum = |of: &dyn Fn(&Motion<3>) -> Twist<3>| {
        motions.iter().zip(parts).fold(Twist::ZERO, |sum, (motion, part)| sum + of(motion) * *part)
    };
    let mut all = motions[0].clone();
    all.object = sum(&|motion| motion.object);
    for body in 0..all.bodies.len() {
        all.bodies[body].twist = sum(&|motion| motion.bodies[body].twist);
    }
    all
}
