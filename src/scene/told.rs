//! Answers that a grasp has given already, as a scene writes them.

use super::equilibrium::{Equilibrium, SolveAnswer};
use super::onset::OnsetAnswer;
use super::setup::Setup;
use super::turn_onset::TurnAnswer;
use crate::equilibrium::{self as state, Outcome};
use crate::error::Error;
use crate::grasp::Grasp;
use crate::load_path as path;

impl<const D: usize, const C: usize> Setup<D, C> {
    /// An answer of this setup's grasp to [`Grasp::solve_with`], as [`Self::answers`] writes it: for whoever asks the grasp, and writes
    /// only what someone wants to read.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Wrench};
    /// use grasp_lcp::scene::{Answer, Question, Setup};
    ///
    /// let jaw = |side: f64| Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(8.0);
    /// let load = Wrench::force([0.0, -4.0]);
    /// let setup = Setup::new([jaw(-1.0).into(), jaw(1.0).into()]).ask(Question::Solve { load });
    /// let grasp = setup.grasp()?;
    /// let told = setup.tell_outcome(&grasp, &grasp.solve(&load)?)?;
    /// assert_eq!(setup.answers()?, [Answer::Solve(told)]);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::points`].
    pub fn tell_outcome<const W: usize>(
        &self,
        grasp: &Grasp<W, C>,
        outcome: &Outcome<W, C>,
    ) -> Result<SolveAnswer<D, C>, Error> {
        Ok(self.places()?.solved(grasp, outcome))
    }

    /// An answer of this setup's grasp to [`Grasp::onset_with`], with the settings of the setup. What comes beyond the onset and the
    /// equilibrium there are found now.
    ///
    /// # Errors
    /// As for [`Self::points`].
    pub fn tell_onset<const W: usize>(
        &self,
        grasp: &Grasp<W, C>,
        onset: &path::Onset<W, C>,
    ) -> Result<OnsetAnswer<D, C>, Error> {
        Ok(self.places()?.onset(grasp, &self.settings, onset))
    }

    /// An answer of this setup's grasp to [`Grasp::onset_of_turn_with`]; otherwise as [`Self::tell_onset`].
    ///
    /// # Errors
    /// As for [`Self::points`].
    pub fn tell_onset_of_turn<const W: usize>(
        &self,
        grasp: &Grasp<W, C>,
        onset: &path::TurnOnset<W, C>,
    ) -> Result<TurnAnswer<D, C>, Error> {
        Ok(self.places()?.onset_of_turn(grasp, &self.settings, onset))
    }

    /// An equilibrium of this setup's grasp, one of [`Grasp::equilibria`] for instance; its accuracy is left out.
    ///
    /// # Errors
    /// As for [`Self::points`].
    pub fn tell_equilibrium<const W: usize>(
        &self,
        state: &state::Equilibrium<W, C>,
    ) -> Result<Equilibrium<D, C>, Error> {
        Ok(self.places()?.equilibrium(state))
    }
}
