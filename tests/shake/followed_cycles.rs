//! Verdicts on loads that repeat for ever agree with thirty cycles that are followed one after the other.

use grasp_lcp::Error;
use grasp_lcp::shake::Repeats;
use support::samples::{samples, seeded};
use support::shaken::{
    Cycle, fault, in_space, in_the_plane, rocked_in_space, rocked_in_the_plane, weaker_once_it_slides,
};
use support::splitmix::Random;

/// Number of cycles that are followed.
const CYCLES: usize = 30;
/// One in this number of verdicts may be undecided.
const FEW: usize = 1000;
/// With kinetic friction, one in this number of verdicts may be undecided. Such cycles may begin to repeat only after more cycles than are followed.
const FEW_THAT_JUMP: usize = 100;

/// Checks that every verdict agrees with the followed cycles, and that all but a few are decided.
fn judge<const C: usize>(
    (many, few): (usize, usize),
    error: f64,
    mut draw: impl FnMut(&mut Random) -> Result<Cycle<C>, Error>,
) -> Result<(), Error> {
    let (many, mut random) = (samples(many), seeded(45));
    let mut counts = [0; 7];
    let (mut wrong, mut followed) = (Vec::new(), Vec::new());
    for k in 0..many {
        let cycle = draw(&mut random)?;
        let shaken = cycle.grasp.shake(cycle.base, &cycle.legs)?;
        counts[match &shaken.repeats {
            Repeats::Rests { .. } => 0,
            Repeats::DiesOut { .. } => 1,
            Repeats::Alternates { .. } => 2,
            Repeats::Walks { .. } => 3,
            Repeats::Lost { .. } => 4,
            Repeats::NoRest { .. } => 5,
            _ => 6,
        }] += 1;
        followed.push(shaken.followed);
        if let Some(fault) = fault(&cycle, &shaken, CYCLES, error)? {
            let (ratio, cycles, gone) = (shaken.ratio, shaken.cycles, shaken.followed);
            wrong.push(format!(
                "case {k}: {shaken}, and {fault} (ratio {ratio}, cycle {cycles}, {gone} followed)"
            ));
        }
        if matches!(shaken.repeats, Repeats::Undecided { .. }) {
            println!("case {k}: {shaken}");
        }
    }
    followed.sort_unstable();
    println!(
        "rests, dies out, alternates, walks, lost, no rest, undecided: {counts:?}; cycles followed: {} in the median, {} at most",
        followed[many / 2],
        followed[many - 1]
    );
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(counts[6] * few <= many, "{} of {many} undecided", counts[6]);
    Ok(())
}

#[test]
fn in_the_plane_every_verdict_is_what_cycles_show() -> Result<(), Error> {
    judge((20, FEW), 1e-6, in_the_plane)
}

#[test]
fn on_the_round_cone_every_verdict_is_what_cycles_show() -> Result<(), Error> {
    judge((4, FEW), 1e-5, in_space)
}

#[test]
fn what_is_rocked_in_the_plane_walks_as_cycles_show() -> Result<(), Error> {
    judge((13, FEW), 1e-6, rocked_in_the_plane)
}

#[test]
fn what_is_rocked_in_space_walks_as_cycles_show() -> Result<(), Error> {
    judge((4, FEW), 1e-5, rocked_in_space)
}

#[test]
fn what_jumps_in_the_plane_does_as_cycles_show() -> Result<(), Error> {
    judge((13, FEW_THAT_JUMP), 1e-6, |random| weaker_once_it_slides(in_the_plane(random)?, random))?;
    judge((13, FEW_THAT_JUMP), 1e-6, |random| weaker_once_it_slides(rocked_in_the_plane(random)?, random))
}

#[test]
fn what_jumps_in_space_does_as_cycles_show() -> Result<(), Error> {
    judge((4, FEW_THAT_JUMP), 1e-5, |random| weaker_once_it_slides(in_space(random)?, random))?;
    judge((4, FEW_THAT_JUMP), 1e-5, |random| weaker_once_it_slides(rocked_in_space(random)?, random))
}
