//! Houses of cards stand from the least friction on with which forces inside all cones balance the weights, and below it there is a proof.

use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::planar::Wrench;
use support::cards::HouseOfCards;

/// Rows, cards, and the least friction by a linear program of another solver (HiGHS: balance of each card, `|F_t| <= μ F_n`, μ halved to 1e-12).
const LEAST: [(usize, usize, f64); 4] =
    [(2, 7, 0.332_787), (4, 26, 0.399_078), (6, 57, 0.420_884), (8, 100, 0.432_130)];

/// A hundredth below and above that.
#[test]
fn they_stand_as_a_linear_program_says() {
    for (rows, cards, least) in LEAST {
        let house = HouseOfCards::of(rows);
        assert_eq!(house.cards(), cards);
        for (part, stands) in [(0.99, false), (1.01, true)] {
            let grasp = house.bodies(part * least).grasp().expect("well posed");
            let outcome = grasp.solve(&Wrench::ZERO).expect("well posed");
            let told = match &outcome {
                Outcome::Equilibrium(_) => Some(true),
                Outcome::NoEquilibrium(_) => Some(false),
                _ => None,
            };
            assert_eq!(told, Some(stands), "{rows} rows, {part} of {least}");
        }
    }
}
