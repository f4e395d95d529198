//! The tables of a page: one section for each answer, of which the page shows one.

use std::fmt::Write;

use super::frame::Frame;
use crate::ask::Grasp;
use crate::equilibrium::{ContactAnswer, Equilibrium};
use crate::grasp::{Contact, Hold};
use crate::picture::actuators::Actuators;
use crate::picture::contact_look::{no_friction_left, word};
use crate::picture::error::PictureError;
use crate::picture::fingertip::{ContactGroup, without_rounding};
use crate::picture::words::{escaped, short};
use crate::words::{LinkKind, Words};

/// Headings and their explanations.
const TABLE_COLUMNS: [(&str, &str); 9] = [
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

/// Writes the sentences of each answer, at the top of the page.
pub(super) fn write_says<const C: usize>(page: &mut String, frames: &[Frame<C>]) {
    for (k, frame) in frames.iter().enumerate() {
        open(page, k);
        for sentence in &frame.says {
            let _ = writeln!(page, "<p class=\"says\">{}</p>", escaped(sentence));
        }
        match &frame.shown {
            Err(why) => {
                let _ = writeln!(page, "<p class=\"none\">{}</p>", escaped(why));
            }
            // Without sentences the label of the answer is written.
            Ok(_) if frame.says.is_empty() => {
                let _ = writeln!(page, "<p class=\"says\">{}</p>", escaped(&frame.label));
            }
            Ok(_) => {}
        }
        page.push_str("</section>\n");
    }
}

/// Opens a section of one of the answers; only the first is visible initially.
fn open(page: &mut String, frame: usize) {
    let hidden = if frame == 0 { "" } else { " hidden" };
    let _ = writeln!(page, "<section data-frame=\"{frame}\"{hidden}>");
}

pub(super) fn write<const C: usize>(
    page: &mut String,
    grasp: &Grasp<C>,
    tips: &[ContactGroup],
    actuators: &Actuators<C>,
    frames: &[Frame<C>],
) -> Result<(), PictureError> {
    for (k, frame) in frames.iter().enumerate() {
        open(page, k);
        let _ = writeln!(page, "<h2>{}</h2>", escaped(&frame.label));
        if let Ok(state) = &frame.shown {
            write_words(page, actuators, state);
            write_rows(page, grasp, tips, frame, state)?;
        }
        page.push_str("</section>\n");
    }
    Ok(())
}

fn write_words<const C: usize>(page: &mut String, actuators: &Actuators<C>, state: &Equilibrium<C>) {
    let words = Words::default();
    let _ = writeln!(
        page,
        "<p>Under {} {}; residual {}.</p>",
        words.load(&state.load),
        escaped(&state.told_motions(words).join("; ")),
        Words::with_digits(1).number(state.residuals.worst())
    );
    let caution = state.caution().map(|caution| format!("CAUTION: {caution}."));
    for note in state.vacuum_gone().into_iter().chain(caution) {
        let _ = writeln!(page, "<p class=\"none\">{}</p>", escaped(&note));
    }
    for motion in &state.free_motions {
        let _ = writeln!(
            page,
            "<p>Nothing resists {}: where the object goes is known up to that.</p>",
            escaped(&words.direction_of(motion))
        );
    }
    let at_their_limit: Vec<_> = actuators.that_yield(state).map(|(name, _)| escaped(name)).collect();
    if !at_their_limit.is_empty() {
        let _ = writeln!(page, "<p>At their limit, and yielding: {}.</p>", at_their_limit.join(", "));
    }
}

/// Writes a row for each contact. A soft fingertip has a row for its sums, and a row for each of its points, shown on request.
fn write_rows<const C: usize>(
    page: &mut String,
    grasp: &Grasp<C>,
    tips: &[ContactGroup],
    frame: &Frame<C>,
    state: &Equilibrium<C>,
) -> Result<(), PictureError> {
    // A table wider than a narrow screen scrolls by itself instead of the page.
    page.push_str("<div class=\"scrolls\">\n<table>\n<thead><tr>");
    for (heading, meaning) in TABLE_COLUMNS {
        let _ = write!(page, "<th title=\"{}\">{}</th>", escaped(meaning), escaped(heading));
    }
    page.push_str("</tr></thead>\n<tbody>\n");
    for (number, tip) in tips.iter().enumerate() {
        let contact = &grasp.contacts()[tip.contacts.start];
        if tip.is_soft() {
            let row = ContactRow::of_tip(tip, grasp.contacts(), state, frame);
            row.write(page, number, "", &tip.name, contact)?;
        }
        for i in tip.contacts.clone() {
            let (contact, answer) = (&grasp.contacts()[i], &state.contacts[i]);
            let class = if tip.is_soft() { " class=\"point\"" } else { "" };
            let name = if tip.is_soft() { contact.label_text(i) } else { tip.name.clone() };
            let friction = frame.friction(i, contact.friction_coefficient());
            ContactRow::of_point(answer, friction, state).write(page, number, class, &name, contact)?;
        }
    }
    page.push_str("</tbody>\n</table>\n</div>\n");
    Ok(())
}

/// Numbers of a row, in the order of the columns.
struct ContactRow {
    state: &'static str,
    numbers: [f64; 7],
}

impl ContactRow {
    fn of_point<const C: usize>(answer: &ContactAnswer<C>, friction: f64, state: &Equilibrium<C>) -> Self {
        let force = |newtons| without_rounding(newtons, state);
        let (pushes, rubs) = (force(answer.normal_force()), force(answer.friction_force()));
        let numbers = [
            pushes,
            rubs,
            if rubs == 0.0 { 0.0 } else { answer.friction_used() },
            friction,
            force(reserve(answer)),
            if answer.gap > 0.0 { answer.gap } else { answer.slip.norm() },
            answer.body_core.norm(),
        ];
        Self { state: word(answer), numbers }
    }

    /// The row of a soft fingertip: sums of forces and reserves, and the largest gap or slip.
    fn of_tip<const C: usize>(
        tip: &ContactGroup,
        contacts: &[Contact<C>],
        state: &Equilibrium<C>,
        frame: &Frame<C>,
    ) -> Self {
        let does = tip.resultant(contacts, state);
        let first = &contacts[tip.contacts.start];
        let answers = &state.contacts[tip.contacts.clone()];
        let normal = first.normal.normalize();
        let along = does.force - normal * does.force.dot(&normal);
        let moved =
            answers.iter().map(|answer| if answer.gap > 0.0 { answer.gap } else { answer.slip.norm() });
        let force = |newtons| without_rounding(newtons, state);
        let (pushes, rubs) = (does.normal_force, force(along.norm()));
        let numbers = [
            pushes,
            rubs,
            if rubs == 0.0 { 0.0 } else { rubs / pushes },
            frame.friction(tip.contacts.start, first.friction_coefficient()),
            force(answers.iter().map(reserve).sum()),
            moved.fold(0.0, f64::max),
            does.displacement.norm(),
        ];
        Self { state: does.word, numbers }
    }

    fn write<const C: usize>(
        &self,
        page: &mut String,
        tip: usize,
        class: &str,
        name: &str,
        contact: &Contact<C>,
    ) -> Result<(), PictureError> {
        if self.numbers.iter().any(|x| x.is_nan()) {
            return Err(PictureError(format!("a number of {name} is not a number")));
        }
        let mut words = self.numbers.map(short);
        if contact.hold == Hold::Bonded || contact.link.is_some() {
            // A bonded contact has no friction to use.
            (words[2], words[3]) = ("–".into(), contact.link.map_or("bonded", LinkKind::name).into());
        }
        let (name, class_of_state) = (escaped(name), self.state.replace(' ', "-"));
        let state = match contact.link {
            Some(LinkKind::Cable) if self.state == "separated" => "slack",
            Some(_) => "carries",
            None => self.state,
        };
        let _ = write!(
            page,
            "<tr data-contact=\"{tip}\"{class}><th>{name}</th><td class=\"{class_of_state}\">{state}</td>"
        );
        for words in words {
            let _ = write!(page, "<td>{words}</td>");
        }
        page.push_str("</tr>\n");
        Ok(())
    }
}

/// Friction in reserve, N; zero if it is rounding.
fn reserve<const C: usize>(answer: &ContactAnswer<C>) -> f64 {
    if no_friction_left(answer) { 0.0 } else { answer.margin }
}
