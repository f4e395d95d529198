//! How an equilibrium answers to commands: the matrices of position control.

use nalgebra::{DMatrix, DVector, SVector};

use super::sensitivity::{Local, Parameter};
use crate::equilibrium::Equilibrium;
use crate::grasp::{Grasp, Twist, object_alone, of_the_object};
use crate::object::least_combination;

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

impl<const D: usize, const C: usize> Grasp<D, C> {
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
        let (object, columns) = (of_the_object::<C>(), parameters.len());
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
}

impl Response {
    /// The smallest commands (least squares over all contacts and axes, m) that move the object by a twist about the origin, in the order of
    /// the columns, to be added to the present ones: `da = (dq/da)⁺ dq`. `None` if the fingers cannot produce it in the present states.
    #[must_use]
    pub fn smallest_command<const D: usize, const C: usize>(
        &self,
        wanted: &Twist<D, C>,
    ) -> Option<DVector<f64>> {
        let object = of_the_object::<C>();
        if self.twist.nrows() != object {
            return None;
        }
        // What joints do meanwhile is not wanted.
        let wanted = object_alone::<D, C>(wanted.as_vector());
        let all = |column: nalgebra::DVectorView<f64>| {
            SVector::<f64, D>::from_fn(|k, _| if k < object { column[k] } else { 0.0 })
        };
        let columns = self.twist.column_iter().map(all).collect();
        let command = DVector::from_vec(least_combination(columns, &wanted));
        let missed = (&self.twist * &command - wanted.rows(0, object)).norm();
        (missed <= 1e-9 * wanted.norm()).then_some(command)
    }
}
