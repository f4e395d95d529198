//! Standard errors agree with formulas of statistics, and outliers have little influence.

use grasp_lcp::identify::{Identify, Slip, Unknown};
use grasp_lcp::need::{Amount, Need};
use grasp_lcp::planar::Wrench;
use support::jaws::jaws;

type Tested = Result<(), grasp_lcp::Error>;

fn slip(newtons: f64) -> Slip<2> {
    Slip::gross(Wrench::force([0.0, -newtons]))
}

const LOADS: [f64; 5] = [5.4, 6.1, 6.6, 5.9, 6.3];

fn logarithms() -> (f64, f64) {
    let logs = LOADS.map(|newtons| (newtons / 20.0).ln());
    let mean = logs.iter().sum::<f64>() / 5.0;
    (mean, (logs.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / 4.0).sqrt())
}

/// Least squares of logarithms give their mean, the standard error s / √n, and Student's quantile with 4 degrees of freedom.
#[test]
fn a_mean_and_its_standard_error() -> Tested {
    let asked = Identify::new([Unknown::friction()], LOADS.map(slip)).with_outliers_beyond(f64::INFINITY);
    let found = jaws([0.5; 2])?.identify(&asked)?;
    let ((mean, s), mu) = (logarithms(), &found.estimates[0]);
    let close = |a: Option<f64>, b: f64| a.is_some_and(|a| (a / b - 1.0).abs() < 1e-6);
    assert!(close(Some(mu.value), mean.exp()) && close(found.scatter, s), "{found}");
    assert!(close(mu.standard_error, mean.exp() * s / 5.0_f64.sqrt()), "{found}");
    let half = 2.776_445 * s / 5.0_f64.sqrt();
    assert!(close(mu.interval.map(|[low, _]| low), (mean - half).exp()), "{found}");
    assert!(close(mu.interval.map(|[_, high]| high), (mean + half).exp()), "{found}");
    Ok(())
}

/// With a given scatter σ the standard error is σ / √n, with the normal quantile. Outliers are reported.
#[test]
fn a_scatter_that_is_given() -> Tested {
    let asked = |sigma: f64| {
        let slips = LOADS.map(|newtons| slip(newtons).scattering_by(sigma));
        Identify::new([Unknown::friction()], slips).with_outliers_beyond(f64::INFINITY)
    };
    let found = jaws([0.5; 2])?.identify(&asked(0.1))?;
    let (mean, s) = logarithms();
    let mu = &found.estimates[0];
    assert!(
        mu.standard_error
            .is_some_and(|error| (error / (mean.exp() * 0.1 / 5.0_f64.sqrt()) - 1.0).abs() < 1e-6)
    );
    let half = 1.959_964 * 0.1 / 5.0_f64.sqrt();
    assert!(mu.interval.is_some_and(|[low, _]| (low / (mean - half).exp() - 1.0).abs() < 1e-6), "{found}");
    assert!(found.misfit.is_some_and(|misfit| (misfit / (s / 0.1) - 1.0).abs() < 1e-6), "{found}");
    let tight = jaws([0.5; 2])?.identify(&asked(0.01))?;
    assert!(tight.misfit.is_some_and(|misfit| (misfit / (s / 0.01) - 1.0).abs() < 1e-6), "{tight}");
    assert!(tight.to_string().contains("as far off"), "{tight}");
    // Residuals of 7 given standard deviations show that the given scatter is too small. The reported error is then that of slips without a given
    // scatter.
    let (mu, half) = (&tight.estimates[0], 2.776_445 * s / 5.0_f64.sqrt());
    assert!(mu.interval.is_some_and(|[low, _]| (low / (mean - half).exp() - 1.0).abs() < 1e-6), "{tight}");
    Ok(())
}

/// Equal slips show no scatter, so that no error is known.
#[test]
fn slips_that_are_equal() -> Tested {
    let found = jaws([0.5; 2])?.identify(&Identify::new([Unknown::friction()], [6.0; 3].map(slip)))?;
    let mu = &found.estimates[0];
    assert!((mu.value / 0.3 - 1.0).abs() < 1e-9 && mu.is_fixed && mu.standard_error.is_none(), "{found}");
    assert!(found.scatter.is_none() && found.to_string().contains("the slips agree"), "{found}");
    Ok(())
}

/// Three specimens with three slips each: the standard error is that of the mean of three means, s / √3, and the interval uses Student's quantile
/// with 2 degrees of freedom.
#[test]
fn groups_of_slips() -> Tested {
    let loads = [5.4, 5.6, 5.5, 6.1, 6.0, 6.2, 6.6, 6.5, 6.4];
    let slips = loads.iter().enumerate().map(|(k, newtons)| slip(*newtons).in_group(7 + k / 3));
    let asked = Identify::new([Unknown::friction()], slips).with_outliers_beyond(f64::INFINITY);
    let found = jaws([0.5; 2])?.identify(&asked)?;
    let logs = loads.map(|newtons: f64| (newtons / 20.0).ln());
    let mean = logs.iter().sum::<f64>() / 9.0;
    let means = logs.chunks(3).map(|three| three.iter().sum::<f64>() / 3.0);
    let error = (means.map(|x| (x - mean).powi(2)).sum::<f64>() / 2.0 / 3.0).sqrt();
    let mu = &found.estimates[0];
    let close = |a: Option<f64>, b: f64| a.is_some_and(|a| (a / b - 1.0).abs() < 1e-6);
    assert!(close(Some(mu.value), mean.exp()) && close(mu.standard_error, mean.exp() * error), "{found}");
    assert!(close(mu.degrees_of_freedom, 2.0) && found.groups == Some(3), "{found}");
    assert!(close(mu.interval.map(|[low, _]| low), (mean - 4.302_653 * error).exp()), "{found}");
    assert!(found.to_string().contains("in 3 groups"), "{found}");
    assert!(found.slips == 9 && found.scatter.is_some(), "{found}");
    Ok(())
}

/// With one slip in each group, identification reports White's standard errors. For a single mean they are the same as without groups.
#[test]
fn groups_of_one_slip() -> Tested {
    let alone = Identify::new([Unknown::friction()], LOADS.map(slip)).with_outliers_beyond(f64::INFINITY);
    let slips = LOADS.iter().enumerate().map(|(k, newtons)| slip(*newtons).in_group(k));
    let grouped = Identify::new([Unknown::friction()], slips).with_outliers_beyond(f64::INFINITY);
    let [alone, grouped] =
        [jaws([0.5; 2])?.identify(&alone)?, jaws([0.5; 2])?.identify(&grouped)?].map(|found| {
            let mu = &found.estimates[0];
            [mu.standard_error.unwrap_or(f64::NAN), mu.interval.map_or(f64::NAN, |[low, _]| low)]
        });
    assert!(alone.iter().zip(grouped).all(|(a, g)| (a / g - 1.0).abs() < 1e-9), "{alone:?} {grouped:?}");
    Ok(())
}

/// One of ten loads is ten times too large. It changes the identified friction by less than the standard error. Least squares would change friction
/// by a quarter.
#[test]
fn a_slip_far_off_counts_less() -> Tested {
    let loads = [5.9, 6.1, 6.0, 6.2, 5.8, 6.1, 5.9, 6.05, 5.95, 60.0].map(slip);
    let asked = Identify::new([Unknown::friction()], loads);
    let found = jaws([0.5; 2])?.identify(&asked)?;
    let squares = jaws([0.5; 2])?.identify(&asked.clone().with_outliers_beyond(f64::INFINITY))?;
    let [robust, plain] = [&found, &squares].map(|found| found.estimates[0].value);
    assert!((robust / 0.3 - 1.0).abs() < 0.06 && plain > 0.37, "{robust} {plain}");
    assert!(found.to_string().contains("1 slip lies far"), "{found}");
    assert!(
        found.weights[9] < 0.2 && found.weights[..9].iter().all(|weight| *weight == 1.0),
        "{:?}",
        found.weights
    );
    Ok(())
}

/// Identified values can be used in `need` and `reserve`: the safe squeeze is that for friction at the low end of its interval.
#[test]
fn errors_go_on_into_needs() -> Tested {
    let asked = Identify::new([Unknown::friction()], LOADS.map(slip));
    let found = jaws([0.5; 2])?.identify(&asked)?;
    let sure = asked.grasp_with(&jaws([0.5; 2])?, &found)?;
    let mu = &found.estimates[0];
    let low = mu.interval.map_or(f64::NAN, |[low, _]| low);
    let need =
        Need::squeeze(Wrench::force([0.0, -4.0])).if_lower_by(found.friction_less(), found.squeeze_less());
    let needed = sure.need(&need)?;
    let [plain, safe] = [Some(&needed.amount), needed.safe.as_ref()]
        .map(|amount| amount.and_then(Amount::bound).unwrap_or(f64::NAN));
    // 2 μ N = 4 N, where N is the squeeze factor times 10 N.
    assert!(
        (plain - 4.0 / (20.0 * mu.value)).abs() < 1e-9 && (safe - 4.0 / (20.0 * low)).abs() < 1e-9,
        "{needed}"
    );
    let part = mu.standard_error.map_or(f64::NAN, |error| error / mu.value);
    assert_eq!(found.uncertainty(1).friction, part);
    let reserve = sure.reserve(Wrench::ZERO, &found.uncertainty(1), 2.0)?;
    assert!(format!("{reserve:?}").len() > 10);
    Ok(())
}
