//! Limit surface of a round patch: the largest combined shear and torsion of a fingertip, and the run time of the path to it.
//!
//! `cargo run --release -p reports --bin limit_surface [most springs]` presses a disc of springs on a body that a stiff arm drags and turns, on the round cone.
//!
//! While everything slides, the friction at a point is μp opposite to its velocity, and the velocities are those of a rigid rotation about a centre.
//! Force and moment then lie on a closed surface, nearly an ellipse (Goyal, Ruina & Papadopoulos 1991; Howe & Cutkosky 1996). Under the pressure of
//! Hertz it has `F = μN` in pure shear and `M = 3π/16 μN R` in pure torsion. In pure torsion rings of springs slide one after the other, which has a
//! closed form.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::time::Instant;

use grasp_lcp::load_path::PathEnd;
use grasp_lcp::nalgebra::SVector;
use grasp_lcp::picture::{Chart, Stroke};
use grasp_lcp::spatial::{Beyond, Contact, Grasp, Leg, Outcome, Wrench};
use support::best_time::repeats;

const RADIUS: f64 = 0.006; // m
const PRESSED: f64 = 10.0; // N
const FRICTION: f64 = 0.5;
/// Tangential stiffness of the whole patch, N/m; the normal stiffness is 1.25 times as large.
const SHEAR: f64 = 5e4;
/// Stiffness of the arm relative to that of the patch.
const ARM: f64 = 1e6;
/// Displacement of the arm in units of `μN / SHEAR`, so large that forces no longer depend on the initial state of the springs.
const FAR: f64 = 300.0;
/// Directions between shear and torsion.
const DIRECTIONS: usize = 24;
const REPEATS: u32 = 3;

fn main() -> Result<(), Box<dyn Error>> {
    let most = std::env::args().nth(1).map_or(Ok(10_000), |most| most.parse())?;
    let patch = Patch::new(1_000, 3)?;
    let surface = patch.limit_surface()?;
    patch.torsion()?;
    ring()?;
    cost(&surface, most)
}

/// A disc of springs under a body, and the ends of an arm that is fixed to it.
struct Patch {
    grasp: Grasp,
    /// Places (m) and normal forces (N) of the springs.
    springs: Vec<([f64; 2], f64)>,
}

/// A motion of the arm from its rest position: shift along x (m) and turn (rad).
type Motion = (f64, f64);

impl Patch {
    fn new(count: usize, ends: usize) -> Result<Self, grasp_lcp::Error> {
        let golden = PI * (3.0 - 5.0_f64.sqrt());
        let area = 1.0 / count as f64;
        let weight = |i: usize| (1.0 - (i as f64 + 0.5) * area).sqrt();
        let whole: f64 = (0..count).map(weight).sum();
        let place = |i: usize| {
            let (sin, cos) = (golden * i as f64).sin_cos();
            let r = RADIUS * ((i as f64 + 0.5) * area).sqrt();
            ([r * cos, r * sin], PRESSED * weight(i) / whole)
        };
        let springs: Vec<_> = (0..count).map(place).collect();
        let k = SHEAR * area;
        let below = springs.iter().map(|([x, y], press)| {
            Contact::new([*x, *y, 0.0], [0.0, 0.0, 1.0])
                .tangent([1.0, 0.0, 0.0])
                .series_stiffness(1.25 * k, k)
                .friction(FRICTION)
                .pressed_with(*press)
        });
        let arm = (0..ends).map(|i| {
            let [x, y] = end(i);
            Contact::new([x, y, 0.0], [0.0, 0.0, 1.0])
                .tangent([1.0, 0.0, 0.0])
                .series_stiffness(ARM * SHEAR, ARM * SHEAR)
                .bonded()
        });
        Ok(Self { grasp: Grasp::new(below.chain(arm).collect::<Vec<_>>())?, springs })
    }

    /// Leg that moves the arm by this motion, straight and evenly.
    fn leg(&self, (shift, turn): Motion) -> Leg {
        let commanded =
            self.grasp.contacts()[..self.springs.len()].iter().map(|c| <[f64; 3]>::from(c.commanded()));
        let arm = (0..3).map(|i| {
            let [x, y] = end(i);
            [0.0, shift - turn * y, turn * x]
        });
        Leg::commands_to(commanded.chain(arm))
    }

    fn weight() -> Wrench {
        Wrench::force([0.0, 0.0, -PRESSED])
    }

    /// Shear force (N) and moment (N m) of the springs, from their forces in contact frames.
    fn pull(&self, forces: &[SVector<f64, 3>]) -> (f64, f64) {
        let each = self.springs.iter().zip(forces);
        each.fold((0.0, 0.0), |(force, moment), (([x, y], _), f)| {
            (force + f[1], moment + x * f[2] - y * f[1])
        })
    }

    /// Shear force (N) and moment (N m) while all springs slide in a rigid motion.
    fn sliding(&self, (shift, turn): Motion) -> (f64, f64) {
        self.springs.iter().fold((0.0, 0.0), |(force, moment), ([x, y], press)| {
            let (vx, vy) = (shift - turn * y, turn * x);
            let most = FRICTION * press / vx.hypot(vy);
            (force - most * vx, moment - most * (x * vy - y * vx))
        })
    }

    /// For each direction between shear and torsion, the force over μN and the moment over 3π/16 μN R at the end of a long displacement of the arm.
    fn limit_surface(&self) -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
        let far = FAR * FRICTION * PRESSED / SHEAR;
        let largest = (FRICTION * PRESSED, 3.0 * PI / 16.0 * FRICTION * PRESSED * RADIUS);
        let (mut points, mut off, mut oval, mut steps) = (Vec::new(), 0.0_f64, 0.0_f64, 0);
        for i in 0..=DIRECTIONS {
            let (sin, cos) = (FRAC_PI_2 * i as f64 / DIRECTIONS as f64).sin_cos();
            let motion = (far * cos, far * sin / RADIUS);
            let mut path = self.grasp.follow_in_steps(Self::weight(), &[self.leg(motion)], 1e-4)?;
            steps += path.by_ref().count();
            if !matches!(path.end(), Some(PathEnd::Completed)) {
                return Err(format!("dragged along {i}: {:?}", path.end().map(ToString::to_string)).into());
            }
            let (force, moment) = self.pull(&path.forces());
            let exact = self.sliding(motion);
            off = off.max((force - exact.0).abs() / largest.0).max((moment - exact.1).abs() / largest.1);
            let point = (-force / largest.0, -moment / largest.1);
            oval = oval.max((point.0.hypot(point.1) - 1.0).abs());
            points.push(point);
        }
        let (shear, torsion) = (points[0].0, points[DIRECTIONS].1);
        println!("{} springs dragged in {} directions, {steps} steps", self.springs.len(), points.len());
        println!("  against rigid sliding of the same springs: {off:.1e} of the largest");
        println!("  pure shear {shear:.6} μN, pure torsion {torsion:.6} of 3π/16 μN R");
        println!("  off the ellipse by {:.1} % at most", 100.0 * oval);
        Ok(points)
    }

    /// Compares pure torsion, in which rings slide one by one, with the sum over springs `M(θ) = Σ r min(k r θ, μ F_n)`. Here θ is the angle, and k
    /// and r are the stiffness and the radius of a spring. On the way back Masing's rule applies.
    fn torsion(&self) -> Result<(), Box<dyn Error>> {
        let (mut worst, most) = (0.0_f64, 2.0 * FRICTION * PRESSED / SHEAR / RADIUS);
        let k = SHEAR / self.springs.len() as f64;
        let moment = |turn: f64| {
            let of = |(place, press): &([f64; 2], f64)| {
                let r = place[0].hypot(place[1]);
                r * (k * r * turn).min(FRICTION * press)
            };
            self.springs.iter().map(of).sum::<f64>()
        };
        for part in [0.1, 0.3, 0.5, 0.8, 1.0] {
            let legs = [self.leg((0.0, part * most)), self.leg((0.0, -0.4 * part * most))];
            let mut path = self.grasp.follow_in_steps(Self::weight(), &legs, 1e-5)?;
            let mut told = [0.0; 2];
            while let Some(step) = path.next() {
                told[step.leg] = -self.pull(&path.forces()).1;
            }
            if !matches!(path.end(), Some(PathEnd::Completed)) {
                return Err(format!("turned: {:?}", path.end().map(ToString::to_string)).into());
            }
            let exact = [moment(part * most), moment(part * most) - 2.0 * moment(0.7 * part * most)];
            for (told, exact) in told.into_iter().zip(exact) {
                worst = worst.max((told - exact).abs() / moment(most));
            }
        }
        println!(
            "pure torsion, there and back, against the rings in closed form: {worst:.1e} of the largest moment"
        );
        Ok(())
    }
}

/// Prints run times for a jar in a ring of springs that all slide at once, pulled along its axis beyond its limit load.
fn ring() -> Result<(), grasp_lcp::Error> {
    for count in [64, 1_024] {
        let spring = |i: usize| {
            let (sin, cos) = (TAU * i as f64 / count as f64).sin_cos();
            Contact::new([cos, sin, 0.0], [-cos, -sin, 0.0])
                .series_stiffness(1e3, 8e2)
                .friction(FRICTION)
                .pressed_with(1.0)
        };
        let jar = Grasp::new((0..count).map(spring))?;
        let limit = FRICTION * count as f64;
        let (mut best, mut held) = (f64::INFINITY, 0.0);
        for _ in 0..repeats(REPEATS) {
            let start = Instant::now();
            let beyond = [Leg::load_to(Wrench::force([0.0, 0.0, -1.25 * limit]))];
            let mut path = jar.follow_in_steps(Wrench::ZERO, &beyond, 1e-6)?;
            path.by_ref().for_each(drop);
            best = best.min(start.elapsed().as_secs_f64());
            held = path.end().and_then(PathEnd::fraction).unwrap_or(1.0);
        }
        println!("ring of {count}: held to {:.12} of its limit in steps, {:.1} ms", 1.25 * held, 1e3 * best);
        at_once(&jar, limit)?;
    }
    Ok(())
}

/// Prints run times at the limit load `limit`: of the onset, the load path to it, the behaviour beyond it, and the equilibrium under a load a quarter
/// larger.
fn at_once(jar: &Grasp, limit: f64) -> Result<(), grasp_lcp::Error> {
    let pull = |part: f64| Wrench::force([0.0, 0.0, -part * limit]);
    let start = Instant::now();
    let onset = jar.onset(pull(1.0))?;
    let found = start.elapsed().as_secs_f64();
    let mut path = jar.follow(Wrench::ZERO, &[Leg::load_to(pull(1.25))])?;
    path.by_ref().for_each(drop);
    let followed = start.elapsed().as_secs_f64();
    let beyond = onset.event().and_then(|event| jar.beyond(event));
    let asked = start.elapsed().as_secs_f64();
    let above = jar.solve(pull(1.25))?;
    let solved = start.elapsed().as_secs_f64();
    let words = match beyond {
        Some(Beyond::LimitLoad) => "a limit load",
        Some(Beyond::Ends { .. }) => "the rates are proved to have no solution",
        _ => "not known",
    };
    let time = |from: f64, to: f64| format!("{:.1} ms", 1e3 * (to - from));
    println!(
        "  onset {}, path {}; beyond: {words}, {}; a quarter above: {}, {}",
        time(0.0, found),
        time(found, followed),
        time(followed, asked),
        if matches!(above, Outcome::NoEquilibrium(_)) { "no equilibrium" } else { "undecided" },
        time(asked, solved)
    );
    Ok(())
}

/// Places at which the arm is attached to the body, m.
fn end(i: usize) -> [f64; 2] {
    let (sin, cos) = (TAU * i as f64 / 3.0).sin_cos();
    [RADIUS * cos, RADIUS * sin]
}

/// Compares error and run time of load paths in steps, without the arm. The patch is sheared, then twisted in addition, then pulled back beyond the
/// start and released.
fn cost(surface: &[(f64, f64)], most: usize) -> Result<(), Box<dyn Error>> {
    let load = |(shear, torsion): (f64, f64)| {
        let most = FRICTION * PRESSED;
        Wrench::new([shear * most, 0.0, -PRESSED], [0.0, 0.0, torsion * most * RADIUS])
    };
    let legs = [(0.6, 0.0), (0.6, 0.35), (-0.4, -0.2), (0.0, 0.0)].map(|pull| Leg::load_to(load(pull)));
    println!(
        "\nshear, torsion beside it, and back: error of forces over the largest, against much finer steps"
    );
    println!("  {:28} {:>8} {:>9} {:>10} {:>10}", "", "steps", "ms", "estimated", "error");
    let mut curves = Vec::new();
    for count in [1_000, 10_000].into_iter().filter(|count| *count <= most) {
        let patch = Patch::new(count, 0)?;
        let follow = |error: f64| {
            let (mut best, mut steps) = (f64::INFINITY, 0);
            let mut path = patch.grasp.follow_in_steps(Patch::weight(), &legs, error)?;
            for _ in 0..if error < 1e-5 { 1 } else { repeats(REPEATS) } {
                let start = Instant::now();
                path = patch.grasp.follow_in_steps(Patch::weight(), &legs, error)?;
                steps = path.by_ref().count();
                best = best.min(start.elapsed().as_secs_f64());
            }
            Ok::<_, grasp_lcp::Error>((path.forces(), path.step_error(), steps, best))
        };
        let (exact, ..) = follow(if count < 5_000 { 1e-7 } else { 1e-6 })?;
        let largest = exact.iter().take(count).map(SVector::norm).fold(0.0, f64::max);
        let off = |forces: &[SVector<f64, 3>]| {
            forces.iter().zip(&exact).take(count).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max) / largest
        };
        let mut curve = Vec::new();
        for error in [1e-2, 1e-3, 1e-4, 1e-5] {
            let (forces, estimated, steps, seconds) = follow(error)?;
            let off = off(&forces);
            curve.push((1e3 * seconds, off));
            println!(
                "  {count:6} springs, error {error:5.0e} {steps:8} {:9.1} {estimated:10.1e} {off:10.1e}",
                1e3 * seconds
            );
        }
        curves.push((format!("{count} springs"), curve));
    }
    let oval = (0..=90).map(|i| f64::from(i).to_radians().sin_cos()).map(|(sin, cos)| (cos, sin)).collect();
    let limits = Chart::new(
        "Limit surface of a disc under Hertz's pressure",
        "shear over μN",
        "moment over 3π/16 μN R",
    )
    .series("springs on the round cone", surface.to_vec(), Stroke::Dots)
    .series("ellipse", oval, Stroke::Dashed);
    let mut costs =
        Chart::new("Shear and torsion there and back", "run time (ms)", "error of forces").log_log();
    for (name, points) in curves {
        costs = costs.series(name, points, Stroke::Line);
    }
    support::save("limit_surface.svg", &Chart::sheet(&[limits, costs], 2)?)?;
    Ok(())
}
