//! An equilibrium as a table: one row for each contact. Points of a soft fingertip share a row, unless `--points` asks for a row for each point. A
//! caution that the first line of the answer already contains is not printed again below the table.

use std::io::{self, Write};

use grasp_lcp::energy::Comparison;
use grasp_lcp::equilibrium::{Equilibrium, PadAnswer, TooFar, WholeAnswer};
use grasp_lcp::words::Words;

use crate::words::Style;

pub(crate) fn table(out: &mut dyn Write, style: Style, state: &Equilibrium<3>, said: &str) -> io::Result<()> {
    let rows: Vec<_> = if style.points {
        state.contacts.iter().map(WholeAnswer::Point).collect()
    } else {
        state.whole_contacts().collect()
    };
    let is_link_row = |row: &WholeAnswer<'_, 3>| row.link().is_some() && !style.points;
    let (links, rows): (Vec<_>, Vec<_>) = rows.into_iter().partition(is_link_row);
    let numbers = WithoutRounding { words: style.words, largest: state.largest_force() };
    let heads = heads(style.axes, rows.iter().any(|row| matches!(row, WholeAnswer::Pad(_))));
    let columns = heads.len();
    let lines: Vec<_> =
        std::iter::once(heads).chain(rows.iter().map(|row| cells(row, numbers, columns))).collect();
    if !rows.is_empty() {
        print(out, &lines)?;
    }
    for link in links {
        let carries = link.carries(style.words, state.largest_force()).unwrap_or_default();
        writeln!(out, "  {} {carries}", link.text())?;
    }
    let digits = style.precision();
    state.joints.iter().try_for_each(|joint| writeln!(out, "  {joint:.digits$}"))?;
    state.tendons.iter().try_for_each(|tendon| writeln!(out, "  {tendon:.digits$}"))?;
    let residual = Words::with_digits(1).number(state.residuals.worst());
    writeln!(out, "  {}, residual {residual}", state.motion_sentences(style.words).join("\n  "))?;
    state.free_motion_sentences(style.words).iter().try_for_each(|free| writeln!(out, "  {free}"))?;
    let is_new = |far: &&TooFar| {
        !said.contains(&if far.is_motion() { format!("{far:.digits$}") } else { far.reason(style.words) })
    };
    let caution = state.too_far.as_ref().filter(is_new).map(|far| far.caution(style.words));
    state.vacuum_gone().into_iter().chain(caution).try_for_each(|note| writeln!(out, "  CAUTION: {note}"))
}

/// Prints two lists of contact forces side by side, contact by contact: those of the equilibrium, and those of least elastic energy among all that
/// balance the load inside the cones. A grasp with soft fingertips is
/// printed only with `--points`, point by point.
pub(crate) fn compared(out: &mut dyn Write, style: Style, comparison: &Comparison<3>) -> io::Result<()> {
    let (Some(state), Some(minimum)) = (comparison.equilibrium.equilibrium(), comparison.minimum.minimum())
    else {
        return Ok(());
    };
    if !state.pads.is_empty() && !style.points {
        return Ok(());
    }
    let numbers = WithoutRounding { words: style.words, largest: state.largest_force() };
    let heads =
        ["contact", "F_n (N)", "|F_t| (N)", "F_n of least energy (N)", "|F_t| of least energy (N)", "state"];
    let mut lines = vec![heads.map(str::to_owned).to_vec()];
    for (contact, least) in state.contacts.iter().zip(&minimum.contacts) {
        let forces = [contact.force, least.force].map(|force| {
            [force[0], force.iter().skip(1).fold(0.0, |h: f64, f| h.hypot(*f))].map(|x| numbers.force(x))
        });
        let mut cells = vec![contact.contact.text()];
        cells.extend(forces.concat());
        cells.push(contact.state_text().to_owned());
        lines.push(cells);
    }
    print(out, &lines)
}

fn heads(axes: usize, pads: bool) -> Vec<String> {
    let moments: &[_] = match (pads, axes) {
        (false, _) => &[],
        (true, 2) => &["M (N m)"],
        (true, _) => &["M_n (N m)", "|M_t| (N m)"],
    };
    let [first, last] = [&["contact", "F_n (N)", "|F_t| (N)"][..], &["margin (N)", "state"]];
    first.iter().chain(moments).chain(last).map(|head| (*head).to_owned()).collect()
}

/// Writes the forces of one table; forces that are only rounding errors become zero.
#[derive(Clone, Copy)]
struct WithoutRounding {
    words: Words,
    /// The largest force, N; forces that are rounding errors relative to this force become zero.
    largest: f64,
}

impl WithoutRounding {
    fn force(self, x: f64) -> String {
        self.words.number(self.words.beside(x, self.largest))
    }
}

fn cells(row: &WholeAnswer<'_, 3>, numbers: WithoutRounding, columns: usize) -> Vec<String> {
    let force = row.force();
    let mut cells = vec![row.text(), numbers.force(force[0]), numbers.force(row.friction_force())];
    if columns > 5 {
        cells.extend(match row {
            WholeAnswer::Pad(pad) => moments(pad, columns - 5, numbers.words),
            WholeAnswer::Point(_) => vec!["0".to_owned(); columns - 5],
        });
    }
    let margin = if row.margin().is_finite() { numbers.force(row.margin()) } else { "no limit".to_owned() };
    let pulls = if numbers.words.beside(force[0], numbers.largest) < 0.0 { ", pulls" } else { "" };
    cells.extend([margin, format!("{}{pulls}", row.state_text())]);
    cells
}

/// The moment of a soft fingertip about its centre: one column in the plane; in space two, about the normal and across the normal.
fn moments(pad: &PadAnswer<3>, columns: usize, words: Words) -> Vec<String> {
    match *pad.moment() {
        [_, _, in_the_plane] if columns == 1 => vec![words.number(in_the_plane)],
        [about_n, first, second] => vec![words.number(about_n), words.number(f64::hypot(first, second))],
        _ => Vec::new(),
    }
}

/// Prints a table whose columns have the same width in every line, names left-aligned, numbers right-aligned.
fn print(out: &mut dyn Write, lines: &[Vec<String>]) -> io::Result<()> {
    let width = |column: usize| lines.iter().map(|line| line[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<_> = (0..lines[0].len()).map(width).collect();
    for line in lines {
        let Some(([name, numbers @ ..], state)) = line.split_last().map(|(state, rest)| (rest, state)) else {
            continue;
        };
        write!(out, "  {name:0$}", widths[0])?;
        for (number, width) in numbers.iter().zip(&widths[1..]) {
            write!(out, "  {number:>width$}")?;
        }
        writeln!(out, "  {state}")?;
    }
    Ok(())
}
