//! Load paths of a pad of many springs follow the law of Cattaneo and Mindlin for partial slip under a fixed normal load.
//!
//! Every number is independent of the crate. The discrete pad is a sum of elastic–plastic springs in closed form (first loading curve, and Masing's
//! rule for unloading). The continuum law is an integral by hand, with a proven bound on the difference of N springs from it.
//!
//! The pad: N contacts at one height y = 0 under a rigid block, ξ_i = (2i + 1 - N)/N, commanded to press with N_i = k a_i = (2/N) p₀ (1 - ξ_i²), a
//! parabola of half width 1. All friction acts along y = 0, so a shear load Q along y = 0 neither tilts nor lifts the block. The pressures stay, and
//! F_i = -kt x until kt x = μ N_i. With c = 2/N kt' per contact
//!
//! ```text
//! Q_N(x) = Σ_i min(c x, μ N_i)                                         exact for the pad
//! Q(x) = ∫ min(kt' x, μ p) dξ = μP (1 - (1 - x/x*)^{3/2})              x* = μ p₀ / kt',  P = 4/3 p₀
//! ```
//!
//! the second being Mindlin's law of two spheres, with its stick zone (1 - Q/μP)^{1/3} (Mindlin 1949).
//!
//! Midpoint rule: f = min(kt' x, μ p) has ∫|f''| <= 4 μp₀ and two kinks of at most 2 μp₀. Each kink costs at most h²/8 times its jump, the rest h²/24
//! ∫|f''|. With h = 2/N: |Q_N - Q| <= h² μp₀ (1/6 + 1/2) = 2 μP / N².

use grasp_lcp::planar::{Change, Contact, Event, Grasp, Leg, LoadPath, PathEnd, Wrench};
use support::assert_close;
use support::ends::limit_load;
use support::programs::changes;

const MU: f64 = 0.4;
const P0: f64 = 3.0;
const KT: f64 = 50.0;
/// Displacement at which the last spring would slide.
const X_STAR: f64 = MU * P0 / KT;

fn real(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap())
}

struct Pad {
    grasp: Grasp,
    /// Friction limits μ N_i, in the order of the contacts.
    limits: Vec<f64>,
    /// Tangential stiffness of each spring.
    c: f64,
}

impl Pad {
    fn new(n: usize) -> Self {
        let (k, c) = (70.0, 2.0 / real(n) * KT);
        let at = |i: usize| real(2 * i + 1) / real(n) - 1.0;
        let press = |i: usize| 2.0 / real(n) * P0 * (1.0 - at(i) * at(i));
        let foot = |i: usize| {
            Contact::new([at(i), 0.0], [0.0, 1.0])
                .series_stiffness(k, c)
                .friction(MU)
                .command([press(i) / k, 0.0])
        };
        let limits = (0..n).map(|i| MU * press(i)).collect();
        Self { grasp: Grasp::new((0..n).map(foot)).unwrap(), limits, c }
    }

    fn normal_load(&self) -> f64 {
        self.limits.iter().sum::<f64>() / MU
    }

    fn load(&self, q: f64) -> Wrench {
        Wrench::force([q, -self.normal_load()])
    }

    /// Shear force Q_N(x) on first loading.
    fn virgin(&self, x: f64) -> f64 {
        self.limits.iter().map(|limit| (self.c * x).min(*limit)).sum()
    }

    fn follow(&self, shears: &[f64]) -> (LoadPath<'_>, Vec<Event>) {
        let legs: Vec<_> = shears.iter().map(|&q| Leg::load_to(self.load(q))).collect();
        let mut path = self.grasp.follow(self.load(0.0), &legs).unwrap();
        let events = path.run();
        (path, events)
    }

    /// Energy that friction dissipates in one full cycle between -x and x: 4 μN (x - μN/c) for each sliding spring.
    fn loop_area(&self, x: f64) -> f64 {
        self.limits.iter().map(|f| 4.0 * f * (x - f / self.c).max(0.0)).sum()
    }
}

fn x_of(event: &Event) -> f64 {
    event.state.twist.translation()[0]
}

/// The contacts of an event; checks that all have the same change.
fn who(event: &Event, what: fn(&Change) -> bool) -> Vec<usize> {
    assert!(changes(event).iter().all(|(_, change)| what(change)), "{:?}", changes(event));
    let mut contacts: Vec<_> = changes(event).iter().map(|(i, _)| *i).collect();
    contacts.sort_unstable();
    contacts
}

fn slides_back(change: &Change) -> bool {
    matches!(change, Change::Slides { direction } if direction[0] < 0.0)
}

fn slides_on(change: &Change) -> bool {
    matches!(change, Change::Slides { direction } if direction[0] > 0.0)
}

fn sticks(change: &Change) -> bool {
    *change == Change::Sticks
}

/// The pad is sheared until it gives way. The pairs of springs i and N-1-i slide from the rim inwards, each pair at once, at x = μN_i / c and the
/// load Q_N(x). The last pair slides at the limit load μP. Between, the load–displacement curve is Q_N, and within 2 μP/N² of Mindlin's.
#[test]
fn the_pad_slips_from_the_rim_inwards() {
    for n in [2_usize, 8, 33, 200] {
        let pad = Pad::new(n);
        let most = MU * pad.normal_load();
        let (path, events) = pad.follow(&[1.25 * most]);
        let pairs = n.div_ceil(2);
        assert_eq!(events.len(), pairs - 1, "{n}");
        for (i, event) in events.iter().enumerate() {
            let x = pad.limits[i] / pad.c;
            assert_eq!(who(event, slides_back), [i, n - 1 - i]);
            assert_close!(x_of(event), x);
            assert_close!(event.load.to_vector()[0], pad.virgin(x));
            assert_close!(event.fraction, pad.virgin(x) / (1.25 * most));
            // The continuation is unique. With more than 64 contacts on an edge the library does not check this.
            assert!(event.other_continuations == Some(0) || (i > 31 && event.other_continuations.is_none()));
            for (answer, limit) in event.state.contacts.iter().zip(&pad.limits) {
                assert_close!(answer.normal_force(), limit / MU);
                assert_close!(answer.force_world[0], -(pad.c * x).min(*limit));
            }
        }
        let loss = limit_load(&path);
        assert_close!(loss.fraction, 0.8);
        assert_eq!(loss.contacts.len(), n);
        // Mindlin's curve of the continuum, at the events and between them.
        let full = MU * P0 * 4.0 / 3.0;
        let within = 2.0 * full / (real(n) * real(n));
        for step in 1..40 {
            let fraction = 0.8 * f64::from(step) / 40.0;
            let state = path.state_at(0, fraction).unwrap();
            let (x, q) = (state.twist.translation()[0], state.load.to_vector()[0]);
            assert_close!(pad.virgin(x), q);
            let mindlin = full * (1.0 - (1.0 - (x / X_STAR).min(1.0)).powf(1.5));
            assert!((q - mindlin).abs() <= within, "N = {n}, x = {x}: {q} against {mindlin} ± {within}");
            // The zone of sticking springs reaches to (1 - Q/μP)^{1/3}, up to half the distance of springs and the error of the load.
            let stuck = state.contacts.iter().filter(|c| c.margin > 1e-9).count();
            let zone = (1.0 - x / X_STAR).max(0.0).sqrt();
            assert!((real(stuck) / real(n) - zone).abs() <= 1.0 / real(n) + 1e-12, "{stuck} of {n}, {zone}");
            let cube_root = (1.0 - mindlin / full).cbrt();
            assert!((cube_root - zone).abs() < 1e-12, "Mindlin's own");
        }
    }
}

/// Shear to Q₁, back to -Q₁, and again (Mindlin and Deresiewicz). Everything sticks at a turning point. From there on each spring slides at twice its
/// friction limit (Masing). During unloading Q = Q₁ - 2 Q_N((x₁ - x)/2), and the pairs that had slid slide back from x₁ - 2 μN_i/c on. The loop
/// closes exactly. Friction dissipates Σ 4 μN_i (x₁ - μN_i/c) per cycle.
#[test]
fn reversed_loading_follows_masing_and_the_loop_closes() {
    let n = 40;
    let pad = Pad::new(n);
    // Half of the pairs slide: c x₁ lies between the friction limits of the ninth and the tenth pair.
    let slid = 9;
    let x1 = 0.5 * (pad.limits[slid - 1] + pad.limits[slid]) / pad.c;
    let q1 = pad.virgin(x1);
    let (path, events) = pad.follow(&[q1, -q1, q1, -q1]);
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    let rim: Vec<usize> = (0..slid).chain(n - slid..n).collect();
    assert_eq!(events.len(), slid + 3 * (1 + slid));
    for leg in 1..4 {
        let sign = if leg % 2 == 1 { 1.0 } else { -1.0 };
        let of_leg: Vec<_> = events.iter().filter(|e| e.leg == leg).collect();
        assert_eq!(who(of_leg[0], sticks), rim);
        assert_eq!(of_leg[0].fraction, 0.0);
        assert_close!(x_of(of_leg[0]), sign * x1);
        for (i, event) in of_leg[1..].iter().enumerate() {
            let way = if leg % 2 == 1 { slides_on } else { slides_back };
            assert_eq!(who(event, way), [i, n - 1 - i]);
            assert_close!(x_of(event), sign * (x1 - 2.0 * pad.limits[i] / pad.c));
            assert_close!(event.load.to_vector()[0], sign * (q1 - 2.0 * pad.virgin(pad.limits[i] / pad.c)));
        }
        for step in 1..=20 {
            let state = path.state_at(leg, f64::from(step) / 20.0).unwrap();
            let x = sign * state.twist.translation()[0];
            assert_close!(sign * state.load.to_vector()[0], q1 - 2.0 * pad.virgin((x1 - x) / 2.0));
        }
        let end = path.state_at(leg, 1.0).unwrap();
        assert_close!(end.twist.translation()[0], -sign * x1);
    }
    let cycle: f64 = path.energies()[1..3].iter().map(|e| e.dissipated).sum();
    assert_close!(cycle, pad.loop_area(x1));
    let work: f64 = path.energies()[1..3].iter().map(|e| e.load_work).sum();
    assert_close!(work, pad.loop_area(x1));
    assert!(path.energies().iter().all(|e| e.residual().abs() < 1e-13));
    // The area of the loop for the continuum is 8 ∫Q dx - 4 x₁Q(x₁) with Mindlin's law. The springs have the same area within the error of their
    // number.
    let (full, rest) = (MU * P0 * 4.0 / 3.0, 1.0 - x1 / X_STAR);
    let integral = full * (x1 - 0.4 * X_STAR * (1.0 - rest.powf(2.5)));
    let area = 8.0 * integral - 4.0 * x1 * full * (1.0 - rest.powf(1.5));
    let within = 12.0 * x1 * 2.0 * full / (real(n) * real(n));
    assert!((cycle - area).abs() <= within, "{cycle} {area} {within}");
    assert!(within < 0.2 * area);
}

/// A smaller loop inside: the shear goes to Q₁, back to Q₂ > -Q₁, and on to Q₃ > Q₁. During unloading only the outer pairs with μN_i < c (x₁ - x₂)/2
/// slide. During reloading the same pairs slide at x₂ + 2 μN_i/c. At x₁, every other pair that had slid before is on its edge again, and all these
/// pairs slide in one event. Beyond x₁ the path is that of the first loading, without a memory of the loop.
#[test]
fn a_loop_inside_is_forgotten_where_it_was_left() {
    let n = 40;
    let pad = Pad::new(n);
    let [inner, outer, last] = [4_usize, 12, 16];
    let between = |i: usize| 0.5 * (pad.limits[i - 1] + pad.limits[i]) / pad.c;
    let (x1, x3) = (between(outer), between(last));
    let x2 = x1 - 2.0 * between(inner);
    let (q1, q3) = (pad.virgin(x1), pad.virgin(x3));
    let q2 = q1 - 2.0 * pad.virgin((x1 - x2) / 2.0);
    let (path, events) = pad.follow(&[q1, q2, q3]);
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    let legs: Vec<usize> = (0..3).map(|leg| events.iter().filter(|e| e.leg == leg).count()).collect();
    assert_eq!(legs, [outer, 1 + inner, 1 + inner + 1 + (last - outer)]);
    let back: Vec<_> = events.iter().filter(|e| e.leg == 2).collect();
    let both = |from: usize, to: usize| (from..to).chain(n - to..n - from).collect::<Vec<_>>();
    assert_eq!(who(back[0], sticks), both(0, inner));
    for i in 0..inner {
        assert_eq!(who(back[1 + i], slides_back), [i, n - 1 - i]);
        assert_close!(x_of(back[1 + i]), x2 + 2.0 * pad.limits[i] / pad.c);
        assert_close!(back[1 + i].load.to_vector()[0], q2 + 2.0 * pad.virgin(pad.limits[i] / pad.c));
    }
    let again = back[1 + inner];
    assert_eq!(who(again, slides_back), both(inner, outer));
    assert_close!(x_of(again), x1);
    assert_close!(again.load.to_vector()[0], q1);
    for (i, event) in (outer..last).zip(&back[2 + inner..]) {
        assert_eq!(who(event, slides_back), [i, n - 1 - i]);
        assert_close!(x_of(event), pad.limits[i] / pad.c);
        assert_close!(event.load.to_vector()[0], pad.virgin(pad.limits[i] / pad.c));
    }
    // The end is the same as after a single leg from zero to Q₃.
    let (straight, _) = pad.follow(&[q3]);
    let (a, b) = (path.state().unwrap(), straight.state().unwrap());
    for (a, b) in a.contacts.iter().zip(&b.contacts) {
        assert_close!(a.force_world[0], b.force_world[0]);
        assert_close!(a.slip[1], b.slip[1]);
    }
}
