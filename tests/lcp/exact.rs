//! Answers agree with rational arithmetic on problems of small integers, where ties and singular blocks are the normal case.
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::doc_markdown)]

use crate::common::{Integers, Random, assert_met, samples, seeded};
use grasp_lcp::lcp::{Outcome, Settings, Solution};
use num_traits::ToPrimitive;

/// A random problem: dense, sparse, skew, symmetric, or copositive-plus A Aᵀ + skew.
fn problem(random: &mut Random, kind: usize, largest: i64) -> Integers {
    let n = random.integer(1, largest) as usize;
    let size = random.integer(1, 3);
    let mut m = vec![0; n * n];
    for entry in &mut m {
        *entry = random.integer(-size, size);
        if kind == 1 && random.integer(0, 1) == 0 {
            *entry = 0;
        }
    }
    let a = m.clone();
    for i in 0..n {
        for j in 0..n {
            m[i * n + j] = match kind {
                2 => a[i * n + j] - a[j * n + i],
                3 => a[i * n + j] + a[j * n + i],
                4 | 5 => {
                    let gram: i64 = (0..n).map(|k| a[i * n + k] * a[j * n + k]).sum();
                    if kind == 4 { gram } else { gram + if i < j { 1 } else { -i64::from(i > j) } }
                }
                6 => a[i * n + j].abs(),
                _ => a[i * n + j],
            };
        }
    }
    let q = (0..n).map(|_| random.integer(-2, 2)).collect();
    Integers { n, m, q }
}

/// Asserts that a solution is exact: by its basis if this is regular, otherwise by its residuals and the existence of a solution.
fn assert_exact(problem: &Integers, solution: &Solution) {
    assert!(solution.residuals.within(1e-13), "{problem:?} {solution:?}");
    let alpha: Vec<usize> = solution.basis.iter().collect();
    match problem.exact().exact_point(&alpha) {
        Some(z) => assert!(problem.exact().is_solution(&z), "{problem:?} {solution:?}"),
        None => assert!(problem.exact().is_solvable(), "{problem:?} {solution:?}"),
    }
}

#[test]
fn the_answer_is_a_solution_exactly_if_there_is_one() {
    let mut random = seeded(3);
    let (mut solved, mut infeasible, mut without) = ([0; 7], [0; 7], [0; 7]);
    for trial in 0..samples(1750) {
        let kind = trial % 7;
        let problem = problem(&mut random, kind, 5);
        let lcp = problem.problem();
        match lcp.solve() {
            Outcome::Solved(solution) => {
                assert_exact(&problem, &solution);
                solved[kind] += 1;
            }
            Outcome::Infeasible(certificate) => {
                assert!(lcp.proves_infeasible(&certificate.y), "{problem:?} {certificate:?}");
                assert!(!problem.exact().is_feasible(), "{problem:?} {certificate:?}");
                infeasible[kind] += 1;
            }
            Outcome::NoBasis { .. } => {
                assert!(!problem.exact().is_solvable() && problem.exact().is_feasible(), "{problem:?}");
                without[kind] += 1;
            }
            other => panic!("{problem:?} {other:?}"),
        }
    }
    println!("solved {solved:?}, infeasible {infeasible:?}, feasible without solution {without:?}");
}

#[test]
fn one_path_is_enough_where_the_theory_says_so() {
    let one_path = Settings::default().with_retries(0).with_enumerate_up_to(0);
    let mut random = seeded(11);
    let mut missed = [0; 7];
    for trial in 0..samples(1750) {
        let kind = trial % 7;
        let problem = problem(&mut random, kind, 6);
        match problem.problem().solve_with(&one_path) {
            Outcome::Solved(solution) => assert_exact(&problem, &solution),
            Outcome::Infeasible(_) => assert!(!problem.exact().is_feasible(), "{problem:?}"),
            Outcome::Ray(ray) => {
                // Skew, Gram, and Gram plus skew matrices are positive semidefinite.
                assert!(!matches!(kind, 2 | 4 | 5), "{problem:?} {ray:?}");
                missed[kind] += usize::from(problem.exact().is_solvable());
            }
            other => panic!("{problem:?} {other:?}"),
        }
    }
    println!("missed by a single path: {missed:?} of 1000 each");
}

#[test]
fn all_solutions_are_those_of_exact_enumeration() {
    let mut random = seeded(5);
    let mut several = 0;
    for trial in 0..samples(750) {
        let problem = problem(&mut random, trial % 7, 4);
        let all = problem.problem().all_solutions().expect("n is small");
        let exact = problem.exact().regular_solutions();
        several += usize::from(exact.len() > 1);
        for z in &exact {
            let found = all.solutions.iter().any(|s| {
                z.iter().zip(&s.z).all(|(exact, z)| (exact.to_f64().expect("finite") - z).abs() < 1e-9)
            });
            assert!(found, "{problem:?} {z:?} {all:?}");
        }
        if all.singular.is_empty() {
            assert_eq!(all.solutions.len(), exact.len(), "{problem:?} {all:?}");
        }
        assert_eq!(all.solutions.is_empty(), !problem.exact().is_solvable(), "{problem:?}");
    }
    assert_met(&[(several, 25)]);
}

#[test]
fn tiny_and_zero_problems() {
    for (m, q, solvable) in [
        (vec![], vec![], true),
        (vec![0], vec![0], true),
        (vec![0], vec![1], true),
        (vec![0], vec![-1], false),
        (vec![1], vec![-2], true),
        (vec![-1], vec![-1], false),
        (vec![-1], vec![1], true),
        (vec![0; 9], vec![0, 1, 2], true),
        (vec![0; 9], vec![0, 1, -2], false),
    ] {
        let problem = Integers { n: q.len(), m, q };
        assert_eq!(problem.exact().is_solvable(), solvable);
        match problem.problem().solve() {
            Outcome::Solved(_) => assert!(solvable, "{problem:?}"),
            Outcome::Infeasible(_) => assert!(!solvable, "{problem:?}"),
            other => panic!("{problem:?} {other:?}"),
        }
    }
}
