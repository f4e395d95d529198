//! Makes a scene in which a gripper with two jaws holds a part that is given by a mesh.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;
use grasp_lcp::scene::Scene;
use grasp_lcp::touch::{Part, Unit};
use serde_json::json;

use crate::arguments::{Command, Numbers, SceneArguments};
use crate::asking;
use crate::failure::Failure;
use crate::loads::OptionVectors;
use crate::numbers::{kilograms, newtons};

/// The part and the jaws of `new grip`.
#[derive(Debug, Args)]
pub(crate) struct Grip {
    /// Of a grip: the mesh of the part, an STL or OBJ. Save the scene in the folder to which the path of the mesh is relative.
    mesh: Option<PathBuf>,
    /// Of a grip: sides of the jaws, such as 20x30mm; the first along the coordinate axis that is most nearly perpendicular to the closing direction.
    #[arg(long, value_name = "AxB")]
    jaws: Option<Lengths>,
    /// Of a grip: the direction in which the first jaw closes; the second closes against it.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y,Z", default_value = "1,0,0")]
    closing: Numbers,
    /// Of a grip: the force with which each jaw closes on the part, N; the closed jaw then stays where it is.
    #[arg(long, allow_hyphen_values = true, value_parser = newtons, value_name = "N")]
    force: Option<f64>,
    /// Of a grip: the point between the jaws, such as 3,25,15mm; the centre of mass if left out.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y,Z")]
    at: Option<Lengths>,
    /// Of a grip: the distance of the open jaws, such as 80mm; if left out, the jaws start outside of the part.
    #[arg(long, value_name = "LENGTH")]
    opening: Option<Lengths>,
    /// Of a grip: the coefficient of friction.
    #[arg(long, value_name = "MU", default_value_t = 0.5)]
    friction: f64,
    /// Of a grip: the unit of the mesh: m, cm, mm or in.
    #[arg(long, default_value = "mm")]
    unit: String,
    /// Of a grip: the mass of the part, kg; if left out, the part is of steel, 7850 kg/m³.
    #[arg(long, value_parser = kilograms, value_name = "KG")]
    mass: Option<f64>,
    /// Of a grip: answers the scene in place of writing it.
    #[arg(long)]
    ask: bool,
}

/// Lengths with a unit, such as 20x30mm or 3,25,15mm; in m if no unit is given.
#[derive(Debug, Clone)]
struct Lengths(Vec<f64>);

impl std::str::FromStr for Lengths {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let allowed =
            || format!("`{text}` is no length; write numbers and their unit, such as 20x30mm or 3,25,15mm");
        let digits = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        let unit = if digits.len() == text.len() { "m" } else { &text[digits.len()..] };
        let unit = Unit::of(unit).ok_or_else(allowed)?;
        let metres =
            |part: &str| part.trim().parse().map(|length| unit.in_metres(length)).map_err(|_| allowed());
        digits.split(['x', ',']).map(metres).collect::<Result<_, _>>().map(Self)
    }
}

impl Lengths {
    fn array<const N: usize>(&self, option: &str) -> Result<[f64; N], Failure> {
        let message = || Failure::Usage(format!("--{option}: {} given, must be {N}", self.0.len()));
        self.0.as_slice().try_into().map_err(|_| message())
    }
}

/// Density of steel, kg/m³, which is assumed by default. Most parts are lighter, so that the jaws usually have to hold less weight than is assumed.
const STEEL: f64 = 7850.0;
/// Distance, m, from the bounding box of the part at which a jaw starts, if `--opening` is left out. The jaw is then outside of the part before it
/// closes.
const AWAY: f64 = 0.005;

impl Grip {
    /// Writes the scene, or answers it.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let (text, scene) = self.scene()?;
        if !self.ask {
            io::stdout().write_all(text.as_bytes())?;
            return Ok(ExitCode::SUCCESS);
        }
        let of = self.mesh.clone().unwrap_or_default();
        let ask =
            SceneArguments { scene: of, json: false, points: false, digits: 6, unit: None, progress: false };
        asking::ask_of(scene, &ask, Command::Ask(ask.clone()))
    }

    /// The scene of two jaws that close on the part, with the question whether they hold its weight. Returned as text, and as a value with its mesh.
    fn scene(&self) -> Result<(String, Scene), Failure> {
        let missing = |what: &str| {
            Failure::Usage(format!("{what}: grasp-lcp new grip part.stl --jaws 20x30mm --force 40"))
        };
        let path = self.mesh.as_ref().ok_or_else(|| missing("say the mesh"))?;
        let sides: [f64; 2] = self.jaws.as_ref().ok_or_else(|| missing("say the jaws"))?.array("jaws")?;
        let force = self.force.ok_or_else(|| missing("say the force"))?;
        let unit = Unit::of(&self.unit)
            .ok_or_else(|| Failure::Usage(format!("--unit: {} given, must be m, cm, mm or in", self.unit)))?;
        let part = Part::read(path, unit)?;
        let part =
            self.mass.map_or_else(|| part.clone().of_density(STEEL), |mass| part.clone().of_mass(mass))?;
        let centre = part.centre_of_mass();
        let at = match &self.at {
            Some(at) => at.array("at")?,
            None => centre.ok_or_else(|| {
                Failure::Usage("--at: must be given, for the mesh is not closed".to_owned())
            })?,
        };
        let closing = OptionVectors::in_space(3).direction(&self.closing, "closing")?;
        let opening = self.opening.as_ref().map(|opening| opening.array::<1>("opening")).transpose()?;
        let path = serde_json::to_string(&path.to_string_lossy()).map_err(std::io::Error::from)?;
        let jaw = |name: &str, sign: f64| {
            let closing = closing.map(|x| sign * x + 0.0);
            let from = start(&part, at, closing, opening.map(|[opening]| opening));
            format!(
                r#"{{ "name": "{name}", "friction": {}, "pressed_with": {force}, "touches": {{
        "rectangle": {}, "from": {}, "closing": {}, "layer": {{ "modulus": 2e6, "thickness": 0.003 }} }} }}"#,
                self.friction,
                json!(sides),
                json!(from),
                json!(closing)
            )
        };
        let (first, second) = (jaw("first", 1.0), jaw("second", -1.0));
        let (of_part, steel) = match self.mass {
            Some(mass) => (format!(r#""mass": {mass}"#), ""),
            None => (format!(r#""density": {STEEL}"#), ", and the part is of steel"),
        };
        let (unit, mass) = (&self.unit, rounded(part.mass().unwrap_or_default()));
        let centre = json!(centre.unwrap_or(at).map(rounded));
        let text = format!(
            r#"{{
  "format": "grasp-lcp/1",
  "comment": "The pads are of rubber, 2 MPa and 3 mm thick, down is along -z{steel}.",
  "spatial": {{
    "part": {{ "mesh": {path}, "unit": "{unit}", {of_part} }},
    "contacts": [
      {first},
      {second}
    ],
    "questions": [
      {{ "hold": {{ "load": {{ "mass": {mass}, "at": {centre} }} }} }}
    ]
  }}
}}
"#
        );
        // The text is read back: a fault for which scenes are refused is thus reported now, and not only when the scene is used.
        let mut scene =
            Scene::from_json(text.as_bytes()).map_err(|fault| Failure::Scene(fault.to_string()))?;
        scene.setup = scene.setup.on_part(Arc::new(part));
        scene.setup.grasp()?;
        Ok((text, scene))
    }
}

/// The middle of a jaw before it closes towards `at`, m: half of `opening` away from `at`; without `opening`, outside of the bounding box of the
/// part.
fn start(part: &Part, at: [f64; 3], closing: [f64; 3], opening: Option<f64>) -> [f64; 3] {
    let length = closing.iter().map(|x| x * x).sum::<f64>().sqrt();
    let way = closing.map(|x| x / length);
    let [low, high] = part.bounds();
    let mut nearest = 0.0;
    for a in 0..3 {
        nearest += ((low[a] - at[a]) * way[a]).min((high[a] - at[a]) * way[a]);
    }
    let back = opening.map_or(nearest.min(0.0) - AWAY, |opening| -0.5 * opening);
    std::array::from_fn(|a| rounded(at[a] + back * way[a]))
}

/// Rounds a length, m, to 0.1 µm, or a mass, kg, to 0.1 mg, so that the numbers of the scene file are short.
fn rounded(x: f64) -> f64 {
    (x * 1e7).round() / 1e7 + 0.0
}
