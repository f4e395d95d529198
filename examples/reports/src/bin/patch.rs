//! A rubber fingertip pressed and sheared: partial slip grows from the rim inwards, against Cattaneo and Mindlin.
//!
//! `cargo run --release -p reports --bin patch` follows a pad of 10⁴ springs through a whole cycle of shear, every event exact.
//!
//! A sphere of radius R pressed by d into an elastic half-space makes a contact of radius `a = √(R d)`. The method of dimensionality reduction (Popov
//! & Heß, 2015) replaces the half-space by a row of independent springs, E* and G* a unit of length, pressed by `d - x²/R`. Normal force, shear
//! force, displacement and the radius of the stick zone of the row equal those of the sphere. So a planar pad represents the round one, and these are
//! exact (Cattaneo 1938, Mindlin 1949, Mindlin & Deresiewicz 1953):
//!
//! ```text
//! P = 4/3 E* √R d^(3/2)        c/a = (1 - Q/μP)^(1/3)        u = μ E*/G* d (1 - (1 - Q/μP)^(2/3))
//! ```
//!
//! while the shear force Q grows for the first time; on the way back from Q₁ the rim slips back outside `c/a = (1 - (Q₁ - Q)/2μP)^(1/3)`.

use std::error::Error;
use std::time::Instant;

use grasp_lcp::load_path::PathEnd;
use grasp_lcp::picture::{Chart, Stroke};
use grasp_lcp::planar::{Change, Contact, ContactState, Equilibrium, Grasp, Leg, Wrench};

const SPRINGS: usize = 10_000;
const RADIUS: f64 = 0.02; // m
const DEPTH: f64 = 1e-3; // m
const NORMAL: f64 = 1e6; // E*, Pa
const SHEAR: f64 = NORMAL * 2.0 / 3.0; // G*, Pa: rubber, ν = 1/2
const FRICTION: f64 = 0.8;
/// The largest shear force in units of μP.
const MOST: f64 = 0.95;
/// Points of the cycle that are shown: leg and Q/μP.
const SHOWN: [(usize, f64); 6] = [(0, 0.3), (0, 0.6), (0, 0.9), (1, 0.4), (1, -0.3), (1, -0.9)];

fn main() -> Result<(), Box<dyn Error>> {
    let pad = Pad::new()?;
    let legs = [MOST, -MOST, MOST].map(|part| Leg::load_to(pad.load(part)));
    println!(
        "{SPRINGS} springs, contact radius {:.2} mm, P = {:.3} N, μP = {:.3} N",
        1e3 * pad.a,
        pad.press,
        pad.limit
    );

    let (mut events, mut best) = (Vec::new(), f64::INFINITY);
    for _ in 0..5 {
        let start = Instant::now();
        let mut path = pad.grasp.follow_patch(&pad.load(0.0), &legs)?;
        events = path.by_ref().collect();
        best = best.min(start.elapsed().as_secs_f64());
        if !matches!(path.end(), Some(PathEnd::Completed)) {
            return Err("the cycle ended early".into());
        }
    }
    println!(
        "{} events in {:.1} ms: {:.2} µs an event",
        events.len(),
        1e3 * best,
        1e6 * best / events.len() as f64
    );

    // The stick zone: every event of slip is at its edge.
    let mut edges = Vec::new();
    let mut off = [0.0_f64; 2];
    for event in &events {
        let (Change::Slides { .. }, leg @ 0..=1) = (event.change, event.leg) else { continue };
        let part = event.load.to_vector()[0] / pad.limit;
        let exact = if leg == 0 { 1.0 - part } else { 1.0 - (MOST - part) / 2.0 }.cbrt();
        let edge = pad.place(event.contact).abs() / pad.a;
        off[leg] = off[leg].max((edge - exact).abs());
        edges.push((leg, part, edge, exact));
    }
    println!("stick radius c/a against Cattaneo-Mindlin, worst of {} events: {:.1e}", edges.len(), off[0]);
    println!("  and on the way back (Mindlin-Deresiewicz): {:.1e}", off[1]);

    let looked_at = pad.looks(&legs)?;
    let worst = |f: fn(&Look) -> f64| looked_at.iter().map(f).fold(0.0, f64::max);
    println!("displacement against the same, relative to its largest: {:.1e}", worst(|look| look.off));
    println!("residual of the whole law, recomputed: {:.1e}", worst(|look| look.state.residuals.worst()));
    let area = looked_at
        .windows(2)
        .filter(|pair| pair[1].leg > 0)
        .map(|pair| 0.5 * (pair[0].part + pair[1].part) * (pair[1].displacement - pair[0].displacement));
    let lost = area.sum::<f64>() * pad.limit;
    println!("energy lost in a cycle: {:.6} mJ, exact {:.6} mJ", 1e3 * lost, 1e3 * pad.loss());

    let sheet =
        [pad.radius_chart(&edges), pad.traction_chart(&legs)?, pad.loop_chart(&looked_at), pad.zones(&legs)?];
    support::save("patch.svg", &Chart::sheet(&sheet, 2)?)?;
    Ok(())
}

struct Pad {
    grasp: Grasp,
    a: f64,
    /// P and μP, N.
    press: f64,
    limit: f64,
}

/// The cycle at one load.
struct Look {
    leg: usize,
    /// Q/μP.
    part: f64,
    displacement: f64,
    /// Error of the displacement, relative to the largest displacement.
    off: f64,
    state: Equilibrium,
}

impl Pad {
    fn new() -> Result<Self, Box<dyn Error>> {
        let a = (RADIUS * DEPTH).sqrt();
        let width = 2.0 * a / SPRINGS as f64;
        let press = |x: f64| DEPTH - x * x / RADIUS;
        let places = || (0..SPRINGS).map(|i| (i as f64 + 0.5) * width - a);
        let spring = |x: f64| {
            Contact::new([x, 0.0], [0.0, 1.0])
                .series_stiffness(NORMAL * width, SHEAR * width)
                .friction(FRICTION)
                .command([press(x), 0.0])
        };
        // Total force of the springs; 4/3 E* √R d^(3/2) as their number grows.
        let force = places().map(|x| NORMAL * width * press(x)).sum::<f64>();
        Ok(Self { grasp: Grasp::new(places().map(spring))?, a, press: force, limit: FRICTION * force })
    }

    fn place(&self, contact: usize) -> f64 {
        self.grasp.contacts()[contact].point()[0]
    }

    /// Load that presses the pad, and shears it by a part of μP.
    fn load(&self, part: f64) -> Wrench {
        Wrench::new([part * self.limit, -self.press], 0.0)
    }

    /// The displacement when Q has grown to this part of μP for the first time.
    fn virgin(part: f64) -> f64 {
        FRICTION * NORMAL / SHEAR * DEPTH * (1.0 - (1.0 - part).powf(2.0 / 3.0))
    }

    /// The displacement on each of the three legs: later ones double the first (Masing).
    fn displacement(leg: usize, part: f64) -> f64 {
        match leg {
            0 => Self::virgin(part),
            1 => Self::virgin(MOST) - 2.0 * Self::virgin(0.5 * (MOST - part)),
            _ => 2.0 * Self::virgin(0.5 * (MOST + part)) - Self::virgin(MOST),
        }
    }

    /// The area of the loop: eight times the work of the first way up to Q₁, less four times that of a straight one.
    fn loss(&self) -> f64 {
        let scale = FRICTION * NORMAL / SHEAR * DEPTH;
        let beside = scale * (MOST - 0.6 * (1.0 - (1.0 - MOST).powf(5.0 / 3.0)));
        self.limit * (4.0 * MOST * Self::virgin(MOST) - 8.0 * beside)
    }

    /// The cycle at many loads.
    fn looks(&self, legs: &[Leg]) -> Result<Vec<Look>, Box<dyn Error>> {
        let mut path = self.grasp.follow_patch(&self.load(0.0), legs)?;
        let steps = 200;
        let mut looks = Vec::new();
        for leg in 0..3 {
            for step in 1..=steps {
                let fraction = f64::from(step) / f64::from(steps);
                while path.next_before(leg, fraction).is_some() {}
                let (from, to) = [(0.0, MOST), (MOST, -MOST), (-MOST, MOST)][leg];
                let part = from + (to - from) * fraction;
                let state = path.state().ok_or("no equilibrium")?;
                let displacement = state.twist.translation()[0];
                let off = (displacement - Self::displacement(leg, part)).abs() / Self::virgin(MOST);
                looks.push(Look { leg, part, displacement, off, state });
            }
        }
        Ok(looks)
    }

    fn radius_chart(&self, edges: &[(usize, f64, f64, f64)]) -> Chart {
        let _ = self;
        let title = "Partial slip grows from the rim inwards";
        let mut chart = Chart::new(title, "shear force Q/μP", "radius of the stick zone c/a");
        for (leg, found, exact) in
            [(0, "going, springs", "Cattaneo-Mindlin"), (1, "coming back, springs", "Mindlin-Deresiewicz")]
        {
            let of = || edges.iter().filter(move |edge| edge.0 == leg);
            let spaced = of().step_by(of().count() / 12 + 1).map(|edge| (edge.1, edge.2)).collect();
            chart = chart
                .series(exact, of().step_by(40).map(|edge| (edge.1, edge.3)).collect(), Stroke::Line)
                .series(found, spaced, Stroke::Circles);
        }
        chart
    }

    fn loop_chart(&self, looks: &[Look]) -> Chart {
        let _ = self;
        let points = looks.iter().map(|look| (1e3 * look.displacement, look.part)).collect();
        let exact = looks
            .iter()
            .step_by(20)
            .map(|look| (1e3 * Self::displacement(look.leg, look.part), look.part))
            .collect();
        Chart::new("A cycle of shear", "displacement (mm)", "shear force Q/μP")
            .series("springs", points, Stroke::Line)
            .series("Mindlin-Deresiewicz", exact, Stroke::Circles)
    }

    /// Shear traction of the sphere from the springs: `τ(r) = -1/π ∫ q'(x) / √(x² - r²) dx` over r < x < a.
    fn traction(&self, state: &Equilibrium, r: f64) -> f64 {
        let width = 2.0 * self.a / SPRINGS as f64;
        let right = &state.contacts[SPRINGS / 2..];
        let lines = right.windows(2).enumerate().map(|(i, pair)| {
            let x = self.place(SPRINGS / 2 + i);
            let slope = (pair[1].force[1] - pair[0].force[1]) / (width * width);
            let depth = |x: f64| if x > r { (x / r).acosh() } else { 0.0 };
            -slope / std::f64::consts::PI * (depth(x + width) - depth(x))
        });
        lines.sum()
    }

    fn traction_chart(&self, legs: &[Leg]) -> Result<Chart, Box<dyn Error>> {
        let mut chart = Chart::new(
            "Shear traction while the force grows",
            "radius r/a",
            "traction over μ times the largest pressure",
        );
        let largest = 2.0 / std::f64::consts::PI * NORMAL * (DEPTH / RADIUS).sqrt();
        let mut path = self.grasp.follow_patch(&self.load(0.0), legs)?;
        let mut found = Vec::new();
        for (_, part) in &SHOWN[..3] {
            while path.next_before(0, part / MOST).is_some() {}
            let state = path.state().ok_or("no equilibrium")?;
            let radii = || (1..100).map(|k| f64::from(k) / 100.0);
            let c = (1.0 - part).cbrt();
            let ellipse = |r: f64, c: f64| (1.0 - (r / c).powi(2)).max(0.0).sqrt();
            let exact = radii().map(|r| (r, ellipse(r, 1.0) - c * ellipse(r, c))).collect();
            let traction = |r: f64| self.traction(&state, r * self.a).abs() / (FRICTION * largest);
            found.extend(radii().step_by(6).map(|r| (r, traction(r))));
            chart = chart.series(format!("Q = {part} μP, Cattaneo-Mindlin"), exact, Stroke::Line);
        }
        chart = chart.series("springs", found, Stroke::Circles);
        Ok(chart)
    }

    /// The zones of the round contact at six loads.
    fn zones(&self, legs: &[Leg]) -> Result<Chart, Box<dyn Error>> {
        let mut path = self.grasp.follow_patch(&self.load(0.0), legs)?;
        let mut dots = [const { Vec::new() }; 3];
        for (k, &(leg, part)) in SHOWN.iter().enumerate() {
            let fraction = if leg == 0 { part / MOST } else { (MOST - part) / (2.0 * MOST) };
            while path.next_before(leg, fraction).is_some() {}
            let state = path.state().ok_or("no equilibrium")?;
            // Distances that make the zones round on the chart, with the legend between the rows.
            let centre = [4.0 * (k % 3) as f64, if k < 3 { 3.5 } else { 0.0 }];
            for i in 0..450 {
                let (r, angle) =
                    (((f64::from(i) + 0.5) / 450.0).sqrt(), f64::from(i) * 2.399_963_229_728_653);
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                // between 0 and the number of springs
                let contact = &state.contacts[((0.5 + 0.5 * r) * SPRINGS as f64) as usize];
                let zone = match contact.state {
                    ContactState::Sliding { direction } if direction[0] < 0.0 => 1,
                    ContactState::Sliding { .. } => 2,
                    _ => 0,
                };
                let (sin, cos) = angle.sin_cos();
                dots[zone].push((centre[0] + r * cos, centre[1] + r * sin));
            }
        }
        let shown = SHOWN.map(|(_, part)| part.to_string());
        let title = format!(
            "Zones at Q/μP = {} (top), then {} (bottom)",
            shown[..3].join(", "),
            shown[3..].join(", ")
        );
        let mut chart = Chart::new(title, "x/a, each zone 4 beside the one before", "y/a, rows 3.5 apart");
        for (name, dots) in ["sticks", "slips one way", "slips the other way"].into_iter().zip(dots) {
            chart = chart.series(name, dots, Stroke::Dots);
        }
        Ok(chart)
    }
}
