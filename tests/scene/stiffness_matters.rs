//! Some loads that a grasp holds depend on the tangential stiffness, others do not.

use std::collections::BTreeMap;

use grasp_lcp::planar::{Contact, Wrench};
use grasp_lcp::scene::{Fingertip, FingertipPatch, Question, Setup};

fn hold(load: Wrench) -> Question<2> {
    Question::Hold { base: Wrench::ZERO, load, together_with: BTreeMap::default() }
}

/// The friction of a pinch is μ times its squeeze, for every stiffness with which it does not buckle.
#[test]
fn a_pinch_holds_the_same() {
    let jaw = |side: f64| {
        let at = Contact::new([0.03 * side, 0.0], [-side, 0.0]).series_stiffness(2e4, 1.5e4);
        Fingertip::from(at.friction(0.5).pressed_with(8.0))
    };
    let setup = Setup::<2>::new([jaw(-1.0), jaw(1.0)]).ask(hold(Wrench::force([0.0, -1.0])));
    assert_eq!(setup.depends_on_tangential_stiffness().expect("answered"), [0; 0]);
}

/// A block lies on a bed, next to a frictionless stop of stiffness k_n. It slides on the bed at `μ N (1 + k_n/k_t)`, where k_t is the tangential
/// stiffness of the bed. For the values of k_t that are tried, this is from 1.05 to 11 times `μ N`.
#[test]
fn a_bed_beside_a_stop_slides_earlier_if_it_is_stiffer() {
    let (stiffness, tangential) = (1e5, 2e5);
    let bed = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e7, tangential).friction(0.3);
    let bed = Fingertip::from(bed.pressed_with(0.0)).soft(FingertipPatch::Pair { width: 0.1 });
    let stop = Contact::new([0.05, 0.0], [-1.0, 0.0]).series_stiffness(stiffness, stiffness);
    let load = Wrench::force([1.0, 0.0]);
    let question =
        Question::Hold { base: Wrench::force([0.0, -100.0]), load, together_with: BTreeMap::default() };
    let setup = Setup::<2>::new([bed, stop.into()]).ask(question);
    let verdict = setup
        .grasp()
        .expect("a grasp")
        .hold(grasp_lcp::planar::Ramp::load(Wrench::force([0.0, -100.0]), load * 1000.0));
    let slips = verdict.expect("answered").first_slip.expect("slides").factor * 1000.0;
    assert!((slips / (30.0 * (1.0 + stiffness / tangential)) - 1.0).abs() < 1e-9, "{slips}");
    assert_eq!(setup.depends_on_tangential_stiffness().expect("answered"), [0]);
}

/// With soft tangential springs the object turns farther than small motions allow before the whole load acts, although friction would hold the load.
#[test]
fn a_load_that_is_reached_by_small_motions_only_with_stiff_springs_depends() {
    let [left, right] = [
        Contact::new([-0.05, -0.04], [1.0, 0.0]).series_stiffness(2e4, 8e3).friction(0.2).force(10.0),
        Contact::new([0.05, -0.04], [-1.0, 0.0]).series_stiffness(2e4, 1e3).friction(0.8).pressed_with(10.0),
    ];
    let load = Wrench::force_at([2.0, -2.0], [0.0, -0.01]);
    let setup = Setup::<2>::new([left.into(), right.into()]).ask(hold(load));
    assert_eq!(setup.grasp().unwrap().hold(load).unwrap().holds(), Some(true));
    assert_eq!(setup.depends_on_tangential_stiffness().expect("answered"), [0]);
}

/// Three supports with kinetic friction share a load. The stiffest support slides first, and the load holds that the others carry beside it: 2 + 5 +
/// 5 N if this support is ten times as stiff. If all supports are equally stiff, the load holds up to 15 N.
#[test]
fn one_support_that_is_stiffer_than_the_others_changes_what_holds() {
    let support = |x: f64| {
        let at = Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e6, 1e5).friction(0.5).kinetic(0.2);
        Fingertip::from(at)
    };
    let (base, load) = (Wrench::force([0.0, -30.0]), Wrench::force([13.0, 0.0]));
    let question = Question::Hold { base, load, together_with: BTreeMap::default() };
    let setup = Setup::<2>::new([-0.1, 0.0, 0.1].map(support)).ask(question);
    assert_eq!(setup.depends_on_tangential_stiffness().expect("answered"), [0]);
}
