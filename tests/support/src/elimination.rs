//! Linear equations in exact numbers, by elimination without fractions (E. H. Bareiss, Math. Comp. 22, 1968).
//!
//! Rows are scaled to integers once and stay integers, because each step divides by the previous pivot without a remainder. Fractions would be
//! reduced after every product instead.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// Equations `A x = b` for several right-hand sides b, after elimination.
#[derive(Debug)]
pub struct Eliminated {
    /// Row k contains only unknown k, if all unknowns are determined.
    rows: Vec<Vec<BigInt>>,
    unknowns: usize,
    rank: usize,
}

impl Eliminated {
    /// Eliminates rows `[A | b …]`, where A has `unknowns` columns.
    pub fn of(rows: impl IntoIterator<Item = Vec<BigRational>>, unknowns: usize) -> Self {
        Self::of_whole(rows.into_iter().map(|row| whole(&row)).collect(), unknowns)
    }

    /// Eliminates rows of integers.
    pub fn of_whole(mut rows: Vec<Vec<BigInt>>, unknowns: usize) -> Self {
        let mut before = BigInt::one();
        let mut rank = 0;
        for column in 0..unknowns {
            let Some(pivot) = (rank..rows.len()).find(|row| !rows[*row][column].is_zero()) else { continue };
            rows.swap(rank, pivot);
            let head = rows[rank].clone();
            for (_, row) in rows.iter_mut().enumerate().filter(|(k, _)| *k != rank) {
                let factor = row[column].clone();
                for (x, h) in row.iter_mut().zip(&head) {
                    *x = (&head[column] * &*x - &factor * h) / &before;
                }
            }
            before.clone_from(&head[column]);
            rank += 1;
        }
        Self { rows, unknowns, rank }
    }

    /// The solution for each b; `None` if A does not determine it.
    pub fn solutions(&self) -> Option<Vec<Vec<BigRational>>> {
        let sides = self.rows.first().map_or(0, |row| row.len() - self.unknowns);
        (0..sides).map(|side| self.unknowns_for(side)).collect()
    }

    /// The solution for the first b; `None` if A does not determine it. Without unknowns it is empty.
    pub fn solution(&self) -> Option<Vec<BigRational>> {
        self.unknowns_for(0)
    }

    fn unknowns_for(&self, side: usize) -> Option<Vec<BigRational>> {
        let unknown = |(k, row): (usize, &Vec<BigInt>)| {
            BigRational::new(row[self.unknowns + side].clone(), row[k].clone())
        };
        let determined = self.rank == self.unknowns;
        determined.then(|| self.rows[..self.unknowns].iter().enumerate().map(unknown).collect())
    }

    /// Whether the equations are consistent: rows that elimination left without unknowns have a zero right-hand side.
    pub fn is_free(&self) -> bool {
        self.rows[self.rank..].iter().flat_map(|row| &row[self.unknowns..]).all(Zero::is_zero)
    }
}

/// A row times its common denominator.
fn whole(row: &[BigRational]) -> Vec<BigInt> {
    let multiple = |common: BigInt, x: &BigRational| {
        let missing = BigRational::new(x.denom().clone(), common.clone());
        common * missing.numer()
    };
    let common = row.iter().fold(BigInt::one(), multiple);
    row.iter().map(|x| x.numer() * (&common / x.denom())).collect()
}
