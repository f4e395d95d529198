//! The most obvious quadratic program of a grasp: the twist and the gaps are unknown, everything else is eliminated. The usual method today solves it
//! again and again by an interior-point method.
//!
//! ```text
//! minimise  Σ ½ F_iᵀK_i⁻¹F_i - W·q,      F_i = K_i (a_i - G_iᵀq + e_n g_i)
//! subject to  g_i >= 0,   μ F_n - h·F_t >= 0 for every facet of the cone
//! ```

use std::f64::consts::PI;

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::{PolygonCone, PolygonFit};
use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use crate::quadratic_program::QuadraticProgram;

/// The program, whose unknowns are the twist about the origin and then a gap for each contact with finite friction.
pub struct ReducedProgram {
    /// The program; it has no equalities.
    pub program: QuadraticProgram,
    /// The contacts that have a gap, in order.
    pub gaps: Vec<usize>,
    /// The contact of each row of friction; `None` for the other rows.
    pub friction: Vec<Option<usize>>,
    /// `Σ ½ aᵀK a`, J, which the cost omits.
    pub constant: f64,
}

impl ReducedProgram {
    /// The program of a grasp whose fingers touch at first.
    pub fn new<const C: usize>(grasp: &Grasp<C>, load: &Wrench<C>, cone: &PolygonCone) -> Self {
        let commands: Vec<_> = grasp.contacts().iter().map(Contact::commanded).collect();
        Self::of(grasp, &commands, load, cone, true)
    }

    /// The program with these drives a_i, commands less clearances. With gaps contacts may open; without them the twist alone is unknown, and every
    /// contact has to push.
    pub fn of<const C: usize>(
        grasp: &Grasp<C>,
        drives: &[SVector<f64, C>],
        load: &Wrench<C>,
        cone: &PolygonCone,
        with_gaps: bool,
    ) -> Self {
        let load = load.components();
        let contacts = grasp.contacts();
        let gaps: Vec<usize> = (0..contacts.len())
            .filter(|i| with_gaps && contacts[*i].friction_coefficient().is_finite())
            .collect();
        let n = load.len() + gaps.len();
        let (mut g, mut h) = (DVector::zeros(n), DMatrix::zeros(n, n));
        g.rows_mut(0, load.len()).copy_from_slice(load);
        g.neg_mut();
        let (mut rows, mut right, mut friction) = (Vec::new(), Vec::new(), Vec::new());
        let mut constant = 0.0;
        for (i, ((contact, frame), drive)) in contacts.iter().zip(grasp.frames()).zip(drives).enumerate() {
            // Stretch of the springs: a - S x, with S = [G_iᵀ, -e_n at the gap].
            let mut s = DMatrix::zeros(C, n);
            for axis in 0..C {
                let direction = frame.column(axis).into_owned();
                for (k, g) in wrench_of(&contact.point(), &direction).into_iter().enumerate() {
                    s[(axis, k)] = g;
                }
            }
            let gap = gaps.iter().position(|j| *j == i).map(|place| load.len() + place);
            if let Some(gap) = gap {
                s[(0, gap)] = -1.0;
            }
            let stiffness = SMatrix::from_diagonal(&contact.series_stiffness_of_axes());
            let pushed = stiffness * drive;
            h += s.transpose() * stiffness * &s;
            g -= s.tr_mul(&pushed);
            constant += 0.5 * drive.dot(&pushed);
            let mut push = |law: SVector<f64, C>, of: Option<usize>| {
                rows.push(-s.tr_mul(&(stiffness * law)));
                right.push(-law.dot(&pushed));
                friction.push(of);
            };
            let mu = contact.friction_coefficient();
            if gap.is_none() {
                push(SVector::from_fn(|k, _| f64::from(u8::from(k == 0))), None);
            }
            if mu.is_finite() && mu > 0.0 {
                for mut law in facets::<C>(cone) {
                    law[0] = mu;
                    push(law, Some(i));
                }
            }
            if let Some(gap) = gap {
                let mut row = DVector::zeros(n);
                row[gap] = 1.0;
                rows.push(row);
                right.push(0.0);
                friction.push(None);
            }
        }
        let mut b = DMatrix::zeros(rows.len(), n);
        for (k, row) in rows.iter().enumerate() {
            b.set_row(k, &row.transpose());
        }
        let program = QuadraticProgram {
            g,
            h,
            a: DMatrix::zeros(0, n),
            c: DVector::zeros(0),
            b,
            d: DVector::from_vec(right),
        };
        Self { program, gaps, friction, constant }
    }
}

/// The force along a direction at a point as a wrench about the origin.
pub(crate) fn wrench_of<const C: usize>(point: &SVector<f64, C>, direction: &SVector<f64, C>) -> Vec<f64> {
    let (p, f) = (point.as_slice(), direction.as_slice());
    let moment = |a: usize, b: usize| p[a] * f[b] - p[b] * f[a];
    let mut wrench = f.to_vec();
    if C == 2 {
        wrench.push(moment(0, 1));
    } else {
        wrench.extend([moment(1, 2), moment(2, 0), moment(0, 1)]);
    }
    wrench
}

/// The facets -h of the cone in the frame of a contact, with normal component zero.
pub(crate) fn facets<const C: usize>(cone: &PolygonCone) -> Vec<SVector<f64, C>> {
    if C == 2 {
        return [1.0, -1.0].map(|sign| SVector::from_fn(|k, _| if k == 1 { -sign } else { 0.0 })).to_vec();
    }
    let m = cone.facets();
    let half = PI / m as f64;
    let distance = match cone.fit() {
        PolygonFit::Inscribed => half.cos(),
        PolygonFit::Circumscribed => 1.0,
        _ => half.cos().sqrt(),
    };
    let facet = |j: usize| {
        let (sin, cos) = ((2.0 * j as f64 - 1.0) * half).sin_cos();
        SVector::from_fn(|k, _| [0.0, -cos / distance, -sin / distance][k])
    };
    (0..m).map(facet).collect()
}
