//! The name of a contact in messages and answers.

use alloc::sync::Arc;
use core::fmt;

use super::link_kind::LinkKind;
use super::names::printable;
use crate::prelude::*;

/// A contact as messages and answers name it: by its number and, where the user gave one, by its name.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ContactLabel {
    /// Position in the list of contacts, from 0: of the grasp, or of the scene in the answer to a scene. Written as `contact`.
    #[cfg_attr(feature = "serde", serde(rename = "contact"))]
    pub index: usize,
    /// Number of the point in its soft fingertip, from 0, in the answer to a scene; `None`, and omitted, for a contact that is a point itself.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub point: Option<usize>,
    /// The user's name for it; omitted if it has none.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub name: Option<Arc<str>>,
    /// Kind of the link between bodies that it belongs to; omitted for a contact.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub link: Option<LinkKind>,
}

impl ContactLabel {
    /// Name of the contact in tables and pictures: its own, safe to print, or "contact" and its number, and the point of a soft fingertip.
    #[must_use]
    pub fn text(&self) -> String {
        let name = self.name.as_deref().map(|name| printable(name).into_owned());
        let name = name.unwrap_or_else(|| format!("contact {}", self.index));
        self.point.map_or(name.clone(), |point| format!("{name}, point {point}"))
    }

    /// The soft fingertip that a point belongs to; a contact that is a point itself stays.
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
