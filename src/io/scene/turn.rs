//! Turning loads as written: the weight of a tilted object, a force that turns, or three wrenches.
//!
//! The weight is `{"weight": [0, -2], "at": [0, 0.1]}` in the plane; in space it has an `"axis"`. A force that turns has `"force"` instead, and three
//! wrenches are `"constant"`, `"cosine"` and `"sine"`. If none of these loads is given, the gravity of the scene's bodies turns. A turn is written
//! back as the three wrenches, or with its axis alone if the bodies' gravity turns.

use crate::numerics::Each;
use std::f64::consts::TAU;

use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, SerializeStruct, Serializer};

use super::wrench::vector_of_field;
use crate::grasp::{Space, Wrench};
use crate::load_path::Turn;
#[cfg(feature = "schema")]
use crate::serial::AxisRow;
use crate::serial::{Computed, Given, Number, ShortList, object, space_of_text};

#[derive(serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, bound = "")]
struct WrittenTurn<const C: usize> {
    /// The weight, N, of an object that is tilted with its grasp. If no load of the turn is given, the scene's own `gravity` turns.
    #[cfg_attr(feature = "schema", schemars(with = "Option<AxisRow<Given, C>>"))]
    weight: Option<ShortList<Given, 3>>,
    /// A force that turns, N, instead of a weight.
    #[cfg_attr(feature = "schema", schemars(with = "Option<AxisRow<Given, C>>"))]
    force: Option<ShortList<Given, 3>>,
    /// The point where the weight or force acts, m; the origin if left out.
    #[cfg_attr(feature = "schema", schemars(with = "Option<AxisRow<Given, C>>"))]
    at: Option<ShortList<Given, 3>>,
    /// The axis of the turn by the right-hand rule, of any length but zero; in space only.
    #[cfg_attr(feature = "schema", schemars(with = "Option<AxisRow<Given, 3>>"))]
    axis: Option<ShortList<Given, 3>>,
    /// A constant wrench in addition to the weight or force.
    beside: Option<Wrench<C>>,
    /// The constant part of `constant + cosine cos θ + sine sin θ`, instead of a weight or force.
    constant: Option<Wrench<C>>,
    /// The wrench that is multiplied by cos θ.
    cosine: Option<Wrench<C>>,
    /// The wrench that is multiplied by sin θ.
    sine: Option<Wrench<C>>,
    /// The angle of the turn, degrees; a full turn if left out.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    angle_deg: Option<Number<Given>>,
    /// The angle of the turn, rad, instead of `angle_deg`.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    angle_rad: Option<Number<Given>>,
    /// Whether the turn is reversed: from y to x in the plane, against the right-hand rule in space.
    #[serde(default)]
    reversed: bool,
}

impl<const C: usize> WrittenTurn<C> {
    /// The turn that the given fields describe.
    fn turn(&self) -> Result<Turn<C>, String> {
        let turn = match (&self.weight, &self.force) {
            (None, None) if self.turns_nothing() => Turn::of_bodies(self.axis()?.into()),
            (None, None) => self.of_wrenches()?,
            (Some(weight), None) => self.of_force("weight", weight)?.reversed(),
            (None, Some(force)) => self.of_force("force", force)?,
            (Some(_), Some(_)) => return Err("weight and force: a turn has one of them".to_owned()),
        };
        let turn = if self.reversed { turn.reversed() } else { turn };
        let angle = match (&self.angle_deg, &self.angle_rad) {
            (None, None) => TAU,
            // 5.7e7 degrees lie just below 1e6 rad, the largest angle of a turn.
            (Some(degrees), None) if !(degrees.0 > 0.0 && degrees.0 <= 5.7e7) => {
                return Err(format!("angle_deg is {}, must be more than 0 and at most 5.7e7", degrees.0));
            }
            (Some(degrees), None) => degrees.0.to_radians(),
            (None, Some(angle)) => angle.0,
            (Some(_), Some(_)) => return Err("angle_deg and angle_rad: a turn has one of them".to_owned()),
        };
        let turn = turn.up_to(angle);
        let checked = if turn.tilts_bodies_about.is_some() {
            turn.check_angle()
        } else {
            turn.check_in(space_of_text::<C>())
        };
        checked.map_err(|error| error.to_string())?;
        Ok(turn)
    }

    /// Whether the turn is given without a load; the scene's gravity then turns.
    fn turns_nothing(&self) -> bool {
        let wrenches = [&self.beside, &self.constant, &self.cosine, &self.sine];
        self.at.is_none() && wrenches.iter().all(|given| given.is_none())
    }

    /// The axis of the turn; in the plane z, since the turn goes from x to y.
    fn axis(&self) -> Result<[f64; 3], String> {
        match (space_of_text::<C>().axes(), &self.axis) {
            (3, Some(axis)) => vector_of_field(Some(axis), 3, "axis"),
            (3, None) => Err("missing field `axis` of a turn in space".to_owned()),
            (_, Some(_)) => Err("axis: a turn of the plane has none, it goes from x to y".to_owned()),
            (_, None) => Ok([0.0, 0.0, 1.0]),
        }
    }

    /// The turn of a force that acts at a point: in the plane from x to y, in space by the right-hand rule.
    fn of_force(&self, name: &str, force: &ShortList<Given, 3>) -> Result<Turn<C>, String> {
        let wrenches = [("constant", &self.constant), ("cosine", &self.cosine), ("sine", &self.sine)];
        if let Some((other, _)) = wrenches.iter().find(|(_, given)| given.is_some()) {
            return Err(format!("{name} and {other}: a turn has one of them"));
        }
        let space = space_of_text::<C>();
        let axes = space.axes();
        let (force, at) =
            (vector_of_field(Some(force), axes, name)?, vector_of_field(self.at.as_ref(), axes, "at")?);
        let turn = Turn::<3>::force_at(force, at, self.axis()?).map_err(|error| error.to_string())?;
        let narrowed = |part: Wrench<3>| {
            Wrench::among(space, &part.coordinates(space)).acting_at(part.points_of_action())
        };
        let [constant, cosine, sine] = turn.parts().map(narrowed);
        Ok(Turn::new(constant, cosine, sine).beside(self.beside.unwrap_or(Wrench::ZERO)))
    }

    fn of_wrenches(&self) -> Result<Turn<C>, String> {
        let of_forces =
            [("at", self.at.is_some()), ("axis", self.axis.is_some()), ("beside", self.beside.is_some())];
        if let Some((name, _)) = of_forces.iter().find(|(_, given)| *given) {
            return Err(format!("{name}: of a weight or a force that turns alone"));
        }
        if self.cosine.is_none() && self.sine.is_none() {
            return Err("nothing turns: give weight, or force, or cosine and sine".to_owned());
        }
        let [constant, cosine, sine] =
            [self.constant, self.cosine, self.sine].each(|part| part.unwrap_or(Wrench::ZERO));
        Ok(Turn::new(constant, cosine, sine))
    }
}

/// Written as `{"constant": …, "cosine": …, "sine": …, "angle_rad": …}` (feature `serde`), see [`crate::scene`].
impl<const C: usize> Serialize for Turn<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if let Some(axis) = self.tilts_bodies_about {
            let mut out = serializer.serialize_struct("Turn", 3)?;
            let is_planar = space_of_text::<C>() == Space::Planar;
            if !is_planar {
                out.serialize_field("axis", &ShortList::<Computed, 3>::of(axis.as_slice()))?;
            }
            out.serialize_field("angle_rad", &Number::<Computed>::new(self.angle()))?;
            out.serialize_field("reversed", &(is_planar && axis[2] < 0.0))?;
            return out.end();
        }
        let [constant, cosine, sine] = self.parts();
        let mut out = serializer.serialize_struct("Turn", 4)?;
        out.serialize_field("constant", &constant)?;
        out.serialize_field("cosine", &cosine)?;
        out.serialize_field("sine", &sine)?;
        out.serialize_field("angle_rad", &Number::<Computed>::new(self.angle()))?;
        out.end()
    }
}

/// Read from a weight that is tilted, a force that turns, or three wrenches (feature `serde`), see [`crate::scene`]. Refuses a turn that
/// [`Grasp::onset_of_turn`](crate::ask::Grasp::onset_of_turn) refuses.
impl<'de, const C: usize> Deserialize<'de> for Turn<C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        object::read(deserializer, "a turn", |written: WrittenTurn<C>| written.turn())
    }
}

#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Turn", Turn<C>, WrittenTurn<C>, C);
