//! If there are three or more unknowns, and slips of several kinds depend on different unknowns, identification finds the assignment that fits. The
//! start does not matter.

use grasp_lcp::identify::{Estimate, Identified, Identify, Slip, Unknown};
use grasp_lcp::spatial::{Contact, Grasp, Wrench};

type Tested = Result<(), grasp_lcp::Error>;

/// Radius of the circle of three feet, m.
const RADIUS: f64 = 0.1;

fn foot(k: usize) -> [f64; 2] {
    let (sin, cos) = (std::f64::consts::TAU * k as f64 / 3.0).sin_cos();
    [RADIUS * cos, RADIUS * sin]
}

fn identified(start: [f64; 3], slips: Vec<Slip<3>>) -> Result<Identified, grasp_lcp::Error> {
    let feet = (0..3).map(|k| {
        let [x, y] = foot(k);
        Contact::new([x, y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(1e5, 1e5).friction(start[k])
    });
    let unknowns = [0, 1, 2].map(|k| Unknown::friction().of_contacts([k]));
    Grasp::new(feet)?.identify(&Identify::new(unknowns, slips))
}

/// Three loads around a value, 1 % apart.
fn about(value: f64) -> [f64; 3] {
    [0.99 * value, value, 1.01 * value]
}

/// A weight of 10 N over the point p. Of this weight, foot k at p_k carries the share 1/3 + 2 (p · p_k) / (3 R²).
fn weight_over(point: [f64; 2]) -> Wrench {
    Wrench::force_at([0.0, 0.0, -10.0], [point[0], point[1], 0.0])
}

/// A first slip of foot k. The weight is half way between the centre and this foot, so that it carries 2/3 of the weight. A horizontal pull through
/// the centre puts a third of the pull on each foot.
fn pulled_over(k: usize, newtons: f64) -> Slip<3> {
    let [x, y] = foot(k);
    Slip::first(Wrench::force([newtons, 0.0, 0.0])).on_top_of(weight_over([0.5 * x, 0.5 * y]))
}

/// Whether an assignment determines exactly the given values and leaves the others open.
fn fixes(all: &[Estimate], values: [Option<f64>; 3]) -> bool {
    all.iter().zip(values).all(|(estimate, value)| match value {
        Some(value) => estimate.is_fixed && (estimate.value / value - 1.0).abs() < 1e-3,
        None => !estimate.is_fixed,
    })
}

/// The moment at which three feet turn, N m: the minimum of W / 3 Σ μ_k |c - p_k| over all centres c, by refining a grid.
fn least_moment(friction: [f64; 3]) -> f64 {
    let moment = |c: [f64; 2]| {
        let arm = |k: usize| (c[0] - foot(k)[0]).hypot(c[1] - foot(k)[1]);
        (0..3).map(|k| 10.0 / 3.0 * friction[k] * arm(k)).sum::<f64>()
    };
    let (mut best, mut step) = ([0.0; 2], RADIUS);
    while step > 1e-9 {
        let near = [[0.0; 2], [step, 0.0], [-step, 0.0], [0.0, step], [0.0, -step]];
        let next = near
            .map(|by| [best[0] + by[0], best[1] + by[1]])
            .into_iter()
            .min_by(|a, b| moment(*a).total_cmp(&moment(*b)))
            .expect("five");
        step = if next == best { 0.5 * step } else { step };
        best = next;
    }
    (0..3).map(|k| moment(foot(k))).fold(moment(best), f64::min)
}

/// With the weight near foot 0 the first slip is at 5 N · min(4 μ_0, μ_1, μ_2), here 1 N; near foot 1 at 5 N · min(μ_0, 4 μ_1, μ_2), here 1.5 N. So μ_1
/// is 0.2, and μ_0 or μ_2 is 0.3.
#[test]
fn each_kind_of_slip_has_its_own_foot() -> Tested {
    let mut slips = Vec::new();
    for (over, newtons) in [(0, 1.0), (1, 1.5)] {
        slips.extend(about(newtons).map(|newtons| pulled_over(over, newtons)));
    }
    for start in [[0.8, 0.8, 0.1], [0.1, 0.8, 0.8], [0.8, 0.1, 0.8], [0.5; 3], [0.3, 0.2, 0.9]] {
        let found = identified(start, slips.clone())?;
        let said = found.to_string();
        assert!(said.starts_with("friction of contact 1 0.2000 ±"), "{start:?}: {said}");
        assert!(said.contains("one of the two is 0.3000 ±"), "{start:?}: {said}");
        let expected = [[Some(0.3), Some(0.2), None], [None, Some(0.2), Some(0.3)]];
        assert_eq!(found.assignments.len(), 2, "{start:?}: {said}");
        for values in expected {
            assert!(found.assignments.iter().any(|all| fixes(all, values)), "{start:?}: {said}");
        }
    }
    Ok(())
}

/// The moment that turns two feet, whose coefficients have the sum 0.5, about the third, N m.
const TWIST: f64 = 10.0 * RADIUS * 0.5 / 1.732_050_807_568_877_2;

/// Gross slips under a vertical moment. The feet turn about the foot with the largest coefficient of friction. The moment is W R (μ_1 + μ_2) / √3,
/// with the weight W and the coefficients of the other two feet.
fn twisted() -> [Slip<3>; 3] {
    about(TWIST).map(|newton_metres| {
        Slip::gross(Wrench::new([0.0; 3], [0.0, 0.0, newton_metres])).on_top_of(weight_over([0.0; 2]))
    })
}

/// Gross slips under a moment alone determine a sum of two coefficients, but neither which two, nor whether all three feet slide.
#[test]
fn a_twist_depends_on_two_of_three_or_on_all() -> Tested {
    for start in [[0.3, 0.3, 0.9], [0.9, 0.3, 0.35]] {
        let found = identified(start, twisted().into())?;
        let said = found.to_string();
        for all in &found.assignments {
            assert!(fixes(all, [None; 3]), "{start:?}: {said}");
            let moment = least_moment([0, 1, 2].map(|k| all[k].value));
            assert!((moment / TWIST - 1.0).abs() < 1e-3, "{start:?}: {moment}, {said}");
        }
        assert!(found.assignments.len() >= 3, "{start:?}: {said}");
        let end = "On which of friction of contact 0, friction of contact 1 and friction of contact 2 the slips depend is not fixed";
        assert!(said.ends_with(end), "{start:?}: {said}");
    }
    Ok(())
}

/// With the weight near foot 0, first slips at 1 N mean that one of 4 μ_0, μ_1 and μ_2 is 0.2. The coefficient of this foot and one of the other two
/// coefficients have the sum 0.5.
#[test]
fn a_twist_and_a_pull_leave_six_pairs() -> Tested {
    let mut slips: Vec<_> = twisted().into();
    slips.extend(about(1.0).map(|newtons| pulled_over(0, newtons)));
    let found = identified([0.9, 0.3, 0.3], slips)?;
    let [low, part, rest, high] = [0.05, 0.2, 0.3, 0.45].map(Some);
    for values in [
        [rest, part, None],
        [rest, None, part],
        [low, high, None],
        [low, None, high],
        [None, rest, part],
        [None, part, rest],
    ] {
        assert!(found.assignments.iter().any(|all| fixes(all, values)), "{values:?}: {found}");
    }
    for all in &found.assignments {
        let values = [0, 1, 2].map(|k| all[k].value);
        let (moment, pull) = (least_moment(values), 5.0 * (4.0 * values[0]).min(values[1]).min(values[2]));
        assert!(
            (moment / TWIST - 1.0).abs() < 1e-3 && (pull - 1.0).abs() < 1e-3,
            "{values:?}: {moment}, {pull}"
        );
    }
    Ok(())
}
