//! A map as JSON: for forces of every direction at one point, the force at first slip and the force at which the load path ends.

use serde_json::{Value, json};

use super::ask::FirstSlipForce;
use super::data_deviations::DataDeviations;
use super::limit::{LimitEnd, LimitForce};
use grasp_lcp::grasp::Wrench;

/// All numbers of a map, to be written as JSON.
pub(super) struct WrittenMap<'a, const C: usize> {
    pub(super) at: [f64; C],
    pub(super) base: Wrench<C>,
    pub(super) data_deviations: &'a DataDeviations,
    pub(super) onsets: Vec<([f64; C], &'a FirstSlipForce)>,
    /// For each direction, the force, N, under which uncertain data may deviate by the given number of standard deviations before a contact slides.
    pub(super) reserves: Vec<([f64; C], f64)>,
    /// For each direction, the force at the end of the load path, and how the path ends.
    pub(super) paths: Vec<([f64; C], &'a LimitForce)>,
    pub(super) most: f64,
    pub(super) weakest: Option<([f64; C], f64)>,
    pub(super) caution: Option<String>,
}

impl<const C: usize> WrittenMap<'_, C> {
    /// Prints the map as one JSON object. If no contact slips under any force of a direction, its force is written as "never". If the load path holds
    /// up to the largest force that is followed, its force is "further". An unknown force is null.
    pub(super) fn print(&self) {
        let onset = |(direction, first): &([f64; C], &FirstSlipForce)| {
            json!({
                "direction": direction.to_vec(),
                "onset": force(first.force, "never"),
                "leaves_first": first.contacts,
            })
        };
        let reserve = |(direction, held): &([f64; C], f64)| json!({ "direction": direction.to_vec(), "held": force(*held, "never") });
        let path = |(direction, last): &([f64; C], &LimitForce)| {
            let held =
                if last.end == LimitEnd::Held { json!("further") } else { force(last.force, "further") };
            json!({ "direction": direction.to_vec(), "held_to": held, "end": last.end.word() })
        };
        let weakest =
            self.weakest.map(|(direction, size)| json!({ "direction": direction.to_vec(), "onset": size }));
        let map = json!({
            "at": self.at.to_vec(),
            "base": self.base.components(),
            "standard_deviations": self.data_deviations.written(),
            "weakest": weakest,
            "onsets": self.onsets.iter().map(onset).collect::<Vec<_>>(),
            "reserves": self.reserves.iter().map(reserve).collect::<Vec<_>>(),
            "followed_to": self.most,
            "caution": self.caution,
            "paths": self.paths.iter().map(path).collect::<Vec<_>>(),
        });
        println!("{map}");
    }
}

fn force(newtons: f64, never: &str) -> Value {
    if newtons.is_finite() {
        json!(newtons)
    } else if newtons.is_nan() {
        Value::Null
    } else {
        json!(never)
    }
}
