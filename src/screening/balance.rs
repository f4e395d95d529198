//! The stiffness of the object with every contact sticking, `T = Σ G_i K_i G_iᵀ`, in factors.
//!
//! With one tangential stiffness a contact `K_i = k_t I + (k_n - k_t) n nᵀ` in coordinate axes.

use super::block::Block;
use super::factors::LaneFactors;
use super::finger::{Force, LaneFinger, moment, world};
use super::lanes::{Lanes, dot};

/// Stiffness of the object about the centroid of its contacts, in factors.
#[derive(Debug, Clone, Copy)]
pub(super) struct RigidBody<const D: usize, const C: usize, const N: usize, const L: usize> {
    pub(super) fingers: [LaneFinger<C, L>; N],
    centre: [Lanes<L>; C],
    pub(super) arms: [[Lanes<L>; C]; N],
    /// Largest entry of an arm.
    pub(super) reach: Lanes<L>,
    factors: LaneFactors<D, L>,
}

impl<const D: usize, const C: usize, const N: usize, const L: usize> RigidBody<D, C, N, L> {
    #[inline(always)]
    pub(super) fn new(block: &Block<C, N, L>) -> Self {
        let share = Lanes::all(1.0 / N as f64);
        let none = [Lanes::ZERO; C];
        let mut fingers = [LaneFinger { normal: none, springs: [Lanes::ZERO; 2] }; N];
        for i in 0..N {
            for axis in 0..C {
                fingers[i].normal[axis] = block.normal[axis][i];
            }
            fingers[i].springs = [block.springs[0][i], block.springs[1][i]];
        }
        let mut centre = none;
        let mut arms = [centre; N];
        let mut reach = Lanes::ZERO;
        for axis in 0..C {
            for i in 0..N {
                centre[axis] += block.point[axis][i] * share;
            }
            for i in 0..N {
                arms[i][axis] = block.point[axis][i] - centre[axis];
                reach = reach.max(arms[i][axis].abs());
            }
        }
        let mut stiffness = [[Lanes::ZERO; D]; D];
        for i in 0..N {
            add(&mut stiffness, &fingers[i], &arms[i]);
        }
        Self { fingers, centre, arms, reach, factors: LaneFactors::new(stiffness) }
    }

    /// Positive if something moves freely.
    #[inline(always)]
    pub(super) fn free(&self) -> Lanes<L> {
        self.factors.free
    }

    /// `T⁻¹ w`, zero for what moves freely.
    #[inline(always)]
    pub(super) fn motion(&self, w: &[Lanes<L>; D]) -> [Lanes<L>; D] {
        self.factors.solve(w)
    }

    /// The load about the centroid.
    #[inline(always)]
    pub(super) fn carried(&self, load: &[Lanes<L>; D]) -> [Lanes<L>; D] {
        let mut force = [Lanes::ZERO; C];
        force.copy_from_slice(&load[..C]);
        let turning = moment(&self.centre, &force);
        let mut carried = *load;
        for k in C..D {
            carried[k] -= turning[k - C];
        }
        carried
    }

    /// What the forces leave of the load, and which part of it that is.
    #[inline(always)]
    pub(super) fn unbalanced(
        &self,
        forces: &[Force<C, L>; N],
        load: &[Lanes<L>; D],
    ) -> ([Lanes<L>; D], Lanes<L>) {
        let mut left = *load;
        let mut size = Lanes::ZERO;
        for axis in 0..C {
            size += load[axis].abs();
        }
        for i in 0..N {
            let force = world(&self.fingers[i], &forces[i]);
            let turning = moment(&self.arms[i], &force);
            for k in 0..D {
                left[k] += if k < C { force[k] } else { turning[k - C] };
            }
            for axis in 0..C {
                size += force[axis].abs();
            }
        }
        let mut moments = self.reach * size;
        let (mut worst_force, mut worst_moment) = (Lanes::ZERO, Lanes::ZERO);
        for k in 0..D {
            if k < C {
                worst_force = worst_force.max(left[k].abs());
            } else {
                worst_moment = worst_moment.max(left[k].abs());
                moments += load[k].abs();
            }
        }
        // Nothing of nothing is nothing.
        let tiny = Lanes::all(f64::MIN_POSITIVE);
        let part = worst_force / (size + tiny) + worst_moment / (moments + tiny);
        // Comparisons above pass over what is not a number.
        (left, part + Lanes::ZERO * left[0])
    }
}

/// Adds `G K Gᵀ` of a contact, the entries on and below the diagonal.
#[inline(always)]
fn add<const D: usize, const C: usize, const L: usize>(
    t: &mut [[Lanes<L>; D]; D],
    finger: &LaneFinger<C, L>,
    arm: &[Lanes<L>; C],
) {
    let [normal, tangential] = finger.springs;
    let more = normal - tangential;
    let turning = moment(arm, &finger.normal);
    let mut line = [Lanes::ZERO; D];
    for k in 0..D {
        line[k] = if k < C { finger.normal[k] } else { turning[k - C] };
    }
    for row in 0..D {
        let stiff = more * line[row];
        for column in 0..=row {
            t[row][column] += stiff * line[column];
        }
    }
    let mut pulled = *arm;
    for axis in 0..C {
        pulled[axis] = tangential * arm[axis];
    }
    let square = dot(&pulled, arm);
    for axis in 0..C {
        t[axis][axis] += tangential;
    }
    if C == 2 {
        t[2][0] -= pulled[1];
        t[2][1] += pulled[0];
        t[2][2] += square;
        return;
    }
    for axis in 0..C {
        let (next, last) = ((axis + 1) % C, (axis + 2) % C);
        t[C + axis][next] -= pulled[last];
        t[C + axis][last] += pulled[next];
        t[C + axis][C + axis] += square;
        for other in 0..=axis {
            t[C + axis][C + other] -= pulled[axis] * arm[other];
        }
    }
}
