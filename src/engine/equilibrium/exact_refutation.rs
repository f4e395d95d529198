//! Checks a case-by-case proof of no equilibrium ([`Refutation`](super::Refutation)) in exact rational arithmetic, on the numbers of the problem.
//!
//! A case restricts the state of each contact by a label. Its proof is a virtual motion of the object with virtual contact forces. These forces are
//! first made to balance one another exactly, by changing six of their components. The gain of the case is the work of these forces along the offsets
//! (commanded displacements of fingers minus clearances), minus the work of the load along the motion. The gain must be positive.
//!
//! In each case the contact law is relaxed to a convex cone: a polygon around an arc of friction directions replaces the arc. For each generator of
//! this cone, the virtual work divided by the generator's norm must not exceed a bound. The bound is the gain divided by [`ESCAPE`] (1e4) and by the
//! norm of the elastic trial, the solution in which every contact sticks. Norms are those of stretches and forces in energy units, √J. Rounding can
//! then hide from the proof only an equilibrium with at least [`ESCAPE`] times the norm of the elastic trial.

use core::f64::consts::FRAC_PI_8;

use nalgebra::SVector;
use num_rational::BigRational;
use num_traits::{FromPrimitive, One, Signed, Zero};

use crate::contact::{Label, LocalLaw, Sector};
use crate::grasp::{Contact, Engine, Site, Wrench};
use crate::numerics::{Vector, every_index};
use crate::object::Problem;
use crate::prelude::*;
use crate::proofs::{ESCAPE, ProofStep, check};
use crate::search::{Settings, refute};

type Rational = BigRational;

fn exact(x: f64) -> Rational {
    Rational::from_f64(x).expect("finite")
}

fn dot(a: &[Rational], b: &[Rational]) -> Rational {
    a.iter().zip(b).fold(Rational::zero(), |sum, (a, b)| sum + a * b)
}

/// Data of one contact as exact rational numbers.
struct Exact {
    /// The columns of the contact's grasp map.
    map: [[Rational; 6]; 3],
    stiffness: [Rational; 3],
    friction: Rational,
    offset: [Rational; 3],
}

impl Exact {
    fn new((site, local): (&Site, LocalLaw<'_>), offset: &SVector<f64, 3>) -> Self {
        let entry =
            |k: usize, axis: usize| exact(site.map[(k, axis)]) + exact(site.map_rounding_error[(k, axis)]);
        let axes = |x: &SVector<f64, 3>| core::array::from_fn(|axis| exact(x[axis]));
        Self {
            map: core::array::from_fn(|axis| core::array::from_fn(|k| entry(k, axis))),
            stiffness: axes(&local.springs.force(&SVector::repeat(1.0))),
            friction: exact(local.cone().limit(1.0)),
            offset: axes(offset),
        }
    }

    /// Generators of the convex cone to which the contact law is relaxed. Each is a pair of vectors, N: the stretches of the contact's springs times
    /// their stiffnesses, and the contact force. `label` restricts the state of the contact in the present case. The contact must have finite
    /// friction and must be able to open.
    fn generators(&self, label: &Label) -> Vec<[[Rational; 3]; 2]> {
        let zero = Rational::zero;
        let none = || [zero(), zero(), zero()];
        let along = |axis: usize, length: i64| {
            let mut vector = none();
            vector[axis] = Rational::from_integer(length.into());
            vector
        };
        let slips_anyhow = || (1..3).flat_map(|axis| [1, -1].map(|sign| [along(axis, sign), none()]));
        let on_cone = |p: &[Rational; 2]| [Rational::one(), &self.friction * &p[0], &self.friction * &p[1]];
        let slip = |p: &[Rational; 2]| [zero(), &self.stiffness[1] * &p[0], &self.stiffness[2] * &p[1]];
        let mut list = Vec::new();
        if matches!(label, Label::Anything | Label::Open) {
            list.push([along(0, -1), none()]);
            list.extend(slips_anyhow());
        }
        match label {
            Label::Open => {}
            Label::Anything | Label::Closed => {
                let whole = around(-core::f64::consts::PI, core::f64::consts::PI);
                list.extend(whole.iter().map(|p| [along(0, 1), on_cone(p)]));
                list.extend(slips_anyhow());
            }
            Label::Friction(Sector { from, to })
            | Label::Sticking(Sector { from, to })
            | Label::Sliding(Sector { from, to }) => {
                for p in &around(*from, *to) {
                    list.push([on_cone(p), on_cone(p)]);
                    if !matches!(label, Label::Sticking(_)) {
                        list.push([slip(p), none()]);
                    }
                }
                if !matches!(label, Label::Sliding(_)) {
                    list.push([along(0, 1), along(0, 1)]);
                }
            }
        }
        list
    }
}

/// Corners of a polygon around the arc of the unit circle between two angles. The polygon has twice as many sides as the polygon of the proof, so
/// that it lies closer to the arc.
fn around(from: f64, to: f64) -> Vec<[Rational; 2]> {
    let pieces = (1..16).find(|k| to - from <= FRAC_PI_8 * f64::from(*k)).unwrap_or(16);
    let half = 0.25 * (to - from) / f64::from(pieces);
    let point = |angle: f64, reach: f64| {
        let (sin, cos) = angle.sin_cos();
        // The corners are moved outwards by the fraction 1e-15, more than the rounding errors of sines and cosines, so that the polygon surely
        // contains the arc.
        [cos, sin].map(|x| exact(x * reach * (1.0 + 1e-15)))
    };
    let corner = |k: i32| point(from + f64::from(2 * k + 1) * half, 1.0 / half.cos());
    (0..2 * pieces).map(corner).chain([point(from, 1.0), point(to, 1.0)]).collect()
}

/// Virtual contact forces that balance one another exactly. They differ from the given `forces` in six components, found by Gaussian elimination of
/// the six equations of equilibrium.
fn balanced(contacts: &[Exact], forces: &[SVector<f64, 3>]) -> Vec<Rational> {
    let mut forces: Vec<Rational> = forces.iter().flat_map(|f| f.iter().map(|x| exact(*x))).collect();
    let column = |j: usize| &contacts[j / 3].map[j % 3];
    let mut rows: Vec<Vec<Rational>> = (0..6)
        .map(|k| {
            let mut row: Vec<Rational> = (0..forces.len()).map(|j| column(j)[k].clone()).collect();
            let left = dot(&row, &forces);
            row.push(-left);
            row
        })
        .collect();
    let mut pivots = Vec::new();
    for k in 0..6 {
        let size = |j: &usize| rows[k][*j].abs();
        let pivot = (0..forces.len()).max_by_key(size).expect("columns");
        let row: Vec<Rational> = rows[k].iter().map(|x| x / &rows[k][pivot]).collect();
        for (other, target) in rows.iter_mut().enumerate() {
            let factor = if other == k { Rational::zero() } else { target[pivot].clone() };
            for (x, y) in target.iter_mut().zip(&row) {
                *x -= &factor * y;
            }
        }
        rows[k] = row;
        pivots.push(pivot);
    }
    for (row, pivot) in rows.iter().zip(pivots) {
        forces[pivot] += row.last().expect("a right side");
    }
    forces
}

/// Whether a virtual motion and virtual contact forces contradict a case in exact arithmetic. The case is given by a label for each contact, which
/// restricts its state. `data` is the norm of the elastic trial, √J.
fn is_contradicted(
    problem: &Problem,
    contacts: &[Exact],
    labels: &[Label],
    (motion, forces): (&Vector, &[SVector<f64, 3>]),
    data: &Rational,
) -> bool {
    let motion: Vec<Rational> = motion.iter().map(|x| exact(*x)).collect();
    let forces = balanced(contacts, forces);
    let load: Vec<Rational> =
        (0..6).map(|k| exact(problem.wrench[k]) + exact(problem.wrench_rounding_error[k])).collect();
    let parts = || contacts.iter().zip(forces.chunks(3));
    let work = parts().fold(Rational::zero(), |sum, (contact, f)| sum + dot(f, &contact.offset));
    let gain = work - dot(&motion, &load);
    // The virtual contact forces now balance one another exactly.
    let sum =
        |k: usize| parts().flat_map(|(c, f)| (0..3).map(move |a| &c.map[a][k] * &f[a])).sum::<Rational>();
    assert!(every_index(6, &|k| sum(k).is_zero()));
    let most = &gain / (exact(ESCAPE) * data);
    gain.is_positive()
        && parts().zip(labels).all(|((contact, f), label)| {
            let give: Vec<Rational> = f.iter().zip(&contact.stiffness).map(|(f, k)| f / k).collect();
            let moved = contact.map.each_ref().map(|column| dot(column, &motion));
            contact.generators(label).iter().all(|[xi, force]| {
                let work = dot(&give, xi) + dot(&moved, force);
                let stored = |x: &[Rational; 3]| {
                    x.iter().zip(&contact.stiffness).fold(Rational::zero(), |sum, (x, k)| sum + x * x / k)
                };
                !work.is_positive() || &work * &work <= &most * &most * (stored(xi) + stored(force))
            })
        })
}

/// Three fingers with different normals and commands around a jar, which is pulled with more force than they can hold.
fn jar(shift: f64, load: [f64; 3]) -> (Engine, Wrench<3>) {
    let finger = |k: f64| {
        let (sin, cos) = (2.0 * k + shift).sin_cos();
        Contact::new([cos, sin, 0.1 * k], [-cos, -sin, 0.05 * k])
            .series_stiffness(1024.0, 512.0)
            .friction(0.5)
            .command([0.01 + 0.001 * k, 0.0, 0.0])
    };
    (Engine::new([0.0, 1.0, 2.0].map(finger).to_vec()).expect("three fingers"), Wrench::<3>::force(load))
}

#[test]
fn every_leaf_is_contradicted_in_exact_arithmetic() -> Result<(), crate::Error> {
    let settings = Settings::default();
    let (mut leaves, mut deep) = (0, 0);
    for (shift, load) in [(0.0, [0.0, 0.0, -20.0]), (0.2, [-5.0, 6.0, 19.0])] {
        let (grasp, load) = jar(shift, load);
        let problem = grasp.problem_under(&load, &settings)?;
        let (steps, cases) = refute(&problem, &settings).expect("too heavy");
        let escape = check(&problem, &steps).expect("a proof");
        let laws = problem.sites.iter().zip(problem.locals()).zip(&problem.offsets);
        let contacts: Vec<_> = laws.map(|(law, offset)| Exact::new(law, offset)).collect();
        // As in `check`, the norm of the elastic trial is the square root of twice its spring energy.
        let trial = problem.trial();
        let state = trial.solve(problem.sites, &problem.offsets, problem.load()).expect("it is held");
        let stored = problem.sites.iter().zip(&state.forces).map(|(s, f)| 2.0 * s.springs.stored(f));
        let data = exact(stored.sum::<f64>().sqrt());

        // The grasp holds a quarter of the load, so that no proof exists under this smaller load. The steps of the proof must then fail: the test
        // thus shows that the check can reject a proof.
        let (held, mut weak) = (grasp.problem_under(&(load * 0.25), &settings)?, 0);
        let mut open = vec![problem.each(|local| local.first_label())];
        for step in &steps {
            let labels = open.pop().expect("a case for every step");
            match step {
                ProofStep::Divided { contact, halves } => {
                    for half in halves {
                        let mut labels = labels.clone();
                        labels[*contact] = *half;
                        open.push(labels);
                    }
                }
                ProofStep::Contradicted { motion, forces } => {
                    leaves += 1;
                    assert!(
                        is_contradicted(&problem, &contacts, &labels, (motion, forces), &data),
                        "{labels:?} {escape:e}"
                    );
                    let proof = (motion, &forces[..]);
                    weak += usize::from(!is_contradicted(&held, &contacts, &labels, proof, &data));
                }
            }
        }
        assert!(open.is_empty() && weak > 0, "{weak}");
        deep = deep.max(cases);
    }
    println!("{leaves} leaves, at most {deep} cases");
    assert!(leaves > 50 && deep > 30, "{leaves} {deep}");
    Ok(())
}
