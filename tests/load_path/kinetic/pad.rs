//! In a pad of many points, each point that starts to slide passes the friction it loses on to the other points. The limit load is a closed form.
//!
//! Points pressed with `p = 1 - ξ²` under a rigid block have the same tangential stretch x. At `y = k x / μ_s` the points beyond `ξ_s² = 1 - y`
//! slide. All points together carry
//!
//! ```text
//! F / μ_s = 2 y ξ_s + 2 r (2/3 - ξ_s + ξ_s³/3),      r = μ_k/μ_s,      most at ξ_s² = (1 - r)/(3 - r)
//! ```
//!
//! With static friction alone the limit is `4/3 μ_s`. A pad of n points is lost close to this maximum, and closer with growing n.

use grasp_lcp::planar::{Contact, Grasp, Leg, PathEnd, Wrench};

const REST: f64 = 0.5;

fn lost_at(points: usize, r: f64) -> f64 {
    let width = 2.0 / points as f64;
    let point = |i: usize| {
        let xi = (i as f64 + 0.5) * width - 1.0;
        let press = 1.0 - xi * xi;
        let contact = Contact::new([xi, 0.0], [0.0, 1.0]).series_stiffness(width, 0.3 * width);
        contact.friction(REST).kinetic(r * REST).command([press, 0.0])
    };
    let total: f64 =
        (0..points).map(|i| (i as f64 + 0.5) * width - 1.0).map(|xi| width * (1.0 - xi * xi)).sum();
    let rail = |x: f64| Contact::new([x, 0.1], [0.0, 1.0]).series_stiffness(1e3, 1.0).kept_closed();
    let grasp = Grasp::new((0..points).map(point).chain([rail(-1.0), rail(1.0)])).unwrap();
    let pulled = |force: f64| Wrench::new([force, -total], 0.0);
    let mut path = grasp.follow(pulled(0.0), &[Leg::load_to(pulled(1.0))]).unwrap();
    path.run();
    assert!(matches!(path.end(), Some(PathEnd::Lost(_))), "{:?}", path.end());
    path.place().1
}

#[test]
fn a_pad_is_lost_at_the_peak_of_all_its_points() {
    for r in [0.9_f64, 0.7, 0.4] {
        let xi = ((1.0 - r) / (3.0 - r)).sqrt();
        let peak = 2.0 * REST * ((1.0 - xi * xi) * xi + r * (2.0 / 3.0 - xi + xi.powi(3) / 3.0));
        let off = [10, 20, 40, 80].map(|points| (points, lost_at(points, r) / peak - 1.0));
        println!("r = {r}: peak {peak}, of rest alone {}; {off:?}", 4.0 / 3.0 * REST);
        for (points, off) in off {
            assert!(off.abs() < 2.0 / points as f64, "{r} {points}: {off}");
        }
    }
}
