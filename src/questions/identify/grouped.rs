//! Standard errors of estimates if observations of one group may share an error, by a sandwich estimator. An observation is a load, or the angle of a
//! turning load, at which slip was observed. A parameter is a number of the grasp that is estimated. A known sum is a sum of parameters that is known
//! from another measurement.
//!
//! A prime denotes the transpose. The matrix U_g has a row for each observation of group g: the derivatives of its predicted load with respect to the
//! parameters, divided by its standard deviation. The derivatives are taken along a basis of the logarithms of the parameters, chosen such that
//! `Σ U_g'U_g = 1`. Let e_g be the residuals of these observations, divided by their standard deviations, and `Q_g = U_g'U_g`. Group g contributes
//! `w_g` to the estimates. The power of `1 - Q_g` corrects for the influence of the group's own residuals on them:
//!
//! ```text
//! w_g = (1 - Q_g)^(-1/2) U_g'e_g
//! ```
//!
//! This is the correction CR2 of Bell and McCaffrey. Its matrices have the dimension of the few parameters instead of the many observations, because
//! `U'(1 - UU')^(-1/2) = (1 - U'U)^(-1/2) U'`. The variance of a parameter with the components c in this basis is `Σ (c'w_g)²`. Let
//! `a_g = (1 - Q_g)^(-1/2) c`, and `δ_gh` be 1 if g = h, else 0. If the rows were independent, the numbers `c'w_g` would have the covariances
//! `Ω_gh = δ_gh a_g'Q_g a_g - (Q_g a_g)'(Q_h a_h)`. The degrees of freedom are Satterthwaite's, `(tr Ω)² / tr Ω²`.

use nalgebra::{DMatrix, DVector};

use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, mapped, paired, summed, symmetric_eigen, vector_of};
use crate::prelude::*;

/// Groups of observations that may share an error, with the contribution of each group to the estimates and to their standard errors.
pub(super) struct Grouped {
    groups: Vec<Group>,
    /// The information matrix `U'U` of the known sums of parameters, which are in no group. The rows of U are the derivatives of these sums with
    /// respect to the parameters, each divided by the standard deviation of its sum.
    known: DMatrix<f64>,
}

/// One group of observations that may share an error.
struct Group {
    /// The information matrix `Q = U'U` of the group. The rows of U are the derivatives of the predicted loads of its observations, each divided by
    /// the standard deviation of its observation.
    tells: DMatrix<f64>,
    /// The matrix (1 - Q)^(-1/2), which corrects for the influence of the group's own residuals on the estimates.
    made_up: DMatrix<f64>,
    /// The contribution w of the group to the estimated logarithms of the parameters, corrected by the matrix `made_up`.
    moves: DVector<f64>,
}

/// The error of the estimate of one parameter, from groups.
pub(super) struct GroupedError {
    /// Variance of the estimated logarithm of the parameter.
    pub(super) variance: f64,
    /// Satterthwaite's degrees of freedom of the variance.
    pub(super) degrees: f64,
}

impl Grouped {
    /// Computes the contribution of each group. `rows` holds the derivatives of predicted loads and known sums, divided by standard deviations. They
    /// are taken along a basis of the parameters such that the columns of `rows` are orthonormal. Rows of observations come first, then those of
    /// known sums. `groups` holds the group of each observation, and `residuals` one entry for each row.
    pub(super) fn of(rows: &DMatrix<f64>, residuals: &[f64], groups: &[usize]) -> Self {
        let mut names = groups.to_vec();
        names.sort_unstable();
        names.dedup();
        let mut members = vec![Vec::new(); names.len()];
        for (slip, group) in groups.iter().enumerate() {
            if let Ok(place) = names.binary_search(group) {
                members[place].push(slip);
            }
        }
        let known: Vec<usize> = (groups.len()..rows.nrows()).list();
        let square = |those: &[usize]| {
            let own = rows.select_rows(those);
            own.tr_mul(&own)
        };
        let group = |those: &Vec<usize>| {
            let tells = square(those);
            let own = vector_of(those.len(), &|k| residuals[those[k]]);
            let made_up = inverse_root_of_rest(&tells);
            let moves = &made_up * rows.select_rows(those).tr_mul(&own);
            Group { tells, made_up, moves }
        };
        Self { groups: mapped(&members, &group), known: square(&known) }
    }

    /// The error of a parameter, which is given by its components c in the basis along which derivatives are taken. `None` if directions that one
    /// group alone determines contribute more than 1 % of the expected variance.
    pub(super) fn of_unknown(&self, unknown: &DVector<f64>) -> Option<GroupedError> {
        let sure = unknown.dot(&(&self.known * unknown));
        let variance = sure + summed(&self.groups, &|group| group.moves.dot(unknown).powi(2));
        let made_up: Vec<_> = mapped(&self.groups, &|group| &group.made_up * unknown);
        let sums: Vec<_> = paired(&self.groups, &made_up, &|(group, a)| &group.tells * a);
        // Covariance of the contributions c'w_g and c'w_h of two groups to the parameter, if the observations were independent.
        let covariance = |g: usize, h: usize| {
            let own = if g == h { made_up[g].dot(&sums[g]) } else { 0.0 };
            own - sums[g].dot(&sums[h])
        };
        let (mut expected, mut squares) = (sure, 0.0);
        for g in 0..sums.len() {
            expected += covariance(g, g);
            for h in 0..sums.len() {
                squares += covariance(g, h).powi(2);
            }
        }
        // Directions in the logarithms of the parameters that one group alone determines have no known error. If they contribute more than 1 % of the
        // expected variance, the parameter has no known error.
        let is_seen = expected >= (1.0 - 1e-2) * unknown.norm_squared();
        is_seen.then(|| GroupedError { variance, degrees: expected * expected / squares })
    }
}

/// The matrix (1 - Q)^(-1/2) for the matrix Q = Q_g of a group. Along directions that this group alone determines, Q is 1 and the inverse root is
/// infinite; zero is taken instead.
fn inverse_root_of_rest(tells: &DMatrix<f64>) -> DMatrix<f64> {
    let (values, vectors) = symmetric_eigen(tells);
    let root = |part: &f64| {
        let rest = 1.0 - part;
        if rest > NEGLIGIBLE { rest.sqrt().recip() } else { 0.0 }
    };
    let roots = DMatrix::from_diagonal(&DVector::from_vec(mapped(&values, &root)));
    &vectors * roots * vectors.transpose()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rows of derivatives `rows`, in a basis of the parameters in which their columns are orthonormal.
    fn in_directions(rows: &DMatrix<f64>) -> DMatrix<f64> {
        rows.clone().qr().q()
    }

    /// For a mean with groups of equal size, CR2 is the variance of the group means, with one degree of freedom less than groups.
    #[test]
    fn a_mean_of_equal_groups() {
        let residuals = [0.3, 0.5, 0.1, -0.2, -0.4, -0.1, 0.2, -0.3, 0.4, -0.7, 0.1, 0.1];
        let mean = residuals.iter().sum::<f64>() / 12.0;
        let residuals = residuals.map(|x| x - mean);
        let groups: Vec<usize> = (0..12).map(|k| k / 3).collect();
        let rows = DMatrix::from_element(12, 1, 12_f64.sqrt().recip());
        let found = Grouped::of(&rows, &residuals, &groups)
            .of_unknown(&DVector::from_element(1, 12_f64.sqrt().recip()));
        let means: Vec<f64> = residuals.chunks(3).map(|three| three.iter().sum::<f64>() / 3.0).collect();
        let expected = means.iter().map(|x| x * x).sum::<f64>() / 3.0 / 4.0;
        let found = found.expect("four groups tell it");
        assert!((found.variance / expected - 1.0).abs() < 1e-12, "{} {expected}", found.variance);
        assert!((found.degrees - 3.0).abs() < 1e-12, "{}", found.degrees);
    }

    /// A straight line through three uneven groups. The result is compared with the definition by matrices with a row for each observation,
    /// `V = B Σ X_g'A_g e_g e_g'A_g X_g B`. X_g are the rows of the design matrix for group g, e_g its residuals, and B the covariance of the
    /// parameters. H is the hat matrix, and `A_g = (1 - H)_gg^(-1/2)`. Satterthwaite's degrees of freedom are computed from the whole matrix `1 - H`.
    #[test]
    fn a_line_by_its_definition() {
        let groups = [0, 0, 0, 1, 1, 2, 2, 2, 2];
        let design = DMatrix::from_fn(9, 2, |k, j| if j == 0 { 1.0 } else { (k * k) as f64 / 9.0 });
        let directions = in_directions(&design);
        let rest = DMatrix::identity(9, 9) - &directions * directions.transpose();
        let vector = DVector::from_fn(9, |k, _| (1.7 * k as f64).sin());
        let residuals = &rest * vector;
        let unknown = DVector::from_vec(vec![0.4, -0.9]);
        let (mut variance, mut p) = (0.0, Vec::new());
        for group in 0..3 {
            let own: Vec<usize> = (0..9).filter(|k| groups[*k] == group).collect();
            let block = rest.select_rows(&own).select_columns(&own);
            let eigen = nalgebra::SymmetricEigen::new(block);
            let roots = DMatrix::from_diagonal(&eigen.eigenvalues.map(|x| x.sqrt().recip()));
            let root = &eigen.eigenvectors * roots * eigen.eigenvectors.transpose();
            let along = root * directions.select_rows(&own) * &unknown;
            variance += along.dot(&residuals.select_rows(&own)).powi(2);
            p.push(rest.select_columns(&own) * along);
        }
        let products = DMatrix::from_fn(3, 3, |g, h| p[g].dot(&p[h]));
        let degrees = products.trace().powi(2) / products.norm_squared();
        let found =
            Grouped::of(&directions, residuals.as_slice(), &groups).of_unknown(&unknown).expect("told");
        assert!((found.variance / variance - 1.0).abs() < 1e-9, "{} {variance}", found.variance);
        assert!((found.degrees / degrees - 1.0).abs() < 1e-9, "{} {degrees}", found.degrees);
    }

    /// Each of two groups determines one parameter alone; no error is known for such a parameter.
    #[test]
    fn what_one_group_tells_alone() {
        let rows = DMatrix::from_fn(4, 2, |k, j| if k / 2 == j { 0.5_f64.sqrt() } else { 0.0 });
        let grouped = Grouped::of(&rows, &[0.1, -0.1, 0.2, -0.2], &[0, 0, 1, 1]);
        assert!(grouped.of_unknown(&DVector::from_vec(vec![1.0, 0.0])).is_none());
    }
}
