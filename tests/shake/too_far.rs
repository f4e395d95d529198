//! Motions within a cycle that are no longer small are named, although the object comes back.

use grasp_lcp::equilibrium::TooFar;
use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};

/// Two jaws press with 8 N each. Under more than 16 N one jaw is open, and its gap grows by the additional load divided by the stiffness of the other
/// jaw.
#[test]
fn jaws_that_open_too_far_in_every_cycle_are_named() {
    let jaw = |x: f64, name: &str| {
        let jaw = Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(2e3, 1e3).friction(0.5);
        jaw.pressed_with(8.0).name(name)
    };
    let grasp = Grasp::new([jaw(-0.04, "left"), jaw(0.04, "right")]).unwrap();
    let shaken = |force: f64| {
        // The load pulls in front of the jaw that stays closed. Behind it, the object would turn over.
        let pull = |x: f64| Wrench::force_at([x, 0.0], [0.1 * x.signum(), 0.0]);
        let legs = [force, -force].map(|x| Leg::there_and_back(pull(x)));
        grasp.shake(Wrench::ZERO, &legs.concat()).unwrap()
    };
    // Small motions end at a tenth of the grasp's size, 4 mm. The gap is the force divided by 2000 N/m, minus 8 mm.
    assert_eq!(shaken(23.0).too_far, None, "{}", shaken(23.0));
    let far = shaken(25.0);
    assert!(
        far.rests() == Some(true)
            && far.to_string().starts_with("GOES TOO FAR: left opens by more than 4 mm"),
        "{far}"
    );
}

/// A bar that two fingers press with N at ±a buckles beyond `N = k a` with tangential stiffness k, in whichever order loads come.
#[test]
fn a_bar_that_buckles_is_not_at_rest_in_any_order() {
    for (press, buckles) in [(19.0, false), (21.0, true)] {
        let finger = |x: f64| {
            let finger = Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e5, 500.0).friction(0.5);
            finger.pressed_with(press)
        };
        let grasp = Grasp::new([finger(-0.04), finger(0.04)]).unwrap();
        let found = grasp.statics().shakedown(Wrench::ZERO, &[Wrench::force([0.0, -1.0])]).unwrap().unwrap();
        assert_eq!(found.too_far == Some(TooFar::Buckles), buckles, "{found}");
        assert_eq!(found.to_string().starts_with("BUCKLES: "), buckles, "{found}");
    }
}
