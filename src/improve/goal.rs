//! What is to be as large as possible.
//!
//! A condition `a·F >= 0` has so much left at rest, `r = a·F⁰`, and a load adds `s = a·F¹`, as a rule less than nothing. Either it is asked how many
//! times the load takes all of it, `r + τ s = 0`, or what the load leaves of it, `r + s`.

/// What is to be as large as possible where fingers are improved: the least of all loads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum ImproveGoal {
    /// The first slip: how many times the loads it takes until something slides or opens. For loads that may become larger than they are known to be.
    #[default]
    FirstSlip,
    /// Friction in reserve while each load acts in full, N: the [margin](crate::equilibrium::ContactAnswer::margin) of the contact that has
    /// least, of one without friction or with friction without limit its normal force. For loads that are known, and disturbances that are not.
    Reserve,
}

impl ImproveGoal {
    /// What it counts of a condition that has so much left at rest, to which a load adds so much; `None` where the load never breaks it.
    pub(super) fn counts(self, rest: f64, added: f64) -> Option<f64> {
        let counted = match self {
            Self::FirstSlip => (added < 0.0).then(|| -rest / added),
            Self::Reserve => Some(rest + added),
        };
        counted.filter(|value| value.is_finite())
    }

    /// How that changes with what is left, and what is added.
    pub(super) fn change(self, value: f64, added: f64, [rest_changes, added_changes]: [f64; 2]) -> f64 {
        match self {
            Self::FirstSlip => -(rest_changes + value * added_changes) / added,
            Self::Reserve => rest_changes + added_changes,
        }
    }
}
