//! Problems with many contacts are solved: towers of blocks with known forces, and problems with redundant contacts.

use grasp_lcp::friction::{ContactMode, FrictionProblem, Settings, SolveProgress, SpatialContacts};
use grasp_lcp::lcp::{BreakdownCause, Outcome};
use nalgebra::{DMatrix, DVector};
use std::ops::ControlFlow;
use support::coulomb::missed_law;
use support::samples::{samples, seeded};
use support::splitmix::Random;

/// A tower of point masses, each with its own sideways push. Contact i carries the weight above it, and the pushes above it up to the limit of friction.
///
/// The problem is in velocities of one step from rest: contact i has u = v_i − v_{i−1}, with v_{−1} = 0 for the ground.
fn tower(masses: &[f64], push: &[f64], mu: f64) -> SpatialContacts {
    let n = masses.len();
    let mut h = DMatrix::<f64>::zeros(3 * n, 3 * n);
    for i in 0..3 * n {
        h[(i, i)] = 1.0;
        if i >= 3 {
            h[(i, i - 3)] = -1.0;
        }
    }
    let inverse = DMatrix::from_diagonal(&DVector::from_fn(3 * n, |k, _| 1.0 / masses[k / 3]));
    let free = DVector::from_fn(3 * n, |k, _| match k % 3 {
        0 => -1.0,
        1 => push[k / 3] / masses[k / 3],
        _ => 0.0,
    });
    SpatialContacts::new(&h * inverse * h.transpose(), &h * free, vec![mu; n]).expect("finite")
}

/// The masses differ by factors of up to a thousand. Forces are accurate to 1e-8 of the normal force.
#[test]
fn a_tower_of_unequal_masses_carries_its_weight() {
    let mut random = seeded(92);
    for n in [1, 5, 30, 120] {
        let masses: Vec<f64> = (0..n).map(|_| 10.0_f64.powf(3.0 * random.uniform() - 1.5)).collect();
        let above = |i: usize| masses[i..].iter().sum::<f64>();
        let push: Vec<f64> = masses.iter().map(|m| 0.2 * m * (random.signed())).collect();
        let outcome = tower(&masses, &push, 0.5).solve();
        let solution = outcome.solution().unwrap_or_else(|| panic!("{n}: {outcome}"));
        for i in 0..n {
            let (normal, pushed) = (above(i), push[i..].iter().sum::<f64>());
            assert_eq!(solution.states[i], ContactMode::Sticking);
            assert!((solution.r[3 * i] / normal - 1.0).abs() < 1e-8, "{i} of {n}");
            assert!((solution.r[3 * i + 1] + pushed).abs() < 1e-8 * normal, "{i} of {n}");
        }
    }
}

/// The top block is pushed harder than friction can hold; all others stay.
#[test]
fn the_top_of_a_tower_slides() {
    let n = 60;
    let mut push = vec![0.0; n];
    push[n - 1] = 1.0;
    let outcome = tower(&vec![1.0; n], &push, 0.25).solve();
    let solution = outcome.solution().unwrap_or_else(|| panic!("{outcome}"));
    assert_eq!(solution.states[n - 1], ContactMode::Sliding);
    assert!(solution.states[..n - 1].iter().all(|state| *state == ContactMode::Sticking));
    assert!((solution.u[3 * n - 2] - 0.75).abs() < 1e-10);
    assert!((solution.r[1] + 0.25).abs() < 1e-10);
}

/// Bodies with redundant contacts, such as 40 contacts of 6 bodies; most forces are not unique.
fn pile(random: &mut Random, bodies: usize, contacts: usize) -> SpatialContacts {
    let mut h = DMatrix::<f64>::zeros(3 * contacts, 6 * bodies);
    for c in 0..contacts {
        let (one, other) = (random.index(0, bodies - 1), random.index(0, bodies));
        for k in 0..3 {
            for l in 0..6 {
                h[(3 * c + k, 6 * one + l)] += random.normal();
                if other < bodies && other != one {
                    h[(3 * c + k, 6 * other + l)] -= random.normal();
                }
            }
        }
    }
    let mass: Vec<f64> = (0..bodies).map(|_| 10.0_f64.powf(random.signed())).collect();
    let inverse = DMatrix::from_diagonal(&DVector::from_fn(6 * bodies, |k, _| 1.0 / mass[k / 6]));
    let v = DVector::from_fn(6 * bodies, |_, _| random.normal());
    let mu = (0..contacts).map(|_| 0.2 + 0.6 * random.uniform()).collect();
    SpatialContacts::new(&h * inverse * h.transpose(), h * v, mu).expect("finite")
}

#[test]
fn piles_of_redundant_contacts_are_solved() {
    let mut random = seeded(93);
    let mut unsolved = 0;
    for (bodies, contacts) in [(2, 8), (4, 20), (6, 40)] {
        for _ in 0..samples(3) {
            let problem = pile(&mut random, bodies, contacts);
            match problem.solve() {
                Outcome::Solved(solution) => {
                    assert!(solution.residuals.max() <= 1e-12 && missed_law(&problem, &solution.r) <= 2e-12);
                }
                Outcome::Infeasible(certificate) => assert!(problem.proves_infeasible(&certificate.y)),
                other => {
                    println!("{bodies} {contacts}: {other}");
                    unsolved += 1;
                }
            }
        }
    }
    assert_eq!(unsolved, 0);
}

/// Problems with positive definite W and very different masses and stiffnesses are solved.
fn unequal_masses<const C: usize>(seed: u64, count: usize) {
    let mut random = seeded(seed);
    for trial in 0..samples(count) {
        let n = random.index(1, 6);
        let size = C * n;
        let (columns, far, shift) =
            [(size.min(6), 0.0, 1e-3), (size + 2, 6.0, 0.0), (size, 4.0, 1e-6)][trial % 3];
        let h = DMatrix::from_fn(size, columns, |_, _| random.normal());
        let inverse = DVector::from_fn(columns, |_, _| 10.0_f64.powf(far * (random.uniform() - 0.5)));
        let w = &h * DMatrix::from_diagonal(&inverse) * h.transpose() + DMatrix::identity(size, size) * shift;
        let q = DVector::from_fn(size, |_, _| random.normal());
        let mu = (0..n).map(|_| 0.05 + 1.5 * random.uniform()).collect();
        let problem = FrictionProblem::<C>::new(w, q, mu).expect("finite");
        let outcome = problem.solve();
        let Outcome::Solved(solution) = outcome else { panic!("{trial}: {outcome}") };
        assert!(missed_law(&problem, &solution.r) <= 1e-12, "{trial} {}", missed_law(&problem, &solution.r));
    }
}

#[test]
fn unequal_masses_are_solved_in_space() {
    unequal_masses::<3>(94, 900);
}

#[test]
fn unequal_masses_are_solved_in_the_plane() {
    unequal_masses::<2>(95, 900);
}

/// A callback receives forces with decreasing residuals and the indices of contacts, and may stop the solver.
#[test]
fn whoever_watches_may_stop() {
    let mut random = seeded(96);
    let problem = pile(&mut random, 8, 40);
    let (mut told, mut least) = (0, f64::INFINITY);
    let outcome = problem.solve_watched(&Settings::default(), &mut |progress: &SolveProgress<'_>| {
        told += 1;
        assert!(progress.residual <= least && progress.contacts.contains(&progress.worst));
        assert_eq!(progress.forces.len(), 3 * progress.contacts.len());
        least = progress.residual;
        ControlFlow::Continue(())
    });
    assert!(outcome.solution().is_some() && told > 2 && least <= 1e-12, "{outcome} {told} {least}");
    let stopped = problem.solve_watched(&Settings::default(), &mut |_| ControlFlow::Break(()));
    let Outcome::Breakdown { cause: BreakdownCause::Stopped { residual, contact }, .. } = stopped else {
        panic!("{stopped}")
    };
    assert!(residual > 1e-12 && contact < 40);
}
