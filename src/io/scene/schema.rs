//! JSON Schemas that are not derived: of vectors written as rows, of wrenches, and of numbers that may be words such as "infinite". Also the schemas
//! of types with their own deserialiser.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde_json::Value;

use super::springs::Springs;
use super::written::{FORMAT, Format};
use crate::error::LARGEST;
use crate::grasp::{Space, Twist, Wrench};
use crate::numerics::mapped;
use crate::serial::{As, AxisRow, Computed, Friction, Given, Kind, Number, Numeric, SpringStiffness};

/// A kind of number whose schema contains the allowed range.
trait Bounded: Kind + 'static {
    fn name() -> &'static str;
    fn bounds() -> Schema;
}

impl Bounded for Given {
    fn name() -> &'static str {
        "Given"
    }
    fn bounds() -> Schema {
        json_schema!({ "minimum": -LARGEST, "maximum": LARGEST })
    }
}

impl Bounded for Friction {
    fn name() -> &'static str {
        "Friction"
    }
    fn bounds() -> Schema {
        json_schema!({ "minimum": 0 })
    }
}

impl Bounded for SpringStiffness {
    fn name() -> &'static str {
        "SpringStiffness"
    }
    fn bounds() -> Schema {
        json_schema!({ "exclusiveMinimum": 0 })
    }
}

impl Bounded for Computed {
    fn name() -> &'static str {
        "Computed"
    }
    fn bounds() -> Schema {
        json_schema!({})
    }
}

impl<K: Bounded> JsonSchema for Number<K> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        K::name().into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        number::<K>()
    }
}

/// The schema of a number within its range, or a word for a number, such as "infinite".
fn number<K: Bounded>() -> Schema {
    let mut number = K::bounds();
    number.insert("type".to_owned(), "number".into());
    if K::WORDS.is_empty() {
        return number;
    }
    let words: Vec<&str> = mapped(K::WORDS, &|(word, _)| *word);
    json_schema!({ "anyOf": [number, { "enum": words }] })
}

/// The schema of a list whose length lies between two numbers.
fn list<K: Bounded>(least: usize, most: usize) -> Schema {
    json_schema!({ "type": "array", "items": number::<K>(), "minItems": least, "maxItems": most })
}

impl<K: Bounded, const C: usize> JsonSchema for AxisRow<K, C> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        format!("RowOf{C}{}", K::name()).into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        list::<K>(C, C)
    }
}

impl<K: Kind, T: Numeric<K>> JsonSchema for As<K, T>
where
    T::Written: JsonSchema,
{
    fn inline_schema() -> bool {
        T::Written::inline_schema()
    }

    fn schema_name() -> Cow<'static, str> {
        T::Written::schema_name()
    }

    fn schema_id() -> Cow<'static, str> {
        T::Written::schema_id()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        T::Written::json_schema(generator)
    }

    // The code that schemars derives calls this function to decide whether a generic field is optional, because it cannot write the default of such a
    // field.
    fn _schemars_private_is_option() -> bool {
        T::Written::_schemars_private_is_option()
    }
}

/// The schema of an angular quantity: in the plane a number or a list of one number, in space a list of three.
fn angular<K: Bounded>(axes: usize) -> Schema {
    let listed = list::<K>(axes, axes);
    if axes == 1 { json_schema!({ "anyOf": [number::<K>(), listed] }) } else { listed }
}

/// The schema of a wrench or twist: linear and angular components, both optional in input.
fn by_parts<K: Bounded, const C: usize>(
    generator: &SchemaGenerator,
    [linear, turning]: [(&str, &str); 2],
) -> Schema {
    let first = described(generator, list::<K>(C, C), linear.1);
    let second = described(generator, angular::<K>(Space::of::<C>().planes().len()), turning.1);
    let required = if generator.contract().is_serialize() { vec![linear.0, turning.0] } else { Vec::new() };
    json_schema!({
        "type": "object",
        "properties": { linear.0: first, turning.0: second },
        "required": required
    })
}

/// Adds a description to `part`, the schema of a component of a wrench or twist. In input the component may be `null`.
fn described(generator: &SchemaGenerator, part: Schema, description: &str) -> Schema {
    let mut part = if generator.contract().is_serialize() {
        part
    } else {
        json_schema!({ "anyOf": [part, { "type": "null" }] })
    };
    part.insert("description".to_owned(), description.into());
    part
}

/// The schema of the rotation of the arm that carries a body.
fn turning<const C: usize>(generator: &SchemaGenerator) -> Schema {
    let rate = || angular::<Given>(Space::of::<C>().planes().len());
    let about = described(generator, list::<Given>(C, C), "A point of the axis, m; the origin if left out.");
    let velocity = [("velocity_deg", "degrees/s."), ("velocity_rad", "rad/s, in place of it.")];
    let speeding = [("acceleration_deg", "degrees/s²."), ("acceleration_rad", "rad/s², in place of it.")];
    let mut schema =
        json_schema!({ "type": "object", "properties": { "about": about }, "additionalProperties": false });
    if let Some(properties) = schema.get_mut("properties").and_then(Value::as_object_mut) {
        for (name, unit) in velocity.into_iter().chain(speeding) {
            properties.insert(name.to_owned(), described(generator, rate(), unit).into());
        }
    }
    schema
}

impl<const C: usize> JsonSchema for Wrench<C> {
    fn schema_name() -> Cow<'static, str> {
        "Wrench".into()
    }

    fn schema_id() -> Cow<'static, str> {
        format!("wrench of {C} axes").into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let parts = [("force", "N."), ("moment", "About the origin, N m.")];
        if generator.contract().is_serialize() {
            return by_parts::<Computed, C>(generator, parts);
        }
        let mut schema = by_parts::<Given, C>(generator, parts);
        let at = list::<Given>(C, C);
        let at = described(
            generator,
            at,
            "Where the force acts, m; at the origin if left out, or at the common centre of mass if shared by mass.",
        );
        if let Some(properties) = schema.get_mut("properties").and_then(Value::as_object_mut) {
            properties.insert("at".to_owned(), at.into());
            let turns = Space::of::<C>().planes().len();
            let body = [
                ("mass", number::<Given>(), "Of a body that an arm carries, kg; its centre is `at`."),
                ("inertia", angular::<Given>(turns), "Of the body about its centre, kg m²."),
                (
                    "gravity",
                    list::<Given>(C, C),
                    "m/s²; that of the scene if left out, or 9.81 down the last axis.",
                ),
                (
                    "accelerated",
                    list::<Given>(C, C),
                    "Acceleration of the arm, m/s². Without a mass, of all bodies that share by mass.",
                ),
                ("turning", turning::<C>(generator), "How the arm turns."),
            ];
            for (name, part, description) in body {
                properties.insert(name.to_owned(), described(generator, part, description).into());
            }
        }
        schema.insert("additionalProperties".to_owned(), false.into());
        schema
    }
}

impl<const C: usize> JsonSchema for Twist<C> {
    fn schema_name() -> Cow<'static, str> {
        "Twist".into()
    }

    fn schema_id() -> Cow<'static, str> {
        format!("twist of {C} axes").into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        by_parts::<Computed, C>(generator, [("translation", "Of the origin, m."), ("rotation", "rad.")])
    }
}

impl<const C: usize> JsonSchema for Springs<C> {
    fn schema_name() -> Cow<'static, str> {
        "Springs".into()
    }

    fn schema_id() -> Cow<'static, str> {
        format!("springs of {C} axes").into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "One stiffness for all directions, or a list: normal and tangential; in space also normal, first and second tangent.",
            "anyOf": [number::<SpringStiffness>(), list::<SpringStiffness>(1, C)]
        })
    }
}

/// Adds the field `stiffness`, another name of `series_stiffness`, to the schema of a contact. The derive macro does not know the other name.
pub(super) fn with_stiffness(contact: &mut Schema) {
    let fields = contact.get_mut("properties").and_then(Value::as_object_mut);
    if let Some((fields, mut other)) = fields.and_then(|fields| {
        let other = fields.get("series_stiffness")?.clone();
        Some((fields, other))
    }) {
        other["description"] = "Another name of `series_stiffness`.".into();
        fields.insert("stiffness".to_owned(), other);
    }
}

impl JsonSchema for Format {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Format".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "const": FORMAT })
    }
}
