//! Numbers that cannot be, by name; searches that cannot end well say so.

use grasp_lcp::identify::{Ending, Identify, Slip, Unknown};
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use support::jaws::jaws;

type Tested = Result<(), grasp_lcp::Error>;

fn down() -> Wrench {
    Wrench::force([0.0, -6.0])
}

#[test]
fn each_is_refused_by_name() -> Tested {
    let (grasp, slip, mu) = (jaws([0.5; 2])?, Slip::gross(down()), Unknown::friction());
    let refused = |asked: Identify<2>, message: &str| {
        let error = grasp.identify(&asked).expect_err(message);
        assert_eq!(error.to_string(), message);
    };
    let one = |unknown: Unknown| Identify::new([unknown], [slip.clone()]);
    refused(Identify::new([], [slip.clone()]), "unknowns: number is 0, must be at least 1");
    refused(Identify::new([mu.clone()], []), "slips: number is 0, must be at least 1");
    refused(
        one(mu.clone().of_contacts([2])),
        "unknown 0: number of the contact is 2, must be less than the number of contacts",
    );
    refused(one(mu.clone().of_contacts([])), "unknown 0: number of contacts is 0, must be at least 1");
    refused(one(mu.clone().in_layout(1)), "unknown 0: layout is 1, must be less than the number of layouts");
    refused(one(mu.clone().starting_at(-1.0)), "unknown 0: start is -1, must be from 1e-6 to 1e6");
    let with = |slip: Slip<2>| Identify::new([mu.clone()], [slip]);
    refused(with(Slip::gross(Wrench::ZERO)), "slip 0: size of the load is 0, must be more than 0");
    refused(
        with(slip.clone().squeezed(0.0)),
        "slip 0: squeeze is 0, must be more than 0 and at most 1e6 times the one given",
    );
    refused(with(slip.clone().in_layout(3)), "slip 0: layout is 3, must be less than the number of layouts");
    refused(
        with(slip.clone().scattering_by(f64::NAN)),
        "slip 0: scatter is NaN, must be more than 0 and at most 10: 0.05 is five percent",
    );
    refused(
        Identify::new([mu.clone()], [slip.clone(), slip.clone().scattering_by(0.1)]),
        "slip 1: scatter is 0.1, must be given for every slip, or for none",
    );
    refused(
        Identify::new([mu.clone()], [slip.clone().in_group(3), slip.clone()]),
        "slip 0: group is 3, must be given for every slip, or for none",
    );
    refused(
        Identify::new([mu.clone()], [slip.clone().in_group(3), slip.clone().in_group(3)]),
        "slips: number of groups is 1, must be at least 2: errors of groups are told by how far they are apart",
    );
    refused(
        Identify::new([mu.clone(), mu.clone().of_contacts([1])], [slip.clone()]),
        "unknown 1: number of the one that has its contacts, too, is 0, must be another one: no contact has two of a kind, or a squeeze beside what it carries",
    );
    refused(
        one(mu.clone()).knowing([1], 1.0, 0.1),
        "known sum 0: number of the unknown is 1, must be less than the number of unknowns",
    );
    refused(
        one(mu.clone()).knowing([0], -1.0, 0.1),
        "known sum 0: value is -1, must be more than 0 and at most 1e50",
    );
    refused(
        one(mu.clone()).with_outliers_beyond(0.5),
        "identify: bound of outliers is 0.5, must be at least 1 standard deviation, or infinite",
    );
    Ok(())
}

/// A load along the fingers presses one of them away, and slides nothing however large: no friction explains that it slid.
#[test]
fn a_slip_that_is_not_predicted() -> Tested {
    let wall = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e3, 1e3).friction(0.5);
    let other = Contact::new([0.1, 0.0], [0.0, 1.0]).series_stiffness(1e3, 1e3).friction(0.5);
    let block = Grasp::new([wall, other])?;
    let slips = [Slip::gross(Wrench::force_at([0.0, -3.0], [0.05, 0.0]))];
    let found = block.identify(&Identify::new([Unknown::friction()], slips))?;
    assert!(matches!(found.ending, Ending::NotPredicted { slip: 0, .. }), "{found}");
    assert_eq!(
        found.to_string(),
        "NOT FOUND from 1 slip: slip 0 is not predicted, it is not lost as far as it was followed"
    );
    assert!(!found.estimates[0].is_fixed && found.residuals.is_empty());
    Ok(())
}

#[test]
fn a_search_that_is_cut_short() -> Tested {
    let slips = [5.9, 6.1].map(|newtons| Slip::gross(Wrench::force([0.0, -newtons])));
    let asked = Identify::new([Unknown::friction().starting_at(5.0)], slips);
    let found = jaws([0.5; 2])?.identify(&asked.clone().with_iterations(1))?;
    assert_eq!(found.ending, Ending::NotConverged { iterations: 1 });
    assert!(
        found.to_string().ends_with("NOT CONVERGED in 1 steps: these numbers may still change"),
        "{found}"
    );
    assert_eq!(jaws([0.5; 2])?.identify(&asked)?.ending, Ending::Converged);
    Ok(())
}
