//! What happens when a load grows beyond the onset of sliding and is then removed?
//!
//! `cargo run --profile quick -p grasp-lcp --example what_comes_after`

use grasp_lcp::spatial::{Contact, Grasp, Leg, Wrench};

fn main() -> Result<(), grasp_lcp::Error> {
    // Five fingers round a jar, pressed with 6 N each, two of them on a slippery label.
    let finger = |degrees: f64, friction: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Contact::new([0.03 * cos, 0.03 * sin, 0.0], [-cos, -sin, 0.0])
            .series_stiffness(2e3, 1.5e3)
            .friction(friction)
            .pressed_with(6.0)
    };
    let frictions = [0.7, 0.4, 0.7, 0.7, 0.3];
    let jar =
        Grasp::new((0_u8..5).zip(frictions).map(|(k, friction)| finger(72.0 * f64::from(k), friction)))?;

    let down = Wrench::force([0.0, 0.0, -14.0]);
    println!("slides {}", jar.onset(Wrench::force([0.0, 0.0, -1.0]))?);
    let mut path = jar.follow(Wrench::ZERO, &[Leg::load_to(down), Leg::load_to(Wrench::ZERO)])?;
    for event in path.run() {
        let (leg, at) = (event.leg + 1, event.fraction);
        for change in &event.changes {
            println!("leg {leg} at {at:.6}: {} {}", change.contact.text(), change.what);
        }
    }
    if let Some(end) = path.end() {
        println!("{end}");
    }
    // Some slip remains: after the load is removed, the jar is not at its initial place.
    if let Some(state) = path.state() {
        println!("{state}");
    }
    Ok(())
}
