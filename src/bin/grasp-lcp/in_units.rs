//! Converts lengths of the command line to m, from the unit of the scene or of `--unit`.

use grasp_lcp::words::Unit;

use crate::arguments::{Command, LoadArguments, NeedArguments, Numbers, SceneArguments};

impl Command {
    /// The scene and the form of the answer, if the command asks about a scene.
    pub(crate) fn asks(&mut self) -> Option<&mut SceneArguments> {
        match self {
            Self::Ask(ask)
            | Self::Hold { ask, .. }
            | Self::Need { ask, .. }
            | Self::Improve { ask, .. }
            | Self::Solve { ask, .. }
            | Self::Compare { ask, .. }
            | Self::Onset { ask, .. }
            | Self::Turn { ask, .. }
            | Self::Follow { ask, .. }
            | Self::Shake { ask, .. }
            | Self::Identify { ask, .. } => Some(ask),
            _ => None,
        }
    }

    /// Converts the lengths among the options from `unit` to m: points of loads, and a point on the axis of a turning arm. For `identify` it stores
    /// the unit of the table of observations, which is read later.
    pub(crate) fn lengths_to_metres(&mut self, unit: Unit) {
        match self {
            Self::Hold { load, .. }
            | Self::Need { need_arguments: NeedArguments { load, .. }, .. }
            | Self::Improve { load, .. }
            | Self::Solve { load, .. }
            | Self::Compare { load, .. }
            | Self::Onset { load, .. } => load.lengths_to_metres(unit),
            Self::Turn { at, .. } | Self::Follow { at, .. } => to_metres(at, unit),
            Self::Shake { shakes, .. } => to_metres(&mut shakes.at, unit),
            Self::Identify { slips, .. } => slips.unit = unit,
            _ => {}
        }
    }
}

impl Command {
    /// If the command line has a force or mass but no point at which it acts, takes `centre` as this point.
    pub(crate) fn act_at(&mut self, centre: &[f64]) {
        let is_pulled = |load: &LoadArguments| load.force.is_some() || load.mass.is_some();
        let (at, acts) = match self {
            Self::Hold { load, base, .. } | Self::Compare { load, base, .. } => {
                let acts = is_pulled(load) || base.is_some();
                (&mut load.at, acts)
            }
            Self::Need { need_arguments: NeedArguments { load, base, any_force, .. }, .. }
            | Self::Improve { load, base, any_force, .. } => {
                let acts = is_pulled(load) || base.is_some() || any_force.is_some();
                (&mut load.at, acts)
            }
            Self::Solve { load, .. } | Self::Onset { load, .. } => {
                let acts = is_pulled(load);
                (&mut load.at, acts)
            }
            Self::Turn { at, mass, weight, .. } => (at, mass.is_some() || weight.is_some()),
            Self::Follow { at, to, .. } => (at, !to.is_empty()),
            Self::Shake { shakes, .. } => (&mut shakes.at, !shakes.force.is_empty() || shakes.mass.is_some()),
            _ => return,
        };
        if acts && at.is_none() {
            *at = Some(Numbers(centre.to_vec()));
        }
    }
}

impl LoadArguments {
    fn lengths_to_metres(&mut self, unit: Unit) {
        to_metres(&mut self.at, unit);
        to_metres(&mut self.about, unit);
        for push in &mut self.together_with {
            to_metres(&mut push.at, unit);
        }
    }
}

fn to_metres(point: &mut Option<Numbers>, unit: Unit) {
    if let Some(point) = point {
        point.bring_to_metres(unit);
    }
}
