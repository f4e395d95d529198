//! How fast and how accurate is the solver of linear complementarity problems?
//!
//! `cargo run --release -p reports --bin lcp_benchmark` prints a row for each family and size: the best time of several solves, the pivots,
//! and the largest scaled residual. With a directory as argument it also writes every problem there, as
//! `family-n.txt`: n, then M row by row, then q, for timing other solvers on the same numbers. With `--bits` it measures no times, and prints only
//! the bits of all solutions.
#![allow(clippy::cast_possible_truncation, clippy::doc_markdown)]

use grasp_lcp::lcp::{Lcp, OutcomeView, Series, Settings, Workspace};
use nalgebra::{DMatrix, DVector};
use std::hint::black_box;
use std::path::PathBuf;
use support::best_time::best;
use support::splitmix::Random;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let argument = std::env::args().nth(1);
    let bits_alone = argument.as_deref() == Some("--bits");
    let directory = argument.filter(|_| !bits_alone).map(PathBuf::from);
    let mut bits = 0_u64;
    if !bits_alone {
        println!("{:<26} {:>5} {:>12} {:>7} {:>10}", "family", "n", "time (µs)", "pivots", "residual");
    }
    for (family, make) in [
        ("definite", definite as fn(usize, &mut Random) -> Lcp),
        ("definite-uniform", definite_uniform),
        ("semidefinite", semidefinite),
        ("planar-contact", planar_contact),
        ("obstacle", obstacle),
    ] {
        for n in [10, 50, 100, 200, 500] {
            let problem = make(n, &mut Random(n as u64));
            if let Some(directory) = &directory {
                std::fs::write(directory.join(format!("{family}-{n}.txt")), text(&problem))?;
            }
            let mut workspace = Workspace::new();
            if !bits_alone {
                timed(family, &problem, &mut workspace);
            }
            if let OutcomeView::Solved(solution) = workspace.solve(&problem, &Settings::default()) {
                bits = solution.z.iter().fold(bits, |bits, z| bits.rotate_left(7) ^ z.to_bits());
            }
        }
    }
    // The bits are the same with and without the feature `simd`.
    println!("bits of all z: {bits:016x}");
    if bits_alone { Ok(()) } else { neighbours() }
}

/// Prints time and accuracy of solving one problem.
fn timed(family: &str, problem: &Lcp, workspace: &mut Workspace) {
    let settings = Settings::default();
    let mut pivots = 0;
    let mut residual = f64::NAN;
    let time = best_time(|| {
        if let OutcomeView::Solved(solution) = workspace.solve(black_box(problem), &settings) {
            pivots = solution.pivots;
            residual = solution.residuals.max();
        }
    });
    println!("{family:<26} {:>5} {time:>12.2} {pivots:>7} {residual:>10.1e}", problem.len());
}

/// n, then M row by row, then q, each number with all its digits.
fn text(problem: &Lcp) -> String {
    let line = |numbers: &mut dyn Iterator<Item = &f64>| {
        numbers.map(|x| format!("{x:e}")).collect::<Vec<_>>().join(" ")
    };
    let mut lines = vec![problem.len().to_string()];
    lines.extend(problem.matrix().row_iter().map(|row| line(&mut row.iter())));
    lines.push(line(&mut problem.vector().iter()));
    lines.join("\n") + "\n"
}

/// Times a series of problems with definite M, in which q changes just enough to change the basis by one pair.
fn neighbours() -> Result<(), Box<dyn std::error::Error>> {
    let n = 100;
    let problem = definite(n, &mut Random(n as u64));
    let direction = DVector::from_fn(n, |i, _| (i as f64).sin());
    let path = grasp_lcp::lcp::Parametric::new(&problem, &direction, Settings::default())?;
    let taus: Vec<f64> = path.take(2).map(|breakpoint| breakpoint.tau).collect();
    let [first, second] = taus[..] else { return Err("two breakpoints expected".into()) };
    let neighbour = problem.vector() + &direction * f64::midpoint(first, second);
    let mut series = Series::new(problem.matrix().clone(), Settings::default())?;
    let mut pivots = [0; 2];
    let time = best_time(|| {
        for (q, pivots) in [problem.vector(), &neighbour].into_iter().zip(&mut pivots) {
            if let Ok(OutcomeView::Solved(solution)) = series.solve(black_box(q)) {
                *pivots = solution.pivots;
            }
        }
    });
    let mut workspace = Workspace::new();
    let cold = best_time(|| {
        black_box(workspace.solve(black_box(&problem), &Settings::default()));
    });
    let warm = time / 2.0;
    println!(
        "neighbouring basis, n = {n}: {warm:.2} µs with {} pivots, {:.3} of a cold solve",
        pivots[1],
        warm / cold
    );
    Ok(())
}

/// The best time of one call in microseconds.
fn best_time(solve: impl FnMut()) -> f64 {
    1e6 * best(solve)
}

fn lcp(m: DMatrix<f64>, q: DVector<f64>) -> Lcp {
    Lcp::new(m, q).expect("the numbers are finite and the sizes match")
}

/// A problem with M = A Aᵀ + I; the entries of A and q are normally distributed.
fn definite(n: usize, random: &mut Random) -> Lcp {
    let a = DMatrix::from_fn(n, n, |_, _| random.normal());
    let q = DVector::from_fn(n, |_, _| random.normal());
    lcp(&a * a.transpose() + DMatrix::identity(n, n), q)
}

/// A problem with M = A Aᵀ + I; the entries of A are uniformly distributed in [0, 1], those of q normally.
fn definite_uniform(n: usize, random: &mut Random) -> Lcp {
    let a = DMatrix::from_fn(n, n, |_, _| random.uniform());
    let q = DVector::from_fn(n, |_, _| random.normal());
    lcp(&a * a.transpose() + DMatrix::identity(n, n), q)
}

/// A problem with M = A Aᵀ of rank n/2. For random complementary z and w, q = w − M z, so that a solution exists.
fn semidefinite(n: usize, random: &mut Random) -> Lcp {
    let a = DMatrix::from_fn(n, n / 2, |_, _| random.normal());
    let m = &a * a.transpose();
    let z = DVector::from_fn(n, |i, _| if i % 2 == 0 { random.uniform() } else { 0.0 });
    let w = DVector::from_fn(n, |i, _| if i % 2 == 1 { random.uniform() } else { 0.0 });
    lcp(m.clone(), w - m * z)
}

/// A rigid body on n/4 springs with Coulomb friction in the plane, on a soft ground that makes its motion unique. Each
/// contact has a normal force, two friction directions and a slip rate; M is copositive and not symmetric.
fn planar_contact(n: usize, random: &mut Random) -> Lcp {
    let contacts = n / 4;
    let size = 4 * contacts;
    let directions: Vec<[f64; 3]> = (0..contacts)
        .flat_map(|_| {
            let angle = std::f64::consts::TAU * random.uniform();
            let (x, y) = (random.normal(), random.normal());
            let (nx, ny) = (-angle.cos(), -angle.sin());
            [[nx, ny, x * ny - y * nx], [ny, -nx, -x * nx - y * ny]]
        })
        .collect();
    // A force displaces the body by the compliance of the ground, and the contact also by its own compliance.
    let compliance = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let mut m = DMatrix::zeros(size, size);
    let mut q = DVector::zeros(size);
    for i in 0..contacts {
        for j in 0..contacts {
            let (ni, ti) = (directions[2 * i], directions[2 * i + 1]);
            let (nj, tj) = (directions[2 * j], directions[2 * j + 1]);
            m[(4 * i, 4 * j)] = compliance(ni, nj);
            for (a, sa) in [(1, 1.0), (2, -1.0)] {
                m[(4 * i, 4 * j + a)] = sa * compliance(ni, tj);
                m[(4 * i + a, 4 * j)] = sa * compliance(ti, nj);
                for (b, sb) in [(1, 1.0), (2, -1.0)] {
                    m[(4 * i + a, 4 * j + b)] = sa * sb * compliance(ti, tj);
                }
            }
        }
        for (a, sa) in [(1, 1.0), (2, -1.0)] {
            for (b, sb) in [(1, 1.0), (2, -1.0)] {
                m[(4 * i + a, 4 * i + b)] += 0.1 * sa * sb;
            }
            m[(4 * i + a, 4 * i + 3)] = 1.0;
            m[(4 * i + 3, 4 * i + a)] = -1.0;
            q[4 * i + a] = sa * random.normal();
        }
        m[(4 * i, 4 * i)] += 0.1;
        m[(4 * i + 3, 4 * i)] = 0.2 + 0.6 * random.uniform();
        q[4 * i] = random.normal() - 0.5;
    }
    lcp(m, q)
}

/// A string over a bump: the three-point Laplacian and an obstacle, the classical free-boundary problem.
fn obstacle(n: usize, _: &mut Random) -> Lcp {
    let h = 1.0 / (n as f64 + 1.0);
    let m = DMatrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
        0 => 2.0,
        1 => -1.0,
        _ => 0.0,
    });
    let bump = |i: usize| 0.5 - 8.0 * ((i as f64 + 1.0) * h - 0.45).powi(2);
    let obstacle = DVector::from_fn(n, |i, _| bump(i));
    lcp(m.clone(), m * obstacle + DVector::from_element(n, h * h))
}
