//! Stiffnesses that differ by many orders of magnitude: between contacts, between axes of a contact, between body and finger, next to a rigid body.

use grasp_lcp::ask::Grasp;
use nalgebra::SVector;

use crate::Failure;
use crate::measure::{Question, Table};
use crate::ring::{NORMAL, PULL, SQUEEZE, TANGENTIAL, TILTED, enough, held, power};
use support::scene::Scene;

pub(crate) const STICKING: &str = "stiffness ratio, sticking";
pub(crate) const SLIDING: &str = "stiffness ratio, sliding";
pub(crate) const FEW: &str = "one contact against three others";
/// Friction of the contact that is to slide.
const SLIPPERY: f64 = 0.02;
/// Coefficient of friction of contacts that should stick.
const ROUGH: f64 = 2.0;

/// The springs whose stiffnesses have the given ratio.
#[derive(Debug, Clone, Copy)]
enum Between {
    /// One finger is stiffer than the others; all have the same commands, so its trial force is larger by the ratio.
    Contacts,
    /// One of four fingers in space is stiffer than the others, and friction must help to hold the body.
    ContactsOfFew,
    NormalOverTangential,
    TangentialOverNormal,
    /// The body is stiffer than the finger at every second contact along the normal, and softer at the other contacts; along the tangents the
    /// reverse.
    BodyAndFinger,
    /// The body is rigid, and the stiffness grows from finger to finger.
    RigidBody,
}

const KINDS: [(Between, &str); 6] = [
    (Between::Contacts, "one contact against the others"),
    (Between::ContactsOfFew, FEW),
    (Between::NormalOverTangential, "normal over tangential"),
    (Between::TangentialOverNormal, "tangential over normal"),
    (Between::BodyAndFinger, "body against finger"),
    (Between::RigidBody, "rigid body, fingers graded"),
];

pub(crate) fn rows(table: &mut Table) -> Result<(), Failure> {
    for (family, slippery) in [(STICKING, false), (SLIDING, true)] {
        for (kind, case) in KINDS {
            if case != FEW {
                of::<3, 2>(table, family, (kind, case), slippery)?;
            }
            of::<6, 3>(table, family, (kind, case), slippery)?;
        }
    }
    Ok(())
}

fn of<const D: usize, const C: usize>(
    table: &mut Table,
    family: &'static str,
    (kind, case): (Between, &'static str),
    slippery: bool,
) -> Result<(), Failure> {
    for exponent in (0..=16).step_by(2) {
        let value = power(exponent);
        let (scene, grasp) = stiff::<D, C>(kind, value.1, slippery)?;
        table.ask_of(Question { family, case, value, expected: None }, &scene, &grasp)?;
    }
    Ok(())
}

/// Fingers with this ratio of stiffness. The scene has the series stiffnesses that the grasp has rounded.
fn stiff<const D: usize, const C: usize>(
    kind: Between,
    ratio: f64,
    slippery: bool,
) -> Result<(Scene<D, C>, Grasp<C>), Failure> {
    let mut scene =
        held::<D, C>(if matches!(kind, Between::ContactsOfFew) { 4 } else { enough::<C>() }, TILTED);
    let axes = |normal: f64, tangential: f64| {
        let mut k = SVector::<f64, C>::repeat(tangential);
        k[0] = normal;
        k
    };
    let last = scene.contacts.len() - 1;
    let mut contacts = Vec::new();
    for (i, datum) in scene.contacts.iter_mut().enumerate() {
        match (slippery, i) {
            (false, _) => datum.friction = ROUGH,
            (true, 1) => datum.friction = SLIPPERY,
            _ => {}
        }
        let rigid = axes(f64::INFINITY, f64::INFINITY);
        let soft = axes(NORMAL, TANGENTIAL);
        let (body, finger) = match kind {
            Between::Contacts | Between::ContactsOfFew => (rigid, if i == 0 { soft * ratio } else { soft }),
            Between::NormalOverTangential => (rigid, axes(NORMAL * ratio, TANGENTIAL)),
            Between::TangentialOverNormal => (rigid, axes(NORMAL, TANGENTIAL * ratio)),
            Between::BodyAndFinger => {
                let stiff_normal = axes(NORMAL * ratio, TANGENTIAL);
                let stiff_tangential = axes(NORMAL, TANGENTIAL * ratio);
                if i % 2 == 0 { (stiff_normal, stiff_tangential) } else { (stiff_tangential, stiff_normal) }
            }
            Between::RigidBody => (rigid, soft * ratio.powf(i as f64 / last as f64)),
        };
        let contact = datum.contact().body_stiffness_axes(body).finger_stiffness_axes(finger);
        datum.stiffness = contact.series_stiffness_of_axes();
        if !matches!(kind, Between::Contacts | Between::ContactsOfFew) {
            datum.command[0] = SQUEEZE / datum.stiffness[0];
        }
        if slippery && i == 1 {
            datum.command[1] = PULL / datum.stiffness[1];
        }
        contacts.push(contact.command(datum.command));
    }
    Ok((scene, Grasp::new(contacts)?))
}
