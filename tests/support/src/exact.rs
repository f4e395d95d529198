//! All equilibria of a planar grasp, by trying every combination of contact states in exact rational arithmetic.
//!
//! This module shares no code with the library. Every number of a scene is a floating point number, hence rational. Normals
//! have integer components and an integer length (Pythagorean), so that the unit normals are rational too. With the
//! stretch `v = a - Gᵀq` of the springs of a contact, where a is its command less its clearance, the law reads
//!
//! ```text
//! open           F = 0                              -v_n >= 0
//! sticking       F = (k_n v_n, k_t v_t)             F_n >= 0,  μ F_n ± F_t >= 0
//! sliding ±      F = (k_n v_n, ± μ F_n)             F_n >= 0,  ± k_t v_t - μ F_n >= 0      (slip ± s >= 0)
//! frictionless   F = (k_n v_n, 0)                   F_n >= 0
//! ```
//!
//! Each combination of states makes equilibrium a linear system `T q + b = 0` (3 x 3) with affine conditions `>= 0`.
//! If T is regular, Cramer's rule in integers gives q and then the sign of every condition. If T is singular, elimination and
//! Fourier-Motzkin decide whether some solution meets the conditions.

use grasp_lcp::planar;
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use super::affine::{
    Affine, Consistent, Point, Rational, common_denominator, cramer, dot, eliminate, feasible, project,
    quotient, rational, times,
};
use super::scene as plain;

/// A contact whose data are exact.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Contact point, m.
    pub point: [f64; 2],
    /// Normal into the object; its length is an integer.
    pub normal: [i32; 2],
    /// Series stiffness (k_n, k_t).
    pub stiffness: [f64; 2],
    /// Coefficient of friction.
    pub friction: f64,
    /// Command of the finger along normal and tangent, m.
    pub command: [f64; 2],
    /// Gap between finger and object before the command, m.
    pub clearance: f64,
}

/// A planar grasp under a load.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Contacts, in order.
    pub contacts: Vec<Contact>,
    /// Force (N) and moment about the origin (N m).
    pub load: [f64; 3],
}

/// The state of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum State {
    /// No force.
    Open,
    /// Stuck to the finger.
    Sticking,
    /// The finger slips over the body along +t.
    SlidingForward,
    /// The finger slips over the body along -t.
    SlidingBackward,
    /// Closed, without a tangential force because μ = 0.
    Frictionless,
}

/// A contact in one state: forces and conditions as functions of the twist.
struct Branch {
    state: State,
    force: [Affine<Rational>; 2],
    wrench: [Affine<BigInt>; 3],
    conditions: Vec<Affine<BigInt>>,
}

/// One equilibrium, or a connected family of them with the same states.
#[derive(Debug, Clone)]
pub struct Entry {
    /// States of the contacts. In a tie several combinations give the same solution; this is the first of them.
    pub states: Vec<State>,
    solution: Solution,
}

/// Twist and forces in the nearest floating point numbers.
#[derive(Debug, Clone)]
struct Rounded {
    twist: [f64; 3],
    forces: Vec<[f64; 2]>,
}

/// The force of a contact: functions of the twist, each over a common denominator.
type Force = [(Affine<BigInt>, BigInt); 2];

#[derive(Debug, Clone)]
enum Solution {
    Point(Point, Rounded),
    /// All twists at which `rows`, equivalent to equilibrium, vanish and all `conditions` are `>= 0`.
    Family {
        rows: Vec<Affine<BigInt>>,
        conditions: Vec<Affine<BigInt>>,
        forces: Vec<Force>,
    },
}

/// All equilibria of a scene.
#[derive(Debug, Clone)]
pub struct Census {
    /// Distinct equilibria, and connected families of them.
    pub entries: Vec<Entry>,
    /// Whether some equilibrium lies exactly on the boundary of its conditions.
    pub tied: bool,
    /// Whether some combination holds or fails by less than 2e-9 of the size of its terms, but not exactly. Working precision
    /// cannot be expected to decide it.
    pub narrow: bool,
    /// Whether some entry is a family.
    pub families: bool,
}

impl Scene {
    /// The scene in floating-point numbers.
    pub fn plain(&self) -> plain::Scene<3, 2> {
        let datum = |c: &Contact| plain::Datum {
            point: c.point.into(),
            normal: c.normal.map(f64::from).into(),
            tangent: [0.0; 2].into(),
            stiffness: c.stiffness.into(),
            friction: c.friction,
            command: c.command.into(),
            clearance: c.clearance,
        };
        plain::Scene { contacts: self.contacts.iter().map(datum).collect(), load: self.load.into() }
    }

    /// All equilibria of the scene, from every combination of contact states.
    pub fn census(&self) -> Census {
        let (load, branches) = self.branches();
        let mut census = Census { entries: Vec::new(), tied: false, narrow: false, families: false };
        let mut at = vec![0; branches.len()];
        loop {
            let chosen: Vec<&Branch> = branches.iter().zip(&at).map(|(list, &k)| &list[k]).collect();
            census.try_branches(&chosen, &load);
            let Some(next) = (0..at.len()).find(|&i| at[i] + 1 < branches[i].len()) else { break };
            at[next] += 1;
            at[..next].fill(0);
        }
        census
    }

    /// The load, and the branches of the law of every contact. Each row of equilibrium is scaled to integers by its common denominator.
    fn branches(&self) -> ([BigInt; 3], Vec<Vec<Branch>>) {
        let load = self.load.map(rational);
        let laws: Vec<Vec<_>> = self.contacts.iter().map(law).collect();
        let scale: [BigInt; 3] = std::array::from_fn(|row| {
            let numbers = laws.iter().flatten().flat_map(|(_, _, wrench, _)| wrench[row].numbers());
            common_denominator(numbers.chain([&load[row]]))
        });
        let branches = laws.into_iter().map(|states| {
            let branch = |(state, force, wrench, conditions): Law| Branch {
                state,
                force,
                wrench: std::array::from_fn(|row| wrench[row].times(&scale[row])),
                conditions: conditions.iter().map(Affine::in_integers).collect(),
            };
            states.into_iter().map(branch).collect()
        });
        let branches = branches.collect();
        (std::array::from_fn(|row| times(&load[row], &scale[row])), branches)
    }
}

type Law = (State, [Affine<Rational>; 2], [Affine<Rational>; 3], Vec<Affine<Rational>>);

/// The states of a contact: force, wrench and conditions as functions of the twist.
fn law(contact: &Contact) -> Vec<Law> {
    let [x, y] = contact.point.map(rational);
    let [i, j] = contact.normal;
    let length = f64::from(i * i + j * j).sqrt();
    assert_eq!(length, length.round(), "a Pythagorean normal");
    let n = [i, j].map(|c| rational(f64::from(c)) / rational(length));
    let t = [n[1].clone(), -&n[0]];
    // The stretch of the springs along `axis` at the twist q: v = a - axis · (q_x - q_θ y, q_y + q_θ x)
    let stretch = |axis: &[Rational; 2], a: f64| Affine {
        slope: [-&axis[0], -&axis[1], &axis[0] * &y - &axis[1] * &x],
        constant: rational(a),
    };
    let zero = Rational::zero();
    let clearance = rational(contact.clearance);
    let mut open_by = stretch(&n, contact.command[0]);
    open_by.constant -= clearance;
    let normal = open_by.scaled(&rational(contact.stiffness[0]));
    let open_by = open_by.scaled(&-Rational::one());
    let tangential = stretch(&t, contact.command[1]).scaled(&rational(contact.stiffness[1]));
    let edge = normal.scaled(&rational(contact.friction));
    let none = normal.scaled(&zero);
    let mut states = vec![(State::Open, [none.clone(), none.clone()], vec![open_by])];
    if contact.friction == 0.0 {
        states.push((State::Frictionless, [normal.clone(), none], vec![normal.clone()]));
    } else {
        let minus = |f: &Affine<Rational>| f.scaled(&-Rational::one());
        let inside = vec![normal.clone(), edge.plus(&tangential), edge.plus(&minus(&tangential))];
        let ahead = vec![normal.clone(), tangential.plus(&minus(&edge))];
        let back = vec![normal.clone(), minus(&tangential).plus(&minus(&edge))];
        states.push((State::Sticking, [normal.clone(), tangential], inside));
        states.push((State::SlidingForward, [normal.clone(), edge.clone()], ahead));
        states.push((State::SlidingBackward, [normal.clone(), minus(&edge)], back));
    }
    let wrench = |f: &[Affine<Rational>; 2]| {
        let fx = f[0].scaled(&n[0]).plus(&f[1].scaled(&t[0]));
        let fy = f[0].scaled(&n[1]).plus(&f[1].scaled(&t[1]));
        let moment = fy.scaled(&x).plus(&fx.scaled(&-&y));
        [fx, fy, moment]
    };
    states.into_iter().map(|(state, f, conditions)| (state, f.clone(), wrench(&f), conditions)).collect()
}

impl Census {
    fn try_branches(&mut self, chosen: &[&Branch], load: &[BigInt; 3]) {
        let mut rows: [Affine<BigInt>; 3] =
            load.clone().map(|w| Affine { slope: [BigInt::ZERO, BigInt::ZERO, BigInt::ZERO], constant: w });
        for branch in chosen {
            for (row, more) in rows.iter_mut().zip(&branch.wrench) {
                *row = row.plus(more);
            }
        }
        let conditions = chosen.iter().flat_map(|b| &b.conditions);
        let Some(point) = cramer(&rows) else {
            return self.try_family(chosen, &rows, conditions.cloned().collect());
        };
        let (mut failed, mut clearly, mut tied, mut narrow) = (false, false, false, false);
        for condition in conditions {
            let (value, close) = condition.value_and_closeness(&point);
            narrow |= close && !value.is_zero();
            tied |= value.is_zero();
            failed |= value.is_negative();
            clearly |= value.is_negative() && !close;
        }
        self.narrow |= narrow && !clearly;
        if failed {
            return;
        }
        self.tied |= tied;
        let known = |e: &Entry| matches!(&e.solution, Solution::Point(p, _) if p.is(&point));
        if !self.entries.iter().any(known) {
            let rounded = Rounded::at(&point, &forces(chosen));
            self.entries.push(Entry::new(chosen, Solution::Point(point, rounded)));
        }
    }

    fn try_family(
        &mut self,
        chosen: &[&Branch],
        rows: &[Affine<BigInt>; 3],
        conditions: Vec<Affine<BigInt>>,
    ) {
        let Consistent { rows, point, directions } = match eliminate(rows) {
            Ok(consistent) => consistent,
            Err(contradiction) => {
                self.narrow |= contradiction.narrow;
                return;
            }
        };
        let within = conditions.iter().map(|c| {
            let c = c.rational();
            let along = directions.iter().map(|d| dot(&c.slope, d)).collect::<Vec<_>>();
            (along, c.at(&point))
        });
        if feasible(within.collect(), directions.len()) {
            self.families = true;
            let forces = forces(chosen);
            self.entries.push(Entry::new(chosen, Solution::Family { rows, conditions, forces }));
        }
    }

    /// Distance of the equilibrium that the library returned from the nearest entry. Forces are relative to the
    /// largest force of the scene, displacements of the contact points to the largest displacement, command or clearance.
    pub fn distance(&self, scene: &Scene, returned: &planar::Equilibrium) -> f64 {
        self.entries.iter().map(|entry| entry.distance(scene, returned)).fold(f64::INFINITY, f64::min)
    }
}

fn forces(chosen: &[&Branch]) -> Vec<Force> {
    let whole = |f: &Affine<Rational>| {
        let scale = common_denominator(f.numbers());
        (f.times(&scale), scale)
    };
    chosen.iter().map(|branch| branch.force.each_ref().map(whole)).collect()
}

impl Rounded {
    fn at(point: &Point, forces: &[Force]) -> Self {
        let value = |(f, scale): &(Affine<BigInt>, BigInt)| quotient(f.at(point), scale * &point.denominator);
        Self {
            twist: point.floats(),
            forces: forces.iter().map(|force| force.each_ref().map(value)).collect(),
        }
    }
}

impl Entry {
    fn new(chosen: &[&Branch], solution: Solution) -> Self {
        Self { states: chosen.iter().map(|b| b.state).collect(), solution }
    }

    fn distance(&self, scene: &Scene, returned: &planar::Equilibrium) -> f64 {
        let nearest;
        let (exact, outside) = match &self.solution {
            Solution::Point(_, rounded) => (rounded, 0.0),
            Solution::Family { rows, conditions, forces } => {
                let point = project(rows, Point::of((returned.twist.to_vector()).into()));
                nearest = Rounded::at(&point, forces);
                (&nearest, conditions.iter().map(|c| c.missed(&point)).fold(0.0, f64::max))
            }
        };
        let exact_twist = planar::Twist::from_vector(exact.twist);
        let mut force_size = scene.load[0].hypot(scene.load[1]);
        let (mut motion_size, mut command) = (f64::MIN_POSITIVE, 0.0_f64);
        let (mut force_off, mut motion_off) = (0.0_f64, 0.0_f64);
        for ((contact, force), answer) in scene.contacts.iter().zip(&exact.forces).zip(&returned.contacts) {
            let [f_n, f_t] = *force;
            force_size = force_size.max(f_n.hypot(f_t));
            force_off = force_off.max((answer.force[0] - f_n).hypot(answer.force[1] - f_t));
            let [a, b] = exact_twist.displacement_at(contact.point);
            let [c, d] = returned.twist.displacement_at(contact.point);
            command = command.max(contact.command[0].hypot(contact.command[1])).max(contact.clearance);
            motion_size = motion_size.max(a.hypot(b)).max(command);
            motion_off = motion_off.max((a - c).hypot(b - d));
        }
        // If no contact carries a force, the force of the softest spring under the largest command is the scale.
        let softest = scene.contacts.iter().flat_map(|c| c.stiffness).fold(f64::INFINITY, f64::min);
        force_size = force_size.max(softest * command).max(f64::MIN_POSITIVE);
        // The library rounds its data (unit normals, arms). A rounded load moves a soft spring by the rounding over its
        // stiffness. The tolerance for this is 45 roundings of the largest force.
        motion_off -= 1e-14 * force_size / softest;
        (force_off / force_size).max(motion_off / motion_size).max(outside)
    }
}
