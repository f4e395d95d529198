//! An unknown that the slips do not determine gets a plain sentence and no value.

use grasp_lcp::identify::{Identified, Identify, Slip, Unknown};
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use support::jaws::jaws;

type Tested = Result<(), grasp_lcp::Error>;

fn slips() -> [Slip<2>; 5] {
    [5.9, 6.1, 6.3, 6.0, 5.8].map(|newtons| Slip::gross(Wrench::force([0.0, -newtons])))
}

fn says(found: &Identified, sentence: &str) {
    assert!(found.to_string().contains(sentence), "{found}");
    assert!(
        found
            .estimates
            .iter()
            .filter(|estimate| !estimate.is_fixed)
            .all(|estimate| { estimate.standard_error.is_none() && estimate.interval.is_none() })
    );
}

/// A pinch holds 2 μ N, so slips determine neither μ nor N alone.
#[test]
fn friction_and_squeeze() -> Tested {
    let found =
        jaws([0.5; 2])?.identify(&Identify::new([Unknown::friction(), Unknown::squeeze()], slips()))?;
    says(&found, "only their product");
    assert_eq!(found.free[0].unknowns, ["friction", "squeeze"]);
    assert!(found.slips == 5 && found.estimates.iter().all(|each| !each.is_fixed), "{found}");
    // The product μ N is determined all the same.
    let product = found.estimates[0].value * found.estimates[1].value;
    assert!((product - 0.30).abs() < 0.01, "{product}");
    assert_eq!(found.free.len(), 1);
    Ok(())
}

/// With a squeeze known from another source, friction is determined.
#[test]
fn what_is_known_besides_fixes_it() -> Tested {
    let unknowns = [Unknown::friction(), Unknown::squeeze()];
    let found = jaws([0.5; 2])?.identify(&Identify::new(unknowns, slips()).knowing([1], 1.0, 0.05))?;
    let [mu, squeeze] = &found.estimates[..] else { panic!("two unknowns") };
    assert!(mu.is_fixed && (mu.value - 0.30).abs() < 0.01 && found.free.is_empty(), "{found}");
    // Friction has the error of the squeeze, 5 %, and the scatter of the slips, 0.9 % of their mean.
    let part = |estimate: &grasp_lcp::identify::Estimate| {
        estimate.standard_error.map_or(f64::NAN, |error| error / estimate.value)
    };
    assert!((part(squeeze) - 0.05).abs() < 1e-6, "{found}");
    assert!((part(mu) - 0.05_f64.hypot(0.015 / 5.0_f64.sqrt())).abs() < 0.003, "{found}");
    Ok(())
}

/// A limit load does not depend on stiffness.
#[test]
fn stiffness_from_gross_slip() -> Tested {
    let found =
        jaws([0.5; 2])?.identify(&Identify::new([Unknown::stiffness(), Unknown::friction()], slips()))?;
    says(&found, "do not depend");
    assert_eq!(found.free[0].unknowns, ["tangential stiffness"]);
    assert!(!found.estimates[0].is_fixed && found.estimates[1].is_fixed, "{found}");
    Ok(())
}

/// Two feet that carry 5 N each slide together, each with its own friction. Their slips determine only the sum of both coefficients. Identification
/// reports a product, because first derivatives do not distinguish a product from a sum.
#[test]
fn friction_of_each_foot_from_both() -> Tested {
    let foot =
        |x: f64, name| Contact::new([x, 0.0], [0.0, 1.0]).name(name).series_stiffness(1e5, 1e5).friction(0.5);
    let block = Grasp::new([foot(-0.1, "left"), foot(0.1, "right")])?;
    let pulls = [2.9, 3.1, 3.0, 3.2];
    let slips = pulls
        .map(|newtons| Slip::gross(Wrench::force([newtons, 0.0])).on_top_of(Wrench::force([0.0, -10.0])));
    let each = [0, 1].map(|k| Unknown::friction().of_contacts([k]));
    let found = block.identify(&Identify::new(each, slips))?;
    says(&found, "only their sum");
    assert_eq!(found.free[0].unknowns, ["friction of left", "friction of right"]);
    let sum: f64 = found.estimates.iter().map(|estimate| estimate.value).sum();
    assert!((sum - 0.61).abs() < 0.01, "{sum}");
    Ok(())
}

/// Of two jaws the jaw with less friction slides, at a load of twice its friction limit. The slips do not show which one.
#[test]
fn friction_of_each_jaw_from_the_weaker() -> Tested {
    let each = [0, 1].map(|k| Unknown::friction().of_contacts([k]));
    let found = jaws([0.5; 2])?.identify(&Identify::new(each, slips()))?;
    says(&found, "one of the");
    let names: Vec<_> = found.estimates.iter().map(|each| each.name.as_str()).collect();
    assert_eq!(names, ["friction of left", "friction of right"]);
    // The mean of the logarithms of friction from each slip, and their scatter divided by the square root of their number.
    let logs = [5.9, 6.1, 6.3, 6.0, 5.8].map(|newtons: f64| (newtons / 20.0).ln());
    let mean = logs.iter().sum::<f64>() / 5.0;
    let error = (logs.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / 4.0 / 5.0).sqrt();
    assert_eq!(found.assignments.len(), 2);
    for all in &found.assignments {
        let one = all.iter().find(|each| each.is_fixed).expect("one is fixed");
        assert!((one.value.ln() - mean).abs() < 1e-3, "{found}");
        assert!((one.standard_error.expect("is known") / one.value / error - 1.0).abs() < 0.05, "{found}");
        let half = one.interval.map(|[low, high]| 0.5 * (high / low).ln()).expect("is known");
        assert!((half / error / 2.776_445 - 1.0).abs() < 0.05, "{found}");
    }
    Ok(())
}

/// Two feet share a pull P, and the first slip is where P/2 reaches μ N of one foot. The weight of 10 N is at x, so that the feet carry 5 N ∓ 50 x
/// N/m. In the first of seven slips alone, the right foot slips first. With μ = 0.47 it does so clearly. With μ = 0.6 that slip is merely 2.5 % below
/// the limit of the left foot, which is within the scatter.
#[test]
fn friction_that_would_explain_one_low_slip() -> Tested {
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(0.5);
    let block = Grasp::new([foot(-0.1), foot(0.1)])?;
    let each = [0, 1].map(|k| Unknown::friction().of_contacts([k]));
    for (right, is_fixed) in [(0.47, true), (0.6, false)] {
        let parts = [0.975, 1.01, 0.99, 1.005, 0.995, 1.01, 0.99];
        let slips = parts.iter().enumerate().map(|(k, part)| {
            let x = -0.03 + 0.01 * k as f64;
            let least = f64::min(0.3 * (5.0 - 50.0 * x), right * (5.0 + 50.0 * x));
            Slip::first(Wrench::force([2.0 * least * part, 0.0]))
                .on_top_of(Wrench::force_at([0.0, -10.0], [x, 0.0]))
        });
        let found = block.identify(&Identify::new(each.clone(), slips))?;
        let [left, other] = &found.estimates[..] else { panic!("two unknowns") };
        assert!(left.is_fixed && (left.value / 0.3 - 1.0).abs() < 0.01, "{found}");
        assert_eq!(other.is_fixed, is_fixed, "{found}");
        assert!(!is_fixed || (other.value / (0.975 * right) - 1.0).abs() < 1e-6, "{found}");
    }
    Ok(())
}

/// Friction and the load of each foot: without a known load, a common factor between loads and friction is open. With one, all are determined.
#[test]
fn friction_and_loads_of_supports() -> Result<(), support::Failure> {
    let known = support::identified::three_feet(12)?;
    let mut draw = support::samples::seeded(3);
    let limits = known.limits()?;
    let weighed = known.guess.identify(&known.asked(&limits, &mut draw))?;
    assert!(weighed.free.is_empty() && weighed.by_differences == 0, "{weighed}");
    let slips = limits.iter().map(|load| grasp_lcp::identify::Slip::gross(*load));
    let found = known.guess.identify(&Identify::new(known.unknowns.iter().cloned(), slips))?;
    let [free] = &found.free[..] else { panic!("{found}") };
    assert_eq!(free.unknowns, ["friction", "load of contact 0", "load of contact 1", "load of contact 2"]);
    assert!(free.powers[1..].iter().all(|power| (power + free.powers[0]).abs() < 1e-6), "{free:?}");
    assert!(free.says.contains("by any factor"), "{free:?}");
    // The ratios of the loads of the feet are determined.
    let loads: Vec<_> = found.estimates[1..].iter().map(|estimate| estimate.value).collect();
    let sum: f64 = loads.iter().sum();
    for (load, truth) in loads.iter().zip(&known.truth[1..]) {
        assert!((load / sum - truth / 14.0).abs() < 1e-6, "{found}");
    }
    Ok(())
}

/// If the scatter of the slips leaves an unknown uncertain by more than a factor of e, it gets no value.
#[test]
fn what_scatters_too_much() -> Tested {
    let slips = [0.6, 60.0, 6.0].map(|newtons| Slip::gross(Wrench::force([0.0, -newtons])));
    let found = jaws([0.5; 2])?.identify(&Identify::new([Unknown::friction()], slips))?;
    assert!(!found.estimates[0].is_fixed && found.slips == 3 && found.free.is_empty(), "{found}");
    assert!(found.to_string().contains("scatter too much"), "{found}");
    Ok(())
}

/// Pulls to one side make the first jaw slide, and pulls to the other side the second jaw. So each coefficient of friction depends on the slips of
/// one group alone. The scatter within one group does not show an error that all its slips have in common.
#[test]
fn what_one_group_tells_alone() -> Result<(), support::Failure> {
    let known = support::identified::first_slips()?;
    let limits = known.limits()?;
    let parts = [1.02, 0.98, 1.01, 0.97, 1.0];
    let slip = |k: usize| Slip::first(limits[k] * parts[k % 5]);
    let asked = |group: &dyn Fn(usize) -> usize| {
        let slips = (0..limits.len()).map(|k| slip(k).in_group(group(k)));
        known.guess.identify(&Identify::new(known.unknowns.iter().cloned(), slips))
    };
    let found = asked(&|k| k / 5)?;
    assert!(found.estimates.iter().all(|each| each.is_fixed && each.standard_error.is_none()), "{found}");
    let names: Vec<_> = found.estimates.iter().map(|each| each.name.as_str()).collect();
    assert_eq!(names, ["friction of left", "friction of right"]);
    assert!(found.to_string().contains("one group"), "{found}");
    let found = asked(&|k| k % 5)?;
    assert!(found.estimates.iter().all(|each| each.standard_error.is_some()), "{found}");
    Ok(())
}
