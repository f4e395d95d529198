//! The quadratic program as the paper prints it (section 5.1), for any number of contacts, in the plane and in space.

use grasp_lcp::PolygonCone;
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Hold, Wrench};
use nalgebra::{DMatrix, DVector, SVector};

use crate::quadratic_program::QuadraticProgram;
use crate::reduced_program::{facets, wrench_of};

/// The meaning of an equality row of the printed program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Equality {
    /// The springs of body and finger carry the same force along this axis.
    SpringContinuity {
        /// Index of the contact.
        contact: usize,
        /// Axis of the contact frame: 0 for the normal, then the tangents.
        axis: usize,
    },
    /// The surfaces do not slip along this axis.
    Sticking {
        /// Index of the contact.
        contact: usize,
        /// Axis of the contact frame: a tangent, from 1.
        axis: usize,
    },
    /// The contact is kept closed.
    Closed {
        /// Index of the contact.
        contact: usize,
    },
    /// The component of u_c along this axis is the component of the object's motion. The multiplier is minus the contact force along the axis as long
    /// as no inequality of the contact binds.
    BodyMotion {
        /// Index of the contact.
        contact: usize,
        /// Axis of the contact frame: 0 for the normal, then the tangents.
        axis: usize,
    },
}

/// The meaning of an inequality row of the printed program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Inequality {
    /// The body's normal spring is compressed.
    BodyPushes {
        /// Index of the contact.
        contact: usize,
    },
    /// The surfaces do not penetrate.
    NoPenetration {
        /// Index of the contact.
        contact: usize,
    },
    /// The finger's normal spring is compressed.
    FingerPushes {
        /// Index of the contact.
        contact: usize,
    },
    /// The force does not exceed this facet of the friction cone.
    Friction {
        /// Index of the contact.
        contact: usize,
        /// The facet: in the plane 0 for F_t <= μ F_n, 1 for -F_t <= μ F_n; in space as in [`PolygonCone`].
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
/// `(u_d - u_e)·n = -clearance` among its equalities and no row against pulling. Bonded contacts, and contacts with infinite friction, have no
/// friction rows. With infinite friction a contact keeps its sticking row when it opens, so that it may carry F_t across a gap. If it does, the
/// program differs from `MinimumEnergy`.
#[derive(Debug, Clone, PartialEq)]
pub struct PrintedProgram<const C: usize> {
    /// G, H, A, C, B, D in 3 c N + d unknowns, N contacts: displacements in m, the twist in m and rad about the origin, the cost in J.
    pub program: QuadraticProgram,
    /// The meaning of each row of A, m.
    pub equalities: Vec<Equality>,
    /// The meaning of each row of B, m.
    pub inequalities: Vec<Inequality>,
    /// `Σ ½ k_f u_f²`, J, which the printed cost omits.
    pub constant: f64,
    contacts: usize,
}

/// The three displacements of one contact in its frame, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Displacements<const C: usize> {
    /// u_c, core of the body.
    pub body_core: SVector<f64, C>,
    /// u_d, surface of the body.
    pub body_surface: SVector<f64, C>,
    /// u_e, surface of the finger.
    pub finger_surface: SVector<f64, C>,
}

/// The data of a contact that the printed program needs, but [`Contact`](grasp_lcp::grasp::Contact) does not give.
#[derive(Debug, Clone, Copy)]
pub struct PrintedContact<const C: usize> {
    /// Stiffness of the body's spring along each axis, N/m.
    pub body: SVector<f64, C>,
    /// Stiffness of the finger's spring along each axis, N/m.
    pub finger: SVector<f64, C>,
    /// The gap between the surfaces at first, m.
    pub clearance: f64,
    /// Whether the contact may open and slip.
    pub hold: Hold,
}

impl<const C: usize> PrintedContact<C> {
    /// A contact that touches at first and may open.
    pub fn of(body: SVector<f64, C>, finger: SVector<f64, C>) -> Self {
        Self { body, finger, clearance: 0.0, hold: Hold::Unilateral }
    }
}

impl<const C: usize> PrintedProgram<C> {
    /// The program of a grasp under a load; its contacts are described by `contacts`, in their order.
    pub fn of(
        grasp: &Grasp<C>,
        contacts: &[PrintedContact<C>],
        load: &Wrench<C>,
        cone: &PolygonCone,
    ) -> Self {
        let load = load.components();
        let columns = 3 * C * contacts.len() + load.len();
        let (mut g, mut h, mut constant) = (DVector::zeros(columns), DMatrix::zeros(columns, columns), 0.0);
        let (mut equalities, mut inequalities) = (Rows::new(columns), Rows::new(columns));
        for (i, (contact, printed)) in grasp.contacts().iter().zip(contacts).enumerate() {
            let at = |displacement: usize| move |axis: usize| C * (3 * i + displacement) + axis;
            let (c, d, e) = (at(0), at(1), at(2));
            let command = contact.commanded();
            for axis in 0..C {
                let (k_b, k_f, u_f) = (printed.body[axis], printed.finger[axis], command[axis]);
                (h[(c(axis), c(axis))], h[(d(axis), d(axis))], h[(e(axis), e(axis))]) = (k_b, k_b, k_f);
                (h[(c(axis), d(axis))], h[(d(axis), c(axis))]) = (-k_b, -k_b);
                g[e(axis)] = -k_f * u_f;
                constant += 0.5 * k_f * u_f * u_f;
                let (says, ratio) = (Equality::SpringContinuity { contact: i, axis }, k_f / k_b);
                equalities.push(says, &[(c(axis), -1.0), (d(axis), 1.0), (e(axis), ratio)], ratio * u_f);
            }
            let mu = contact.friction_coefficient();
            let apart = |axis| [(d(axis), 1.0), (e(axis), -1.0)];
            if mu > 0.0 || printed.hold == Hold::Bonded {
                for axis in 1..C {
                    equalities.push(Equality::Sticking { contact: i, axis }, &apart(axis), 0.0);
                }
            }
            if printed.hold == Hold::Unilateral {
                let rows = &mut inequalities;
                rows.push(Inequality::BodyPushes { contact: i }, &[(c(0), -1.0), (d(0), 1.0)], 0.0);
                rows.push(Inequality::NoPenetration { contact: i }, &apart(0), -printed.clearance);
                rows.push(Inequality::FingerPushes { contact: i }, &[(e(0), -1.0)], -command[0]);
            } else {
                equalities.push(Equality::Closed { contact: i }, &apart(0), -printed.clearance);
            }
            if printed.hold != Hold::Bonded && mu > 0.0 && mu.is_finite() {
                for (facet, mut row) in facets::<C>(cone).into_iter().enumerate() {
                    row[0] = mu;
                    let row = row.component_mul(&(printed.body / printed.body[0]));
                    let terms: Vec<_> =
                        (0..C).flat_map(|axis| [(c(axis), -row[axis]), (d(axis), row[axis])]).collect();
                    inequalities.push(Inequality::Friction { contact: i, facet }, &terms, 0.0);
                }
            }
        }
        for (i, (contact, frame)) in grasp.contacts().iter().zip(grasp.frames()).enumerate() {
            for axis in 0..C {
                let map = wrench_of(&contact.point(), &frame.column(axis).into_owned());
                let mut terms = vec![(C * 3 * i + axis, 1.0)];
                terms.extend(map.iter().enumerate().map(|(k, g)| (columns - map.len() + k, -g)));
                equalities.push(Equality::BodyMotion { contact: i, axis }, &terms, 0.0);
            }
        }
        for (g, load) in g.iter_mut().skip(columns - load.len()).zip(load) {
            *g = -load;
        }
        let (equalities, a, c) = equalities.finish();
        let (inequalities, b, d) = inequalities.finish();
        let program = QuadraticProgram { g, h, a, c, b, d };
        Self { program, equalities, inequalities, constant, contacts: contacts.len() }
    }

    /// The twist Q_b of a vector of unknowns, about the origin, m and rad.
    pub fn twist<'x>(&self, x: &'x DVector<f64>) -> &'x [f64] {
        &x.as_slice()[3 * C * self.contacts..]
    }

    /// The displacements Q_i of a contact from a vector of unknowns.
    pub fn displacements(&self, x: &DVector<f64>, contact: usize) -> Displacements<C> {
        let part = |k: usize| SVector::from_fn(|a, _| x[C * (3 * contact + k) + a]);
        Displacements { body_core: part(0), body_surface: part(1), finger_surface: part(2) }
    }

    /// Contact force in the contact frame, N, from the spring of the body: `k_b (u_d - u_c)`.
    ///
    /// The force is computed from a difference of displacements. For a contact stiffer than the others by 10^p it has p digits less than x.
    pub fn force(&self, x: &DVector<f64>, contact: usize) -> SVector<f64, C> {
        let u = self.displacements(x, contact);
        let stretch = u.body_surface - u.body_core;
        let of = |a: usize| 3 * C * contact + a;
        SVector::from_fn(|a, _| self.program.h[(of(a), of(a))] * stretch[a])
    }

    /// The force at a contact in the balance of the object, in the contact frame, N: minus the multipliers of its [`Equality::BodyMotion`] rows.
    ///
    /// As long as no inequality of the contact binds this is the contact force, as accurate as the multipliers for any stiffness. Where an inequality
    /// binds, it also contains the contribution of the constraint.
    pub fn force_on_object(&self, equality_multipliers: &DVector<f64>, contact: usize) -> SVector<f64, C> {
        let first = self.equalities.len() - C * (self.contacts - contact);
        SVector::from_fn(|a, _| -equality_multipliers[first + a])
    }
}

/// Rows of a program in `columns` unknowns, collected one by one with their meaning.
struct Rows<Says> {
    columns: usize,
    says: Vec<Says>,
    entries: Vec<f64>,
    right: Vec<f64>,
}

impl<Says> Rows<Says> {
    fn new(columns: usize) -> Self {
        Self { columns, says: Vec::new(), entries: Vec::new(), right: Vec::new() }
    }

    /// Appends a row given by its non-zero entries, each with its column.
    fn push(&mut self, says: Says, terms: &[(usize, f64)], right: f64) {
        let first = self.entries.len();
        self.entries.resize(first + self.columns, 0.0);
        for (column, value) in terms {
            self.entries[first + column] += value;
        }
        self.says.push(says);
        self.right.push(right);
    }

    /// The meanings of the rows, their matrix, and their right-hand sides.
    fn finish(self) -> (Vec<Says>, DMatrix<f64>, DVector<f64>) {
        let matrix = DMatrix::from_row_slice(self.right.len(), self.columns, &self.entries);
        (self.says, matrix, DVector::from_vec(self.right))
    }
}
