//! Ill-posed systems of bodies are refused with an error that names the body or contact.

use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::planar::{Bodies, Body, Contact, Grasp, Wrench};
use support::facts;

fn floor() -> Contact {
    Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e4, 1e4).friction(0.5).name("floor")
}

/// The name of the refused body, and its fault.
fn refused(bodies: Bodies) -> [String; 2] {
    let [name, fault, _] = facts(&bodies.grasp().expect_err("not well posed"));
    [name, fault]
}

#[test]
fn bodies_are_told_apart_by_name() {
    let two = || [Body::new("box"), Body::new("box")];
    let [name, fault] = refused(Bodies::new(two()).contacts([floor().on("box")]));
    assert!(name == "box" && fault.contains("another body"), "{fault}");
    let [name, fault] = refused(Bodies::new([]).contacts([floor()]));
    assert!(name.is_empty() && fault.contains("no body"), "{fault}");
}

#[test]
fn contacts_name_bodies_that_are_there() {
    let bodies = || Bodies::new([Body::new("box"), Body::new("lid")]);
    let cases = [
        (floor().on("bocks"), "bocks", "box, lid"),
        (floor().on("box").against("lit"), "lit", "box, lid"),
        (floor().on("lid").against("lid"), "lid", "on both sides"),
        (floor(), "box", "must be said"),
    ];
    for (contact, body, said) in cases {
        let [name, fault] = refused(bodies().contacts([contact]));
        assert!(name == body && fault.contains(said) && fault.contains("contact 0 (floor)"), "{fault}");
    }
    let [name, fault, _] = facts(&Grasp::new([floor().on("box")]).expect_err("no bodies"));
    assert!(name == "box" && fault.contains("contact 0 (floor)") && fault.contains("no bodies"), "{fault}");
}

#[test]
fn numbers_are_in_range() {
    let with = |body: Body| Bodies::new([body]).contacts([floor()]);
    for (body, name, said) in [
        (with(Body::new("box").mass(-1.0, [0.0; 2])), "box", "mass -1"),
        (with(Body::new("box").mass(1.0, [f64::NAN, 0.0])), "box", "mass at NaN"),
        (with(Body::new("box")).loaded("lid"), "lid", "none of box"),
        (with(Body::new("box")).shared_by_mass(), "box", "no mass"),
    ] {
        let [named, fault] = refused(body);
        assert!(named == name && fault.contains(said), "{named}: {fault}");
    }
    let refused = |bodies: Bodies| facts(&bodies.grasp().expect_err("not well posed"));
    let pulled = Body::new("box").load(Wrench::force([f64::INFINITY, 0.0]));
    assert_eq!(refused(with(pulled)), ["load of a body", "0", "inf"]);
    let [.., value] = refused(with(Body::new("box")).gravity([0.0, f64::NAN]));
    assert_eq!(value, "NaN");
}

/// A body without supports is no error: the answer names its free motion.
#[test]
fn a_loose_body_is_named() {
    let bodies = Bodies::new([
        Body::new("box").load(Wrench::force([0.0, -1.0])),
        Body::new("ball").load(Wrench::force([0.0, -2.0])),
    ]);
    let feet = [-0.1, 0.1]
        .map(|x| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e4, 1e4).friction(0.5).on("box"));
    let outcome = bodies.contacts(feet).grasp().expect("well posed").solve(Wrench::ZERO).expect("well posed");
    assert!(matches!(outcome, Outcome::NoEquilibrium(_)));
    assert!(outcome.to_string().ends_with("ball moving along −y"), "{outcome}");
}
