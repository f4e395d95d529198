//! If bodies are lost already at rest and no proof of this was found, the verdict says which part of the loads and commands can be held.

use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::hold::{Holding, Verdict};
use grasp_lcp::planar::Wrench;
use proptest::prelude::Strategy;
use proptest::strategy::ValueTree;
use support::samples::{assert_met, config, runner, samples};
use support::stacks::{Stack, stack};

/// The stack with its loads and commands multiplied by `part`.
fn times(stack: &Stack<3, 2>, part: f64) -> Stack<3, 2> {
    let mut less = stack.clone();
    less.loads.iter_mut().for_each(|load| *load *= part);
    less.touches.iter_mut().for_each(|touch| touch.datum.command *= part);
    less
}

/// With 99.9 % of the loads and commands that are held at rest according to the verdict, a pile has an equilibrium. The piles are random, with four
/// bodies and sloped faces.
#[test]
fn what_is_held_of_it_is_told() {
    let mut runner = runner(config(1));
    let mut told = 0;
    for _ in 0..samples(100) {
        let stack = stack::<3, 2>(4).new_tree(&mut runner).expect("a stack").current();
        let verdict = stack.grasp(0).hold(Wrench::force([1.5, -1.0])).expect("well posed");
        let Holding::LostAtRest { at_rest } = &verdict.holding else { continue };
        told += 1;
        assert_eq!((verdict.holds(), verdict.held_to), (Some(false), 0.0));
        assert!((0.0..1.0).contains(&at_rest.factor));
        assert!(verdict.to_string().contains("even at rest"), "{verdict}");
        let before = times(&stack, 0.999 * at_rest.factor).grasp(0).solve(Wrench::ZERO).expect("well posed");
        assert!(matches!(before, Outcome::Equilibrium(_)), "{before}");
        let written = serde_json::to_string(&verdict).expect("written");
        let read: Verdict<2> = serde_json::from_str(&written).expect("reads back");
        assert_eq!(serde_json::to_string(&read).expect("written"), written);
    }
    assert_met(&[(told, 1)]);
}
