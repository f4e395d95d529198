//! Events of whole contacts, i.e. of point contacts, and of soft fingertips with all their contact points. At an event contact points change their
//! states (sticking, sliding, open) at one point of a load path. A soft fingertip begins to slide with its first point, and slides everywhere with
//! its last; changes of the points between are not reported.

use core::fmt;

use super::event::{Change, ContactChange, Event};
use crate::equilibrium::{ContactState, Equilibrium, PadAnswer};
use crate::error::ContactLabel;
use crate::numerics::{IntoList, picked};
use crate::prelude::*;
use crate::words::{Words, opens};

/// A change of one contact at an event. The points of a soft fingertip are taken together as one contact.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct WholeChange<const C: usize> {
    /// The contact whose state changes.
    pub contact: ContactLabel,
    /// The behaviour of the contact from this event on.
    pub what: PadChange<C>,
}

/// The behaviour of a contact from an event on. For a point contact it is its change of state. A soft fingertip is listed when its first point, or
/// its last closed point, changes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum PadChange<const C: usize> {
    /// A point contact changes its state.
    Point(Change<C>),
    /// The first points of a fingertip slide, and others still stick; before, no point slid.
    BeginsToSlide,
    /// All closed points of a fingertip slide; before, some of them did not.
    SlidesEverywhere,
    /// Some points of a fingertip stick, others slide on; before, all closed points slid.
    SticksInPart,
    /// No point of a fingertip slides any more, but some still touch.
    SticksAgain,
    /// All sliding points of a fingertip reverse their direction of sliding.
    SlidesBack,
    /// The first points of a fingertip open; before, all points touched.
    BeginsToOpen,
    /// The last points of a fingertip open, so that no point touches.
    Opens,
    /// The first points of a fingertip touch; before, no point touched.
    Touches,
    /// The last points of a fingertip touch, so that no point is open.
    TouchesEverywhere,
    /// The contact is kept closed, and its normal force has fallen to zero. If it stayed closed beyond the event, it would have to pull on the
    /// object, and while it pulls it cannot have a friction force.
    WouldPull,
}

impl<const C: usize> fmt::Display for PadChange<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Point(change) => return write!(f, "{change:.*}", Words::of(f).precision()),
            Self::BeginsToSlide => "begins to slide",
            Self::SlidesEverywhere => "slides everywhere",
            Self::SticksInPart => "sticks in part",
            Self::SticksAgain => "sticks again",
            Self::SlidesBack => "slides back",
            Self::BeginsToOpen => "begins to open",
            Self::Opens => "opens",
            Self::Touches => "touches",
            Self::TouchesEverywhere => "touches everywhere",
            Self::WouldPull => "would have to pull",
        })
    }
}

/// Writes the change as text, for example "left begins to slide".
impl<const C: usize> fmt::Display for WholeChange<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.contact.text();
        match (self.contact.link, self.what) {
            (link @ Some(_), PadChange::Point(Change::Opens)) => write!(f, "{name} {}", opens(link)),
            (Some(_), PadChange::Point(Change::Closes)) => write!(f, "{name} pulls tight"),
            (_, what) => write!(f, "{name} {what:.*}", Words::of(f).precision()),
        }
    }
}

impl<const C: usize> WholeChange<C> {
    /// The verb of a sentence about this change, with the contact as subject: "slides", "begins to open". It does not say in which direction a
    /// contact slips.
    #[must_use]
    pub fn verb(&self) -> String {
        self.verb_in(Words::default())
    }

    /// The verb of a sentence about this change, with numbers in the format `words`. Only the verb of a contact whose direction of sliding turns has
    /// numbers, the components of the new direction: "turns to (0.6, 0.8, 0)".
    #[must_use]
    pub fn verb_in(&self, words: Words) -> String {
        let said = format!("{self:.*}", words.precision());
        match self.what {
            PadChange::Point(Change::Slides { .. }) => "slides".to_owned(),
            PadChange::Point(Change::ClosesSliding { .. }) => "closes and slides".to_owned(),
            PadChange::Point(Change::Reverses { .. }) => "slides back".to_owned(),
            _ => said.strip_prefix(&format!("{} ", self.contact.text())).unwrap_or("changes").to_owned(),
        }
    }
}

impl<const C: usize> Event<C> {
    /// The changes at this event, contact by contact, as [`PadChange`]s: the points of a soft fingertip are taken together. Empty if only points of
    /// fingertips change that are neither the first nor the last of their fingertip to change.
    #[must_use]
    pub fn whole_changes(&self) -> Vec<WholeChange<C>> {
        whole_changes(&self.state, &self.changes)
    }
}

/// Writes the event as text, for example "leg 1 at 0.5, (0, -4) N: left begins to slide".
impl<const C: usize> fmt::Display for Event<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (words, digits) = (Words::of(f), Words::of(f).precision());
        let (fraction, load) = (words.number(self.fraction), words.load(&self.load));
        write!(f, "leg {} at {fraction}, {load}:", self.leg + 1)?;
        let contacts = self.whole_changes().into_iter().map(|change| format!(" {change:.digits$}"));
        let drives = self.drives.iter().map(|drive| format!(" {} {}", drive.part.text(), drive.what));
        let texts: Vec<_> = contacts.chain(drives).list();
        f.write_str(&if texts.is_empty() { " more points change".to_owned() } else { texts.join(",") })?;
        match &self.jump {
            Some(jump) => write!(f, "; {jump:.digits$}"),
            None => Ok(()),
        }
    }
}

/// The changes `changes` of contact points at an event, summed up as changes of point contacts and of soft fingertips as a whole. `state` is the
/// equilibrium before the event. The contacts are in the order in which they first occur in `changes`.
pub(crate) fn whole_changes<const C: usize>(
    state: &Equilibrium<C>,
    changes: &[ContactChange<C>],
) -> Vec<WholeChange<C>> {
    let site = |change: &ContactChange<C>| {
        state.contacts.iter().position(|contact| contact.contact == change.contact)
    };
    let sites = picked(changes, &|change| Some((site(change)?, change)));
    let mut all = Vec::new();
    for (at, change) in &sites {
        let Some(pad) = state.pads.iter().find(|pad| pad.range().contains(at)) else {
            all.push(WholeChange { contact: change.contact.clone(), what: PadChange::Point(change.what) });
            continue;
        };
        let of_pad = picked(&sites, &|(i, change)| pad.range().contains(i).then_some((*i, change.what)));
        if of_pad[0].0 == *at {
            let whole = |what| WholeChange { contact: pad.contact.clone(), what };
            all.extend(PadAtEvent::of(state, pad, &of_pad).pad_changes().into_iter().map(whole));
        }
    }
    all
}

/// Numbers of points of one fingertip in each state before and after an event, and of points that reverse their direction of sliding.
struct PadAtEvent {
    before: PadCount,
    after: PadCount,
    slide_back: usize,
}

impl PadAtEvent {
    fn of<const C: usize>(
        state: &Equilibrium<C>,
        pad: &PadAnswer<C>,
        changes: &[(usize, Change<C>)],
    ) -> Self {
        let (mut before, mut after) = (PadCount::default(), PadCount::default());
        for i in pad.range() {
            let state = PointState::of(&state.contacts[i].state);
            let change = changes.iter().find(|(at, _)| *at == i).map(|(_, what)| what);
            let [was, is] = change.map_or([state; 2], |change| PointState::change(change, state));
            before.add(was);
            after.add(is);
        }
        let slide_back = changes.iter().filter(|(_, what)| matches!(what, Change::Reverses { .. })).count();
        Self { before, after, slide_back }
    }

    fn pad_changes<const C: usize>(&self) -> Vec<PadChange<C>> {
        let Self { before, after, slide_back } = self;
        let all_slide = |count: &PadCount| count.closed > 0 && count.slide == count.closed;
        let mut changes = Vec::new();
        let mut add = |is_so: bool, what| {
            if is_so {
                changes.push(what);
            }
        };
        if after.closed == 0 {
            add(before.closed > 0, PadChange::Opens);
            return changes;
        }
        add(before.closed == 0, PadChange::Touches);
        add(before.closed > 0 && before.open == 0 && after.open > 0, PadChange::BeginsToOpen);
        add(before.closed > 0 && before.open > 0 && after.open == 0, PadChange::TouchesEverywhere);
        add(!all_slide(before) && all_slide(after), PadChange::SlidesEverywhere);
        add(before.slide == 0 && after.slide > 0 && !all_slide(after), PadChange::BeginsToSlide);
        add(before.slide > 0 && after.slide == 0, PadChange::SticksAgain);
        add(all_slide(before) && after.slide > 0 && !all_slide(after), PadChange::SticksInPart);
        add(*slide_back > 0 && *slide_back == after.slide, PadChange::SlidesBack);
        changes
    }
}

/// The state of one point of a fingertip. A frictionless point that touches is treated as sticking.
#[derive(Debug, Clone, Copy, PartialEq)]
enum PointState {
    Open,
    Sticks,
    Slides,
}

impl PointState {
    fn of<const C: usize>(state: &ContactState<C>) -> Self {
        match state {
            ContactState::Separated => Self::Open,
            ContactState::Sticking | ContactState::Frictionless => Self::Sticks,
            ContactState::Sliding { .. } => Self::Slides,
        }
    }

    /// The states of a point of a fingertip before and after `change`. `state` is the state of the point in the equilibrium that the event stores: as
    /// a rule the equilibrium before the event. It is needed only for a point that opens, which may have slid or stuck before. At the very start of a
    /// path there is no earlier equilibrium, and `state` is the state after the change.
    fn change<const C: usize>(change: &Change<C>, state: Self) -> [Self; 2] {
        match change {
            Change::Slides { .. } => [Self::Sticks, Self::Slides],
            Change::Sticks => [Self::Slides, Self::Sticks],
            Change::Reverses { .. } | Change::Turns { .. } => [Self::Slides, Self::Slides],
            Change::Opens if state == Self::Slides => [Self::Slides, Self::Open],
            Change::Opens => [Self::Sticks, Self::Open],
            Change::Closes => [Self::Open, Self::Sticks],
            Change::ClosesSliding { .. } => [Self::Open, Self::Slides],
        }
    }
}

/// Numbers of points of a fingertip that are closed, that slide (also counted as closed), and that are open.
#[derive(Debug, Clone, Copy, Default)]
struct PadCount {
    closed: usize,
    slide: usize,
    open: usize,
}

impl PadCount {
    fn add(&mut self, point: PointState) {
        self.closed += usize::from(point != PointState::Open);
        self.slide += usize::from(point == PointState::Slides);
        self.open += usize::from(point == PointState::Open);
    }
}
