//! Loads at which bodies in contact lose their equilibrium agree with textbook formulas and hand calculations.

use super::faces::{assert_close, face, lost_at};
use grasp_lcp::planar::{Bodies, Body, Contact, Wrench};

/// A box of 10 N stands on a box of 20 N on a table, with μ = 0.3 between the boxes and 0.5 below. A constant force also acts on the upper box.
#[test]
fn two_boxes() {
    for (pushed, exact) in [(0.0, 15.0), (2.9, 12.1), (-2.9, 17.9)] {
        let bodies = Bodies::new([
            Body::new("lower").load(Wrench::force_at([0.0, -20.0], [0.0, 0.1])),
            Body::new("upper").load(
                Wrench::force_at([0.0, -10.0], [0.0, 0.3]) + Wrench::force_at([pushed, 0.0], [0.0, 0.21]),
            ),
        ])
        .contacts(face([-0.2, 0.0], [0.2, 0.0], 0.5).map(|contact| contact.on("lower")))
        .contacts(face([-0.2, 0.2], [0.2, 0.2], 0.3).map(|contact| contact.on("upper").against("lower")));
        assert_close(lost_at(bodies, Wrench::force_at([10.0, 0.0], [0.0, 0.01])) * 10.0, exact);
    }
}

/// A wedge of 8° under a machine block of 400 lb at a wall, μ = 0.35 everywhere (Beer and Johnston, sample problem of wedges): `P = W tan(α + 2φ)`.
#[test]
fn wedge_under_a_block() {
    let (alpha, mu): (f64, f64) = (8f64.to_radians(), 0.35);
    let rise = alpha.tan();
    // The wedge points to the left, and the wall is to the left of the block.
    let bodies = Bodies::new([
        Body::new("wedge"),
        Body::new("block").load(Wrench::force_at([0.0, -400.0], [0.45, 1.0])),
    ])
    .contacts(face([0.0, 0.0], [2.0, 0.0], mu).map(|contact| contact.on("wedge").name("floor")))
    .contacts(face([0.0, 0.1], [1.0, 0.1 + rise], mu).map(|contact| contact.on("block").against("wedge")))
    .contacts(face([0.0, 2.0], [0.0, 0.5], mu).map(|contact| contact.on("block").name("wall")));
    let lost = lost_at(bodies, Wrench::force_at([-100.0, 0.0], [2.0, 0.15]));
    assert_close(100.0 * lost, 400.0 * (alpha + 2.0 * mu.atan()).tan());
}

/// Two wedges of 10° under a block of 400 lb, the upper wedge at a wall, μ = 0.25 everywhere (Beer and Johnston, problems on wedges). The formula is
/// the same as for one wedge, and the block moves with the upper wedge.
#[test]
fn two_wedges_under_a_block() {
    let (alpha, mu): (f64, f64) = (10f64.to_radians(), 0.25);
    let rise = alpha.tan();
    let bodies = Bodies::new([
        Body::new("lower"),
        Body::new("upper"),
        Body::new("block").load(Wrench::force_at([0.0, -400.0], [0.5, 1.0])),
    ])
    .contacts(face([-0.2, 0.0], [2.0, 0.0], mu).map(|contact| contact.on("lower").name("floor")))
    .contacts(face([0.0, 0.2], [1.0, 0.2 + rise], mu).map(|contact| contact.on("upper").against("lower")))
    .contacts(face([0.0, 0.9], [0.0, 0.25], mu).map(|contact| contact.on("upper").name("wall")))
    .contacts(face([0.1, 0.9], [0.9, 0.9], mu).map(|contact| contact.on("block").against("upper")));
    let lost = lost_at(bodies.loaded("lower"), Wrench::force_at([-100.0, 0.0], [2.0, 0.15]));
    assert_close(100.0 * lost, 400.0 * (alpha + 2.0 * mu.atan()).tan());
}

/// A wedge of 15° between a tray and a block with vertical guides is pressed out unless `μ >= tan 7.5°`, for every weight of the block.
#[test]
fn wedge_that_is_not_pressed_out() {
    let alpha = 15f64.to_radians();
    let holds = |mu: f64| {
        let bodies = Bodies::new([Body::new("wedge"), Body::new("block")])
            .contacts(face([0.0, 0.0], [1.0, 0.0], mu).map(|contact| contact.on("wedge")))
            .contacts(
                face([0.0, 0.1], [1.0, 0.1 + alpha.tan()], mu)
                    .map(|contact| contact.on("block").against("wedge")),
            )
            .contacts(face([0.0, 1.0], [0.0, 0.5], 0.0).map(|contact| contact.on("block").kept_closed()));
        let verdict = bodies
            .loaded("block")
            .grasp()
            .expect("well posed")
            .hold(Wrench::force_at([0.0, -10.0], [0.5, 1.0]));
        verdict.expect("well posed").holds()
    };
    let least = (0.5 * alpha).tan();
    assert_eq!([holds(least * (1.0 - 1e-9)), holds(least * (1.0 + 1e-9))], [Some(false), Some(true)]);
}

/// Books of 0.95 kg pressed together with 120 N, μ = 0.6 at the hands and 0.4 between books (Halliday, Resnick and Walker): 12 can be carried. The outermost
/// faces between books carry the shear force `(n - 2) w / 2`.
#[test]
fn a_row_of_books() {
    let weight = 0.95 * 9.81;
    let most = |books: usize| {
        let thick = 0.03;
        let name = |book: usize| format!("book {book}");
        let bodies =
            Bodies::new((0..books).map(|k| Body::new(name(k)).mass(0.95, [(k as f64 + 0.5) * thick, 0.0])));
        let at =
            |k: usize, friction: f64| face([k as f64 * thick, 0.12], [k as f64 * thick, -0.12], friction);
        let hand = face([books as f64 * thick, -0.12], [books as f64 * thick, 0.12], 0.6)
            .map(|c| c.force(60.0).on(name(books - 1)));
        let row = bodies
            .contacts(at(0, 0.6).map(|contact| contact.on(name(0))))
            .contacts((1..books).flat_map(|k| {
                at(k, 0.4).map(move |c| c.on(format!("book {k}")).against(format!("book {}", k - 1)))
            }))
            .contacts(hand)
            .shared_by_mass();
        let load = row.weight([0.0, -9.81]);
        lost_at(row, load)
    };
    for books in [12, 13] {
        assert_close(most(books), 2.0 * 0.4 * 120.0 / ((books as f64 - 2.0) * weight));
    }
    assert!(most(12) > 1.0 && most(13) < 1.0);
}

/// Tongs on a pin: handles at `a` above it, jaws at `b` below it and `c` beside it. The load between the jaws tightens them: `W = 2 μ P a / (b - μ c)`.
#[test]
fn tongs() {
    let (a, b, c, mu, squeeze) = (0.3, 0.2, 0.04, 0.3, 50.0);
    let lever = |name: &str, side: f64| {
        Body::new(name).load(Wrench::force_at([side * squeeze, 0.0], [side * 0.1, a]))
    };
    let pin = |name: &str| {
        Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e7, 1e7).bonded().on(name).name("pin")
    };
    let jaw = |name: &str, side: f64| {
        let at = Contact::new([side * c, -b], [-side, 0.0]).series_stiffness(1e5, 7e4).friction(mu);
        at.on("load").against(name).name(format!("{name} jaw"))
    };
    let bodies = Bodies::new([lever("left", -1.0), lever("right", 1.0), Body::new("load")])
        .contacts([pin("left"), pin("right"), jaw("left", -1.0), jaw("right", 1.0)])
        .loaded("load");
    let lost = lost_at(bodies, Wrench::force_at([0.0, -100.0], [0.0, -b]));
    assert_close(100.0 * lost, 2.0 * mu * squeeze * a / (b - mu * c));
}
