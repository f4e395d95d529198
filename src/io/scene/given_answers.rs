//! Converts answers that the caller got from a grasp to the form in which a scene writes answers. A setup is a grasp with its questions. First slip
//! is the event at which the first contact ceases to stick.

use super::labels::SceneNames;
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
    /// The answer of a setup's grasp to [`Grasp::solve`] in the form of [`Self::answers`]. It is for a caller that calls the methods of the grasp
    /// itself, and writes only some of the answers.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Wrench};
    /// use grasp_lcp::scene::{Answer, Question, Setup};
    ///
    /// let jaw = |side: f64| Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(8.0);
    /// let load = Wrench::force([0.0, -4.0]);
    /// let setup = Setup::new([jaw(-1.0).into(), jaw(1.0).into()]).ask(Question::solve(load));
    /// let grasp = setup.grasp()?;
    /// let stated = Setup::tell_outcome(&grasp, &load, &grasp.solve(&load)?)?;
    /// assert_eq!(setup.answers()?, [Answer::Solve(stated)]);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// An [`Error`] if the load is not finite or beyond 1e50.
    pub fn tell_outcome(
        grasp: &Grasp<C>,
        load: &Wrench<C>,
        outcome: &Outcome<C>,
    ) -> Result<SolveAnswer<C>, Error> {
        let (grasp, words) = (inside(grasp), Words::default().in_space(grasp.space()));
        SceneNames(&grasp).solve(&inside(load), inside(outcome).into_owned(), words).map(outside)
    }

    /// The answer of a setup's grasp to [`Grasp::onset`], in the form of a scene's answers. This call computes the equilibrium at first slip and the
    /// behaviour beyond it.
    #[must_use]
    pub fn tell_onset(grasp: &Grasp<C>, onset: &path::Onset<C>) -> OnsetAnswer<C> {
        outside(SceneNames(&inside(grasp)).onset(&inside(onset), |factor| Factor { factor }))
    }

    /// The answer of a setup's grasp to [`Grasp::onset_of_turn`], in the form of a scene's answers. This call computes the equilibrium at first slip
    /// and the behaviour beyond it.
    #[must_use]
    pub fn tell_onset_of_turn(grasp: &Grasp<C>, onset: &path::TurnOnset<C>) -> TurnAnswer<C> {
        outside(SceneNames(&inside(grasp)).onset_of_turn(&inside(onset)))
    }

    /// Converts an equilibrium of a setup's grasp, for example one of [`Grasp::equilibria`], to the form of a scene's answers. The numerical accuracy
    /// of the equilibrium is left out.
    #[must_use]
    pub fn tell_equilibrium(grasp: &Grasp<C>, state: &Equilibrium<C>) -> Equilibrium<C> {
        outside(SceneNames(&inside(grasp)).equilibrium(inside(state).into_owned()))
    }
}
