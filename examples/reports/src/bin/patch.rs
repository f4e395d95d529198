//! A rubber fingertip is pressed and sheared: partial slip grows from the rim inwards, compared with Cattaneo and Mindlin.
//!
//! `cargo run --release -p reports --bin patch` follows a pad of 10⁴ springs through a whole cycle of shear in steps.
//!
//! A sphere of radius R pressed by d into an elastic half-space makes a contact of radius `a = √(R d)`. The method of dimensionality reduction (Popov
//! & Heß, 2015) replaces the half-space by a row of independent springs, E* and G* a unit of length, pressed by `d - x²/R`. The normal force P, shear
//! force Q, displacement u and radius c of the stick zone of the row equal those of the sphere. So a planar pad represents the round one, and the
//! following results are exact (Cattaneo 1938, Mindlin 1949, Mindlin & Deresiewicz 1953):
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
use grasp_lcp::planar::{Contact, ContactState, Equilibrium, Grasp, Leg, Wrench};

const SPRINGS: usize = 10_000;
const RADIUS: f64 = 0.02; // m
const DEPTH: f64 = 1e-3; // m
const NORMAL: f64 = 1e6; // E*, Pa
const SHEAR: f64 = NORMAL * 2.0 / 3.0; // G*, Pa: rubber, ν = 1/2
const FRICTION: f64 = 0.8;
/// The largest shear force in units of μP.
const MOST: f64 = 0.95;
/// Error that a leg may add to forces, relative to the largest force.
const ERROR: f64 = 1e-4;
/// Ends of the legs: the part of the cycle (0 loading, 1 unloading, 2 reloading), and Q/μP.
const ENDS: [(usize, f64); 9] =
    [(0, 0.3), (0, 0.6), (0, 0.9), (0, MOST), (1, 0.4), (1, -0.3), (1, -0.9), (1, -MOST), (2, MOST)];
/// Indices of the leg ends whose zones are drawn.
const SHOWN: [usize; 6] = [0, 1, 2, 4, 5, 6];

fn main() -> Result<(), Box<dyn Error>> {
    let pad = Pad::new()?;
    println!(
        "{SPRINGS} springs, contact radius {:.2} mm, P = {:.3} N, μP = {:.3} N",
        1e3 * pad.a,
        pad.press,
        pad.limit
    );

    let (mut steps, mut best) = (0, f64::INFINITY);
    for _ in 0..5 {
        let start = Instant::now();
        let mut path = pad.grasp.follow_in_steps(pad.load(0.0), &pad.legs(), ERROR)?;
        steps = path.by_ref().count();
        best = best.min(start.elapsed().as_secs_f64());
        if !matches!(path.end(), Some(PathEnd::Completed)) {
            return Err("the cycle ended early".into());
        }
    }
    println!("{steps} steps in {:.1} ms", 1e3 * best);

    let looks = pad.looks()?;
    let mut off = [0.0_f64; 2];
    for edge in looks.iter().filter_map(|look| look.edge) {
        off[edge.way] = off[edge.way].max((edge.found - edge.exact).abs());
    }
    println!("stick radius c/a against Cattaneo-Mindlin, worst of all steps: {:.1e}", off[0]);
    println!("  and on the way back (Mindlin-Deresiewicz): {:.1e}", off[1]);
    let worst = |f: fn(&Look) -> f64| looks.iter().map(f).fold(0.0, f64::max);
    println!("displacement against the same, relative to its largest: {:.1e}", worst(|look| look.off));
    println!("residual of the whole law, recomputed: {:.1e}", worst(|look| look.residual));
    let area = looks
        .windows(2)
        .filter(|pair| pair[1].way > 0)
        .map(|pair| 0.5 * (pair[0].part + pair[1].part) * (pair[1].displacement - pair[0].displacement));
    let lost = area.sum::<f64>() * pad.limit;
    println!("energy lost in a cycle: {:.6} mJ, exact {:.6} mJ", 1e3 * lost, 1e3 * pad.loss());

    let sheet =
        [pad.radius_chart(&looks), pad.traction_chart(&looks)?, pad.loop_chart(&looks), Pad::zones(&looks)?];
    support::save("patch.svg", &Chart::sheet(&sheet, 2)?)?;
    Ok(())
}

struct Pad {
    grasp: Grasp,
    a: f64,
    /// Normal force P and friction limit μP of the pad, N.
    press: f64,
    limit: f64,
}

/// Quantities at the end of a step.
struct Look {
    way: usize,
    /// Shear force as a fraction of its limit, Q/μP.
    part: f64,
    displacement: f64,
    /// Error of the displacement, relative to the largest displacement.
    off: f64,
    residual: f64,
    edge: Option<Edge>,
    /// The equilibrium, if the step ends a leg.
    state: Option<Equilibrium>,
}

/// The radius c of the stick zone over the radius a of the contact, as found and exact.
#[derive(Clone, Copy)]
struct Edge {
    way: usize,
    part: f64,
    found: f64,
    exact: f64,
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
        // Total force of the springs, N. As the number of springs grows, it converges to the force of the sphere, 4/3 E* √R d^(3/2).
        let force = places().map(|x| NORMAL * width * press(x)).sum::<f64>();
        Ok(Self { grasp: Grasp::new(places().map(spring))?, a, press: force, limit: FRICTION * force })
    }

    fn place(&self, contact: usize) -> f64 {
        self.grasp.contacts()[contact].point()[0]
    }

    /// The load that presses the pad with the normal force P and shears it with the fraction `part` of its limit μP.
    fn load(&self, part: f64) -> Wrench {
        Wrench::new([part * self.limit, -self.press], 0.0)
    }

    /// The displacement, m, when the pad is sheared for the first time, at the shear force Q = `part` μP.
    fn virgin(part: f64) -> f64 {
        FRICTION * NORMAL / SHEAR * DEPTH * (1.0 - (1.0 - part).powf(2.0 / 3.0))
    }

    /// The displacement on loading, unloading and reloading, m. Later curves are the first one, doubled in both directions (Masing).
    fn displacement(leg: usize, part: f64) -> f64 {
        match leg {
            0 => Self::virgin(part),
            1 => Self::virgin(MOST) - 2.0 * Self::virgin(0.5 * (MOST - part)),
            _ => 2.0 * Self::virgin(0.5 * (MOST + part)) - Self::virgin(MOST),
        }
    }

    /// The heat of a cycle, J: eight times the area between the curve of first loading up to the largest shear force Q₁ and its chord (Masing).
    fn loss(&self) -> f64 {
        let scale = FRICTION * NORMAL / SHEAR * DEPTH;
        let beside = scale * (MOST - 0.6 * (1.0 - (1.0 - MOST).powf(5.0 / 3.0)));
        self.limit * (4.0 * MOST * Self::virgin(MOST) - 8.0 * beside)
    }

    fn legs(&self) -> [Leg; ENDS.len()] {
        ENDS.map(|(_, part)| Leg::load_to(self.load(part)))
    }

    /// Follows the cycle, and returns the quantities at the end of each step.
    fn looks(&self) -> Result<Vec<Look>, Box<dyn Error>> {
        let mut path = self.grasp.follow_in_steps(self.load(0.0), &self.legs(), ERROR)?;
        let mut looks = Vec::new();
        while let Some(step) = path.next() {
            let (way, part) = (ENDS[step.leg].0, step.load.to_vector()[0] / self.limit);
            let state = path.state().ok_or("no equilibrium")?;
            let displacement = state.twist.translation()[0];
            let off = (displacement - Self::displacement(way, part)).abs() / Self::virgin(MOST);
            let (residual, edge) = (state.residuals.worst(), self.edge(way, part, &state));
            let state = Some(state).filter(|_| step.fraction >= 1.0);
            looks.push(Look { way, part, displacement, off, residual, edge, state });
        }
        Ok(looks)
    }

    /// The edge of the stick zone on loading or unloading: the place of the innermost spring that slips.
    fn edge(&self, way: usize, part: f64, state: &Equilibrium) -> Option<Edge> {
        let exact = [1.0 - part, 1.0 - (MOST - part) / 2.0].get(way)?.cbrt();
        let slips = |i: &usize| match state.contacts[*i].state {
            ContactState::Sliding { direction } => (direction[0] < 0.0) == (way == 0),
            _ => false,
        };
        let found = (0..SPRINGS).filter(slips).map(|i| self.place(i).abs() / self.a).reduce(f64::min)?;
        Some(Edge { way, part, found, exact })
    }

    fn radius_chart(&self, looks: &[Look]) -> Chart {
        let _ = self;
        let title = "Partial slip grows from the rim inwards";
        let mut chart = Chart::new(title, "shear force Q/μP", "radius of the stick zone c/a");
        for (way, found, exact) in
            [(0, "going, springs", "Cattaneo-Mindlin"), (1, "coming back, springs", "Mindlin-Deresiewicz")]
        {
            let of = || looks.iter().filter_map(|look| look.edge).filter(move |edge| edge.way == way);
            let spaced = of().step_by(of().count() / 12 + 1).map(|edge| (edge.part, edge.found)).collect();
            chart = chart
                .series(exact, of().map(|edge| (edge.part, edge.exact)).collect(), Stroke::Line)
                .series(found, spaced, Stroke::Circles);
        }
        chart
    }

    fn loop_chart(&self, looks: &[Look]) -> Chart {
        let _ = self;
        let points = looks.iter().map(|look| (1e3 * look.displacement, look.part)).collect();
        let exact = looks
            .iter()
            .step_by(looks.len() / 30 + 1)
            .map(|look| (1e3 * Self::displacement(look.way, look.part), look.part))
            .collect();
        Chart::new("A cycle of shear", "displacement (mm)", "shear force Q/μP")
            .series("springs", points, Stroke::Line)
            .series("Mindlin-Deresiewicz", exact, Stroke::Circles)
    }

    /// Shear traction of the sphere at radius r, from the spring forces q per unit of length: `τ(r) = -1/π ∫ q'(x) / √(x² - r²) dx` over r < x < a.
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

    /// The equilibria at the leg ends of [`SHOWN`], with the shear force Q/μP.
    fn shown(looks: &[Look]) -> Result<Vec<(f64, &Equilibrium)>, Box<dyn Error>> {
        let ends: Vec<_> = looks.iter().filter_map(|look| look.state.as_ref()).collect();
        let at = |&end: &usize| Ok((ENDS[end].1, *ends.get(end).ok_or("the cycle ended early")?));
        SHOWN.iter().map(at).collect()
    }

    fn traction_chart(&self, looks: &[Look]) -> Result<Chart, Box<dyn Error>> {
        let mut chart = Chart::new(
            "Shear traction while the force grows",
            "radius r/a",
            "traction over μ times the largest pressure",
        );
        let largest = 2.0 / std::f64::consts::PI * NORMAL * (DEPTH / RADIUS).sqrt();
        let mut found = Vec::new();
        for &(part, state) in &Self::shown(looks)?[..3] {
            let radii = || (1..100).map(|k| f64::from(k) / 100.0);
            let c = (1.0 - part).cbrt();
            let ellipse = |r: f64, c: f64| (1.0 - (r / c).powi(2)).max(0.0).sqrt();
            let exact = radii().map(|r| (r, ellipse(r, 1.0) - c * ellipse(r, c))).collect();
            let traction = |r: f64| self.traction(state, r * self.a).abs() / (FRICTION * largest);
            found.extend(radii().step_by(6).map(|r| (r, traction(r))));
            chart = chart.series(format!("Q = {part} μP, Cattaneo-Mindlin"), exact, Stroke::Line);
        }
        chart = chart.series("springs", found, Stroke::Circles);
        Ok(chart)
    }

    /// Draws the zones of stick and slip of the round contact at six loads.
    fn zones(looks: &[Look]) -> Result<Chart, Box<dyn Error>> {
        let shown = Self::shown(looks)?;
        let mut dots = [const { Vec::new() }; 3];
        for (k, (_, state)) in shown.iter().enumerate() {
            // Centres of the six zones, in two rows with the legend between them.
            let centre = [4.0 * (k % 3) as f64, if k < 3 { 3.5 } else { 0.0 }];
            for i in 0..450 {
                let (r, angle) =
                    (((f64::from(i) + 0.5) / 450.0).sqrt(), f64::from(i) * 2.399_963_229_728_653);
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                // The index lies between 0 and the number of springs.
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
        let shown: Vec<_> = shown.iter().map(|(part, _)| part.to_string()).collect();
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
