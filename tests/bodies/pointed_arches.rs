//! Pointed arches stand as long as a line of thrust fits inside the stones and friction can carry it. The friction that a round arch needs is the
//! published value.

use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::grasp::Wrench;
use support::piles::Arch;
use support::pointed_arch::PointedArch;

fn stands(arch: &PointedArch, friction: f64) -> bool {
    let outcome = arch
        .voussoirs()
        .bodies(friction)
        .grasp()
        .expect("well posed")
        .solve(Wrench::ZERO)
        .expect("well posed");
    assert!(!matches!(outcome, Outcome::Undecided(_)), "{arch:?}, {friction}: {outcome}");
    matches!(outcome, Outcome::Equilibrium(_))
}

/// A pointed arch of zero eccentricity has the stones of a round arch.
#[test]
fn without_a_point_it_is_round() {
    for stones in [2, 4, 50] {
        let round = PointedArch { stones, thickness: 0.1, eccentricity: 0.0 }.least_thickness();
        let known = Arch::least_thickness(2 * stones);
        assert!((round - known).abs() < 1e-9, "{stones}: {round}, {known}");
    }
}

/// In a semicircle of many thin stones under its own weight, the thrust is inclined to the normal of the joint at the angle φ from the crown by
/// `|atan(φ/h) - φ|`. The best horizontal thrust h makes the maximum, near the haunch and at the foot, atan 0.309215 (G. Cocchetti and E. Rizzi).
#[test]
fn a_round_arch_needs_the_friction_that_is_published() {
    let leans = |h: f64| {
        let at = |k: u32| {
            let phi = f64::from(k) * std::f64::consts::FRAC_PI_2 / 2e4;
            ((phi / h).atan() - phi).abs()
        };
        (0..=20_000).map(at).fold(0.0, f64::max)
    };
    let best = (0..4000).map(|k| leans(0.3 + 1e-4 * f64::from(k))).fold(f64::INFINITY, f64::min).tan();
    assert!((best - 0.309_215).abs() < 2e-5, "{best}");
    let many = PointedArch { stones: 300, thickness: 0.4, eccentricity: 0.0 }.least_friction();
    assert!((many - 0.309_215).abs() < 2e-3, "{many}");
}

/// Pointed arches stand exactly if they are thick enough for a line of thrust inside their stones.
#[test]
fn pointed_arches_stand_as_long_as_their_line_of_thrust_does() {
    for (stones, eccentricity) in [(3, 0.1), (4, 0.25), (5, 0.4), (6, 0.5)] {
        let mut arch = PointedArch { stones, thickness: 0.0, eccentricity };
        let least = arch.least_thickness();
        for (part, expected) in [(1.0 - 1e-6, false), (1.0 + 1e-6, true)] {
            arch.thickness = part * least;
            assert_eq!(stands(&arch, 10.0), expected, "{arch:?} {part} {least}");
        }
    }
}

/// Thick arches fail by sliding. They stand if and only if friction can carry some line of thrust.
#[test]
fn thick_arches_stand_as_long_as_friction_does() {
    for (stones, eccentricity) in [(3, 0.0), (4, 0.0), (4, 0.2), (5, 0.4)] {
        let arch = PointedArch { stones, thickness: 0.5, eccentricity };
        let least = arch.least_friction();
        assert_eq!(
            [stands(&arch, least * (1.0 - 1e-6)), stands(&arch, least * (1.0 + 1e-6))],
            [false, true],
            "{arch:?}: {least}"
        );
    }
}
