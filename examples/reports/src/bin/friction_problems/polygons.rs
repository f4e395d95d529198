//! The round cone compared with polygons: error and run time.

use super::{median, timed};
use grasp_lcp::friction::SpatialContacts;
use grasp_lcp::lcp::{Outcome, Settings};
use nalgebra::{DMatrix, DVector};
use support::best_time::repeats;
use support::splitmix::Random;

const POLYGONS: [usize; 3] = [8, 16, 32];
const PROBLEMS: usize = 40;

pub(super) fn print() {
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
}

/// Prints the row of one family and number of contacts.
fn row(family: &str, n: usize, columns: usize, skew: f64) {
    let mut random = Random(n as u64);
    let (mut times, mut missed, mut undecided) = (Vec::new(), Vec::new(), 0);
    let mut polygons = POLYGONS.map(|_| (Vec::new(), Vec::new(), Vec::new()));
    for _ in 0..PROBLEMS {
        let problem = problem(&mut random, n, columns, skew);
        let (time, outcome) = best_of_three(|| problem.solve());
        let Outcome::Solved(solution) = outcome else {
            undecided += 1;
            continue;
        };
        times.push(time);
        missed.push(solution.residuals.max());
        for ((law, off, cost), facets) in polygons.iter_mut().zip(POLYGONS) {
            let (time, polygon) = best_of_three(|| {
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
        // Forces of redundant contacts are not unique, so that they are not compared.
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

fn best_of_three<T>(mut work: impl FnMut() -> T) -> (f64, T) {
    let runs = (0..repeats(3)).map(|_| timed(&mut work));
    runs.min_by(|a, b| a.0.total_cmp(&b.0)).expect("at least one")
}
