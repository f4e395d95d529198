//! Rows of a batch, each a grasp with its loads, and the load factors of first slip that screening computes for the rows. At first slip the first
//! contact ceases to stick. The base load acts before the other load grows.

use crate::numerics::{IntoList, Space, numbered};
use core::ops::Range;

use crate::grasp::{Contact, Hold, Wrench};
use crate::prelude::*;
use crate::screening::{PointBatch, Pull, SlipAndRotation, WhileSticking};
use crate::search::Settings;
use crate::sweep::map_in_order;

/// A function that gives the row of a batch with an index, from 0. It appends the contacts of the row's grasp to an empty list. It returns the base
/// load, and the load that grows in addition.
pub type RowOf<'a, const C: usize> = dyn Fn(usize, &mut Vec<Contact<C>>) -> [Wrench<C>; 2] + Sync + 'a;

/// Number of rows in one task of a thread, few enough for their data to fit in the cache of a core.
const CHUNK: usize = 256;

/// The answers for all rows, in the order of the rows. `answers` computes the answers for a range of rows; each core works on one such range at a
/// time.
pub(crate) fn answers_of_rows<T: Send>(
    rows: usize,
    answers: &(dyn Fn(Range<usize>) -> Vec<T> + Sync),
) -> Vec<T> {
    let chunks = numbered(rows.div_ceil(CHUNK), &|k| k * CHUNK..rows.min((k + 1) * CHUNK));
    map_in_order(&chunks, |chunk| answers(chunk.clone())).into_iter().flatten().list()
}

/// For each row the load factor of first slip, and the larger of the object's rotations under the base load and under the whole load. `None` for a
/// row whose contacts screening does not support. Also `None` if `is_meant`, which gets the contacts and base load of a row, returns false.
pub(crate) fn while_sticking<const C: usize>(
    rows: Range<usize>,
    row: &RowOf<'_, C>,
    settings: &Settings,
    is_meant: &dyn Fn(&[Contact<C>], &Wrench<C>) -> bool,
) -> Vec<Option<WhileSticking>> {
    let mut answers = vec![None; rows.len()];
    let is_exact = C == 2 || settings.is_round(Space::Spatial);
    if !is_exact || settings.small_motions.check().is_err() {
        return answers;
    }
    let (mut batch, mut contacts) = (None, Vec::new());
    let (mut pulls, mut places) = (Vec::with_capacity(rows.len()), Vec::with_capacity(rows.len()));
    for (place, number) in rows.clone().enumerate() {
        contacts.clear();
        let [base, load] = row(number, &mut contacts);
        // Two kinds of rows are left to the caller, which computes their load path. If all contacts are bonded, the object may lie loose without any
        // force, which screening does not notice. And screening computes no slips of contacts without friction.
        let presses = contacts.iter().any(|contact| contact.hold == Hold::Unilateral);
        let sticks = |contact: &Contact<C>| contact.hold == Hold::Bonded || contact.springs() > 1;
        if !(presses && contacts.iter().all(sticks) && is_meant(&contacts, &base)) {
            continue;
        }
        let Ok(pull) = Pull::new(&base, &load) else { continue };
        let batch = batch.get_or_insert_with(|| PointBatch::with_capacity(contacts.len(), rows.len()));
        if batch.push(&contacts) {
            pulls.push(pull);
            places.push(place);
        }
    }
    if let Some(batch) = batch {
        let found = SlipAndRotation { pulls, turns: true }.answers(&batch);
        places.into_iter().zip(found).for_each(|(place, answer)| answers[place] = Some(answer));
    }
    answers
}
