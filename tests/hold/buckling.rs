//! A verdict warns before the forces that small motions leave out buckle what they hold.

use grasp_lcp::hold::Verdict;
use grasp_lcp::planar::{Bodies, Body, Contact, Link, Wrench};

const LENGTH: f64 = 0.1;
const SIDEWAYS: f64 = 1e3;
/// Stiffness of the links and the guide, N/m. The error of the closed form falls as one over it, to 3e-6 here; beyond, rounding prevails.
const STIFF: f64 = 1e10;

/// Two links of [`LENGTH`] in line, which a ram pushes with this force, N. Two springs without preload hold the knee sideways.
fn pushed(force: f64) -> Verdict<2> {
    let beside = |name: &str, side: f64| {
        let finger = Contact::new([LENGTH, 0.01 * side], [0.0, -side]).series_stiffness(SIDEWAYS, SIDEWAYS);
        finger.friction(0.0).pressed_with(1e-6).on("first").name(name)
    };
    let grasp = Bodies::new([Body::new("first"), Body::new("second"), Body::new("ram")])
        .contacts([beside("above", 1.0), beside("below", -1.0)])
        .links([
            Link::hinge([0.0, 0.0]).stiffness(STIFF).to_ground("first"),
            Link::hinge([LENGTH, 0.0]).stiffness(STIFF).between("first", "second"),
            Link::hinge([2.0 * LENGTH, 0.0]).stiffness(STIFF).between("second", "ram"),
            Link::slide([0.22, 0.0], [1.0, 0.0], 0.03).stiffness(STIFF).to_ground("ram"),
        ])
        .loaded("ram")
        .grasp()
        .unwrap();
    grasp.hold(Wrench::force_at([-force, 0.0], [2.0 * LENGTH, 0.0])).unwrap()
}

/// The linear model holds any force, so the verdict must warn. The knee turns both links by w/L. The springs resist with 2k w, the compressed links take 2P w/L: they buckle at `P = k L`.
#[test]
fn compressed_links_in_line_are_warned_about() {
    let critical = SIDEWAYS * LENGTH;
    assert_eq!(pushed(0.45 * critical).left_out, None);
    for part in [0.55, 0.9, 1.1, 5.0] {
        let verdict = pushed(part * critical);
        let taken = -verdict.left_out.unwrap();
        assert!((taken - part).abs() < 1e-5 * part, "{taken} {part}");
        assert_eq!(verdict.to_string().contains("so that nothing stays"), part > 1.0, "{verdict}");
    }
    assert_eq!(pushed(5.0 * critical).holds(), Some(true));
}
