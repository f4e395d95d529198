//! The verdict reports the right motion by which the object is lost, in scenes where it is known by hand.

use grasp_lcp::hold::WayOut;
use grasp_lcp::planar::{Bodies, Body, Contact, Grasp, Ramp, Wrench};
use grasp_lcp::spatial;
use support::jaws::jaw;

type Tested = Result<(), grasp_lcp::Error>;

fn foot(x: f64, name: &str) -> Contact {
    Contact::new([x, 0.0], [0.0, 1.0]).name(name).series_stiffness(1e4, 8e3).friction(0.6)
}

fn box_on_feet() -> Result<Grasp, grasp_lcp::Error> {
    Grasp::new([foot(-0.05, "left"), foot(0.05, "right")])
}

fn names(parts: &[grasp_lcp::grasp::WholeContact]) -> Vec<&str> {
    parts.iter().map(|part| part.label.as_str()).collect()
}

/// A box of 10 N, pushed at a height of 0.2 m, tips at 10 · 0.05 / 0.2 N, long before it slides.
#[test]
fn a_box_tips_over_its_foot() -> Tested {
    let push = Ramp::load(Wrench::force([0.0, -10.0]), Wrench::force_at([5.0, 0.0], [0.0, 0.2]));
    let verdict = box_on_feet()?.hold(push)?;
    let lost = verdict.lost.as_ref().expect("tips");
    assert!((5.0 * lost.factor - 2.5).abs() < 1e-12, "{}", lost.factor);
    let WayOut::TipsOver { about, opens } = &lost.way_out else { panic!("{verdict}") };
    assert_eq!((names(about), names(opens)), (vec!["right"], vec!["left"]));
    assert!(!lost.is_gross_slip);

    Ok(())
}

/// A box that is pushed low slides at μ W, for all feet.
#[test]
fn a_box_slides_when_pushed_low() -> Tested {
    let push = Ramp::load(Wrench::force([0.0, -10.0]), Wrench::force_at([-9.0, 0.0], [0.0, 0.0]));
    let lost = box_on_feet()?.hold(push)?.lost.expect("slides");
    assert!((9.0 * lost.factor - 6.0).abs() < 1e-12);
    assert!(lost.is_gross_slip);
    assert!(matches!(&lost.way_out, WayOut::SlidesOut { direction } if (direction[0] + 1.0).abs() < 1e-9));
    Ok(())
}

#[test]
fn a_box_lifts_off() -> Tested {
    let lift = Ramp::load(Wrench::force([0.0, -10.0]), Wrench::force([0.0, 12.0]));
    let verdict = box_on_feet()?.hold(lift)?;
    let lost = verdict.lost.as_ref().expect("lifts off");
    assert!((12.0 * lost.factor - 10.0).abs() < 1e-12);
    assert!(matches!(&lost.way_out, WayOut::LiftsOff { direction } if direction[1] > 0.99), "{verdict}");
    assert!(lost.nothing_near.is_some_and(|near| near.translation.is_infinite()), "{verdict}");
    Ok(())
}

/// Two points carry no moment about the line through them.
#[test]
fn a_pinch_spins_about_its_line() -> Tested {
    let tip = |x: f64, name: &str| jaw::<3>(x, [1e3, 8e2], 0.5).name(name).pressed_with(10.0);
    let pinch = spatial::Grasp::new([tip(-0.03, "thumb"), tip(0.03, "index")])?;
    let verdict = pinch.hold(spatial::Wrench::new([0.0, 0.0, -1.0], [1e-3, 0.0, 0.0]))?;
    let lost = verdict.lost.as_ref().expect("turns");
    assert_eq!(lost.factor, 0.0);
    assert!(
        matches!(&lost.way_out, WayOut::TurnsAbout { about } if names(about) == ["thumb", "index"]),
        "{verdict}"
    );
    assert!(verdict.to_string().contains("line thumb–index"), "{verdict}");
    Ok(())
}

fn feet_without_friction() -> Result<Grasp, grasp_lcp::Error> {
    let foot = |x: f64, name: &str| Contact::new([x, 0.0], [0.0, 1.0]).name(name).series_stiffness(1e7, 1e7);
    Grasp::new([foot(0.0, "a"), foot(0.2, "b")])
}

/// A load outside its two feet tips a plank over the nearer foot, also without forces at rest. The initial spring deflection does not count.
#[test]
fn a_plank_tips_at_once_over_the_nearer_foot() -> Tested {
    let beside = Wrench::force_at([0.0, -100.0], [0.25, 0.05]);
    let plank = feet_without_friction()?;
    for base in [Wrench::ZERO, Wrench::force_at([0.0, -1.0], [0.1, 0.0])] {
        let verdict = plank.hold(Ramp::load(base, beside))?;
        let lost = verdict.lost.as_ref().expect("tips");
        let WayOut::TipsOver { about, opens } = &lost.way_out else { panic!("{verdict}") };
        assert_eq!((names(about), names(opens)), (vec!["b"], vec!["a"]));
        assert!(lost.nothing_near.is_some_and(|near| near.translation.is_infinite()), "{verdict}");
    }
    Ok(())
}

/// A bracket on a post has 100 mm between its edges. With μ = 0.2 and the load nearer than 250 mm it does not jam, and slides down without rotation.
#[test]
fn a_bracket_slides_down_its_post_at_once() -> Tested {
    let edge = |x: f64, y: f64| Contact::new([x, y], [x, 0.0]).series_stiffness(1e8, 1e8).friction(0.2);
    let bracket = Grasp::new([edge(-0.02, 0.05), edge(0.02, -0.05)])?;
    let hung = |at: f64| bracket.hold(Wrench::force_at([0.0, -100.0], [at, 0.0]));
    let verdict = hung(0.24)?;
    let WayOut::SlidesOut { direction } = &verdict.lost.as_ref().expect("slides").way_out else {
        panic!("{verdict}")
    };
    assert!(verdict.held_to == 0.0 && direction[1] < -1.0 + 1e-9, "{verdict}");
    assert!(verdict.to_string().starts_with("DROPS at once"), "{verdict}");
    assert_eq!(hung(0.26)?.holds(), Some(true));
    Ok(())
}

/// A ladder slides along the floor and down the wall, so it turns about the intersection of both normals.
#[test]
fn a_ladder_turns_about_the_point_where_normals_meet() -> Tested {
    let foot = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(5e5, 2e5).friction(0.2);
    let top = Contact::new([2.0, 4.5], [-1.0, 0.0]).series_stiffness(2e5, 1e5).friction(0.1);
    let verdict = Grasp::new([foot, top])?.hold(Wrench::force_at([0.0, -800.0], [1.5, 0.0]))?;
    let lost = verdict.lost.as_ref().expect("slides away");
    let WayOut::Turns { centre, .. } = &lost.way_out else { panic!("{verdict}") };
    assert!(lost.factor == 0.0 && centre[0].abs() < 1e-9 && (centre[1] - 4.5).abs() < 1e-9, "{verdict}");
    Ok(())
}

/// A table on four feet with a load outside them tips over the two nearer feet.
#[test]
fn a_table_tips_at_once_over_two_feet() -> Tested {
    let foot = |x: f64, y: f64| {
        spatial::Contact::new([x, y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(1e6, 8e5).friction(0.5)
    };
    let table = spatial::Grasp::new([foot(-0.4, -0.3), foot(-0.4, 0.3), foot(0.4, 0.3), foot(0.4, -0.3)])?;
    let beside = spatial::Wrench::force_at([0.0, 0.0, -50.0], [0.55, 0.0, 0.0]);
    let verdict = table.hold(beside)?;
    let WayOut::TipsOver { about, opens } = &verdict.lost.as_ref().expect("tips").way_out else {
        panic!("{verdict}")
    };
    assert_eq!(about.iter().map(|part| part.contact).collect::<Vec<_>>(), [2, 3]);
    assert_eq!(opens.iter().map(|part| part.contact).collect::<Vec<_>>(), [0, 1]);
    Ok(())
}

/// A box of 100 N on a box of 50 N is pushed at the top. Both tip at 1 m · F = 0.3 m · 150 N; the upper box alone would tip at 60 N.
#[test]
fn a_stack_tips_over_as_one() -> Tested {
    let pair = grasp_lcp::planar::SoftFingertip::pair(0.6)?;
    let face = |y: f64, name: &str| {
        Contact::new([0.0, y], [0.0, 1.0]).name(name).series_stiffness(1e7, 1e7).friction(0.9)
    };
    let floor = pair.contacts(&face(0.0, "floor"))?.into_iter().map(|point| point.on("lower"));
    let between =
        pair.contacts(&face(0.5, "between"))?.into_iter().map(|point| point.on("upper").against("lower"));
    let weight = |newtons: f64| Wrench::force([0.0, -newtons]);
    let stack = Bodies::new([Body::new("upper").load(weight(100.0)), Body::new("lower").load(weight(50.0))])
        .contacts(floor.chain(between))
        .grasp()?;
    let verdict = stack.hold(Wrench::force_at([60.0, 0.0], [0.0, 1.0]))?;
    assert!((60.0 * verdict.held_to - 45.0).abs() < 1e-9, "{verdict}");
    let lost = verdict.lost.as_ref().expect("tips");
    let WayOut::Apart { bodies } = &lost.way_out else { panic!("{verdict}") };
    assert_eq!(bodies.iter().map(|body| body.body.as_str()).collect::<Vec<_>>(), ["upper", "lower"]);
    for body in bodies {
        let WayOut::TipsOver { about, .. } = &body.way else { panic!("{verdict}") };
        assert_eq!(names(about), ["floor"]);
    }
    Ok(())
}

/// The cutter turns a bar in a chuck of three jaws. By symmetry the bar turns about its middle, whatever the rounding.
#[test]
fn a_bar_turns_about_its_middle() -> Tested {
    for tilt in [0.0, 0.3, 1.1] {
        let jaw = |k: u32| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 3.0 + tilt).sin_cos();
            Contact::new([0.025 * cos, 0.025 * sin], [-cos, -sin])
                .series_stiffness(1e7, 6e6)
                .friction(0.15)
                .pressed_with(2e3)
        };
        let verdict = Grasp::new((0..3).map(jaw))?.hold(Wrench::new([0.0, 0.0], 30.0))?;
        // The jaws hold a moment of 3 μ F r = 22.5 N m by friction.
        assert!((30.0 * verdict.held_to - 22.5).abs() < 1e-9, "{verdict}");
        let WayOut::Turns { centre, .. } = verdict.lost.as_ref().expect("turns").way_out else {
            panic!("{verdict}")
        };
        assert_eq!([centre[0], centre[1]], [0.0, 0.0], "{verdict}");
    }
    Ok(())
}

/// A shaft in a press fit under an axial force and a moment about its axis leaves in a screw: all contacts slide along the ratio of both.
#[test]
fn a_shaft_leaves_its_press_fit_in_a_screw() -> Tested {
    let (radius, axial, moment) = (0.02, 1150.0, 10.0);
    let contact = |k: u32| {
        let (y, x) = (f64::from(k) * std::f64::consts::TAU / 12.0).sin_cos();
        spatial::Contact::new([radius * x, radius * y, 0.0], [-x, -y, 0.0])
            .series_stiffness(1e8, 1e8)
            .friction(0.2)
            .pressed_with(500.0)
    };
    let verdict = spatial::Grasp::new((0..12).map(contact))?
        .hold(spatial::Wrench::new([0.0, 0.0, axial], [0.0, 0.0, moment]))?;
    let lost = verdict.lost.as_ref().expect("slips out");
    assert!((lost.factor - 1200.0 / axial.hypot(moment / radius)).abs() < 1e-9, "{verdict}");
    let WayOut::Turns { advance, .. } = lost.way_out else { panic!("{verdict}") };
    assert!((advance.abs() - radius * axial / (moment / radius)).abs() < 1e-6, "{verdict}");
    assert!(verdict.to_string().starts_with("SLIPS OUT at 0.956942"), "{verdict}");
    assert!(verdict.to_string().contains("moving 46 mm along it for each radian"), "{verdict}");
    Ok(())
}

/// A weight beyond the end of a plank tips it over this end, however little beyond it acts.
#[test]
fn a_weight_just_beyond_an_edge_tips_over_it() -> Tested {
    let table = [[0.5, 0.3], [-0.5, 0.3], [-0.5, -0.3], [0.5, -0.3]].map(|[x, y]| {
        let name = format!("leg {x} {y}");
        spatial::Contact::new([x, y, 0.0], [0.0, 0.0, 1.0])
            .name(name)
            .series_stiffness(1e5, 1e5)
            .friction(0.5)
    });
    let table = spatial::Grasp::new(table)?;
    for beyond in [1e-11, 1e-9, 1e-7, 1e-3] {
        let at = 0.05 * (1.0 + beyond);
        let lost = box_on_feet()?.hold(Wrench::force_at([0.0, -490.0], [at, 0.0]))?.lost.expect("tips");
        let WayOut::TipsOver { about, opens } = &lost.way_out else { panic!("{beyond}: {lost}") };
        assert_eq!((names(about), names(opens)), (vec!["right"], vec!["left"]));
        let weight = spatial::Wrench::force_at([0.0, 0.0, -780.0], [10.0 * at, 0.0, 0.0]);
        let lost = table.hold(weight)?.lost.expect("tips");
        let WayOut::TipsOver { about, .. } = &lost.way_out else { panic!("{beyond}: {lost}") };
        assert_eq!(names(about), ["leg 0.5 0.3", "leg 0.5 -0.3"]);
    }
    Ok(())
}

/// Two jaws on free slides that a tendon couples: what they grip moves with them, and nothing slides.
#[test]
fn what_takes_the_hand_along_does_not_slip_out() -> Tested {
    use grasp_lcp::planar::hand::{Finger, Hand, Joint, Tendon};
    let jaw = |side: f64| {
        let pad = Contact::new([0.03 * side, 0.0], [-side, 0.0]).series_stiffness(1e5, 1e5).friction(0.5);
        Finger::new([Joint::prismatic([-side, 0.0])]).contact(pad)
    };
    let hand = Hand::new([jaw(-1.0), jaw(1.0)]).tendon(Tendon::new([1.0, 1.0]).tension(20.0));
    let verdict = hand.grasp()?.hold(Wrench::force([5.0, 0.0]))?;
    let said = "GIVES WAY at once, under any part of 5 N: the object moves along +x, the hand with it";
    assert_eq!(verdict.to_string(), said);
    Ok(())
}
