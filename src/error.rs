//! Malformed input, and only that: "no equilibrium exists" is an answer (see [`crate::equilibrium::Outcome`]), not an error.

use core::fmt;

use crate::prelude::*;
pub use crate::words::ContactLabel;

/// Larger numbers are refused: squares of products of three of them would overflow, and a size that overflows makes every
/// violation look small. No unit of length or force brings a real grasp near this.
pub(crate) const LARGEST: f64 = 1e50;

/// Wording of this range in messages.
pub(crate) const MODERATE: &str = "finite and at most 1e50 in size";

/// Finite and at most [`LARGEST`] in size.
pub(crate) fn is_moderate(x: f64) -> bool {
    x.abs() <= LARGEST
}

/// An error if the index of a contact is not below their number.
pub(crate) fn check_contact(contact: usize, count: usize) -> Result<(), Error> {
    if contact < count {
        return Ok(());
    }
    let (what, allowed) = ("number of the contact", "less than the number of contacts");
    Err(Error::Argument { what, value: contact as f64, allowed })
}

/// A fault in a question: its place, its value, and the allowed values. "No equilibrium" is not among them: that is an answer,
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
        /// Which contact.
        contact: ContactLabel,
        /// Which of its data.
        field: Field,
        /// What was given: the offending component, or the length of an offending vector.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A curve or surface that a contact may move along is degenerate, or the contact does not lie on it.
    #[error("contact {contact}: {field} is {value}, must be {allowed}")]
    Surface {
        /// Which contact.
        contact: ContactLabel,
        /// Which datum of its surface.
        field: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A component of a wrench is not finite, or absurdly large.
    #[error("{what}: component {component} is {value}, must be finite and at most 1e50 in size")]
    Wrench {
        /// Which wrench of the question, such as "load", "base load" or "load direction".
        what: &'static str,
        /// Index of the component: forces first, then moments, then the torques on the joints of a hand.
        component: usize,
        /// What was given.
        value: f64,
    },
    /// A list that goes with the contacts has another length than the list of contacts.
    #[error("{what}: {given} given, must be {expected}, one a contact")]
    Size {
        /// Which list, such as "commands" or "command changes".
        what: &'static str,
        /// Its length.
        given: usize,
        /// The number of contacts.
        expected: usize,
    },
    /// A polygonal friction cone that is no polygon, or needlessly fine.
    #[error("friction cone: {given} facets, must be from 3 to {most}")]
    Facets {
        /// What was given.
        given: usize,
        /// The largest number of facets that is accepted.
        most: usize,
    },
    /// A soft fingertip without extent or points, or with too many.
    #[error("soft fingertip: {what} is {value}, must be {allowed}")]
    Fingertip {
        /// Which of its data: a radius or a width (m), or a number of annuli, strips or points.
        what: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A mesh that is not there, cannot be read, or encloses no volume.
    #[cfg(feature = "mesh")]
    #[error("mesh: {fault}")]
    Mesh {
        /// The fault, and what must be.
        fault: String,
    },
    /// A description of a robot that cannot be read, or a link or a joint that it has not.
    #[cfg(feature = "urdf")]
    #[error("robot: {fault}")]
    Robot {
        /// The fault, and what must be.
        fault: String,
    },
    /// A pad that does not meet the part on which it closes, or begins inside of it.
    #[cfg(feature = "mesh")]
    #[error("contact {contact}: {fault}")]
    Misses {
        /// Which contact.
        contact: ContactLabel,
        /// The fault, and what must be.
        fault: &'static str,
    },
    /// A number of a question is out of range, other than a number of a contact, a load or a hand.
    #[error("{what} is {value}, must be {allowed}")]
    Argument {
        /// Which number, such as "angle of the turn".
        what: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A number of an observed slip, or of an unknown to be identified, is out of range.
    #[error("{what}: {field} is {value}, must be {allowed}")]
    Identify {
        /// Which slip or which unknown, by number.
        what: String,
        /// Which of its data.
        field: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A question made this library fail: a fault of the library, not of the question. Where many questions are asked at once the others are
    /// answered.
    #[error("internal: this question made the library fail, which is a fault of the library ({fault})")]
    Internal {
        /// The message of the failure.
        fault: String,
    },
    /// Commands or held torques change while the load turns: events would have no exact angles.
    #[error("commands or torques of a leg: change while the load turns, must stay")]
    CommandsWhileTurning,
    /// A scene asks for an onset along a ramp that changes nothing.
    #[error("onset: direction, command_change and joint_change are zero, one of them must change something")]
    NothingChanges,
    /// A cycle of legs does not end where it begins.
    #[error("cycle: the {what} at its end is {off} away from that at its beginning, must be the same")]
    NotClosed {
        /// The quantity that differs.
        what: &'static str,
        /// Its largest difference, in its own unit.
        off: f64,
    },
    /// A question that bounds normal forces, asked of a contact whose force they do not bound.
    #[error("{question} bounds normal forces: contact {contact} pulls, is bonded or has infinite friction")]
    Unlimited {
        /// The method.
        question: &'static str,
        /// Which contact.
        contact: ContactLabel,
    },
    /// A question about loads of any size, asked of contacts that do not hold all loads by themselves but have a vacuum, which holds some.
    #[error(
        "{question} asks for loads of any size: the vacuum of contact {contact} is limited, ask load_limit or ferrari_canny"
    )]
    Vacuum {
        /// The method.
        question: &'static str,
        /// Which contact.
        contact: ContactLabel,
    },
    /// A field of a question is missing, or does not belong to this question.
    #[error("{question}: {field} {fault}")]
    Question {
        /// Which question.
        question: &'static str,
        /// Which of its fields.
        field: &'static str,
        /// The fault, and the allowed values.
        fault: &'static str,
    },
    /// One of several bodies is not well posed, or a named body does not exist.
    #[error("body {name:?} {fault}")]
    Body {
        /// The name that was given.
        name: String,
        /// The fault, and the allowed values.
        fault: String,
    },
    /// A part whose force is sought presses with nothing of its own, or is not there.
    #[error("part {name:?} has no load, command or force of its own, must be one of {allowed}")]
    Part {
        /// The name that was given.
        name: String,
        /// Parts that may press.
        allowed: String,
    },
    /// One datum of a link between bodies is out of range.
    #[error("{kind} {name:?}: {field} is {value}, must be {allowed}")]
    Link {
        /// What kind of link.
        kind: &'static str,
        /// Its name.
        name: String,
        /// Which of its data.
        field: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// One number of one joint, tendon or finger is out of range.
    #[error("{what}: {field} is {value}, must be {allowed}")]
    Hand {
        /// Which joint, tendon or finger, by number and name.
        what: String,
        /// Which of its data.
        field: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A matrix of a hand is not symmetric, or has a negative eigenvalue.
    #[error(
        "{what}: {field} {fault} {value}, must be symmetric, with no eigenvalue below zero (a compliance: all above)"
    )]
    Matrix {
        /// Which finger.
        what: String,
        /// Which matrix.
        field: &'static str,
        /// The fault.
        fault: &'static str,
        /// By how much: the largest difference across the diagonal, or the least eigenvalue.
        value: f64,
    },
    /// A matrix of a hand has the wrong shape.
    #[error("{what}: {} x {} given, must be {} x {}", given.0, given.1, expected.0, expected.1)]
    Shape {
        /// Which matrix.
        what: String,
        /// Its rows and columns.
        given: (usize, usize),
        /// What is wanted.
        expected: (usize, usize),
    },
    /// A question about one object and contacts with springs of their own, asked of a hand or of several bodies.
    #[error(
        "{question} knows neither joints nor several bodies: ask it of one object that no hand with joints holds"
    )]
    NotForHands {
        /// The method.
        question: &'static str,
    },
    /// A question that reports sliding contacts, asked of a contact with lower kinetic friction, which it does not support.
    #[error(
        "{question} does not know that the friction of contact {contact} is lower once it slides: ask hold, follow or shake, which do, or leave kinetic friction out"
    )]
    KineticFriction {
        /// The method.
        question: &'static str,
        /// Which contact.
        contact: ContactLabel,
    },
    /// A question that supports several bodies but no joints, asked of bodies that a hand with joints holds. A contact that presses with a given
    /// force has a slide behind it, which is a joint.
    #[error(
        "{question} knows no joints: ask it of bodies that no hand with joints holds, and no contact presses with a given force"
    )]
    NotForJoints {
        /// The method.
        question: &'static str,
    },
    /// A list of joint commands has another length than there are joints and tendons.
    #[error("{what}: {given} given, must be {expected}, one a joint and one a tendon")]
    JointCommands {
        /// Which list.
        what: &'static str,
        /// Its length.
        given: usize,
        /// Number of joints and tendons.
        expected: usize,
    },
    /// Listing every equilibrium would mean trying too many combinations of contact states.
    #[error("{contacts} contacts have {combinations:e} combinations of states, at most {most} are tried")]
    TooManyStates {
        /// Number of contacts.
        contacts: usize,
        /// Number of combinations of their states.
        combinations: f64,
        /// The limit in force.
        most: usize,
    },
}

/// The data of a contact, as error messages name them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Field {
    /// The contact point, m.
    Point,
    /// The normal into the object.
    Normal,
    /// The first tangent.
    Tangent,
    /// Stiffness of the object at the contact, N/m.
    BodyStiffness,
    /// Stiffness of the finger, N/m.
    FingerStiffness,
    /// Stiffness of both in series, N/m.
    SeriesStiffness,
    /// Coefficient of friction.
    Friction,
    /// Coefficient of friction of a contact that slides.
    KineticFriction,
    /// Commanded finger displacement, contact frame, m.
    Command,
    /// Change of the commanded finger displacement along a ramp or a leg, contact frame, m; the command itself for a leg given by its end.
    CommandChange,
    /// Force with which the finger is commanded to press, N.
    Press,
    /// [`Contact::force`](crate::grasp::Contact::force), N.
    Force,
    /// [`Contact::suction`](crate::grasp::Contact::suction), N.
    Suction,
    /// Initial clearance along the normal, m.
    Clearance,
}

impl Field {
    /// The word between a datum and its value: of a tangent the length is reported.
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
