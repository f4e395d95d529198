//! Whatever is verified is true in rational arithmetic, and nearly everything true is verified.

use crate::adversarial::{FAMILIES, Family, problem};
use crate::common::{Exact, samples, seeded};
use grasp_lcp::lcp::{Basis, Lcp, Outcome};
use num_rational::BigRational;
use num_traits::FromPrimitive;

#[test]
fn bounds_hold_the_exact_solution() {
    let mut random = seeded(91);
    for family in FAMILIES {
        let (mut solved, mut exact_ones, mut verified) = (0, 0, 0);
        for trial in 0..samples(100) {
            let (m, q) = problem(&mut random, family);
            if !m.iter().chain(&q).all(|x| x.is_finite()) {
                continue;
            }
            let exact = Exact::of(&m, &q);
            let lcp = Lcp::new(m, q).expect("finite");
            // The basis of the answer, or a random one.
            let basis = match lcp.solve() {
                Outcome::Solved(solution) if trial % 4 > 0 => solution.basis,
                _ => Basis::from_indices(lcp.len(), (0..lcp.len()).filter(|_| random.integer(0, 1) == 0)),
            };
            solved += 1;
            let alpha: Vec<usize> = basis.iter().collect();
            let point = exact.exact_point(&alpha).filter(|z| exact.is_solution(z));
            exact_ones += usize::from(point.is_some());
            let Some(bounds) = lcp.verify(&basis) else { continue };
            verified += 1;
            let rational = |x: f64| BigRational::from_f64(x).expect("finite");
            if let Some(z) = point {
                for (i, z) in z.iter().enumerate() {
                    let within = rational(bounds.lower[i]) <= *z && *z <= rational(bounds.upper[i]);
                    assert!(within, "z_{i} = {z} of {lcp:?} {bounds:?}");
                    let tight = bounds.upper[i] - bounds.lower[i] <= 1e-15 * bounds.upper[i].abs();
                    assert!(tight || !matches!(family, Family::Whole(_)), "{bounds:?}");
                }
            } else {
                // The block is singular, but rational numbers may solve the problem all the same.
                assert!(exact.exact_point(&alpha).is_none() && exact.is_solvable(), "{lcp:?} {bounds:?}");
            }
        }
        println!("{family:?}: {verified} of {exact_ones} verified, {solved} bases tried");
        if matches!(family, Family::Whole(_)) {
            assert!(verified >= exact_ones, "{family:?}");
        }
        assert!(verified * 10 >= exact_ones * 7, "{family:?} {verified}");
    }
}
