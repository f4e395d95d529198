//! Exact derivatives of an equilibrium in its present states, and of the onset of sliding.
//!
//! In known states the law is linear, `F_i = K_i (a_i - G_iᵀq)` with K_i depending on stiffness, friction and state, so a small
//! change of any datum p leads to one more solve on the same piece:
//!
//! ```text
//! dF_i = K_i (da_i - G_iᵀdq) + f_i,   f_i = (∂K_i/∂p) v_i,      Σ G_i dF_i + dW = 0
//! friction     sliding:  f = F_n p (the unit edge p)             rolling: 0
//! stiffness    normal:   f = (e_n + μ p) F_n / k_n               tangential: f = e_a F_a/k_a less its part across the facet
//! ```
//!
//! The stretches v are taken as F/k, so that no difference of large displacements is needed.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector, SVector};

use super::onset::OnsetEvent;
use super::ramp::Ramp;
use crate::contact::{Mode, Polygon, State, tangential};
use crate::equilibrium::{Cone, Equilibrium};
use crate::grasp::{Grasp, HandPart, Twist, Wrench};
use crate::object::{Load, Piece, Problem, least_combination};
use crate::search::Settings;

/// One datum of a grasp or its load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Parameter {
    /// Coefficient of friction of a contact.
    Friction {
        /// The contact, from 0.
        contact: usize,
    },
    /// Series stiffness of a contact, N/m.
    Stiffness {
        /// The contact, from 0.
        contact: usize,
        /// The axis of its frame: 0 normal, then the tangents.
        axis: usize,
    },
    /// Finger command of a contact, m. (A clearance is a normal command of the opposite sign.)
    Command {
        /// The contact, from 0.
        contact: usize,
        /// The axis of its frame: 0 normal, then the tangents.
        axis: usize,
    },
    /// Command of a joint of the hand or, behind the joints, of a tendon, rad or m.
    JointCommand {
        /// The joint, from 0, finger by finger; tendons follow.
        joint: usize,
    },
    /// Stiffness of the own spring of a joint or of a tendon, N m/rad or N/m.
    JointStiffness {
        /// The joint, from 0, finger by finger; tendons follow.
        joint: usize,
    },
    /// Limit of a joint or of a tendon, N m or N.
    JointLimit {
        /// The joint, from 0, finger by finger; tendons follow.
        joint: usize,
    },
    /// Component of the load: forces first (N), then moments about the origin (N m), then torques on joints.
    Load {
        /// The component, from 0.
        component: usize,
    },
}

/// Derivatives of an equilibrium by one parameter, as long as every contact keeps its state. Per unit of the parameter: friction 1, stiffness
/// N/m, command m, load N or N m.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Derivative<const D: usize, const C: usize> {
    /// Of the twist, m and rad per unit of the parameter; of least norm where motions are free.
    pub twist: Twist<D, C>,
    /// Of the contact forces in the contact frames, N per unit of the parameter, in the order of the grasp.
    pub forces: Vec<SVector<f64, C>>,
}

/// Response of an equilibrium of n contacts to the finger commands, as long as every contact keeps its state: the matrices of position
/// control, the paper's aim. Columns: the commands, contact by contact, axis by axis (m); column `c i + a` is axis a of contact i. Of a
/// [response to joint commands](Grasp::joint_response): joint by joint, then tendon by tendon (rad, m).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Response {
    /// dq/da, `d x (n c)`: twist about the origin, translation first; 1 and rad/m.
    pub twist: DMatrix<f64>,
    /// dF/da, `(n c)` rows, N/m: contact forces in the contact frames, contact by contact, axis by axis.
    pub forces: DMatrix<f64>,
}

/// Derivatives of the load factor (without unit) at which one contact leaves rolling.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct OnsetGradient<const D: usize, const C: usize> {
    /// What leaves: a contact, or a drive of a hand. Where several leave together the onset is the least of their factors: its one-sided derivative along
    /// a change of the data is the least of theirs.
    pub leaving: Leaver,
    /// By every contact's coefficient of friction.
    pub friction: Vec<f64>,
    /// By every contact's series stiffness, axis by axis, m/N.
    pub stiffness: Vec<SVector<f64, C>>,
    /// By every contact's command in its contact frame, axis by axis, 1/m.
    pub command: Vec<SVector<f64, C>>,
    /// By the commands of the joints of a hand, then of its tendons, 1/rad or 1/m.
    pub joint_command: Vec<f64>,
    /// By the stiffnesses of their own springs, rad/(N m) or m/N.
    pub joint_stiffness: Vec<f64>,
    /// By their limits, 1/(N m) or 1/N.
    pub joint_limit: Vec<f64>,
    /// By the components of the base load, 1/N and 1/(N m); those by the load direction are the factor times these. Not a number
    /// where a component works on a motion that nothing resists: with such a load there is no equilibrium.
    pub base_load: SVector<f64, D>,
}

/// What leaves at an onset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Leaver {
    /// A contact, from 0.
    Contact(usize),
    /// A drive of a hand.
    Drive(HandPart),
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// How an equilibrium of this grasp changes with one parameter while every contact keeps its state: one linear solve, exact.
    /// On a load path what has slipped so far stays. `None` if an index is out of range, if the equilibrium has another number of
    /// contacts, or if the change has no equilibrium in these states (a load on a free motion).
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::load_path::Parameter;
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let outcome = grasp.solve(&Wrench::force([0.0, -4.0]))?;
    /// let held = outcome.equilibrium().expect("holds");
    /// let by_weight = grasp.sensitivity(held, Parameter::Load { component: 1 }).expect("a component");
    /// assert!((by_weight.twist.translation()[1] - 1.0 / 1600.0).abs() < 1e-15); // two springs of 800 N/m
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn sensitivity(&self, equilibrium: &Equilibrium<D, C>, by: Parameter) -> Option<Derivative<D, C>> {
        let local = Local::new(self, equilibrium)?;
        let (twist, mut forces) = local.derivative(by)?;
        forces.truncate(self.len());
        Some(Derivative { twist: self.outside(&twist), forces })
    }

    /// How an equilibrium of this grasp answers to its finger commands while every contact keeps its state: one linear solve for each axis
    /// of each contact. `None` if the equilibrium has another number of contacts, or if a command has no equilibrium in these states.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Twist, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let outcome = grasp.solve(&Wrench::force([0.0, -4.0]))?;
    /// let response = grasp.response(outcome.equilibrium().expect("holds")).expect("regular");
    /// // The left finger moves on by 1 m: the object goes half the way, its force grows by half its stiffness.
    /// assert!((response.twist[(0, 0)] - 0.5).abs() < 1e-14);
    /// assert!((response.forces[(0, 0)] - 500.0).abs() < 1e-11);
    ///
    /// // 1 mm to the right: the left finger follows, the right one, whose normal points left, gives way.
    /// let command = response.smallest_command(&Twist::new([1e-3, 0.0], 0.0)).expect("can be reached");
    /// assert!((command[0] - 1e-3).abs() < 1e-16 && (command[2] - -1e-3).abs() < 1e-16);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn response(&self, equilibrium: &Equilibrium<D, C>) -> Option<Response> {
        let commands = (0..self.len() * C).map(|k| Parameter::Command { contact: k / C, axis: k % C });
        self.response_to(equilibrium, commands)
    }

    /// How an equilibrium answers to the joint commands of its hand while every contact and every drive keeps its state: as [`Self::response`], with a column
    /// for each joint and then each tendon.
    ///
    /// ```
    /// use grasp_lcp::planar::hand::{Finger, Hand, Joint, Twist, Wrench};
    /// use grasp_lcp::planar::Contact;
    ///
    /// let jaw = |x: f64| {
    ///     Finger::new([Joint::prismatic([-x, 0.0]).stiffness(1e3).command(0.01)])
    ///         .contact(Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 1e3).friction(0.5))
    /// };
    /// let grasp = Hand::new([jaw(-1.0), jaw(1.0)]).grasp::<5>()?;
    /// let outcome = grasp.solve(&Wrench::ZERO)?;
    /// let response = grasp.joint_response(outcome.equilibrium().expect("holds")).expect("regular");
    /// // 1 mm to the right: the left jaw closes by as much as the right one opens.
    /// let commands = response.smallest_command(&Twist::<5>::new([1e-3, 0.0], 0.0)).expect("can be reached");
    /// assert!((commands[0] - 1e-3).abs() < 1e-15 && (commands[1] + 1e-3).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn joint_response(&self, equilibrium: &Equilibrium<D, C>) -> Option<Response> {
        let commands = (0..self.joint_commands().len()).map(|joint| Parameter::JointCommand { joint });
        self.response_to(equilibrium, commands)
    }

    fn response_to(
        &self,
        equilibrium: &Equilibrium<D, C>,
        parameters: impl ExactSizeIterator<Item = Parameter>,
    ) -> Option<Response> {
        let local = Local::new(self, equilibrium)?;
        let (object, columns) = (C * (C + 1) / 2, parameters.len());
        let mut response = Response {
            twist: DMatrix::zeros(object, columns),
            forces: DMatrix::zeros(self.len() * C, columns),
        };
        for (column, parameter) in parameters.enumerate() {
            let (twist, forces) = local.derivative(parameter)?;
            let twist = self.outside(&twist);
            for k in 0..object {
                response.twist[(k, column)] = twist.as_vector()[k];
            }
            for (i, force) in forces.iter().take(self.len()).enumerate() {
                for a in 0..C {
                    response.forces[(i * C + a, column)] = force[a];
                }
            }
        }
        Some(response)
    }

    /// Derivatives of the onset by every parameter, one gradient for each leaving contact: `dτ = -dm / m'` with the margin that vanishes,
    /// m = `μ F_n - |F_t|` (F_n where a contact opens), and its rate m' along the ramp. `ramp` and `event` must be those of the same
    /// question. Empty if the onset was reached after a contact had closed on the way (the history then enters, too), or if event or
    /// ramp have another number of contacts.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let ramp = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
    /// let onset = grasp.onset(&ramp)?;
    /// // A contact leaves at W = 2 μ N, so ∂W/∂μ = 2 N = 20 newtons.
    /// let gradient = &grasp.onset_gradients(&ramp, onset.event().expect("slides"))[0];
    /// assert!((gradient.friction[0] - 20.0).abs() < 1e-12);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn onset_gradients(&self, ramp: &Ramp<D, C>, event: &OnsetEvent<D, C>) -> Vec<OnsetGradient<D, C>> {
        let Some(state) = self.state_at_onset(event) else { return Vec::new() };
        let Some(local) = Local::new(self, &state) else { return Vec::new() };
        let has_slipped = |i: usize| {
            let sticks = local.states[i].is_rolling() && !local.problem.local(i).is_frictionless();
            sticks && state.contacts[i].slip.norm() != 0.0
        };
        if (0..self.len()).any(has_slipped) {
            return Vec::new();
        }
        let Ok(change) = ramp.drive_changes(self) else { return Vec::new() };
        let Ok(rates) = local.piece.solve(self.sites(), &change, &self.inside_unchecked(&ramp.direction))
        else {
            return Vec::new();
        };
        let one = |site: &usize| self.onset_gradient(&local, event.cone, *site, &rates.forces[*site]);
        event.local.leaving.iter().filter_map(one).collect()
    }

    fn onset_gradient(
        &self,
        local: &Local<D, C>,
        cone: Cone,
        contact: usize,
        rate: &SVector<f64, C>,
    ) -> Option<OnsetGradient<D, C>> {
        let (law, force) = (local.problem.local(contact), &local.forces[contact]);
        // The margin that vanishes: μ F_n - h·F_t, or F_n alone where there is no friction or no limit to it.
        let h = if !law.cone().has_edges() {
            None
        } else if cone == Cone::Round {
            Some(tangential(force).normalize())
        } else {
            Some(*law.facets().iter().max_by(|a, b| a.dot(force).total_cmp(&b.dot(force)))?)
        };
        let margin = |f: &SVector<f64, C>| h.map_or(f[0], |h| law.cone().facet_margin(f, &h));
        let slope = margin(rate);
        let by = |parameter| -> Option<f64> {
            let (_, forces) = local.derivative(parameter)?;
            let own = matches!(parameter, Parameter::Friction { contact: i } if i == contact && h.is_some());
            Some(-(margin(&forces[contact]) + if own { force[0] } else { 0.0 }) / slope)
        };
        let (n, actuators) = (self.len(), 0..self.joint_commands().len());
        let leaving = match self.linkage() {
            Some(linkage) if contact >= n => Leaver::Drive(linkage.part(contact - n)?),
            _ => Leaver::Contact(contact),
        };
        let mut gradient = OnsetGradient {
            leaving,
            friction: Vec::with_capacity(n),
            stiffness: vec![SVector::zeros(); n],
            command: vec![SVector::zeros(); n],
            joint_command: actuators
                .clone()
                .map(|joint| by(Parameter::JointCommand { joint }))
                .collect::<Option<_>>()?,
            joint_stiffness: actuators
                .clone()
                .map(|joint| by(Parameter::JointStiffness { joint }))
                .collect::<Option<_>>()?,
            joint_limit: actuators.map(|joint| by(Parameter::JointLimit { joint })).collect::<Option<_>>()?,
            base_load: SVector::zeros(),
        };
        for i in 0..n {
            gradient.friction.push(by(Parameter::Friction { contact: i })?);
            for axis in 0..C {
                gradient.stiffness[i][axis] = by(Parameter::Stiffness { contact: i, axis })?;
                gradient.command[i][axis] = by(Parameter::Command { contact: i, axis })?;
            }
        }
        for component in 0..D {
            // A load on a free motion is not carried at all: the onset does not depend on what cannot be.
            gradient.base_load[component] = by(Parameter::Load { component }).unwrap_or(f64::NAN);
        }
        Some(gradient)
    }
}

impl Response {
    /// The smallest commands (least squares over all contacts and axes, m) that move the object by a twist about the origin, in the order of
    /// the columns, to be added to the present ones: `da = (dq/da)⁺ dq`. `None` if the fingers cannot produce it in the present states.
    #[must_use]
    pub fn smallest_command<const D: usize, const C: usize>(
        &self,
        wanted: &Twist<D, C>,
    ) -> Option<DVector<f64>> {
        let object = C * (C + 1) / 2;
        if self.twist.nrows() != object {
            return None;
        }
        // What joints do meanwhile is not wanted.
        let wanted = SVector::<f64, D>::from_fn(|k, _| if k < object { wanted.as_vector()[k] } else { 0.0 });
        let all = |column: nalgebra::DVectorView<f64>| {
            SVector::<f64, D>::from_fn(|k, _| if k < object { column[k] } else { 0.0 })
        };
        let columns = self.twist.column_iter().map(all).collect();
        let command = DVector::from_vec(least_combination(columns, &wanted));
        let missed = (&self.twist * &command - wanted.rows(0, object)).norm();
        (missed <= 1e-9 * wanted.norm()).then_some(command)
    }
}

/// An equilibrium with its piece.
struct Local<'g, const D: usize, const C: usize> {
    grasp: &'g Grasp<D, C>,
    problem: Problem<'g, D, C>,
    states: Vec<State<C>>,
    forces: Vec<SVector<f64, C>>,
    piece: Piece<D, C>,
}

impl<'g, const D: usize, const C: usize> Local<'g, D, C> {
    fn new(grasp: &'g Grasp<D, C>, equilibrium: &Equilibrium<D, C>) -> Option<Self> {
        if equilibrium.contacts.len() != grasp.len() {
            return None;
        }
        let polygon = match equilibrium.cone {
            Cone::Polygon(cone) => Polygon::new(&cone),
            _ => Polygon::new(&Settings::default().cone),
        };
        let nothing = Load::from(&SVector::zeros());
        let problem = grasp.problem(Arc::new(polygon), false, grasp.drives(), &nothing);
        let states = equilibrium.local.states.clone();
        let piece = Piece::new(&problem, &states);
        let forces = equilibrium.site_forces();
        Some(Self { grasp, problem, states, forces, piece })
    }

    fn derivative(&self, by: Parameter) -> Option<(SVector<f64, D>, Vec<SVector<f64, C>>)> {
        let n = self.problem.len();
        let mut drives = vec![SVector::zeros(); n];
        let mut wrench = SVector::zeros();
        let mut direct: Vec<(usize, SVector<f64, C>)> = Vec::new();
        let (contacts, actuators) = (self.grasp.len(), self.grasp.joint_commands().len());
        match by {
            Parameter::Friction { contact } if contact < contacts => {
                direct.push((contact, self.by_friction(contact)));
            }
            Parameter::Stiffness { contact, axis } if contact < contacts && axis < C => {
                direct.push((contact, self.by_stiffness(contact, axis)));
            }
            Parameter::Command { contact, axis } if contact < contacts && axis < C => {
                drives[contact][axis] = 1.0;
            }
            Parameter::JointCommand { joint } if joint < actuators => {
                let unit: Vec<f64> = (0..actuators).map(|k| f64::from(u8::from(k == joint))).collect();
                drives = self.grasp.drive_changes(None, Some(&unit));
            }
            Parameter::JointStiffness { joint } if joint < actuators => {
                for (site, drive) in self.grasp.drives_of(joint) {
                    let state = &self.states[site];
                    if !state.is_open() && !state.slides() {
                        direct.push((site, drive.by_stiffness(&self.forces[site])));
                    }
                }
            }
            Parameter::JointLimit { joint } if joint < actuators => {
                for (site, drive) in self.grasp.drives_of(joint) {
                    let held;
                    (drives[site], held) = drive.by_limit();
                    wrench += held;
                }
            }
            Parameter::Load { component } if component < D => {
                let mut unit = SVector::<f64, D>::zeros();
                unit[component] = 1.0;
                wrench = self.grasp.inside_unchecked(&Wrench::from_vector(unit));
            }
            _ => return None,
        }
        for (site, f) in &direct {
            wrench += self.problem.sites[*site].map * f;
        }
        let mut solved = self.piece.solve(self.grasp.sites(), &drives, &wrench).ok()?;
        for (site, f) in direct {
            solved.forces[site] += f;
        }
        Some((solved.twist, solved.forces))
    }

    /// (∂K/∂μ) v of one contact.
    fn by_friction(&self, contact: usize) -> SVector<f64, C> {
        let state = &self.states[contact];
        if !state.slides() {
            return SVector::zeros();
        }
        self.problem.local(contact).edge(state).pull * self.forces[contact][0]
    }

    /// (∂K/∂k) v of one contact along one axis.
    fn by_stiffness(&self, contact: usize, axis: usize) -> SVector<f64, C> {
        let (local, force) = (self.problem.local(contact), &self.forces[contact]);
        let state = &self.states[contact];
        let mut f = SVector::zeros();
        if axis >= local.springs.axes() || state.is_open() {
            return f;
        }
        let stretch = local.springs.give_along(axis, force[axis]);
        if state.is_rolling() {
            f[axis] = stretch;
        } else if axis == 0 {
            f = local.edge(state).pull * local.cone().limit(stretch);
            f[0] = stretch;
        } else if !matches!(state, Mode::Corner(_))
            && let Some(h) = local.outward(state)
        {
            // e_a F_a/k_a, less what the slip gives back so that h·F_t keeps to μ F_n; on the round cone softened by the slip.
            let softened =
                state.slide().map_or(stretch, |slide| stretch * local.springs.softening(axis, slide.lambda));
            f = local.edge(state).pull * (-h[axis] * softened);
            f[axis] += softened;
        }
        f
    }
}
