//! The load at which a pushed block on three points starts to slide is right to the last digits, however close the push comes to the middle of the
//! block.
//!
//! The weight alone determines the normal force N of each point. For a motion v, ω of the block, friction dissipates Σ μ N |v + ω × r|. The limit
//! load is the minimum of this over all motions on which the push does unit work. This convex minimum is found here by golden-section search.

use grasp_lcp::load_path::PathEnd;
use support::odd_paths::{Odd, in_space};
use support::samples::{samples, seeded};

/// The minimum of a convex function in an interval, by golden-section search.
fn least(mut low: f64, mut high: f64, f: &dyn Fn(f64) -> f64) -> f64 {
    let part = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (high - part * (high - low), low + part * (high - low));
    let (mut fa, mut fb) = (f(a), f(b));
    for _ in 0..75 {
        if fa < fb {
            (high, b, fb) = (b, a, fa);
            a = high - part * (high - low);
            fa = f(a);
        } else {
            (low, a, fa) = (a, b, fb);
            b = low + part * (high - low);
            fb = f(b);
        }
    }
    fa.min(fb)
}

/// The limit factor of a push (force in the plane of the feet and moment about z) on feet (x, y, μN).
fn limit(feet: &[[f64; 3]; 3], push: [f64; 3]) -> f64 {
    let force = push[0].hypot(push[1]);
    let (along, across) = ([push[0] / force, push[1] / force], [-push[1] / force, push[0] / force]);
    let work = |turn: f64, side: f64| {
        // Unit work: force·v + moment ω = 1.
        let forward = (1.0 - push[2] * turn) / force;
        let v = [0, 1].map(|k| forward * along[k] + side * across[k]);
        feet.iter().map(|[x, y, limit]| limit * (v[0] - turn * y).hypot(v[1] + turn * x)).sum::<f64>()
    };
    let most = 1e3 / force;
    least(-most, most, &|turn| least(-most, most, &|side| work(turn, side)))
}

#[test]
fn pushes_end_at_their_limit_loads() {
    let mut random = seeded(7);
    for number in 0..samples(150) {
        let pushed = in_space(Odd::Pushed, &mut random).unwrap();
        let mut path = pushed.grasp.follow(pushed.start, &pushed.legs).unwrap();
        path.run();
        let Some(loss) = path.end().and_then(PathEnd::loss) else { panic!("{number}: {:?}", path.end()) };
        let first = path.state_at(0, 0.0).unwrap();
        let feet = [0, 1, 2].map(|i| {
            let contact = &pushed.grasp.contacts()[i];
            let point = contact.point();
            [point[0], point[1], contact.friction_coefficient() * first.contacts[i].normal_force()]
        });
        let ([x, y, _], [.., about]) = (loss.load.resultant(), loss.load.moment());
        // The load at the end of the path is the limit load, so that the limit factor of this load is one.
        let factor = limit(&feet, [x, y, about]);
        assert!((factor - 1.0).abs() < 1e-7, "{number}: {:e}", factor - 1.0);
    }
}
