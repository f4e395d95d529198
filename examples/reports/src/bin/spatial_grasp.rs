//! A bottle held by a thumb and three fingers in space. The report has its onset of sliding on the round cone, an equilibrium beyond it with bounds
//! from polygons, and the onset on polygons of 4 … 64 facets, inscribed, balanced and circumscribed. It draws the bottle at its onset, and writes a
//! page on which the reader can turn it.
//!
//! `cargo run --release -p reports --bin spatial_grasp`

use grasp_lcp::picture::{Chart, Page, Stroke, View};
use grasp_lcp::spatial::{Beyond, Contact, Departure, Grasp, Outcome, Ramp, Wrench};
use grasp_lcp::{Error, PolygonCone, PolygonFit, Settings};
use support::bracket::bracket;

/// Load of the equilibrium beyond the onset, as a multiple of the load at the onset.
const BEYOND: f64 = 1.02;
/// Index of the answer on the page that the picture shows.
const ONSET: usize = 2;

/// Radius and height of the edges of the bottle, m: foot, shoulder, neck, mouth.
const PROFILE: [[f64; 2]; 4] = [[0.035, -0.052], [0.035, 0.029], [0.013, 0.042], [0.013, 0.052]];

/// A bottle of radius 35 mm between three fingers at different heights and a thumb opposite them. A rubber fingertip is softer than the glass.
fn bottle() -> Result<Grasp, Error> {
    let finger = |name: &str, degrees: f64, height: f64, squeeze: f64, mu: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Contact::new([0.035 * cos, 0.035 * sin, height], [-cos, -sin, 0.0])
            .name(name)
            .body_stiffness(2e5, 1e5)
            .finger_stiffness(1500.0, 900.0)
            .friction(mu)
            .tangent([0.0, 0.0, 1.0])
            .command([squeeze, 0.0, 0.0])
    };
    Grasp::new([
        finger("thumb", 180.0, 0.002, 0.005, 0.8),
        finger("index", 32.0, 0.020, 0.0030, 0.7),
        finger("middle", 0.0, 0.000, 0.0030, 0.7),
        finger("ring", -32.0, -0.020, 0.0030, 0.7),
    ])
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let grasp = bottle()?;
    // The bottle is tilted for pouring: its weight (N) acts below and beside the fingers, and turns the bottle as it grows.
    let base = Wrench::ZERO;
    let direction = Wrench::force_at([0.25, 0.1, -1.0], [0.01, -0.012, 0.02]);
    let ramp = Ramp::load(base, direction);

    let onset = grasp.onset(&ramp)?;
    let event = onset.event().ok_or("a finite onset")?;
    println!("Onset on the round cone (a quadratic equation for each contact): {:.12} N", event.factor);
    for leaving in &event.leaving {
        let name = leaving.contact.text();
        if let Departure::Slides { direction: d } = leaving.how {
            println!("  {name} slides over the bottle along ({:+.4}, {:+.4}, {:+.4})", d[0], d[1], d[2]);
        }
    }
    match grasp.beyond(event).ok_or("its own event")? {
        Beyond::Continues(next) => {
            println!(
                "  beyond: the grasp still holds at first with {} contact(s) sliding",
                sliding(&next.states)
            );
        }
        other => println!("  beyond: {other:?}"),
    }

    let beyond = bracket(&grasp, direction * (BEYOND * event.factor))?;
    let Outcome::Equilibrium(state) = &beyond.round else { return Err(format!("{:?}", beyond.round).into()) };
    println!(
        "\nAt {BEYOND} of it, on the round cone by {:?}: residual {:.0e}",
        state.rule,
        state.residuals.worst()
    );
    if let Some(change) = state.change_from_polygon {
        println!("  no force is farther than {change:.4} N from that of the polygon that it was found from");
    }
    if let Some([force, displacement]) = beyond.spread {
        println!(
            "  8 facets inside the cone, the cone, and 8 around it: forces differ by {:.4} N, the object by {:.4} mm",
            force,
            1e3 * displacement
        );
    }
    println!("  contact   F_n (N)  |F_t| (N)  |F_t|/F_n");
    for (i, c) in state.contacts.iter().enumerate() {
        let name = grasp.contacts()[i].label_text(i);
        println!(
            "  {name:8} {:8.4} {:10.4} {:10.4}",
            c.normal_force(),
            c.friction_force(),
            c.friction_used()
        );
    }

    println!("\nThe onset on polygons, relative to the round cone:");
    println!("  facets   inscribed                 balanced                  circumscribed");
    let fits = [
        ("inscribed", PolygonFit::Inscribed),
        ("balanced", PolygonFit::Balanced),
        ("circumscribed", PolygonFit::Circumscribed),
    ];
    let mut errors = vec![Vec::new(); fits.len()];
    for facets in [4, 6, 8, 12, 16, 24, 32, 48, 64] {
        print!("  {facets:6}");
        for (curve, (_, fit)) in errors.iter_mut().zip(fits) {
            let settings = Settings::default().with_cone(PolygonCone::new(facets, fit)?);
            let factor =
                grasp.with(&settings.on_the_polygon()).onset(&ramp)?.factor().ok_or("holds without load")?;
            let error = factor / event.factor - 1.0;
            curve.push((f64::from(u32::try_from(facets)?), 100.0 * error));
            print!("   {factor:.8} ({:+8.4} %)", 100.0 * error);
        }
        println!();
    }
    let mut chart =
        Chart::new("Onset on a polygonal cone against the round cone", "facets", "error of the onset (%)");
    for ((name, _), curve) in fits.into_iter().zip(errors) {
        chart = chart.series(name, curve, Stroke::Line);
    }
    support::save("spatial_grasp_facets.svg", &chart.to_svg()?)?;

    let mut page = Page::new(&grasp, "A bottle in a thumb and three fingers, poured from");
    for [radius, height] in PROFILE {
        page = page.outline(circle(radius, height, 10));
    }
    for ends in PROFILE.windows(2) {
        let [low, high] = [0, 1].map(|k| circle(ends[k][0], ends[k][1], 90));
        for (low, high) in low.into_iter().zip(high) {
            page = page.outline([low, high]);
        }
    }
    let at_onset = grasp.state_at_onset(event).ok_or("its own event")?;
    let part = |factor: f64| grasp.solve(direction * (factor * event.factor));
    let page = page
        .outcome("no load", &part(0.0)?)
        .outcome("half the onset", &part(0.5)?)
        .frame(format!("onset of sliding, {:.4} N", event.factor), &at_onset)
        .frame(format!("{BEYOND} of the onset"), state)
        .outcome("1.5 of the onset", &part(1.5)?)
        .outcome("3 times the onset", &part(3.0)?);
    support::save("spatial_grasp.html", &page.to_html()?)?;
    support::save("spatial_grasp.svg", &page.to_svg(Some(ONSET), View::default())?)?;
    Ok(())
}

/// Points on a circle around the axis of the bottle, m, spaced by `degrees`.
fn circle(radius: f64, height: f64, degrees: u32) -> Vec<[f64; 3]> {
    let corner = |k: u32| {
        let (sin, cos) = f64::from(degrees * k).to_radians().sin_cos();
        [radius * cos, radius * sin, height]
    };
    (0..360 / degrees).map(corner).collect()
}

fn sliding(states: &[grasp_lcp::spatial::ContactState]) -> usize {
    states.iter().filter(|s| matches!(s, grasp_lcp::spatial::ContactState::Sliding { .. })).count()
}
