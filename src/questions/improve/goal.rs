//! The goal: the value that is maximised over the positions and the commanded normal forces of contacts. The load factor is the multiple of the load.
//!
//! The contact force is F⁰ under the base load, which acts before the loads of the question grow, and a load changes it by F¹. With the coefficients
//! a of a facet of the friction cone, the sticking condition of this facet is `a·F >= 0` for the contact force F; its margin is `a·F`. The margin
//! under the base load is `r = a·F⁰`, and the load adds `s = a·F¹`, usually negative. If the goal is a late first slip, the value is the load factor
//! τ at which the margin vanishes, `r + τ s = 0`. If the goal is a reserve of friction, the value is the margin under the load, `r + s`.

/// The value that the search for better finger placement maximises. Each load has such a value, and the least of them is maximised.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum ImproveGoal {
    /// The load factor at which the first contact slides or opens. This goal suits loads that may become larger than expected.
    #[default]
    FirstSlip,
    /// Friction in reserve while each load acts in full, N: the least [margin](crate::equilibrium::ContactAnswer::margin) of all contacts. For a
    /// contact with zero or infinite friction it is the normal force. This goal suits known loads with unknown disturbances.
    Reserve,
}

impl ImproveGoal {
    /// The value of the goal for one sticking condition, i.e. one facet of a friction cone. `rest` is the margin r, N, of this condition under the
    /// base load, and `added` the change s of the margin due to the load, N. `None` if the goal is first slip and the load never breaks the
    /// condition.
    pub(super) fn counts(self, rest: f64, added: f64) -> Option<f64> {
        let counted = match self {
            Self::FirstSlip => (added < 0.0).then(|| -rest / added),
            Self::Reserve => Some(rest + added),
        };
        counted.filter(|value| value.is_finite())
    }

    /// The derivative of [`Self::counts`] with respect to one variable. `value` is what `counts` returned, and `added` the change of the margin due
    /// to the load, as given to `counts`. The pair holds two derivatives with respect to the variable: of the margin under the base load, and of
    /// `added`.
    pub(super) fn change(self, value: f64, added: f64, [rest_changes, added_changes]: [f64; 2]) -> f64 {
        match self {
            Self::FirstSlip => -(rest_changes + value * added_changes) / added,
            Self::Reserve => rest_changes + added_changes,
        }
    }
}
