//! Everyday piles of boxes on a table, with and without fingers, are all decided. Reported equilibria satisfy the contact law and balance, recomputed
//! from the data.

use support::piles::boxes;
use support::samples::{assert_met, samples, seeded};

#[test]
fn piles_of_boxes_are_decided() {
    let mut random = seeded(44);
    let (mut asked, mut held) = (0, 0);
    for (count, fingers, each) in
        [(2, false, 100), (2, true, 100), (4, false, 60), (4, true, 60), (8, false, 30)]
    {
        for number in 0..samples(each) {
            let Some(pile) = boxes(&mut random, count, fingers) else { continue };
            let verdict =
                pile.bodies.clone().grasp().expect("well posed").hold(pile.load).expect("well posed");
            let holds = verdict.holds().unwrap_or_else(|| panic!("{fingers} {number}: {verdict}"));
            if holds {
                let state = verdict.state.as_ref().expect("holds");
                let off = pile.violation(state);
                assert!(off < 1e-12, "{fingers} {number}: {off:e}");
            }
            held += usize::from(holds);
            asked += 1;
        }
    }
    assert_met(&[(asked, 315), (held, 110)]);
    assert!(held + samples(48) < asked, "{held} of {asked}");
}
