//! Answers for two planar bodies agree with the enumeration of all combinations of contact states. Close cases are decided in exact rational
//! arithmetic.

use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::grasp::Wrench;
use proptest::prelude::Strategy;
use proptest::strategy::ValueTree;
use support::samples::{assert_met, config, runner, samples};
use support::stacks::stack;
use support::two_bodies::{Census, census};

/// An equilibrium is returned exactly if one exists. The seed is fixed, because outcomes are counted below.
#[test]
fn two_bodies_are_decided() {
    let mut runner = runner(config(1));
    let (mut held, mut lost, mut narrow) = (0, 0, 0);
    for _ in 0..samples(167) {
        let stack = stack::<3, 2>(2).new_tree(&mut runner).expect("a stack").current();
        let census = census(&stack);
        let outcome = stack.grasp(0).solve(Wrench::ZERO).expect("well posed");
        match (census, &outcome) {
            (Census::Narrow, _) => narrow += 1,
            (Census::Held(0), Outcome::NoEquilibrium(_)) => lost += 1,
            (Census::Held(1..), Outcome::Equilibrium(_)) => held += 1,
            (census, outcome) => panic!("{census:?} {outcome} {stack:?}"),
        }
    }
    println!("{held} {lost} {narrow}");
    assert_met(&[(held, 83), (lost, 33)]);
    assert!(narrow < samples(17), "{held} {lost} {narrow}");
}
