//! A gripper measures its contact forces a thousand times a second, and presses harder before a finger slips.
//!
//! `cargo run --release -p grasp-lcp --example raise_the_squeeze`

use std::f64::consts::{PI, TAU};

use grasp_lcp::equilibrium::ContactState;
use grasp_lcp::spatial::{Contact, Fingers, Grasp, Wrench};

const MASS: f64 = 0.3; // kg
const TICK: f64 = 1e-3; // s
/// Time by which the watch anticipates the load, s, since the fingers need some milliseconds to press harder.
const AHEAD: f64 = 0.03;
/// Largest increase of the squeeze in a tick, relative to the initial squeeze.
const FASTEST: f64 = 0.01;

/// Three fingers round a bottle. Each presses with 6 N times `squeeze`.
fn fingers(squeeze: f64) -> [Contact; 3] {
    [0.0, 1.0, 2.0].map(|third: f64| {
        let (sin, cos) = (third * TAU / 3.0).sin_cos();
        Contact::new([0.03 * cos, 0.03 * sin, 0.0], [-cos, -sin, 0.0])
            .series_stiffness(2e3, 1.5e3)
            .friction(0.5)
            .pressed_with(6.0 * squeeze)
    })
}

/// The load of a bottle that is lifted and swung, at the time `time`, s.
fn load(time: f64) -> Wrench {
    let push = (PI * time).sin().powi(2);
    Wrench::force_at([-8.0 * MASS * push, 0.0, -MASS * (9.81 + 20.0 * push)], [0.0, 0.0, -0.005])
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let watch = Fingers::new(&fingers(1.0))?;
    for watched in [false, true] {
        let (mut squeeze, mut least) = (1.0_f64, f64::INFINITY);
        let mut slipped = None;
        for tick in 0..1000_u16 {
            let time = f64::from(tick) * TICK;
            // The simulated grasp, whose contact forces the sensors measure: springs and Coulomb's law.
            let world = Grasp::new(fingers(squeeze))?;
            let outcome = world.solve(load(time))?;
            let Some(state) = outcome.equilibrium() else {
                slipped = slipped.or(Some(time));
                break;
            };
            if state.contacts.iter().any(|contact| contact.state != ContactState::Sticking) {
                slipped = slipped.or(Some(time));
            }
            // Measured forces on the object, along the coordinate axes, N.
            let mut forces = [[0.0; 3]; 3];
            for ((force, contact), frame) in forces.iter_mut().zip(&state.contacts).zip(world.frames()) {
                *force = (frame * contact.force).into();
            }
            // The load to come: the planned change of the load, plus a tenth of the load as a reserve.
            let to_come = load(time + AHEAD) - load(time) + 0.1 * load(time);
            let seen = watch.watch(&forces, &to_come)?;
            least = least.min(seen.margin());
            if watched {
                squeeze += seen.extra_squeeze().factor().unwrap_or(FASTEST).min(FASTEST);
            }
        }
        let what = if watched { "with the watch" } else { "with the first squeeze" };
        let when =
            slipped.map_or("nothing slips".to_owned(), |time| format!("a finger slips at {time:.3} s"));
        println!("{what}: {when}; least margin {least:.3} N, in the end {:.2} N a finger", 6.0 * squeeze);
    }
    Ok(())
}
