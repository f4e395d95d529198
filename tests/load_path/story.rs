//! Shared by tests of load paths: comparison of numbers, and lists of the events of a path.
#![allow(dead_code)]

use grasp_lcp::load_path::{Change, Event, PathEnd};

pub(crate) use support::assert_close;

pub(crate) fn completed<const C: usize>(end: Option<&PathEnd<C>>) -> bool {
    matches!(end, Some(PathEnd::Completed))
}

/// An event: leg, fraction, and the changes of contacts.
pub(crate) type Line = (usize, f64, Vec<(usize, &'static str)>);

/// The events of a path, without directions.
pub(crate) fn story<const C: usize>(events: &[Event<C>]) -> Vec<Line> {
    let word = |change: &Change<C>| match change {
        Change::Slides { .. } => "slides",
        Change::Sticks => "sticks",
        Change::Reverses { .. } => "reverses",
        Change::Turns { .. } => "turns",
        Change::Opens => "opens",
        Change::Closes => "closes",
        Change::ClosesSliding { .. } => "closes sliding",
    };
    let all =
        |e: &Event<C>| e.changes.iter().map(|change| (change.contact.index, word(&change.what))).collect();
    events.iter().map(|e| (e.leg, e.fraction, all(e))).collect()
}

pub(crate) fn assert_story<const C: usize>(events: &[Event<C>], expected: &[Line]) {
    let got = story(events);
    assert_eq!(got.len(), expected.len(), "{got:#?}");
    for (got, want) in got.iter().zip(expected) {
        assert_eq!((got.0, &got.2), (want.0, &want.2), "{got:?}");
        assert_close!(got.1, want.1);
    }
}
