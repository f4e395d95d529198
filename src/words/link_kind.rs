//! Kinds of links between bodies, and their verbs in sentences: hinges carry, cables pull and go slack.

use super::Words;
use crate::prelude::*;

/// The kind of a link between two bodies, or between a body and the ground; see [`Link`](crate::grasp::Link).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum LinkKind {
    /// A hinge: bodies turn about a point, in space about an axis.
    Hinge,
    /// A ball joint: bodies turn about a point in any direction; in space only.
    Ball,
    /// A slide: a body moves along a line and does not turn.
    Slide,
    /// A rigid joint: bodies move as one.
    Rigid,
    /// A spring between two points, which pulls and pushes.
    Spring,
    /// A cable between two points, which pulls and goes slack.
    Cable,
}

impl LinkKind {
    /// The name in sentences: "hinge".
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

    /// The load of a link in a sentence: "carries 12 N", "pulls with 3 N", "is slack". `along` is the force with which a spring or cable pulls along
    /// its line, N; negative if a spring pushes. `force` and `moment` are the force (N) and moment (N m) of any other link; `moment` is `None` if the
    /// link carries no moment.
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

/// The verb for a contact that opens, or a link that goes slack.
pub(crate) fn opens(link: Option<LinkKind>) -> &'static str {
    if link.is_some() { "goes slack" } else { "opens" }
}

/// The verb for several contacts that open, or links that go slack.
pub(crate) fn open(link: Option<LinkKind>) -> &'static str {
    if link.is_some() { "go slack" } else { "open" }
}
