//! If no contact resists a rotation, the point of action of the load decides about stability. A part that is pinched above its centre of mass hangs.
//! A part that is pinched below it turns over. A load to the side swings what hangs by the angle whose tangent is the force over the weight.

use grasp_lcp::equilibrium::TooFar;
use grasp_lcp::hold::{Holding, LossVerb, ShortVerdict, Verdict};
use grasp_lcp::load_path::{Leg, Ramp};
use grasp_lcp::nalgebra::{Isometry3, Vector3};
use grasp_lcp::spatial::{Contact, Grasp, Wrench};
use grasp_lcp::{Settings, planar};
use proptest::prelude::*;

type Tested = Result<(), grasp_lcp::Error>;

fn turns_over<const C: usize>(verdict: &Verdict<C>) -> bool {
    let is_told = verdict.to_string().starts_with("TURNS OVER");
    assert_eq!(matches!(verdict.holding, Holding::TurnsOver { .. }), is_told, "{verdict}");
    assert_eq!(verdict.holds(), Some(!is_told), "{verdict}");
    is_told
}

fn pinch() -> [Contact; 2] {
    let finger = |x: f64| {
        Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0])
            .series_stiffness(1e5, 1e5)
            .friction(0.5)
            .pressed_with(100.0)
    };
    [finger(-0.03), finger(0.03)]
}

proptest! {
    /// The line through the fingers is the axis of a pendulum, in any frame. A weight beside the centre of the line, or to the side of the fingers,
    /// still acts above or below it. A load of which only the line is known, and one in the axis itself, are held.
    #[test]
    fn a_pinched_part_is_a_pendulum(
        height in prop_oneof![Just(0.0), -0.05..0.05f64],
        beside in -0.01..0.01f64,
        angles in prop::array::uniform3(-3.0..3.0f64),
        place in prop::array::uniform3(-1.0..1.0f64),
    ) {
        let pose = Isometry3::new(Vector3::from(place), Vector3::from(angles));
        let grasp = Grasp::new(pinch().map(|contact| contact.transformed(&pose)))?;
        let weight = Wrench::force_at([0.0, 0.0, -10.0], [beside, 0.0, height]);
        let over = turns_over(&grasp.hold(weight.transformed(&pose))?);
        prop_assert_eq!(over, height > 1e-6);
        let moved = weight.transformed(&pose);
        prop_assert!(!turns_over(&grasp.hold(Wrench::new(moved.resultant(), moved.moment()))?));
        // A sum of loads acts like its parts. A second weight of 20 N, as far on the other side of the line, decides: the part turns over if this
        // weight is above the line.
        let both = weight + Wrench::force_at([0.0, 0.0, -20.0], [beside, 0.0, -height]);
        prop_assert_eq!(turns_over(&grasp.hold(both.transformed(&pose))?), height < -1e-6);
        // A weight in front of the line swings the part until the weight is below the line. The swing is reported if it is small.
        let verdict = grasp.hold(Wrench::force_at([0.0, 0.0, -10.0], [0.0, 2e-3, height]).transformed(&pose))?;
        prop_assert_eq!((verdict.holds(), verdict.held_to), (Some(false), 0.0));
        let turns = verdict.swing.map(|swing| Vector3::from(swing.object.rotation()).norm());
        prop_assert_eq!(turns.is_some(), height < -0.02, "{:?}", turns);
        prop_assert!(turns.is_none_or(|turns| (turns * height + 2e-3).abs() < 1e-9), "{:?}", turns);
    }
}

/// A weight W and a force F to the side of it swing a lamp on a hinge and on a rope, and a crate on two ropes, by the angle F/W.
#[test]
fn what_hangs_swings_by_the_tangent() -> Tested {
    use planar::{Grasp, Link, Wrench};
    const ROPE: f64 = 0.7;
    let rope = |x: f64| Link::cable([x, 0.0], [x, ROPE]).contacts();
    let hinge = Link::hinge([0.0, 0.0]).contacts()?;
    let [lamp, crate_] = [rope(0.0)?, [rope(-0.3)?, rope(0.3)?].concat()];
    // The weight alone, beside the hinge, swings a lamp until it is below.
    let aside = Wrench::force_at([0.0, -20.0], [0.01, -0.2]);
    for load in [Ramp::load(aside, Wrench::ZERO), Ramp::load(Wrench::ZERO, aside)] {
        let swing = Grasp::new(hinge.clone())?.hold(load)?.swing.expect("hangs");
        assert!((swing.object.components()[2] + 0.05).abs() < 1e-12, "{swing:?}");
    }
    for (contacts, moves, turns) in [(hinge, 0.0, 1.0), (lamp, ROPE, 1.0), (crate_, ROPE, 0.0)] {
        let grasp = Grasp::new(contacts)?;
        for (part, height) in [(0.05, -0.2), (0.2, -0.2), (0.05, 0.2)] {
            let weight = Wrench::force_at([0.0, -20.0], [0.0, height]);
            let verdict =
                grasp.hold(Ramp::load(weight, Wrench::force_at([20.0 * part, 0.0], [0.0, height])))?;
            assert_eq!((verdict.holds(), verdict.held_to), (Some(false), 0.0));
            // A lamp with its weight above the support falls over. The crate on two ropes does not turn.
            let hangs = part < 0.1 && (height < 0.0 || turns == 0.0);
            assert_eq!(verdict.swing.is_some(), hangs, "{verdict}");
            assert_eq!(
                verdict.to_string().starts_with("SWINGS until the load hangs: it "),
                hangs,
                "{verdict}"
            );
            let Some(swing) = &verdict.swing else { continue };
            assert_eq!(verdict.to_string().contains("°"), turns != 0.0, "{verdict}");
            let [x, y, angle] = [0, 1, 2].map(|k| swing.object.components()[k]);
            for (is, must) in [(x, moves * part), (y, 0.0), (angle, turns * part)] {
                assert!((is - must).abs() < 1e-9, "{is} {must}");
            }
        }
    }
    Ok(())
}

/// A pencil stands on its tip at a point of friction: free to turn about it.
#[test]
fn a_pencil_on_its_tip() -> Tested {
    let tip = planar::Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(0.5);
    let grasp = planar::Grasp::new([tip])?;
    assert!(turns_over(&grasp.hold(planar::Wrench::force_at([0.0, -1.0], [0.0, 0.1]))?));
    assert!(!turns_over(&grasp.hold(planar::Wrench::force_at([0.0, -1.0], [0.0, -0.1]))?));
    Ok(())
}

/// A lamp on a hinge below the ceiling. The weights of the lamp and of a second body on top of it decide whether it turns over.
#[test]
fn bodies_on_a_hinge() -> Tested {
    for (low, high, over) in [(-0.3, 0.1, false), (-0.1, 0.3, true)] {
        let bodies = planar::Bodies::new([
            planar::Body::new("arm").mass(1.0, [0.0, low]),
            planar::Body::new("weight").mass(1.0, [0.0, high]),
        ])
        .links([
            planar::Link::hinge([0.0, 0.0]).stiffness(1e7).to_ground("arm"),
            planar::Link::hinge([-0.1, 0.0]).stiffness(1e7).between("arm", "weight"),
            planar::Link::hinge([0.1, 0.0]).stiffness(1e7).between("arm", "weight"),
        ]);
        let verdict = bodies.clone().gravity([0.0, -9.81]).grasp()?.hold(planar::Wrench::ZERO)?;
        assert_eq!(turns_over(&verdict), over, "{verdict}");
        // A load that is shared by mass acts at the centres of mass, whether its own point is known or not.
        let weight = bodies.weight([0.0, -9.81]);
        let shared = bodies.shared_by_mass().grasp()?;
        for weight in [weight, planar::Wrench::new(weight.resultant(), weight.moment())] {
            let verdict = shared.hold(weight)?;
            assert_eq!(turns_over(&verdict), over, "{verdict}");
        }
    }
    Ok(())
}

/// A weight of 10 N hangs at the depth d below the line through the fingers, and a load F is put on at the height h above it: it turns over beyond `F h
/// = 10 N d`, whatever is asked.
#[test]
fn a_load_on_top_of_what_hangs_turns_it_over() -> Tested {
    let (depth, height) = (0.02, 0.05);
    let (weight, limit) = (Wrench::force_at([0.0, 0.0, -10.0], [0.0, 0.0, -depth]), 10.0 * depth / height);
    let top = |force: f64| Wrench::force_at([0.0, 0.0, -force], [0.0, 0.0, height]);
    let grasp = Grasp::new(pinch())?;
    for part in [0.5, 0.99, 1.01, 4.0] {
        let (load, is_over) = (top(part * limit), part > 1.0);
        let far = is_over.then_some(TooFar::TurnsOver);
        let verdict = grasp.hold(Ramp::load(weight, load))?;
        assert_eq!(turns_over_at(&verdict), is_over, "{verdict}");
        // Rounding of the forces that press, 100 N, hides a geometric stiffness a billion times smaller.
        assert!((verdict.held_to * part - 1.0).abs() < 1e-6, "{verdict}");
        let ShortVerdict { motion, held_to, .. } = ShortVerdict::from(&verdict);
        assert_eq!((motion, held_to), (Some(LossVerb::TurnsOver), verdict.held_to));
        let row = |_: usize, contacts: &mut Vec<Contact>| {
            contacts.extend(pinch());
            [weight, load]
        };
        let brief = Grasp::hold_batch(1, &row, &Settings::default()).remove(0)?;
        assert_eq!((brief.motion, brief.holds()), (motion, Some(!is_over)));
        assert_eq!(grasp.statics().shakedown(weight, &[load])?.unwrap().too_far, far);
        assert_eq!(grasp.solve(weight + load)?.equilibrium().unwrap().too_far, far);
        let mut path = grasp.follow(weight, &[Leg::load_by(load)])?;
        path.run();
        let end = path.end_of_theory();
        assert_eq!(end.as_ref().map(|end| end.what.clone()), far);
        assert!(end.is_none_or(|end| (end.fraction * part - 1.0).abs() < 1e-6));
        assert_eq!(grasp.shake(weight, &Leg::there_and_back(load))?.too_far, far);
    }
    Ok(())
}

fn turns_over_at(verdict: &Verdict<3>) -> bool {
    let is_told = verdict.to_string().starts_with("TURNS OVER at ");
    assert_eq!(verdict.holds(), Some(!is_told), "{verdict}");
    is_told
}
