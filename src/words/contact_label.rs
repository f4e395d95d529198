//! The name of a contact in messages and answers.

use alloc::sync::Arc;
use core::fmt;

use super::link_kind::LinkKind;
use super::names::printable;
use crate::prelude::*;

/// Label of a contact in messages and answers: its number and, if the user gave one, its name.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ContactLabel {
    /// Index in the list of contacts, from 0. In the answer to a scene it is the index in the list of the scene. In text form this field is named
    /// `contact`.
    #[cfg_attr(feature = "serde", serde(rename = "contact"))]
    pub index: usize,
    /// Number of the point in its soft fingertip, from 0. `None`, and omitted, for a contact that is a single point.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub point: Option<usize>,
    /// The name that the user gave; omitted without one.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub name: Option<Arc<str>>,
    /// Kind of the link between bodies to which this contact belongs; omitted for a contact that is no link.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub link: Option<LinkKind>,
}

impl ContactLabel {
    /// Name in tables and pictures: the name that the user gave, safe to print, or "contact" and its number; then the point of a soft fingertip.
    #[must_use]
    pub fn text(&self) -> String {
        let name = self.name.as_deref().map(|name| printable(name).into_owned());
        let name = name.unwrap_or_else(|| format!("contact {}", self.index));
        self.point.map_or(name.clone(), |point| format!("{name}, point {point}"))
    }

    /// Label of the soft fingertip to which a point belongs; of a single point, its own label.
    #[must_use]
    pub fn whole(&self) -> Self {
        Self { point: None, ..self.clone() }
    }
}

impl fmt::Display for ContactLabel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.name {
            Some(name) => write!(f, "{} ({})", self.index, printable(name)),
            None => write!(f, "{}", self.index),
        }
    }
}
