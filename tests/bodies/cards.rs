//! A house of cards stands if and only if contact forces inside all friction cones can balance the weights. With less friction there is a proof that
//! it falls.

use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::need::Need;
use grasp_lcp::planar::Wrench;
use support::cards::HouseOfCards;

/// Rows, cards, and the least friction by a linear program of another solver (HiGHS: balance of each card, `|F_t| <= μ F_n`, μ halved to 1e-12).
const LEAST: [(usize, usize, f64); 4] =
    [(2, 7, 0.332_787), (4, 26, 0.399_078), (6, 57, 0.420_884), (8, 100, 0.432_130)];

/// The verdict changes from falling to standing within 1 % of the least friction that the linear program finds.
#[test]
fn they_stand_as_a_linear_program_says() {
    for (rows, cards, least) in LEAST {
        let house = HouseOfCards::of(rows);
        assert_eq!(house.cards(), cards);
        for (part, stands) in [(0.99, false), (1.01, true)] {
            let grasp = house.bodies(part * least).grasp().expect("well posed");
            let outcome = grasp.solve(Wrench::ZERO).expect("well posed");
            let told = match &outcome {
                Outcome::Equilibrium(_) => Some(true),
                Outcome::NoEquilibrium(_) => Some(false),
                _ => None,
            };
            assert_eq!(told, Some(stands), "{rows} {part} {least}");
        }
    }
}

/// The needed friction agrees with the linear program. The house also stands at very large coefficients, which the search may try.
#[test]
fn a_house_of_two_rows_needs_as_much_friction_as_a_linear_program_says() {
    let (rows, _, least) = LEAST[0];
    let grasp = HouseOfCards::of(rows).bodies(0.5).grasp().expect("well posed");
    let needed = grasp.need(&Need::friction(Wrench::ZERO).if_lower_by(0.0, 0.0)).expect("well posed");
    let does = needed.amount.bound().unwrap_or(f64::NAN);
    assert!((does / least - 1.0).abs() < 1e-3, "{does} {least} {needed}");
}
