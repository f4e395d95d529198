//! Completes the loads of questions in the text of a scene (feature `json`). If all bodies share a load, each in proportion to its mass, a force or a
//! mass without a point acts at their common centre of mass. An acceleration without a mass accelerates the masses of the bodies. A mass that a load
//! states is pulled by the scene's gravity, unless the load has a gravity of its own.

use serde_json::{Map, Value};

use super::setup::Setup;
use super::written::Scene;

/// The text of a scene with missing masses, centres of mass and gravity added to its loads; `None` if no load lacks them.
pub(super) fn with_centre_of_mass(text: &[u8]) -> Option<Vec<u8>> {
    let mut scene: Value = serde_json::from_slice(text).ok()?;
    complete(&mut scene).then(|| serde_json::to_vec(&scene).ok()).flatten()
}

impl<const C: usize> Setup<C> {
    /// A question or a load in JSON, completed with the masses, centres of mass and gravity that a scene adds to loads without them. `None` if there
    /// is nothing to add.
    #[must_use]
    pub fn completed(&self, question: &Value) -> Option<Value> {
        if !self.shared_by_mass && self.gravity.is_none() {
            return None;
        }
        let (space, mut scene) = (self.space.name(), serde_json::to_value(Scene::from(self.clone())).ok()?);
        scene[space]["questions"] = Value::Array(vec![question.clone()]);
        complete(&mut scene).then(|| scene[space]["questions"][0].take())
    }
}

/// Adds masses, centres of mass and gravity to the loads of a scene that lack them; returns whether a load was changed.
fn complete(scene: &mut Value) -> bool {
    let mut is_written = false;
    for (space, axes) in [("planar", 2), ("spatial", 3)] {
        let Some(setup) = scene.get_mut(space).and_then(Value::as_object_mut) else { continue };
        let (all, gravity) = (AllBodies::of(setup, axes), setup.get("gravity").cloned());
        let Some(questions) = setup.get_mut("questions") else { continue };
        is_written |= all.is_some_and(|all| all.write_into(questions));
        is_written |= gravity.is_some_and(|gravity| weigh(questions, &gravity));
    }
    is_written
}

/// Adds the scene's gravity to all loads that have a mass and no gravity of their own; returns whether a load was changed.
fn weigh(value: &mut Value, gravity: &Value) -> bool {
    match value {
        Value::Array(list) => list.iter_mut().fold(false, |written, value| weigh(value, gravity) | written),
        Value::Object(fields) => {
            let is_light = fields.contains_key("mass") && !fields.contains_key("gravity");
            if is_light {
                fields.insert("gravity".to_owned(), gravity.clone());
            }
            fields.values_mut().fold(is_light, |written, value| weigh(value, gravity) | written)
        }
        _ => false,
    }
}

/// The total mass of all bodies, kg, and their common centre of mass, in the unit of lengths of the scene's text.
struct AllBodies {
    mass: f64,
    centre: Vec<f64>,
    /// Whether loads of questions act on all bodies, on each in proportion to its mass.
    share: bool,
    /// Whether the scene's gravity pulls at the bodies; an acceleration then needs no mass.
    are_heavy: bool,
}

impl AllBodies {
    /// The total mass of all bodies and their common centre of mass. `None` unless the loads of questions act on all bodies, and the bodies have a
    /// mass.
    fn of(setup: &Map<String, Value>, axes: usize) -> Option<Self> {
        let bodies = setup.get("bodies")?.as_array()?;
        let share = setup.get("shared_by_mass").and_then(Value::as_bool).unwrap_or(false);
        let (mut mass, mut centre) = (0.0, vec![0.0; axes]);
        for body in bodies {
            let one = body["mass"].as_f64().unwrap_or(0.0);
            mass += one;
            for (axis, moment) in centre.iter_mut().enumerate() {
                *moment += one * body["centre_of_mass"][axis].as_f64().unwrap_or(0.0);
            }
        }
        for moment in &mut centre {
            *moment /= mass;
        }
        let acts_on_all = share || bodies.len() == 1;
        (acts_on_all && mass > 0.0).then(|| Self {
            mass,
            centre,
            share,
            are_heavy: setup.contains_key("gravity"),
        })
    }

    /// Adds the missing `mass` and `at` to all loads of a question; returns whether a load was changed.
    fn write_into(&self, value: &mut Value) -> bool {
        let mut is_written = false;
        match value {
            Value::Array(list) => {
                for value in list {
                    is_written |= self.write_into(value);
                }
            }
            Value::Object(fields) => {
                is_written = self.complete(fields);
                for (name, value) in fields {
                    // Loads in these fields act on one body each. Only loads that act on all bodies get a mass and a point.
                    let is_on_one = matches!(&**name, "together_with" | "body_loads_by" | "body_loads_to");
                    is_written |= !is_on_one && self.write_into(value);
                }
            }
            _ => {}
        }
        is_written
    }

    fn complete(&self, load: &mut Map<String, Value>) -> bool {
        let has = |name: &str| load.contains_key(name);
        if has("at") {
            return false;
        }
        let accelerates = self.are_heavy && has("accelerated") && !has("mass");
        // A force that is given with a moment gets no point `at`: it is a wrench about the origin, the form in which answers write loads.
        let pulls =
            self.share && !has("moment") && ["force", "weight", "mass", "any_force"].into_iter().any(has);
        if accelerates {
            load.insert("mass".to_owned(), self.mass.into());
            let axes = self.centre.len();
            load.entry("gravity").or_insert_with(|| vec![0.0; axes].into());
        }
        if accelerates || pulls {
            load.insert("at".to_owned(), self.centre.clone().into());
        }
        accelerates || pulls
    }
}
