//! Invalid data are refused with an error that names them, and a search without a valid result says so.

use grasp_lcp::identify::{FitEnding, Identify, Slip, Unknown};
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use support::facts;
use support::jaws::jaws;

type Tested = Result<(), grasp_lcp::Error>;

fn down() -> Wrench {
    Wrench::force([0.0, -6.0])
}

#[test]
fn each_is_refused_by_name() -> Tested {
    let (grasp, slip, mu) = (jaws([0.5; 2])?, Slip::gross(down()), Unknown::friction());
    // The end of the datum's name is compared.
    let refused = |asked: Identify<2>, place: &str, datum: &str, value: &str| {
        let [told, field, given] = facts(&grasp.identify(&asked).expect_err(datum));
        assert!(told == place && field.ends_with(datum) && given == value, "{told} {field} {given}");
    };
    let one = |unknown: Unknown| Identify::new([unknown], [slip.clone()]);
    refused(Identify::new([], [slip.clone()]), "unknowns", "number", "0");
    refused(Identify::new([mu.clone()], []), "slips", "number", "0");
    refused(one(mu.clone().of_contacts([2])), "contact", "2", "2");
    refused(one(mu.clone().of_contacts([])), "unknown 0", "number of contacts", "0");
    refused(one(mu.clone().in_layout(1)), "unknown 0", "layout", "1");
    refused(one(mu.clone().starting_at(-1.0)), "unknown 0", "start", "-1");
    let with = |slip: Slip<2>| Identify::new([mu.clone()], [slip]);
    refused(with(Slip::gross(Wrench::ZERO)), "slip 0", "the load", "0");
    refused(with(slip.clone().squeezed(0.0)), "slip 0", "squeeze", "0");
    refused(with(slip.clone().in_layout(3)), "slip 0", "layout", "3");
    refused(with(slip.clone().scattering_by(f64::NAN)), "slip 0", "scatter", "NaN");
    let slips = |these: [Slip<2>; 2]| Identify::new([mu.clone()], these);
    refused(slips([slip.clone(), slip.clone().scattering_by(0.1)]), "slip 1", "scatter", "0.1");
    refused(slips([slip.clone().in_group(3), slip.clone()]), "slip 0", "group", "3");
    let one_group = [slip.clone().in_group(3), slip.clone().in_group(3)];
    refused(slips(one_group), "slips", "number of groups", "1");
    let pressed = slip.clone().on_top_of(Wrench::force([-2.0, 0.0]));
    refused(Identify::new([Unknown::carried()], [pressed]), "slip 0, left", "onto it", "2");
    let twice = [mu.clone(), mu.clone().of_contacts([1])];
    refused(Identify::new(twice, [slip.clone()]), "unknown 1", "its contacts, too,", "0");
    refused(one(mu.clone()).knowing([1], 1.0, 0.1), "known sum 0", "the unknown", "1");
    refused(one(mu.clone()).knowing([0], -1.0, 0.1), "known sum 0", "value", "-1");
    refused(one(mu.clone()).with_outliers_beyond(0.5), "identify", "outliers", "0.5");
    Ok(())
}

/// A load along the pinch line opens one finger, and no contact slides at any size. So no friction explains an observed slip.
#[test]
fn a_slip_that_is_not_predicted() -> Tested {
    let wall = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e3, 1e3).friction(0.5);
    let other = Contact::new([0.1, 0.0], [0.0, 1.0]).series_stiffness(1e3, 1e3).friction(0.5);
    let block = Grasp::new([wall, other])?;
    let slips = [Slip::gross(Wrench::force_at([0.0, -3.0], [0.05, 0.0]))];
    let found = block.identify(&Identify::new([Unknown::friction()], slips))?;
    assert!(matches!(found.ending, FitEnding::NotPredicted { slip: 0, .. }), "{found}");
    assert!(found.to_string().starts_with("NOT FOUND"), "{found}");
    assert!(!found.estimates[0].is_fixed && found.residuals.is_empty());
    Ok(())
}

#[test]
fn a_search_that_is_cut_short() -> Tested {
    let slips = [5.9, 6.1].map(|newtons| Slip::gross(Wrench::force([0.0, -newtons])));
    let asked = Identify::new([Unknown::friction().starting_at(5.0)], slips);
    let found = jaws([0.5; 2])?.identify(&asked.clone().with_iterations(1))?;
    assert_eq!(found.ending, FitEnding::NotConverged { iterations: 1 });
    assert!(found.to_string().contains("NOT CONVERGED"), "{found}");
    assert_eq!(jaws([0.5; 2])?.identify(&asked)?.ending, FitEnding::Converged);
    Ok(())
}
