//! Scenes with load programs, and an independent implementation of the contact law. No arithmetic of the crate is used: frames,
//! grasp maps, springs and cones are computed from points, normals and tangents.

pub mod draw;
pub mod steps;
pub mod tally;
pub mod views;

use std::f64::consts::{PI, TAU};

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{ContactAnswer, ContactState, Equilibrium};
use grasp_lcp::grasp::{Contact, HandPart, Hold, Wrench};
use grasp_lcp::load_path::{Change, DriveChange, Event, Leg, PartChange, Turn};
use grasp_lcp::{ContactLabel, Settings};
use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;

/// Number of facets of the crate's default polygon in space. The polygon is inscribed, with its first corner along the first tangent.
const FACETS: usize = 8;

/// Data of a contact.
#[derive(Debug, Clone)]
pub struct Spot<const C: usize> {
    /// Contact point.
    pub point: SVector<f64, C>,
    /// Contact frame, with columns n, t….
    pub frame: SMatrix<f64, C, C>,
    /// Series stiffness of each axis.
    pub k: SVector<f64, C>,
    /// Coefficient of friction.
    pub mu: f64,
    /// Gap before the command.
    pub clearance: f64,
    /// Whether the contact can open, and slide.
    pub hold: Hold,
}

/// Load and commands at the end of a leg.
#[derive(Debug, Clone)]
pub struct Goal<const D: usize, const C: usize> {
    /// Load on the object.
    pub load: SVector<f64, D>,
    /// Commands of the fingers, in the contact frames.
    pub commands: Vec<SVector<f64, C>>,
    /// Turn of the load along the leg; `None` for a straight leg.
    pub turn: Option<Swing<D>>,
}

/// A turn of the load: `W + c (cos φ - 1) + s sin φ`, where W is the load at the start of the leg.
#[derive(Debug, Clone)]
pub struct Swing<const D: usize> {
    /// The wrench c.
    pub cosine: SVector<f64, D>,
    /// The wrench s.
    pub sine: SVector<f64, D>,
    /// Angle φ at the end of the leg, rad.
    pub angle: f64,
}

impl<const D: usize> Swing<D> {
    /// Change of the load at a fraction of the leg.
    pub fn at(&self, fraction: f64) -> SVector<f64, D> {
        let (sin, cos) = (self.angle * fraction).sin_cos();
        self.cosine * (cos - 1.0) + self.sine * sin
    }
}

/// Contacts with a load program. Goal 0 is the start, goal j + 1 the end of leg j.
#[derive(Debug, Clone)]
pub struct Scene<const D: usize, const C: usize> {
    /// The contacts.
    pub spots: Vec<Spot<C>>,
    /// Goals of the load program.
    pub goals: Vec<Goal<D, C>>,
}

impl<const C: usize> Spot<C> {
    /// The grasp map: column a is the wrench of a unit force along axis a of the contact frame. Its transpose maps a twist to the displacement.
    pub fn map<const D: usize>(&self) -> SMatrix<f64, D, C> {
        let mut map = SMatrix::zeros();
        for axis in 0..C {
            let (r, e) = (&self.point, self.frame.column(axis));
            for a in 0..C {
                map[(a, axis)] = e[a];
            }
            if C == 2 {
                map[(2, axis)] = r[0] * e[1] - r[1] * e[0];
            } else {
                for a in 0..3 {
                    let (b, c) = ((a + 1) % 3, (a + 2) % 3);
                    map[(3 + a, axis)] = r[b] * e[c] - r[c] * e[b];
                }
            }
        }
        map
    }

    /// Whether friction limits the tangential force.
    pub fn rubs(&self) -> bool {
        self.mu > 0.0 && self.mu.is_finite() && self.hold != Hold::Bonded
    }

    /// Whether the contact has tangential springs.
    pub fn holds_along(&self) -> bool {
        self.mu > 0.0 || self.hold == Hold::Bonded
    }
}

/// Settings for the law of this module: the exact cone in the plane, the polygon in space.
pub fn polygon() -> Settings {
    Settings::default().on_the_polygon()
}

/// Facet normals h of the friction polygon, `h·F_t <= μ F_n`, as tangential vectors in the contact frame.
pub fn facets<const C: usize>() -> Vec<SVector<f64, C>> {
    if C == 2 {
        return [1.0, -1.0].iter().map(|s| SVector::from_fn(|a, _| if a == 1 { *s } else { 0.0 })).collect();
    }
    let m = FACETS as f64;
    (0..FACETS).map(|j| flat((2 * j) as f64 * PI / m - PI / m, 1.0 / (PI / m).cos())).collect()
}

/// Corners of the friction polygon. Corner j lies between facets j and j + 1.
pub fn corners<const C: usize>() -> Vec<SVector<f64, C>> {
    if C == 2 {
        return facets();
    }
    (0..FACETS).map(|j| flat(j as f64 * TAU / FACETS as f64, 1.0)).collect()
}

fn flat<const C: usize>(angle: f64, length: f64) -> SVector<f64, C> {
    SVector::from_fn(|a, _| match a {
        1 => length * angle.cos(),
        2 => length * angle.sin(),
        _ => 0.0,
    })
}

/// The tangential part of a vector in the contact frame.
pub fn tangential<const C: usize>(f: &SVector<f64, C>) -> SVector<f64, C> {
    let mut t = *f;
    t[0] = 0.0;
    t
}

impl<const D: usize, const C: usize> Scene<D, C> {
    /// The grasp with the commands at the start of the load program (goal 0).
    pub fn grasp(&self) -> Grasp<C> {
        let contacts = self.spots.iter().zip(&self.goals[0].commands).map(|(spot, command)| {
            let contact = Contact::new(spot.point, spot.frame.column(0).into_owned());
            let contact = if C == 3 { contact.tangent(spot.frame.column(1).into_owned()) } else { contact };
            let contact = contact
                .series_stiffness_axes(spot.k)
                .friction(spot.mu)
                .clearance(spot.clearance)
                .command(*command);
            match spot.hold {
                Hold::Unilateral => contact,
                Hold::KeptClosed => contact.kept_closed(),
                Hold::Bonded => contact.bonded(),
            }
        });
        Grasp::new(contacts).expect("a valid scene")
    }

    /// The load at the start of the load program (goal 0).
    pub fn start(&self) -> Wrench<C> {
        Wrench::from_components(self.goals[0].load.as_slice())
    }

    /// The legs of the load program, one to each goal (load and commands) after goal 0, the start.
    pub fn legs(&self) -> Vec<Leg<C>> {
        let to = |goal: &Goal<D, C>| {
            if let Some(Swing { cosine, sine, angle }) = &goal.turn {
                let [cosine, sine] = [cosine, sine].map(|part| Wrench::from_components(part.as_slice()));
                return Leg::turn(&Turn::new(cosine * -1.0, cosine, sine).up_to(*angle));
            }
            Leg::load_to(Wrench::from_components(goal.load.as_slice())).and_commands_to(goal.commands.clone())
        };
        self.goals[1..].iter().map(to).collect()
    }

    /// Load and drives (commands less clearances) at a fraction of a leg.
    pub fn at(&self, leg: usize, fraction: f64) -> (SVector<f64, D>, Vec<SVector<f64, C>>) {
        let (from, to) = (&self.goals[leg], &self.goals[leg + 1]);
        let drives = (0..self.spots.len()).map(|i| {
            let mut a = from.commands[i] + (to.commands[i] - from.commands[i]) * fraction;
            a[0] -= self.spots[i].clearance;
            a
        });
        let change = match &to.turn {
            Some(swing) => swing.at(fraction),
            None => (to.load - from.load) * fraction,
        };
        (from.load + change, drives.collect())
    }

    /// The largest force with which commands of goal 0 press on a fixed object: a scale of forces that does not vanish with them.
    pub fn press(&self) -> f64 {
        let presses = self.spots.iter().zip(&self.goals[0].commands).map(|(spot, a)| spot.k[0] * a[0].abs());
        presses.fold(0.0, f64::max)
    }

    /// The worst violation by a state of the contact law on the polygon, relative to the terms of each condition. The law is the law on the crate's
    /// first page, with the slip so far of each contact.
    pub fn breach(&self, leg: usize, fraction: f64, state: &Equilibrium<C>) -> f64 {
        let reach = |t: &SVector<f64, C>| facets::<C>().iter().map(|h| h.dot(t)).fold(f64::MIN, f64::max);
        self.breach_of(leg, fraction, state, reach)
    }

    /// The worst violation of the contact law on the round cone by a state.
    pub fn breach_on_the_round_cone(&self, leg: usize, fraction: f64, state: &Equilibrium<C>) -> f64 {
        self.breach_of(leg, fraction, state, nalgebra::Matrix::norm)
    }

    /// The worst violation by a state of the contact law with the cone `reach(F_t) <= μ F_n`.
    fn breach_of(
        &self,
        leg: usize,
        fraction: f64,
        state: &Equilibrium<C>,
        reach: impl Fn(&SVector<f64, C>) -> f64,
    ) -> f64 {
        let (load, drives) = self.at(leg, fraction);
        let mut worst: f64 = 0.0;
        let mut note = |excess: f64, size: f64| {
            assert!(excess.is_finite());
            if excess > 0.0 {
                worst = worst.max(excess / size.max(f64::MIN_POSITIVE));
            }
        };
        let (most, _) = sizes(state);
        let (mut sum, mut sum_size) = (load, load.norm());
        for (i, (spot, c)) in self.spots.iter().zip(&state.contacts).enumerate() {
            let map = spot.map::<D>();
            let stretch =
                drives[i] - map.transpose() * SVector::<f64, D>::from_column_slice(state.twist.components());
            let (n, t) = (c.force[0], tangential(&c.force));
            sum += map * c.force;
            sum_size += map.norm() * c.force.norm();
            // Translation and rotation may cancel at the contact, but their rounding does not.
            let moved = SVector::<f64, D>::from_column_slice(state.twist.components());
            let size = drives[i].norm() + map.norm() * moved.norm() + c.slip.norm();
            if spot.hold == Hold::Unilateral {
                note(-n, most);
            }
            if c.state == ContactState::Separated {
                assert!(spot.hold == Hold::Unilateral);
                note(c.force.norm(), most);
                note((stretch[0] + c.gap).abs(), size);
                note(-c.gap, size);
                continue;
            }
            note(c.gap.abs(), size);
            note((n - spot.k[0] * stretch[0]).abs(), spot.k[0] * size + most);
            if !spot.holds_along() {
                note(t.norm(), most);
                continue;
            }
            for axis in 1..C {
                let pull = spot.k[axis] * (stretch[axis] - c.slip[axis]);
                note((t[axis] - pull).abs(), spot.k[axis] * size + most);
            }
            if !spot.rubs() {
                assert!(c.state == ContactState::Sticking);
                continue;
            }
            let reach = reach(&t);
            note(reach - spot.mu * n, (1.0 + spot.mu) * most);
            if matches!(c.state, ContactState::Sliding { .. }) {
                note(spot.mu * n - reach, (1.0 + spot.mu) * most);
            }
        }
        note(sum.norm(), sum_size);
        worst
    }
}

/// The largest force and the largest displacement of a state, as scales for rounding.
pub fn sizes<const C: usize>(state: &Equilibrium<C>) -> (f64, f64) {
    let load = SVector::<f64, C>::from_fn(|a, _| state.load.components()[a]).norm();
    let force = state.contacts.iter().fold(load, |most, c| most.max(c.force.norm()));
    let motion = state.contacts.iter().map(|c| c.body_core.norm() + c.slip.norm() + c.gap);
    (force, motion.fold(0.0, f64::max))
}

/// State, force, slip and gap of each contact, for messages.
pub fn brief<const C: usize>(state: &Equilibrium<C>) -> String {
    let of = |c: &ContactAnswer<C>| (c.state, c.force.as_slice().to_vec(), c.slip.as_slice().to_vec(), c.gap);
    format!("{:?}", state.contacts.iter().map(of).collect::<Vec<_>>())
}

/// Asserts that two states have the same forces and motions, relative to the largest of each.
pub fn same_state<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    a: &Equilibrium<C>,
    b: &Equilibrium<C>,
    within: f64,
) -> Result<(), TestCaseError> {
    let (force, motion) = sizes(a);
    let force = force.max(scene.press());
    for (i, (x, y)) in a.contacts.iter().zip(&b.contacts).enumerate() {
        prop_assert!(
            (x.force - y.force).norm() <= within * force,
            "contact {i}: {} against {}",
            brief(a),
            brief(b)
        );
        let moved = (x.body_core - y.body_core).norm();
        prop_assert!(moved <= within * motion, "{i} {moved:e} {} {}", brief(a), brief(b));
    }
    Ok(())
}

/// Changes of contacts at an event, with the index of each contact.
pub fn changes<const C: usize>(event: &Event<C>) -> Vec<(usize, Change<C>)> {
    event.changes.iter().map(|change| (change.contact.index, change.what)).collect()
}

/// Changes of drives at an event, with the index of each joint or tendon.
pub fn parts(drives: &[PartChange]) -> Vec<(HandPart, DriveChange)> {
    drives.iter().map(|drive| (drive.part.part, drive.what)).collect()
}

/// Indices of contacts.
pub fn numbers(contacts: &[ContactLabel]) -> Vec<usize> {
    contacts.iter().map(|contact| contact.index).collect()
}

/// In which direction a contact slides from a change on.
pub fn direction<const C: usize>(change: &Change<C>) -> Option<SVector<f64, C>> {
    match change {
        Change::Slides { direction }
        | Change::Reverses { direction }
        | Change::Turns { direction }
        | Change::ClosesSliding { direction } => Some(*direction),
        _ => None,
    }
}
