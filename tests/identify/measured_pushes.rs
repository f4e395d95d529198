//! From the measured pushes of one log, identification finds the part of the block's known weight that each support carries.

use grasp_lcp::identify::{Identify, Slip, Unknown};
use grasp_lcp::spatial::Wrench;
use support::Failure;
use support::measured_pushes::{SURFACES, WEIGHT, blocks, normal_forces, pushes, supports};

/// A log with the true fractions .25 .5 .25 of the weight. The reference values .226 .511 .263 come from an independent prototype.
#[test]
fn loads_of_supports_of_one_log() -> Result<(), Failure> {
    let (blocks, pushes) = (blocks()?, pushes()?);
    let own = pushes.iter().filter(|push| push.layout == 3 && push.surface == SURFACES[0]);
    let slip = |push: &support::measured_pushes::Push| {
        Slip::gross(Wrench::new([push.load.x, push.load.y, 0.0], [0.0, 0.0, push.load.z]))
    };
    let carried = (0..3).map(|k| Unknown::carried().of_contacts([k]).starting_at(WEIGHT / 3.0));
    let unknowns = std::iter::once(Unknown::friction().starting_at(0.3)).chain(carried);
    let asked = Identify::new(unknowns, own.map(slip)).knowing(1..4, WEIGHT, 1e-3);
    let found = blocks[3].identify(&asked)?;
    println!("{found}");
    assert_eq!(found.by_differences, 0);
    for (estimate, truth) in found.estimates[1..].iter().zip(normal_forces(&supports(3))) {
        let error = estimate.standard_error.expect("fixed");
        assert!((estimate.value - truth).abs() < 3.0 * error && error < 0.1 * WEIGHT, "{truth}: {found}");
    }
    Ok(())
}
