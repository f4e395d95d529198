//! The numbers beside the picture: one section for each answer, of which the page shows one.

use std::fmt::Write;

use super::frame::Frame;
use super::text::vector;
use crate::grasp::Hold;
use crate::picture::actuators::Actuators;
use crate::picture::contact_look::{no_friction_left, word};
use crate::picture::error::PictureError;
use crate::picture::fingertip::ContactGroup;
use crate::picture::words::{escaped, short};
use crate::spatial::{Contact, ContactAnswer, Equilibrium, Grasp};

/// Headings, and what they mean.
const COLUMNS: [(&str, &str); 9] = [
    ("contact", "name"),
    ("state", "what the contact does"),
    ("F_n (N)", "normal force; positive pushes"),
    ("|F_t| (N)", "friction force"),
    ("|F_t|/F_n", "friction used"),
    ("μ", "coefficient of friction"),
    ("μF_n − |F_t| (N)", "friction in reserve"),
    ("gap, slip (m)", "gap of an open contact; slip of the finger over the object"),
    ("|u_c| (m)", "displacement of the object at the contact"),
];

pub(super) fn write(
    page: &mut String,
    grasp: &Grasp,
    tips: &[ContactGroup],
    actuators: &Actuators<3>,
    frames: &[Frame],
) -> Result<(), PictureError> {
    for (k, Frame { label, shown }) in frames.iter().enumerate() {
        let hidden = if k == 0 { "" } else { " hidden" };
        let _ = writeln!(page, "<section data-frame=\"{k}\"{hidden}>\n<h2>{}</h2>", escaped(label));
        match shown {
            Err(why) => {
                let _ = writeln!(page, "<p class=\"none\">{}</p>", escaped(why));
            }
            Ok(state) => write_state(page, grasp, tips, actuators, state)?,
        }
        page.push_str("</section>\n");
    }
    Ok(())
}

fn write_state(
    page: &mut String,
    grasp: &Grasp,
    tips: &[ContactGroup],
    actuators: &Actuators<3>,
    state: &Equilibrium,
) -> Result<(), PictureError> {
    let (load, twist) = (state.load.components(), state.twist.components());
    let _ = writeln!(
        page,
        "<p>LoadArrow: force {} N, moment about the origin {} N m. The object moves by {} m and turns by {} rad. \
         Residual {:.0e}.</p>",
        vector(&load[..3]),
        vector(&load[3..]),
        vector(&twist[..3]),
        vector(&twist[3..]),
        state.residuals.worst()
    );
    for motion in &state.free_motions {
        let v = motion.object.components();
        let _ = writeln!(
            page,
            "<p>Nothing resists the motion {} (translation, rotation about the origin): where the object goes is known up to it.</p>",
            vector(v)
        );
    }
    let at_their_limit: Vec<_> = actuators.that_yield(state).map(|(name, _)| escaped(name)).collect();
    if !at_their_limit.is_empty() {
        let _ = writeln!(page, "<p>At their limit, and yielding: {}.</p>", at_their_limit.join(", "));
    }
    page.push_str("<table>\n<thead><tr>");
    for (heading, meaning) in COLUMNS {
        let _ = write!(page, "<th title=\"{}\">{}</th>", escaped(meaning), escaped(heading));
    }
    page.push_str("</tr></thead>\n<tbody>\n");
    for (i, (contact, answer)) in grasp.contacts().iter().zip(&state.contacts).enumerate() {
        // The place among what is drawn.
        let tip = tips.iter().position(|tip| tip.contacts.contains(&i)).unwrap_or(i);
        write_row(page, (i, tip), contact, answer)?;
    }
    page.push_str("</tbody>\n</table>\n");
    Ok(())
}

fn write_row(
    page: &mut String,
    (index, tip): (usize, usize),
    contact: &Contact,
    answer: &ContactAnswer,
) -> Result<(), PictureError> {
    // What is left of a contact on the edge of its cone is rounding.
    let reserve = if no_friction_left(answer) { 0.0 } else { answer.margin };
    let moved = if answer.gap > 0.0 { answer.gap } else { answer.slip.norm() };
    let numbers = [
        answer.normal_force(),
        answer.friction_force(),
        answer.friction_used(),
        contact.friction_coefficient(),
        reserve,
        moved,
        answer.body_core.norm(),
    ];
    let name = contact.label_text(index);
    if numbers.iter().any(|x| x.is_nan()) {
        return Err(PictureError(format!("a number of {name} is not a number")));
    }
    let mut words = numbers.map(short);
    if contact.hold == Hold::Bonded {
        // Glued, it has no friction to use.
        (words[2], words[3]) = ("–".into(), "bonded".into());
    }
    let state = word(answer);
    let _ = write!(
        page,
        "<tr data-contact=\"{tip}\"><th>{}</th><td class=\"{}\">{state}</td>",
        escaped(&name),
        state.replace(' ', "-")
    );
    for words in words {
        let _ = write!(page, "<td>{words}</td>");
    }
    page.push_str("</tr>\n");
    Ok(())
}
