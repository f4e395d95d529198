//! Where a jump ends, against every combination of contact states in exact rational arithmetic.
//!
//! At the load at which the first contact slides each contact is open, slides with its friction of sliding, or has not slid and is within its friction of
//! rest. Every combination is a linear system in rationals. A jump must end in one of those that hold, with no more contacts sliding than any other one has.
//! Where the jump is not caught, and the library says that nothing holds there, none of them holds.

use grasp_lcp::planar::{Beyond, Change, PathEnd};
use grasp_lcp::planar::{Contact, ContactState, Equilibrium, Grasp, Leg, Wrench};
use num_rational::BigRational;
use num_traits::{FromPrimitive, One, Signed, Zero};
use support::splitmix::Random;

type Row = [BigRational; 3];

fn exact(x: f64) -> BigRational {
    BigRational::from_f64(x).expect("finite")
}

fn float(x: &BigRational) -> f64 {
    num_traits::ToPrimitive::to_f64(x).expect("finite")
}

/// A planar contact whose data are rational.
#[derive(Debug)]
pub(super) struct Datum {
    pub(super) point: [f64; 2],
    /// Of integer length.
    pub(super) normal: [f64; 2],
    pub(super) stiffness: [f64; 2],
    /// At rest and sliding.
    pub(super) friction: [f64; 2],
    pub(super) press: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum State {
    Open,
    Sticks,
    Forward,
    Backward,
}

/// A normal force and a tangential one as functions of the twist, `c + s·q`.
struct Branch {
    force: [(BigRational, Row); 2],
    /// All `>= 0`.
    conditions: Vec<(BigRational, Row)>,
}

impl Datum {
    /// Without friction of sliding.
    pub(super) fn plain(&self) -> Contact {
        Contact::new(self.point, self.normal)
            .series_stiffness(self.stiffness[0], self.stiffness[1])
            .friction(self.friction[0])
            .command([self.press, 0.0])
    }

    pub(super) fn contact(&self) -> Contact {
        self.plain().kinetic(self.friction[1])
    }

    fn frame(&self) -> [[BigRational; 2]; 2] {
        let [x, y] = self.normal;
        let length = exact(x.hypot(y).round());
        let n = [exact(x) / &length, exact(y) / &length];
        let t = [n[1].clone(), -n[0].clone()];
        [n, t]
    }

    /// G of an axis, times a number.
    fn wrench(&self, axis: &[BigRational; 2]) -> Row {
        let [x, y] = self.point.map(exact);
        [axis[0].clone(), axis[1].clone(), &x * &axis[1] - &y * &axis[0]]
    }

    fn branch(&self, state: State) -> Branch {
        let [n, t] = self.frame().map(|axis| self.wrench(&axis));
        let [k_n, k_t] = self.stiffness.map(exact);
        let [rest, sliding] = self.friction.map(exact);
        let times = |f: &(BigRational, Row), k: &BigRational| (&f.0 * k, f.1.each_ref().map(|s| s * k));
        let plus = |a: &(BigRational, Row), b: &(BigRational, Row)| {
            (&a.0 + &b.0, std::array::from_fn(|i| &a.1[i] + &b.1[i]))
        };
        let minus = -BigRational::one();
        let stretch = (exact(self.press), n.map(|s| -s));
        let normal = times(&stretch, &k_n);
        let trial = times(&(BigRational::zero(), t.map(|s| -s)), &k_t);
        let edge = times(&normal, &sliding);
        let none = (BigRational::zero(), [(); 3].map(|()| BigRational::zero()));
        match state {
            State::Open => Branch { force: [none.clone(), none], conditions: vec![times(&stretch, &minus)] },
            State::Sticks => {
                let most = times(&normal, &rest);
                let conditions =
                    vec![normal.clone(), plus(&most, &trial), plus(&most, &times(&trial, &minus))];
                Branch { force: [normal, trial], conditions }
            }
            State::Forward => {
                let conditions = vec![normal.clone(), plus(&trial, &times(&edge, &minus))];
                Branch { force: [normal, edge], conditions }
            }
            State::Backward => {
                let against = times(&edge, &minus);
                let conditions = vec![normal.clone(), times(&plus(&trial, &edge), &minus)];
                Branch { force: [normal, against], conditions }
            }
        }
    }
}

fn value((c, s): &(BigRational, Row), q: &Row) -> BigRational {
    c + (0..3).map(|i| &s[i] * &q[i]).sum::<BigRational>()
}

/// The twist at which these balance a load; `None` where the system is singular.
fn balanced(data: &[Datum], branches: &[Branch], load: &Row) -> Option<Row> {
    let mut rows: [[BigRational; 4]; 3] = std::array::from_fn(|k| {
        std::array::from_fn(|j| if j == 3 { -load[k].clone() } else { BigRational::zero() })
    });
    for (datum, branch) in data.iter().zip(branches) {
        for (axis, force) in datum.frame().iter().zip(&branch.force) {
            let map = datum.wrench(axis);
            for k in 0..3 {
                for j in 0..3 {
                    rows[k][j] += &map[k] * &force.1[j];
                }
                rows[k][3] -= &map[k] * &force.0;
            }
        }
    }
    for column in 0..3 {
        let pivot = (column..3).find(|&row| !rows[row][column].is_zero())?;
        rows.swap(column, pivot);
        let lead = rows[column].clone();
        for (row, entries) in rows.iter_mut().enumerate() {
            if row != column && !entries[column].is_zero() {
                let by = &entries[column] / &lead[column];
                for j in column..4 {
                    entries[j] -= &lead[j] * &by;
                }
            }
        }
    }
    Some(std::array::from_fn(|k| &rows[k][3] / &rows[k][k]))
}

/// Contact states with their forces, exactly.
struct Catch {
    states: Vec<State>,
    forces: Vec<[BigRational; 2]>,
}

impl Catch {
    fn slides(&self, i: usize) -> bool {
        matches!(self.states[i], State::Forward | State::Backward)
    }

    fn off(&self, state: &Equilibrium) -> f64 {
        let largest = state.contacts.iter().map(|contact| contact.force.norm()).fold(0.0, f64::max);
        let off = self.forces.iter().zip(&state.contacts).map(|(exact, told)| {
            (float(&exact[0]) - told.force[0]).abs().max((float(&exact[1]) - told.force[1]).abs())
        });
        off.fold(0.0, f64::max) / largest
    }
}

/// Every combination of states that holds at a load after one contact has begun to slide.
fn catches(data: &[Datum], load: &Row, first: usize) -> Vec<Catch> {
    let all = [State::Open, State::Sticks, State::Forward, State::Backward];
    let branches: Vec<Vec<Branch>> =
        data.iter().map(|datum| all.iter().map(|state| datum.branch(*state)).collect()).collect();
    let mut list = Vec::new();
    for code in 0..4_usize.pow(u32::try_from(data.len()).expect("few")) {
        let chosen: Vec<usize> =
            (0..data.len()).map(|i| code / 4_usize.pow(u32::try_from(i).expect("few")) % 4).collect();
        if all[chosen[first]] == State::Sticks {
            continue;
        }
        let these: Vec<Branch> = chosen.iter().zip(data).map(|(k, datum)| datum.branch(all[*k])).collect();
        let Some(q) = balanced(data, &these, load) else { continue };
        let holds = chosen
            .iter()
            .zip(&branches)
            .all(|(k, of)| of[*k].conditions.iter().all(|c| !value(c, &q).is_negative()));
        if holds {
            let forces = these.iter().map(|branch| branch.force.each_ref().map(|f| value(f, &q))).collect();
            list.push(Catch { states: chosen.iter().map(|k| all[*k]).collect(), forces });
        }
    }
    list
}

/// Fingers around an object that press on it, in balance with a load at rest but for its rounding, and a direction to load it in.
pub(super) fn scene(random: &mut Random) -> (Vec<Datum>, [f64; 3], [f64; 3]) {
    let turns =
        [[1.0, 0.0], [0.0, 1.0], [4.0, 3.0], [3.0, 4.0], [12.0, 5.0], [5.0, 12.0], [15.0, 8.0], [8.0, 15.0]];
    let data: Vec<Datum> = (0..random.index(2, 4))
        .map(|_| {
            let point = [0, 0].map(|_| random.integer(-8, 8) as f64 * 0.25);
            let [x, y] = turns[random.index(0, turns.len() - 1)];
            let inward = |c: f64, at: f64| if at > 0.0 { -c } else { c };
            let friction = [0.25, 0.5, 0.75, 1.0][random.index(0, 3)];
            let falls = [0.25, 0.5, 0.75, 0.875][random.index(0, 3)];
            Datum {
                point,
                normal: [inward(x, point[0]), inward(y, point[1])],
                stiffness: [0, 0].map(|_| random.integer(1, 20) as f64),
                friction: [friction, friction * falls],
                press: random.integer(1, 16) as f64 / 16.0,
            }
        })
        .collect();
    let mut base = [0.0; 3];
    for datum in &data {
        let [n, _] = datum.frame();
        let pushed = datum.wrench(&n).map(|w| float(&w) * datum.stiffness[0] * datum.press);
        base.iter_mut().zip(pushed).for_each(|(load, w)| *load -= w);
    }
    (data, base, [0, 0, 0].map(|_| random.integer(-16, 16) as f64))
}

/// The part of the load at which the first contact slides, who and which way; `None` where something else comes first.
fn first_slip(data: &[Datum], base: &Row, more: &Row) -> Option<(BigRational, usize)> {
    let stuck: Vec<Branch> = data.iter().map(|datum| datum.branch(State::Sticks)).collect();
    let sum: Row = std::array::from_fn(|k| &base[k] + &more[k]);
    let [from, to] = [base, &sum].map(|load| balanced(data, &stuck, load));
    let (from, to) = (from?, to?);
    let mut first: Option<(BigRational, usize, bool)> = None;
    for (i, branch) in stuck.iter().enumerate() {
        for (k, condition) in branch.conditions.iter().enumerate() {
            let (a, b) = (value(condition, &from), value(condition, &to));
            if !a.is_positive() {
                return None;
            }
            if b < a {
                let part = &a / (&a - &b);
                if first.as_ref().is_none_or(|(least, ..)| part < *least) {
                    first = Some((part, i, k > 0));
                } else if first.as_ref().is_some_and(|(least, ..)| part == *least) {
                    return None;
                }
            }
        }
    }
    first.filter(|(_, _, slides)| *slides).map(|(part, i, _)| (part, i))
}

#[derive(Debug, Default)]
struct Tally {
    caught: usize,
    joined: usize,
    stuck_again: usize,
    lost: usize,
    at_the_edge: usize,
    fewer: usize,
    elsewhere: usize,
}

#[test]
fn jumps_end_where_rationals_say() {
    let mut random = Random(0x6b69_6e65);
    let (mut tally, mut looked) = (Tally::default(), 0);
    while looked < 2000 {
        let (data, base, more) = scene(&mut random);
        let [exact_base, exact_more] = [base, more].map(|load| load.map(exact));
        let Some((part, first)) = first_slip(&data, &exact_base, &exact_more) else { continue };
        looked += 1;
        // Twice as far as the first slip.
        let far = 2.0 * float(&part);
        let grasp = Grasp::new(data.iter().map(Datum::contact)).unwrap();
        let wrench = |load: [f64; 3]| Wrench::new([load[0], load[1]], load[2]);
        let goal = wrench(std::array::from_fn(|k| base[k] + far * more[k]));
        let mut path = grasp.follow(&wrench(base), &[Leg::load_to(goal)]).unwrap();
        let event = path.next();
        let load: Row = std::array::from_fn(|k| &exact_base[k] + &exact_more[k] * &part);
        let catches = catches(&data, &load, first);
        if let Some(event) = event {
            assert!((event.fraction - 0.5).abs() < 1e-12, "{looked}: {event:?}");
            assert!(matches!(event.changes[..], [ref change] if change.contact.index == first));
            let jump = event.jump.expect("friction falls");
            let sticks = jump.changes.iter().any(|change| matches!(change.what, Change::Sticks));
            if sticks {
                tally.stuck_again += 1;
                continue;
            }
            tally.caught += 1;
            tally.joined +=
                usize::from(jump.changes.iter().any(|change| matches!(change.what, Change::Slides { .. })));
            let told = |i: usize| match jump.state.contacts[i].state {
                ContactState::Separated => State::Open,
                ContactState::Sliding { .. } if jump.state.contacts[i].force[1] > 0.0 => State::Forward,
                ContactState::Sliding { .. } => State::Backward,
                _ => State::Sticks,
            };
            let same = |catch: &&Catch| {
                (0..data.len()).all(|i| catch.states[i] == told(i)) && catch.off(&jump.state) < 1e-10
            };
            let at = catches.iter().find(same).unwrap_or_else(|| panic!("{looked}: {jump:?}"));
            // Where nothing opens, what holds at the end holds all the way there: forces are affine, and cones convex.
            let fewer = |catch: &&Catch| {
                let all = 0..data.len();
                all.clone().all(|i| !catch.slides(i) || at.slides(i))
                    && all.clone().any(|i| at.slides(i) && !catch.slides(i))
            };
            if let Some(fewer) = catches.iter().find(fewer) {
                tally.fewer += 1;
                println!("{looked}: {:?} where {:?} would hold", at.states, fewer.states);
                assert!(fewer.states.contains(&State::Open), "{looked}");
            }
            continue;
        }
        let Some(PathEnd::Lost(loss)) = path.end() else { panic!("{looked}: {:?}", path.end()) };
        assert!((loss.fraction - 0.5).abs() < 1e-12);
        if loss.jumped.is_empty() {
            tally.at_the_edge += 1;
            continue;
        }
        match path.beyond() {
            Some(Beyond::LimitLoad) => {
                tally.lost += 1;
                let states: Vec<_> = catches.iter().map(|catch| catch.states.clone()).collect();
                assert!(catches.is_empty(), "{looked}: {states:?}");
            }
            Some(Beyond::Snap) => {
                tally.elsewhere += 1;
                let states: Vec<_> = catches.iter().map(|catch| catch.states.clone()).collect();
                println!("{looked}: lost, {states:?} holds elsewhere");
            }
            other => panic!("{looked}: {other:?}"),
        }
    }
    println!("{tally:?}");
    assert!(tally.caught > 1500 && tally.joined > 50 && tally.lost > 50);
}
