//! An answer names what bounds it: arms that are too short, the range of small motions, the load at rest alone, and a start that does not hold.

use grasp_lcp::need::{Amount, Need};
use grasp_lcp::planar::{Contact, Grasp, Turn, Wrench};

type Tested = Result<(), Box<dyn std::error::Error>>;

fn contact(point: [f64; 2], normal: [f64; 2], friction: f64, stiffness: f64) -> Contact {
    Contact::new(point, normal).series_stiffness(stiffness, stiffness).friction(friction)
}

/// A drawer of width 0.5 m between guides of length L, friction 0.3, is pulled with F at a distance x from its middle. Its moment is balanced by a
/// couple `N L = F x`. The friction of both forces N jams the drawer from `x = L / (2 μ)` on. Some of these distances are smaller than the distances
/// between contacts.
#[test]
fn a_drawer_jams_from_an_arm_on() -> Tested {
    for length in [0.001, 0.05, 0.3, 0.6] {
        let guide = |side: f64, y: f64| contact([0.25 * side, y], [-side, 0.0], 0.3, 1e7);
        let drawer =
            Grasp::new([guide(-1.0, 0.0), guide(-1.0, length), guide(1.0, 0.0), guide(1.0, length)])?;
        let pull = Wrench::force([0.0, -10.0]);
        let per_metre = Wrench::force_at([0.0, -10.0], [1.0, 0.0]) - pull;
        let needed = drawer.need(&Need::arm(pull, per_metre).to_hold())?;
        let (Amount::Bound { until: Some(end), is_too_far: true, .. } | Amount::Any { until: Some(end), .. }) =
            &needed.amount
        else {
            panic!("{needed}")
        };
        // At the end of the range that is not the bound, the answer gives two amounts at most 1e-4 apart. The limit lies between them.
        let [sufficient, insufficient] = [end.sufficient, end.insufficient].map(|x| x * 0.6 / length);
        assert!(
            insufficient < 1.0 + 1e-9 && sufficient > 1.0 - 1e-9 && sufficient - insufficient < 1e-4,
            "{sufficient} {insufficient}: {needed}"
        );
    }
    Ok(())
}

/// A box on a slope of 30° with friction 0.3 slides under its weight alone, and 50 N hold it. With the weight as the load at rest, no multiple of a
/// push is the answer, because the load at rest is not held.
#[test]
fn a_load_at_rest_that_is_not_held() -> Tested {
    let (sin, cos) = (30.0_f64.to_radians()).sin_cos();
    let foot = |along: f64| contact([along * cos, along * sin], [-sin, cos], 0.3, 1e6);
    let slope = Grasp::new([foot(-0.1), foot(0.1)])?;
    let (weight, push) = (Wrench::force([0.0, -100.0]), Wrench::force([50.0, 0.0]));
    assert_eq!(slope.hold(weight + push)?.holds(), Some(true));
    let needed = slope.need(&Need::load(push).on_top_of(weight).to_hold())?;
    assert!(matches!(needed.amount, Amount::None { is_proved: true, at_rest: true, .. }), "{needed}");
    Ok(())
}

/// A box at a vertical wall slides before the wall is tilted.
#[test]
fn a_turn_whose_start_is_not_held() -> Tested {
    let wall = Grasp::new([-0.1, 0.1].map(|y| contact([0.0, y], [1.0, 0.0], 0.5, 1e6)))?;
    let needed = wall.need(&Need::angle(Turn::tilting([0.0, -9.81], [0.0, 0.0])).to_hold())?;
    assert!(
        needed.to_string().starts_with("NO angle does, since it does not hold before it turns"),
        "{needed}"
    );
    Ok(())
}

/// A box on two feet, with its weight at the height of the feet, is tilted until it slides, at `tan θ = μ` if both feet have the same coefficient.
/// The foot with less friction slides first. While both feet stick, each carries half of the tangential force.
#[test]
fn a_turn_names_what_slides() -> Tested {
    let feet = |left: f64, right: f64| {
        Grasp::new([
            contact([-0.5, 0.0], [0.0, 1.0], left, 1e6).name("left"),
            contact([0.5, 0.0], [0.0, 1.0], right, 1e6).name("right"),
        ])
    };
    let turn = Turn::tilting([0.0, -10.0], [0.0, 0.0]);
    let otherwise = |grasp: &Grasp, need: Need<2>| {
        let needed = grasp.need(&need.if_lower_by(0.0, 0.0))?;
        let Amount::Bound { sufficient, otherwise, .. } = needed.amount else { panic!("{needed}") };
        Ok::<_, Box<dyn std::error::Error>>((sufficient, otherwise))
    };
    let (angle, why) = otherwise(&feet(0.3, 0.3)?, Need::angle(turn).to_hold())?;
    assert!((angle.tan() - 0.3).abs() < 1e-9, "{angle}");
    assert!(why.starts_with("SLIPS OUT at ") && why.contains("left and right slide"), "{why}");
    let (angle, why) = otherwise(&feet(0.2, 0.6)?, Need::angle(turn).to_stick())?;
    assert!((angle.tan() - 0.2).abs() < 1e-9, "{angle}");
    assert!(why.starts_with("left slides at "), "{why}");
    Ok(())
}
