//! If it depends on the unknowns which contact slips first, the fit also tries other assignments of slips to contacts. The answer does not depend on
//! the start.

use grasp_lcp::identify::{Identified, Identify, Slip, Unknown};
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use support::jaws::jaws;

type Tested = Result<(), grasp_lcp::Error>;

/// Loads at which two jaws with friction 0.9 and 0.423 slide: 20 N times the smaller coefficient, with a scatter of 2 %.
const LOADS: [f64; 6] = [8.3, 8.62, 8.44, 8.57, 8.28, 8.55];

fn each() -> [Unknown; 2] {
    [0, 1].map(|k| Unknown::friction().of_contacts([k]))
}

fn from(start: [f64; 2], slip: fn(Wrench) -> Slip<2>) -> Result<Identified, grasp_lcp::Error> {
    let slips = LOADS.map(|newtons| slip(Wrench::force([0.0, -newtons])));
    jaws(start)?.identify(&Identify::new(each(), slips).with_outliers_beyond(f64::INFINITY))
}

/// The jaw with less friction slides. One of the two jaws has the coefficient that the mean of the slips gives. No start determines which jaw.
#[test]
fn one_of_two_jaws_whichever_the_start() -> Tested {
    let logs = LOADS.map(|newtons| (newtons / 20.0).ln());
    let mean = logs.iter().sum::<f64>() / 6.0;
    let scatter = (logs.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / 5.0).sqrt();
    for slip in [Slip::gross, Slip::first] {
        for start in [[0.3, 0.5], [0.5, 0.3], [0.9, 0.423], [0.5, 0.5]] {
            let found = from(start, slip)?;
            let said = found.to_string();
            assert!(said.starts_with("one of"), "{start:?}: {said}");
            assert_eq!(found.slips, 6);
            // No jaw is given a value, which might be that of the other jaw.
            assert!(
                found.estimates.iter().all(|each| !each.is_fixed && each.standard_error.is_none()),
                "{found:?}"
            );
            assert_eq!(found.friction_less(), 0.0);
            assert!(found.free.is_empty() && !said.contains("do not depend"), "{said}");
            let [one, other] = &found.assignments[..] else { panic!("{start:?}: {found:?}") };
            let fixed =
                [one, other].map(|all| all.iter().position(|each| each.is_fixed).expect("one is fixed"));
            assert_eq!(fixed[0] + fixed[1], 1, "{start:?}: {found:?}");
            for (all, k) in [(one, fixed[0]), (other, fixed[1])] {
                assert!((all[k].value.ln() - mean).abs() < 1e-6, "{start:?}: {found:?}");
                let error = all[k].standard_error.expect("is known") / all[k].value;
                assert!((error - scatter / 6.0_f64.sqrt()).abs() < 1e-6, "{error}");
                assert!(!all[1 - k].is_fixed);
            }
        }
    }
    Ok(())
}

/// Two feet under a weight of 10 N that is nearer to one of them. They carry 7 N and 3 N, or 3 N and 7 N. Each carries half of a pull.
fn feet(start: [f64; 2]) -> Result<Grasp, grasp_lcp::Error> {
    let foot = |x: f64, mu, name| {
        Contact::new([x, 0.0], [0.0, 1.0]).name(name).series_stiffness(1e5, 1e5).friction(mu)
    };
    Grasp::new([foot(-0.1, start[0], "left"), foot(0.1, start[1], "right")])
}

fn pulled(newtons: f64, x: f64) -> Slip<2> {
    Slip::first(Wrench::force([newtons, 0.0])).on_top_of(Wrench::force_at([0.0, -10.0], [x, 0.0]))
}

/// In all slips the weight is nearer to the left foot, which carries 7 N. Either foot may have slipped first at the pull P: the left one with
/// friction P / 14, or the right one with P / 6.
#[test]
fn either_of_two_feet() -> Tested {
    for start in [[0.1, 0.9], [0.9, 0.1]] {
        let slips = [2.78, 2.8, 2.82].map(|newtons| pulled(newtons, -0.04));
        let found = feet(start)?.identify(&Identify::new(each(), slips))?;
        let said = found.to_string();
        assert!(said.starts_with("either friction of ") && said.contains(", or friction of "), "{said}");
        let mut of = [f64::NAN; 2];
        for all in &found.assignments {
            let k = all.iter().position(|each| each.is_fixed).expect("one is fixed");
            of[k] = all[k].value;
        }
        assert!((of[0] - 0.2).abs() < 1e-3 && (of[1] - 2.8 / 6.0).abs() < 1e-3, "{of:?} {said}");
    }
    Ok(())
}

/// With the weight nearer to the left foot the first slip is at the pull 2.8 N, and nearer to the right foot at 1.2 N. Only friction 0.2 of the left
/// foot explains both. The search finds this even if at its start the right foot slips first.
#[test]
fn the_assignment_that_fits_is_found_from_the_other_one() -> Tested {
    for start in [[0.2, 0.8], [0.8, 0.1]] {
        let slips = [
            pulled(2.78, -0.04),
            pulled(2.82, -0.04),
            pulled(2.8, -0.04),
            pulled(1.21, 0.04),
            pulled(1.19, 0.04),
            pulled(1.2, 0.04),
        ];
        let found = feet(start)?.identify(&Identify::new(each(), slips))?;
        assert!(found.assignments.is_empty(), "{start:?}: {found}");
        assert!(
            found.estimates[0].is_fixed && (found.estimates[0].value - 0.2).abs() < 1e-3,
            "{start:?}: {found}"
        );
        assert!(!found.estimates[1].is_fixed, "{start:?}: {found}");
        assert_eq!(found.estimates[1].name, "friction of right");
    }
    Ok(())
}

/// Three fingers around a disc under a torque: any one of them may be the first to slip, so each gives another assignment.
#[test]
fn one_of_three() -> Tested {
    let unknowns = [0, 1, 2].map(|k| Unknown::friction().of_contacts([k]));
    for start in [[0.3, 0.5, 0.7], [0.7, 0.3, 0.5], [0.5; 3]] {
        let grasp =
            Grasp::new([0, 1, 2].map(|i| {
                support::jaws::around::<2>(i, 3, 0.05, [1000.0, 800.0], start[i]).pressed_with(10.0)
            }))?;
        // Each finger carries a third of the torque. The first slip is at μ · 10 N · 3 · 0.05 m, which is 0.6 N m for μ = 0.4.
        let slips = [0.59, 0.6, 0.61].map(|m| Slip::first(Wrench::new([0.0; 2], m)));
        let found = grasp.identify(&Identify::new(unknowns.clone(), slips))?;
        assert!(found.to_string().starts_with("one of"), "{start:?}: {found}");
        assert_eq!(found.assignments.len(), 3, "{start:?}: {found:?}");
        for (k, all) in found.assignments.iter().enumerate() {
            let fixed: Vec<_> = all.iter().filter(|each| each.is_fixed).collect();
            assert!(fixed.len() == 1 && (fixed[0].value / 0.4 - 1.0).abs() < 0.01, "{k}: {found:?}");
        }
    }
    Ok(())
}
