//! Words for what a scene's answers say.

use grasp_lcp::equilibrium::{ContactAnswer, ContactState, DriveState, Proof, row};
use grasp_lcp::grasp::Motion;
use grasp_lcp::grasp::Wrench;

/// Of what the library may come to say some day.
pub(crate) const NO_WORDS: &str = "an answer for which this program has no words yet; --json prints it";

/// What is left of a limit, if there is one.
pub(crate) fn left(margin: f64) -> String {
    if margin.is_finite() { format!(", {margin:.6} left of its limit") } else { String::new() }
}

pub(crate) fn gives_way(state: DriveState) -> &'static str {
    match state {
        DriveState::Yields => "  yields at its limit",
        DriveState::Slack => "  slack",
        _ => "",
    }
}

/// A motion of the object, and of the joints if there are any.
fn motion<const C: usize>(motion: &Motion<C>) -> String {
    let object = row(motion.object.components());
    if motion.joints.is_empty() { object } else { format!("{object}, joints {}", row(&motion.joints)) }
}

pub(crate) fn doing<const C: usize>(points: &[&ContactAnswer<C>]) -> String {
    let words = ["sticking", "sliding", "open", "smooth"];
    let which = |c: &&&ContactAnswer<C>| match c.state {
        ContactState::Sticking => 0,
        ContactState::Sliding { .. } => 1,
        ContactState::Separated => 2,
        ContactState::Frictionless => 3,
    };
    let parts = words.iter().enumerate().filter_map(|(k, word)| {
        let count = points.iter().filter(|c| which(c) == k).count();
        match count {
            0 => None,
            _ if points.len() == 1 => Some((*word).to_owned()),
            _ => Some(format!("{count} {word}")),
        }
    });
    parts.collect::<Vec<_>>().join(", ")
}

pub(crate) fn proof<const C: usize>(proof: &Proof<C>) -> String {
    match proof {
        Proof::FreeMotion { motion: free, .. } => {
            format!("nothing resists the motion {}", motion(free))
        }
        Proof::SeparatingMotion { motion: free, .. } => {
            format!("no friction works against the motion {}", motion(free))
        }
        Proof::EveryStateTried { combinations } => {
            format!("all {combinations} combinations of contact states fail")
        }
        Proof::EveryCaseContradicted { cases, .. } => {
            format!("all {cases} cases of contact states and directions of friction contradict themselves")
        }
        _ => NO_WORDS.to_owned(),
    }
}

pub(crate) fn wrench<const C: usize>(wrench: &Wrench<C>) -> String {
    row(wrench.components())
}
