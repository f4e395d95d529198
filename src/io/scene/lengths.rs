//! Converts lengths in the text of a scene from mm, cm or inches to m (feature `json`). A scene is a grasp with its questions. A command is the
//! displacement that a finger, joint or tendon would make without the object. The conversion works on the text, where field names distinguish lengths
//! from other numbers. The text also has the points at which loads act, while a wrench keeps only the moment that follows from such a point.

use serde_json::{Map, Value};

use super::fault::{Fault, message_of};
use super::plain_words::in_plain_words;
use super::setup::Setup;
use super::suspicious_numbers::far_load;
use super::warning::Warning;
use super::written::Scene;
use crate::numerics::Reals;
use crate::words::Unit;

/// Names of fields whose values are lengths, provided that the value is a number or a list of numbers.
const LENGTHS: [&str; 32] = [
    "about",
    "at",
    "centre",
    "centre_of_mass",
    "clearance",
    "closed_spline",
    "command",
    "command_change",
    "command_world",
    "commands_by",
    "commands_to",
    "corner",
    "disc",
    "from",
    "layouts",
    "length",
    "outline",
    "point",
    "polyline",
    "pull",
    "radius",
    "rectangle",
    "round",
    "segment",
    "sides",
    "size",
    "slack",
    "spline",
    "thickness",
    "to",
    "triangles",
    "width",
];

/// Reads the scene in `text`, whose lengths are in `unit`, and converts these lengths to m.
pub(super) fn in_metres(text: &[u8], unit: Unit) -> Result<Scene, Fault> {
    let fault = |error: serde_json::Error| Fault::of_scene(in_plain_words(&message_of(&error), None));
    let mut scene: Value = serde_json::from_slice(text).map_err(fault)?;
    for space in ["planar", "spatial"] {
        if let Some(setup) = scene[space].as_object_mut() {
            Lengths::of(setup, unit)?.setup(setup);
        }
    }
    if let Some(fields) = scene.as_object_mut() {
        fields.remove("unit");
    }
    // The JSON value is converted to text and read again. If it were read from the `Value` directly, the whole deserialiser would be compiled a
    // second time.
    let scene: Scene = serde_json::from_slice(&serde_json::to_vec(&scene).map_err(fault)?).map_err(fault)?;
    Ok(Scene { unit, ..scene })
}

impl Scene {
    /// A warning about a load whose point of action lies far outside of the grasp, although its line of action passes near the grasp. `text` is the
    /// scene's text. Loads whose line of action is far from the grasp are not reported here, but by [`Self::warnings`].
    #[must_use]
    pub fn far_load_in(&self, text: &[u8]) -> Option<Warning> {
        let scene: Value = serde_json::from_slice(text).unwrap_or_default();
        self.setup.far_load_in(&scene[self.setup.space.name()]["questions"], self.unit)
    }
}

impl Setup<3> {
    fn far_load_in(&self, questions: &Value, unit: Unit) -> Option<Warning> {
        let (centre, size) = self.middle();
        let mut farthest = 0.0_f64;
        each_at(questions, &mut |at| {
            let place = |a: usize| unit.in_metres(at.get(a).and_then(Value::as_f64).unwrap_or_default());
            let squares = (0..self.space.axes()).map(|a| (place(a) - centre[a]).powi(2));
            farthest = farthest.max(squares.added().sqrt());
        });
        let has_bodies = !self.bodies.is_empty();
        far_load(farthest, size).filter(|_| !has_bodies && self.odd_loads().is_empty())
    }
}

/// Calls `look` with every list that is the value of a field `at` (the point at which a load acts), anywhere within a JSON value.
fn each_at(value: &Value, look: &mut dyn FnMut(&[Value])) {
    match value {
        Value::Array(list) => list.iter().for_each(|value| each_at(value, look)),
        Value::Object(fields) => {
            for (name, value) in fields {
                match value {
                    Value::Array(at) if name == "at" => look(at),
                    value => each_at(value, look),
                }
            }
        }
        _ => {}
    }
}

/// Converts the lengths of a scene's text to m. The kinds of the joints are needed, since the command of a prismatic joint is a length, that of a
/// revolute joint an angle.
struct Lengths {
    unit: Unit,
    /// For each joint of all fingers, whether the joint is prismatic, i.e. has a length as its command.
    is_prismatic: Vec<bool>,
}

impl Lengths {
    fn of(setup: &Map<String, Value>, unit: Unit) -> Result<Self, Fault> {
        if setup.contains_key("robot") {
            return Err(Fault::of_scene(format!(
                "unit: {unit} given, must be m beside a robot, whose file is in m"
            )));
        }
        let mut is_prismatic = Vec::new();
        for finger in setup.get("fingers").and_then(Value::as_array).into_iter().flatten() {
            for joint in finger["joints"].as_array().into_iter().flatten() {
                is_prismatic.push(joint["prismatic"].is_array());
            }
            let has_jacobian = |contact: &Value| contact["moved_by"]["jacobian"].is_array();
            if finger["contacts"].as_array().into_iter().flatten().any(has_jacobian) {
                return Err(Fault::of_scene(format!(
                    "unit: {unit} given, must be m beside a jacobian, whose columns are in m/rad or have no unit"
                )));
            }
        }
        Ok(Self { unit, is_prismatic })
    }

    fn setup(&self, setup: &mut Map<String, Value>) {
        self.object(setup, "");
        if let Some(part) = setup.get_mut("part").and_then(Value::as_object_mut) {
            part.entry("unit").or_insert_with(|| self.unit.to_string().into());
        }
    }

    /// Converts to m those fields of a JSON object that are lengths. `of` is the name of the field that has this JSON object as its value, or "".
    fn object(&self, fields: &mut Map<String, Value>, of: &str) {
        let is_turning = of == "joints" && !fields.contains_key("prismatic");
        for (name, value) in fields {
            match (name.as_str(), value) {
                // The command of a revolute joint is an angle, and is not converted.
                ("command", _) if is_turning => {}
                // The keys of these objects are names of bodies, not of fields; their values are loads, which may contain lengths.
                ("together_with" | "body_loads_by" | "body_loads_to", Value::Object(loads)) => {
                    for load in loads.values_mut().filter_map(Value::as_object_mut) {
                        self.object(load, "");
                    }
                }
                ("joints_by" | "joints_to" | "joint_change", Value::Array(all)) => {
                    // These lists have the commands of the joints first, then those of the tendons, which are lengths.
                    self.each(all, |joint| self.is_prismatic.get(joint).is_none_or(|is| *is));
                }
                ("arms", Value::Array(all)) => {
                    self.each(all, |joint| self.is_prismatic.get(joint).is_none_or(|is| !is));
                }
                (name, value @ (Value::Number(_) | Value::Array(_)))
                    if LENGTHS.contains(&name) || (of, name) == ("cylinder", "axis") =>
                {
                    self.all(value);
                }
                (name, value) => self.within(value, name),
            }
        }
    }

    fn within(&self, value: &mut Value, of: &str) {
        match value {
            Value::Array(list) => list.iter_mut().for_each(|value| self.within(value, of)),
            Value::Object(fields) => self.object(fields, of),
            _ => {}
        }
    }

    /// Converts to m those entries of a JSON list for whose index `is_length` returns true.
    fn each(&self, list: &mut [Value], is_length: impl Fn(usize) -> bool) {
        for (index, value) in list.iter_mut().enumerate() {
            if is_length(index) {
                self.all(value);
            }
        }
    }

    /// Converts all numbers within a JSON value to m.
    fn all(&self, value: &mut Value) {
        match value {
            Value::Array(list) => list.iter_mut().for_each(|value| self.all(value)),
            Value::Number(_) => *value = self.unit.in_metres(value.as_f64().unwrap_or_default()).into(),
            _ => {}
        }
    }
}
