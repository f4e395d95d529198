//! A planar load program followed in small implicit steps. At the end of every step the contact law, with the slip so far, is solved for every
//! combination of contact states. The solution nearest to the last solution is taken.

use grasp_lcp::equilibrium::{ContactAnswer, ContactState, Equilibrium};
use grasp_lcp::grasp::Hold;
use nalgebra::{Matrix3, Matrix3x2, SVector, Vector2, Vector3};

use super::{Scene, Spot};

/// Behaviour of a contact during a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Does {
    /// The contact is open at the end of the step.
    Opens,
    /// The contact closes: its slip is reset to the present position, so that F_t = 0.
    Closes,
    /// The contact sticks with the slip so far.
    Sticks,
    /// The finger slips along +t or -t.
    Slips(f64),
}

/// Tolerance of inequalities, relative to the largest forces or displacements.
const SLACK: f64 = 1e-9;

/// The end of a step.
#[derive(Debug, Clone)]
pub struct Step {
    /// Behaviour of each contact.
    pub does: Vec<Does>,
    /// Force of each contact, in the contact frames.
    pub forces: Vec<Vector2<f64>>,
    twist: Vector3<f64>,
    slips: Vec<f64>,
}

impl Step {
    /// The largest difference of a contact force from `forces`.
    pub fn distance(&self, forces: &[SVector<f64, 2>]) -> f64 {
        self.forces.iter().zip(forces).map(|(f, g)| (f - g).norm()).fold(0.0, f64::max)
    }
}

impl Scene<3, 2> {
    /// Behaviour of each contact in an equilibrium that the library computed.
    pub fn does(&self, state: &Equilibrium<2>) -> Vec<Does> {
        let of = |(spot, c): (&Spot<2>, &ContactAnswer<2>)| match c.state {
            ContactState::Separated => Does::Opens,
            ContactState::Sliding { direction } => Does::Slips(spot.frame.column(1).dot(&direction).signum()),
            _ => Does::Sticks,
        };
        self.spots.iter().zip(&state.contacts).map(of).collect()
    }

    /// The first step of a path, from an equilibrium that the library computed.
    pub fn first_step(&self, state: &Equilibrium<2>) -> Step {
        Step {
            does: self.does(state),
            forces: state.contacts.iter().map(|c| c.force).collect(),
            twist: state.twist.to_vector(),
            slips: state.contacts.iter().map(|c| c.slip[1]).collect(),
        }
    }

    /// Advances from one fraction of a leg to another. If a contact changes its behaviour or forces change much, the step is
    /// halved. Of several possible states, one with unchanged behaviour is preferred, else the nearest one is taken.
    pub fn advance(&self, leg: usize, [from, to]: [f64; 2], last: &Step, halvings: usize) -> Option<Step> {
        let steps = self.steps_to(leg, to, last);
        let next = steps.iter().find(|next| next.does == last.does).or(steps.first());
        match next {
            Some(next) if next.does == last.does && last.apart(next) < 0.1 => Some(next.clone()),
            _ if halvings > 0 => {
                let middle = 0.5 * (from + to);
                let half = self.advance(leg, [from, middle], last, halvings - 1)?;
                self.advance(leg, [middle, to], &half, halvings - 1)
            }
            next => next.cloned(),
        }
    }

    /// All states at a fraction of a leg that can follow `last` in one step, the nearest first.
    pub fn steps_to(&self, leg: usize, fraction: f64, last: &Step) -> Vec<Step> {
        let choices: Vec<Vec<Does>> = self
            .spots
            .iter()
            .zip(&last.does)
            .map(|(spot, was)| {
                if *was == Does::Opens {
                    return vec![Does::Closes, Does::Opens];
                }
                let mut list = vec![Does::Sticks];
                if spot.hold == Hold::Unilateral {
                    list.push(Does::Opens);
                }
                if spot.rubs() {
                    list.extend([Does::Slips(1.0), Does::Slips(-1.0)]);
                }
                list
            })
            .collect();
        let at = self.at(leg, fraction);
        let maps: Vec<_> = self.spots.iter().map(Spot::map::<3>).collect();
        let mut found = Vec::new();
        for mut k in 0..choices.iter().map(Vec::len).product() {
            let does = choices
                .iter()
                .map(|list| {
                    let own = list[k % list.len()];
                    k /= list.len();
                    own
                })
                .collect();
            found.extend(self.step(&at, &maps, last, does));
        }
        found.sort_by(|a, b| last.apart(a).total_cmp(&last.apart(b)));
        found
    }

    /// The step to this load and these drives with this behaviour of each contact. `None` if the law does not allow it.
    fn step(
        &self,
        (load, drives): &(Vector3<f64>, Vec<Vector2<f64>>),
        maps: &[Matrix3x2<f64>],
        last: &Step,
        does: Vec<Does>,
    ) -> Option<Step> {
        let (mut stiffness, mut pull) = (Matrix3::zeros(), *load);
        // The law of each contact: F = (force at twist 0) - slope · twist.
        let mut laws = Vec::new();
        for (i, (spot, does)) in self.spots.iter().zip(&does).enumerate() {
            let map = maps[i];
            let (n, t) = (map.column(0), map.column(1));
            let kt = if spot.holds_along() { spot.k[1] } else { 0.0 };
            let push = spot.k[0] * drives[i][0];
            let (at_rest, slope) = match does {
                Does::Opens => (Vector2::zeros(), [Vector3::zeros(); 2]),
                Does::Closes => (Vector2::new(push, 0.0), [n * spot.k[0], Vector3::zeros()]),
                Does::Sticks => {
                    (Vector2::new(push, kt * (drives[i][1] - last.slips[i])), [n * spot.k[0], t * kt])
                }
                Does::Slips(sign) => {
                    let share = Vector2::new(1.0, sign * spot.mu);
                    (share * push, [n * spot.k[0], n * (sign * spot.mu * spot.k[0])])
                }
            };
            pull += map * at_rest;
            stiffness += n * slope[0].transpose() + t * slope[1].transpose();
            laws.push((at_rest, slope));
        }
        let factor = stiffness.full_piv_lu();
        let pivots = factor.u().diagonal().abs();
        if pivots.min() <= 1e-12 * pivots.max() {
            return None;
        }
        let twist = factor.solve(&pull)?;
        let forces: Vec<_> =
            laws.iter().map(|(rest, s)| rest - Vector2::new(s[0].dot(&twist), s[1].dot(&twist))).collect();
        let most = forces.iter().map(Vector2::norm).fold(load.norm(), f64::max);
        let mut slips = last.slips.clone();
        for (i, (spot, does)) in self.spots.iter().zip(&does).enumerate() {
            let map = maps[i];
            let stretch = drives[i] - map.transpose() * twist;
            let travel = SLACK * (drives[i].norm() + map.norm() * twist.norm());
            let (n, friction) = (forces[i][0], forces[i][1]);
            // A contact that cannot open, and whose friction has no limit or is zero, may carry a pull.
            let pulled = spot.hold != Hold::Unilateral && !spot.rubs();
            let pushes = |n: f64, least: f64| n >= least || pulled;
            let least = -SLACK * (1.0 + if spot.mu.is_finite() { spot.mu } else { 0.0 }) * most;
            let allowed = match does {
                Does::Opens => {
                    slips[i] = stretch[1];
                    stretch[0] <= travel
                }
                Does::Closes => {
                    slips[i] = stretch[1];
                    pushes(n, least)
                }
                Does::Sticks => pushes(n, least) && (!spot.rubs() || spot.mu * n - friction.abs() >= least),
                Does::Slips(sign) => {
                    slips[i] = stretch[1] - friction / spot.k[1];
                    pushes(n, least) && sign * (slips[i] - last.slips[i]) >= -travel
                }
            };
            if !allowed {
                return None;
            }
        }
        Some(Step { does, forces, twist, slips })
    }
}

impl Step {
    /// The relative difference of the forces plus the relative difference of the twists of this step and the next.
    pub fn apart(&self, next: &Self) -> f64 {
        let size = self.forces.iter().map(Vector2::norm).fold(0.0, f64::max);
        let travel = self.twist.norm();
        self.distance(&next.forces) / (size + 1e-12) + (self.twist - next.twist).norm() / (travel + 1e-12)
    }
}
