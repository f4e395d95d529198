//! Refuses questions that contain the weight of a body again, although the scene's gravity already acts on it (feature `json`). Also refuses an arm that
//! turns where bodies share loads by mass, because then each body has an acceleration of its own.

use serde_json::Value;

use super::fault::{Fault, FaultKind};
use super::setup::Setup;
use crate::grasp::inside;
use crate::words::printable;

impl Setup<3> {
    /// Refuses the questions of a scene that count a weight twice, or that turn an arm with several bodies. The questions are checked in `text`, because in the setup a mass has already
    /// become a force.
    pub(super) fn refuse_in_scene(&self, text: &[u8]) -> Result<(), Fault> {
        if self.own_mass().is_none() && !self.shared_by_mass {
            return Ok(());
        }
        let (scene, space): (Value, _) =
            (serde_json::from_slice(text).unwrap_or_default(), self.space.name());
        self.refuse_twice(&scene[space]["questions"], &format!("{space}.questions"))
    }
}

impl<const C: usize> Setup<C> {
    /// Refuses a question, given as JSON, that states a mass, or a weight whose direction turns, for bodies on which the gravity of the scene already
    /// acts. Also refuses a question in which an arm turns whose bodies share loads by mass. `path` is the path of the question in the text, for the message.
    ///
    /// # Errors
    /// A [`Fault`] that names the field, and how to count the weight once.
    pub fn refuse_weight_twice(&self, question: &Value, path: &str) -> Result<(), Fault> {
        inside(self).refuse_twice(question, path)
    }
}

impl Setup<3> {
    /// Refuses a question that states a mass, or a weight whose direction turns, for bodies on which the gravity of the scene already acts. Vectors
    /// have three components; in the plane the third is zero.
    fn refuse_twice(&self, question: &Value, path: &str) -> Result<(), Fault> {
        let twice = || self.own_mass().and_then(|_| self.weight_twice(question, path, None));
        let shares = self.shared_by_mass && self.bodies.len() > 1;
        match shares.then(|| turning(question, path)).flatten().or_else(twice) {
            Some((field, message)) => {
                Err(Fault { kind: FaultKind::Scene, message, field: Some(field), at: None })
            }
            None => Ok(()),
        }
    }

    /// The path of the first field within `value` that counts a weight twice, and the message about it; `None` if no field does. `path` is the path
    /// of `value`, and `body` the name of the body on which its loads act; `None` for the body on which the loads of questions act.
    fn weight_twice(&self, value: &Value, path: &str, body: Option<&str>) -> Option<(String, String)> {
        let fields = match value {
            Value::Array(list) => {
                let mut all = list.iter().enumerate();
                return all.find_map(|(i, value)| self.weight_twice(value, &format!("{path}[{i}]"), body));
            }
            Value::Object(fields) => fields,
            _ => return None,
        };
        let no_gravity = fields.get("gravity").and_then(Value::as_array);
        let no_gravity = no_gravity.is_some_and(|row| row.iter().all(|x| x.as_f64() == Some(0.0)));
        for (name, value) in fields {
            let (path, called) = (format!("{path}.{name}"), |name| printable(name));
            match name.as_str() {
                "mass" if !no_gravity => {
                    let Some(body) = self.weighty_body(body) else { continue };
                    let accelerated = if self.shared_by_mass || self.bodies.len() == 1 {
                        "`accelerated` without `mass`"
                    } else {
                        "this load with \"gravity\" all zeros"
                    };
                    let message = format!(
                        "the scene's gravity already pulls at {}, which has a mass: what lies on it besides is said by its weight as a force, and what accelerates it by {accelerated}",
                        called(body)
                    );
                    return Some((path, message));
                }
                "weight" => {
                    let body = self.bodies.iter().find(|body| body.mass > 0.0)?;
                    let message = format!(
                        "the scene's gravity already pulls at {}, which has a mass: leave out weight and at, and gravity itself turns",
                        called(&body.name)
                    );
                    return Some((path, message));
                }
                "together_with" | "body_loads_by" | "body_loads_to" => {
                    let named = value.as_object().into_iter().flatten();
                    for (body, load) in named {
                        let found = self.weight_twice(load, &format!("{path}.{}", called(body)), Some(body));
                        if found.is_some() {
                            return found;
                        }
                    }
                }
                _ => {
                    let found = self.weight_twice(value, &path, body);
                    if found.is_some() {
                        return found;
                    }
                }
            }
        }
        None
    }
}

/// The path of the first load within `value` that is the inertia of a turning arm, and the message about it; `None` if there is none. `path` is the path
/// of `value`. Loads on single bodies may turn.
fn turning(value: &Value, path: &str) -> Option<(String, String)> {
    const OF_EACH: &str = "must be left out where bodies share loads by mass, since each has an acceleration of its own; say the inertia of each under together_with";
    match value {
        Value::Array(list) => {
            list.iter().enumerate().find_map(|(i, value)| turning(value, &format!("{path}[{i}]")))
        }
        Value::Object(fields) => fields.iter().find_map(|(name, value)| match &**name {
            "together_with" | "body_loads_by" | "body_loads_to" => None,
            "turning" => Some((format!("{path}.turning"), OF_EACH.to_owned())),
            _ => turning(value, &format!("{path}.{name}")),
        }),
        _ => None,
    }
}
