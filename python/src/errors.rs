//! Converts errors of the crate to exceptions that name the Python argument.

use std::fmt::Display;

use grasp_lcp::words::printable;
use grasp_lcp::{Error, Field};
use pyo3::PyErr;
use pyo3::exceptions::PyValueError;

/// The error of the crate as a `ValueError` that names the argument, the index in it, the value, and the allowed values.
pub(crate) fn refused(error: Error) -> PyErr {
    PyValueError::new_err(match error {
        Error::Contact { contact, field, value, allowed } => {
            let name = contact.name.map(|name| format!(" ({})", printable(&name))).unwrap_or_default();
            format!("{}[{}]{name} is {}, must be {allowed}", argument(field), contact.index, shown(value))
        }
        Error::Wrench { what, component, value } => {
            format!(
                "{}[{component}] is {}, must be finite and at most 1e50 in size",
                named(what),
                shown(value)
            )
        }
        Error::Argument { what, value, allowed } => {
            format!("{} is {}, must be {allowed}", named(what), shown(value))
        }
        Error::Size { what, given, expected } => {
            format!("{}: {given} rows given, must be {expected}, one a contact", named(what))
        }
        Error::JointCommands { what, given, expected } => {
            format!("{}: {given} given, must be {expected}, one a joint and one a tendon", named(what))
        }
        Error::NothingChanges => {
            "direction, command_change and joint_change are zero, one of them must change something"
                .to_owned()
        }
        other => other.to_string(),
    })
}

/// A `ValueError` with a complete message.
pub(crate) fn wrong(message: impl Display) -> PyErr {
    PyValueError::new_err(message.to_string())
}

/// Whether the refused number is NaN, which marks missing data.
pub(crate) fn has_nan(error: &Error) -> bool {
    matches!(error, Error::Contact { value, .. } | Error::Wrench { value, .. } if value.is_nan())
}

/// A number in a message, with an exponent if it is very large or very small.
pub(crate) fn shown(value: f64) -> String {
    let plain = value == 0.0 || !value.is_finite() || (1e-5..1e16).contains(&value.abs());
    if plain { value.to_string() } else { format!("{value:e}") }
}

/// The Python argument that holds this field of all contacts.
fn argument(field: Field) -> &'static str {
    match field {
        Field::Point => "points",
        Field::Normal => "normals",
        Field::Tangent => "tangents",
        Field::BodyStiffness => "body_stiffness",
        Field::FingerStiffness => "finger_stiffness",
        Field::SeriesStiffness => "series_stiffness",
        Field::Friction => "friction",
        Field::KineticFriction => "kinetic_friction",
        Field::Command => "command",
        Field::CommandChange => "command_change",
        Field::Press => "pressed_with",
        Field::Force => "force",
        Field::Suction => "suction",
        Field::Clearance => "clearance",
        _ => "contact",
    }
}

/// The Python argument for a name that the crate uses in its errors.
fn named(what: &'static str) -> &'static str {
    match what {
        "load direction" => "direction",
        "load to come" => "to_come",
        "base load" => "base",
        "command changes" => "command_change",
        "changes of joint commands" => "joint_change",
        "budget of normal forces" => "budget",
        "size of the force" => "any_force",
        "point of the force" => "at",
        "size of the load direction" => "size of direction",
        "number of loads" => "number of loads",
        other => other,
    }
}

/// A `ValueError` with the message of serde, without line and column: they would refer to text that the package has written, not the caller.
pub(crate) fn of_json(argument: &str, error: &serde_json::Error) -> PyErr {
    let message = error.to_string();
    let message = message.split(" at line ").next().unwrap_or(&message);
    wrong(format_args!("{argument}: {}", printable(message)))
}
