//! Which contact of the scene an answer speaks of, and what it says of it.

use nalgebra::SVector;
use serde::{Deserialize, Serialize};

use crate::equilibrium::{ContactAnswer, ContactState};
use crate::serial::AsComputed;

/// A contact of the grasp, as the scene knows it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Place {
    /// Its place in the list of contacts, from 0.
    pub contact: usize,
    /// Which point of a soft fingertip, from 0; left out for a contact that is a point itself.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point: Option<usize>,
    /// The name of the contact; left out if it has none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
}

impl Place {
    /// Its name, or what it is and its number.
    #[must_use]
    pub fn label(&self) -> String {
        let name = self.name.clone().unwrap_or_else(|| format!("contact {}", self.contact));
        self.point.map_or(name.clone(), |point| format!("{name}, point {point}"))
    }
}

/// What a grasp consists of, in its order, as the scene knows it.
pub(super) struct Places {
    pub(super) contacts: Vec<Place>,
    /// Names of joints, those that have one.
    pub(super) joints: Vec<Option<String>>,
    pub(super) tendons: Vec<Option<String>>,
}

/// What a contact does.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "state", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Doing<const C: usize> {
    /// Open, or touching without force.
    Separated,
    /// Closed and stuck.
    Sticking,
    /// Closed and on the edge of its cone.
    Sliding {
        /// Unit direction in which the finger slips over the body, coordinate axes.
        #[serde(with = "AsComputed::<SVector<f64, C>>")]
        direction: SVector<f64, C>,
    },
    /// Closed without friction.
    Frictionless,
}

impl<const C: usize> From<ContactState<C>> for Doing<C> {
    fn from(state: ContactState<C>) -> Self {
        match state {
            ContactState::Separated => Self::Separated,
            ContactState::Sticking => Self::Sticking,
            ContactState::Sliding { direction } => Self::Sliding { direction },
            ContactState::Frictionless => Self::Frictionless,
        }
    }
}

/// One contact of an equilibrium; see [`ContactAnswer`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Touch<const C: usize> {
    /// Which contact.
    #[serde(flatten)]
    pub place: Place,
    /// What it does.
    #[serde(flatten)]
    pub doing: Doing<C>,
    /// Force on the object in the contact frame, N: normal (positive pushes), tangential.
    #[serde(with = "AsComputed::<SVector<f64, C>>")]
    pub force: SVector<f64, C>,
    /// The same force along the coordinate axes, N.
    #[serde(with = "AsComputed::<SVector<f64, C>>")]
    pub force_world: SVector<f64, C>,
    /// Gap between the surfaces, m, never negative.
    #[serde(with = "AsComputed::<f64>")]
    pub gap: f64,
    /// Slip of the finger over the body in the contact frame, m; its normal component is zero.
    #[serde(with = "AsComputed::<SVector<f64, C>>")]
    pub slip: SVector<f64, C>,
    /// Friction in reserve, N; "infinite" with infinite friction.
    #[serde(with = "AsComputed::<f64>")]
    pub margin: f64,
    /// Whether working precision tells the state from its neighbours: of the answer to `solve`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub distinct: Option<bool>,
    /// Displacement of the body's core, coordinate axes, m.
    #[serde(with = "AsComputed::<SVector<f64, C>>")]
    pub body_core: SVector<f64, C>,
    /// Displacement of the body's surface, coordinate axes, m; left out if only the series
    /// stiffness is known.
    #[serde(
        default,
        with = "AsComputed::<Option<SVector<f64, C>>>",
        skip_serializing_if = "Option::is_none"
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub body_surface: Option<SVector<f64, C>>,
    /// Displacement of the finger's surface, coordinate axes, m; left out if only the series
    /// stiffness is known.
    #[serde(
        default,
        with = "AsComputed::<Option<SVector<f64, C>>>",
        skip_serializing_if = "Option::is_none"
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub finger_surface: Option<SVector<f64, C>>,
}

impl Places {
    pub(super) fn touch<const C: usize>(&self, index: usize, answer: &ContactAnswer<C>) -> Touch<C> {
        Touch {
            place: self.contacts[index].clone(),
            doing: answer.state.into(),
            force: answer.force,
            force_world: answer.force_world,
            gap: answer.gap,
            slip: answer.slip,
            margin: answer.margin,
            distinct: None,
            body_core: answer.body_core,
            body_surface: answer.body_surface,
            finger_surface: answer.finger_surface,
        }
    }

    pub(super) fn many(&self, indices: &[usize]) -> Vec<Place> {
        indices.iter().map(|&index| self.contacts[index].clone()).collect()
    }
}
