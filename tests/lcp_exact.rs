//! Against rational arithmetic on small-integer problems, where ties and singular blocks are the normal case.
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::doc_markdown)]

mod common_lcp;
use common_lcp::{Integers, Random};
use grasp_lcp::lcp::Outcome;

/// A random problem: dense, sparse, skew, symmetric, or copositive-plus A Aᵀ + skew.
fn problem(random: &mut Random, kind: usize) -> Integers {
    let n = random.integer(1, 3) as usize;
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

#[test]
fn every_solved_basis_is_an_exact_solution_and_copositive_plus_rays_are_true() {
    let mut random = Random(3);
    let (mut solved, mut true_rays, mut false_rays) = ([0; 7], [0; 7], [0; 7]);
    for trial in 0..7000 {
        let kind = trial % 7;
        let problem = problem(&mut random, kind);
        match problem.problem().solve() {
            Outcome::Solved(solution) => {
                let alpha: Vec<usize> = solution.basis.iter().collect();
                let z = problem
                    .exact_point(&alpha)
                    .unwrap_or_else(|| panic!("singular basis {alpha:?} of {problem:?}"));
                assert!(problem.is_solution(&z), "{problem:?} {alpha:?} {solution:?}");
                assert!(solution.residuals.max() < 1e-13, "{problem:?} {solution:?}");
                solved[kind] += 1;
            }
            Outcome::Ray(ray) => {
                if problem.is_solvable() {
                    assert!(!matches!(kind, 2 | 4 | 5), "{problem:?} {ray:?}");
                    false_rays[kind] += 1;
                } else {
                    true_rays[kind] += 1;
                }
            }
            other => panic!("{problem:?} {other:?}"),
        }
    }
    println!("solved {solved:?}, true rays {true_rays:?}, false rays {false_rays:?}");
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
        assert_eq!(problem.is_solvable(), solvable);
        match problem.problem().solve() {
            Outcome::Solved(_) => assert!(solvable, "{problem:?}"),
            Outcome::Ray(_) => assert!(!solvable, "{problem:?}"),
            other => panic!("{problem:?} {other:?}"),
        }
    }
}
