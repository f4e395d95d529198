//! Random piles of bodies, and the conditions of an equilibrium recomputed from their data alone.

use super::scene::{self, Datum};
use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{ContactState, Equilibrium};
use grasp_lcp::grasp::{Bodies, Body, Wrench};
use nalgebra::SVector;
use proptest::prelude::*;

/// A contact between two bodies, or between a body and the ground.
#[derive(Debug, Clone)]
pub struct Touch<const C: usize> {
    /// Data of the contact.
    pub datum: Datum<C>,
    /// The body that its normal points into.
    pub on: usize,
    /// The body on the other side; `None` is the ground.
    pub against: Option<usize>,
}

/// Bodies in a pile, each with its own load, and a finger on the last body.
#[derive(Debug, Clone)]
pub struct Stack<const D: usize, const C: usize> {
    /// Contacts of all bodies.
    pub touches: Vec<Touch<C>>,
    /// Load of each body: force and moment about the origin.
    pub loads: Vec<SVector<f64, D>>,
}

/// Name of a body.
pub fn name(body: usize) -> String {
    format!("body {body}")
}

impl<const D: usize, const C: usize> Stack<D, C> {
    /// The bodies for the library, where loads of questions act on body `loaded`.
    pub fn bodies(&self, loaded: usize) -> Bodies<C> {
        let contact = |touch: &Touch<C>| {
            let contact = touch.datum.contact().on(name(touch.on));
            touch.against.map_or(contact.clone(), |body| contact.against(name(body)))
        };
        let body = |(body, load): (usize, &SVector<f64, D>)| {
            Body::new(name(body)).load(Wrench::from_components(load.as_slice()))
        };
        Bodies::new(self.loads.iter().enumerate().map(body))
            .contacts(self.touches.iter().map(contact))
            .loaded(name(loaded))
    }

    /// The grasp for the library, where loads of questions act on body `loaded`.
    pub fn grasp(&self, loaded: usize) -> Grasp<C> {
        grasp(self.bodies(loaded))
    }

    /// The worst violation of any condition, relative to the largest force or displacement. `load` acts on body `loaded` in addition to its own load.
    pub fn violation(&self, answer: &Equilibrium<C>, loaded: usize, load: &SVector<f64, D>) -> f64 {
        let twist =
            |body: usize| SVector::<f64, D>::from_column_slice(answer.bodies[body].twist.components());
        let (mut force, mut motion) = (load.norm(), 0.0_f64);
        for (touch, told) in self.touches.iter().zip(&answer.contacts) {
            force = force.max(told.force.norm());
            let moved = scene::displacement(&touch.datum.point, &twist(touch.on)).norm();
            motion = motion.max(moved).max(touch.datum.command.norm()).max(told.slip.norm());
        }
        force = self.loads.iter().fold(force, |most, load| most.max(load.norm()));
        let mut worst = 0.0_f64;
        let mut check = |violation: f64, size: f64| {
            worst = if violation.is_nan() { f64::INFINITY } else { worst.max(violation / size) };
        };
        let mut sums = self.loads.clone();
        sums[loaded] += load;
        for (touch, told) in self.touches.iter().zip(&answer.contacts) {
            let (datum, frame) = (&touch.datum, touch.datum.frame());
            let mut moved = scene::displacement(&datum.point, &twist(touch.on));
            if let Some(against) = touch.against {
                moved -= scene::displacement(&datum.point, &twist(against));
            }
            let stretch = datum.drive() - frame.tr_mul(&moved);
            let mut give = stretch - told.slip;
            give[0] = stretch[0] + told.gap;
            for a in 0..datum.axes() {
                check((told.force[a] / datum.stiffness[a] - give[a]).abs(), motion);
            }
            check(-told.force[0], force);
            check(-told.gap, motion);
            check(told.force[0].min(told.gap * datum.softest()).max(0.0), force);
            let friction = SVector::<f64, C>::from_fn(|a, _| if a == 0 { 0.0 } else { told.force[a] });
            let limit = datum.friction * told.force[0];
            check(friction.norm() - limit, force);
            let slip = SVector::<f64, C>::from_fn(|a, _| if a == 0 { 0.0 } else { told.slip[a] });
            // The slip of an open contact is not checked, because it has no reference position.
            if told.state != ContactState::Separated && datum.friction > 0.0 {
                check((limit * slip.norm() - friction.dot(&slip)).abs(), force * motion);
            }
            let on_body = scene::wrench::<D, C>(&datum.point, &(frame * told.force));
            sums[touch.on] += on_body;
            if let Some(against) = touch.against {
                sums[against] -= on_body;
            }
        }
        // Arms of moments are at most about the height of the pile: one for each body.
        for sum in &sums {
            check(sum.norm(), force * (1.0 + self.loads.len() as f64));
        }
        worst
    }
}

/// The grasp of well-posed bodies.
pub fn grasp<const C: usize>(bodies: Bodies<C>) -> Grasp<C> {
    bodies.grasp().expect("well posed")
}

/// Contacts at the lower face of body `below`, at the height `below`: two points in the plane, three in space. The numbers `bends` perturb points,
/// normals and stiffnesses.
fn face<const C: usize>(below: usize, bends: &[f64], friction: f64) -> Vec<Touch<C>> {
    let on = below;
    let against = below.checked_sub(1);
    let corners: &[[f64; 2]] =
        if C == 2 { &[[-0.4, 0.0], [0.5, 0.0]] } else { &[[-0.4, -0.3], [0.5, -0.3], [0.0, 0.5]] };
    let touch = |(corner, bend): (&[f64; 2], &[f64])| {
        let (mut point, mut normal) = (SVector::<f64, C>::zeros(), SVector::<f64, C>::zeros());
        (point[0], normal[0]) = (corner[0] + 0.1 * bend[0], 0.4 * bend[1]);
        if C == 3 {
            (point[1], normal[1]) = (corner[1], 0.4 * bend[2]);
        }
        (point[C - 1], normal[C - 1]) = (below as f64 + 0.05 * bend[2], 1.0);
        let mut tangent = SVector::zeros();
        tangent[0] = 1.0;
        let stiffness = SVector::from_fn(|a, _| 10f64.powf(3.0 + bend[3] + 0.2 * a as f64));
        let datum =
            Datum { point, normal, tangent, stiffness, friction, command: SVector::zeros(), clearance: 0.0 };
        Touch { datum, on, against }
    };
    corners.iter().zip(bends.chunks(4)).map(touch).collect()
}

/// Random piles of `bodies` bodies with weights, nearly level faces, and a finger that presses down on the last body.
pub fn stack<const D: usize, const C: usize>(bodies: usize) -> impl Strategy<Value = Stack<D, C>> {
    let numbers = prop::collection::vec(-1.0..1.0f64, bodies * 16 + 8);
    let frictions = prop::collection::vec(prop_oneof![1 => Just(0.0), 6 => 0.1..0.9f64], bodies + 1);
    (numbers, frictions).prop_map(move |(numbers, frictions)| {
        let (of_faces, of_loads) = numbers.split_at(bodies * 12);
        let mut touches: Vec<_> = (0..bodies)
            .flat_map(|below| face::<C>(below, &of_faces[below * 12..], frictions[below]))
            .collect();
        let load = |body: usize| {
            let of = &of_loads[body * 4..];
            let mut load = SVector::<f64, D>::zeros();
            load[0] = 2.0 * of[0];
            load[C - 1] = -10.0 + 5.0 * of[1];
            load[D - 1] = of[2];
            load
        };
        let loads = (0..bodies).map(load).collect();
        let last = &of_loads[bodies * 4..];
        let (mut point, mut normal) = (SVector::zeros(), SVector::zeros());
        (point[0], point[C - 1], normal[0], normal[C - 1]) =
            (0.2 * last[0], bodies as f64, 0.3 * last[1], -1.0);
        let (mut tangent, mut command) = (SVector::zeros(), SVector::zeros());
        tangent[0] = 1.0;
        command[0] = 0.005 * (1.0 + last[2]);
        let stiffness = SVector::repeat(2e3);
        let friction = frictions[bodies];
        let datum = Datum { point, normal, tangent, stiffness, friction, command, clearance: 0.0 };
        touches.push(Touch { datum, on: bodies - 1, against: None });
        Stack { touches, loads }
    })
}
