//! Answers of a grasp in the form in which a scene writes them.

use super::onset::{Factor, OnsetAnswer, TurnAnswer};
use super::setup::Setup;
use super::solved::SolveAnswer;
use crate::ask::Grasp;
use crate::equilibrium::{Equilibrium, Outcome};
use crate::error::Error;
use crate::grasp::{Wrench, inside, outside};
use crate::load_path as path;
use crate::words::Words;

impl<const C: usize> Setup<C> {
    /// The answer of this setup's grasp to [`Grasp::solve`] in the form of [`Self::answers`], for a caller that asks the grasp itself and writes
    /// only some answers.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Wrench};
    /// use grasp_lcp::scene::{Answer, Question, Setup};
    ///
    /// let jaw = |side: f64| Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(8.0);
    /// let load = Wrench::force([0.0, -4.0]);
    /// let setup = Setup::new([jaw(-1.0).into(), jaw(1.0).into()]).ask(Question::solve(load));
    /// let grasp = setup.grasp()?;
    /// let told = setup.tell_outcome(&grasp, &load, &grasp.solve(&load)?)?;
    /// assert_eq!(setup.answers()?, [Answer::Solve(told)]);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::points`] and [`Grasp::hold`].
    pub fn tell_outcome(
        &self,
        grasp: &Grasp<C>,
        load: &Wrench<C>,
        outcome: &Outcome<C>,
    ) -> Result<SolveAnswer<C>, Error> {
        let (setup, words) = (inside(self), Words::default().in_space(self.space));
        setup.labels()?.solve(&inside(grasp), &inside(load), inside(outcome).into_owned(), words).map(outside)
    }

    /// The answer of this setup's grasp to [`Grasp::onset`], with the settings of the setup. The behaviour beyond first slip and the
    /// equilibrium there are computed now.
    ///
    /// # Errors
    /// As for [`Self::points`].
    pub fn tell_onset(&self, grasp: &Grasp<C>, onset: &path::Onset<C>) -> Result<OnsetAnswer<C>, Error> {
        Ok(outside(inside(self).labels()?.onset(&inside(grasp), &inside(onset), |factor| Factor { factor })))
    }

    /// The answer of this setup's grasp to [`Grasp::onset_of_turn`]; otherwise like [`Self::tell_onset`].
    ///
    /// # Errors
    /// As for [`Self::points`].
    pub fn tell_onset_of_turn(
        &self,
        grasp: &Grasp<C>,
        onset: &path::TurnOnset<C>,
    ) -> Result<TurnAnswer<C>, Error> {
        Ok(outside(inside(self).labels()?.onset_of_turn(&inside(grasp), &inside(onset))))
    }

    /// An equilibrium of this setup's grasp in the form of [`Self::answers`], such as one of [`Grasp::equilibria`]. Its accuracy is left out.
    ///
    /// # Errors
    /// As for [`Self::points`].
    pub fn tell_equilibrium(&self, state: &Equilibrium<C>) -> Result<Equilibrium<C>, Error> {
        Ok(outside(inside(self).labels()?.equilibrium(inside(state).into_owned())))
    }
}
