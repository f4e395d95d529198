//! A load path in words: its events, its end, and the soft fingertips that slide or open completely at its end.

use std::io;

use grasp_lcp::equilibrium::{ContactAnswer, ContactState, Equilibrium, PadAnswer};
use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::{ContactChange, EndOfSmallMotions, Loss};
use grasp_lcp::scene::{PathAnswer, PathOutcome};

use crate::report::Report;

impl Report<'_> {
    pub(crate) fn followed(&mut self, path: &PathAnswer<3>) -> io::Result<()> {
        let digits = self.style.precision();
        let (mut in_between, mut caution) = (0, path.small_motions_end.as_ref());
        for event in &path.events {
            if let Some(far) = caution.filter(|far| (far.leg, far.fraction) < (event.leg, event.fraction)) {
                self.small_motions_end(far)?;
                caution = None;
            }
            let contacts: Vec<_> = if self.style.points {
                let point =
                    |change: &ContactChange<3>| format!("{} {:.digits$}", change.contact.text(), change.what);
                event.changes.iter().map(point).collect()
            } else {
                event.whole_changes().iter().map(|change| format!("{change:.digits$}")).collect()
            };
            in_between += usize::from(contacts.is_empty() && !event.changes.is_empty());
            let drives = event.drives.iter().map(|drive| format!("{} {}", drive.part.text(), drive.what));
            for what in contacts.into_iter().chain(drives) {
                let (fraction, load) =
                    (self.number(event.fraction), self.load_of(&event.load, Some(&event.state)));
                self.line(&format!("leg {} at {fraction}, {load}: {what}", event.leg + 1))?;
            }
            if let Some(jump) = &event.jump {
                let (fraction, load) = (self.number(event.fraction), self.load(&event.load));
                self.line(&format!("leg {} at {fraction}, {load}: {jump:.digits$}", event.leg + 1))?;
            }
        }
        caution.map_or(Ok(()), |far| self.small_motions_end(far))?;
        for steps in path.steps.chunk_by(|a, b| a.leg == b.leg) {
            let Some(last) = steps.last() else { continue };
            let (fraction, load) = (self.number(last.fraction), self.load(&last.load));
            let (leg, count, sliding, open) = (last.leg + 1, steps.len(), last.sliding, last.open);
            self.line(&format!(
                "leg {leg} at {fraction}, {load}: contacts sliding: {sliding}, open: {open}, steps: {count}"
            ))?;
        }
        if !path.steps.is_empty() {
            let error = self.number(path.step_error);
            self.line(&format!("estimated error of the forces: {error} of the largest; a slip that begins and ends within one step is not seen"
            ))?;
        }
        if in_between > 0 {
            self.line(&format!("in between at {in_between} loads more points change: --points tells them"))?;
        }
        self.end_of_path(&path.end)
    }

    fn small_motions_end(&mut self, far: &EndOfSmallMotions) -> io::Result<()> {
        let (leg, fraction) = (far.leg + 1, self.number(far.fraction));
        self.line(&format!(
            "leg {leg} at {fraction}: CAUTION, from here on {}",
            far.what.caution(self.style.words)
        ))
    }

    /// The load at a point of the path in words, with additional loads on bodies.
    fn load_of(&self, load: &Wrench<3>, state: Option<&Equilibrium<3>>) -> String {
        let loads = state.into_iter().flat_map(|state| &state.body_loads);
        self.load(load) + &self.and_on_bodies(loads.map(|load| (&*load.body, &load.load)))
    }

    /// Prints the equilibrium at the end of a path and, if equilibrium is lost at this end, whether an equilibrium exists beyond it.
    fn end_of_path(&mut self, end: &PathOutcome<3>) -> io::Result<()> {
        match end {
            PathOutcome::Completed { state } => self.state(state.as_deref()),
            PathOutcome::Lost { loss, beyond: next, state, .. } => {
                if !loss.jumped.is_empty() {
                    self.line(
                        "friction falls as contacts begin to slide there, and nothing catches the object",
                    )?;
                }
                if let Some(state) = state {
                    self.on_their_edge(loss, state)?;
                    self.table(state)?;
                }
                self.line(&format!("beyond: {next:.0$}", self.style.precision()))
            }
            _ => Ok(()),
        }
    }

    /// Prints the soft fingertips that slide or open completely at the load at which equilibrium is lost. At this load all of their closed points
    /// slide or have their force on the boundary of the friction cone.
    fn on_their_edge(&mut self, loss: &Loss<3>, state: &Equilibrium<3>) -> io::Result<()> {
        let is_closed = |contact: &&ContactAnswer<3>| contact.state != ContactState::Separated;
        let slides = |contact: &ContactAnswer<3>| {
            matches!(contact.state, ContactState::Sliding { .. }) || loss.contacts.contains(&contact.contact)
        };
        let pads = state.pads.iter().filter(|_| !self.style.points);
        let those = pads.filter(|pad| {
            let mut closed = state.contacts[pad.range()].iter().filter(is_closed).peekable();
            closed.peek().is_some() && closed.all(slides)
        });
        let size = |force: &[f64]| force.iter().fold(0.0, |h: f64, x| h.hypot(*x));
        // A soft fingertip that carries less than this force, N, is said to open; otherwise it is said to slide everywhere.
        let weightless = 1e-9 * state.largest_force();
        let does = |pad: &PadAnswer<3>| {
            let presses = size(&pad.wrench.components()[..3]) > weightless;
            format!("{} {}", pad.contact.text(), if presses { "slides everywhere" } else { "opens" })
        };
        those.map(does).collect::<Vec<_>>().iter().try_for_each(|what| self.line(what))
    }
}
