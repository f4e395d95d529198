//! The screw of a vice is in line with its jaws, so that nothing presses the part on the rests below it, whatever their stiffness. The rests touch,
//! rub, and carry no force.
//!
//! Both jaws press with the force of the screw. The part moves by this force over the stiffness of a jaw, the moving jaw by twice as much.

use grasp_lcp::spatial::{Bodies, Body, Contact, Grasp, Link, SoftFingertip, Wrench};

const SCREW: f64 = 8000.0;

/// A vice that presses a part above rests. `strips` are the numbers of strips of its pads, `jaws` and `guide` stiffnesses, N/m. The guide of the
/// moving jaw is `below` metres below the screw.
fn vice(strips: [usize; 2], jaws: f64, guide: f64, below: f64) -> Grasp {
    let pad = SoftFingertip::rectangle([0.1, 0.04], strips).expect("a rectangle");
    let jaw = |name: &str, side: f64| {
        let at = Contact::new([0.0, 0.03 * side, 0.02], [0.0, -side, 0.0]).tangent([1.0, 0.0, 0.0]);
        at.series_stiffness(jaws, jaws).friction(0.2).on("part").name(name)
    };
    let rest = |x: f64, y: f64| {
        let at = Contact::new([x, y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(1e8, 1e8).friction(0.15);
        at.on("part").name(format!("rest {x} {y}"))
    };
    let mut contacts = pad.contacts(&jaw("fixed jaw", 1.0)).expect("a pad");
    contacts.extend(pad.contacts(&jaw("moving jaw", -1.0).against("jaw")).expect("a pad"));
    contacts
        .extend([(-0.05, -0.025), (0.05, -0.025), (0.05, 0.025), (-0.05, 0.025)].map(|(x, y)| rest(x, y)));
    let screw = Wrench::force_at([0.0, SCREW, 0.0], [0.0, -0.04, 0.02]);
    let slide = Link::slide([0.0, -0.06, 0.02 - below], [0.0, 1.0, 0.0], 0.08).stiffness(guide);
    Bodies::new([Body::new("part"), Body::new("jaw").load(screw)])
        .contacts(contacts)
        .links([slide.name("guide").to_ground("jaw")])
        .grasp()
        .expect("well posed")
}

#[test]
fn they_carry_nothing_and_everything_else_sticks() {
    // These vices were once reported as lost at rest, because a contact with a force of rounding alone was taken to stick.
    let vices = [
        ([1, 1], 33_048_540.706_334_896, 2_482_364_398.787_123, 0.03),
        ([2, 1], 15_903_690.548_656_778, 260_532_030.190_372_7, 0.02),
        ([1, 2], 267_087_992.569_351_9, 80_960_470.069_954_8, 0.01),
        ([3, 2], 53_401_313.806_613_88, 753_076_591.224_295_3, 0.01),
    ];
    for (strips, jaws, guide, below) in vices {
        let vice = vice(strips, jaws, guide, below);
        let outcome = vice.solve(Wrench::ZERO).expect("well posed");
        let state = outcome.equilibrium().unwrap_or_else(|| panic!("{outcome}"));
        for whole in state.whole_contacts() {
            let force = whole.force();
            let presses = if whole.text().contains("jaw") { SCREW } else { 0.0 };
            if whole.text() != "guide" {
                assert!((force[0] - presses).abs() <= 1e-12 * SCREW, "{} {force}", whole.text());
                assert!(force[1].hypot(force[2]) <= 1e-12 * SCREW, "{} {force}", whole.text());
            }
        }
        let verdict = vice.hold(Wrench::new([0.0, 0.0, -1.0], [0.0; 3])).expect("well posed");
        assert_eq!(verdict.holds(), Some(true), "{verdict}");
    }
}
