//! Rows give exactly the stated problem, bit for bit, or an error with its place.
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::doc_markdown)]

use crate::common::{Random, seeded};
use grasp_lcp::lcp::{Lcp, LcpError};
use nalgebra::{DMatrix, DVector};

fn any(random: &mut Random) -> f64 {
    let x = f64::from_bits(random.bits());
    if x.is_finite() { x } else { random.integer(-3, 3) as f64 }
}

#[test]
fn every_bit_comes_back() {
    let mut random = seeded(5);
    for n in 0..12 {
        let m = DMatrix::from_fn(n, n, |_, _| any(&mut random));
        let q = DVector::from_fn(n, |_, _| any(&mut random));
        let problem = Lcp::new(m.clone(), q.clone()).unwrap();
        let rows: Vec<Vec<f64>> = m.row_iter().map(|row| row.iter().copied().collect()).collect();
        assert_eq!(Lcp::from_rows(&rows, q.as_slice()).unwrap(), problem);
    }
}

#[test]
fn errors_name_the_place() {
    let rows: [&[f64]; 2] = [&[1.0, 2.0], &[1.0]];
    let error = Lcp::from_rows(&rows, &[0.0; 2]).unwrap_err();
    assert_eq!(error, LcpError::RowLength { row: 1, given: 1, needed: 2 });
}

#[test]
fn each_outcome_is_one_line() {
    let solve = |m: &[f64], q: &[f64]| {
        Lcp::new(DMatrix::from_row_slice(q.len(), q.len(), m), DVector::from_column_slice(q))
            .unwrap()
            .solve()
            .to_string()
    };
    let limited = grasp_lcp::lcp::Settings::default().with_max_pivots(1);
    let stopped = Lcp::from_rows(&[[1.0]], &[-1.0]).unwrap().solve_with(&limited);
    for (line, told) in [
        (solve(&[1.0], &[-1.0]), ["solved: 1 of 1 z", "residuals up to 0.0e0", "2 pivots"]),
        (solve(&[-1.0], &[-1.0]), ["infeasible, proved", "1 of 1 rows", "(1 pivots)"]),
        (solve(&[0.0, 1.0, 0.0, 1.0], &[-1.0, 0.0]), ["no solution:", "basis", "excluded"]),
        (stopped.to_string(), ["nothing known:", "stopped", "1 pivots"]),
    ] {
        let parts = told.iter().all(|part| line.contains(part));
        assert!(parts && line.starts_with(told[0]) && !line.contains('\n'), "{line}");
    }
}
