//! Pads of many springs followed in steps agree with closed forms. A pad under parabolic pressure is dragged to and fro (Masing's rule), and dragged
//! until it is lost. In other pads one pair of springs after another touches.
//!
//! All friction acts along y = 0 through the middle of the pad, so a shear load Q along y = 0 neither tilts nor lifts the block. With c the
//! tangential stiffness of each spring and f_i = μ N_i,
//!
//! ```text
//! Q(x) = Σ_i min(c x, f_i)             first loading, spring i slides from x = f_i / c on
//! Q = Q_0 - 2 Q((x_0 - x)/2)           unloading from (x_0, Q_0), spring i slides back from x = x_0 - 2 f_i / c on
//! ```

use grasp_lcp::load_path::{Beyond, Step};
use grasp_lcp::planar::{Contact, Grasp, Leg, PathEnd, Wrench};

const MU: f64 = 0.4;
const K: f64 = 70.0;
const C: f64 = 50.0;
/// Allowed error of forces, relative to the largest force.
const ERROR: f64 = 1e-4;

fn real(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap())
}

struct Pad {
    grasp: Grasp,
    /// Friction limits μ N_i in the order of the contacts.
    limits: Vec<f64>,
}

impl Pad {
    fn new(n: usize) -> Self {
        let at = |i: usize| real(2 * i + 1) / real(n) - 1.0;
        let press = |i: usize| 1.0 - at(i) * at(i);
        let foot = |i: usize| {
            Contact::new([at(i), 0.0], [0.0, 1.0])
                .series_stiffness(K, C)
                .friction(MU)
                .command([press(i) / K, 0.0])
        };
        let limits = (0..n).map(|i| MU * press(i)).collect();
        Self { grasp: Grasp::new((0..n).map(foot)).unwrap(), limits }
    }

    fn load(&self, q: f64) -> Wrench {
        Wrench::force([q, -self.limits.iter().sum::<f64>() / MU])
    }

    /// Shear force Q(x) on first loading.
    fn virgin(&self, x: f64) -> f64 {
        self.limits.iter().map(|limit| (C * x).min(*limit)).sum()
    }
}

#[test]
fn every_spring_is_where_masings_rule_puts_it() {
    for n in [2, 33, 1000] {
        let pad = Pad::new(n);
        // About half of the springs slide at the turning point.
        let x0 = 0.6 * MU / C;
        let [most, least] = [pad.virgin(x0), pad.virgin(x0) - 2.0 * pad.virgin(0.9 * x0)];
        let mut path = pad.grasp.follow_in_steps(pad.load(0.0), &[], ERROR).unwrap();
        // Each spring carries at most its limit of friction f_i during loading, and at least -f_i during unloading.
        let there = |limit: f64| (C * x0).min(limit);
        let back = |limit: f64| (there(limit) - C * 1.8 * x0).max(-limit);
        let frictions: [&dyn Fn(f64) -> f64; 2] = [&there, &back];
        for ((load, x), friction) in [(most, x0), (least, x0 - 1.8 * x0)].into_iter().zip(frictions) {
            path.continue_with(&[Leg::load_to(pad.load(load))]).unwrap();
            path.by_ref().for_each(drop);
            assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
            let state = path.state().unwrap();
            let moved = state.twist.translation()[0];
            let worst = state.contacts.iter().zip(&pad.limits);
            let worst = worst.map(|(contact, limit)| (contact.force[1] + friction(*limit)).abs());
            let worst = worst.fold(0.0, f64::max);
            println!("{n} springs: {worst:e} N, {:e} m", moved - x);
            assert!(worst < ERROR && (moved - x).abs() < ERROR * x0, "{n} springs: {worst:e} N");
            assert!(state.residuals.worst() <= 1e-11, "{:?}", state.residuals);
        }
    }
}

#[test]
fn a_pad_gives_way_when_every_spring_slides() {
    for n in [3, 100] {
        let pad = Pad::new(n);
        let most: f64 = pad.limits.iter().sum();
        let legs = [Leg::load_to(pad.load(1.25 * most))];
        let mut path = pad.grasp.follow_in_steps(pad.load(0.0), &legs, ERROR).unwrap();
        path.by_ref().for_each(drop);
        let loss = path.end().and_then(PathEnd::loss).expect("a loss");
        let off = loss.load.to_vector()[0] / most - 1.0;
        println!("{n} springs: {} by {off:e}", loss.kind);
        assert!(off.abs() < 1e-10 && loss.contacts.len() == n, "{off:e}");
        let motion = loss.motion.as_ref().unwrap();
        assert!(motion.object.translation()[0] > 0.9 && motion.object.rotation().abs() < 1e-6, "{motion:?}");
        assert!(matches!(path.beyond(), Some(Beyond::LimitLoad)));
    }
}

/// Pairs of springs at ±x have clearances that grow from the middle outwards. Pair j touches when the block has moved by the clearance of this pair.
/// The load of this event is the force that the inner pairs carry at this displacement. On unloading the pairs separate at the same loads.
#[test]
fn pairs_touch_and_part_at_known_loads() {
    let (n, deepest) = (100, 0.5);
    let clearance = |j: usize| (real(j) / real(n)).powi(2);
    let spring = |i: usize| {
        let (j, side) = (i / 2, if i.is_multiple_of(2) { 1.0 } else { -1.0 });
        Contact::new([side * (0.1 + real(j)), 0.0], [0.0, 1.0])
            .series_stiffness(K, C)
            .friction(MU)
            .clearance(clearance(j))
            .command([0.01, 0.0])
    };
    let grasp = Grasp::new((0..2 * n).map(spring)).unwrap();
    // Load at which the block has moved down by z from the first touch of the innermost pair.
    let load = |z: f64| -> f64 { (0..n).map(|j| 2.0 * K * (z - clearance(j)).max(0.0)).sum() };
    let press = |z: f64| Wrench::force([0.0, -load(z)]);
    let first = 0.5 * clearance(1);
    let legs = [Leg::load_to(press(deepest)), Leg::load_to(press(first))];
    let mut path = grasp.follow_in_steps(press(first), &legs, ERROR).unwrap();
    let mut steps = 0;
    while let Some(Step { load: pressed, open, .. }) = path.next() {
        let state = path.state().unwrap();
        let z = 0.01 - state.twist.translation()[1];
        let off = (load(z) + pressed.to_vector()[1]).abs() / load(deepest);
        let apart = (0..n).filter(|&j| clearance(j) > z).count();
        assert!(off < 1e-9 && open.abs_diff(2 * apart) <= 2, "{open} {z} {off:e}");
        steps += 1;
    }
    println!("{steps} steps");
    assert!(matches!(path.end(), Some(PathEnd::Completed)) && steps > 4, "{:?}", path.end());
}
