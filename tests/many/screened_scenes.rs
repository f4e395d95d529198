//! Shared by tests of screening: random scenes, and comparison of answers.

use std::cell::RefCell;
use std::collections::BTreeMap;

use grasp_lcp::grasp::Contact;
use support::scene::Datum;

/// Number of scenes for each verdict.
pub(crate) type Tally = RefCell<BTreeMap<String, usize>>;

pub(crate) fn count(tally: &Tally, verdict: &str) {
    *tally.borrow_mut().entry(verdict.to_owned()).or_default() += 1;
}

pub(crate) fn of(tally: &Tally, verdict: &str) -> usize {
    tally.borrow().get(verdict).copied().unwrap_or_default()
}

/// Contacts from data, with one tangential stiffness each. Some are kept closed or bonded.
pub(crate) fn contacts<const C: usize, const N: usize>(data: &[Datum<C>], holds: &[u8]) -> [Contact<C>; N] {
    std::array::from_fn(|i| {
        let mut datum = data[i];
        datum.stiffness[C - 1] = datum.stiffness[1];
        if C == 3 && datum.friction < 10.0 {
            // With less inclined normals and more friction, fewer contacts slide at once.
            datum.normal -= 2.0 * datum.point;
            datum.friction *= 2.0;
            datum.command.rows_range_mut(1..).fill(0.0);
        }
        match holds[i] {
            0 => datum.contact().kept_closed(),
            1 => datum.contact().bonded(),
            _ => datum.contact(),
        }
    })
}

/// Fingers with normals closer to the middle, more friction and less shear, most of which stick at rest.
pub(crate) fn firmer<const C: usize>(mut data: Vec<Datum<C>>) -> Vec<Datum<C>> {
    for datum in &mut data {
        datum.normal -= datum.point * 2.0;
        datum.command.rows_range_mut(1..).fill(0.0);
        datum.friction *= if datum.friction < 10.0 { 2.0 } else { 1.0 };
    }
    data
}

/// The contacts with small changes of points and stiffnesses. `part` is the relative size of the changes, whose sign alternates.
pub(crate) fn shaken<const C: usize>(data: &[Datum<C>], part: f64) -> Vec<Datum<C>> {
    let mut sign = part;
    let mut data = data.to_vec();
    for datum in &mut data {
        for axis in 0..C {
            datum.point[axis] *= 1.0 + sign;
            sign = -sign;
        }
        datum.stiffness *= 1.0 + sign;
    }
    data
}

/// Whether a number agrees with a reference, to a relative tolerance. A larger difference is accepted if changes of the twelfth digits of the data
/// change the reference as much. A search may also end slightly too low, because it ends when what is missing may be rounding.
pub(crate) fn agrees(
    [found, exact]: [f64; 2],
    close: f64,
    others: impl Fn(f64) -> f64,
    tally: &Tally,
) -> bool {
    let off = (found - exact).abs();
    let sharp = off <= close * exact.abs();
    count(tally, if sharp { "close" } else { "as the question" });
    sharp
        || off <= 10.0 * close * exact.abs()
        || off <= [1e-12, -1e-12].map(|part| (others(part) - exact).abs()).into_iter().fold(0.0, f64::max)
}
