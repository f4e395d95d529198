//! Images of a scene: rotated, mirrored, shifted, in other units, with contacts in another order or halved.

use nalgebra::{SMatrix, SVector};

use super::{Goal, Scene, Spot, Swing};
use crate::transform::rotation;

/// `x -> length (R x + shift)` for points, `f -> force R f` for forces, with R orthogonal.
#[derive(Debug, Clone, Copy)]
pub struct View<const C: usize> {
    rotation: SMatrix<f64, C, C>,
    shift: SVector<f64, C>,
    length: f64,
    /// Factor by which numbers of forces grow.
    pub force: f64,
}

impl<const C: usize> View<C> {
    /// The change of units that multiplies numbers of lengths by `length` and of forces by `force`.
    pub fn in_units(length: f64, force: f64) -> Self {
        Self { rotation: SMatrix::identity(), shift: SVector::zeros(), length, force }
    }

    /// The rotation of coordinate planes (i, i + 1) by these angles, one after the other, and then the translation by a shift.
    pub fn moved(angles: [f64; 3], shift: [f64; 3]) -> Self {
        let rotation = rotation(angles);
        Self { rotation, shift: SVector::from_fn(|a, _| shift[a]), ..Self::in_units(1.0, 1.0) }
    }

    /// The reflection of the first axis.
    pub fn mirrored() -> Self {
        let mut view = Self::in_units(1.0, 1.0);
        view.rotation[(0, 0)] = -1.0;
        view
    }

    /// The image of a unit vector of the original scene.
    pub fn direction(&self, d: &SVector<f64, C>) -> SVector<f64, C> {
        self.rotation * d
    }

    fn turns_over(&self) -> bool {
        let r = &self.rotation;
        let minor = |a: usize, b: usize| r[(1, a)] * r[(2, b)] - r[(1, b)] * r[(2, a)];
        let determinant = if C == 2 {
            r[(0, 0)] * r[(1, 1)] - r[(0, 1)] * r[(1, 0)]
        } else {
            (0..3).map(|a| r[(0, a)] * minor((a + 1) % 3, (a + 2) % 3)).sum()
        };
        determinant < 0.0
    }

    /// A vector in the contact frame of the image. A mirrored frame has its last tangent reversed.
    fn flipped(&self, mut v: SVector<f64, C>) -> SVector<f64, C> {
        if self.turns_over() {
            v[C - 1] = -v[C - 1];
        }
        v
    }

    fn wrench<const D: usize>(&self, w: &SVector<f64, D>) -> SVector<f64, D> {
        let force = self.rotation * SVector::<f64, C>::from_fn(|a, _| w[a]) * self.force;
        let side = if self.turns_over() { -1.0 } else { 1.0 } * self.force * self.length;
        let arm = self.shift * self.length;
        SVector::from_fn(|k, _| {
            if k < C {
                return force[k];
            }
            if C == 2 {
                return side * w[2] + arm[0] * force[1] - arm[1] * force[0];
            }
            let (a, b, c) = (k - 3, (k - 2) % 3, (k - 1) % 3);
            let turned: f64 = (0..3).map(|j| self.rotation[(a, j)] * w[3 + j]).sum();
            side * turned + arm[b] * force[c] - arm[c] * force[b]
        })
    }

    /// The image of a scene.
    pub fn scene<const D: usize>(&self, scene: &Scene<D, C>) -> Scene<D, C> {
        let spot = |spot: &Spot<C>| {
            let mut frame = self.rotation * spot.frame;
            if self.turns_over() {
                let last = -frame.column(C - 1);
                frame.set_column(C - 1, &last);
            }
            Spot {
                point: (self.rotation * spot.point + self.shift) * self.length,
                frame,
                k: spot.k * (self.force / self.length),
                clearance: spot.clearance * self.length,
                ..spot.clone()
            }
        };
        let goal = |goal: &Goal<D, C>| Goal {
            load: self.wrench(&goal.load),
            commands: goal.commands.iter().map(|a| self.flipped(*a) * self.length).collect(),
            turn: goal.turn.as_ref().map(|Swing { cosine, sine, angle }| Swing {
                cosine: self.wrench(cosine),
                sine: self.wrench(sine),
                angle: *angle,
            }),
        };
        Scene { spots: scene.spots.iter().map(spot).collect(), goals: scene.goals.iter().map(goal).collect() }
    }
}

impl<const D: usize, const C: usize> Scene<D, C> {
    /// Contact i of the new scene is contact `order[i]` of this one.
    pub fn reordered(&self, order: &[usize]) -> Self {
        let goal = |goal: &Goal<D, C>| Goal {
            load: goal.load,
            commands: order.iter().map(|&i| goal.commands[i]).collect(),
            turn: goal.turn.clone(),
        };
        Self {
            spots: order.iter().map(|&i| self.spots[i].clone()).collect(),
            goals: self.goals.iter().map(goal).collect(),
        }
    }

    /// The scene with one contact split into two of half its stiffness at the same place; the second is the last contact.
    pub fn halved(&self, contact: usize) -> Self {
        let mut order: Vec<usize> = (0..self.spots.len()).collect();
        order.push(contact);
        let mut scene = self.reordered(&order);
        for i in [contact, self.spots.len()] {
            scene.spots[i].k *= 0.5;
        }
        scene
    }
}
