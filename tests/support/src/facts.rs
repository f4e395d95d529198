//! The facts of an error, without the sentence that the library makes of them.

use grasp_lcp::Error;

/// The place, the datum and the value of an error: `["joint 0 (tip)", "command", "NaN"]`. Of lists the value is the length that was given, and the
/// datum the length that is needed.
pub fn facts(error: &Error) -> [String; 3] {
    let number = |place: &dyn ToString, datum: &dyn ToString, value: &dyn ToString| {
        [place.to_string(), datum.to_string(), value.to_string()]
    };
    match error {
        Error::Contact { contact, field, value, .. } => number(contact, field, value),
        Error::Surface { contact, field, value, .. } => number(contact, field, value),
        Error::Wrench { what, component, value } => number(what, component, value),
        Error::Size { what, given, expected } | Error::JointCommands { what, given, expected } => {
            number(what, expected, given)
        }
        Error::Fingertip { what, value, .. } | Error::Argument { what, value, .. } => {
            number(&"", what, value)
        }
        Error::Identify { what, field, value, .. } | Error::Hand { what, field, value, .. } => {
            number(what, field, value)
        }
        Error::Matrix { what, field, value, .. } => number(what, field, value),
        Error::Shape { what, given: (m, n), expected: (rows, columns) } => {
            number(what, &format!("{rows} x {columns}"), &format!("{m} x {n}"))
        }
        Error::Link { name, field, value, .. } => number(name, field, value),
        Error::NotClosed { what, off } => number(&"cycle", what, off),
        Error::Question { question, field, .. } => number(question, field, &""),
        Error::NoSuchContact { contact, contacts } => number(&"contact", contacts, contact),
        Error::Body { name, fault } => number(name, fault, &""),
        other => panic!("{other:?}"),
    }
}
