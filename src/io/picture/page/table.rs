//! The tables of a page: one section for each answer, of which the page shows one. A fingertip is a contact with all its points; a soft fingertip has
//! several. A link (a hinge or cable, for example) joins two bodies, or a body and the ground.

use std::fmt::Write;
use std::ops::Range;

use super::frame::Frame;
use crate::ask::Grasp;
use crate::equilibrium::{ContactAnswer, Equilibrium, WholeAnswer};
use crate::grasp::{Contact, ContactPoints, Hold};
use crate::numerics::{Space, chosen, largest, mapped};
use crate::picture::actuators::Actuators;
use crate::picture::contact_look::word;
use crate::picture::error::PictureError;
use crate::picture::fingertip::without_rounding;
use crate::picture::words::{caution, escaped, short};
use crate::words::{LinkKind, Words};

/// Headings of the table's columns, each with the explanation that appears when the mouse pointer is on it.
const TABLE_COLUMNS: [(&str, &str); 10] = [
    ("contact", "name"),
    ("state", "what the contact does"),
    ("F_n (N)", "normal force; positive pushes"),
    ("|F_t| (N)", "friction force"),
    ("M_n (N m)", "moment of a pad about its normal; in the plane its moment"),
    ("|F_t|/F_n", "friction used"),
    ("μ", "coefficient of friction"),
    ("μF_n − |F_t| (N)", "friction in reserve"),
    ("gap, slip (mm)", "gap of an open contact; slip of the finger over the object"),
    ("|u_c| (mm)", "displacement of the object at the contact"),
];

/// Index of a soft fingertip's moment in the list of a row's numbers. The list starts at the third column of the table. Tables without soft
/// fingertips have no column for this moment.
const MOMENT: usize = 2;

/// Writes the sentences of each answer, or the reason why it has no equilibrium, at the top of the page.
pub(super) fn write_says(page: &mut String, frames: &[Frame]) {
    for (k, frame) in frames.iter().enumerate() {
        open(page, k);
        for sentence in &frame.says {
            let _ = writeln!(page, "<p class=\"says\">{}</p>", escaped(sentence));
        }
        match &frame.shown {
            Err(why) => {
                let _ = writeln!(page, "<p class=\"none\">{}</p>", escaped(why));
            }
            // An equilibrium to which no sentence was added gets the label of its answer as its only sentence.
            Ok(_) if frame.says.is_empty() => {
                let _ = writeln!(page, "<p class=\"says\">{}</p>", escaped(&frame.label));
            }
            Ok(_) => {}
        }
        page.push_str("</section>\n");
    }
}

/// Opens the section of the answer with the index `frame`; only the section of the first answer is visible initially.
fn open(page: &mut String, frame: usize) {
    let hidden = if frame == 0 { "" } else { " hidden" };
    let _ = writeln!(page, "<section data-frame=\"{frame}\"{hidden}>");
}

pub(super) fn write(
    page: &mut String,
    grasp: &Grasp<3>,
    actuators: &Actuators,
    frames: &[Frame],
) -> Result<(), PictureError> {
    for (k, frame) in frames.iter().enumerate() {
        open(page, k);
        let _ = writeln!(page, "<h2>{}</h2>", escaped(&frame.label));
        if let Ok(state) = &frame.shown {
            write_words(page, grasp.space(), actuators, state, &frame.says);
            write_rows(page, grasp, frame, state)?;
        }
        page.push_str("</section>\n");
    }
    Ok(())
}

fn write_words(
    page: &mut String,
    space: Space,
    actuators: &Actuators,
    state: &Equilibrium<3>,
    says: &[String],
) {
    let words = Words::default().in_space(space);
    let _ = writeln!(
        page,
        "<p>Under {} {}; residual {}.</p>",
        words.load(&state.load),
        escaped(&state.motion_sentences(words).join("; ")),
        Words::with_digits(1).number(state.residuals.worst())
    );
    let caution = caution(Some(state), says.iter().map(String::as_str)).map(|words| format!("{words}."));
    for note in state.vacuum_gone().into_iter().chain(caution) {
        let _ = writeln!(page, "<p class=\"none\">{}</p>", escaped(&note));
    }
    for motion in state.free_motion_sentences(words) {
        let _ = writeln!(page, "<p>{}.</p>", escaped(&motion));
    }
    let at_their_limit = mapped(&actuators.that_yield(state), &|(name, _)| escaped(name));
    if !at_their_limit.is_empty() {
        let _ = writeln!(page, "<p>At their limit, and yielding: {}.</p>", at_their_limit.join(", "));
    }
}

/// Writes a row for each contact. A soft fingertip has a row for the sums over its points, and a row for each point; the rows of points are shown on
/// request.
fn write_rows(
    page: &mut String,
    grasp: &Grasp<3>,
    frame: &Frame,
    state: &Equilibrium<3>,
) -> Result<(), PictureError> {
    // A table wider than a narrow screen scrolls by itself instead of the page.
    page.push_str("<div class=\"scrolls\">\n<table>\n<thead><tr>");
    let has_pads = grasp.engine.wholes().iter().any(ContactPoints::is_soft);
    let shown = |column: &usize| has_pads || *column != 2 + MOMENT;
    for column in chosen(TABLE_COLUMNS.len(), &shown) {
        let (heading, meaning) = TABLE_COLUMNS[column];
        let _ = write!(page, "<th title=\"{}\">{}</th>", escaped(meaning), escaped(heading));
    }
    page.push_str("</tr></thead>\n<tbody>\n");
    for (tip, whole) in grasp.engine.wholes().iter().zip(state.whole_contacts()) {
        let (number, name) = (tip.label.index, tip.text());
        let resultant = tip.resultant(grasp.contacts(), state);
        let mut row =
            |class: &str, name: &str, points: Range<usize>, answer: WholeAnswer<'_, 3>, look, moves: f64| {
                let contact = &grasp.contacts()[points.start];
                let friction = frame.friction(points.start, contact.friction_coefficient());
                let numbers = numbers(grasp.space(), answer, &state.contacts[points], friction, moves, state);
                let _ = write!(page, "<tr data-contact=\"{number}\"{class}><th>{}</th>", escaped(name));
                write_row(page, contact, answer, look, numbers, has_pads)
                    .map_err(|fault| PictureError(format!("{fault} of {name}")))
            };
        row("", &name, tip.range.clone(), whole, resultant.word, resultant.displacement.norm())?;
        for i in tip.range.clone().filter(|_| tip.is_soft()) {
            let (name, answer) = (grasp.contacts()[i].label_text(i), &state.contacts[i]);
            let point = WholeAnswer::Point(answer);
            row(" class=\"point\"", &name, i..i + 1, point, word(answer), answer.body_core.norm())?;
        }
    }
    page.push_str("</tbody>\n</table>\n</div>\n");
    Ok(())
}

/// The numbers of a contact for its row of the table, in the order of the columns, lengths in mm. The gap or slip is the largest among the points of
/// the fingertip.
fn numbers(
    space: Space,
    answer: WholeAnswer<'_, 3>,
    points: &[ContactAnswer<3>],
    friction: f64,
    moves: f64,
    state: &Equilibrium<3>,
) -> [f64; 8] {
    let force = |newtons| without_rounding(newtons, state);
    let (pushes, rubs) = (force(answer.force()[0]), force(answer.friction_force()));
    let used = if rubs == 0.0 { 0.0 } else { rubs / pushes };
    let moment = match (answer, space) {
        (WholeAnswer::Pad(pad), Space::Spatial) => pad.moment()[0],
        (WholeAnswer::Pad(pad), Space::Planar) => pad.moment()[pad.moment().len() - 1],
        (WholeAnswer::Point(_), _) => 0.0,
    };
    // A moment is written as zero if it is only a rounding error compared with the largest contact force times this lever arm, m. Pads are larger
    // than a millimetre.
    let arm = 1e-3;
    let moment = Words::default().beside(moment, arm * state.largest_force());
    let moved = |point: &ContactAnswer<3>| if point.gap > 0.0 { point.gap } else { point.slip.norm() };
    let most = |points: &[ContactAnswer<3>]| largest(points, &moved);
    // A length is written as zero if it is only a rounding error compared with the largest length of all contacts.
    let largest = most(&state.contacts).max(largest(&state.contacts, &|one| one.body_core.norm()));
    let length = |metres: f64| 1e3 * Words::default().beside(metres, largest);
    [pushes, rubs, moment, used, friction, force(answer.margin()), length(most(points)), length(moves)]
}

/// Writes the contact state of a contact, in the colour of `look`, and its numbers.
fn write_row(
    page: &mut String,
    contact: &Contact<3>,
    answer: WholeAnswer<'_, 3>,
    look: &str,
    numbers: [f64; 8],
    has_pads: bool,
) -> Result<(), &'static str> {
    if numbers.iter().any(|x| x.is_nan()) {
        return Err("a number is not a number");
    }
    let mut words = numbers.map(short);
    if contact.hold == Hold::Bonded || contact.link.is_some() {
        // A bonded contact has no limit of friction. A dash takes the place of the friction used, and "bonded" or the kind of link takes the place of
        // μ.
        (words[3], words[4]) = ("–".into(), contact.link.map_or("bonded", LinkKind::name).into());
    }
    let state = match contact.link {
        Some(LinkKind::Cable) if look == "separated" => "slack".to_owned(),
        Some(_) => "carries".to_owned(),
        None => answer.state_text(),
    };
    let _ = write!(page, "<td class=\"{}\">{state}</td>", look.replace(' ', "-"));
    for (_, words) in words.iter().enumerate().filter(|(column, _)| has_pads || *column != MOMENT) {
        let _ = write!(page, "<td>{words}</td>");
    }
    page.push_str("</tr>\n");
    Ok(())
}
