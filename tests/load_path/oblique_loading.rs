//! A rough ball on independent springs is pressed and sheared at once, then sheared further and back. The tractions agree with the solutions of Jäger
//! and of Ciavarella.
//!
//! Spring i closes when the ball has come down by `h_i = r_i²/2R`. When the ball has come down by δ, the spring presses with `n_i = k (δ - h_i)`. All
//! friction acts in the plane of the spring ends, and the springs lie symmetrically, so that the ball does not tilt. Starting from a pressed ball,
//!
//! ```text
//! P and Q grow, dQ = ρ dP, ρ < μ:     all springs stick,      t_i = ρ (n_i - n_i⁰)
//! Q grows at this P:                  t_i = min(ρ (n_i - n_i⁰) + k_t v, μ n_i)
//! Q falls at this P:                  t_i = max(t_i - k_t w, -μ n_i)
//! ```
//!
//! With `n_i⁰ = 0` the second is `μ n_i - (μ - ρ) n_i*` with the pressures n* of a ball that is pressed less: the superposition of J. Jäger (A new
//! principle in contact mechanics, J. Tribology 120 (1998) 677) and M. Ciavarella (Tangential loading of general three-dimensional contacts, J. Appl.
//! Mech. 65 (1998) 998).

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::Contact;
use grasp_lcp::load_path::{Leg, PathEnd};
use grasp_lcp::{planar, spatial};
use nalgebra::{Matrix, SVector};

const MU: f64 = 0.4;
/// Normal and tangential stiffness of a spring, N/m.
const K: f64 = 1000.0;
const KT: f64 = 700.0;
/// Diameter 2R of the ball, m.
const DIAMETER: f64 = 100.0;
/// Indentation before the shear, and after the oblique leg, m.
const DEPTHS: [f64; 2] = [2e-3, 9e-3];
/// dQ / dP of the oblique leg.
const RHO: f64 = 0.25;
/// Shear force after the second and the third leg, relative to μP.
const SHEARS: [f64; 2] = [0.9, -0.6];

/// The springs, each by its squared distance r² from the axis, m².
struct Springs(Vec<f64>);

impl Springs {
    fn pressures(&self, depth: f64) -> Vec<f64> {
        self.0.iter().map(|square| K * (depth - square / DIAMETER).max(0.0)).collect()
    }

    /// The loads `[P, Q]` (normal and shear) at the start and after each of three legs, and the forces `[n, t]` of each spring after each leg.
    fn closed_form(&self) -> ([[f64; 2]; 4], [Vec<[f64; 2]>; 3]) {
        let [before, pressed] = DEPTHS.map(|depth| self.pressures(depth));
        let [start, total] = [&before, &pressed].map(|n| n.iter().sum::<f64>());
        let oblique: Vec<f64> = pressed.iter().zip(&before).map(|(n, less)| RHO * (n - less)).collect();
        let further = |v: f64| -> Vec<f64> {
            let sheared = oblique.iter().zip(&pressed);
            sheared.map(|(t, n)| if *n > 0.0 { (t + KT * v).min(MU * n) } else { 0.0 }).collect()
        };
        let [most, back] = SHEARS.map(|part| part * MU * total);
        let sheared = further(solved(|v| further(v).iter().sum::<f64>() - most));
        let returned = |w: f64| -> Vec<f64> {
            let sheared = sheared.iter().zip(&pressed);
            sheared.map(|(t, n)| if *n > 0.0 { (t - KT * w).max(-MU * n) } else { 0.0 }).collect()
        };
        let returned = returned(solved(|w| back - returned(w).iter().sum::<f64>()));
        let loads = [[start, 0.0], [total, RHO * (total - start)], [total, most], [total, back]];
        let both = |t: &Vec<f64>| pressed.iter().copied().zip(t.iter().copied()).map(Into::into).collect();
        (loads, [&oblique, &sheared, &returned].map(both))
    }
}

/// The root of an increasing function in [0, 1], by bisection.
fn solved(f: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        *(if f(middle) < 0.0 { &mut low } else { &mut high }) = middle;
    }
    0.5 * (low + high)
}

fn spring<const C: usize>(contact: Contact<C>, square: f64) -> Contact<C> {
    contact.series_stiffness(K, KT).friction(MU).clearance(square / DIAMETER)
}

/// Largest difference of forces from the closed form `[n, t]`, relative to the largest force. Friction acts on the ball against the shear.
fn off<const C: usize>(forces: &[SVector<f64, C>], shear: &SVector<f64, C>, exact: &[[f64; 2]]) -> f64 {
    let largest = forces.iter().map(Matrix::norm).fold(0.0, f64::max);
    let mut up = SVector::zeros();
    up[C - 1] = 1.0;
    let error = |(f, [n, t]): (&SVector<f64, C>, &[f64; 2])| (f - up * *n + shear * *t).norm() / largest;
    forces.iter().zip(exact).map(error).fold(0.0, f64::max)
}

#[test]
fn in_the_plane_every_event_is_exact() {
    let places: Vec<f64> =
        (0..41).map(|i| (f64::from(i) - 20.0) / 20.0 + 1e-3 * (f64::from(i) - 20.0)).collect();
    let springs = Springs(places.iter().map(|x| x * x).collect());
    let contacts = places.iter().map(|x| spring(planar::Contact::new([*x, 0.0], [0.0, 1.0]), x * x));
    let grasp = Grasp::new(contacts).unwrap();
    let (loads, exact) = springs.closed_form();
    let load = |[p, q]: [f64; 2]| planar::Wrench::force([q, -p]);
    let legs: Vec<_> = loads[1..].iter().map(|pq| Leg::load_to(load(*pq))).collect();
    for (count, exact) in (1..).zip(&exact) {
        let legs = &legs[..count];
        let mut path = grasp.follow(load(loads[0]), legs).unwrap();
        path.run();
        assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
        let error = off(&world(&grasp, &path.forces()), &SVector::from([1.0, 0.0]), exact);

        assert!(error < 2e-15, "leg {count}: {error:e}");
        let mut path = grasp.follow_in_steps(load(loads[0]), legs, 1e-6).unwrap();
        path.run();
        assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
        let error = off(&world(&grasp, &path.forces()), &SVector::from([1.0, 0.0]), exact);

        assert!(error < 1e-11, "{count} {error:e}");
    }
}

#[test]
fn on_the_round_cone_events_and_steps_are_exact() {
    let places: Vec<[f64; 2]> = (-6_i8..=6)
        .flat_map(|i| (-6_i8..=6).map(move |j| [f64::from(i) / 6.5, f64::from(j) / 6.1]))
        .filter(|[x, y]| x * x + y * y < 1.0)
        .collect();
    let square = |[x, y]: &[f64; 2]| x * x + y * y;
    let springs = Springs(places.iter().map(square).collect());
    let contacts = places.iter().map(|place| {
        spring(spatial::Contact::new([place[0], place[1], 0.0], [0.0, 0.0, 1.0]), square(place))
    });
    let grasp: spatial::Grasp = Grasp::new(contacts).unwrap();
    let (loads, exact) = springs.closed_form();
    let (sin, cos) = 0.7_f64.sin_cos();
    let load = |[p, q]: [f64; 2]| spatial::Wrench::force([q * cos, q * sin, -p]);
    let legs: Vec<_> = loads[1..].iter().map(|pq| Leg::load_to(load(*pq))).collect();
    let shear = SVector::from([cos, sin, 0.0]);
    for (count, exact) in (1..).zip(&exact) {
        let legs = &legs[..count];
        let mut path = grasp.follow(load(loads[0]), legs).unwrap();
        path.run();
        assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
        let error = off(&world(&grasp, &path.forces()), &shear, exact);

        assert!(error < 2e-15, "leg {count}: {error:e}");
        let mut path = grasp.follow_in_steps(load(loads[0]), legs, 1e-6).unwrap();
        path.run();
        assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
        let error = off(&world(&grasp, &path.forces()), &shear, exact);

        assert!(error < 1e-11, "{count} {error:e}");
    }
}

/// Forces along the coordinate axes.
fn world<const C: usize>(grasp: &Grasp<C>, forces: &[SVector<f64, C>]) -> Vec<SVector<f64, C>> {
    grasp.frames().zip(forces).map(|(frame, force)| frame * force).collect()
}
