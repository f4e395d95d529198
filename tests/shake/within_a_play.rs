//! A block that is shaken between two stops slides from one to the other and back in every cycle. Its slip agrees with a closed form.
//!
//! Feet (total stiffness K, friction μ) carry the weight W. Stops of stiffness K are at the distance g on both sides, and a pull goes from P to -P
//! and back. From one extreme to the other the feet stretch by 2 μ W / K before they slide, and each stop is compressed by (P - μ W) / K. So the feet
//! slide by
//!
//! ```text
//! 2 (g + (P - μ W) / K) - 2 μ W / K      on each way
//! ```

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::Leg;
use grasp_lcp::shake::Repeats;

const K: f64 = 1e6;
const GAP: f64 = 1e-3;

fn feet<const C: usize>(places: &[[f64; C]]) -> impl Iterator<Item = Contact<C>> {
    let mut up = [0.0; C];
    up[C - 1] = 1.0;
    let stiffness = K / places.len() as f64;
    places.iter().map(move |at| Contact::new(*at, up).series_stiffness(stiffness, stiffness).friction(0.5))
}

fn between_stops<const C: usize>(places: &[[f64; C]], back: [f64; C], ahead: [f64; C]) -> Grasp<C> {
    let stop = |normal: [f64; C]| Contact::new([0.0; C], normal).series_stiffness(K, K).clearance(GAP);
    Grasp::new(feet(places).chain([stop(back), stop(ahead)])).expect("well posed")
}

fn goes_to_and_fro<const C: usize>(grasp: &Grasp<C>, down: &Wrench<C>, pull: &Wrench<C>) {
    let cycle = [*pull, *pull * -1.0].map(Leg::there_and_back).concat();
    let shaken = grasp.shake(down, &cycle).expect("well posed");
    let Repeats::Alternates { way, dissipated, .. } = shaken.repeats else { panic!("{shaken}") };
    let each = 2.0 * (GAP + 30.0 / K) - 100.0 / K;
    assert!((way - 2.0 * each).abs() < 1e-9 * GAP, "{way} {each}");
    assert!((dissipated - 50.0 * 2.0 * each).abs() < 1e-9 * 50.0 * GAP, "{dissipated}");
    assert!(shaken.to_string().contains("slow shaking"), "{shaken}");
    assert_eq!(shaken.stays(), Some(true));
    // Under a pull in one direction only, the block comes to rest at the stop.
    let shaken = grasp.shake(down, &Leg::there_and_back(*pull)).expect("well posed");
    assert_eq!(shaken.rests(), Some(true), "{shaken}");
}

#[test]
fn a_block_goes_from_stop_to_stop() {
    let grasp = between_stops(&[[-0.1, 0.0], [0.1, 0.0]], [-1.0, 0.0], [1.0, 0.0]);
    goes_to_and_fro(&grasp, &Wrench::<2>::new([0.0, -100.0], 0.0), &Wrench::<2>::new([80.0, 0.0], 0.0));
    let places = [[-0.1, -0.1, 0.0], [0.1, -0.1, 0.0], [-0.1, 0.1, 0.0], [0.1, 0.1, 0.0]];
    let grasp = between_stops(&places, [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let load = |force: [f64; 3]| Wrench::<3>::new(force, [0.0; 3]);
    goes_to_and_fro(&grasp, &load([0.0, 0.0, -100.0]), &load([80.0, 0.0, 0.0]));
}

/// A soft rocked block walks farther in the first cycle than its feet are apart. The reported walk is the walk of all later cycles. The feet carry 10
/// N, rocked by 4 N m. In each cycle they slide by twice the missing force, 3.5 N minus 3 N of friction, divided by their stiffness.
#[test]
fn a_walk_is_told_by_the_cycles_to_come() {
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e3, 0.4).friction(0.5);
    let block = Grasp::new([foot(-1.0), foot(1.0)]).expect("well posed");
    let cycle = [4.0, -4.0].map(|rocked| Leg::there_and_back(Wrench::<2>::new([0.0, 0.0], rocked))).concat();
    let shaken = block.shake(Wrench::<2>::new([3.5, -10.0], 0.0), &cycle).expect("well posed");
    let Repeats::Walks { by, .. } = &shaken.repeats else { panic!("{shaken}") };
    // The missing force of 0.5 N, times two, divided by 0.4 N/m: 2.5 m in each cycle.
    assert!((by[0].twist.translation()[0] - 2.5).abs() < 1e-9, "{shaken}");
    assert!(shaken.change < 1e-9 && shaken.cycles > 1, "{shaken:?}");
}
