//! The motion with which the object leaves at a loss (the end of equilibrium under a growing load), as a clause of the verdict's sentence.

use alloc::borrow::Cow;
use core::fmt;

use super::way_out::{BodyWay, WayOut};
use super::words::they_open;
use crate::grasp::{WholeContact, vacuum_is_gone};
use crate::numerics::{IntoList, Space, mapped};
use crate::prelude::*;
use crate::words::{Words, listed, printable};

impl<const C: usize> fmt::Display for WayOut<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        match self {
            Self::LiftsOff { direction } => {
                let goes = if self.falls(&[], words) { "falls" } else { "lifts" };
                write!(f, "the object {goes} off along {}", words.along(direction))
            }
            Self::SlidesOut { .. } | Self::Turns { .. } | Self::TipsOver { .. } => {
                write!(f, "the object {}", self.motion_text(words, false))
            }
            Self::TurnsAbout { about } if words.space::<C>() == Space::Spatial && about.len() == 2 => {
                write!(f, "the object spins about the line {}–{}", about[0].text(), about[1].text())
            }
            Self::TurnsAbout { about } => write!(f, "the object turns about {}", listed(about)),
            Self::LetsGo { cups } => f.write_str(&vacuum_is_gone(cups)),
            Self::Apart { bodies } => f.write_str(&body_motions_text(bodies, words)),
            Self::NotKnown => f.write_str("nothing holds on"),
        }
    }
}

/// The clause about the motions of several bodies, grouped by motion: "wedge moves along −x, block and lid turn about (0.1, 0) m".
fn body_motions_text<const C: usize>(bodies: &[BodyWay<C>], words: Words) -> String {
    let mut ways: Vec<(String, &WayOut<C>, Vec<Cow<'_, str>>)> = Vec::new();
    for BodyWay { body, way } in bodies {
        let (text, name) = (way.motion_text(words, false), printable(body));
        match ways.iter_mut().find(|(other, ..)| *other == text) {
            Some((.., names)) => names.push(name),
            None => ways.push((text, way, vec![name])),
        }
    }
    let text = |(one, way, names): &(String, &WayOut<C>, Vec<_>)| {
        if names.len() == 1 {
            format!("{} {one}", names[0])
        } else {
            format!("{} {}", listed(names), way.motion_text(words, true))
        }
    };
    listed(&mapped(&ways, &text))
}

impl<const C: usize> WayOut<C> {
    /// The verb clause for the motion of one body or of several bodies: "moves along −x", "turn about (0.1, 0) m".
    fn motion_text(&self, words: Words, are_several: bool) -> String {
        let ending = if are_several { "" } else { "s" };
        match self {
            Self::SlidesOut { direction } => format!("move{ending} along {}", words.along(direction)),
            Self::Turns { centre, axis, advance } => {
                let axis = match words.space::<C>() {
                    Space::Planar => String::new(),
                    Space::Spatial => format!("{} through ", words.along(axis)),
                };
                let turns = format!("turn{ending} about {axis}{}", words.place(centre));
                if *advance == 0.0 {
                    return turns;
                }
                format!("{turns}, moving {} along it for each radian", words.length(advance.abs()))
            }
            Self::TipsOver { about, opens } => {
                let edge = |part: &WholeContact| {
                    if part.is_whole() {
                        part.text().into_owned()
                    } else {
                        format!("an edge of {}", part.text())
                    }
                };
                let about_whole =
                    |part: &WholeContact| about.iter().all(|other| other.contact != part.contact);
                let edges: Vec<_> = mapped(about, &edge);
                let opens: Vec<_> = opens.iter().filter(|part| about_whole(part)).cloned().list();
                let they_open =
                    if opens.is_empty() { String::new() } else { format!(", {}", they_open(&opens)) };
                format!("tip{ending} over about {}{they_open}", listed(&edges))
            }
            Self::TurnsAbout { about } => format!("turn{ending} about {}", listed(about)),
            _ => format!("move{ending}"),
        }
    }
}
