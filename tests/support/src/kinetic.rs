//! Planar grasps whose friction is lower once contacts slide, by trying every combination of contact states in exact rational arithmetic.
//!
//! At some load a contact begins to slide. Then each contact is in one of these states, with the stretch `v = a - Gᵀq` of its springs:
//!
//! ```text
//! open        F = 0                                -v_n >= 0
//! stuck       F = (k_n v_n, k_t v_t)               F_n >= 0,  μ_s F_n ± F_t >= 0
//! sliding ±   F = (k_n v_n, ± μ_k F_n)             F_n >= 0,  ± k_t v_t - μ_k F_n >= 0      (slip ± s >= 0)
//! ```
//!
//! Equilibrium of a combination is a linear system. This module shares no code with the library.

use grasp_lcp::planar::{Contact, Equilibrium, Wrench};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use super::affine::{Affine, Point, Rational, common_denominator, cramer, float, quotient, rational, times};
use super::splitmix::Random;

/// A contact whose data are exact.
#[derive(Debug, Clone)]
pub struct Datum {
    /// Contact point, m.
    pub point: [f64; 2],
    /// Normal into the object; its length is an integer.
    pub normal: [f64; 2],
    /// Series stiffness (k_n, k_t), N/m.
    pub stiffness: [f64; 2],
    /// Friction coefficients (μ_s, μ_k) at rest and while sliding.
    pub friction: [f64; 2],
    /// Command of the finger along the normal, m.
    pub press: f64,
}

/// Contacts that balance a base load up to its rounding, and a load that grows on top of it.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Contacts, in order.
    pub contacts: Vec<Datum>,
    /// Base load: force and moment about the origin.
    pub base: [f64; 3],
    /// Load on top of the base load at factor 1: force and moment about the origin.
    pub more: [f64; 3],
}

/// The state of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// No force.
    Open,
    /// Closed, and has not slid.
    Stuck,
    /// Sliding; the friction force on the object acts along +t.
    Forward,
    /// Sliding; the friction force on the object acts along -t.
    Backward,
}

/// An equilibrium in which contacts catch the object: a state for each contact that satisfies the law of friction.
#[derive(Debug, Clone)]
pub struct Catch {
    /// State of each contact.
    pub states: Vec<State>,
    /// Normal and tangential force of each contact, N.
    pub forces: Vec<[f64; 2]>,
}

/// A contact in one state: forces, wrench and conditions as functions of the twist.
struct Branch {
    force: [Affine<Rational>; 2],
    wrench: [Affine<Rational>; 3],
    conditions: Vec<Affine<BigInt>>,
}

const ALL: [State; 4] = [State::Open, State::Stuck, State::Forward, State::Backward];

impl Datum {
    /// The contact for the library, with the friction at rest alone.
    pub fn plain(&self) -> Contact {
        Contact::new(self.point, self.normal)
            .series_stiffness(self.stiffness[0], self.stiffness[1])
            .friction(self.friction[0])
            .command([self.press, 0.0])
    }

    /// The contact for the library.
    pub fn contact(&self) -> Contact {
        self.plain().kinetic(self.friction[1])
    }

    fn frame(&self) -> [[Rational; 2]; 2] {
        let [x, y] = self.normal;
        let length = x.hypot(y);
        assert!(length == length.round(), "a Pythagorean normal");
        let n = [rational(x) / rational(length), rational(y) / rational(length)];
        let t = [n[1].clone(), -n[0].clone()];
        [n, t]
    }

    /// The wrench about the origin of a unit force along the axis (a, b).
    fn map(&self, [a, b]: &[Rational; 2]) -> [Rational; 3] {
        let [x, y] = self.point.map(rational);
        [a.clone(), b.clone(), x * b - y * a]
    }

    fn branch(&self, state: State) -> Branch {
        let maps = self.frame().map(|axis| self.map(&axis));
        let spring = |axis: usize, a: f64| {
            let stretch = Affine { slope: maps[axis].each_ref().map(|g| -g), constant: rational(a) };
            stretch.scaled(&rational(self.stiffness[axis]))
        };
        let (normal, trial) = (spring(0, self.press), spring(1, 0.0));
        let [rest, edge] = self.friction.map(|mu| normal.scaled(&rational(mu)));
        let minus = |f: &Affine<Rational>| f.scaled(&-Rational::one());
        let none = normal.scaled(&Rational::zero());
        let (force, conditions) = match state {
            State::Open => ([none.clone(), none], vec![minus(&normal)]),
            State::Stuck => {
                let inside = vec![normal.clone(), rest.plus(&trial), rest.plus(&minus(&trial))];
                ([normal, trial], inside)
            }
            State::Forward => {
                let ahead = vec![normal.clone(), trial.plus(&minus(&edge))];
                ([normal, edge], ahead)
            }
            State::Backward => {
                let back = vec![normal.clone(), minus(&trial.plus(&edge))];
                ([normal, minus(&edge)], back)
            }
        };
        let [n, t] = maps;
        let wrench = std::array::from_fn(|k| force[0].scaled(&n[k]).plus(&force[1].scaled(&t[k])));
        Branch { force, wrench, conditions: conditions.iter().map(Affine::in_integers).collect() }
    }
}

impl Scene {
    /// A random scene of two to four fingers around an object.
    pub fn random(random: &mut Random) -> Self {
        let turns = [[1.0, 0.0], [4.0, 3.0], [12.0, 5.0], [15.0, 8.0]];
        let mut contact = || {
            let point = [0, 0].map(|_| random.integer(-8, 8) as f64 * 0.25);
            let [mut x, mut y] = turns[random.index(0, turns.len() - 1)];
            if random.integer(0, 1) == 0 {
                (x, y) = (y, x);
            }
            let inward = |c: f64, at: f64| if at > 0.0 { -c } else { c };
            let friction = random.integer(1, 4) as f64 * 0.25;
            let falls = [0.25, 0.5, 0.75, 0.875][random.index(0, 3)];
            Datum {
                point,
                normal: [inward(x, point[0]), inward(y, point[1])],
                stiffness: [0, 0].map(|_| random.integer(1, 20) as f64),
                friction: [friction, friction * falls],
                press: random.integer(1, 16) as f64 / 16.0,
            }
        };
        let contacts: Vec<_> = (0..4).map(|_| contact()).collect();
        let contacts = contacts[..random.index(2, 4)].to_vec();
        let mut base = [0.0; 3];
        for datum in &contacts {
            let pushed = datum.map(&datum.frame()[0]).map(|g| float(&g) * datum.stiffness[0] * datum.press);
            base.iter_mut().zip(pushed).for_each(|(load, w)| *load -= w);
        }
        Self { contacts, base, more: [0, 0, 0].map(|_| random.integer(-16, 16) as f64) }
    }

    /// The base load plus `times` the load on top of it.
    pub fn load(&self, times: f64) -> Wrench {
        let [x, y, spin] = std::array::from_fn(|k| self.base[k] + times * self.more[k]);
        Wrench::new([x, y], spin)
    }

    /// The factor of the load at which the first contact slides, and that contact. `None` if no
    /// contact slides, one opens first, two conditions fail at once, or a contact does not stick at the base.
    pub fn first_slip(&self) -> Option<(Rational, usize)> {
        let stuck: Vec<_> = self.contacts.iter().map(|datum| vec![datum.branch(State::Stuck)]).collect();
        let at = |part: &Rational| Balance::of(&stuck, &self.exact_load(part)).twist(&[0; 4]);
        let (from, to) = (at(&Rational::zero())?, at(&Rational::one())?);
        let mut first: Option<(Rational, usize, bool)> = None;
        for (i, branch) in stuck.iter().enumerate() {
            for (k, condition) in branch[0].conditions.iter().enumerate() {
                let value = |q: &Point| Rational::new(condition.at(q), q.denominator.clone());
                let (a, b) = (value(&from), value(&to));
                if !a.is_positive() {
                    return None;
                }
                if b < a {
                    let part = &a / (&a - b);
                    match &first {
                        Some((least, ..)) if part == *least => return None,
                        Some((least, ..)) if part > *least => {}
                        _ => first = Some((part, i, k > 0)),
                    }
                }
            }
        }
        first.filter(|(_, _, slides)| *slides).map(|(part, i, _)| (part, i))
    }

    fn exact_load(&self, part: &Rational) -> [Rational; 3] {
        std::array::from_fn(|k| rational(self.base[k]) + rational(self.more[k]) * part)
    }

    /// All combinations of contact states that satisfy the law at this load factor, if contact `begun` no longer sticks.
    pub fn catches(&self, part: &Rational, begun: usize) -> Vec<Catch> {
        let branches: Vec<Vec<Branch>> =
            self.contacts.iter().map(|datum| ALL.map(|state| datum.branch(state)).into()).collect();
        let balance = Balance::of(&branches, &self.exact_load(part));
        let mut list = Vec::new();
        let mut at = vec![0; branches.len()];
        loop {
            let chosen: Vec<&Branch> = branches.iter().zip(&at).map(|(list, &k)| &list[k]).collect();
            let states: Vec<State> = at.iter().map(|&k| ALL[k]).collect();
            if states[begun] != State::Stuck
                && let Some(q) = balance.twist(&at)
                && chosen.iter().flat_map(|branch| &branch.conditions).all(|c| !c.at(&q).is_negative())
            {
                list.push(Catch { states, forces: chosen.iter().map(|branch| branch.forces(&q)).collect() });
            }
            let Some(next) = (0..at.len()).find(|&i| at[i] + 1 < ALL.len()) else { return list };
            at[next] += 1;
            at[..next].fill(0);
        }
    }
}

impl Branch {
    fn forces(&self, q: &Point) -> [f64; 2] {
        self.force.each_ref().map(|force| {
            let scale = common_denominator(force.numbers());
            quotient(force.times(&scale).at(q), scale * &q.denominator)
        })
    }
}

/// The equations of equilibrium for contacts in given states, with each row scaled to integers.
struct Balance {
    load: [BigInt; 3],
    wrenches: Vec<Vec<[Affine<BigInt>; 3]>>,
}

impl Balance {
    fn of(branches: &[Vec<Branch>], load: &[Rational; 3]) -> Self {
        let scale: [BigInt; 3] = std::array::from_fn(|row| {
            let numbers = branches.iter().flatten().flat_map(|branch| branch.wrench[row].numbers());
            common_denominator(numbers.chain([&load[row]]))
        });
        let whole = |branch: &Branch| std::array::from_fn(|row| branch.wrench[row].times(&scale[row]));
        Self {
            load: std::array::from_fn(|row| times(&load[row], &scale[row])),
            wrenches: branches.iter().map(|list| list.iter().map(whole).collect()).collect(),
        }
    }

    /// The twist at which contacts in these states balance the load; `None` if the system of equations is singular.
    fn twist(&self, at: &[usize]) -> Option<Point> {
        cramer(&std::array::from_fn(|row| {
            let zero = || [(); 3].map(|()| BigInt::ZERO);
            let alone = Affine { slope: zero(), constant: self.load[row].clone() };
            self.wrenches.iter().zip(at).fold(alone, |sum, (list, &k)| sum.plus(&list[k][row]))
        }))
    }
}

impl Catch {
    /// Whether a contact slides.
    pub fn slides(&self, i: usize) -> bool {
        matches!(self.states[i], State::Forward | State::Backward)
    }

    /// The largest difference of a contact force from the library's contact force, relative to the largest force.
    pub fn off(&self, state: &Equilibrium) -> f64 {
        let off = self.forces.iter().zip(&state.contacts);
        let off = off.map(|([n, t], told)| (n - told.force[0]).hypot(t - told.force[1]));
        off.fold(0.0, f64::max) / state.largest_force()
    }
}
