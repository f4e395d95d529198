//! The first slip agrees with closed forms in all outcomes. Contacts never slide, slide from rest, or slide already; there is no equilibrium at
//! factor zero, or a free motion. Further cases are a contact that closes, changing commands, and several contacts that slide at once.

use grasp_lcp::planar::{Beyond, Contact, ContactState, Departure, Grasp, Onset, Ramp, Wrench};
use grasp_lcp::{Settings, spatial};
use support::jaws::{around, jaw};

fn onset(grasp: &Grasp, base: Wrench, direction: Wrench) -> Onset {
    grasp.onset(Ramp::load(base, direction)).expect("valid loads")
}

/// Two fingers at ±1 with commands `a` inwards press with N = k a each.
fn pinch(k: f64, kt: f64, mu: f64, a: f64) -> Grasp {
    Grasp::new([-1.0, 1.0].map(|x| jaw::<2>(x, [k, kt], mu).command([a, 0.0]))).unwrap()
}

/// A force w along the pinch line loads one finger and relieves the other until it opens at w = 2 N. With infinite friction nothing ever slides, but
/// the relieved finger still opens. With bonded contacts it does not open.
#[test]
fn never_and_opening() {
    let sideways = Wrench::force([1.0, 0.0]);
    let grasp = pinch(10.0, 5.0, 0.5, 0.1);
    let Onset::At(event) = onset(&grasp, Wrench::ZERO, sideways) else { panic!("opens") };
    // With the displacement q of the object: N_left = k (a - q), N_right = k (a + q) and 2 k q = w. So the left contact opens at w = 2 k a.
    assert!((event.factor - 2.0).abs() < 1e-14);
    assert_eq!(event.leaving[0].contact.index, 0);
    assert_eq!(event.leaving[0].how, Departure::Opens);
    let bonded = Grasp::new(grasp.contacts().iter().map(|c| c.clone().bonded())).unwrap();
    assert!(matches!(onset(&bonded, Wrench::ZERO, Wrench::new([3.0, -2.0], 1.0)), Onset::Never));
    let sticky = Grasp::new(grasp.contacts().iter().map(|c| c.clone().friction(f64::INFINITY))).unwrap();
    assert!(matches!(onset(&sticky, Wrench::ZERO, Wrench::force([0.0, -1.0])), Onset::Never));
    let Onset::At(event) = onset(&sticky, Wrench::ZERO, sideways) else { panic!("opens") };
    assert!((event.factor - 2.0).abs() < 1e-14);
    // A load that presses both contacts along their normals never exhausts friction, because tangential forces grow more slowly than μ times the
    // normal forces.
    let on_two_feet = Grasp::new(
        [-1.0, 1.0].map(|x| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(10.0, 5.0).friction(0.5)),
    )
    .unwrap();
    assert!(matches!(onset(&on_two_feet, Wrench::ZERO, Wrench::force([0.3, -1.0])), Onset::Never));
}

/// If all forces start from zero, a contact sticks under every size of the load if the rates of its forces satisfy |F_t'| <= μ F_n'.
#[test]
fn at_once_from_rest() {
    let on_two_feet = Grasp::new(
        [-1.0, 1.0].map(|x| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(10.0, 5.0).friction(0.5)),
    )
    .unwrap();
    let Onset::At(event) = onset(&on_two_feet, Wrench::ZERO, Wrench::force([0.6, -1.0])) else {
        panic!("0.6 > μ")
    };
    assert_eq!(event.factor, 0.0);
    assert_eq!(event.leaving.len(), 2);
    let beyond = on_two_feet.beyond(&event).expect("its own event");
    assert!(!matches!(beyond, Beyond::Continues(_)), "{beyond:?}");
}

#[test]
fn already_sliding_and_no_base() {
    // A spring along the incline carries the rest of the load, and the feet slide at the base load.
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(100.0, 50.0).friction(0.2);
    let stop = Contact::new([-2.0, 0.0], [1.0, 0.0]).series_stiffness(10.0, 10.0);
    let grasp = Grasp::new([foot(-1.0), foot(1.0), stop]).unwrap();
    let base = Wrench::force([-1.0, -1.0]);
    let Onset::AlreadySliding(state) = onset(&grasp, base, Wrench::force([0.0, -1.0])) else {
        panic!("slides")
    };
    assert!(matches!(state.contacts[0].state, ContactState::Sliding { .. }));
    assert!(matches!(onset(&grasp, Wrench::force([0.0, 1.0]), base), Onset::NoBase(_)));
}

/// A load that does work on a free motion is not held at any factor. The answer names this motion.
#[test]
fn gives_way() {
    let finger = |x: f64| jaw::<3>(x, [10.0, 5.0], 0.5).command([0.1, 0.0, 0.0]);
    let grasp = spatial::Grasp::new([finger(-1.0), finger(1.0)]).unwrap();
    let twist = spatial::Wrench::new([0.0, 0.0, -1.0], [0.3, 0.0, 0.0]);
    let outcome = grasp.onset(twist).unwrap();
    let spatial::Onset::GivesWay { factor, reason } = outcome else { panic!("{outcome:?}") };
    assert_eq!(factor, 0.0);
    assert!(matches!(reason.proof, spatial::Proof::FreeMotion { work, .. } if work > 0.0));
}

/// A block on two springs of stiffness k at ±1 sinks by w/2k. A third foot waits below its middle with the clearance c. It touches at w = 2 k c with
/// the tangential force F_t = 0, although a horizontal load b w has meanwhile pushed the block sideways by b w / 2 kt. From then on all three feet
/// share the load equally. With δ = (w - 2 k c)/3 the outer feet carry N = k c + δ and T = b k c + b δ, the middle foot N = δ and T = b δ. All ratios
/// T/N are b. So nothing slides while b < μ, and with b > μ the feet slide at once.
#[test]
fn a_contact_closes_on_the_way_without_tangential_force() {
    let (k, kt, mu, c) = (20.0, 9.0, 0.5, 0.03);
    let foot = |x: f64, gap: f64| {
        Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(k, kt).friction(mu).clearance(gap)
    };
    // With b < μ nothing ever slides.
    let grasp = Grasp::new([foot(-1.0, 0.0), foot(1.0, 0.0), foot(0.0, c)]).unwrap();
    assert!(matches!(onset(&grasp, Wrench::ZERO, Wrench::force([0.3, -1.0])), Onset::Never));
    // A base load of w₀ = 4 k c straight down closes the middle foot and presses it with δ₀ = (w₀ - 2 k c)/3 = 2 k c/3, without a tangential force.
    // From there on the load grows sideways.
    let base = Wrench::force([0.0, -4.0 * k * c]);
    let Onset::At(event) = onset(&grasp, base, Wrench::force([1.0, 0.0])) else { panic!("finite") };
    // Each foot carries τ/3 of the horizontal load τ. This load has no moment, so the normal force of the middle foot stays 2 k c/3, and the middle
    // foot slides first.
    let exact = 3.0 * mu * 2.0 * k * c / 3.0;
    assert!((event.factor - exact).abs() < 1e-14 * exact, "{} {exact}", event.factor);
    assert_eq!(event.leaving.iter().map(|l| l.contact.index).collect::<Vec<_>>(), [2]);
    let beyond = grasp.beyond(&event).expect("its own event");
    assert!(matches!(&beyond, Beyond::Continues(next) if next.states[0] == ContactState::Sticking));
}

/// The same three feet. The base load has the sideways part h and the weight w₀, which leaves the middle foot open. Then a load τ (b, -1) with b > μ
/// is added. The outer feet would slide at h + b τ = μ (w₀ + τ). Before that, at w₀ + τ = 2 k c, the middle foot closes, and slides at once because
/// its tangential force grows b times as fast as its normal force. It touches with T = 0. A contact that had stuck from the beginning would have T =
/// kt (h + b τ)/2kt.
#[test]
fn a_contact_that_slides_the_moment_it_closes() {
    let (k, kt, mu, c, h, b, w0) = (20.0, 9.0, 0.5, 0.03, 0.4, 0.6, 1.0);
    let foot = |x: f64, gap: f64| {
        Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(k, kt).friction(mu).clearance(gap)
    };
    let grasp = Grasp::new([foot(-1.0, 0.0), foot(1.0, 0.0), foot(0.0, c)]).unwrap();
    let closing = 2.0 * k * c - w0;
    assert!(closing > 0.0 && closing < (mu * w0 - h) / (b - mu));
    let Onset::At(event) = onset(&grasp, Wrench::force([h, -w0]), Wrench::force([b, -1.0])) else {
        panic!("finite")
    };
    assert!((event.factor - closing).abs() < 1e-14, "{} {closing}", event.factor);
    assert_eq!(event.leaving.iter().map(|l| l.contact.index).collect::<Vec<_>>(), [2]);
    let state = grasp.state_at_onset(&event).expect("its own event");
    assert_eq!(state.contacts[2].state, ContactState::Separated);
    assert!(state.contacts[2].gap < 1e-15);
}

/// The squeeze of a loaded pinch is released. With N = k (a - τ) and T = w/2 it slides at τ = a - w/(2 μ k). If the load grows at the same time, T =
/// w (1 + τ)/2, and it slides at τ = (μ k a - w/2) / (w/2 + μ k).
#[test]
fn along_commands_and_both_at_once() {
    let (k, kt, mu, a, w) = (30.0, 11.0, 0.4, 0.05, 0.6);
    let grasp = pinch(k, kt, mu, a);
    let load = Wrench::force([0.0, -w]);
    let release = [[-1.0, 0.0]; 2];
    let settings = Settings::default();
    let alone = grasp.with(&settings).onset(Ramp::commands(load, release)).unwrap();
    assert!((alone.factor().unwrap() - (a - w / (2.0 * mu * k))).abs() < 1e-15);
    let both = grasp.with(&settings).onset(Ramp::load(load, load).with_commands(release)).unwrap();
    assert!((both.factor().unwrap() - (mu * k * a - w / 2.0) / (w / 2.0 + mu * k)).abs() < 1e-15);
    // The state at the first slip is the equilibrium with the commands that act there.
    let event = both.event().unwrap();
    let state = grasp.state_at_onset(event).expect("its own event");
    assert!(state.residuals.worst() < 1e-15);
    let there = event.factor;
    let moved = grasp.clone().with_commands([[a - there, 0.0]; 2]).unwrap();
    let again = moved.solve(event.load).unwrap();
    let again = again.equilibrium().expect("on the edge");
    for (x, y) in again.contacts.iter().zip(&state.contacts) {
        assert!((x.force - y.force).norm() < 1e-14);
        assert!((x.body_core - y.body_core).norm() < 1e-15);
        assert!((x.finger_surface.is_none()) && y.finger_surface.is_none());
    }
}

/// Identical contacts of a ring under a torque about its axis slide together, at one factor.
#[test]
fn rings_leave_together() {
    for n in [2, 3, 5, 8, 17, 64] {
        let finger = |i: usize| around::<2>(i, n, 1.0, [10.0, 4.0], 0.3).command([0.1, 0.0]);
        let ring = Grasp::new((0..n).map(finger)).unwrap();
        let Onset::At(event) = onset(&ring, Wrench::ZERO, Wrench::new([0.0, 0.0], 1.0)) else {
            panic!("finite")
        };
        let exact = n as f64 * 0.3;
        assert!((event.factor - exact).abs() < 1e-13 * exact, "{n}: {}", event.factor);
        assert_eq!(event.leaving.len(), n);
        let beyond = ring.beyond(&event).expect("its own event");
        assert!(!matches!(beyond, Beyond::Continues(_)), "{beyond:?}");
    }
}
