//! The weight that the scene's gravity gives to the bodies. In a question the gravity may turn, as if object and grasp were tilted together. A setup
//! is a grasp with its questions; the base load acts before the load of a question.

use std::borrow::Cow;

use nalgebra::SVector;

use super::question::Question;
use super::setup::Setup;
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::load_path::Turn;
use crate::need::Quantity;
use crate::numerics::{Each, summed};
use crate::words::LinkKind;

impl Setup<3> {
    /// The total mass of all bodies on which the scene's gravity acts, kg, and their common centre of mass, m; `None` without a mass or without
    /// gravity.
    ///
    /// ```
    /// use grasp_lcp::scene::Scene;
    ///
    /// // A box on a tray, μ = 0.4. The turn of the question has no load, so that gravity itself turns.
    /// let scene: Scene = serde_json::from_str(r#"{
    ///     "format": "grasp-lcp/1",
    ///     "planar": {
    ///         "bodies": [{ "name": "box", "mass": 1, "centre_of_mass": [0, 0.05] }], "gravity": [0, -9.81],
    ///         "contacts": [{ "name": "tray", "on": "box", "point": [0, 0], "normal": [0, 1], "friction": 0.4, "soft": { "pair": { "width": 0.2 } } }],
    ///         "questions": [{ "need": { "quantity": "angle", "turn": {} } }]
    ///     }
    /// }"#)?;
    /// let answers = serde_json::to_value(scene.answers()?)?;
    /// assert!(answers[0]["need"]["says"].as_str().unwrap_or_default().contains("21.8"), "{answers}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn own_mass(&self) -> Option<(f64, [f64; 3])> {
        self.gravity.filter(|gravity| gravity.iter().any(|x| *x != 0.0))?;
        let mass: f64 = summed(&self.bodies, &|body| body.mass);
        let moment = self
            .bodies
            .iter()
            .fold(SVector::<f64, 3>::zeros(), |sum, body| sum + body.centre_of_mass * body.mass);
        (mass > 0.0).then(|| (mass, (moment / mass).into()))
    }

    /// The name of the body on which a load acts. This is the body `named`, or without a name the body on which the loads of questions act. If all
    /// bodies share these loads, it is the first body with a mass. `None` if the body has no mass, or the scene no gravity.
    #[must_use]
    pub fn weighty_body(&self, named: Option<&str>) -> Option<&str> {
        self.own_mass()?;
        let mut bodies = self.bodies.iter();
        let body = match named.or(self.loaded.as_deref()) {
            Some(name) => bodies.find(|body| *body.name == *name),
            None if self.shared_by_mass => bodies.find(|body| body.mass > 0.0),
            None => bodies.next(),
        };
        body.filter(|body| body.mass > 0.0).map(|body| &*body.name)
    }

    /// This setup without gravity, for questions whose loads already contain the weight of the bodies. In the returned setup loads act on all bodies,
    /// on each in proportion to its mass. A link with a given tension, which it has under this weight, gets the pretension that leads to it.
    ///
    /// # Errors
    /// As for [`Self::grasp`], if a link has a given tension.
    pub fn with_gravity_as_load(&self) -> Result<Self, Error> {
        let mut setup = Self { gravity: None, loaded: None, shared_by_mass: true, ..self.clone() };
        if self.has_tensions() {
            let grasp = self.grasp_checked()?;
            let tense = grasp.contacts().iter().filter(|contact| contact.at_rest.is_some());
            let links = setup.links.iter_mut().map(|link| &mut link.link);
            for (link, contact) in links.filter(|link| link.tension.is_some()).zip(tense) {
                let pretension = contact.command[0] * contact.stiffness.series()[0];
                *link = link.clone().pretension(pretension);
                if link.kind() == LinkKind::Cable && pretension < 0.0 {
                    (link.pretension, link.slack) = (0.0, -contact.command[0]);
                }
            }
        }
        Ok(setup)
    }

    /// Whether a link has a given tension.
    fn has_tensions(&self) -> bool {
        self.links.iter().any(|link| link.link.tension.is_some())
    }

    /// The question to ask of the grasp that [`Self::grasp_of`] returns. If the gravity of the scene turns in the question, the weight of the bodies
    /// becomes the turning load. Any other question is returned unchanged.
    ///
    /// # Errors
    /// [`Error::Question`] if gravity should turn but the bodies have no weight. The same error is returned if a base load acts in addition to the
    /// turning gravity and loads are not shared by mass.
    pub fn meant<'q>(&self, question: &'q Question<3>) -> Result<Cow<'q, Question<3>>, Error> {
        Ok(match question {
            Question::OnsetOfTurn(turn) => match self.own_turn(turn)? {
                Some(turn) => Cow::Owned(Question::OnsetOfTurn(turn)),
                None => Cow::Borrowed(question),
            },
            Question::Need(asked) => {
                let own = asked.turn.as_ref().map(|turn| self.own_turn(turn)).transpose()?.flatten();
                let Some(turn) = own else { return Ok(Cow::Borrowed(question)) };
                if asked.base() != Wrench::ZERO && !self.shared_by_mass {
                    let fault = "given, must be left out where gravity turns: what is always there is the `load` of a body";
                    return Err(Error::Question { question: "need", field: "base", fault });
                }
                let mut asked = asked.clone();
                asked.turn = Some(turn);
                Cow::Owned(Question::Need(asked))
            }
            _ => Cow::Borrowed(question),
        })
    }

    /// The turn with the weight of all bodies as its load; `None` if `turn` has a load of its own. An error if `turn` has no load and
    /// the bodies have no weight.
    fn own_turn(&self, turn: &Turn<3>) -> Result<Option<Turn<3>>, Error> {
        let Some(axis) = turn.tilts_bodies_about else { return Ok(None) };
        let (Some(gravity), Some((mass, centre))) = (self.gravity, self.own_mass()) else {
            turn.check_in(self.space)?;
            return Ok(None);
        };
        let weight = Turn::<3>::force_at(gravity * mass, centre, axis)?.reversed();
        let [constant, cosine, sine] =
            weight.parts().each(|part| Wrench::among(self.space, &part.coordinates(self.space)));
        Ok(Some(Turn::new(constant, cosine, sine).up_to(turn.angle())))
    }

    /// The grasp for a question in which the gravity of the scene turns: it has no gravity, since the turning load of the question is the weight.
    /// `None` for any other question.
    pub(super) fn tilted_grasp(&self, question: &Question<3>) -> Result<Option<Grasp<3>>, Error> {
        let turn = match question {
            Question::OnsetOfTurn(turn) => Some(turn),
            Question::Need(asked) => asked.turn.as_ref(),
            _ => None,
        };
        if turn.is_none_or(|turn| turn.tilts_bodies_about.is_none()) {
            return Ok(None);
        }
        if let Question::Need(asked) = question
            && matches!(asked.quantity(), Quantity::Squeeze | Quantity::Force)
            && self.has_tensions()
        {
            // Without gravity the sought amount would scale a pretension, not the tension under the weight.
            let fault = "given, must be left out where the squeeze or a force is sought and a link has a `tension`: say its `pretension`";
            return Err(Error::Question { question: "need", field: "turn", fault });
        }
        self.with_gravity_as_load()?.grasp_checked().map(Some)
    }
}
