//! Scenes that screening is asked about.

use std::cell::RefCell;
use std::collections::BTreeMap;

use grasp_lcp::grasp::Contact;
use support::scene::Datum;

/// How often each verdict came.
pub(crate) type Tally = RefCell<BTreeMap<String, usize>>;

pub(crate) fn count(tally: &Tally, verdict: &str) {
    *tally.borrow_mut().entry(verdict.to_owned()).or_default() += 1;
}

pub(crate) fn of(tally: &Tally, verdict: &str) -> usize {
    tally.borrow().get(verdict).copied().unwrap_or_default()
}

/// Contacts from data, with one tangential stiffness each; some are held in other ways.
pub(crate) fn contacts<const C: usize, const N: usize>(data: &[Datum<C>], holds: &[u8]) -> [Contact<C>; N] {
    std::array::from_fn(|i| {
        let mut datum = data[i];
        datum.stiffness[C - 1] = datum.stiffness[1];
        if C == 3 && datum.friction < 10.0 {
            // Fewer slide at once.
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
