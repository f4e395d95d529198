//! The stiffness matrix of the object if every contact sticks, `T = Σ G_i K_i G_iᵀ` with the grasp map G_i and stiffness K_i of contact i,
//! factorised.
//!
//! A contact has the unit normal n, the normal stiffness k_n and one tangential stiffness k_t. In coordinate axes thus
//! `K_i = k_t I + (k_n - k_t) n nᵀ`. A block holds as many grasps as a vector has numbers, one in each lane.

use super::block::{Block, Layout, count, entries};
use super::factors::LaneFactors;
use super::finger::{Force, LaneFinger, moment, world};
use super::lanes::{Packed, dot};
use super::pinch::AlongTheLine;

/// The factorised stiffness matrix of the object about the centroid of its contacts, for several grasps, one in each lane of a vector.
#[derive(Debug, Clone, Copy)]
pub(super) struct RigidBody<const C: usize, X: Packed> {
    centre: [X; C],
    /// Largest magnitude of a coordinate of the vectors from the centroid to the contacts, m.
    pub(super) reach: X,
    /// For two contacts in space: the exchange of coordinates after which the rotation about the coordinate axis nearest to the line through both
    /// contacts comes last. No spring resists the rotation about this line, so the last pivot vanishes up to rounding. `None` for all other grasps.
    line: Option<AlongTheLine<X>>,
    factors: LaneFactors<6, X>,
}

impl<const C: usize, X: Packed> RigidBody<C, X> {
    pub(super) fn none() -> Self {
        let zero = X::all(0.0);
        Self { centre: [zero; C], reach: zero, line: None, factors: LaneFactors::none() }
    }

    /// Computes the centroid and the factorised stiffness matrix for the grasps of a block.
    #[inline(always)]
    pub(super) fn ready(&mut self, block: &Block<'_, C, X>) {
        let contacts = count(block.contacts);
        let share = X::all(1.0 / contacts as f64);
        let points = block.points();
        self.reach = X::all(0.0);
        for axis in 0..C {
            let mut centre = X::all(0.0);
            for i in 0..contacts {
                centre += points[axis][i] * share;
            }
            for i in 0..contacts {
                self.reach = self.reach.max((points[axis][i] - centre).abs());
            }
            self.centre[axis] = centre;
        }
        self.factors.entries = [[X::all(0.0); 6]; 6];
        for i in 0..contacts {
            let finger = self.finger(block, i);
            add(&mut self.factors.entries, &finger);
        }
        self.line = (const { C == 3 } && contacts == 2).then(|| AlongTheLine::between(&points));
        if let Some(line) = &self.line {
            line.exchange(&mut self.factors.entries);
        }
        self.factors.factorize(Layout::<C>::COORDINATES, self.line.is_some());
    }

    /// The contact with the index `i` of the grasp in each lane, with its arm from the centroid.
    #[inline(always)]
    pub(super) fn finger(&self, block: &Block<'_, C, X>, i: usize) -> LaneFinger<C, X> {
        let mut arm = entries(&block.points(), i);
        for axis in 0..C {
            arm[axis] -= self.centre[axis];
        }
        LaneFinger { normal: entries(&block.normals(), i), springs: entries(&block.springs(), i), arm }
    }

    /// For each lane, a positive number if some motion of the object stretches no spring, up to rounding; else zero.
    #[inline(always)]
    pub(super) fn free(&self) -> X {
        self.factors.free
    }

    /// The motion `T⁻¹ w` of the object under the wrench w, with the stiffness matrix T of the object; zero along motions that stretch no spring.
    #[inline(always)]
    pub(super) fn motion(&self, w: &[X; 6]) -> [X; 6] {
        let coordinates = Layout::<C>::COORDINATES;
        match &self.line {
            Some(line) if const { C == 3 } => {
                line.exchanged(&self.factors.solve(coordinates, &line.exchanged(w)))
            }
            _ => self.factors.solve(coordinates, w),
        }
    }

    /// Returns `load` with its moment about the centroid of the contacts instead of about the origin.
    #[inline(always)]
    pub(super) fn carried(&self, load: &[X; 6]) -> [X; 6] {
        let mut force = [X::all(0.0); C];
        force.copy_from_slice(&load[..C]);
        let turning = moment(&self.centre, &force);
        let mut carried = *load;
        for k in C..Layout::<C>::COORDINATES {
            carried[k] -= turning[k - C];
        }
        carried
    }

    /// The load that `forces` leave unbalanced, as force and moment about the centroid, and its relative magnitude. The latter is a sum of two
    /// ratios. One is the largest force component over the sum of the magnitudes of all forces. The other is the largest moment component over a
    /// bound on the sum of the magnitudes of all moments.
    #[inline(always)]
    pub(super) fn unbalanced(
        &self,
        block: &Block<'_, C, X>,
        forces: &[Force<C, X>],
        load: &[X; 6],
    ) -> ([X; 6], X) {
        let mut left = *load;
        let mut size = X::all(0.0);
        for axis in 0..C {
            size += load[axis].abs();
        }
        for (i, force) in forces.iter().enumerate().take(count(block.contacts)) {
            let finger = self.finger(block, i);
            let force = world(&finger.normal, force);
            let turning = moment(&finger.arm, &force);
            for k in 0..Layout::<C>::COORDINATES {
                left[k] += if k < C { force[k] } else { turning[k - C] };
            }
            for axis in 0..C {
                size += force[axis].abs();
            }
        }
        let mut moments = self.reach * size;
        let (mut worst_force, mut worst_moment) = (X::all(0.0), X::all(0.0));
        for k in 0..Layout::<C>::COORDINATES {
            if k < C {
                worst_force = worst_force.max(left[k].abs());
            } else {
                worst_moment = worst_moment.max(left[k].abs());
                moments += load[k].abs();
            }
        }
        // If there are no forces and loads, the quotients are 0 / 0. The smallest positive double that is not subnormal, added to the denominators,
        // makes them 0.
        let tiny = X::all(f64::MIN_POSITIVE);
        let part = worst_force / (size + tiny) + worst_moment / (moments + tiny);
        // `max` ignores NaN. Adding zero times the first entry of `left` makes the relative magnitude NaN if that entry is NaN.
        (left, part + X::all(0.0) * left[0])
    }
}

/// Adds the contribution `G K Gᵀ` of a contact with the grasp map G and the stiffness K to the stiffness matrix t of the object. Only entries on and
/// below the diagonal are stored.
#[inline(always)]
fn add<const C: usize, X: Packed>(t: &mut [[X; 6]; 6], finger: &LaneFinger<C, X>) {
    let arm = &finger.arm;
    let [normal, tangential] = finger.springs;
    let more = normal - tangential;
    let turning = moment(arm, &finger.normal);
    let mut line = [X::all(0.0); 6];
    for k in 0..Layout::<C>::COORDINATES {
        line[k] = if k < C { finger.normal[k] } else { turning[k - C] };
    }
    for row in 0..Layout::<C>::COORDINATES {
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
    if const { C == 2 } {
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
