//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
#[cfg(feature = "cli-full")]
use clap_complete::Shell;
use grasp_lcp::words::Unit;

use crate::identifies::Identifies;
pub(crate) use crate::load_arguments::LoadArguments;
use crate::map::DataDeviations;
use crate::new::{FIELDS_HELP, Template};
pub(crate) use crate::numbers::Numbers;
use crate::numbers::{count, kilograms, newtons, percent, times, unit};
use crate::shakes::Shakes;

/// Does the grasp hold? At which load does a contact start to slide, and what comes after?
///
/// A scene is a JSON file with contacts (points, normals, stiffness, friction, clamping force) and questions; `new` writes one to begin with, and
/// `help scene` lists all fields. Lengths are in m, or in the unit that the scene or `--unit` says; forces in N, angles in degrees.
#[derive(Debug, Parser)]
#[command(name = "grasp-lcp", version, max_term_width = 100, after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// The page of all fields of a scene. A test generates it from the JSON Schema.
pub(crate) const FIELDS: &str = include_str!("../../../examples/scenes/FIELDS.md");

const EXAMPLES: &str = include_str!("examples.txt");

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Writes an example scene as a starting point.
    ///
    /// The scene goes to standard output and contains questions, so that `ask` answers it at once.
    #[command(arg_required_else_help = true, after_long_help = FIELDS_HELP)]
    New {
        /// The kind of grasp.
        #[arg(value_enum)]
        of: Template,
        #[cfg(feature = "mesh")]
        #[command(flatten)]
        grip: crate::grip::Grip,
    },
    /// Typical coefficients of friction and stiffnesses, with their sources.
    Values,
    /// All fields of a scene, with their meaning and units; so does `help scene`.
    #[command(after_long_help = FIELDS)]
    Scene,
    /// Answers every question of a scene.
    Ask(SceneArguments),
    /// Does the grasp hold the load? The load grows from zero while the base load stays constant; the answer is a sentence.
    ///
    /// Without a load on the command line, the scene's own questions `hold` are answered. If the scene has none, the answer is whether the grasp
    /// holds the load of the scene's question `need`, or else whether it is in equilibrium without a load.
    Hold {
        #[command(flatten)]
        load: LoadArguments,
        /// A constant force, N, that acts before the load and then together with it, at the same point (--at).
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        base: Option<Numbers>,
        /// Factor on the load; the base load stays as it is.
        #[arg(long, allow_hyphen_values = true, value_parser = times, value_name = "TIMES")]
        safety: Option<f64>,
        /// Says whether the answer changes by more than 5 % if all contacts are a tenth or ten times as stiff along their tangents, or one is ten
        /// times as stiff. The question is then answered once for each contact, and three more times.
        #[arg(long)]
        vary_stiffness: bool,
        #[command(flatten)]
        ask: SceneArguments,
    },
    /// How much clamping force, friction, load, lever arm or tilt angle does the grasp need, or allow?
    ///
    /// Without a load on the command line, the loads of the scene's questions are taken.
    Need {
        #[command(flatten)]
        ask: SceneArguments,
        #[command(flatten)]
        need_arguments: NeedArguments,
    },
    /// Where should the fingers be, and how hard should they press, so that the first slip comes as late as possible, or most friction is left?
    ///
    /// Only contacts with a `surface` in the scene may move. The answer names the conditions and limits that prevent further improvement,
    /// and `draw` shows the grasp before and after.
    Improve {
        #[command(flatten)]
        load: LoadArguments,
        /// A constant force, N, that acts before the load and then together with it, at the same point (--at).
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        base: Option<Numbers>,
        /// A force of any direction in addition to the load, N; a load factor of 1 means a force of this magnitude.
        #[arg(long, allow_hyphen_values = true, value_parser = newtons, value_name = "N")]
        any_force: Option<f64>,
        /// Contacts may press with up to this force, N; if left out, the finger commands of the scene do not change.
        #[arg(long, allow_hyphen_values = true, value_parser = newtons, value_name = "N")]
        at_most: Option<f64>,
        /// Maximises the friction reserve under the full load, instead of the load at first slip.
        #[arg(long)]
        reserve: bool,
        #[command(flatten)]
        ask: SceneArguments,
    },
    /// How does the object move under a load, and which forces do the contacts carry?
    Solve {
        #[command(flatten)]
        load: LoadArguments,
        #[command(flatten)]
        ask: SceneArguments,
    },
    /// Is the equilibrium also the minimum of energy that a quadratic program finds, and up to which multiple of the load?
    Compare {
        #[command(flatten)]
        load: LoadArguments,
        /// A constant force, N, that acts before the load and then together with it, at the same point (--at).
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        base: Option<Numbers>,
        #[command(flatten)]
        ask: SceneArguments,
    },
    /// At which load does the first contact start to slide?
    ///
    /// The load grows from zero in proportion to a force and a moment; the answer is the load factor at first slip.
    Onset {
        #[command(flatten)]
        load: LoadArguments,
        #[command(flatten)]
        ask: SceneArguments,
    },
    /// At which angle does the first contact start to slide while a weight is tilted?
    ///
    /// Without --mass and --weight, the scene's bodies with masses are tilted under its gravity.
    Turn {
        /// The mass of the object, kg, with the scene's gravity, or 9.81 m/s² down along the last axis.
        #[arg(long, allow_hyphen_values = true, value_parser = kilograms, value_name = "KG", conflicts_with = "weight")]
        mass: Option<f64>,
        /// The weight, N, instead of the mass: components separated by commas.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        weight: Option<Numbers>,
        /// The centre of mass, m; the origin if left out.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        at: Option<Numbers>,
        /// A constant force, N, at the centre of mass, which does not turn while the weight does.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        base: Option<Numbers>,
        /// The axis about which the grasp is tilted, by the right-hand rule; in the plane 0,0,1 (anticlockwise, also if left out) or 0,0,-1.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y,Z")]
        axis: Option<Numbers>,
        #[command(flatten)]
        ask: SceneArguments,
    },
    /// Which events occur while the load goes from one force to the next?
    Follow {
        /// The force at the end of a leg, N; give one for each leg.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        to: Vec<Numbers>,
        /// The force at the start, N; none if left out.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        from: Option<Numbers>,
        /// The point where the forces act, m; the origin if left out.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        at: Option<Numbers>,
        #[command(flatten)]
        ask: SceneArguments,
    },
    /// Does the grasp survive a repeated load, or does the object walk out?
    ///
    /// Each force is applied and removed in turn, cycle after cycle, while the constant load acts. The answer holds for any number of cycles.
    Shake {
        #[command(flatten)]
        shakes: Shakes,
        #[command(flatten)]
        ask: SceneArguments,
    },
    /// Identifies friction, support loads, clamping force or stiffness from observed slips.
    ///
    /// Each row of the table is one observation of slip. Columns of the load under which the object slid: fx, fy, fz (N), mx, my, mz (N m; in the
    /// plane one column m), and at_x, at_y, at_z (m), the point of the force. Columns base_x, base_y, base_z (N) are the force that acted before, a
    /// weight for instance, at the origin as in --base. Further columns: squeeze (factor on the clamping forces of the scene), slip (first or gross),
    /// scatter_percent (standard deviation of the load, percent), and group, a name or number that is the same for observations that may share an
    /// error. Every estimate comes with its standard error; quantities that the observations do not determine are named.
    Identify {
        #[command(flatten)]
        ask: SceneArguments,
        #[command(flatten)]
        slips: Identifies,
    },
    /// Maps the force that the grasp holds in every direction, and finds the weakest direction: a table and pictures.
    ///
    /// Friction, stiffness and clamping force of every contact may be uncertain. Beside the force at first slip, the table then has a smaller force
    /// that keeps the given number of standard deviations in reserve.
    Map {
        /// The scene; `-` for standard input.
        scene: PathBuf,
        /// The point where the force acts, m; the origin if left out.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        at: Option<Numbers>,
        /// A constant force, N, at the same point (--at), instead of the load at rest of the scene's questions.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        base: Option<Numbers>,
        /// The unit of the point `--at`: m, cm, mm or in; the scene's field `unit` if left out.
        #[arg(long, value_parser = unit, value_name = "UNIT")]
        unit: Option<Unit>,
        #[command(flatten)]
        data_deviations: DataDeviations,
        /// Prints the map as one JSON object, and draws nothing.
        #[arg(long)]
        json: bool,
        /// Prints the progress of the map every second on standard error, where no terminal shows a progress bar.
        #[arg(long)]
        progress: bool,
        #[command(flatten)]
        output: Output,
    },
    /// Draws every question as SVG; for a spatial grasp also a page with all answers, to turn with the mouse.
    ///
    /// The first picture has the name of the scene, later ones also the number of the question. A file that ends in `_friction` shows the fraction of
    /// its friction limit that each contact uses while the load grows, turns or follows a program. A file that ends in `_cycles` shows the slips
    /// under a repeated load.
    Draw {
        /// The scene; `-` for standard input.
        scene: PathBuf,
        #[command(flatten)]
        output: Output,
    },
    /// Answers scenes in JSON, one a line, on all cores, in order.
    ///
    /// Every line of standard input is a scene. Every line of standard output is its answer, with the number of the line and the scene's `id`, or
    /// a hash of the line. A line that cannot be answered gives an error in its place; later lines are still answered.
    Stream {
        /// Number of worker threads; the output does not depend on it. All cores if left out.
        #[arg(long, value_parser = clap::value_parser!(u16).range(1..=1024))]
        threads: Option<u16>,
        /// Short answers of about a hundred bytes: outcome, factor and the first contact.
        #[arg(long)]
        brief: bool,
        /// Largest number of contact points of a scene; a scene with more points is refused.
        #[arg(long, allow_hyphen_values = true, value_parser = count, default_value_t = 2000)]
        most_points: usize,
        /// Largest number of combinations of contact states that a scene may try.
        #[arg(long, allow_hyphen_values = true, value_parser = count, default_value_t = 20_000)]
        most_states: usize,
        /// Largest number of integration steps on a leg of a load path along which directions of sliding turn.
        #[arg(long, allow_hyphen_values = true, value_parser = count, default_value_t = 20_000)]
        most_steps: usize,
    },
    /// The JSON Schema of scenes or of answers, for editors and for programs.
    ///
    /// An editor completes a scene that begins with `"$schema": "scene.schema.json"`, the file name under which to save this schema.
    #[cfg(feature = "cli-full")]
    Schema {
        /// The file that the schema describes.
        #[arg(value_enum, default_value_t = SchemaOf::Scene)]
        of: SchemaOf,
    },
    /// Completions for a shell, to be saved in its folder of completions.
    #[cfg(feature = "cli-full")]
    Completions {
        /// The shell for which completions are written.
        shell: Shell,
    },
    /// The manual page, in roff.
    #[cfg(feature = "cli-full")]
    Man,
}

#[cfg(feature = "cli-full")]
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum SchemaOf {
    /// A scene file.
    Scene,
    /// The list of answers that `--json` prints.
    Answers,
    /// One line of the output of `stream`.
    Line,
}

/// The scene, and the form of the answer.
#[derive(Debug, Clone, Args)]
pub(crate) struct SceneArguments {
    /// The scene; `-` for standard input.
    pub(crate) scene: PathBuf,
    /// The answers in JSON in place of words.
    #[arg(long)]
    pub(crate) json: bool,
    /// Prints the points of soft fingertips one by one, each with its own friction reserve.
    #[arg(long)]
    pub(crate) points: bool,
    /// Number of significant digits.
    #[arg(long, default_value_t = 6, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(crate) digits: u8,
    /// The unit of lengths on the command line, in a table of observed slips, and of places and arms in answers: m, cm, mm or in; the scene's field
    /// `unit` if left out.
    #[arg(long, value_parser = unit, value_name = "UNIT")]
    pub(crate) unit: Option<Unit>,
    /// Prints every second on standard error which question is being answered, where no terminal shows the question.
    #[arg(long)]
    pub(crate) progress: bool,
}

/// The question of `need`.
#[derive(Debug, Default, PartialEq, Args)]
pub(crate) struct NeedArguments {
    /// The quantity that is sought; if left out, the scene's own questions are asked.
    #[arg(value_enum)]
    pub(crate) quantity: Option<SoughtQuantity>,
    #[command(flatten)]
    pub(crate) load: LoadArguments,
    /// A constant force, N, in addition to the load and at the same point (--at). It does not depend on the sought quantity.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) base: Option<Numbers>,
    /// A force of this magnitude, N, and of any direction, in addition to the load.
    #[arg(long, allow_hyphen_values = true, value_parser = newtons, value_name = "N")]
    pub(crate) any_force: Option<f64>,
    /// For an arm: the direction in which the force is moved outwards.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) along: Option<Numbers>,
    /// For an angle: the axis about which the grasp is tilted, by the right-hand rule; in the plane 0,0,1 (anticlockwise, also if left out) or 0,0,-1.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y,Z")]
    pub(crate) axis: Option<Numbers>,
    /// For friction: the name of the contact whose coefficient is sought; the coefficient of all contacts if left out.
    #[arg(long)]
    pub(crate) contact: Option<String>,
    /// For a force: the name of the body whose load is sought, or of the contact, link or joint whose command or force is sought. If left out, the
    /// constant load (--base) is sought.
    #[arg(long, value_name = "NAME")]
    pub(crate) of: Option<String>,
    /// Seeks only the value of the quantity with which no contact slides. By default the answer has both this value and the value with which the
    /// object is held.
    #[arg(long, conflicts_with_all = ["may_slide", "repeats"])]
    pub(crate) sticks: bool,
    /// Contacts may slide, as long as the object is held, which is the default; with --repeats they may slide to and fro in every cycle.
    #[arg(long)]
    pub(crate) may_slide: bool,
    /// The load is applied and removed again and again, until the object comes to rest; with --may-slide contacts may slide to and fro in every
    /// cycle, but the object must not move farther.
    #[arg(long)]
    pub(crate) repeats: bool,
    /// Safety factor on the load, for the safe value in the answer.
    #[arg(long, allow_hyphen_values = true, value_parser = times, value_name = "TIMES")]
    pub(crate) safety: Option<f64>,
    /// Reduction of friction, percent, for the safe value in the answer; 10 if left out, 0 with --safety.
    #[arg(long, allow_hyphen_values = true, value_parser = percent, value_name = "PERCENT")]
    pub(crate) friction_less: Option<f64>,
    /// Reduction of the clamping force, percent, for the safe value in the answer; 5 if left out, 0 with --safety.
    #[arg(long, allow_hyphen_values = true, value_parser = percent, value_name = "PERCENT")]
    pub(crate) squeeze_less: Option<f64>,
}

/// A quantity that `need` seeks.
#[derive(Debug, Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum SoughtQuantity {
    /// The least clamping force of each contact.
    Squeeze,
    /// The least coefficient of friction.
    Friction,
    /// The largest factor on the load.
    Load,
    /// The largest distance at which the load may hang.
    Arm,
    /// The largest angle by which the load may be tilted.
    Angle,
    /// The least load on a body, lever or screw, or the least command or force of a contact, cable or joint.
    Force,
}

/// The place and the names of pictures.
#[derive(Debug, Args)]
pub(crate) struct Output {
    /// The folder for pictures, which is created if missing, or the file of the first picture, such as grasp.svg.
    #[arg(long, short, default_value = "output")]
    pub(crate) output: PathBuf,
    /// The beginning of the names of pictures; the name of the scene's file if left out.
    #[arg(long)]
    pub(crate) name: Option<String>,
}
