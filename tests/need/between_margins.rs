//! Between two sufficient amounts others fail where a margin would vanish if it fell on as it does: the answer ends before them. `hold` puts on
//! amounts around each answer.

use support::amounts::{self, Checked, checked};
use support::samples::seeded;

type Tested = Result<(), grasp_lcp::Error>;

fn is_met(number: u64, found: &Checked) {
    assert!(found.wrong.is_empty(), "{number}: {} wrong: {}", found.wrong.len(), found.wrong[0]);
}

/// With 0.69 to 0.78 of the load at rest the load that follows is lost. Both 0.19 and 0.78 of it suffice.
#[test]
fn a_part_of_the_load_at_rest() -> Tested {
    let mut random = seeded(161);
    let scene = amounts::planar(&mut random)?;
    is_met(161, &checked(&scene, amounts::at_rest(), 200, &mut random)?);
    Ok(())
}

/// Forces of 7.6 to 8.1 times the one given move a contact too far. Both 7.4 and 8.5 times it suffice.
#[test]
fn a_force_in_space() -> Tested {
    let mut random = seeded(169);
    let scene = amounts::spatial(&mut random)?;
    is_met(169, &checked(&scene, amounts::force(), 200, &mut random)?);
    Ok(())
}

/// From 3.493 times the load at rest on, several equilibria at rest exist, and rounding determines which one is found: some of these amounts
/// hold, others fail.
#[test]
fn equilibria_that_rounding_tells_apart() -> Tested {
    let mut random = seeded(31);
    let scene = amounts::spatial(&mut random)?;
    is_met(31, &checked(&scene, amounts::at_rest(), 200, &mut random)?);
    Ok(())
}
