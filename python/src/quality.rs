//! Force and form closure, load limits, least squeeze and weakest direction.

use grasp_lcp::grasp::{BodyMotion, Wrench};
use grasp_lcp::load_path::{DepartingPart, Turn};
use grasp_lcp::nalgebra::SVector;
use grasp_lcp::squeeze::{LeastSqueeze, Loads, WeakestDirection};
use grasp_lcp::statics::{Budget, Closure, LoadLimit};
use numpy::{PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use serde_json::{Value, json};

use crate::errors::{of_json, refused, wrong};
use crate::loads::{point, wrench};
use crate::stored_grasp::StoredGrasp;

type OptionalArgument<'a, 'py> = Option<&'a Bound<'py, PyAny>>;

/// Questions about closure, limits and squeeze of a grasp. Answers are JSON in the style of scenes.
pub(crate) trait Quality {
    fn closure(&self, friction: bool) -> PyResult<String>;
    fn ball(&self, py: Python<'_>, budget: f64, each: bool) -> PyResult<String>;
    fn load_limit(
        &self,
        direction: &Bound<'_, PyAny>,
        base: OptionalArgument<'_, '_>,
        budget: f64,
        each: bool,
    ) -> PyResult<String>;
    fn least_squeeze_of_loads(&self, loads: PyReadonlyArray2<'_, f64>) -> PyResult<String>;
    fn least_squeeze_of_turn(&self, turn: &str) -> PyResult<String>;
    fn least_squeeze_of_any_force(
        &self,
        size: f64,
        base: OptionalArgument<'_, '_>,
        at: OptionalArgument<'_, '_>,
    ) -> PyResult<String>;
    fn weakest_direction(
        &self,
        base: OptionalArgument<'_, '_>,
        at: OptionalArgument<'_, '_>,
    ) -> PyResult<String>;
}

impl<const C: usize> Quality for StoredGrasp<C> {
    fn closure(&self, friction: bool) -> PyResult<String> {
        let question = if friction { "force_closure" } else { "form_closure" };
        let grasp = &self.without_hand(question).map_err(refused)?;
        let settings = &self.setup.settings;
        let closure = if friction {
            grasp.with(settings).statics().force_closure()
        } else {
            grasp.statics().form_closure()
        };
        text(&match closure.map_err(refused)? {
            Closure::Closed { internal, .. } => json!({"outcome": "closed", "internal": rows(&internal)}),
            Closure::Open { motion, bodies, .. } if bodies.is_empty() => {
                json!({"outcome": "open", "motion": moved(&motion)})
            }
            Closure::Open { motion, bodies, .. } => {
                let each = |body: &BodyMotion<C>| json!({"body": &*body.body, "twist": moved(&body.twist)});
                let bodies: Vec<_> = bodies.iter().map(each).collect();
                json!({"outcome": "open", "motion": moved(&motion), "bodies": bodies})
            }
            Closure::Boundary => json!({"outcome": "boundary"}),
            _ => undecided(),
        })
    }

    fn ball(&self, py: Python<'_>, budget: f64, each: bool) -> PyResult<String> {
        let grasp = self.without_joints("quality").map_err(refused)?;
        let ball = py.detach(|| grasp.statics().ferrari_canny(of(budget, each))).map_err(refused)?;
        let [at_least, at_most] = [ball.at_least, ball.at_most].map(number);
        text(&json!({"at_least": at_least, "at_most": at_most, "weakest": pulled(&ball.weakest)}))
    }

    fn load_limit(
        &self,
        direction: &Bound<'_, PyAny>,
        base: OptionalArgument<'_, '_>,
        budget: f64,
        each: bool,
    ) -> PyResult<String> {
        let grasp = self.without_joints("load_limit").map_err(refused)?;
        let (base, direction) = (base_of(base)?, wrench("direction", direction)?);
        let budget = of(budget, each);
        let limit = grasp.with(&self.setup.settings).statics().load_limit(base, direction, budget);
        text(&match limit.map_err(refused)? {
            LoadLimit::Factor { at_least, at_most, forces, motion, .. } => {
                let [at_least, at_most] = [at_least, at_most].map(number);
                let (forces, motion) = (rows(&forces), moved(&motion));
                json!({"outcome": "factor", "at_least": at_least, "at_most": at_most, "forces": forces, "motion": motion})
            }
            LoadLimit::NoBase { motion, .. } => json!({"outcome": "no_base", "motion": moved(&motion)}),
            _ => undecided(),
        })
    }

    fn least_squeeze_of_loads(&self, loads: PyReadonlyArray2<'_, f64>) -> PyResult<String> {
        let columns = loads.shape()[1];
        let all = C * (C + 1) / 2;
        if columns != C && columns != all {
            return Err(wrong(format_args!(
                "loads: rows of {columns} given, must be of {C} numbers of a force or {all} of a force and a moment"
            )));
        }
        let loads = loads.as_array();
        let load = |i: usize| Wrench::from_components(&loads.row(i).to_vec());
        self.least_squeeze(&Loads::Each((0..loads.nrows()).map(load).collect()))
    }

    fn least_squeeze_of_turn(&self, turn: &str) -> PyResult<String> {
        let turn: Turn<C> = serde_json::from_str(turn).map_err(|error| of_json("turn", &error))?;
        self.least_squeeze(&Loads::Turn(turn))
    }

    fn least_squeeze_of_any_force(
        &self,
        size: f64,
        base: OptionalArgument<'_, '_>,
        at: OptionalArgument<'_, '_>,
    ) -> PyResult<String> {
        self.least_squeeze(&Loads::AnyForce { base: base_of(base)?, size, point: point_of(at)? })
    }

    fn weakest_direction(
        &self,
        base: OptionalArgument<'_, '_>,
        at: OptionalArgument<'_, '_>,
    ) -> PyResult<String> {
        let grasp = self.without_joints("weakest_direction").map_err(refused)?;
        let (base, at) = (base_of::<C>(base)?, point_of::<C>(at)?);
        let weakest = grasp.with(&self.setup.settings).weakest_direction(base, at);
        text(&match weakest.map_err(refused)? {
            WeakestDirection::Force { size, direction, load, leaver, .. } => {
                let contact = if let DepartingPart::Contact(contact) = leaver { Some(contact) } else { None };
                let (size, direction) = (number(size), direction.map(number).to_vec());
                json!({"outcome": "force", "size": size, "direction": direction, "load": pulled(&load), "contact": contact})
            }
            WeakestDirection::Never => json!({"outcome": "never"}),
            WeakestDirection::GivesWay { motion, .. } => {
                json!({"outcome": "gives_way", "motion": moved(&motion)})
            }
            WeakestDirection::NotSticking => json!({"outcome": "not_sticking"}),
            _ => undecided(),
        })
    }
}

impl<const C: usize> StoredGrasp<C> {
    fn least_squeeze(&self, loads: &Loads<C>) -> PyResult<String> {
        let grasp = self.without_joints("least_squeeze").map_err(refused)?;
        let least = grasp.with(&self.setup.settings).least_squeeze(loads).map_err(refused)?;
        text(&match least {
            LeastSqueeze::Factor { factor, binding, .. } => {
                let (contact, load) =
                    binding.map_or((None, None), |(contact, load)| (Some(contact), Some(load)));
                let load = load.as_ref().map(pulled);
                json!({"outcome": "factor", "factor": number(factor), "contact": contact, "load": load})
            }
            LeastSqueeze::NoFactor { contact, load, factor, .. } => {
                json!({"outcome": "no_factor", "factor": number(factor), "contact": contact, "load": pulled(&load)})
            }
            LeastSqueeze::GivesWay { motion, .. } => {
                json!({"outcome": "gives_way", "motion": moved(&motion)})
            }
            _ => undecided(),
        })
    }
}

fn of(budget: f64, each: bool) -> Budget {
    if each { Budget::Each(budget) } else { Budget::Total(budget) }
}

fn base_of<const C: usize>(given: OptionalArgument<'_, '_>) -> PyResult<Wrench<C>> {
    given.map_or(Ok(Wrench::ZERO), |given| wrench("base", given))
}

fn point_of<const C: usize>(given: OptionalArgument<'_, '_>) -> PyResult<[f64; C]> {
    given.map_or(Ok([0.0; C]), |given| point("at", given))
}

fn undecided() -> Value {
    json!({"outcome": "undecided"})
}

fn text(value: &Value) -> PyResult<String> {
    serde_json::to_string(value).map_err(wrong)
}

/// A number, or the scene format's word for a number that JSON cannot express, such as "infinite".
fn number(x: f64) -> Value {
    match x {
        _ if x.is_finite() => x.into(),
        f64::INFINITY => "infinite".into(),
        f64::NEG_INFINITY => "-infinite".into(),
        _ => "not a number".into(),
    }
}

fn rows<const C: usize>(vectors: &[SVector<f64, C>]) -> Value {
    vectors.iter().map(|v| v.iter().copied().map(number).collect::<Value>()).collect()
}

fn moved(motion: &impl serde::Serialize) -> Value {
    serde_json::to_value(motion).unwrap_or_default()
}

fn pulled<const C: usize>(load: &Wrench<C>) -> Value {
    serde_json::to_value(load).unwrap_or_default()
}
