//! At the factor of screening, contacts in exact rational arithmetic are on or inside their cones, for three contacts in space.
//!
//! With rational normals the numbers of a scene are rational. Forces at factor zero and their rates are computed exactly while every contact sticks.
//! At the factor that screening finds, up to rounding of the forces, no contact is outside its cone and one contact is on the edge. Triangles of
//! contacts are even or slim, with stiffnesses over twelve decades. Screening computes some grasps from the edges of their triangle, and others from
//! motions.

use std::cell::Cell;

use grasp_lcp::screening::ScreeningVerdict;
use grasp_lcp::spatial::{Contact, Fingers, Pull, Wrench};
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use proptest::prelude::*;
use support::elimination::Eliminated;
use support::random::for_all;
use support::samples::assert_met;

type Rational = BigRational;
type Vector = [Rational; 3];

/// For each contact: offset of its point from the point opposite to its normal; normal, followed by the length of the normal; both stiffnesses;
/// friction; command.
type Datum = ([f64; 3], [i32; 4], [f64; 2], f64, [f64; 2]);

fn exact(x: f64) -> Rational {
    Rational::from_float(x).expect("finite")
}

fn float(x: &Rational) -> f64 {
    x.to_f64().expect("a number")
}

fn dot(a: &Vector, b: &Vector) -> Rational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|k| &a[(k + 1) % 3] * &b[(k + 2) % 3] - &a[(k + 2) % 3] * &b[(k + 1) % 3])
}

/// A contact whose data are exact rational numbers.
struct Exact {
    point: Vector,
    normal: Vector,
    k: [Rational; 2],
    command: Vector,
    friction: f64,
}

impl Exact {
    fn new(point: [f64; 3], &(_, [i, j, k, length], stiffness, friction, [press, shear]): &Datum) -> Self {
        let normal = [i, j, k].map(|c| Rational::new(c.into(), length.into()));
        // The shear command acts along the contact's given tangent.
        let tangent = tangent([i, j, k]).map(|c| exact(f64::from(c)));
        let command = [0, 1, 2].map(|a| exact(press) * &normal[a] + exact(shear) * &tangent[a]);
        Self { point: point.map(exact), normal, k: stiffness.map(exact), command, friction }
    }

    /// The force of the springs at a displacement.
    fn stretched(&self, u: &Vector) -> Vector {
        let along = dot(&self.normal, u) * (&self.k[0] - &self.k[1]);
        [0, 1, 2].map(|a| &self.k[1] * &u[a] + &along * &self.normal[a])
    }

    /// The wrench of a force at the contact.
    fn wrench(&self, force: Vector) -> Vec<Rational> {
        let moment = cross(&self.point, &force);
        force.into_iter().chain(moment).collect()
    }

    /// The displacement of the object at the contact.
    fn moved(&self, q: &[Rational]) -> Vector {
        let turn = [0, 1, 2].map(|a| q[3 + a].clone());
        let turned = cross(&turn, &self.point);
        [0, 1, 2].map(|a| &q[a] + &turned[a])
    }
}

/// A unit tangent for a normal along a coordinate axis, zero for other normals.
fn tangent([i, j, k]: [i32; 3]) -> [i32; 3] {
    match [i, j, k].map(i32::abs) {
        [_, 0, 0] => [0, 1, 0],
        [0, _, 0] => [0, 0, 1],
        [0, 0, _] => [1, 0, 0],
        _ => [0; 3],
    }
}

/// Motions of the object under two loads, by elimination.
fn motions(contacts: &[Exact], loads: &[Vec<Rational>; 2]) -> Option<[Vec<Rational>; 2]> {
    let mut rows: Vec<Vec<Rational>> = vec![vec![Rational::zero(); 6]; 6];
    for column in 0..6 {
        let mut unit = vec![Rational::zero(); 6];
        unit[column] = exact(1.0);
        for contact in contacts {
            let wrench = contact.wrench(contact.stretched(&contact.moved(&unit)));
            for row in 0..6 {
                rows[row][column] += &wrench[row];
            }
        }
    }
    let beside = |(row, mut entries): (usize, Vec<Rational>)| {
        entries.extend(loads.iter().map(|load| load[row].clone()));
        entries
    };
    Eliminated::of(rows.into_iter().enumerate().map(beside), 6).solutions()?.try_into().ok()
}

/// Forces of all contacts at factor zero, and their rates.
fn forces(contacts: &[Exact], direction: [f64; 6]) -> Option<[Vec<Vector>; 2]> {
    let mut commanded = vec![Rational::zero(); 6];
    for contact in contacts {
        for (sum, part) in commanded.iter_mut().zip(contact.wrench(contact.stretched(&contact.command))) {
            *sum += part;
        }
    }
    let [q, dq] = motions(contacts, &[commanded, direction.map(exact).to_vec()])?;
    let force = |contact: &Exact, q: &[Rational], command: bool| {
        let moved = contact.moved(q);
        let u = [0, 1, 2].map(|a| if command { &contact.command[a] - &moved[a] } else { -moved[a].clone() });
        contact.stretched(&u)
    };
    Some(
        [(q, true), (dq, false)].map(|(q, command)| contacts.iter().map(|c| force(c, &q, command)).collect()),
    )
}

/// The margin `μ F_n - |F_t|`, without cancellation of rounded numbers.
fn margin(contact: &Exact, force: &Vector) -> f64 {
    let normal = dot(&contact.normal, force);
    let pressed = &normal * exact(contact.friction);
    let friction = dot(force, force) - &normal * &normal;
    let [n, t] = [float(&pressed), float(&friction).sqrt()];
    if n < 0.0 { n - t } else { float(&(&pressed * &pressed - friction)) / (n + t) }
}

fn size(forces: &[Vector]) -> f64 {
    forces.iter().flatten().map(|x| float(x).abs()).fold(0.0, f64::max)
}

/// Results of the scenes of one kind.
#[derive(Default)]
struct Worst {
    /// Largest deviation from zero of the margin `μ F_n - |F_t|` of the sliding contact, relative to the forces.
    off: Cell<f64>,
    leaving: Cell<usize>,
    unclear: Cell<usize>,
}

/// Results for stiffnesses over `decades`, and triangles of contacts narrower by the factor `narrow`.
fn worst(decades: f64, narrow: f64, cases: usize, normals: &[[i32; 4]]) -> Worst {
    let unit = || -1.0..1.0_f64;
    let stiffness = || (-decades / 2.0..=decades / 2.0).prop_map(|e| 10_f64.powf(e));
    let normal = prop::sample::select(normals.to_vec());
    let place = [-0.4..0.4, -0.4..0.4, -0.4..0.4_f64];
    let datum = (place, normal, [stiffness(), stiffness()], 0.5..3.0_f64, [0.1..0.3_f64, -0.02..0.02_f64]);
    let question = (prop::collection::vec(datum, 3), [unit(), unit(), unit(), unit(), unit(), unit()]);
    let worst = Worst::default();
    for_all(file!(), cases, &question, |(data, direction)| {
        let point = |&(off, [i, j, k, length], ..): &Datum| {
            let opposite = [i, j, k].map(|c| -f64::from(c) / f64::from(length));
            std::array::from_fn(|a| (opposite[a] + off[a]) * if a == 0 { 1.0 } else { narrow })
        };
        let contacts: [Contact; 3] = std::array::from_fn(|i| {
            let (_, [x, y, z, _], [k, kt], friction, [press, shear]) = data[i];
            let contact = Contact::new(point(&data[i]), [x, y, z].map(f64::from));
            let contact = if tangent([x, y, z]) == [0; 3] {
                contact.command([press, 0.0, 0.0])
            } else {
                contact.tangent(tangent([x, y, z]).map(f64::from)).command([press, shear, 0.0])
            };
            contact.series_stiffness(k, kt).friction(friction)
        });
        let pull = Pull::new(&Wrench::ZERO, &Wrench::from_vector(direction)).unwrap();
        let screened = Fingers::new(&contacts).unwrap().onset(&pull);
        let contacts: Vec<_> = data.iter().map(|datum| Exact::new(point(datum), datum)).collect();
        let Some([base, rates]) = forces(&contacts, direction) else { return Ok(()) };
        let least = |forces: &[Vector]| {
            contacts.iter().zip(forces).map(|(c, f)| margin(c, f)).fold(f64::INFINITY, f64::min)
        };
        match screened.verdict() {
            ScreeningVerdict::Leaves => {
                let factor = exact(screened.factor().unwrap());
                let at = |(f, d): (&Vector, &Vector)| [0, 1, 2].map(|a| &f[a] + &factor * &d[a]);
                let there: Vec<_> = base.iter().zip(&rates).map(at).collect();
                let off = least(&there).abs() / (4.0 * (size(&base) + float(&factor) * size(&rates)));
                worst.off.set(worst.off.get().max(off));
                worst.leaving.set(worst.leaving.get() + 1);
            }
            ScreeningVerdict::NotSticking => prop_assert!(least(&base) < 1e-11 * size(&base)),
            ScreeningVerdict::Never => {
                let far = exact(1e9 * size(&base) / size(&rates));
                let at = |(f, d): (&Vector, &Vector)| [0, 1, 2].map(|a| &f[a] + &far * &d[a]);
                let there: Vec<_> = base.iter().zip(&rates).map(at).collect();
                prop_assert!(least(&there) > -1e-10 * size(&there));
            }
            _ => worst.unclear.set(worst.unclear.get() + 1),
        }
        Ok(())
    });
    worst
}

/// Normals of unit length: STRAIGHT have components that are exact doubles, SLANTED have others.
const STRAIGHT: [[i32; 4]; 6] =
    [[1, 0, 0, 1], [-1, 0, 0, 1], [0, 1, 0, 1], [0, -1, 0, 1], [0, 0, 1, 1], [0, 0, -1, 1]];
const SLANTED: [[i32; 4]; 6] =
    [[1, 2, 2, 3], [-2, 3, 6, 7], [4, -4, 7, 9], [-2, -1, -2, 3], [6, 2, -3, 7], [-1, -4, -8, 9]];

#[test]
fn even_triangles() {
    let Worst { off, leaving, unclear } = worst(0.0, 1.0, 50, &SLANTED);
    assert_met(&[(leaving.get(), 16)]);
    assert!(off.get() < 5e-16 && unclear.get() == 0, "{off:?} {leaving:?} {unclear:?}");
}

/// Results that depend on the height of a slim triangle have the relative rounding error of this height.
#[test]
fn slim_triangles() {
    for narrow in [0.1, 1e-2, 1e-4] {
        let Worst { off, leaving, .. } = worst(0.0, narrow, 33, &SLANTED);
        assert_met(&[(leaving.get(), 3)]);
        assert!(off.get() < 2e-14 / narrow, "{narrow} {off:?} {leaving:?}");
    }
}

#[test]
fn stiffnesses_over_decades() {
    for (decades, bound) in [(2.0, 1e-14), (4.0, 5e-14), (12.0, 5e-14)] {
        let Worst { off, leaving, .. } = worst(decades, 1.0, 50, &STRAIGHT);
        assert_met(&[(leaving.get(), 3)]);
        assert!(off.get() < bound, "{decades} {off:?} {leaving:?}");
    }
}
