//! Links as people speak of them: hinges carry, cables pull and go slack.

use super::Words;
use crate::prelude::*;

/// What kind of link two bodies, or a body and the ground, are joined by; see [`Link`](crate::grasp::Link).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum LinkKind {
    /// Bodies turn about a point, in space about an axis.
    Hinge,
    /// In space bodies turn about a point any way.
    Ball,
    /// A body moves along a line and does not turn.
    Slide,
    /// Bodies move as one.
    Rigid,
    /// A spring between two points pulls and pushes.
    Spring,
    /// A cable between two points pulls, and goes slack.
    Cable,
}

impl LinkKind {
    /// What people call it: "hinge".
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Hinge => "hinge",
            Self::Ball => "ball joint",
            Self::Slide => "slide",
            Self::Rigid => "rigid joint",
            Self::Spring => "spring",
            Self::Cable => "cable",
        }
    }

    /// What a link does that has this force, N, along its line where it has one, and where it can carry it this moment, N m: "carries 12 N",
    /// "pulls with 3 N", "is slack".
    pub(crate) fn carries(self, words: Words, along: f64, force: f64, moment: Option<f64>) -> String {
        let newtons = |x: f64| format!("{} N", words.number(x));
        match self {
            Self::Cable if along == 0.0 => "is slack".to_owned(),
            Self::Spring if along < 0.0 => format!("pushes with {}", newtons(-along)),
            Self::Cable | Self::Spring => format!("pulls with {}", newtons(along)),
            _ => {
                let moment = moment.map(|moment| format!(" and {} N m", words.number(moment)));
                format!("carries {}{}", newtons(force), moment.unwrap_or_default())
            }
        }
    }
}

/// What somebody does who opens: a contact, or a cable that goes slack.
pub(crate) fn opens(link: Option<LinkKind>) -> &'static str {
    if link.is_some() { "goes slack" } else { "opens" }
}

/// The same of several.
pub(crate) fn open(link: Option<LinkKind>) -> &'static str {
    if link.is_some() { "go slack" } else { "open" }
}
