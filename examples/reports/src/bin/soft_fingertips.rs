//! A card between two soft fingertips is turned about the line through them. The report has its rotation, and the moments at which first the rims and
//! then all points slide, for four distributions of the same total stiffness over a tip.
//!
//! `cargo run --release -p reports --bin soft_fingertips`

use grasp_lcp::Error;
use grasp_lcp::picture::{Chart, Stroke};
use grasp_lcp::spatial::{Contact, Grasp, Leg, PathEnd, Pressure, SoftFingertip, Wrench};

/// Stiffness along the tangents (N/m), friction, squeeze (N), radius of the tip (m).
const KT: f64 = 9000.0;
const MU: f64 = 0.8;
const SQUEEZE: f64 = 4.0;
const RADIUS: f64 = 0.006;

fn finger(name: &str, side: f64) -> Contact {
    let normal = 15000.0;
    Contact::new([0.001 * side, 0.0, 0.0], [-side, 0.0, 0.0])
        .name(name)
        .finger_stiffness(normal, KT)
        .friction(MU)
        .command([SQUEEZE / normal, 0.0, 0.0])
}

fn pinch(tip: &SoftFingertip) -> Result<Grasp, Error> {
    Grasp::new([tip.contacts(&finger("thumb", -1.0))?, tip.contacts(&finger("index", 1.0))?].concat())
}

/// A moment about the line of the pinch, N m.
fn spin(moment: f64) -> Wrench {
    Wrench::new([0.0; 3], [moment, 0.0, 0.0])
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let points = Grasp::new([finger("thumb", -1.0), finger("index", 1.0)])?;
    let spun = points.solve(spin(1e-6))?;
    let resisted = if spun.equilibrium().is_some() { "something resists" } else { "nothing resists" };
    println!("Two point contacts under a moment about their line: {resisted}.\n");

    // Under pure spin the four points of a ring slide along corners of the default polygon, where the polygon touches the round cone.
    let tips = [
        ("ring", SoftFingertip::ring(RADIUS, 4)?),
        ("uniform disc", SoftFingertip::disc(RADIUS, 4, 4, Pressure::Uniform)?),
        ("Hertz disc", SoftFingertip::disc(RADIUS, 4, 4, Pressure::Hertz)?),
        ("parabolic disc", SoftFingertip::disc(RADIUS, 4, 4, Pressure::Parabolic)?),
    ];
    let whole = 2.0 * MU * SQUEEZE * RADIUS;
    println!("Two soft tips of radius {} mm, moments in units of 2 μ N R = {:.4} N m", 1e3 * RADIUS, whole);
    println!("  tip              k_θ (N m/rad)  first sliding: solved   closed   limit: path     closed");
    let mut chart = Chart::new("A pinch turned about its line", "turn (degrees)", "moment / 2 μ N R");
    for (name, tip) in &tips {
        let (grasp, one) = (pinch(tip)?, finger("", 1.0));
        let onset = grasp.onset(spin(whole))?.factor().ok_or("sticks at rest")?;
        let limit = tip.torsional_limit(&one, SQUEEZE) * 2.0 / whole;
        let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(spin(1.5 * whole))])?;
        path.run();
        if matches!(path.end(), Some(PathEnd::Completed)) {
            return Err("friction has a limit".into());
        }
        let (_, reached) = path.place();
        println!(
            "  {name:15} {:14.6} {onset:23.6} {:8.6} {:12.6} {limit:12.6}",
            tip.torsional_stiffness(&one),
            2.0 * tip.first_sliding(&one, SQUEEZE) / whole,
            1.5 * reached,
        );
        let mut curve = Vec::new();
        for step in 0..=100 {
            // With this order of operations the last fraction equals `reached` exactly.
            let fraction = reached * (f64::from(step) / 100.0);
            let state = path.state_at(0, fraction).ok_or("on the way")?;
            curve.push((state.twist.rotation()[0].to_degrees(), 1.5 * fraction));
        }
        chart = chart.series(*name, curve, Stroke::Line);
    }
    support::save("soft_fingertips.svg", &chart.to_svg()?)?;
    Ok(())
}
