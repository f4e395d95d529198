//! In the plane a solution is returned exactly if one exists. Enumeration of all combinations of states in rational arithmetic confirms this.

use grasp_lcp::friction::PlanarContacts;
use grasp_lcp::lcp::Outcome;
use nalgebra::{DMatrix, DVector};
use num_rational::BigRational;
use num_traits::FromPrimitive;
use support::exact_lcp::is_feasible;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// The forces of a contact in a state, as nonnegative combinations of generators, and the conditions on its velocity: components that
/// vanish, and components with a sign that are not negative.
struct State {
    generators: Vec<[BigRational; 2]>,
    vanishing: Vec<usize>,
    signed: Vec<(usize, i64)>,
}

fn states(mu: &BigRational) -> Vec<State> {
    let one = || BigRational::from_integer(1.into());
    vec![
        State { generators: vec![], vanishing: vec![], signed: vec![(0, 1)] },
        State { generators: vec![[one(), mu.clone()], [one(), -mu]], vanishing: vec![0, 1], signed: vec![] },
        State { generators: vec![[one(), -mu]], vanishing: vec![0], signed: vec![(1, 1)] },
        State { generators: vec![[one(), mu.clone()]], vanishing: vec![0], signed: vec![(1, -1)] },
    ]
}

/// Whether some combination of states has a solution.
fn is_solvable(w: &DMatrix<f64>, q: &DVector<f64>, mu: &[f64]) -> bool {
    let exact = |x: f64| BigRational::from_f64(x).expect("finite");
    let of_contact: Vec<Vec<State>> = mu.iter().map(|mu| states(&exact(*mu))).collect();
    let codes = (0..mu.len()).fold(1_usize, |codes, _| 4 * codes);
    (0..codes).any(|code| {
        let chosen: Vec<&State> = (0..mu.len()).map(|i| &of_contact[i][code >> (2 * i) & 3]).collect();
        let columns: Vec<(usize, &[BigRational; 2])> = chosen
            .iter()
            .enumerate()
            .flat_map(|(i, state)| state.generators.iter().map(move |g| (i, g)))
            .collect();
        let (mut rows, mut constants, mut equal) = (Vec::new(), Vec::new(), Vec::new());
        for (i, state) in chosen.iter().enumerate() {
            let vanishing = state.vanishing.iter().map(|k| (*k, 1, true));
            for (k, sign, vanishes) in
                vanishing.chain(state.signed.iter().map(|(k, sign)| (*k, *sign, false)))
            {
                let sign = BigRational::from_integer(sign.into());
                let entry = |(j, g): &(usize, &[BigRational; 2])| {
                    &sign * (exact(w[(2 * i + k, 2 * j)]) * &g[0] + exact(w[(2 * i + k, 2 * j + 1)]) * &g[1])
                };
                rows.push(columns.iter().map(entry).collect::<Vec<_>>());
                constants.push(&sign * exact(q[2 * i + k]));
                equal.push(vanishes);
            }
        }
        is_feasible(&rows, &constants, &equal)
    })
}

/// Families of matrices W.
#[derive(Debug, Clone, Copy)]
enum Family {
    /// Random integers.
    Any,
    /// H Hᵀ, where H has as many columns as a body has coordinates; redundant from two contacts on.
    Body,
    /// `Body` plus a skew part.
    Skew,
}

fn problem(random: &mut Random, family: Family) -> (DMatrix<f64>, DVector<f64>, Vec<f64>) {
    let n = random.index(1, 3);
    let mut whole = |rows: usize, columns: usize, size: i64| {
        DMatrix::from_fn(rows, columns, |_, _| random.integer(-size, size) as f64)
    };
    let (h, a) = (whole(2 * n, 3, 2), whole(2 * n, 2 * n, 2));
    let w = match family {
        Family::Any => a,
        Family::Body => &h * h.transpose(),
        Family::Skew => &h * h.transpose() + &a - a.transpose(),
    };
    let q = whole(2 * n, 1, 3).column(0).into_owned();
    let mu = (0..n).map(|_| [0.0, 0.25, 0.5, 1.0, 3.0][random.index(0, 4)]).collect();
    (w, q, mu)
}

#[test]
fn the_answer_is_a_solution_exactly_if_there_is_one() {
    let mut random = seeded(21);
    let mut excluded = 0;
    for family in [Family::Any, Family::Body, Family::Skew] {
        let (mut solved, mut infeasible, mut none, mut open) = (0, 0, 0, 0);
        for _ in 0..samples(50) {
            let (w, q, mu) = problem(&mut random, family);
            let problem = PlanarContacts::new(w.clone(), q.clone(), mu.clone()).expect("finite");
            let solvable = is_solvable(&w, &q, &mu);
            match problem.solve() {
                Outcome::Solved(solution) => {
                    assert!(solvable && solution.residuals.max() <= 1e-12, "{problem:?} {solution:?}");
                    solved += 1;
                }
                Outcome::Infeasible(certificate) => {
                    assert!(!solvable && problem.proves_infeasible(&certificate.y), "{problem:?}");
                    infeasible += 1;
                }
                Outcome::NoBasis { .. } => {
                    assert!(!solvable, "{problem:?}");
                    none += 1;
                }
                other => {
                    assert!(!solvable, "{problem:?} {other}");
                    open += 1;
                }
            }
        }
        println!(
            "{family:?}: {solved} solved, {infeasible} infeasible, {none} without a solution, {open} open"
        );
        assert_met(&[(solved, 30)]);
        assert!(open <= samples(1));
        excluded += infeasible + none;
    }
    assert_met(&[(excluded, 10)]);
}

/// In the plane the complementarity problem with two directions is equivalent to the frictional problem.
#[test]
fn two_facets_are_the_cone() {
    let mut random = seeded(22);
    for _ in 0..samples(300) {
        let (w, q, mu) = problem(&mut random, Family::Body);
        let problem = PlanarContacts::new(w, q, mu).expect("finite");
        let polygon = problem.facets(2).expect("small numbers");
        let Outcome::Solved(solution) = polygon.lcp.solve() else { continue };
        let r = polygon.forces(&solution.z).expect("it fits");
        assert!(problem.residuals(&r).max() <= 1e-13);
    }
}
