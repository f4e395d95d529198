//! A load drags a foot to and fro between springs. Its slip in every cycle agrees with a closed form, with one coefficient of friction and with two.
//!
//! The foot (10 N, spring of 1000 N/m) and a bonded spring of 1000 N/m carry a load that varies from 0 to 24 N and back. In every later cycle
//!
//! ```text
//! μ = 0.5          foot −5 → 5 N while the load goes to 20 N, then 4 mm of slip; as much slip during unloading
//! 0.5, then 0.4    foot −4 → 5 N up to 18 N, where it jumps by 2 mm to 4 N, then 6 mm of slip; as much slip during unloading
//! ```
//!
//! The heat equals the work of the load: with x from 5 mm to 19 mm, and from 4 mm to 20 mm.

use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
use grasp_lcp::shake::Repeats;

fn dragged(foot: Contact) -> Grasp {
    let weight = Contact::new([0.0, 0.0], [0.0, -1.0]).series_stiffness(1e3, 1e-9).pressed_with(10.0);
    let spring = |y: f64| Contact::new([0.0, y], [1.0, 0.0]).series_stiffness(500.0, 1e-9).bonded();
    Grasp::new([foot, weight, spring(-0.1), spring(0.1)]).expect("well posed")
}

fn foot() -> Contact {
    Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e3, 1e3).friction(0.5).pressed_with(10.0)
}

fn to_and_fro(grasp: &Grasp) -> (f64, f64) {
    let shaken =
        grasp.shake(Wrench::ZERO, &Leg::there_and_back(Wrench::force([24.0, 0.0]))).expect("well posed");
    let Repeats::Alternates { way, dissipated, .. } = shaken.repeats else { panic!("{shaken}") };
    (way, dissipated)
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9 * b, "{a} {b}");
}

#[test]
fn what_slides_at_the_end_of_a_cycle_counts_once() {
    let (way, heat) = to_and_fro(&dragged(foot()));
    near(way, 8e-3);
    // The heat is 5 N of friction over 8 mm.
    near(heat, 5.0 * 8e-3);
}

#[test]
fn jumps_count_in_every_cycle() {
    let (way, heat) = to_and_fro(&dragged(foot().kinetic(0.4)));
    near(way, 16e-3);
    // The heat ∮ F dx in mJ: F rises to 18 N over 9 mm, jumps by 1 mm, and rises to 24 N over 6 mm. The way back is the same with the sign changed.
    let up = 9.0 * 9.0 + 1.0 * 18.0 + 6.0 * 21.0;
    let back = 9.0 * 15.0 + 1.0 * 6.0 + 6.0 * 3.0;
    near(heat, (up - back) * 1e-3);
}

/// A stop that is far away and never touched changes no verdict: slips beside jumps are compared with the jumps, not with open gaps.
#[test]
fn a_far_stop_hides_no_slip() {
    let far = Contact::new([0.0, 0.0], [-1.0, 0.0]).series_stiffness(1e3, 1.0).clearance(1e4);
    let grasp = dragged(foot().kinetic(0.4));
    let beside = Grasp::new(grasp.contacts().iter().cloned().chain([far])).expect("well posed");
    let shaken =
        beside.shake(Wrench::ZERO, &Leg::there_and_back(Wrench::force([24.0, 0.0]))).expect("well posed");
    let Repeats::Alternates { slides, way, .. } = &shaken.repeats else { panic!("{shaken}") };
    assert_eq!(slides.len(), 1, "{shaken}");
    near(*way, 16e-3);
}

/// Two feet share a pull. The stiff foot jumps once, and the other foot holds. After this jump nothing slides.
#[test]
fn what_is_caught_comes_to_rest() {
    let foot = |x: f64, k: f64| {
        Contact::new([x, 0.0], [0.0, 1.0])
            .series_stiffness(1e3, k)
            .friction(0.5)
            .kinetic(0.4)
            .pressed_with(10.0)
    };
    let rail = |x: f64| Contact::new([x, 0.1], [0.0, -1.0]).series_stiffness(1e3, 1.0).pressed_with(10.0);
    let grasp = Grasp::new([foot(-0.1, 1e3), foot(0.1, 5e2), rail(-0.1), rail(0.1)]).expect("well posed");
    let shaken =
        grasp.shake(Wrench::ZERO, &Leg::there_and_back(Wrench::force([8.0, 0.0]))).expect("well posed");
    let Repeats::Rests { after: 1, slid } = &shaken.repeats else { panic!("{shaken}") };
    assert_eq!(slid.len(), 1, "{shaken}");
}
