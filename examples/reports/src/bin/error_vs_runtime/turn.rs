//! A load that turns: the angle at which a finger slides, found directly, along chords of the turn, and by bisection.
//!
//! Two fingers of equal springs press with N each and hold a weight W in the plane. Tilted by θ they carry `W cos θ / 2` each along their faces, and
//! the lower finger presses with `N + W sin θ / 2`, the upper finger with `N - W sin θ / 2`. With the coefficient of friction μ the upper finger
//! slides where
//!
//! ```text
//! W cos θ / 2 = μ (N - W sin θ / 2)      ⟺      θ = atan μ - acos(2 μ N / (W √(1 + μ²)))
//! ```

use std::f64::consts::FRAC_PI_2;

use grasp_lcp::load_path::{Onset, Ramp};
use grasp_lcp::planar::{Contact, ContactState, Grasp, Turn, Wrench};

use crate::report::{Panel, Report};
use support::Failure;
use support::best_time::timed;

const FRICTION: f64 = 0.5;
const PRESSED: f64 = 10.0;
const WEIGHT: f64 = 9.5;
const CHORDS: [u32; 4] = [9, 90, 900, 9000];
const TOLERANCES: [f64; 5] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10];

pub fn measure(report: &mut Report) -> Result<(), Failure> {
    let exact = FRICTION.atan() - (2.0 * FRICTION * PRESSED / (WEIGHT * FRICTION.hypot(1.0))).acos();
    let finger = |side: f64| {
        Contact::new([side, 0.0], [-side, 0.0])
            .series_stiffness(1000.0, 800.0)
            .friction(FRICTION)
            .pressed_with(PRESSED)
    };
    let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    let weight = |angle: f64| Wrench::force([WEIGHT * angle.sin(), -WEIGHT * angle.cos()]);
    let turn = Turn::new(Wrench::ZERO, weight(0.0), weight(FRAC_PI_2));
    let off = |angle: f64| (angle / exact - 1.0).abs();
    let mut panel = Panel::new(
        "turn",
        "Two fingers hold a weight that is tilted",
        "relative error of the angle of onset",
    );
    let (angle, time) =
        timed(|| Ok(grasp.onset_of_turn(turn)?.onset.factor().ok_or("it slides within a turn")?))?;
    panel.add("direct, Grasp::onset_of_turn", "", off(angle), time);
    for chords in CHORDS {
        let (angle, time) = timed(|| {
            let step = FRAC_PI_2 / f64::from(chords);
            for k in 0..chords {
                let from = weight(step * f64::from(k));
                let ramp = Ramp::load(from, weight(step * f64::from(k + 1)) - from);
                if let Onset::At(event) = grasp.onset(&ramp)?
                    && event.factor <= 1.0
                {
                    return Ok(step * (f64::from(k) + event.factor));
                }
            }
            Err("it slides within a right angle".into())
        })?;
        panel.add("chords of a right angle, Grasp::onset", chords.to_string(), off(angle), time);
    }
    for tolerance in TOLERANCES {
        let (angle, time) = timed(|| {
            let (mut below, mut above) = (0.0, FRICTION.atan());
            while above - below > tolerance * above {
                let middle = 0.5 * (below + above);
                let outcome = grasp.solve(weight(middle))?;
                let sticks = outcome
                    .equilibrium()
                    .is_some_and(|state| state.contacts.iter().all(|c| c.state == ContactState::Sticking));
                *(if sticks { &mut below } else { &mut above }) = middle;
            }
            Ok(0.5 * (below + above))
        })?;
        panel.add("bisection, Grasp::solve", format!("{tolerance:.0e}"), off(angle), time);
    }
    report.push(panel);
    Ok(())
}
