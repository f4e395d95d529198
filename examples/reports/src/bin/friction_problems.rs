//! Frictional contact problems (W, q, μ): the round cone beside polygons, error against run time.
//!
//! `cargo run --release -p reports --bin friction_problems` prints, for random problems of several sizes, how far the forces of polygons miss Coulomb's law, how
//! far they are from those of the round cone, and the median times. With a file of a problem (n, then the rows of W, q and μ, as numbers) it
//! solves that one: `-- problem.txt 3` for contacts in space, `2` in the plane.

use grasp_lcp::friction::{FrictionProblem, Solution, SpatialContacts};
use grasp_lcp::lcp::{Outcome, Settings};
use nalgebra::{DMatrix, DVector};
use std::time::Instant;
use support::splitmix::Random;

const POLYGONS: [usize; 3] = [8, 16, 32];
const PROBLEMS: usize = 40;

fn main() -> Result<(), support::Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [file, components] = &arguments[..] {
        let text = std::fs::read_to_string(file)?;
        let outcome = if components == "2" { read::<2>(&text)?.solve() } else { read::<3>(&text)?.solve() };
        println!("{outcome}");
        if let Outcome::Solved(solution) = outcome {
            tell(&solution);
        }
        return Ok(());
    }
    println!(
        "{PROBLEMS} problems each; missed: the law, in the median; off: forces of the polygon from those on the round cone."
    );
    println!("{:<34}{:>12}{:>10}   polygons of 8, 16, 32 facets:", "", "round cone", "missed");
    println!("{:<59}missed, off, time over that of the round cone", "");
    for (family, columns, skew) in
        [("definite", None, 0.0), ("one body, redundant", Some(6), 0.0), ("nonsymmetric", None, 0.2)]
    {
        for n in [2, 4, 8, 16] {
            row(family, n, columns.unwrap_or(3 * n + 2), skew);
        }
    }
    Ok(())
}

/// One family and size.
fn row(family: &str, n: usize, columns: usize, skew: f64) {
    let mut random = Random(n as u64);
    let (mut times, mut missed, mut undecided) = (Vec::new(), Vec::new(), 0);
    let mut polygons = POLYGONS.map(|_| (Vec::new(), Vec::new(), Vec::new()));
    for _ in 0..PROBLEMS {
        let problem = problem(&mut random, n, columns, skew);
        let (time, outcome) = timed(|| problem.solve());
        let Outcome::Solved(solution) = outcome else {
            undecided += 1;
            continue;
        };
        times.push(time);
        missed.push(solution.residuals.max());
        for ((law, off, cost), facets) in polygons.iter_mut().zip(POLYGONS) {
            let (time, polygon) = timed(|| {
                let polygon = problem.facets(facets).expect("numbers near one");
                let outcome = polygon.lcp.solve_with(&Settings::default());
                outcome.solution().map(|solution| polygon.forces(&solution.z).expect("it fits"))
            });
            if let Some(r) = polygon {
                law.push(problem.residuals(&r).max());
                off.push((&r - &solution.r).amax() / solution.r.amax());
                cost.push(time);
            }
        }
    }
    let round = median(&mut times);
    print!("{:<34}{:>9.3} ms{:>10.0e}  ", format!("{family}, {n} contacts"), round, median(&mut missed));
    for (law, off, cost) in &mut polygons {
        // Forces of redundant contacts are not unique.
        let off = if columns == 6 && n > 2 { "-".to_string() } else { format!("{:.0e}", median(off)) };
        print!("{:>8.0e} {:>6} {:>5.1}", median(law), off, median(cost) / round);
    }
    println!("{}", if undecided == 0 { String::new() } else { format!("   {undecided} undecided") });
}

fn problem(random: &mut Random, n: usize, columns: usize, skew: f64) -> SpatialContacts {
    let h = DMatrix::from_fn(3 * n, columns, |_, _| random.normal());
    let v = DVector::from_fn(columns, |_, _| random.normal());
    let a = DMatrix::from_fn(3 * n, 3 * n, |_, _| skew * random.normal());
    let mu = (0..n).map(|_| 0.1 + random.uniform()).collect();
    SpatialContacts::new(&h * h.transpose() / columns as f64 + &a - a.transpose(), h * v, mu).expect("finite")
}

/// The best of three, in milliseconds.
fn timed<T>(mut work: impl FnMut() -> T) -> (f64, T) {
    let mut best = f64::INFINITY;
    let mut run = || {
        let start = Instant::now();
        let out = work();
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
        out
    };
    run();
    run();
    let out = run();
    (best, out)
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

fn read<const C: usize>(text: &str) -> Result<FrictionProblem<C>, support::Failure> {
    let mut words = text.split_whitespace();
    let n: usize = words.next().ok_or("an empty file")?.parse()?;
    let rest: Vec<f64> = words.map(str::parse).collect::<Result<_, _>>()?;
    let size = C * n;
    if rest.len() != size * size + size + n {
        return Err(format!(
            "{} numbers after n = {n}, but W, q and μ have {}",
            rest.len(),
            size * size + size + n
        )
        .into());
    }
    let (w, rest) = rest.split_at(size * size);
    let (q, mu) = rest.split_at(size);
    Ok(FrictionProblem::new(
        DMatrix::from_row_slice(size, size, w),
        DVector::from_column_slice(q),
        mu.to_vec(),
    )?)
}

fn tell(solution: &Solution) {
    let components = solution.r.len() / solution.states.len().max(1);
    for (i, state) in solution.states.iter().enumerate() {
        let at = |v: &DVector<f64>| v.as_slice()[components * i..components * (i + 1)].to_vec();
        println!("  contact {i}: {state:?}, force {:?}, velocity {:?}", at(&solution.r), at(&solution.u));
    }
}
