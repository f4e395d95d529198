//! Errors for malformed input. That no equilibrium exists is not an error but an answer, [`crate::equilibrium::Outcome`]. A leg is a section of a
//! load program. On a ramp the load, or commands, change in proportion to the load factor. A parameter is a number of the grasp that `identify`
//! estimates; its input calls it an unknown.

use core::fmt;

use crate::prelude::*;
pub use crate::words::ContactLabel;
use crate::words::Words;

/// Largest accepted magnitude of an input number. The square of a product of three larger numbers could overflow, and a norm that is infinite makes
/// every relative residual look small. No unit of length or force brings a real grasp near this limit.
pub(crate) const LARGEST: f64 = 1e50;

/// The range of numbers that [`is_moderate`] accepts, as error messages state it.
pub(crate) const MODERATE: &str = "finite and at most 1e50 in size";

/// The end of the message of [`Error::Part`]: the names of the `allowed` parts. If there are none, it says that no part of the scene has a load,
/// command or force of its own.
fn one_of(allowed: &str) -> String {
    match allowed {
        "" => "and no other part has: what presses by overlap is the squeeze, and a `mass` presses as given"
            .to_owned(),
        allowed => format!("must be one of {allowed}"),
    }
}

/// A load as text, from its components: three in the plane, six in space.
fn load_text(components: &[f64]) -> String {
    Words::default().load_of(if components.len() == 3 { 2 } else { 3 }, components)
}

/// Whether a number is finite and at most [`LARGEST`] in magnitude.
pub(crate) fn is_moderate(x: f64) -> bool {
    x.abs() <= LARGEST
}

/// Returns an error if `contact`, the index of a contact from 0, is not below `count`, the number of contacts.
pub(crate) fn check_contact(contact: usize, count: usize) -> Result<(), Error> {
    if contact < count {
        return Ok(());
    }
    Err(Error::NoSuchContact { contact, contacts: count })
}

/// Malformed input: the quantity at fault, its value, and the allowed values. That no equilibrium exists is not an error but an answer,
/// [`Outcome::NoEquilibrium`](crate::equilibrium::Outcome::NoEquilibrium).
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, Wrench};
/// use grasp_lcp::Error;
///
/// let grasp = Grasp::new([Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(100.0, 100.0)])?;
/// let refused = grasp.solve(Wrench::new([0.0, -1.0], f64::NAN)).unwrap_err();
/// assert!(matches!(refused, Error::Wrench { what: "load", component: 2, .. }));
/// assert_eq!(refused.to_string(), "load: component 2 is NaN, must be finite and at most 1e50 in size");
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A grasp without contacts.
    #[error("a grasp needs at least one contact, none was given")]
    EmptyGrasp,
    /// One number of one contact is out of range.
    #[error("contact {contact}: {field} {} {value}, must be {allowed}", field.is())]
    Contact {
        /// The contact at fault.
        contact: ContactLabel,
        /// The quantity that is out of range.
        field: Field,
        /// The given value: the component at fault, or the length of the vector at fault.
        value: f64,
        /// The allowed values, as the end of the message.
        allowed: &'static str,
    },
    /// The curve or surface along which the search for finger places may move a contact is degenerate, or the contact does not lie on it.
    #[error("contact {contact}: {field} is {value}, must be {allowed}")]
    Surface {
        /// The contact at fault.
        contact: ContactLabel,
        /// The quantity that is out of range: a dimension of the surface, or the position or normal of the contact relative to the surface.
        field: &'static str,
        /// The given value of the quantity `field`.
        value: f64,
        /// The allowed values of this quantity, in words.
        allowed: &'static str,
    },
    /// A component of a wrench is not finite, or larger than 1e50 in magnitude.
    #[error("{what}: component {component} is {value}, must be finite and at most 1e50 in size")]
    Wrench {
        /// The wrench at fault, such as "load", "base load" or "load direction".
        what: &'static str,
        /// Index of the component, from 0: forces first, then moments, then the torques on the joints of a hand.
        component: usize,
        /// The given value of this component of the wrench, N or N m.
        value: f64,
    },
    /// An index of a contact is not below the number of contacts.
    #[error(
        "contact: {contact} given, must be less than {contacts}, the number of contacts, which are counted from 0"
    )]
    NoSuchContact {
        /// The given index of a contact, from 0.
        contact: usize,
        /// The number of contacts.
        contacts: usize,
    },
    /// The length of a list with one entry for each contact differs from the number of contacts.
    #[error("{what}: {given} given, must be {expected}, one a contact")]
    Size {
        /// Name of the list, such as "commands" or "command changes".
        what: &'static str,
        /// The length of the given list.
        given: usize,
        /// The number of contacts.
        expected: usize,
    },
    /// A polygonal friction cone has fewer than three facets, or more than is allowed.
    #[error("friction cone: {given} facets, must be from 3 to {most}")]
    Facets {
        /// The number of facets that was given.
        given: usize,
        /// The largest number of facets that is accepted.
        most: usize,
    },
    /// A dimension of a soft fingertip, or its number of points, is out of range.
    #[error("soft fingertip: {what} is {value}, must be {allowed}")]
    Fingertip {
        /// The quantity at fault: a radius or a width (m), or a number of annuli, strips or points.
        what: &'static str,
        /// The given value of the quantity `what`.
        value: f64,
        /// The allowed values of this quantity, in words.
        allowed: &'static str,
    },
    /// A mesh file is missing or cannot be read, or the mesh encloses no volume although a volume is needed.
    #[cfg(feature = "mesh")]
    #[error("mesh: {fault}")]
    Mesh {
        /// The fault, and the requirement, in words.
        fault: String,
    },
    /// The description of a robot cannot be read, or has no link or joint of the given name.
    #[cfg(feature = "urdf")]
    #[error("robot: {fault}")]
    Robot {
        /// The fault, and the requirement, in words.
        fault: String,
    },
    /// A pad (a finger's surface that closes on an object) does not meet the part, the mesh of this object, or starts inside the part.
    #[cfg(feature = "mesh")]
    #[error("contact {contact}: {fault}")]
    Misses {
        /// The contact that the pad should make.
        contact: ContactLabel,
        /// The fault, and the requirement, in words.
        fault: &'static str,
    },
    /// An argument of a method, or a number of a question, is out of range. Numbers of a contact, a wrench or a hand have errors of their own.
    #[error("{what} is {value}, must be {allowed}")]
    Argument {
        /// The quantity that is out of range, such as "angle of the turn".
        what: &'static str,
        /// The given value of the quantity `what`.
        value: f64,
        /// The allowed values of this quantity, in words.
        allowed: &'static str,
    },
    /// A number of an observed slip, of a parameter to be identified or of a known sum of parameters is out of range.
    #[error("{what}: {field} is {value}, must be {allowed}")]
    Identify {
        /// The observed slip, the parameter or the known sum of parameters, with its index in its list, counted from 0.
        what: String,
        /// The quantity that is out of range.
        field: &'static str,
        /// The given value of the quantity `field`.
        value: f64,
        /// The allowed values of this quantity, in words.
        allowed: &'static str,
    },
    /// The library panicked while it answered one grasp or question: a fault of the library, not of the input. In a batch all others are still
    /// answered.
    #[error("internal: this question made the library fail, which is a fault of the library ({fault})")]
    Internal {
        /// The message of the panic.
        fault: String,
    },
    /// Commands or joint torques change on a leg of a load program along which the load turns. They must stay constant, since only then the angles at
    /// which contacts change their states have closed forms.
    #[error("commands or torques of a leg: change while the load turns, must stay")]
    CommandsWhileTurning,
    /// A turn (a leg along which the load turns) begins with another load than the load that acts just before this leg. Such a leg would make the
    /// load jump at its beginning, if it were followed.
    #[error(
        "leg {}: its turn begins with {}, and {} acts before it, must be the same: give it as `start` or `base`, or by a leg before; loads that do not turn are `beside`",
        leg + 1,
        load_text(begins),
        load_text(before)
    )]
    TurnBegins {
        /// Index of the leg, from 0.
        leg: usize,
        /// The first load of the turn: force, then moment, N and N m.
        begins: Vec<f64>,
        /// The load before the leg.
        before: Vec<f64>,
    },
    /// The question has no change of load. If first slip is sought, neither the load nor a command changes along the ramp. Otherwise loads on other
    /// bodies are to grow in proportion to a load that is zero.
    #[error("onset: direction, command_change and joint_change are zero, one of them must change something")]
    NothingChanges,
    /// The legs (sections) of a load cycle do not return to the load or the commands with which the cycle begins.
    #[error("cycle: the {what} at its end is {off} away from that at its beginning, must be the same")]
    NotClosed {
        /// The quantity that differs between beginning and end of the cycle: the load or the commands.
        what: &'static str,
        /// The largest difference of this quantity, in its own unit.
        off: f64,
    },
    /// The method that was called limits contact forces by a budget of normal forces. A contact may pull, is bonded or has infinite friction, so that
    /// a budget does not limit its force.
    #[error("{question} bounds normal forces: contact {contact} pulls, is bonded or has infinite friction")]
    Unlimited {
        /// Name of the method that gave the error.
        question: &'static str,
        /// The contact whose force a budget does not limit.
        contact: ContactLabel,
    },
    /// The method that was called decides whether contacts can balance loads of any magnitude. The vacuum of suction cups helps to balance limited
    /// loads only, about which this method says nothing.
    #[error(
        "{question} asks for loads of any size: the vacuum of contact {contact} is limited, ask load_limit or ferrari_canny"
    )]
    Vacuum {
        /// Name of the method that gave the error.
        question: &'static str,
        /// The first contact with a vacuum.
        contact: ContactLabel,
    },
    /// A field of a scene's question is missing, or does not fit the other fields.
    #[error("{question}: {field} {fault}")]
    Question {
        /// Name of the question, such as "improve".
        question: &'static str,
        /// Name of the field at fault.
        field: &'static str,
        /// The fault and the allowed values, in words.
        fault: &'static str,
    },
    /// The data of one of several bodies are not valid, or a body of this name does not exist.
    #[error("body {name:?} {fault}")]
    Body {
        /// The name of the body.
        name: String,
        /// The fault and the allowed values, in words.
        fault: String,
    },
    /// The part (a body, contact, cable or joint) whose force a question seeks has no load, command or force to scale, or does not exist.
    #[error("part {name:?} has no load, command or force of its own, {}", one_of(allowed))]
    Part {
        /// The name of the part that was given.
        name: String,
        /// Names of the bodies, contacts, cables and joints that have a load, a command or a force, any of which can be given.
        allowed: String,
    },
    /// One number of a link between bodies is out of range.
    #[error("{kind} {name:?}: {field} is {value}, must be {allowed}")]
    Link {
        /// Kind of the link: "hinge", "cable", …
        kind: &'static str,
        /// Name of the link at fault.
        name: String,
        /// The quantity that is out of range.
        field: &'static str,
        /// The given value of the quantity `field`.
        value: f64,
        /// The allowed values of this quantity, in words.
        allowed: &'static str,
    },
    /// One number of one joint, tendon or finger is out of range.
    #[error("{what}: {field} is {value}, must be {allowed}")]
    Hand {
        /// The joint, tendon or finger, by kind, number and name.
        what: String,
        /// The quantity that is out of range.
        field: &'static str,
        /// The given value of the quantity `field`.
        value: f64,
        /// The allowed values of this quantity, in words.
        allowed: &'static str,
    },
    /// A matrix of a hand is not symmetric, or has a negative eigenvalue.
    #[error(
        "{what}: {field} {fault} {value}, must be symmetric, with no eigenvalue below zero (a compliance: all above)"
    )]
    Matrix {
        /// The finger whose matrix is at fault, by number.
        what: String,
        /// Name of the matrix at fault.
        field: &'static str,
        /// The fault in words; the value follows it in the message.
        fault: &'static str,
        /// Magnitude of the fault: the largest difference between entries across the diagonal, or the least eigenvalue.
        value: f64,
    },
    /// A matrix of a hand has the wrong number of rows or columns.
    #[error("{what}: {} x {} given, must be {} x {}", given.0, given.1, expected.0, expected.1)]
    Shape {
        /// The matrix, with the finger or contact to which it belongs.
        what: String,
        /// Rows and columns that were given.
        given: (usize, usize),
        /// Required rows and columns.
        expected: (usize, usize),
    },
    /// The method that was called supports only one object, held by contacts with springs of their own. The grasp has joints or several bodies.
    #[error(
        "{question} knows neither joints nor several bodies: ask it of one object that no hand with joints holds"
    )]
    NotForHands {
        /// Name of the method that gave the error.
        question: &'static str,
    },
    /// The method that was called finds contacts that slide but does not support kinetic friction lower than static friction, which a contact has.
    #[error(
        "{question} does not know that the friction of contact {contact} is lower once it slides: ask hold, follow or shake, which do, or leave kinetic friction out"
    )]
    KineticFriction {
        /// Name of the method that gave the error.
        question: &'static str,
        /// The contact with lower kinetic friction.
        contact: ContactLabel,
    },
    /// The method that was called supports several bodies but no joints. A contact with a constant normal force counts as a joint: its finger follows
    /// the object along a prismatic joint in the direction of the normal.
    #[error(
        "{question} knows no joints: ask it of bodies that no hand with joints holds, and no contact presses with a given force"
    )]
    NotForJoints {
        /// Name of the method that gave the error.
        question: &'static str,
    },
    /// The length of a list of joint commands differs from the number of joints and tendons.
    #[error("{what}: {given} given, must be {expected}, one a joint and one a tendon")]
    JointCommands {
        /// Name of the list, such as "joint commands".
        what: &'static str,
        /// The length of the given list.
        given: usize,
        /// Number of joints and tendons.
        expected: usize,
    },
    /// All equilibria cannot be listed, since too many combinations of contact states have to be tried.
    #[error("{contacts} contacts have {combinations:e} combinations of states, at most {most} are tried")]
    TooManyStates {
        /// Number of contacts of the grasp.
        contacts: usize,
        /// Number of combinations of the states of all contacts.
        combinations: f64,
        /// The largest number of combinations that the settings allow.
        most: usize,
    },
}

/// The quantities that describe a contact, as error messages name them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Field {
    /// The contact point, m.
    Point,
    /// The normal into the object.
    Normal,
    /// Direction of the first tangent.
    Tangent,
    /// Stiffness of the object at the contact, N/m, by axis of the contact frame.
    BodyStiffness,
    /// Stiffness of the finger at the contact, N/m, by axis of the contact frame.
    FingerStiffness,
    /// Stiffness of object and finger in series, N/m, by axis of the contact frame.
    SeriesStiffness,
    /// Coefficient of friction of a contact that sticks.
    Friction,
    /// Coefficient of friction of a contact that slides.
    KineticFriction,
    /// Commanded finger displacement, in the contact frame, m.
    Command,
    /// Change of the commanded finger displacement along a ramp or along a leg of a load program, in the contact frame, m. If a leg gives the command
    /// at its end instead of the change, this is that command.
    CommandChange,
    /// Normal force with which the finger is commanded to press, N.
    Press,
    /// Constant normal force with which the finger presses, N; see [`Contact::force`](crate::grasp::Contact::force).
    Force,
    /// Constant force with which a vacuum pulls the object onto the contact, N; see [`Contact::suction`](crate::grasp::Contact::suction).
    Suction,
    /// Initial clearance between finger and object along the normal, m.
    Clearance,
}

impl Field {
    /// The words between the name and the value of a quantity in an error message: "is". For a tangent they are "of length", since the error gives
    /// the length of the tangent.
    pub(crate) fn is(self) -> &'static str {
        if self == Self::Tangent { "of length" } else { "is" }
    }
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Field::Point => "point",
            Field::Normal => "normal",
            Field::Tangent => "tangent",
            Field::BodyStiffness => "body stiffness",
            Field::FingerStiffness => "finger stiffness",
            Field::SeriesStiffness => "series stiffness",
            Field::Friction => "friction coefficient",
            Field::KineticFriction => "kinetic friction coefficient",
            Field::Command => "command",
            Field::CommandChange => "change of command",
            Field::Press => "pressing force",
            Field::Force => "force",
            Field::Suction => "suction",
            Field::Clearance => "clearance",
        })
    }
}
