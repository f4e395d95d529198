//! The weakest direction of a force on a hand is right: in many other directions the force of first slip is not lower. At the first slip a contact
//! slides, or a drive reaches its limit.

use std::f64::consts::TAU;

use grasp_lcp::Limit;
use grasp_lcp::load_path::DepartingPart;
use grasp_lcp::planar::Contact;
use grasp_lcp::planar::hand::{Finger, Hand, Joint};
use grasp_lcp::planar::{Grasp, Ramp, Wrench};
use grasp_lcp::squeeze::WeakestDirection;

fn hand(limit: Option<Limit>) -> Grasp {
    let finger = |x: f64| {
        let joint = |p: [f64; 2]| {
            let joint = Joint::revolute(p).stiffness(30.0);
            if let Some(limit) = limit { joint.limit(limit) } else { joint }
        };
        let pad =
            Contact::new([x, 0.0], [-x, 0.1]).series_stiffness(2e3, 1.5e3).friction(0.6).pressed_with(3.0);
        Finger::new([joint([1.3 * x, -1.0]), joint([1.2 * x, 0.4])]).contact(pad)
    };
    Hand::new([finger(-1.0), finger(1.0)]).grasp().expect("well posed")
}

#[test]
fn no_direction_of_a_force_on_a_hand_is_weaker() {
    let mut drives = 0;
    let limits = [3.2, 3.5, 4.0, 50.0].map(|most| [Limit::Saturates(most), Limit::Slips(most)]);
    for limit in limits.into_iter().flatten().map(Some).chain([None]) {
        let grasp = hand(limit);
        for (base, point) in [([0.0, 0.0], [0.0, 0.0]), ([0.2, -0.3], [0.1, 0.3])] {
            let base = Wrench::force(base);
            let push = |angle: f64| Wrench::force_at([angle.cos(), angle.sin()], point);
            let onset = |angle: f64| grasp.onset(Ramp::load(base, push(angle))).expect("loads");
            let weakest = grasp.weakest_direction(base, point).expect("a load");
            let WeakestDirection::Force { size, direction: [x, y], leaver, .. } = weakest else {
                // At rest some drive is beyond its limit already, so that there is no weakest direction.
                assert!(onset(0.0).event().is_none(), "{limit:?} {weakest:?}");
                continue;
            };
            let there = onset(y.atan2(x));
            let event = there.event().expect("gives way");
            assert!((event.factor - size).abs() < 1e-12 * size, "{limit:?}: {} {size}", event.factor);
            match leaver {
                DepartingPart::Contact(i) => assert!(event.leaving.iter().any(|l| l.contact.index == i)),
                DepartingPart::Drive(part) => {
                    drives += 1;
                    assert!(event.drives.iter().any(|drive| drive.part.part == part), "{limit:?} {event:?}");
                }
                other => panic!("{other:?}"),
            }
            let sampled =
                (0..720).filter_map(|k| onset(TAU * f64::from(k) / 720.0).factor()).fold(f64::MAX, f64::min);
            assert!(sampled >= size * (1.0 - 1e-12) && sampled < 1.01 * size, "{sampled} {size}");
        }
    }
    println!("{drives} drives");
    assert!(drives > 4, "{drives}");
}
