//! Bodies that are not well posed are refused by name.

use grasp_lcp::planar::{Bodies, Body, Contact, Grasp, Wrench};

fn floor() -> Contact {
    Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e4, 1e4).friction(0.5).name("floor")
}

fn refused(bodies: Bodies) -> String {
    bodies.grasp().expect_err("not well posed").to_string()
}

#[test]
fn bodies_are_told_apart_by_name() {
    let two = || [Body::new("box"), Body::new("box")];
    assert_eq!(
        refused(Bodies::new(two()).contacts([floor().on("box")])),
        "body \"box\" has the name of another body"
    );
    assert_eq!(refused(Bodies::new([]).contacts([floor()])), "body \"\" no body was given");
}

#[test]
fn contacts_name_bodies_that_are_there() {
    let bodies = || Bodies::new([Body::new("box"), Body::new("lid")]);
    let cases = [
        (floor().on("bocks"), "body \"bocks\" is named by contact 0 (floor), and is none of box, lid"),
        (
            floor().on("box").against("lit"),
            "body \"lit\" is named by contact 0 (floor), and is none of box, lid",
        ),
        (floor().on("lid").against("lid"), "body \"lid\" is on both sides of contact 0 (floor)"),
        (floor(), "body \"box\" may be what contact 0 (floor) is on, or another one: it must be said"),
    ];
    for (contact, message) in cases {
        assert_eq!(refused(bodies().contacts([contact])), message);
    }
    let alone = Grasp::new([floor().on("box")]).expect_err("no bodies").to_string();
    assert_eq!(alone, "body \"box\" is named by contact 0 (floor), and the scene has no bodies");
}

#[test]
fn numbers_are_in_range() {
    let with = |body: Body| Bodies::new([body]).contacts([floor()]);
    assert_eq!(
        refused(with(Body::new("box").mass(-1.0, [0.0; 2]))),
        "body \"box\" has mass -1, must be from 0 to 1e50"
    );
    assert!(refused(with(Body::new("box").mass(1.0, [f64::NAN, 0.0]))).contains("centre of mass at NaN"));
    assert!(
        refused(with(Body::new("box").load(Wrench::force([f64::INFINITY, 0.0])))).contains("load of a body")
    );
    assert!(refused(with(Body::new("box")).gravity([0.0, f64::NAN])).contains("gravity is NaN"));
    assert!(refused(with(Body::new("box")).loaded("lid")).contains("is none of box"));
    assert!(refused(with(Body::new("box")).shared_by_mass()).contains("no mass"));
}

/// A body that nothing holds is no error: the answer names it.
#[test]
fn a_loose_body_is_named() {
    let bodies = Bodies::new([
        Body::new("box").load(Wrench::force([0.0, -1.0])),
        Body::new("ball").load(Wrench::force([0.0, -2.0])),
    ]);
    let feet = [-0.1, 0.1]
        .map(|x| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e4, 1e4).friction(0.5).on("box"));
    let outcome = bodies.contacts(feet).grasp().expect("well posed").solve(Wrench::ZERO).expect("well posed");
    assert_eq!(outcome.to_string(), "no equilibrium exists: nothing resists ball moving along −y");
}
