//! Parallel work on all cores (feature `parallel`); no other module uses threads. The work is passed as a trait object, so that the code for
//! threads is compiled only once.

use crate::numerics::IntoList;
use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

use crate::prelude::*;

/// Calls `what` with each number from 0 to `count` − 1, in parallel. A panic in `what` is passed on to the caller.
fn for_each(count: usize, what: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(what);
}

/// Results of `f` for all items, in the order of the items.
pub(crate) fn in_order<T: Sync, R: Send>(items: &[T], f: &(impl Fn(&T) -> R + Sync)) -> Vec<R> {
    let mut answers: Vec<Mutex<Option<R>>> = Vec::new();
    answers.resize_with(items.len(), Mutex::default);
    for_each(items.len(), &|k| {
        let answer = f(&items[k]);
        *answers[k].lock().unwrap_or_else(PoisonError::into_inner) = Some(answer);
    });
    let mut all = Vec::with_capacity(items.len());
    for answer in answers {
        if let Some(answer) = answer.into_inner().unwrap_or_else(PoisonError::into_inner) {
            all.push(answer);
        }
    }
    all
}

/// Calls `f` with each item by value, in parallel.
pub(crate) fn each_taken<T: Send>(items: impl Iterator<Item = T>, f: &(impl Fn(T) + Sync)) {
    let items: Vec<Mutex<Option<T>>> = items.map(|item| Mutex::new(Some(item))).list();
    for_each(items.len(), &|k| {
        if let Some(item) = items[k].lock().unwrap_or_else(PoisonError::into_inner).take() {
            f(item);
        }
    });
}

/// Results of both functions, which run on two threads.
pub(crate) fn both<R: Send>(a: impl FnOnce() -> R + Send, b: impl FnOnce() -> R + Send) -> (R, R) {
    let (mut first, mut second) = (None, None);
    {
        let (mut a, mut b) = (Some(a), Some(b));
        side_by_side(&mut || first = a.take().map(|a| a()), &mut || second = b.take().map(|b| b()));
    }
    first.zip(second).expect("both have been done")
}

fn side_by_side(a: &mut (dyn FnMut() + Send), b: &mut (dyn FnMut() + Send)) {
    rayon::join(a, b);
}
