//! Which of a million grasps holds an object best in every orientation?
//!
//! `cargo run --release -p reports --bin screen_grasps` samples three-finger grasps on a point cloud with normals. For each it finds the multiple of
//! its weight at which the first finger slides, for gravity in 26 directions, and keeps the weakest direction. It prints the ten best grasps, checked
//! with `Grasp::onset`, and the throughput, also of gradients; it draws the distribution over the million.

mod gradients;

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use grasp_lcp::Error;
use grasp_lcp::picture::{Chart, Stroke};
use grasp_lcp::screening::ScreeningVerdict;
use grasp_lcp::spatial::{Batch, Contact, Fingers, Grasp, Pull, Ramp, Wrench};
use grasp_lcp::sweep::map_watched;
use nalgebra::Vector3;

const GRASPS: usize = 1_000_000;
/// Number of grasps that a thread samples and screens as one task.
const CHUNK: usize = 4096;
const POINTS: usize = 20_000;
const WEIGHT: f64 = 4.0; // N
const SQUEEZE: f64 = 6e-3; // m, of each finger
const BEST: usize = 10;
/// Bins of the histogram, and the multiple of the weight at its end.
const BINS: usize = 50;
const MOST: f64 = 2.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cloud = bottle();
    let start = Instant::now();
    let chunks: Vec<usize> = (0..GRASPS.div_ceil(CHUNK)).collect();
    let shown = AtomicUsize::new(0);
    let parts = map_watched(
        &chunks,
        |&chunk| screen(&cloud, chunk),
        |progress| {
            let tenths = 10 * progress.answered / progress.of;
            if shown.fetch_max(tenths, Ordering::Relaxed) < tenths {
                eprint!("\r{:3} %", 10 * tenths);
            }
            ControlFlow::Continue(())
        },
    );
    eprintln!();
    let mut all = Part::default();
    for part in parts.into_iter().flatten() {
        all.absorb(part?);
    }
    let seconds = start.elapsed().as_secs_f64();

    println!(
        "{GRASPS} grasps of three fingers on {POINTS} points, gravity in {} directions",
        directions().len()
    );
    println!(
        "  {:.1} s: {:.2} million grasps a second, {:.1} million onsets a second, {} threads",
        seconds,
        GRASPS as f64 / seconds * 1e-6,
        (GRASPS * directions().len()) as f64 / seconds * 1e-6,
        rayon::current_num_threads()
    );
    gradients::print_cost(&cloud)?;
    let share = |count: usize| 100.0 * count as f64 / GRASPS as f64;
    println!(
        "  {:5.1} % do not even hold the squeeze: a finger would slide or open",
        share(all.not_sticking)
    );
    println!("  {:5.1} % slide under their own weight in some direction", share(all.too_weak));
    println!("  {:5.1} % hold in every direction", share(all.holding()));
    println!("  {:5.1} % unclear: a finger on the edge of its cone", share(all.unclear));

    println!("\nThe ten best: the multiple of the weight at which a finger slides, in the weakest direction");
    println!("{:>8}  {:>24}  {:>10}  contact points (mm)", "multiple", "gravity along", "checked");
    for found in &all.best {
        let direction = directions()[found.weakest];
        let off = check(&cloud, found)?;
        let points = found.fingers.map(|i| cloud[i].0.map(|x| (1e3 * x).round()));
        let points: Vec<_> = points.iter().map(|p| format!("({} {} {})", p.x, p.y, p.z)).collect();
        println!(
            "{:>8.4}  {:>8.3}{:>8.3}{:>8.3}  {off:>10.1e}  {}",
            found.multiple,
            direction.x,
            direction.y,
            direction.z,
            points.join(" ")
        );
    }
    support::save("screen_grasps.svg", &picture(&cloud, &all)?)?;
    Ok(())
}

type Cloud = Vec<(Vector3<f64>, Vector3<f64>)>;

/// Points on a bottle 20 cm high, with normals into it, both with the errors of a depth camera: half a millimetre and two degrees. The centre of mass
/// is the origin.
fn bottle() -> Cloud {
    let mut random = Random(1);
    let radius = |z: f64| 0.035 - 0.02 / (1.0 + (-(z - 0.05) / 0.012).exp());
    let slope = |z: f64| (radius(z + 1e-6) - radius(z - 1e-6)) / 2e-6;
    let point = |_| {
        let (z, angle) = (random.between(-0.09, 0.11), random.between(0.0, std::f64::consts::TAU));
        let (sin, cos) = angle.sin_cos();
        let mut noise = || Vector3::from_fn(|_, _| random.between(-1.0, 1.0));
        let point = Vector3::new(radius(z) * cos, radius(z) * sin, z) + 5e-4 * noise();
        let normal = Vector3::new(-cos, -sin, slope(z)).normalize() + 0.035 * noise();
        (point, normal.normalize())
    };
    (0..POINTS).map(point).collect()
}

/// The 26 directions of gravity: along the axes of the body, and halfway between two and three of them.
fn directions() -> Vec<Vector3<f64>> {
    let steps = || [-1.0, 0.0, 1.0].into_iter();
    let all = steps().flat_map(|x| steps().flat_map(move |y| steps().map(move |z| Vector3::new(x, y, z))));
    all.filter(|v| v.norm() > 0.0).map(|v| v.normalize()).collect()
}

/// The weight along a direction, at the centre of mass.
fn weight(direction: Vector3<f64>) -> Wrench {
    Wrench::force(direction * WEIGHT)
}

/// A rubber fingertip that is pressed into the object along the normal.
fn finger((point, normal): &(Vector3<f64>, Vector3<f64>)) -> Contact {
    Contact::new(*point, *normal).series_stiffness(900.0, 600.0).friction(0.6).command([SQUEEZE, 0.0, 0.0])
}

/// A grasp with the multiple of the weight that it holds in the weakest direction.
#[derive(Debug, Clone, Copy)]
struct Found {
    multiple: f64,
    weakest: usize,
    fingers: [usize; 3],
}

/// Results of screening some grasps.
#[derive(Debug, Clone)]
struct Part {
    best: Vec<Found>,
    histogram: [usize; BINS],
    not_sticking: usize,
    too_weak: usize,
    unclear: usize,
}

impl Default for Part {
    fn default() -> Self {
        Self { best: Vec::new(), histogram: [0; BINS], not_sticking: 0, too_weak: 0, unclear: 0 }
    }
}

impl Part {
    fn holding(&self) -> usize {
        self.histogram.iter().sum::<usize>() - self.too_weak
    }

    fn absorb(&mut self, other: Self) {
        for (here, there) in self.histogram.iter_mut().zip(other.histogram) {
            *here += there;
        }
        self.not_sticking += other.not_sticking;
        self.too_weak += other.too_weak;
        self.unclear += other.unclear;
        self.best.extend(other.best);
        self.best.sort_by(|a, b| b.multiple.total_cmp(&a.multiple));
        self.best.truncate(BEST);
    }
}

/// Samples and screens one chunk. Its grasps depend only on the number of the chunk, not on threads.
fn screen(cloud: &Cloud, chunk: usize) -> Result<Part, Error> {
    let mut random = Random(1 + chunk as u64);
    let grasps: Vec<[usize; 3]> =
        (chunk * CHUNK..GRASPS.min((chunk + 1) * CHUNK)).map(|_| sample(cloud, &mut random)).collect();
    let mut batch = Batch::<3>::with_capacity(grasps.len());
    for grasp in &grasps {
        batch.push(&Fingers::new(&grasp.map(|i| finger(&cloud[i])))?);
    }
    let pulls = directions().into_iter().map(|direction| Pull::new(&Wrench::ZERO, &weight(direction)));
    let pulls: Vec<_> = pulls.collect::<Result<_, _>>()?;
    let mut answers = Vec::new();
    batch.onsets_into(&pulls, &mut answers);
    let mut part = Part::default();
    for (&fingers, answers) in grasps.iter().zip(answers.chunks(pulls.len())) {
        let (mut multiple, mut weakest, mut verdict) = (f64::INFINITY, 0, ScreeningVerdict::Never);
        for (k, answer) in answers.iter().enumerate() {
            match (answer.verdict(), answer.factor()) {
                (_, Some(factor)) if factor < multiple => (multiple, weakest) = (factor, k),
                (ScreeningVerdict::Leaves | ScreeningVerdict::Never, _) => {}
                (worse, _) => verdict = worse,
            }
        }
        match verdict {
            ScreeningVerdict::Never => {
                part.too_weak += usize::from(multiple < 1.0);
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                // `multiple` is not negative, and the conversion saturates.
                let bin = (multiple / MOST * BINS as f64) as usize;
                part.histogram[bin.min(BINS - 1)] += 1;
                part.best.push(Found { multiple, weakest, fingers });
            }
            ScreeningVerdict::NotSticking | ScreeningVerdict::GivesWay => part.not_sticking += 1,
            _ => part.unclear += 1,
        }
    }
    part.absorb(Part::default());
    Ok(part)
}

/// Three points whose normals nearly balance and that lie within a hand's reach of each other.
fn sample(cloud: &Cloud, random: &mut Random) -> [usize; 3] {
    loop {
        let fingers = [0; 3].map(|_| random.below(cloud.len()));
        let [a, b, c] = fingers.map(|i| &cloud[i]);
        let high = [a, b, c].map(|(point, _)| point.z);
        let spread = high[0].max(high[1]).max(high[2]) - high[0].min(high[1]).min(high[2]);
        if (a.1 + b.1 + c.1).norm() < 0.4 && spread < 0.06 {
            return fingers;
        }
    }
}

/// Relative difference between the load factor of screening and that of `Grasp::onset`.
fn check(cloud: &Cloud, found: &Found) -> Result<f64, Box<dyn std::error::Error>> {
    let grasp = Grasp::new(found.fingers.map(|i| finger(&cloud[i])))?;
    let mut least = f64::INFINITY;
    for direction in directions() {
        let ramp = Ramp::load(Wrench::ZERO, weight(direction));
        least = least.min(grasp.onset(&ramp)?.factor().unwrap_or(f64::INFINITY));
    }
    Ok((least / found.multiple - 1.0).abs())
}

/// Distribution of the held multiples, and the places of the best grasps.
fn picture(cloud: &Cloud, all: &Part) -> Result<String, Box<dyn std::error::Error>> {
    let bars = all.histogram.iter().enumerate();
    let bars = bars.map(|(k, &count)| ((k as f64 + 0.5) / BINS as f64 * MOST, 1e-3 * count as f64)).collect();
    let title = format!("What {GRASPS} grasps hold in their weakest direction");
    let histogram =
        Chart::new(title, "multiple of the weight at which a finger slides", "thousands of grasps")
            .series("grasps that hold the squeeze", bars, Stroke::Bars)
            .mark(1.0, "the weight")
            .mark(all.best.first().map_or(MOST, |best| best.multiple), "the best");
    // Places on the unrolled surface: angle around the axis, degrees, and height, mm.
    let seen = |p: &Vector3<f64>| (p.y.atan2(p.x).to_degrees(), 1e3 * p.z);
    let title = "Where the ten best grasps take hold, the surface unrolled";
    let points = cloud.iter().step_by(20).map(|(p, _)| seen(p)).collect();
    let mut view = Chart::new(title, "angle about the axis (°)", "height above the centre of mass (mm)")
        .series("a twentieth of the points", points, Stroke::Dots);
    if let Some((best, others)) = all.best.split_first() {
        let points = |found: &Found| found.fingers.map(|i| seen(&cloud[i].0));
        view = view
            .series("the nine behind", others.iter().flat_map(points).collect(), Stroke::Circles)
            .series("the best", points(best).to_vec(), Stroke::Circles);
    }
    Ok(Chart::sheet(&[histogram, view], 2)?)
}

/// Pseudo-random numbers, the same in every run (splitmix64 of Steele, Lea & Flood, 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, count: usize) -> usize {
        usize::try_from(self.next() % count as u64).unwrap_or_default()
    }
}
