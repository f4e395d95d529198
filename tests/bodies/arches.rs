//! A round arch has an equilibrium exactly if it is thick enough for a line of thrust to fit inside its stones.

use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::grasp::Wrench;
use support::piles::Arch;

/// With many stones the least thickness converges to Milankovitch's value, 0.1075 of the mean radius.
#[test]
fn the_least_thickness_is_the_one_known() {
    let least = Arch::least_thickness(400);
    assert!((least - 0.1075).abs() < 1e-4, "{least}");
}

#[test]
fn arches_stand_as_long_as_their_line_of_thrust_does() {
    for stones in [5, 8, 13] {
        let least = Arch::least_thickness(stones);
        for (part, stands) in [(1.0 - 1e-6, false), (1.0 + 1e-6, true)] {
            let arch = Arch { stones, thickness: part * least };
            let outcome = arch
                .voussoirs()
                .bodies(10.0)
                .grasp()
                .expect("well posed")
                .solve(Wrench::ZERO)
                .expect("well posed");
            let told = matches!(outcome, Outcome::Equilibrium(_));
            assert_eq!(told, stands, "{stones} {part}: {outcome}");
        }
    }
}
