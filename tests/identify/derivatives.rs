//! Derivatives of the gross-slip load with respect to the unknowns agree with differences of verdicts, for random grasps in the plane and in space.

use grasp_lcp::identify::{Identify, Slip, Unknown};
use grasp_lcp::{Settings, planar, spatial};
use support::samples::{samples, seeded};
use support::splitmix::Random;

type Tested = Result<(), grasp_lcp::Error>;

/// Step of the logarithm of an unknown, for differences of fourth order.
const STEP: f64 = 1e-3;
/// Relative standard deviation of the observed slip load.
const SCATTER: f64 = 1e-6;
/// At a kink the one-sided derivatives differ by more than this, relative to the derivative.
const EDGE: f64 = 0.02;
/// Smaller derivatives are treated as zero.
const FLAT: f64 = 1e-4;

#[derive(Debug, Default)]
struct Count {
    slips: usize,
    exact: usize,
    compared: usize,
}

/// The load factor at the loss if friction and squeeze of each contact are multiplied by these factors.
type Lost<'a> = dyn Fn(&[[f64; 2]]) -> Option<f64> + 'a;
/// The derivative of the logarithm of the slip load with respect to an unknown, as identification computes it. `None` if it is zero or not exact.
type Derivative<'a> = dyn Fn(Unknown) -> Result<Option<f64>, grasp_lcp::Error> + 'a;

fn compare(number: usize, lost: &Lost<'_>, told: &Derivative<'_>, count: &mut Count) -> Tested {
    for contact in 0..number {
        for kind in 0..2 {
            count.slips += 1;
            let at = |log: f64| {
                let mut factors = vec![[1.0; 2]; number];
                factors[contact][kind] = log.exp();
                lost(&factors).map(f64::ln)
            };
            let beside = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| at(k * STEP));
            let [Some(a), Some(b), Some(here), Some(c), Some(d)] = beside else { continue };
            let slope = (8.0 * (c - b) - (d - a)) / (12.0 * STEP);
            let edge = ((c - here) - (here - b)).abs() > EDGE * (c - b).abs() + 1e-9;
            let unknown = if kind == 0 { Unknown::friction() } else { Unknown::squeeze() };
            let Some(told) = told(unknown.of_contacts([contact]))? else { continue };
            count.exact += 1;
            if !edge && slope.abs() > FLAT {
                count.compared += 1;
                let off = (told / slope.abs() - 1.0).abs();
                assert!(off < 1e-6, "{told} {slope} {kind}");
            }
        }
    }
    Ok(())
}

macro_rules! derivatives {
    ($name:ident, $at:ident, $drawn:expr, $loaded:expr) => {
        #[test]
        fn $name() -> Tested {
            let (mut random, mut count) = (seeded(11), Count::default());
            for _ in 0..samples(20) {
                let drawn: Vec<_> = (0..random.index(2, 5)).map(|k| $drawn(k, &mut random)).collect();
                let [base, load]: [$at::Wrench; 2] = $loaded(&mut random);
                let grasp = |factors: &[[f64; 2]]| {
                    let contact = |((contact, friction, command), [by, squeeze]): (
                        &($at::Contact, f64, f64),
                        &[f64; 2],
                    )| {
                        let contact = contact.clone().friction(friction * by);
                        contact.pressed_with(command * squeeze)
                    };
                    let contacts = drawn.iter().zip(factors).map(contact).collect::<Vec<_>>();
                    // Gross slip is the loss of equilibrium, without a limit on motions.
                    $at::Grasp::new(contacts)
                        .expect("valid")
                        .with(&Settings::default().with_small_motions(1e50, 1e50))
                };
                let lost = |factors: &[[f64; 2]]| {
                    let verdict = grasp(factors).hold($at::Ramp::load(base, load * 1000.0)).expect("a load");
                    verdict.lost.map(|lost| lost.factor * 1000.0)
                };
                let same = vec![[1.0; 2]; drawn.len()];
                let Some(at) = lost(&same).filter(|at| *at > 1e-3) else { continue };
                let slip = Slip::gross(load * at).on_top_of(base).scattering_by(SCATTER);
                let grasp = grasp(&same);
                let told = |unknown: Unknown| {
                    let asked = Identify::new([unknown], [slip.clone()]).with_outliers_beyond(f64::INFINITY);
                    let found = grasp.identify(&asked)?;
                    let estimate = &found.estimates[0];
                    Ok(estimate
                        .standard_error
                        .filter(|_| found.by_differences == 0)
                        .map(|error| SCATTER * estimate.value / error))
                };
                compare(drawn.len(), &lost, &told, &mut count)?;
            }
            println!("{count:?}");
            assert!(count.exact * 2 > count.slips && count.compared * 4 > count.slips, "{count:?}");
            Ok(())
        }
    };
}

/// A finger at a random place of a gripper with two parallel jaws, its friction, and its squeeze.
fn of_a_gripper(k: usize, random: &mut Random) -> (planar::Contact, f64, f64) {
    let side = if k.is_multiple_of(2) { -1.0 } else { 1.0 };
    let contact = planar::Contact::new([0.03 * side, 0.04 * random.normal()], [-side, 0.0])
        .series_stiffness(1000.0 * (1.0 + random.uniform()), 500.0 * (1.0 + random.uniform()));
    (contact, 0.3 + 0.5 * random.uniform(), 2.0 + 8.0 * random.uniform())
}

/// A foot on a table.
fn foot(_: usize, random: &mut Random) -> (spatial::Contact, f64, f64) {
    let point = [0.1 * random.normal(), 0.1 * random.normal(), 0.0];
    let contact = spatial::Contact::new(point, [0.0, 0.0, 1.0])
        .series_stiffness(1e4 * (1.0 + random.uniform()), 5e3 * (1.0 + random.uniform()));
    (contact, 0.3 + 0.5 * random.uniform(), 2.0 + 8.0 * random.uniform())
}

derivatives!(of_grippers_in_the_plane, planar, of_a_gripper, |random: &mut Random| {
    let mut part = |size: f64| {
        planar::Wrench::new(
            [0.1 * size * random.normal(), size * random.normal()],
            0.03 * size * random.normal(),
        )
    };
    [part(0.2), part(1.0)]
});

derivatives!(of_pushed_blocks, spatial, foot, |random: &mut Random| {
    let weight =
        spatial::Wrench::force_at([0.0, 0.0, -15.0], [0.02 * random.normal(), 0.02 * random.normal(), 0.0]);
    let height = 0.02 * random.uniform();
    let push = [random.normal(), random.normal(), 0.0];
    [weight, spatial::Wrench::force_at(push, [0.1 * random.normal(), 0.1 * random.normal(), height])]
});
