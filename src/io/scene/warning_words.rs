//! The sentences of [`Warning`]s about probable mistakes in a scene. At rest means without load, or under the constant base load of a question.

use std::fmt;

use super::warning::Warning;
use crate::numerics::{Each, mapped};
use crate::words::{Words, listed, printable};

const OPPOSITE_IN_ONE_PLACE: &str =
    "press against each other in one place: the object has no thickness there; are their points right?";
const ALIKE_IN_ONE_PLACE: &str =
    "are in one place, with parallel normals: a finger that is there twice is twice as stiff";
const BUCKLES_AT_REST: &str = "BUCKLES at rest already: as the forces turn with the parts they act on, they take all that resists; answers for small motions do not apply";

const BUCKLING_NOT_ASKED: &str = "with so many bodies it is not asked whether they buckle, which a slender or soft stack may do at a smaller load";

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        match self {
            Self::NothingPresses => f.write_str(
                "no finger presses: every command is zero or missing, so that friction has nothing to act on; say `command` or `pressed_with`",
            ),
            Self::BucklesAtRest => f.write_str(BUCKLES_AT_REST),
            Self::BucklingNotAsked => f.write_str(BUCKLING_NOT_ASKED),
            Self::NoGravity => f.write_str(
                "bodies have a `mass`, but the scene has no `gravity`: nothing weighs, and nothing else presses",
            ),
            Self::PressesOtherwise { name, stated, force, .. } => write!(
                f,
                "{} presses with {} N at rest, not with {} N: `pressed_with` moves a spring, and the object gives way until forces agree",
                printable(name),
                words.number(*force),
                words.number(*stated)
            ),
            Self::PullsOtherwise { name, stated, force, .. } => write_pull(f, words, name, [*force, *stated]),
            Self::MuchFriction { names, friction, .. } => write!(
                f,
                "friction {} at {}: coefficients are rarely above 1; in percent? Then it is {}",
                words.number(*friction),
                all(names),
                words.number(0.01 * friction)
            ),
            Self::NoFriction => f.write_str(
                "no contact has friction: nothing is held but what normals push against; say `friction`",
            ),
            Self::ManyMetres { what, length, beside } => {
                write!(f, "{} {} m", printable(what), words.number(*length))?;
                if let Some(size) = beside {
                    write!(f, ", and contacts are {} m apart", words.number(*size))?;
                }
                f.write_str(": lengths are in m; is this in mm? A scene then says \"unit\": \"mm\"")
            }
            Self::OutOfProportion { names, is_stiffness: true, value, .. } => write!(
                f,
                "stiffness {} N/m at {}, out of proportion to the rest: contacts of steel have some 1e8 N/m; is this a modulus, in Pa?",
                words.number(*value),
                all(names)
            ),
            Self::OutOfProportion { names, value, .. } => write!(
                f,
                "{} N at {}, out of proportion to the rest: forces are in N",
                words.number(*value),
                all(names)
            ),
            Self::SameSide { names, .. } => write!(
                f,
                "the normals of {} point the same way: contacts cannot press against each other; normals point into the object, the way the finger pushes",
                all(names)
            ),
            Self::Outwards { names, .. } => write!(
                f,
                "the normals of {} point away from the middle: so they do for fingers in a hole; else normals point into the object, the way the finger pushes",
                all(names)
            ),
            Self::BeyondVacuum { names, pressure, .. } => write!(
                f,
                "a vacuum of {} kPa at {}: none exceeds an atmosphere, 101.3 kPa, `pressure` is in Pa",
                words.number(1e-3 * pressure),
                all(names)
            ),
            Self::HeavyLoad { force, pressed } => write!(
                f,
                "a load has {} N, and contacts press with {} N together: masses are in kg; is this in g?",
                words.number(*force),
                words.number(*pressed)
            ),
            Self::ManyTurns { angle } => turns_often(f, words, *angle),
            #[cfg(feature = "mesh")]
            Self::MissesInPart { name, missing, .. } => write_missing(f, words, name, *missing),
            #[cfg(feature = "mesh")]
            Self::OverAnEdge { name, angle, .. } => lies_over_an_edge(f, words, name, *angle),
            Self::OnePlace { names, opposite, .. } => {
                let what = if *opposite { OPPOSITE_IN_ONE_PLACE } else { ALIKE_IN_ONE_PLACE };
                write!(f, "{} {what}", all(names))
            }
            Self::SameName { contacts, name } => {
                let numbers: Vec<_> = mapped(contacts, &|contact| format!("contact {contact}"));
                write!(f, "{} are called {}: answers do not tell which is meant", listed(&numbers), printable(name))
            }
            Self::StiffnessLeftOut { names, stiffness, questions, .. } => {
                let (have, taken) =
                    if names.len() == 1 { ("has", "taken") } else { ("have", "taken for each") };
                let numbers: Vec<_> = mapped(questions, &|question| format!("question {}", question + 1));
                write!(
                    f,
                    "{} {have} no `stiffness`: {} N/m is {taken}, and the answer to {} depends on it",
                    all(names),
                    words.number(*stiffness),
                    listed(&numbers)
                )
            }
            Self::PointsOut { name, .. } => write!(
                f,
                "{}: its normal points out of the outline; normals point into the object, the way the finger pushes",
                printable(name)
            ),
        }
    }
}

fn turns_often(f: &mut fmt::Formatter<'_>, words: Words, angle: f64) -> fmt::Result {
    let (angle, turns) = (words.number(angle), angle / core::f64::consts::TAU);
    write!(f, "a turn of {angle} rad is {turns:.1} full turns: degrees? Those are `angle_deg`")
}

#[cfg(feature = "mesh")]
fn write_missing(f: &mut fmt::Formatter<'_>, words: Words, name: &str, missing: f64) -> fmt::Result {
    let percent = words.number(100.0 * missing);
    write!(
        f,
        "{} misses the part with {percent} % of its pad: the rest carries all of its force",
        printable(name)
    )
}

#[cfg(feature = "mesh")]
fn lies_over_an_edge(f: &mut fmt::Formatter<'_>, words: Words, name: &str, angle: f64) -> fmt::Result {
    let (name, angle) = (printable(name), words.number(angle));
    write!(f, "{name} lies over an edge: pad and part meet at up to {angle}°, more than friction bridges")
}

/// Writes that a spring or cable pulls with another force at rest than its pretension. `force` is the pull at rest, `stated` the pretension, N; each
/// is negative for a spring that pushes.
fn write_pull(
    f: &mut fmt::Formatter<'_>,
    words: Words,
    name: &str,
    [force, stated]: [f64; 2],
) -> fmt::Result {
    let [now, nominal] = [force, stated].each(|x| words.number(x * stated.signum()));
    let (verb, why) = if stated < 0.0 {
        ("pushes", "`pretension` acts before anything gives way; a larger one pushes with more")
    } else {
        (
            "pulls",
            "`pretension` is its pull before anything gives way; say `tension` for the pull once it is installed",
        )
    };
    write!(f, "{} {verb} with {now} N at rest, not with {nominal} N: {why}", printable(name))
}

/// The names of contacts as one text, for messages.
fn all(names: &[String]) -> String {
    listed(&mapped(names, &|name| printable(name)))
}
