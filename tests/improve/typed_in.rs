//! The sentence about a better grasp says the values of `pressed_with`, and typed in they give the promised first slip.

use grasp_lcp::improve::{Improve, Surface};
use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};

fn jaw(at: [f64; 2], k: f64, mu: f64, press: f64) -> Contact {
    Contact::new(at, [-at[0], 0.0]).series_stiffness(k, 1e3).friction(mu).pressed_with(press)
}

/// A rest below the object, on which the weight presses: forces at rest differ from those that are typed in.
fn rest() -> Contact {
    Contact::new([0.0, -0.02], [0.0, 1.0]).series_stiffness(1e4, 1e4).friction(0.1)
}

#[test]
fn the_values_of_the_sentence_give_the_promised_grasp() {
    let load = Wrench::force_at([0.0, 1.0], [0.005, 0.0]);
    let base = Wrench::force_at([0.0, -2.0], [0.01, 0.0]);
    let jaws = [jaw([-0.03, 0.0], 2e3, 0.3, 8.0).name("a"), jaw([0.03, 0.0], 4e3, 0.6, 8.0).name("b")];
    let [a, b] = jaws;
    let grasp = Grasp::new([a, b, rest().name("c")]).expect("three contacts");
    let edge = |x: f64| Surface::segment([x, -0.02], [x, 0.02]);
    let question = Improve::new(load).on_top_of(base).along(0, edge(-0.03)).along(1, edge(0.03));
    let improved = grasp.improve(&question.pressing_at_most(12.0)).expect("asked well");

    let words = format!("{improved:.9}");
    let presses: Vec<f64> =
        improved.contacts.iter().map(|placed| placed.pressed_with.expect("is changed")).collect();
    let (_, said) = words.split_once("; a `pressed_with` ").expect("says the field");
    let numbers = said.split([' ', '(']).filter_map(|word| word.parse::<f64>().ok());
    let numbers: Vec<f64> = numbers.take(6).collect();
    let given: Vec<f64> = numbers.iter().step_by(2).copied().collect();
    assert!(given.iter().zip(&presses).all(|(said, press)| (said - press).abs() < 1e-6), "{words}");

    let at = |k: usize| improved.contacts[k].point.into();
    let typed =
        [jaw(at(0), 2e3, 0.3, given[0]), jaw(at(1), 4e3, 0.6, given[1]), rest().pressed_with(given[2])];
    let onset = Grasp::new(typed).expect("a grasp").onset(Ramp::load(base, load)).expect("a load");
    let promised = improved.after.expect("sticks");
    assert!((onset.factor().expect("slides") / promised - 1.0).abs() < 1e-6, "{words}");
}

/// Jaws with tangential springs of 1 kN/m on arms of 0.03 m resist turning with 1.8 N m. Pressed with N they take 0.06 m times N of that, all of it
/// from 30 N on. With a load at the height h above them it is the load times h more, at the first slip at 25 N at most 25 N times h.
#[test]
fn a_grasp_that_buckles_is_not_praised() {
    let grasp =
        Grasp::new([jaw([-0.03, 0.0], 2e3, 0.5, 8.0), jaw([0.03, 0.0], 2e3, 0.5, 8.0)]).expect("two jaws");
    let improved = |most: f64, height: f64| {
        let question = Improve::new(Wrench::force_at([0.0, -1.0], [0.0, height])).pressing_at_most(most);
        grasp.improve(&question).expect("asked well")
    };
    for (most, height, buckles) in
        [(29.0, 0.0, false), (31.0, 0.0, true), (25.0, 0.0119, false), (25.0, 0.0121, true)]
    {
        let found = improved(most, height);
        assert_eq!(found.too_far.is_some(), buckles, "{found}");
        assert_eq!(
            found.to_string().starts_with("BUCKLES at rest, under these loads or before the first slip: "),
            buckles,
            "{found}"
        );
    }
}
