//! Hinges, slides, rigid joints, springs and cables transmit the forces that statics gives, and leave the right motions free.

use grasp_lcp::equilibrium::ContactAnswer;
use grasp_lcp::grasp::LinkKind;
use grasp_lcp::hold::Verdict;
use grasp_lcp::{planar, spatial};
use support::facts;

fn assert_close(x: f64, exact: f64) {
    assert!((x - exact).abs() <= 1e-12 * exact.abs().max(1.0), "{x} {exact}");
}

fn size(force: &[f64]) -> f64 {
    force.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The force that the link of this name carries, N, from the answer.
fn carried<const C: usize>(state: &grasp_lcp::equilibrium::Equilibrium<C>, name: &str) -> f64 {
    let link = state.whole_contacts().find(|whole| whole.text() == name).expect("is there");
    size(link.force().as_slice())
}

fn state<const C: usize>(
    grasp: &grasp_lcp::ask::Grasp<C>,
    load: grasp_lcp::grasp::Wrench<C>,
) -> grasp_lcp::equilibrium::Equilibrium<C> {
    grasp.solve(load).expect("well posed").equilibrium().expect("holds").clone()
}

fn lost<const C: usize>(verdict: &Verdict<C>) -> f64 {
    verdict.lost.as_ref().unwrap_or_else(|| panic!("{verdict}")).factor
}

/// Tongs whose levers share a pin; one lever hangs on a stand. `W = 2 μ P a / (b - μ c)`, as with separate pins.
#[test]
fn tongs_on_a_true_hinge() {
    use planar::{Bodies, Body, Contact, Link, Wrench};
    let (a, b, c, mu, squeeze) = (0.3, 0.2, 0.04, 0.3, 50.0);
    let lever = |name: &str, side: f64| {
        Body::new(name).load(Wrench::force_at([side * squeeze, 0.0], [side * 0.1, a]))
    };
    let jaw = |name: &str, side: f64| {
        let at = Contact::new([side * c, -b], [-side, 0.0]).series_stiffness(1e5, 7e4).friction(mu);
        at.on("load").against(name).name(format!("{name} jaw"))
    };
    let pin = Link::hinge([0.0, 0.0]);
    let tongs = Bodies::new([Body::new("load"), lever("left", -1.0), lever("right", 1.0)])
        .contacts([jaw("left", -1.0), jaw("right", 1.0)])
        .links([pin.clone().name("pin").between("left", "right"), pin.name("stand").to_ground("left")])
        .grasp()
        .expect("well posed");
    let verdict = tongs.hold(Wrench::force_at([0.0, -100.0], [0.0, -b])).expect("well posed");
    assert_close(100.0 * lost(&verdict), 2.0 * mu * squeeze * a / (b - mu * c));
}

/// Lifting tongs: crossed levers of arms 0.2 m and 0.15 m on ropes under 45°. Of a weight W each rope pulls with `W/√2`, each jaw presses with
/// `0.25/0.3 W`, the pin carries `W/2 + 0.25/0.3 W`, and friction must be `0.5 · 0.3/0.25`, whatever W.
#[test]
fn lifting_tongs() {
    use planar::{Bodies, Body, Contact, Link, Wrench};
    let tongs = |mu: f64| {
        let jaw = |side: f64, name: &str, lever: &str| {
            let at = Contact::new([0.15 * side, -0.3], [-side, 0.0]).series_stiffness(1e6, 8e5).friction(mu);
            at.on("block").against(lever).name(name)
        };
        let rope = |side: f64, name: &str, lever: &str| {
            Link::cable([0.2 * side, 0.15], [0.0, 0.35]).stiffness(1e5).name(name).to_ground(lever)
        };
        Bodies::new(["block", "one", "other"].map(Body::new))
            .contacts([jaw(1.0, "right jaw", "one"), jaw(-1.0, "left jaw", "other")])
            .links([
                Link::hinge([0.0, 0.0]).name("pin").between("one", "other"),
                rope(-1.0, "left rope", "one"),
                rope(1.0, "right rope", "other"),
            ])
            .grasp()
            .expect("well posed")
    };
    let weight = Wrench::force_at([0.0, -200.0], [0.0, -0.3]);
    let hangs = state(&tongs(0.7), weight);
    let press = 0.25 / 0.3 * 200.0;
    assert_close(hangs.contacts[0].normal_force(), press);
    assert_close(carried(&hangs, "left rope"), 100.0 * 2f64.sqrt());
    assert_close(carried(&hangs, "pin"), 100.0 + press);
    assert!(hangs.to_string().contains("\n  right rope pulls"), "{hangs}");
    let holds = |mu: f64| tongs(mu).hold(weight).expect("well posed").holds();
    assert_eq!([holds(0.6 * (1.0 - 1e-9)), holds(0.6 * (1.0 + 1e-9))], [Some(false), Some(true)]);
}

/// A block hangs between two ropes with a pretension of 20 N. Both share a pull along one of them until the other is slack, at `20 (k + k')/k'`.
#[test]
fn a_rope_goes_slack() {
    use planar::{Grasp, Link, Wrench};
    let rope = |to: [f64; 2], stiffness: f64, name: &str| {
        Link::cable([0.0, 0.0], to)
            .stiffness(stiffness)
            .pretension(20.0)
            .name(name)
            .contacts()
            .expect("well posed")
    };
    let ropes =
        [rope([-1.0, 0.0], 3e4, "left"), rope([2.0, 0.0], 1e4, "right"), rope([0.0, 3.0], 1e4, "top")];
    let block =
        Grasp::new(ropes.concat().into_iter().chain(rope([0.0, -1.0], 1e4, "bottom"))).expect("well posed");
    let verdict = block.hold(Wrench::force([100.0, 0.0])).expect("well posed");
    let first = verdict.first_slip.as_ref().expect("slackens");
    assert_close(100.0 * first.factor, 20.0 * 4e4 / 1e4);
    assert_eq!((first.open[0].link, first.to_string().as_str()), (Some(LinkKind::Cable), "right goes slack"));
    let state = verdict.state.as_ref().unwrap();
    assert_close(carried(state, "left"), 100.0);
    assert!(state.to_string().contains("\n  right is slack"), "{state}");
    let grasp_lcp::load_path::Onset::At(event) = block.onset(Wrench::force([1.0, 0.0])).expect("well posed")
    else {
        panic!("it slackens")
    };
    assert_close(event.factor, 80.0);
    assert!(event.to_string().ends_with("right goes slack"), "{event}");
}

/// A block of two upright springs of 1000 N/m sinks by 10 mm under 20 N. The springs at its sides hang across this motion and do not slip.
#[test]
fn a_spring_does_not_slip() {
    use planar::{Bodies, Body, Link, Wrench};
    let upright = |x: f64| Link::spring([x, 0.05], [x, 1.05], 1e3).to_ground("block");
    let side = |x: f64| Link::spring([x, 0.0], [20.0 * x, 0.0], 1e3).to_ground("block");
    let block =
        Bodies::new([Body::new("block")]).links([upright(-0.05), upright(0.05), side(-0.05), side(0.05)]);
    let sunk = state(&block.grasp().expect("well posed"), Wrench::force([0.0, -20.0]));
    assert_close(sunk.twist.components()[1], -0.01);
    assert_eq!(sunk.too_far, None);
}

/// A spring with a pretension of -5 N is compressed by a further `F/k`, and pushes.
#[test]
fn a_spring_pulls_and_pushes() {
    use planar::{Bodies, Body, Link, Wrench};
    let cart = Bodies::new([Body::new("cart")])
        .links([
            Link::slide([0.0, 0.0], [3.0, 4.0], 0.2).name("rail").to_ground("cart"),
            Link::spring([0.0, 0.0], [6.0, 8.0], 500.0).pretension(-5.0).name("spring").to_ground("cart"),
        ])
        .grasp()
        .expect("well posed");
    // 20 N of the 25 N along y act along the rail. Without a load the cart moves back by 10 mm, to where the spring is relaxed.
    let moved = state(&cart, Wrench::force([0.0, 25.0]));
    let along = 0.6 * moved.twist.components()[0] + 0.8 * moved.twist.components()[1];
    assert_close(along, (20.0 - 5.0) / 500.0);
    assert_close(carried(&moved, "rail"), 15.0);
    assert!(moved.to_string().contains("\n  spring pushes"), "{moved}");
}

/// A door of 200 N on a hinge of two bearings, 1.6 m apart, whose free edge a rope holds against the wind. About the axis the rope balances the wind;
/// across it the bearings carry the rest.
#[test]
fn a_door() {
    use spatial::{Bodies, Body, Link, Wrench};
    let door = Bodies::new([Body::new("door").load(Wrench::force_at([0.0, 0.0, -200.0], [0.4, 0.0, 1.0]))])
        .links([
            Link::hinge([0.0, 0.0, 1.0], [0.0, 0.0, 2.0], 1.6).name("hinge").to_ground("door"),
            Link::cable([0.8, 0.0, 1.0], [0.8, 3.0, 1.0]).stiffness(1e5).name("rope").to_ground("door"),
        ])
        .grasp()
        .expect("well posed");
    let held = state(&door, Wrench::force_at([0.0, -60.0, 0.0], [0.4, 0.0, 1.0]));
    assert_close(carried(&held, "rope"), 30.0);
    // The hinge carries 30 N of wind, the weight, and the moment of the weight about its middle.
    assert_close(carried(&held, "hinge"), f64::hypot(30.0, 200.0));
    let pad = &held.pads[0];
    assert_eq!((pad.contact.link, pad.points), (Some(LinkKind::Hinge), 2));
    assert_close(size(pad.moment()), 200.0 * 0.4);
    // Under wind in the opposite direction the rope is slack, and the door turns about its hinge.
    let verdict = door.hold(Wrench::force_at([0.0, 60.0, 0.0], [0.4, 0.0, 1.0])).expect("well posed");
    assert_eq!((verdict.holds(), verdict.held_to), (Some(false), 0.0));
    assert!(verdict.to_string().contains("turns about hinge"), "{verdict}");
}

/// Each spatial link leaves the right motions free and carries the other forces and moments.
#[test]
fn what_links_leave_free() {
    use spatial::{Grasp, Link, Wrench};
    let at = [0.1, -0.2, 0.3];
    let axis = [1.0, 2.0, -2.0];
    let ball = Link::ball(at);
    let links = [
        (Link::hinge(at, axis, 0.3), 1),
        (ball, 3),
        (Link::slide(at, axis, 0.3), 1),
        (Link::rigid(at, 0.1), 0),
        (Link::spring(at, [0.0; 3], 1e4), 5),
    ];
    for (link, free) in links {
        let kind = link.kind();
        let held = Grasp::new(link.contacts().expect("well posed")).expect("well posed");
        let rests = state(&held, Wrench::ZERO);
        assert_eq!(rests.free_motions.len(), free, "{kind:?}");
        for motion in &rests.free_motions {
            let twist = motion.object.about(at);
            let (along, turning) = twist.components().split_at(3);
            let across = |x: &[f64]| {
                let part = (x[0] + 2.0 * x[1] - 2.0 * x[2]) / 3.0;
                size(&[x[0] - part / 3.0, x[1] - 2.0 * part / 3.0, x[2] + 2.0 * part / 3.0])
            };
            match kind {
                LinkKind::Hinge => assert!(size(along) + across(turning) < 1e-12 * size(turning)),
                LinkKind::Ball => assert!(size(along) < 1e-12 * size(turning)),
                LinkKind::Slide => assert!(size(turning) + across(along) < 1e-12 * size(along)),
                _ => {}
            }
        }
        // A force and a moment across the axis are carried by the links that should carry them.
        let load = Wrench::force_at([0.0, 5.0, 5.0], at);
        let carries = held.solve(load).expect("well posed").equilibrium().is_some();
        assert_eq!(carries, kind != LinkKind::Spring, "{kind:?}");
        if carries {
            let held = state(&held, load);
            let force = held.whole_contacts().next().expect("is there").force();
            assert_close(size(force.as_slice()), 50f64.sqrt());
        }
    }
}

/// A hinge has the answers of a bonded contact, and a slide has the answers of a pair of contacts kept closed, to the last bit.
#[test]
fn the_same_as_contacts() {
    use planar::{Contact, Grasp, Link, Wrench};
    let linked =
        [Link::hinge([0.1, 0.0]).stiffness(1e5), Link::slide([0.0, 0.2], [1.0, 0.0], 0.1).stiffness(2e4)];
    let linked = linked.map(|link| link.contacts().expect("well posed")).concat();
    let guide = |x: f64| Contact::new([x, 0.2], [0.0, 1.0]).series_stiffness(1e4, 1e4).kept_closed();
    let contacts =
        [Contact::new([0.1, 0.0], [1.0, 0.0]).series_stiffness(1e5, 1e5).bonded(), guide(-0.05), guide(0.05)];
    let load = Wrench::new([3.0, -7.0], 0.4);
    let [one, other] =
        [linked, contacts.to_vec()].map(|list| state(&Grasp::new(list).expect("well posed"), load));
    assert_eq!(one.twist, other.twist);
    let forces =
        |state: &planar::Equilibrium| state.contacts.iter().map(|c| c.force_world).collect::<Vec<_>>();
    assert_eq!(forces(&one), forces(&other));
}

#[test]
fn refused() {
    use planar::{Bodies, Body, Link};
    let refuse = |link: Link| {
        let bodies = Bodies::new([Body::new("a"), Body::new("b")]).links([link]);
        bodies.grasp().expect_err("refused")
    };
    for (link, name, field, value) in [
        (Link::hinge([0.0, f64::NAN]).name("pin").between("a", "b"), "pin", "point", "NaN"),
        (Link::slide([0.0; 2], [0.0; 2], 1.0).to_ground("a"), "slide 0", "direction", "0"),
        (Link::slide([0.0; 2], [1.0, 0.0], -1.0).to_ground("a"), "slide 0", "length", "-1"),
        (Link::rigid([0.0; 2], 0.0).to_ground("a"), "rigid joint 0", "size", "0"),
        (Link::spring([0.0; 2], [1.0, 0.0], 0.0).to_ground("a"), "spring 0", "stiffness", "0"),
        (Link::cable([0.0; 2], [1.0, 0.0]).pretension(-2.0).to_ground("a"), "cable 0", "pretension", "-2"),
        (Link::hinge([0.0; 2]).pretension(2.0).to_ground("a"), "hinge 0", "pretension", "2"),
        (Link::spring([0.0; 2], [1.0, 0.0], 1.0).slack(0.1).to_ground("a"), "spring 0", "slack", "0.1"),
    ] {
        assert_eq!(facts(&refuse(link)), [name, field, value]);
    }
    let [cable, length, value] = facts(&refuse(Link::cable([0.0; 2], [0.0; 2]).to_ground("a")));
    assert!(cable == "cable 0" && length.starts_with("length") && value == "0");
    for (link, body, fault) in [
        (Link::hinge([0.0; 2]).name("pin").to_ground("c"), "c", "none of a, b"),
        (Link::hinge([0.0; 2]).name("pin").between("a", "a"), "a", "both sides"),
    ] {
        let [name, told, _] = facts(&refuse(link));
        assert!(name == body && told.contains(fault) && told.contains("\"pin\""), "{told}");
    }
}

/// Three belts of different stiffness hold a block on two feet. Each pulls with its given force whatever the others do, and the feet carry the sum.
#[test]
fn belts_pull_as_they_are_installed() {
    use planar::{Bodies, Body, Contact, Link, Wrench};
    let foot =
        |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(3e4, 3e4).friction(0.5).on("block");
    let belts = [(-0.2, 1e4, 120.0), (0.05, 3e6, 45.0), (0.2, 2e5, 80.0)];
    let belt = |(x, k, pull): (f64, f64, f64)| {
        Link::cable([x, 0.3], [x, 0.0])
            .stiffness(k)
            .tension(pull)
            .name(format!("belt at {x}"))
            .to_ground("block")
    };
    let grasp = Bodies::new([Body::new("block").mass(2.0, [0.0, 0.1])])
        .gravity([0.0, -10.0])
        .contacts([foot(-0.25), foot(0.25)])
        .links(belts.map(belt))
        .grasp()
        .expect("well posed");
    let outcome = grasp.solve(Wrench::ZERO).expect("well posed");
    let state = outcome.equilibrium().expect("stands");
    for (contact, (_, _, pull)) in state.contacts[2..].iter().zip(belts) {
        assert!((contact.normal_force() - pull).abs() < 1e-9 * pull, "{outcome}");
    }
    let feet: f64 = state.contacts[..2].iter().map(ContactAnswer::normal_force).sum();
    assert!((feet - 265.0).abs() < 1e-6, "{outcome}");
}
