//! A million planar pairs and a million spatial triples in Rust: the other half of `batch.py`.
//!
//! Grasps are made from flat arrays of numbers, as a Python user has them, pushed into a batch and screened on all cores.

use std::time::Instant;

use grasp_lcp::screening::Screened;
use grasp_lcp::sweep::onsets_of_batch;
use grasp_lcp::{Error, planar, spatial};

const GRASPS: usize = 1_000_000;
const REPEATS: usize = 5;

/// The golden ratio's part beyond one: its multiples spread evenly over the unit interval.
const SPREAD: f64 = 0.618_033_988_749_894_9;

/// A number between 0 and 1 for each datum of each grasp, the same in `batch.py`.
fn number(grasp: usize, datum: usize) -> f64 {
    ((grasp as f64 + 1.0) * SPREAD + datum as f64 * 0.137).fract()
}

fn planar_pairs(points: &[f64], friction: &[f64], answers: &mut Vec<Screened>) -> Result<(), Error> {
    let pull = planar::Pull::new(&planar::Wrench::ZERO, &planar::Wrench::force([0.1, -1.0]))?;
    let mut batch = planar::Batch::<2>::with_capacity(GRASPS);
    for (points, mu) in points.chunks_exact(4).zip(friction) {
        let finger = |x: f64, y: f64, n: f64| {
            planar::Contact::new([x, y], [n, 0.0])
                .series_stiffness(1e3, 8e2)
                .friction(*mu)
                .command([0.01, 0.0])
        };
        batch.push(&planar::Fingers::new(&[
            finger(points[0], points[1], 1.0),
            finger(points[2], points[3], -1.0),
        ])?);
    }
    onsets_of_batch(&batch, &[pull], answers);
    Ok(())
}

fn spatial_triples(points: &[f64], friction: &[f64], answers: &mut Vec<Screened>) -> Result<(), Error> {
    let pull = spatial::Pull::new(&spatial::Wrench::ZERO, &spatial::Wrench::force([0.1, 0.2, -1.0]))?;
    let mut batch = spatial::Batch::<3>::with_capacity(GRASPS);
    for (points, mu) in points.chunks_exact(9).zip(friction) {
        let finger = |i: usize| {
            let p = [points[3 * i], points[3 * i + 1], points[3 * i + 2]];
            spatial::Contact::new(p, [-p[0], -p[1], 0.0])
                .series_stiffness(9e2, 6e2)
                .friction(*mu)
                .command([0.006, 0.0, 0.0])
        };
        batch.push(&spatial::Fingers::new(&[finger(0), finger(1), finger(2)])?);
    }
    onsets_of_batch(&batch, &[pull], answers);
    Ok(())
}

/// The best time, and a sum of the factors that tells whether Python has the same answers.
fn report(name: &str, mut run: impl FnMut(&mut Vec<Screened>) -> Result<(), Error>) -> Result<(), Error> {
    let (mut answers, mut best) = (Vec::new(), f64::INFINITY);
    for _ in 0..REPEATS {
        let start = Instant::now();
        run(&mut answers)?;
        best = best.min(start.elapsed().as_secs_f64());
    }
    let bits =
        answers.iter().filter_map(Screened::factor).fold(0_u64, |sum, x| sum.wrapping_add(x.to_bits()));
    let found = answers.iter().filter(|answer| answer.factor().is_some()).count();
    let pace = GRASPS as f64 / best * 1e-6;
    println!("{name:16} {best:8.3} s  {pace:6.2} million a second  {found} factors, sum of bits {bits:016x}");
    Ok(())
}

fn main() -> Result<(), Error> {
    let friction: Vec<f64> = (0..GRASPS).map(|g| 0.3 + 0.4 * number(g, 0)).collect();
    let pairs: Vec<f64> = (0..GRASPS)
        .flat_map(|g| [-0.04, 0.02 * (number(g, 1) - 0.5), 0.04, 0.02 * (number(g, 2) - 0.5)])
        .collect();
    let triples: Vec<f64> = (0..GRASPS)
        .flat_map(|g| {
            let z = |i| 0.02 * (number(g, i) - 0.5);
            let y = |i| 0.03 + 0.01 * number(g, i);
            [-0.04, 0.0, z(1), 0.02, y(2), z(3), 0.02, -y(4), z(5)]
        })
        .collect();
    report("planar pairs", |answers| planar_pairs(&pairs, &friction, answers))?;
    report("spatial triples", |answers| spatial_triples(&triples, &friction, answers))
}
