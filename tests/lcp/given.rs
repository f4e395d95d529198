//! Rows, triplets, text and JSON give the problem that they say, bit for bit, or name the place that is wrong.
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
fn messages_name_the_place() {
    let message = |error: Result<Lcp, LcpError>| error.unwrap_err().to_string();
    let rows: [&[f64]; 2] = [&[1.0, 2.0], &[1.0]];
    assert_eq!(message(Lcp::from_rows(&rows, &[0.0; 2])), "row 1 of M has 1 entries, but must have 2");
    assert_eq!(
        message(Lcp::from_triplets([(0, 2, 1.0)], &[0.0; 2])),
        "entry (0, 2) is outside of M, which has 2 rows and columns"
    );
    assert_eq!(
        message(Lcp::from_triplets([(0, 1, f64::MAX), (0, 1, f64::MAX)], &[0.0; 2])),
        "entry (0, 1) of M is inf, not a finite number"
    );
    let text = |text: &str| message(text.parse());
    assert_eq!(text("two"), "word 0 is `two`, but must be the number of pairs");
    assert_eq!(text("1\n# M\n 2\n # q\n x"), "word 2 is `x`, but must be a number");
    assert_eq!(text(""), "the text has 0 numbers, but must have 1: n, n rows of M and q");
    assert_eq!(text("1 2"), "the text has 2 numbers, but must have 3: n, n rows of M and q");
    assert_eq!(
        text("99999999999999 1"),
        format!("the text has 2 numbers, but must have {}: n, n rows of M and q", usize::MAX)
    );
    assert_eq!(text("1 2 NaN"), "entry 0 of q is NaN, not a finite number");
    let json = |text: &str| serde_json::from_str::<Lcp>(text).unwrap_err().to_string();
    assert!(json(r#"{"m": [[1, 2]], "q": [1]}"#).starts_with("row 0 of M has 2 entries, but must have 1"));
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
    assert_eq!(solve(&[1.0], &[-1.0]), "solved: 1 of 1 z basic, residuals up to 0.0e0, 2 pivots");
    assert_eq!(
        solve(&[-1.0], &[-1.0]),
        "infeasible, proved without rounding by a combination of 1 of 1 rows (1 pivots)"
    );
    assert!(
        solve(&[0.0, 1.0, 0.0, 1.0], &[-1.0, 0.0])
            .starts_with("no solution: every complementary basis is excluded")
    );
    let limited = grasp_lcp::lcp::Settings::default().with_max_pivots(1);
    let stopped = Lcp::from_rows(&[[1.0]], &[-1.0]).unwrap().solve_with(&limited);
    assert_eq!(stopped.to_string(), "nothing known: stopped after 1 pivots");
}
