//! The class `Grasp` of the native module.

use std::sync::Arc;

use grasp_lcp::Settings;
use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::{Ramp, Turn};
use grasp_lcp::scene::{Answer, Question, Scene, Setup};
use grasp_lcp::touch::Part;
use numpy::PyReadonlyArray2;
use numpy::ndarray::ArrayView1;
use pyo3::prelude::*;
use pyo3::types::PyMapping;
use serde::de::DeserializeOwned;

use crate::answers::{Reply, UnwrittenAnswer, json};
use crate::columns::{Columns, GivenColumns};
use crate::errors::{of_json, refused, wrong};
use crate::loads::{mapping_text, wrench};
use crate::pictures::PythonPicture;
use crate::quality::Quality;
use crate::stored_grasp::StoredGrasp;
use crate::watch::{Watch, Watchable};

/// Points of all contacts, and edges of the grasped part's mesh, m.
pub(crate) type Places = (Vec<Vec<f64>>, Vec<[[f64; 3]; 2]>);

/// The questions that Python asks of a grasp, in the plane or in space.
pub(crate) trait HeldGrasp: Send + Sync {
    fn json(&self) -> PyResult<String>;
    fn axes(&self) -> usize;
    fn contacts(&self) -> usize;
    fn solve(self: Arc<Self>, load: &Bound<'_, PyAny>) -> PyResult<Reply>;
    fn onset(self: Arc<Self>, ramp: &AskedRamp<'_, '_>) -> PyResult<Reply>;
    fn turn(self: Arc<Self>, turn: &str) -> PyResult<Reply>;
    fn ask(&self, py: Python<'_>, question: &str) -> PyResult<String>;
    fn equilibria(&self, py: Python<'_>, load: &Bound<'_, PyAny>) -> PyResult<String>;
    fn watch(&self) -> PyResult<Watch>;
    fn warnings(&self, question: Option<&str>) -> PyResult<Vec<String>>;
    /// Mass, kg, and centre of mass, m, of the scene's part; `None` for a quantity that is not known.
    fn part(&self) -> (Option<f64>, Option<[f64; 3]>);
    /// Points of all contacts, and edges of the grasped part's mesh, m.
    fn places(&self) -> PyResult<Places>;
    /// The grasp as SVG or HTML page, in the equilibrium `state` (JSON), or without `state` in the equilibrium under no load. `None` for hands,
    /// several bodies, and pages in the plane.
    fn drawn(&self, state: Option<&str>, title: &str, page: bool) -> PyResult<Option<String>>;
}

/// Direction, base load and changes of commands for the load at first slip, as Python passes them.
pub(crate) struct AskedRamp<'a, 'py> {
    direction: &'a Bound<'py, PyAny>,
    base: Option<&'a Bound<'py, PyAny>>,
    command_change: Option<&'a PyReadonlyArray2<'py, f64>>,
    joint_change: Option<Vec<f64>>,
}

impl<const C: usize> StoredGrasp<C> {
    /// Reads a load. For several bodies, a mapping may omit the masses, centres of mass and gravity that the scene adds.
    fn load(&self, argument: &str, given: &Bound<'_, PyAny>) -> PyResult<Wrench<C>> {
        if self.setup.bodies.is_empty() || given.cast::<PyMapping>().is_err() {
            return wrench(argument, given);
        }
        read_for(&self.setup, &mapping_text(argument, given)?, argument)
    }

    fn ramp(&self, asked: &AskedRamp<'_, '_>) -> PyResult<Ramp<C>> {
        let base = asked.base.map_or(Ok(Wrench::ZERO), |base| self.load("base", base))?;
        let mut ramp = Ramp::load(base, self.load("direction", asked.direction)?);
        if let Some(change) = asked.command_change {
            let change = change.as_array();
            if change.ncols() != C {
                let given = change.ncols();
                return Err(wrong(format_args!("command_change: rows of {given} given, must be of {C}")));
            }
            let row = |i: usize| -> [f64; C] { std::array::from_fn(|k| change[[i, k]]) };
            ramp = ramp.with_commands((0..change.nrows()).map(row));
        }
        Ok(match &asked.joint_change {
            Some(change) => ramp.with_joint_commands(change.iter().copied()),
            None => ramp,
        })
    }
}

/// Reads a question or a load from JSON, with the masses, centres of mass and gravity that the scene adds. Refuses one that contains the weight of
/// bodies a second time.
fn read_for<T: DeserializeOwned, const C: usize>(setup: &Setup<C>, text: &str, path: &str) -> PyResult<T> {
    // Text that is not JSON passes, since the parser refuses it below.
    let value = serde_json::from_str(text).unwrap_or_default();
    setup.refuse_weight_twice(&value, path).map_err(wrong)?;
    let completed = setup.completed(&value).map(|value| value.to_string());
    serde_json::from_str(completed.as_deref().unwrap_or(text)).map_err(|error| of_json(path, &error))
}

/// Asks one question by means of a scene, which supports joints and several bodies. Returns the answer in JSON.
fn asked<const C: usize>(setup: &Setup<C>, question: Question<C>) -> PyResult<String> {
    let answers = setup.clone().ask(question).answers().map_err(refused)?;
    match answers.into_iter().next() {
        Some(Answer::Hold(answer)) => json(&answer),
        Some(Answer::Need(answer)) => json(&answer),
        Some(Answer::Improve(answer)) => json(&answer),
        Some(Answer::Solve(answer)) => json(&answer),
        Some(Answer::Compare(answer)) => json(&answer),
        Some(Answer::Onset(answer)) => json(&answer),
        Some(Answer::OnsetOfTurn(answer)) => json(&answer),
        Some(Answer::Follow(answer)) => json(&answer),
        Some(Answer::Shake(answer)) => json(&answer),
        Some(Answer::Shakedown(answer)) => json(&answer),
        Some(Answer::Identify(answer)) => json(&answer),
        _ => Err(wrong("question: is of a kind that is not answered here")),
    }
}

impl<const C: usize> HeldGrasp for StoredGrasp<C>
where
    Contact<C>: Watchable,
    Wrench<C>: DeserializeOwned,
    Self: PythonPicture<C>,
{
    fn drawn(&self, state: Option<&str>, title: &str, page: bool) -> PyResult<Option<String>> {
        let Some(grasp) = &self.grasp else { return Ok(None) };
        let state = if let Some(text) = state {
            Some(serde_json::from_str::<Equilibrium<C>>(text).map_err(|error| of_json("state", &error))?)
        } else {
            let rest = grasp.with(&self.setup.settings).solve(Wrench::ZERO).map_err(refused)?;
            rest.equilibrium().cloned()
        };
        let Some(state) = state else { return Ok(None) };
        if page { self.page(&state, title) } else { self.svg(&state, title).map(Some) }
    }

    fn json(&self) -> PyResult<String> {
        json(&Scene::from(self.setup.clone()))
    }

    fn axes(&self) -> usize {
        C
    }

    fn contacts(&self) -> usize {
        self.setup.entries().count()
    }

    fn solve(self: Arc<Self>, load: &Bound<'_, PyAny>) -> PyResult<Reply> {
        let load = self.load("load", load)?;
        let Some(grasp) = &self.grasp else {
            return asked(&self.setup, Question::solve(load)).map(Reply::Written);
        };
        let outcome = grasp.with(&self.setup.settings).solve(load).map_err(refused)?;
        Ok(Reply::told(self, UnwrittenAnswer::Solved(outcome, load)))
    }

    fn onset(self: Arc<Self>, ramp: &AskedRamp<'_, '_>) -> PyResult<Reply> {
        let ramp = self.ramp(ramp)?;
        let question = Question::onset(ramp.clone());
        let Some(grasp) = &self.grasp else { return asked(&self.setup, question).map(Reply::Written) };
        self.setup.check(&question).map_err(refused)?;
        let onset = grasp.with(&self.setup.settings).onset(&ramp).map_err(refused)?;
        Ok(Reply::told(self, UnwrittenAnswer::Onset(onset)))
    }

    fn turn(self: Arc<Self>, turn: &str) -> PyResult<Reply> {
        let turn: Turn<C> = read_for(&self.setup, turn, "turn")?;
        let Some(grasp) = &self.grasp else {
            return asked(&self.setup, Question::OnsetOfTurn(turn)).map(Reply::Written);
        };
        let onset = grasp.with(&self.setup.settings).onset_of_turn(turn).map_err(refused)?;
        Ok(Reply::told(self, UnwrittenAnswer::Turn(onset)))
    }

    fn ask(&self, py: Python<'_>, question: &str) -> PyResult<String> {
        let question = read_for(&self.setup, question, "question")?;
        py.detach(|| asked(&self.setup, question))
    }

    fn equilibria(&self, py: Python<'_>, load: &Bound<'_, PyAny>) -> PyResult<String> {
        let load = wrench("load", load)?;
        let grasp = self.without_joints("equilibria").map_err(refused)?;
        let all = py.detach(|| grasp.with(&self.setup.settings).equilibria(load)).map_err(refused)?;
        json(&all.iter().map(|state| Setup::tell_equilibrium(grasp, state)).collect::<Vec<_>>())
    }

    fn warnings(&self, question: Option<&str>) -> PyResult<Vec<String>> {
        let mut setup = self.setup.clone();
        if let Some(question) = question {
            let question = read_for(&setup, question, "question")?;
            setup = setup.ask(question);
        }
        Ok(setup.warnings().map_err(refused)?.iter().map(ToString::to_string).collect())
    }

    fn part(&self) -> (Option<f64>, Option<[f64; 3]>) {
        let part = self.setup.part_read();
        (part.and_then(Part::mass), part.and_then(Part::centre_of_mass))
    }

    fn places(&self) -> PyResult<Places> {
        let made = self.setup.grasp().map_err(refused)?;
        let points = made.contacts().iter().map(|contact| contact.point().as_slice().to_vec()).collect();
        Ok((points, self.setup.part_read().map_or_else(Vec::new, |part| part.edges(0.5))))
    }

    fn watch(&self) -> PyResult<Watch> {
        Contact::watch(self.without_joints("watch").map_err(refused)?.contacts())
    }
}

/// A grasp that is described by contacts, or by a hand with joints; see `grasp_lcp.Grasp`.
#[pyclass(frozen, module = "grasp_lcp._grasp_lcp")]
pub(crate) struct Grasp {
    held: Arc<dyn AnyQuestion>,
}

/// Questions about equilibria, and questions about closure, load limits and squeeze.
pub(crate) trait AnyQuestion: HeldGrasp + Quality {}
impl<T: HeldGrasp + Quality> AnyQuestion for T {}

#[pymethods]
impl Grasp {
    /// A grasp from its contacts: the first row of the arrays of contact data.
    #[staticmethod]
    fn of_columns(
        columns: GivenColumns<'_>,
        names: Vec<Option<String>>,
        outline: Option<PyReadonlyArray2<'_, f64>>,
        settings: Option<&str>,
    ) -> PyResult<Self> {
        let settings = settings.map_or(Ok(Settings::default()), serde_json::from_str);
        let settings = settings.map_err(|error| of_json("settings", &error))?;
        let beside = GraspOptions { names, outline, settings };
        let columns = columns.view();
        Ok(Self {
            held: if columns.axes() == 2 { beside.planar(&columns)? } else { beside.spatial(&columns)? },
        })
    }

    /// The grasp of a scene, whose questions are ignored. If the package itself has `made` the text, errors have no line and column.
    #[staticmethod]
    #[pyo3(signature = (text, made=false))]
    fn of_json(text: &str, made: bool) -> PyResult<Self> {
        let scene = read(text, made)?.with_files_from("").map_err(refused)?;
        Ok(Self {
            held: match scene.planar() {
                Some(setup) => StoredGrasp::new(alone(setup)).map_err(refused)?,
                None => StoredGrasp::new(alone(scene.setup)).map_err(refused)?,
            },
        })
    }

    fn json(&self) -> PyResult<String> {
        self.held.json()
    }

    #[getter]
    fn axes(&self) -> usize {
        self.held.axes()
    }

    #[getter]
    fn contacts(&self) -> usize {
        self.held.contacts()
    }

    fn part(&self) -> (Option<f64>, Option<[f64; 3]>) {
        self.held.part()
    }

    fn places(&self) -> PyResult<Places> {
        self.held.places()
    }

    fn solve(&self, load: &Bound<'_, PyAny>) -> PyResult<Reply> {
        Arc::clone(&self.held).solve(load)
    }

    #[pyo3(signature = (direction, base=None, command_change=None, joint_change=None))]
    fn onset<'py>(
        &self,
        direction: &Bound<'py, PyAny>,
        base: Option<&Bound<'py, PyAny>>,
        command_change: Option<PyReadonlyArray2<'py, f64>>,
        joint_change: Option<Vec<f64>>,
    ) -> PyResult<Reply> {
        let command_change = command_change.as_ref();
        Arc::clone(&self.held).onset(&AskedRamp { direction, base, command_change, joint_change })
    }

    fn turn(&self, turn: &str) -> PyResult<Reply> {
        Arc::clone(&self.held).turn(turn)
    }

    fn ask(&self, py: Python<'_>, question: &str) -> PyResult<String> {
        self.held.ask(py, question)
    }

    fn equilibria(&self, py: Python<'_>, load: &Bound<'_, PyAny>) -> PyResult<String> {
        self.held.equilibria(py, load)
    }

    #[pyo3(signature = (question=None))]
    fn warnings(&self, question: Option<&str>) -> PyResult<Vec<String>> {
        self.held.warnings(question)
    }

    fn watch(&self) -> PyResult<Watch> {
        self.held.watch()
    }

    fn drawn(&self, state: Option<&str>, title: &str, page: bool) -> PyResult<Option<String>> {
        self.held.drawn(state, title, page)
    }

    fn closure(&self, friction: bool) -> PyResult<String> {
        self.held.closure(friction)
    }

    fn ball(&self, py: Python<'_>, budget: f64, each: bool) -> PyResult<String> {
        self.held.ball(py, budget, each)
    }

    fn load_limit(
        &self,
        direction: &Bound<'_, PyAny>,
        base: Option<&Bound<'_, PyAny>>,
        budget: f64,
        each: bool,
    ) -> PyResult<String> {
        self.held.load_limit(direction, base, budget, each)
    }

    fn least_squeeze(&self, loads: PyReadonlyArray2<'_, f64>) -> PyResult<String> {
        self.held.least_squeeze_of_loads(loads)
    }

    fn least_squeeze_of_turn(&self, turn: &str) -> PyResult<String> {
        self.held.least_squeeze_of_turn(turn)
    }

    fn least_squeeze_of_any_force(
        &self,
        size: f64,
        base: Option<&Bound<'_, PyAny>>,
        at: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<String> {
        self.held.least_squeeze_of_any_force(size, base, at)
    }

    fn weakest_direction(
        &self,
        base: Option<&Bound<'_, PyAny>>,
        at: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<String> {
        self.held.weakest_direction(base, at)
    }
}

/// The setup without its questions.
fn alone<const C: usize>(mut setup: Setup<C>) -> Setup<C> {
    setup.questions.clear();
    setup
}

/// Reads a scene. If the package itself has `made` the text, errors have no line and column.
fn read(text: &str, made: bool) -> PyResult<Scene> {
    Scene::from_json(text.as_bytes()).map_err(|mut fault| {
        fault.at = fault.at.filter(|_| !made);
        wrong(fault)
    })
}

/// The answers to all questions of a scene, in JSON.
#[pyfunction]
pub(crate) fn answers_of_scene(py: Python<'_>, text: &str, made: bool) -> PyResult<String> {
    let scene = read(text, made)?.with_files_from("").map_err(refused)?;
    json(&py.detach(|| scene.answers()).map_err(refused)?)
}

/// Probable mistakes in a scene and in its questions, one sentence each.
#[pyfunction]
pub(crate) fn warnings_of_scene(text: &str, made: bool) -> PyResult<Vec<String>> {
    let scene = read(text, made)?.with_files_from("").map_err(refused)?;
    let mut found = scene.warnings().map_err(refused)?;
    found.extend(scene.far_load_in(text.as_bytes()));
    Ok(found.iter().map(ToString::to_string).collect())
}

/// Data of a grasp besides its contacts: names, outline of the object, and settings.
struct GraspOptions<'py> {
    names: Vec<Option<String>>,
    outline: Option<PyReadonlyArray2<'py, f64>>,
    settings: Settings,
}

impl GraspOptions<'_> {
    fn planar(&self, columns: &Columns<'_>) -> PyResult<Arc<dyn AnyQuestion>> {
        Ok(StoredGrasp::<2>::new(self.setup(columns)).map_err(refused)?)
    }

    fn spatial(&self, columns: &Columns<'_>) -> PyResult<Arc<dyn AnyQuestion>> {
        Ok(StoredGrasp::<3>::new(self.setup(columns)).map_err(refused)?)
    }

    fn setup<const C: usize>(&self, columns: &Columns<'_>) -> Setup<C> {
        let contact = |i: usize| {
            let contact = columns.contact::<C>(0, i);
            match self.names.get(i) {
                Some(Some(name)) => contact.name(name),
                _ => contact,
            }
        };
        let contacts = (0..columns.contacts()).map(contact);
        let mut setup = Setup::new(contacts.map(Into::into)).with_settings(self.settings);
        if let Some(outline) = &self.outline {
            let corners = outline.as_array();
            let corner = |row: ArrayView1<'_, f64>| std::array::from_fn::<f64, C, _>(|k| row[k]).into();
            setup.outline = corners.rows().into_iter().map(corner).collect();
        }
        setup
    }
}
