//! Is the load that a grasp holds with standard deviations in reserve as safe as claimed, and how much larger could it be?
//!
//! `cargo run --release -p reports --bin reserve [samples [directions]]`
//!
//! Random grasps are pulled in random directions, and two scenes in directions all around. The load with reserve is compared with the quantile of
//! sampled onsets.

use std::f64::consts::{PI, TAU};
use std::time::Instant;

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::Ramp;
use grasp_lcp::scene::Scene;
use grasp_lcp::sweep::Uncertainty;
use grasp_lcp::{planar, spatial};
use support::Failure;
use support::splitmix::Random;

const GRASPS: usize = 100;
const SIGMAS: f64 = 3.0;
/// Probability Φ(-3) that a normal variable lies three standard deviations or more below its mean.
const TAIL: f64 = 0.001_349_898_031_630_094_5;

fn main() -> Result<(), Failure> {
    let samples = std::env::args().nth(1).map_or(Ok(20_000), |count| count.parse::<u64>())?;
    let directions = std::env::args().nth(2).map_or(Ok(60), |count| count.parse::<usize>())?;
    println!(
        "{SIGMAS} standard deviations in reserve, {samples} samples of each grasp, {:.1} of which may slide below\n",
        TAIL * samples as f64
    );
    println!(
        "                                                     slide below          (reserve − quantile) / onset     reserve below"
    );
    println!(
        "grasps  in         not known                     most  expected by chance      5 %   median     95 %    0.8 quantile    µs a direction"
    );
    let known = Uncertainty::seeded(3).with_friction(0.1).with_stiffness(0.1).with_squeeze(0.05);
    let places = known.with_position(5e-4).with_normal(0.02).with_load(0.05);
    for (off, what) in [(known, "friction, stiffness, squeeze"), (places, "and places, normals, load")] {
        let mut random = Random(17);
        let mut plane = Tally::default();
        while plane.grasps < GRASPS {
            let count = 2 + random.index(0, 3);
            let grasp = planar::Grasp::new((0..count).map(|i| {
                let angle = TAU * (i as f64 + between(&mut random, -0.2, 0.2)) / count as f64;
                let contact = planar::Contact::new(
                    [0.03 * angle.cos(), 0.03 * angle.sin()],
                    [
                        between(&mut random, -0.1, 0.1) - angle.cos(),
                        between(&mut random, -0.1, 0.1) - angle.sin(),
                    ],
                );
                contact
                    .series_stiffness(between(&mut random, 5e2, 4e3), between(&mut random, 5e2, 3e3))
                    .friction(between(&mut random, 0.3, 0.9))
                    .pressed_with(between(&mut random, 5.0, 12.0))
            }))?;
            let [x, y, at] = [(); 3].map(|()| between(&mut random, -1.0, 1.0));
            plane.add(&grasp, planar::Wrench::force_at([x, y], [0.01 * at, 0.0]), &off, samples)?;
        }
        plane.print("the plane", what);
        let mut space = Tally::default();
        while space.grasps < GRASPS {
            let count = 3 + random.index(0, 2);
            let grasp = spatial::Grasp::new((0..count).map(|i| {
                let angle = TAU * (i as f64 + between(&mut random, -0.2, 0.2)) / count as f64;
                let point = [0.03 * angle.cos(), 0.03 * angle.sin(), between(&mut random, -0.01, 0.01)];
                let normal = [
                    between(&mut random, -0.1, 0.1) - angle.cos(),
                    between(&mut random, -0.1, 0.1) - angle.sin(),
                    between(&mut random, -0.1, 0.1),
                ];
                spatial::Contact::new(point, normal)
                    .series_stiffness(between(&mut random, 5e2, 4e3), between(&mut random, 5e2, 3e3))
                    .friction(between(&mut random, 0.3, 0.9))
                    .pressed_with(between(&mut random, 5.0, 12.0))
            }))?;
            let [x, y, z, at] = [(); 4].map(|()| between(&mut random, -1.0, 1.0));
            space.add(&grasp, spatial::Wrench::force_at([x, y, z], [0.01 * at, 0.0, 0.0]), &off, samples)?;
        }
        space.print("space", what);
    }
    for scene in ["paper_two_fingers", "bottle"] {
        all_around(scene, &known, samples, directions)?;
    }
    println!(
        "\nGrasps that slide at rest more often than that have no reserve, and are counted as 0. By chance: four standard deviations of the number that is expected."
    );
    Ok(())
}

/// Prints a row for a scene of the repository, pulled in `directions` directions, about evenly spaced all around.
fn all_around(name: &str, off: &Uncertainty, samples: u64, directions: usize) -> Result<(), Failure> {
    let path = format!("{}/../scenes/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let scene = Scene::from_json(&std::fs::read(path)?)?;
    let mut tally = Tally::default();
    if let Some(setup) = scene.planar() {
        let grasp = setup.grasp()?;
        for k in 0..directions {
            let (sin, cos) = (TAU * k as f64 / directions as f64).sin_cos();
            tally.add(&grasp, planar::Wrench::force([cos, sin]), off, samples)?;
        }
    } else {
        let grasp = scene.setup.grasp()?;
        for k in 0..directions {
            // Directions on a spiral over the sphere.
            let z = 1.0 - (2 * k + 1) as f64 / directions as f64;
            let (sin, cos) = (PI * (3.0 - 5.0_f64.sqrt()) * k as f64).sin_cos();
            let r = (1.0 - z * z).sqrt();
            tally.add(&grasp, spatial::Wrench::force([r * cos, r * sin, z]), off, samples)?;
        }
    }
    tally.print("", &format!("directions of {name}"));
    Ok(())
}

/// A random number between `low` and `high`.
fn between(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * random.uniform()
}

#[derive(Default)]
struct Tally {
    grasps: usize,
    most: usize,
    may: f64,
    /// Number of loads with reserve that are below four fifths of the sampled quantile.
    far_below: usize,
    short: Vec<f64>,
    microseconds: Vec<f64>,
}

impl Tally {
    /// Adds a grasp, unless no contact ever slides under a load in this direction.
    fn add<const C: usize>(
        &mut self,
        grasp: &Grasp<C>,
        direction: Wrench<C>,
        off: &Uncertainty,
        samples: u64,
    ) -> Result<(), Failure> {
        let ramp = Ramp::load(Wrench::ZERO, direction);
        let Some(onset) = grasp.onset(&ramp)?.factor().filter(|onset| *onset > 0.0 && onset.is_finite())
        else {
            return Ok(());
        };
        let reserve = grasp.reserve(Wrench::ZERO, off, SIGMAS)?;
        let start = Instant::now();
        let held = reserve.along(&direction);
        self.microseconds.push(1e6 * start.elapsed().as_secs_f64());
        let mut onsets = Vec::new();
        for onset in grasp.onset_of_samples(&ramp, off, samples) {
            onsets.push(onset?.factor().unwrap_or(0.0));
        }
        onsets.sort_by(f64::total_cmp);
        let expected = TAIL * samples as f64;
        let quantile = onsets[onsets.len() * 135 / 100_000];
        self.grasps += 1;
        self.most = self.most.max(onsets.partition_point(|onset| *onset < held));
        self.may = expected + 4.0 * expected.sqrt();
        self.far_below += usize::from(held < 0.8 * quantile);
        self.short.push((held - quantile) / onset);
        Ok(())
    }

    fn print(&mut self, place: &str, what: &str) {
        let at = |list: &mut Vec<f64>, percent: usize| {
            list.sort_by(f64::total_cmp);
            list[(list.len() - 1) * percent / 100]
        };
        println!(
            "{:6}  {place:9}  {what:28}  {:4}  at most {:.0}         {:7.1} % {:7.1} % {:7.1} %       {:5.1} %    {:.0}",
            self.grasps,
            self.most,
            self.may,
            100.0 * at(&mut self.short, 5),
            100.0 * at(&mut self.short, 50),
            100.0 * at(&mut self.short, 95),
            100.0 * self.far_below as f64 / self.grasps as f64,
            at(&mut self.microseconds, 50),
        );
    }
}
