//! Problems can be read in the three forms of files that Siconos writes.

use nalgebra::{DMatrix, DVector};
use support::siconos::{Error, ReadProblem};

/// Two planar contacts with a nonsymmetric W, so that an exchange of rows and columns is detected.
fn expected() -> (DMatrix<f64>, DVector<f64>) {
    let w = DMatrix::from_row_slice(
        4,
        4,
        &[2.0, 0.5, -1.0, 0.0, 0.25, 3.0, 0.0, 0.0, -1.0, 0.0, 4.0, 0.125, 0.0, 0.0, 0.75, 5.0],
    );
    (w, DVector::from_vec(vec![-1.0, 0.5, -2.0, 0.25]))
}

fn check(text: &str) {
    let ReadProblem::Planar(problem) = ReadProblem::from_siconos(text).expect("well formed") else {
        panic!("two components")
    };
    let (w, q) = expected();
    assert_eq!((problem.matrix(), problem.vector(), problem.friction()), (&w, &q, &[0.5, 0.25][..]));
}

#[test]
fn a_dense_matrix_goes_down_its_columns() {
    check(
        "2\n2\n0\n4\n4\n4\t4\n 2 .25 -1 0\n .5 3 0 0\n -1 0 4 .75\n 0 0 .125 5\n -1 .5 -2 .25\n .5 .25\n1\n",
    );
}

#[test]
fn blocks_go_down_their_columns_too() {
    let blocks = "0\n2 .25 .5 3\n1\n-1 0 0 0\n2\n-1 0 0 0\n3\n4 .75 .125 5\n";
    check(&format!(
        "2\n2\n1\n4\n4\n4\n2\n2\n2 4\n2 4\n3\n4\n0 2 4\n0 1 0 1\n{blocks} -1 .5 -2 .25\n.5 .25\n"
    ));
}

#[test]
fn a_sparse_matrix_is_that_of_csparse() {
    let head = "CSparse Version 3.1.9, May 4, 2016.  Copyright (c) Timothy A. Davis, 2006-2016\n";
    let rest = " -1 .5 -2 .25\n.5 .25\n";
    let columns = "    col 0 : locations 0 to 2\n      0 : 2\n      1 : .25\n      2 : -1\n    col 1 : locations 3 to 4\n      0 : .5\n      1 : 3\n    \
                   col 2 : locations 5 to 7\n      0 : -1\n      2 : 4\n      3 : .75\n    col 3 : locations 8 to 9\n      2 : .125\n      3 : 5\n";
    check(&format!("2\n2\n2\n4\n4\n2\n{head}4-by-4, nzmax: 10 nnz: 10, 1-norm: 6\n{columns}{rest}"));
    let triplets = "0 0 : 2\n1 0 : .25\n2 0 : -1\n0 1 : .5\n1 1 : 3\n0 2 : -1\n2 2 : 4\n3 2 : .75\n2 3 : .125\n3 3 : 5\n";
    check(&format!("2\n2\n2\n4\n4\n1\n{head}triplet: 4-by-4, nzmax: 10 nnz: 10\n{triplets}{rest}"));
}

#[test]
fn errors_name_the_word() {
    // For each text: the position of the faulty word, the word itself, and a part of the message.
    for (text, place, found, needed) in [
        ("4 1 0 4 4", 1, Some("4"), "components, 2 or 3"),
        ("3 1 0 3 3 3 3 1 0", 10, None, "an entry"),
        ("3 1 7 3 3", 3, Some("7"), "2 (sparse)"),
        ("3 2 0 3 3", 4, Some("3"), "rows or columns"),
        ("3 1 0 3 3 3 3 1 0 0 0 1 0 0 0 one", 16, Some("one"), "an entry"),
        // A large number in the file does not cause a large allocation.
        ("3 40000 0 120000 120000", 5, Some("120000 120000"), "fits into memory"),
    ] {
        let error = ReadProblem::from_siconos(text).unwrap_err();
        let Error::Word { at, word, allowed } = &error else { panic!("{error}") };
        assert_eq!((*at, word.as_deref()), (place, found), "{error}");
        assert!(allowed.contains(needed), "{error}");
    }
    for cut in 0..40 {
        let text =
            "2 2 1 4 4 4 2 2 2 4 2 4 3 4 0 2 4 0 1 0 1 0 2 .25 .5 3 1 -1 0 0 0 2 -1 0 0 0 3 4 .75 .125 5";
        let words: Vec<&str> = text.split_whitespace().take(cut).collect();
        assert!(ReadProblem::from_siconos(&words.join(" ")).is_err());
    }
}
