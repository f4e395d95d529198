//! From slips without scatter, at loads computed by hand, identification returns every unknown to the last digits.

use grasp_lcp::identify::{FitEnding, Identified, Identify, Slip, Unknown};
use grasp_lcp::planar::{Contact, Grasp, Link, Turn, Wrench};
use support::jaws::{jaw, jaws};

type Tested = Result<(), grasp_lcp::Error>;

fn down(newtons: f64) -> Wrench {
    Wrench::force([0.0, -newtons])
}

fn are(found: &Identified, values: &[f64]) {
    assert_eq!(found.ending, FitEnding::Converged, "{found}");
    for (estimate, value) in found.estimates.iter().zip(values) {
        assert!((estimate.value / value - 1.0).abs() < 1e-9 && estimate.is_fixed, "{value}: {found}");
    }
}

/// For a pinch the load at first slip and at gross slip is 2 μ N.
#[test]
fn friction_of_a_pinch() -> Tested {
    for slip in [Slip::first, Slip::gross] {
        let found = jaws([0.5; 2])?
            .identify(&Identify::new([Unknown::friction()], [slip(down(6.2)), slip(down(6.2))]))?;
        are(&found, &[0.31]);
        assert_eq!(found.by_differences, 0, "exact derivatives");
    }
    Ok(())
}

/// A floor below the object stops it, but only after the jaws have slipped. So the floor does not change the identified friction of the jaws.
#[test]
fn friction_of_a_pinch_above_a_floor() -> Tested {
    // Friction of the jaws carries 10 N. The tangential deflection of their springs is then 0.5 mm, less than the clearance of the floor.
    let jaw = |x: f64| jaw::<2>(x, [1e4, 1e4], 0.5).pressed_with(10.0);
    let floor =
        Contact::new([0.0, -0.02], [0.0, 1.0]).series_stiffness(1e4, 5e3).friction(0.2).clearance(1e-3);
    let contacts = [jaw(-0.03), jaw(0.03), floor];
    let found = Grasp::new(contacts)?
        .identify(&Identify::new([Unknown::friction().of_contacts([0, 1])], [Slip::gross(down(6.2))]))?;
    are(&found, &[0.31]);
    assert_eq!(found.by_differences, 0, "exact derivatives");
    Ok(())
}

/// With the given friction of 0.5, a pinch that holds 12 N presses with 12 N, 1.2 times the given squeeze.
#[test]
fn squeeze_of_a_pinch() -> Tested {
    for slip in [Slip::first, Slip::gross] {
        let slips = [slip(down(12.0)), slip(down(12.0))];
        are(&jaws([0.5; 2])?.identify(&Identify::new([Unknown::squeeze()], slips.clone()))?, &[1.2]);
        // Both jaws press with the mean of their two commands, so that a factor of 1.4 at one jaw gives a force 1.2 times as large at each.
        are(&jaws([0.5; 2])?.identify(&Identify::new([Unknown::squeeze().of_contacts([1])], slips))?, &[1.4]);
    }
    Ok(())
}

/// A pinch that carries 4 N with μ = 0.4 is loosened. It slides at half of its squeeze of 10 N.
#[test]
fn friction_from_a_squeeze_that_is_loosened() -> Tested {
    let slips = [Slip::gross(down(4.0)).squeezed(0.5)];
    are(&jaws([0.5; 2])?.identify(&Identify::new([Unknown::friction()], slips))?, &[0.4]);
    Ok(())
}

/// A block on an incline begins to slide where tan θ = μ.
#[test]
fn friction_from_an_angle() -> Tested {
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(0.3);
    let block = Grasp::new([foot(-0.1), foot(0.1)])?;
    let turn = Turn::tilting([0.0, -5.0], [0.0, 0.0]).up_to(0.4_f64.atan());
    are(&block.identify(&Identify::new([Unknown::friction()], [Slip::gross_on_turn(turn)]))?, &[0.4]);
    are(&block.identify(&Identify::new([Unknown::friction()], [Slip::first_on_turn(turn)]))?, &[0.4]);
    Ok(())
}

/// An unknown friction of all contacts concerns only contacts with friction, not cables or frictionless feet. First case: a cable is as stiff as both
/// feet together and keeps half of its pretension, so that it presses the feet with 10 N. Second case: of two feet that carry 5 N each, only one has
/// friction.
#[test]
fn friction_of_contacts_that_rub() -> Tested {
    let foot = |x: f64, mu: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(mu);
    let cable = Link::cable([0.0, 0.1], [0.0, 0.0]).stiffness(2e5).pretension(20.0).contacts()?;
    let tied = Grasp::new([vec![foot(-0.1, 0.5), foot(0.1, 0.5)], cable].concat())?;
    let slip = Slip::gross(Wrench::force([3.0, 0.0]));
    are(&tied.identify(&Identify::new([Unknown::friction()], [slip]))?, &[0.3]);
    let lies = Grasp::new([foot(-0.1, 0.5), foot(0.1, 0.0)])?;
    let slip = Slip::gross(Wrench::force([1.5, 0.0])).on_top_of(down(10.0));
    are(&lies.identify(&Identify::new([Unknown::friction()], [slip]))?, &[0.3]);
    Ok(())
}

/// Two feet share a pull in proportion to their tangential stiffness. The foot that carries k₁/(k₁+k₂) of the pull slides first, at μ N (k₁+k₂)/k₁.
/// With known friction the first slip determines the ratio of stiffnesses, whose given value is one.
#[test]
fn a_ratio_of_stiffnesses_from_first_slip() -> Tested {
    let foot = |x: f64| {
        Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e4, 1e4).friction(0.5).pressed_with(10.0)
    };
    let guide = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e14, 1e9).kept_closed();
    let feet = Grasp::new([foot(-0.1), foot(0.1), guide])?;
    let ratio = 2.5;
    let pull = 0.5 * 10.0 * (ratio + 1.0) / ratio;
    let asked = Identify::new(
        [Unknown::stiffness().of_contacts([0]).starting_at(2.0)],
        [Slip::first(Wrench::force([pull, 0.0]))],
    );
    let found = feet.identify(&asked)?;
    assert!((found.estimates[0].value / ratio - 1.0).abs() < 1e-6, "{found}");
    Ok(())
}

/// Slips of two layouts, with jaws that press with 10 N and with 4 N. The unknowns are a common friction and the squeeze of the second layout.
#[test]
fn two_layouts() -> Tested {
    let gently = jaws([0.5; 2])?.squeezed(0.4)?;
    let slips = [Slip::gross(down(6.0)), Slip::gross(down(3.6)).in_layout(1)];
    let unknowns = [Unknown::friction(), Unknown::squeeze().in_layout(1)];
    let found = jaws([0.5; 2])?.identify(&Identify::new(unknowns, slips).and_layouts([gently]))?;
    are(&found, &[0.3, 1.5]);
    assert_eq!(found.estimates[1].name, "squeeze in layout 1");
    assert!(found.slips == 2 && found.estimates.iter().all(|each| each.interval.is_none()), "{found}");
    Ok(())
}
