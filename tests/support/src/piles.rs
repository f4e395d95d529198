//! Everyday piles of several planar bodies: boxes on a table, walls of bricks, round arches of stones.

use std::f64::consts::PI;

use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::planar::{Bodies, Body, Contact, Wrench};
use nalgebra::Vector2;

use super::splitmix::Random;
use super::voussoirs::{Joint, NEVER_FAILS, Voussoirs, bisected};

const GRAVITY: [f64; 2] = [0.0, -9.81];

/// A pile of boxes, a load, and the data needed to add up forces on each box.
#[derive(Debug, Clone)]
pub struct Pile {
    /// The boxes; the last box is loaded.
    pub bodies: Bodies,
    /// The load on the last box.
    pub load: Wrench,
    /// Mass (kg) and centre of mass (m) of each box.
    pub boxes: Vec<(f64, [f64; 2])>,
    /// The boxes and the data of each contact.
    pub touches: Vec<Touching>,
}

/// A contact of a pile.
#[derive(Debug, Clone, Copy)]
pub struct Touching {
    /// The box that its normal points into.
    pub on: usize,
    /// The box on the other side; `None` for the table and for fingers.
    pub against: Option<usize>,
    /// Friction coefficient.
    pub friction: f64,
    /// Normal stiffness, N/m.
    pub stiffness: f64,
    /// Normal force before any motion, N.
    pub pressed: f64,
}

impl Pile {
    /// The worst violation by an answer under the load, relative to the largest force (at least 1 N): balance of each box, cones, and normal springs.
    pub fn violation(&self, state: &Equilibrium<2>) -> f64 {
        let last = self.boxes.len() - 1;
        let mut sums: Vec<Wrench> =
            self.boxes.iter().map(|(mass, at)| Wrench::force_at([0.0, mass * GRAVITY[1]], *at)).collect();
        sums[last] = sums[last] + self.load;
        let largest = state.contacts.iter().map(|contact| contact.force.norm()).fold(1.0, f64::max);
        let (mut worst, grasp) = (0.0_f64, self.bodies.clone().grasp().expect("well posed"));
        let contacts = grasp.contacts().iter().zip(grasp.frames()).zip(&state.contacts);
        for (((contact, frame), answer), touch) in contacts.zip(&self.touches) {
            let point = [contact.point()[0], contact.point()[1]];
            let force = Wrench::force_at(answer.force_world, point);
            sums[touch.on] = sums[touch.on] + force;
            let moved = |body: usize| Vector2::from(state.bodies[body].twist.displacement_at(point));
            let mut away = moved(touch.on);
            if let Some(below) = touch.against {
                sums[below] = sums[below] - force;
                away -= moved(below);
            }
            let [normal, friction]: [f64; 2] = answer.force.into();
            let pushed = (touch.pressed - touch.stiffness * frame.column(0).dot(&away)).max(0.0);
            worst =
                worst.max(friction.abs() - touch.friction * normal).max(-normal).max((normal - pushed).abs());
        }
        sums.iter().flat_map(|sum| sum.components().to_vec()).fold(worst, |worst, x| worst.max(x.abs()))
            / largest
    }
}

/// A pile of boxes of random size, mass and friction, with a push at the last box. With `fingers` two fingers press on the last box, and the push
/// also has an upward part. `None` if two boxes overlap by less than 20 mm.
pub fn boxes(random: &mut Random, count: usize, fingers: bool) -> Option<Pile> {
    let name = |k: usize| format!("box {k}");
    let (mut bodies, mut contacts, mut boxes, mut touches) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let ([mut left, mut right], mut height) = ([-0.5, 0.5], 0.0);
    for k in 0..count {
        let (wide, high) = (random.between(0.1, 0.3), random.between(0.05, 0.2));
        let middle = if k == 0 { 0.0 } else { 0.25 * (left + right) + 0.5 * random.between(left, right) };
        let own = [middle - 0.5 * wide, middle + 0.5 * wide];
        let face = [own[0].max(left), own[1].min(right)];
        if face[1] - face[0] < 0.02 {
            return None;
        }
        let (mass, centre) = (random.between(0.1, 3.0), [middle, height + 0.5 * high]);
        bodies.push(Body::new(name(k)).mass(mass, centre));
        boxes.push((mass, centre));
        let (friction, stiffness) = (random.between(0.2, 0.9), 10_f64.powf(random.between(4.0, 6.0)));
        touches.extend([Touching { on: k, against: k.checked_sub(1), friction, stiffness, pressed: 0.0 }; 2]);
        contacts.extend(face.map(|x| {
            let edge = Contact::new([x, height], [0.0, 1.0]).series_stiffness(stiffness, 0.8 * stiffness);
            let edge = edge.friction(friction).on(name(k));
            if k == 0 { edge } else { edge.against(name(k - 1)) }
        }));
        ([left, right], height) = (own, height + high);
        if fingers && k + 1 == count {
            let (force, friction) = (random.between(2.0, 30.0), random.between(0.2, 0.9));
            touches.extend([Touching { on: k, against: None, friction, stiffness: 1e4, pressed: force }; 2]);
            contacts.extend([(left, 1.0), (right, -1.0)].map(|(x, normal)| {
                let finger = Contact::new([x, height - 0.5 * high], [normal, 0.0]).series_stiffness(1e4, 8e3);
                finger.friction(friction).pressed_with(force).on(name(k))
            }));
        }
    }
    let (push, up) = (random.between(0.5, 20.0), if fingers { random.between(0.0, 1.0) } else { 0.0 });
    let load = Wrench::force_at([push * (1.0 - up), push * up], [0.0, height - 0.03]);
    let bodies = Bodies::new(bodies).contacts(contacts).gravity(GRAVITY).loaded(name(count - 1));
    Some(Pile { bodies, load, boxes, touches })
}

/// The brick (row, column) on which half brick number `half`, counted from the left of the wall, of row `row` rests. `None` if it rests on the
/// ground.
pub(crate) fn brick_below(rows: usize, row: usize, half: usize) -> Option<(usize, usize)> {
    let below = row.checked_sub(1)?;
    let column = half.checked_sub(below % 2)? / 2;
    (column < rows).then_some((below, column))
}

/// A wall of `rows` rows of `rows` bricks each. A brick has 2 kg and is 1 m by 0.5 m; every other row is shifted by half a brick.
///
/// Loads act on the first brick of the top row. Half bricks that overhang stand on the ground.
pub fn wall(rows: usize) -> Bodies {
    let name = |row: usize, column: usize| format!("brick {row}.{column}");
    let (mut bodies, mut contacts) = (Vec::new(), Vec::new());
    for (row, column) in (0..rows).flat_map(|row| (0..rows).map(move |column| (row, column))) {
        // Number of the first half brick, counted from the left.
        let (first, height) = (2 * column + row % 2, 0.5 * row as f64);
        bodies.push(Body::new(name(row, column)).mass(2.0, [0.5 * first as f64 + 0.5, height + 0.25]));
        for half in [first, first + 1] {
            let points = [0.02, 0.48].map(|x| {
                let point = Contact::new([0.5 * half as f64 + x, height], [0.0, 1.0]);
                point.series_stiffness(1e6, 8e5).friction(0.6).on(name(row, column))
            });
            contacts.extend(points.map(|point| match brick_below(rows, row, half) {
                Some((row, column)) => point.against(name(row, column)),
                None => point,
            }));
        }
    }
    Bodies::new(bodies).contacts(contacts).gravity(GRAVITY).loaded(name(rows - 1, 0))
}

/// A row of `count` books of 1 kg, 3 cm thick and 24 cm high, pressed together between two hands. Loads act on the middle book.
///
/// The hands press with twice the force that carries the row and keeps the faces closed.
pub fn books(count: usize) -> Bodies {
    let name = |k: usize| format!("book {k}");
    let face = |k: usize, normal: f64| {
        [-0.12, 0.12].map(|y| {
            let point = Contact::new([0.03 * k as f64, y], [normal, 0.0]);
            point.series_stiffness(1e5, 8e4).friction(0.5)
        })
    };
    let (weight, long) = (9.81 * count as f64, 0.03 * count as f64);
    // Force at each of two points. The second bound keeps faces closed: the row bends under its weight like a beam.
    let press = weight.max(weight * long / (8.0 * 0.12));
    let right = face(count, -1.0).map(|hand| hand.force(press).on(name(count - 1)));
    let between = (1..count).flat_map(|k| face(k, 1.0).map(|point| point.on(name(k)).against(name(k - 1))));
    let bodies = (0..count).map(|k| Body::new(name(k)).mass(1.0, [0.03 * (k as f64 + 0.5), 0.0]));
    Bodies::new(bodies)
        .contacts(face(0, 1.0).map(|hand| hand.on(name(0))).into_iter().chain(between).chain(right))
        .gravity(GRAVITY)
        .loaded(name(count / 2))
}

/// A semicircular arch.
#[derive(Debug, Clone, Copy)]
pub struct Arch {
    /// Number of stones. They have equal angles and radial joints.
    pub stones: usize,
    /// Thickness relative to the mean radius, which is 1 m.
    pub thickness: f64,
}

impl Arch {
    /// Joint k, counted from the left foot.
    fn joint(&self, k: usize) -> Joint {
        let (sin, cos) = (PI * (1.0 - k as f64 / self.stones as f64)).sin_cos();
        Joint { middle: [cos, sin], across: [sin, -cos], half: 0.5 * self.thickness }
    }

    /// Centre of gravity of a stone (m) and its weight (N), at 1000 N for each square metre.
    fn weight(&self, stone: usize) -> ([f64; 2], f64) {
        let [outer, inner] = [1.0 + 0.5 * self.thickness, 1.0 - 0.5 * self.thickness];
        let half = 0.5 * PI / self.stones as f64;
        let area = half * (outer * outer - inner * inner);
        let radius =
            2.0 / 3.0 * (outer.powi(3) - inner.powi(3)) / (outer * outer - inner * inner) * half.sin() / half;
        let (sin, cos) = (PI * (1.0 - (stone as f64 + 0.5) / self.stones as f64)).sin_cos();
        ([radius * cos, radius * sin], 1000.0 * area)
    }

    /// The joints and stones of the arch.
    pub fn voussoirs(&self) -> Voussoirs {
        Voussoirs {
            joints: (0..=self.stones).map(|k| self.joint(k)).collect(),
            weights: (0..self.stones).map(|stone| self.weight(stone)).collect(),
        }
    }

    /// The least thickness at which an arch of `stones` stones stands, with friction that never fails.
    pub fn least_thickness(stones: usize) -> f64 {
        bisected(1.0, |thickness| Self { stones, thickness }.voussoirs().stands(NEVER_FAILS))
    }
}
