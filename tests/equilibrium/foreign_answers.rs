//! An equilibrium or onset of another grasp, with more or fewer contacts, causes no panic. Contacts that only one of the grasps has contribute zero.

use std::error::Error;

use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};

fn on_feet(places: &[f64]) -> Result<Grasp, grasp_lcp::Error> {
    let foot = |x: &f64| Contact::new([*x, 0.0], [0.0, 1.0]).series_stiffness(1e3, 8e2).friction(0.5);
    Grasp::new(places.iter().map(foot))
}

#[test]
fn forces_of_fewer_or_more_contacts_are_split() -> Result<(), Box<dyn Error>> {
    let (two, three) = (on_feet(&[-1.0, 1.0])?, on_feet(&[-1.0, 0.0, 1.0])?);
    for (grasp, other) in [(&two, &three), (&three, &two)] {
        let outcome = other.solve(Wrench::force([0.0, -6.0]))?;
        let split = grasp.statics().decompose(outcome.equilibrium().ok_or("the feet stand")?);
        assert_eq!((split.equilibrating.len(), split.interaction.len()), (2, 2));
    }
    Ok(())
}

#[test]
fn an_onset_has_no_gradients_in_another_grasp() -> Result<(), Box<dyn Error>> {
    let grasp = on_feet(&[-1.0, 1.0])?;
    let ramp = Ramp::load(Wrench::force([0.0, -6.0]), Wrench::force([1.0, 0.0]));
    let onset = grasp.onset(&ramp)?;
    let event = onset.event().ok_or("it slides at 3 N")?;
    assert_eq!(grasp.sensitivity().onset(event).ok_or("its own")?.leavers().len(), 2);
    assert!(on_feet(&[-1.0, 1.0, 2.0])?.sensitivity().onset(event).is_none());
    Ok(())
}
