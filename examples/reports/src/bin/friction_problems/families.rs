//! Hard random contact problems (W, q, μ). W is positive definite, so that a solution exists; masses or compliances are many orders of
//! magnitude apart.

use super::{median, timed};
use grasp_lcp::friction::FrictionProblem;
use grasp_lcp::lcp::Outcome;
use nalgebra::{DMatrix, DVector};
use support::coulomb::missed_law;
use support::splitmix::Random;

const FAMILIES: [(&str, Family); 5] = [
    ("few coordinates, 1e-3 of compliance", few_coordinates),
    ("masses 1e±3", far_apart),
    ("bodies of masses 1e±2, soft contacts", bodies),
    ("nonsymmetric, units 1e±1", nonsymmetric),
    ("contacts in units 1e±3", units),
];

type Family = fn(&mut Random, usize, usize) -> DMatrix<f64>;

pub(super) fn print(each: usize) {
    println!(
        "\n{each} random problems of each family, 1 to 6 contacts, W positive definite; missed: no solution found; law: Coulomb's law at each contact"
    );
    println!("beside its own sums, recomputed here.");
    println!("{:<54}{:>8}{:>12}{:>12}{:>12}", "", "missed", "law", "median ms", "longest ms");
    for (name, family) in FAMILIES {
        row::<3>(name, family, each);
    }
    for (name, family) in FAMILIES {
        row::<2>(name, family, each);
    }
}

fn row<const C: usize>(name: &str, family: Family, each: usize) {
    let mut random = Random(1000 + C as u64);
    let (mut missed, mut worst, mut times) = (0, 0.0_f64, Vec::with_capacity(each));
    for _ in 0..each {
        let n = random.index(1, 6);
        let w = family(&mut random, C, n);
        let q = DVector::from_fn(C * n, |_, _| random.normal());
        let mu = (0..n).map(|_| 0.05 + 1.5 * random.uniform()).collect();
        let problem = FrictionProblem::<C>::new(w, q, mu).expect("finite");
        let (time, outcome) = timed(|| problem.solve());
        times.push(time);
        match outcome {
            Outcome::Solved(solution) => worst = worst.max(missed_law(&problem, &solution.r)),
            _ => missed += 1,
        }
    }
    let space = if C == 3 { "in space" } else { "in the plane" };
    let longest = times.iter().copied().fold(0.0, f64::max);
    let name = format!("{name}, {space}");
    println!("{name:<54}{missed:>8}{worst:>12.1e}{:>12.3}{longest:>12.1}", median(&mut times));
}

fn normal(random: &mut Random, rows: usize, columns: usize) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |_, _| random.normal())
}

/// 10 to a random power between `-far` and `far`.
fn power(random: &mut Random, far: f64) -> f64 {
    10.0_f64.powf(far * (2.0 * random.uniform() - 1.0))
}

fn few_coordinates(random: &mut Random, components: usize, n: usize) -> DMatrix<f64> {
    let size = components * n;
    let columns = random.index(1, size.min(6));
    let h = normal(random, size, columns) * 3.0;
    &h * h.transpose() + DMatrix::identity(size, size) * 1e-3
}

fn far_apart(random: &mut Random, components: usize, n: usize) -> DMatrix<f64> {
    let size = components * n;
    let h = normal(random, size, size + 2);
    let masses = DMatrix::from_diagonal(&DVector::from_fn(size + 2, |_, _| power(random, 3.0)));
    &h * masses * h.transpose()
}

fn bodies(random: &mut Random, components: usize, n: usize) -> DMatrix<f64> {
    let (count, of_each) = (random.index(1, n) + 1, if components == 3 { 6 } else { 3 });
    let mut h = DMatrix::<f64>::zeros(components * n, of_each * count);
    for contact in 0..n {
        let (one, other) = (random.index(0, count - 1), random.index(0, count - 1));
        let mut arms = |body: usize, sign: f64| {
            let own = normal(random, components, of_each) * sign;
            let mut view = h.view_mut((components * contact, of_each * body), (components, of_each));
            view += own;
        };
        arms(one, 1.0);
        if other != one {
            arms(other, -1.0);
        }
    }
    let inverse: Vec<f64> = (0..count).map(|_| power(random, 2.0)).collect();
    let inverse = DMatrix::from_diagonal(&DVector::from_fn(of_each * count, |k, _| inverse[k / of_each]));
    let soft = DVector::from_fn(components * n, |_, _| 10.0_f64.powf(-3.0 * random.uniform()));
    &h * inverse * h.transpose() + DMatrix::from_diagonal(&soft)
}

fn nonsymmetric(random: &mut Random, components: usize, n: usize) -> DMatrix<f64> {
    let size = components * n;
    let (h, a) = (normal(random, size, size + 1), normal(random, size, size));
    scaled(&(&h * h.transpose() + &a - a.transpose()), |_| power(random, 1.0))
}

fn units(random: &mut Random, components: usize, n: usize) -> DMatrix<f64> {
    let h = normal(random, components * n, components * n);
    let unit: Vec<f64> = (0..n).map(|_| power(random, 3.0)).collect();
    scaled(&(&h * h.transpose()), |k| unit[k / components])
}

/// The matrix `D W D` in other units; D is diagonal with the factors that `unit` gives.
fn scaled(w: &DMatrix<f64>, unit: impl FnMut(usize) -> f64) -> DMatrix<f64> {
    let units: Vec<f64> = (0..w.nrows()).map(unit).collect();
    DMatrix::from_fn(w.nrows(), w.ncols(), |i, j| w[(i, j)] * units[i] * units[j])
}
