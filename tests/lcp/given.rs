//! Rows, triplets, text and JSON give exactly the stated problem, bit for bit, or an error with its place.
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::doc_markdown)]

use crate::common::{Random, seeded};
use grasp_lcp::lcp::{Lcp, LcpError, MixedLcp, Outcome};
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
        let places = (0..n * n).rev().map(|k| (k / n, k % n, m[(k / n, k % n)]));
        assert_eq!(Lcp::from_triplets(places, q.as_slice()).unwrap(), problem);
        assert_eq!(problem.to_string().parse::<Lcp>().unwrap(), problem);
        let json = serde_json::to_string(&problem).unwrap();
        assert_eq!(serde_json::from_str::<Lcp>(&json).unwrap(), problem);
    }
}

#[test]
fn entries_at_one_place_are_added() {
    let problem = Lcp::from_triplets([(0, 1, 2.0), (1, 0, 1.0), (0, 1, 0.5)], &[0.0; 2]).unwrap();
    assert_eq!(*problem.matrix(), DMatrix::from_row_slice(2, 2, &[0.0, 2.5, 1.0, 0.0]));
}

#[test]
fn errors_name_the_place() {
    let rows: [&[f64]; 2] = [&[1.0, 2.0], &[1.0]];
    let error = Lcp::from_rows(&rows, &[0.0; 2]).unwrap_err();
    assert_eq!(error, LcpError::RowLength { row: 1, given: 1, needed: 2 });
    let error = Lcp::from_triplets([(0, 2, 1.0)], &[0.0; 2]).unwrap_err();
    assert_eq!(error, LcpError::Place { row: 0, column: 2, size: 2 });
    let error = Lcp::from_triplets([(0, 1, f64::MAX), (0, 1, f64::MAX)], &[0.0; 2]).unwrap_err();
    assert_eq!(error, LcpError::MatrixEntry { what: "M", row: 0, column: 1, value: f64::INFINITY });
    let text = |text: &str| text.parse::<Lcp>().unwrap_err();
    assert!(matches!(text("two"), LcpError::Word { at: 0, word, .. } if word == "two"));
    assert!(matches!(text("1\n# M\n 2\n # q\n x"), LcpError::Word { at: 2, word, .. } if word == "x"));
    assert_eq!(text(""), LcpError::Count { given: 0, needed: 1 });
    assert_eq!(text("1 2"), LcpError::Count { given: 2, needed: 3 });
    assert_eq!(text("99999999999999 1"), LcpError::Count { given: 2, needed: usize::MAX });
    assert!(matches!(text("1 2 NaN"), LcpError::VectorEntry { what: "q", row: 0, value } if value.is_nan()));
    let json = |text: &str| serde_json::from_str::<Lcp>(text).unwrap_err().to_string();
    let length = LcpError::RowLength { row: 0, given: 2, needed: 1 }.to_string();
    assert!(json(r#"{"m": [[1, 2]], "q": [1]}"#).starts_with(&length));
    assert!(json(r#"{"m": [[1]], "q": [1], "d": 1}"#).starts_with("unknown field `d`"));
}

#[test]
fn outcomes_and_mixed_problems_are_written_too() {
    let [a, c, d, m] = [2.0, 1.0, -1.0, 0.0].map(|entry| DMatrix::from_element(1, 1, entry));
    let [b, q] = [-3.0, 1.0].map(|entry| DVector::from_element(1, entry));
    let problem = MixedLcp::new(&a, &c, &d, &m, &b, &q).unwrap();
    let json = serde_json::to_string(&problem).unwrap();
    assert_eq!(json, r#"{"a":[[2.0]],"c":[[1.0]],"d":[[-1.0]],"m":[[0.0]],"b":[-3.0],"q":[1.0]}"#);
    assert_eq!(serde_json::from_str::<MixedLcp>(&json).unwrap(), problem);
    let told = serde_json::to_value(problem.solve()).unwrap();
    assert_eq!(told["solved"]["u"], serde_json::json!([1.0]));
    assert_eq!(told["solved"]["basis"], serde_json::json!([0]));
    let hopeless = Lcp::from_rows(&[[-1.0]], &[-1.0]).unwrap().solve();
    assert!(matches!(hopeless, Outcome::Infeasible(_)));
    assert_eq!(serde_json::to_value(&hopeless).unwrap()["infeasible"]["y"], serde_json::json!([1.0]));
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
