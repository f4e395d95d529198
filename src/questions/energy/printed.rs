//! The quadratic program as the paper prints it (section 5.1), for any number of contacts, in the plane and in space.

use nalgebra::{DMatrix, DVector, SVector};

use super::program::QuadraticProgram;
use super::program_rows::ProgramRows;
use crate::contact::{LocalLaw, PolygonCone};
use crate::error::{Error, Field, LARGEST};
use crate::grasp::{Contact, Engine, Space, Stiffness, Twist, Wrench, of_axes};
use crate::numerics::{Each, Vector, numbered};
use crate::prelude::*;

/// The meaning of an equality row of the printed program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Equality {
    /// The springs of body and finger carry the same force along this axis.
    SpringContinuity {
        /// The contact.
        contact: usize,
        /// The axis of its frame, 0 for the normal.
        axis: usize,
    },
    /// The surfaces do not slip along this axis.
    Sticking {
        /// The contact.
        contact: usize,
        /// The axis of its frame, from 1.
        axis: usize,
    },
    /// The contact is kept closed.
    Closed {
        /// The contact.
        contact: usize,
    },
    /// The component of u_c along this axis is that of the object. The multiplier is minus the contact force along the axis as long as no inequality
    /// of the contact binds.
    BodyMotion {
        /// The contact.
        contact: usize,
        /// The axis of its frame, 0 for the normal.
        axis: usize,
    },
}

/// The meaning of an inequality row of the printed program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Inequality {
    /// The body's normal spring is compressed.
    BodyPushes {
        /// The contact.
        contact: usize,
    },
    /// The surfaces do not penetrate.
    NoPenetration {
        /// The contact.
        contact: usize,
    },
    /// The finger's normal spring is compressed.
    FingerPushes {
        /// The contact.
        contact: usize,
    },
    /// The force does not exceed this facet of the friction cone.
    Friction {
        /// The contact.
        contact: usize,
        /// The facet: in the plane 0 for F_t <= μ F_n, 1 for -F_t <= μ F_n; in space as in
        /// [`PolygonCone`].
        facet: usize,
    },
}

/// The quadratic program as the paper prints it (section 5.1), for any number of contacts, with the meaning of its rows and columns.
///
/// Every displacement is an unknown. With c axes per contact (n, t in the plane; n, t₁, t₂ in space) the unknowns are
///
/// ```text
/// Q   = (Q_1 … Q_N, Q_b)            Q_i = (u_c, u_d, u_e in the frame of contact i),   Q_b = the twist
/// G_i = (0, 0, -k_f u_f)            G_b = -W
/// H_i = [ k_b  -k_b   0 ;           energy of the springs ½ k_b (u_d - u_c)² + ½ k_f (u_f - u_e)², its constant
///        -k_b   k_b   0 ;           ½ k_f u_f² left out
///          0     0   k_f]
/// ```
///
/// and, with `α = k_nf/k_nb`, `β = k_tf/k_tb`, `γ = k_tb/k_nb`, contact by contact,
///
/// ```text
/// A Q = C     -u_c·n + u_d·n + α u_e·n = α u_f·n        the springs of body and finger carry the same force
///             -u_c·t + u_d·t + β u_e·t = β u_f·t
///              u_d·t - u_e·t           = 0              sticking
/// B Q >= D    (u_d - u_c)·n            >= 0             F_n >= 0, from the body's spring
///             (u_d - u_e)·n            >= -clearance    no penetration
///             -u_e·n                   >= -u_f·n        F_n >= 0, from the finger's spring
///             μ (u_d - u_c)·n ∓ γ (u_d - u_c)·t >= 0    (μ F_n ∓ F_t) / k_nb, one row a facet of the cone
/// ```
///
/// after which c rows for each contact complete A: `u_c - (displacement of the object at r_i) = 0`. Two corrections are made to the print: the last
/// diagonal entry of H_i is k_tf, and A, which is not printed, is the only matrix that fits C.
///
/// A frictionless contact has neither sticking rows nor friction rows: its surfaces slide freely. A contact that is kept closed has
/// `(u_d - u_e)·n = -clearance` among its equalities and no row against pulling. Bonded contacts, and those with infinite friction, have no friction
/// rows. With infinite friction a contact keeps its sticking row when it opens, so that it may carry F_t across a gap. If it does, the program
/// differs from [`MinimumEnergy`](super::MinimumEnergy).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct PrintedQp<const C: usize> {
    /// G, H, A, C, B, D in 3 c N + d unknowns, N contacts: displacements in m, the twist in m and rad about the origin, the cost in J.
    pub program: QuadraticProgram,
    /// The meaning of each row of A, m.
    pub equalities: Vec<Equality>,
    /// The meaning of each row of B, m.
    pub inequalities: Vec<Inequality>,
    /// `Σ ½ k_f u_f²`, J, which the printed cost omits.
    pub constant: f64,
    pub(super) contacts: usize,
    pub(super) space: Space,
}

/// The three displacements of one contact in its frame, m.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Displacements<const C: usize> {
    /// u_c, core of the body.
    pub body_core: SVector<f64, C>,
    /// u_d, surface of the body.
    pub body_surface: SVector<f64, C>,
    /// u_e, surface of the finger.
    pub finger_surface: SVector<f64, C>,
}

impl<const C: usize> PrintedQp<C> {
    /// The twist Q_b of a vector of unknowns, about the origin, m and rad.
    ///
    /// # Panics
    /// If x is not a vector of unknowns of this program.
    #[must_use]
    pub fn twist(&self, x: &DVector<f64>) -> Twist<C> {
        let own = &x.as_slice()[3 * self.space.axes() * self.contacts..];
        Twist::among(self.space, &Vector::from_slice(own))
    }

    /// The displacements Q_i of a contact from a vector of unknowns.
    ///
    /// # Panics
    /// If x is not a vector of unknowns of this program, or there is no such contact.
    #[must_use]
    pub fn displacements(&self, x: &DVector<f64>, contact: usize) -> Displacements<C> {
        let axes = self.space.axes();
        let part = |k: usize| of_axes(axes, |a| x[axes * (3 * contact + k) + a]);
        Displacements { body_core: part(0), body_surface: part(1), finger_surface: part(2) }
    }

    /// Contact force in the contact frame, N, from the spring of the body: `k_b (u_d - u_c)`.
    ///
    /// It is a difference of displacements: for a contact stiffer than the others by 10^p it has p digits less than x.
    ///
    /// # Panics
    /// As for [`Self::displacements`].
    #[must_use]
    pub fn force(&self, x: &DVector<f64>, contact: usize) -> SVector<f64, C> {
        let u = self.displacements(x, contact);
        let stretch = u.body_surface - u.body_core;
        let axes = self.space.axes();
        let of = |a: usize| 3 * axes * contact + a;
        of_axes(axes, |a| self.program.h[(of(a), of(a))] * stretch[a])
    }

    /// The force at a contact in the balance of the object, in the contact frame, N: minus the multipliers of its [`Equality::BodyMotion`] rows.
    ///
    /// As long as no inequality of the contact binds this is the contact force, as accurate as the multipliers for any stiffness. Where an inequality
    /// binds, it also contains the contribution of the constraint.
    ///
    /// # Panics
    /// If y does not belong to this program, or there is no such contact.
    #[must_use]
    pub fn force_on_object(&self, equality_multipliers: &DVector<f64>, contact: usize) -> SVector<f64, C> {
        let axes = self.space.axes();
        let first = self.equalities.len() - axes * (self.contacts - contact);
        of_axes(axes, |a| -equality_multipliers[first + a])
    }
}

impl Engine {
    /// Implements [`Energy::printed_qp`](crate::ask::Energy::printed_qp).
    pub(crate) fn printed_qp(&self, load: &Wrench<3>, cone: &PolygonCone) -> Result<PrintedQp<3>, Error> {
        self.refuse_hands("printed_qp")?;
        let problem = self.on_polygons(load, cone)?;
        let size = self.size();
        let count = size.count();
        let (space, axes) = (self.space(), self.space().axes());
        let columns = 3 * axes * self.len() + count;
        let mut written = Written {
            g: DVector::zeros(columns),
            h: DMatrix::zeros(columns, columns),
            equalities: ProgramRows::new(columns),
            inequalities: ProgramRows::new(columns),
            constant: 0.0,
        };
        for (i, (local, contact)) in problem.locals().zip(self.contacts()).enumerate() {
            let sides = both_sides(i, contact)?;
            written.springs(axes, i, &contact.command, &sides);
            written.surfaces(axes, i, &local, contact, &sides);
        }
        for (i, (site, contact)) in self.sites().iter().zip(self.contacts()).enumerate() {
            let map = space.grasp_map(size, &contact.point, &site.frame);
            for axis in 0..axes {
                let mut terms = vec![(column(axes, i, BODY_CORE, axis), 1.0)];
                terms.extend(numbered(count, &|k| (columns - count + k, -map[(k, axis)])));
                written.equalities.push_terms(Equality::BodyMotion { contact: i, axis }, terms, 0.0);
            }
        }
        let Written { mut g, h, equalities, inequalities, constant } = written;
        for (g, load) in
            g.iter_mut().skip(columns - count).zip(self.with_vacuum(load).coordinates(space).iter())
        {
            *g = -load;
        }
        let (equalities, a, c) = equalities.finish();
        let (inequalities, b, d) = inequalities.finish();
        let program = QuadraticProgram { g, h, a, c, b, d };
        Ok(PrintedQp { program, equalities, inequalities, constant, contacts: self.len(), space })
    }
}

/// Index of u_c (core of the body) among the three displacements of a contact.
const BODY_CORE: usize = 0;
/// Index of u_d (surface of the body).
const BODY_SURFACE: usize = 1;
/// Index of u_e (surface of the finger).
const FINGER_SURFACE: usize = 2;

/// The column of an unknown: one of the three displacements of a contact, along one axis.
fn column(axes: usize, contact: usize, displacement: usize, axis: usize) -> usize {
    axes * (3 * contact + displacement) + axis
}

/// The stiffnesses of the body's and the finger's springs at a contact.
fn both_sides(index: usize, contact: &Contact<3>) -> Result<[SVector<f64, 3>; 2], Error> {
    const ALLOWED: &str = "from 1e-50 to 1e50 on both sides (the paper's program has two springs a contact)";
    let fault =
        |field, value| Err(Error::Contact { contact: contact.label(index), field, value, allowed: ALLOWED });
    let (body, finger) = match &contact.stiffness {
        Stiffness::BodyAndFinger { body, finger } => (body, finger),
        Stiffness::Series(k) => return fault(Field::SeriesStiffness, k[0]),
    };
    for (field, side) in [(Field::BodyStiffness, body), (Field::FingerStiffness, finger)] {
        if let Some(&k) = side.iter().find(|k| !(1.0 / LARGEST..=LARGEST).contains(*k)) {
            return fault(field, k);
        }
    }
    Ok([*body, *finger])
}

/// The printed program while its rows are collected.
struct Written {
    g: DVector<f64>,
    h: DMatrix<f64>,
    equalities: ProgramRows<Equality>,
    inequalities: ProgramRows<Inequality>,
    constant: f64,
}

impl Written {
    /// Adds the energy of both springs of a contact, and the rows that make their forces equal.
    fn springs(
        &mut self,
        axes: usize,
        contact: usize,
        u_f: &SVector<f64, 3>,
        [body, finger]: &[SVector<f64, 3>; 2],
    ) {
        for axis in 0..axes {
            let [c, d, e] =
                [BODY_CORE, BODY_SURFACE, FINGER_SURFACE].each(|u| column(axes, contact, u, axis));
            let (k_b, k_f) = (body[axis], finger[axis]);
            (self.h[(c, c)], self.h[(d, d)], self.h[(e, e)]) = (k_b, k_b, k_f);
            (self.h[(c, d)], self.h[(d, c)]) = (-k_b, -k_b);
            self.g[e] = -k_f * u_f[axis];
            self.constant += 0.5 * k_f * u_f[axis] * u_f[axis];
            let (says, ratio) = (Equality::SpringContinuity { contact, axis }, k_f / k_b);
            self.equalities.push_terms(says, [(c, -1.0), (d, 1.0), (e, ratio)], ratio * u_f[axis]);
        }
    }

    /// Adds the rows of a contact for the relative motion of its surfaces and for its friction.
    fn surfaces(
        &mut self,
        axes: usize,
        i: usize,
        local: &LocalLaw<'_>,
        contact: &Contact<3>,
        [body, _]: &[SVector<f64, 3>; 2],
    ) {
        let [c, d, e] =
            [BODY_CORE, BODY_SURFACE, FINGER_SURFACE].each(|u| move |axis| column(axes, i, u, axis));
        let apart = |axis| [(d(axis), 1.0), (e(axis), -1.0)];
        for axis in 1..local.springs.axes() {
            self.equalities.push_terms(Equality::Sticking { contact: i, axis }, apart(axis), 0.0);
        }
        if local.may_open() {
            let rows = &mut self.inequalities;
            rows.push_terms(Inequality::BodyPushes { contact: i }, [(c(0), -1.0), (d(0), 1.0)], 0.0);
            rows.push_terms(Inequality::NoPenetration { contact: i }, apart(0), -contact.clearance);
            rows.push_terms(Inequality::FingerPushes { contact: i }, [(e(0), -1.0)], -contact.command[0]);
        } else {
            self.equalities.push_terms(Equality::Closed { contact: i }, apart(0), -contact.clearance);
        }
        for (facet, normal) in local.facets().iter().enumerate() {
            let row = local.cone().facet_row(normal).component_mul(&(body / body[0]));
            let terms = numbered(axes, &|axis| [(c(axis), -row[axis]), (d(axis), row[axis])]).concat();
            self.inequalities.push_terms(Inequality::Friction { contact: i, facet }, terms, 0.0);
        }
    }
}
