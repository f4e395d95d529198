//! Gradients of screening agree with differences in exact rational arithmetic.
//!
//! At the factor of screening the margin `m = μ² F_n² - |F_t|²` of the critical contact is a rational function of every datum. Central differences Δm
//! over a step of 2⁻⁴⁰ are exact except for the square of the step, and `-Δm / m'` is the change of the factor. No solver and no derivative of the
//! library is used.

use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::screening::{Fingers, Pull, ScreenedGradient};
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use support::samples::{samples, seeded};

type Rational = BigRational;

/// Tolerance of derivatives, relative to the largest derivative with respect to the same kind of data, for example all points.
const CLOSE: f64 = 1e-9;

fn exact(x: f64) -> Rational {
    Rational::from_float(x).expect("finite")
}

/// The step of differences, small compared with every datum here.
fn step() -> Rational {
    exact(2_f64.powi(-40))
}

fn dot(a: &[Rational], b: &[Rational]) -> Rational {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[derive(Clone)]
struct Exact {
    point: Vec<Rational>,
    normal: Vec<Rational>,
    k: [Rational; 2],
    command: Vec<Rational>,
    friction: Rational,
}

impl Exact {
    /// The force of the springs at a displacement.
    fn stretched(&self, u: &[Rational]) -> Vec<Rational> {
        let along = dot(&self.normal, u) * (&self.k[0] - &self.k[1]);
        u.iter().zip(&self.normal).map(|(u, n)| &self.k[1] * u + &along * n).collect()
    }

    /// The wrench of a force at the contact.
    fn wrench(&self, force: &[Rational]) -> Vec<Rational> {
        let (p, f) = (&self.point, force);
        let turns = |a: usize, b: usize| &p[a] * &f[b] - &p[b] * &f[a];
        let moments =
            if p.len() == 2 { vec![turns(0, 1)] } else { vec![turns(1, 2), turns(2, 0), turns(0, 1)] };
        f.iter().cloned().chain(moments).collect()
    }

    /// The displacement of the object at the contact.
    fn moved(&self, q: &[Rational]) -> Vec<Rational> {
        let axes = self.point.len();
        (0..axes)
            .map(|axis| {
                let unit: Vec<_> = (0..axes).map(|k| exact(f64::from(u8::from(k == axis)))).collect();
                dot(&self.wrench(&unit), q)
            })
            .collect()
    }

    /// The contact with its normal tilted in a perpendicular direction; the command tilts with it.
    fn tilted(&self, across: &[Rational]) -> Self {
        let (mut tilted, along) = (self.clone(), dot(&self.normal, &self.command));
        let sheared: Vec<_> = self.command.iter().zip(&self.normal).map(|(a, n)| a - &along * n).collect();
        let back = dot(&sheared, across);
        for axis in 0..across.len() {
            tilted.normal[axis] = &self.normal[axis] + &across[axis];
            tilted.command[axis] =
                &along * &tilted.normal[axis] + &sheared[axis] - &back * &self.normal[axis];
        }
        tilted
    }
}

/// The force of one contact under a load while every contact sticks.
fn force(contacts: &[Exact], of: usize, load: &[Rational]) -> Vec<Rational> {
    let size = load.len();
    let mut rows: Vec<Vec<Rational>> = vec![vec![Rational::zero(); size + 1]; size];
    for column in 0..=size {
        for contact in contacts {
            let unit: Vec<_> = (0..size).map(|k| exact(f64::from(u8::from(k == column)))).collect();
            let u = if column == size { contact.command.clone() } else { contact.moved(&unit) };
            for (row, entry) in contact.wrench(&contact.stretched(&u)).into_iter().enumerate() {
                rows[row][column] += entry;
            }
        }
    }
    for (row, entry) in load.iter().enumerate() {
        rows[row][size] += entry;
    }
    for pivot in 0..size {
        let lead = rows[pivot].clone();
        assert!(!lead[pivot].is_zero(), "stiffnesses are positive");
        for row in rows.iter_mut().skip(pivot + 1) {
            let factor = &row[pivot] / &lead[pivot];
            for column in pivot..=size {
                row[column] -= &factor * &lead[column];
            }
        }
    }
    let mut q = vec![Rational::zero(); size];
    for row in (0..size).rev() {
        let known: Rational = (row + 1..size).map(|k| &rows[row][k] * &q[k]).sum();
        q[row] = (&rows[row][size] - known) / &rows[row][row];
    }
    let contact = &contacts[of];
    let u: Vec<_> = contact.command.iter().zip(contact.moved(&q)).map(|(a, moved)| a - moved).collect();
    contact.stretched(&u)
}

/// The margin `μ² F_n² - |F_t|²`.
fn margin(contacts: &[Exact], of: usize, load: &[Rational]) -> Rational {
    let (contact, force) = (&contacts[of], force(contacts, of, load));
    // The normal need not have exactly unit length.
    let normal = dot(&contact.normal, &force);
    let square = dot(&contact.normal, &contact.normal);
    let pressed = &contact.friction * &contact.friction * &normal * &normal / &square;
    pressed - (dot(&force, &force) - &normal * &normal / square)
}

struct Scene {
    contacts: Vec<Exact>,
    base: Vec<Rational>,
    direction: Vec<Rational>,
    factor: Rational,
    leaves: usize,
}

impl Scene {
    fn load(&self, base: &[Rational], factor: &Rational) -> Vec<Rational> {
        base.iter().zip(&self.direction).map(|(base, direction)| base + factor * direction).collect()
    }

    /// The difference of the margin m between both sides of a change of the data.
    fn difference(
        &self,
        change: impl Fn(&mut Vec<Exact>, &mut Vec<Rational>, &mut Rational, Rational),
    ) -> Rational {
        let [above, below] = [step(), -step()].map(|step| {
            let (mut contacts, mut base, mut factor) =
                (self.contacts.clone(), self.base.clone(), self.factor.clone());
            change(&mut contacts, &mut base, &mut factor, step);
            margin(&contacts, self.leaves, &self.load(&base, &factor))
        });
        above - below
    }
}

/// A change of contacts and base load by a step.
type Change<'a> = dyn Fn(&mut Vec<Exact>, &mut Vec<Rational>, Rational) + 'a;

/// The largest difference of derivatives, relative to the largest derivative with respect to the same kind of data.
fn off(pairs: &[(f64, f64)]) -> f64 {
    let size = pairs.iter().map(|(_, exact)| exact.abs()).fold(0.0, f64::max);
    pairs.iter().map(|(ours, exact)| (ours - exact).abs()).fold(0.0, f64::max) / size
}

fn worst_field<const C: usize>(scene: &Scene, ours: &ScreenedGradient<'_, C>) -> f64 {
    let by_factor = scene.difference(|_, _, factor, step| *factor += step);
    let by = |change: &Change<'_>| {
        let moved = scene.difference(|contacts, base, _, step| change(contacts, base, step));
        (-moved / &by_factor).to_f64().expect("a number")
    };
    let mut fields: [Vec<(f64, f64)>; 6] = Default::default();
    for i in 0..scene.contacts.len() {
        let normal = &scene.contacts[i].normal;
        for axis in 0..C {
            fields[0].push((ours.point(i)[axis], by(&|c, _, step| c[i].point[axis] += step)));
            fields[1].push((ours.command(i)[axis], by(&|c, _, step| c[i].command[axis] += step)));
            // The component of a coordinate axis perpendicular to the normal.
            let across = |step: &Rational| -> Vec<Rational> {
                (0..C)
                    .map(|k| (exact(f64::from(u8::from(k == axis))) - &normal[axis] * &normal[k]) * step)
                    .collect()
            };
            fields[2].push((ours.normal(i)[axis], by(&|c, _, step| c[i] = c[i].tilted(&across(&step)))));
        }
        for k in 0..2 {
            fields[3].push((ours.stiffness(i)[k], by(&|c, _, step| c[i].k[k] += step)));
        }
        fields[4].push((ours.friction(i), by(&|c, _, step| c[i].friction += step)));
    }
    for (k, ours) in ours.base_load().iter().enumerate() {
        fields[5].push((*ours, by(&|_, base, step| base[k] += step)));
    }
    fields.iter().map(|field| off(field)).fold(0.0, f64::max)
}

/// The largest error of a field over some sliding grasps.
fn worst<const D: usize, const C: usize, const N: usize>(grasps: usize) -> f64 {
    let (mut random, mut worst, mut count) = (seeded(10 * N as u64 + C as u64), 0.0_f64, 0);
    while count < samples(grasps) {
        let mut number = || random.signed();
        let mut given = [([0.0; C], 0.0); N];
        let contacts: [Contact<C>; N] = std::array::from_fn(|i| {
            let out: [f64; C] = std::array::from_fn(|_| number());
            let length = out.iter().map(|x| x * x).sum::<f64>().sqrt();
            let point = out.map(|x| x / length + 0.3);
            let mut command = [0.0; C];
            (command[0], command[1]) = (0.1, 0.01 * number());
            given[i] = (point, 0.6 + 0.3 * number());
            Contact::new(point, out.map(|x| -x / length + 0.2 * number()))
                .series_stiffness(10.0 * (2.0 + number()), 8.0 * (2.0 + number()))
                .friction(given[i].1)
                .command(command)
        });
        let [base, direction] = [0.02, 0.5]
            .map(|size| Wrench::from_components(&(0..D).map(|_| size * number()).collect::<Vec<_>>()));
        let fingers = Fingers::<C, N>::new(&contacts).unwrap();
        let gradients = fingers.onset_gradients(&Pull::new(&base, &direction).unwrap());
        let Some(ours) = gradients.get(0).filter(|gradient| !gradient.is_one_sided()) else { continue };
        let grasp = grasp_lcp::ask::Grasp::new(contacts.iter().cloned()).unwrap();
        let frames = grasp.frames();
        let exactly = contacts.iter().zip(frames).zip(given).map(|((contact, frame), (point, friction))| {
            let column = |k: usize| frame.column(k).iter().copied().map(exact).collect::<Vec<_>>();
            let command = contact.commanded();
            let turned = (0..C).map(|axis| (0..C).map(|k| exact(frame[(axis, k)]) * exact(command[k])).sum());
            let k = contact.series_stiffness_of_axes();
            Exact {
                point: point.into_iter().map(exact).collect(),
                normal: column(0),
                k: [k[0], k[1]].map(exact),
                command: turned.collect(),
                friction: exact(friction),
            }
        });
        let scene = Scene {
            contacts: exactly.collect(),
            base: base.components().iter().copied().map(exact).collect(),
            direction: direction.components().iter().copied().map(exact).collect(),
            factor: exact(ours.screened().factor().unwrap()),
            leaves: ours.contact().unwrap(),
        };
        worst = worst.max(worst_field(&scene, &ours));
        count += 1;
    }
    worst
}

#[test]
fn in_the_plane() {
    for worst in [worst::<3, 2, 2>(2), worst::<3, 2, 3>(1), worst::<3, 2, 5>(1)] {
        assert!(worst < CLOSE, "{worst}");
    }
}

#[test]
fn in_space() {
    for worst in [worst::<6, 3, 3>(1), worst::<6, 3, 4>(1)] {
        assert!(worst < CLOSE, "{worst}");
    }
}
