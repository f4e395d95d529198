//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
#[cfg(feature = "cli-full")]
use clap_complete::Shell;

use crate::identifies::Identifies;
use crate::map::Unsure;
use crate::new::{FIELDS, Template};
pub(crate) use crate::numbers::{BodyPush, Numbers};
use crate::numbers::{acceleration, count, kilograms, newtons, percent};

/// Does the grasp hold? At which load does a contact start to slide, and what comes after?
///
/// A scene is a JSON file: contacts with points, normals, stiffness, friction and squeeze, and questions. The format is described in the
/// documentation of the module `scene`; examples are in `examples/scenes`. Lengths are in m, forces in N, angles in degrees.
#[derive(Debug, Parser)]
#[command(name = "grasp-lcp", version, max_term_width = 100, after_help = AFTER)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const AFTER: &str = "\
Examples:
  grasp-lcp new gripper > gripper.json        a scene to begin with; `new --help` explains its fields
  grasp-lcp hold mug.json --mass 0.4          does it hold 400 g, and how much more
  grasp-lcp need mug.json squeeze --mass 0.4  how many newtons each finger has to press with
  grasp-lcp improve pinch.json --mass 0.5     where the fingers should be, on their surfaces
  grasp-lcp onset mug.json --force 0,0,-1     the weight at which the first finger slides
  grasp-lcp draw mug.json                     its answers as a page, and as SVG
  grasp-lcp stream < scenes.jsonl             one scene a line in, one answer a line out

Exit codes:
  0  everything was answered; \"no equilibrium\" is an answer
  1  a file could not be read or written
  2  the command line is wrong
  3  the scene is refused, with the field and what is allowed
  4  an answer is \"undecided\"";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Writes an ordinary scene to begin with.
    ///
    /// It goes to standard output, with questions in it, so that `ask` answers at once.
    #[command(arg_required_else_help = true, after_long_help = FIELDS)]
    New {
        /// Of what.
        #[arg(value_enum)]
        of: Template,
    },
    /// Ordinary coefficients of friction and stiffnesses, with their sources.
    Values,
    /// Answers every question of a scene.
    Ask(Ask),
    /// Does it hold? The load is put on from rest, and the answer is a sentence.
    Hold {
        #[command(flatten)]
        load: LoadArguments,
        /// A force that is there at rest, N, where the load acts.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        base: Option<Numbers>,
        #[command(flatten)]
        ask: Ask,
    },
    /// How much squeeze, friction, load, arm or angle does it need, or allow?
    Need {
        #[command(flatten)]
        ask: Ask,
        #[command(flatten)]
        wanted: Wanted,
    },
    /// Where should the fingers be, and how hard should they press, so that the first slip comes as late as possible, or most friction is left?
    ///
    /// Contacts that may move have a `surface` in the scene. The answer says what stands in the way of more, and `draw` shows the grasp before and after.
    Improve {
        #[command(flatten)]
        load: LoadArguments,
        /// A force that is there at rest, N, where the load acts.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        base: Option<Numbers>,
        /// A force of any direction, of which this size counts as one, N, beside the load.
        #[arg(long, allow_hyphen_values = true, value_parser = newtons, value_name = "N")]
        any_force: Option<f64>,
        /// Contacts may press with up to this force, N; as they are commanded if left out.
        #[arg(long, allow_hyphen_values = true, value_parser = newtons, value_name = "N")]
        at_most: Option<f64>,
        /// Keeps most friction in reserve while the load acts in full, in place of a late first slip.
        #[arg(long)]
        reserve: bool,
        #[command(flatten)]
        ask: Ask,
    },
    /// Where does the object go, and what do the contacts carry, under a load?
    Solve {
        #[command(flatten)]
        load: LoadArguments,
        #[command(flatten)]
        ask: Ask,
    },
    /// At which load does the first contact start to slide?
    ///
    /// The load grows from nothing along a force and a moment; the factor of the answer counts them.
    Onset {
        #[command(flatten)]
        load: LoadArguments,
        #[command(flatten)]
        ask: Ask,
    },
    /// At which angle does the first contact start to slide while a weight is tilted?
    Turn {
        /// The mass of the object, kg, with 9.81 m/s² down along the last axis.
        #[arg(long, allow_hyphen_values = true, value_parser = kilograms, value_name = "KG", conflicts_with = "weight")]
        mass: Option<f64>,
        /// The weight in place of the mass, N: components between commas.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        weight: Option<Numbers>,
        /// The centre of mass, m; the origin if left out.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        at: Option<Numbers>,
        /// A force that does not turn, N, where the weight acts.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        base: Option<Numbers>,
        /// In space the axis about which the grasp is tilted.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y,Z")]
        axis: Option<Numbers>,
        #[command(flatten)]
        ask: Ask,
    },
    /// What happens on the way as the load goes from one force to the next?
    Follow {
        /// A force that the load goes to, N, one for each leg.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        to: Vec<Numbers>,
        /// The force at the start, N; none if left out.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        from: Option<Numbers>,
        /// Where the forces act, m; the origin if left out.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        at: Option<Numbers>,
        #[command(flatten)]
        ask: Ask,
    },
    /// Does it survive a load that repeats, or does the object walk out?
    ///
    /// Forces are put on and taken off again in turn, cycle after cycle, beside what is there at rest. The answer holds for all time.
    Shake {
        /// A force that is put on and taken off again, N; several are put on one after the other.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        force: Vec<Numbers>,
        /// The mass of the object, kg, with 9.81 m/s² down along the last axis, there at rest.
        #[arg(long, allow_hyphen_values = true, value_parser = kilograms, value_name = "KG")]
        mass: Option<f64>,
        /// Accelerations of this size, m/s², to and fro along every axis in turn: the mass pulls the other way.
        #[arg(long, allow_hyphen_values = true, value_parser = acceleration, value_name = "A", requires = "mass")]
        acceleration: Option<f64>,
        /// The forces come in any order, and again and again: up to how many times these could it come to rest?
        #[arg(long)]
        any_order: bool,
        /// A force that is there at rest, N.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        base: Option<Numbers>,
        /// Where forces and weight act, m; the origin if left out.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        at: Option<Numbers>,
        #[command(flatten)]
        ask: Ask,
    },
    /// What do slips that were seen tell of friction, loads of supports, squeeze or stiffness?
    ///
    /// Columns of the table are fx, fy, fz (N) of the load under which it slid, mx, my, mz (in the plane m, N m), at_x, at_y, at_z (m) where the force acted,
    /// squeeze (times that of the scene), slip (first or gross) and scatter_percent. Slips that may share an error have the same name or number in the column
    /// group. Numbers come with their errors; what slips do not fix is named.
    Identify {
        #[command(flatten)]
        ask: Ask,
        #[command(flatten)]
        slips: Identifies,
    },
    /// How much is held in every direction, and which is the weakest? A table and pictures.
    ///
    /// Beside the force at first slip stands the one below which so few grasps slide as the standard deviations in reserve say, where friction, stiffness
    /// and squeeze of every contact are not known exactly.
    Map {
        /// The scene; `-` for standard input.
        scene: PathBuf,
        /// Where the force acts, m; the origin if left out.
        #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
        at: Option<Numbers>,
        #[command(flatten)]
        unsure: Unsure,
        /// Prints the map as one JSON object, and draws nothing.
        #[arg(long)]
        json: bool,
        /// Where no terminal shows a bar, tells every second on standard error how far the map is.
        #[arg(long)]
        progress: bool,
        #[command(flatten)]
        output: Output,
    },
    /// Draws every question: SVG, and a page with all answers, of a spatial grasp to turn with the mouse.
    ///
    /// The first question is drawn in a file with the name of the scene, those after it in files with their number besides. A file that ends in `_friction`
    /// shows what each contact uses of its friction as the load is put on, turns or follows a program. One that ends in `_cycles` shows what slips while a
    /// load repeats.
    Draw {
        /// The scene; `-` for standard input.
        scene: PathBuf,
        #[command(flatten)]
        output: Output,
    },
    /// Answers scenes in JSON, one a line, on all cores, in order.
    ///
    /// Every line of standard input is a scene; every line of standard output is its answer, with the number of the line and the scene's `id`, or
    /// a hash of the line. A line that cannot be answered gives an error in its place, and the rest goes on.
    Stream {
        /// Workers; the output does not depend on them. All cores if left out.
        #[arg(long, value_parser = clap::value_parser!(u16).range(1..=1024))]
        threads: Option<u16>,
        /// Answers in a hundred bytes: outcome, factor and the first contact.
        #[arg(long)]
        brief: bool,
        /// A scene with more points of contact is refused.
        #[arg(long, allow_hyphen_values = true, value_parser = count, default_value_t = 2000)]
        most_points: usize,
        /// Most combinations of contact states that a scene may try.
        #[arg(long, allow_hyphen_values = true, value_parser = count, default_value_t = 20_000)]
        most_states: usize,
        /// Most steps along sliding arcs that a leg may take.
        #[arg(long, allow_hyphen_values = true, value_parser = count, default_value_t = 20_000)]
        most_steps: usize,
    },
    /// The JSON Schema of scenes or of answers, for editors and for programs that write them.
    ///
    /// An editor completes a scene that begins with `"$schema": "scene.schema.json"`, the file that this writes.
    #[cfg(feature = "cli-full")]
    Schema {
        /// Of what.
        #[arg(value_enum, default_value_t = SchemaOf::Scene)]
        of: SchemaOf,
    },
    /// Completions for a shell, to be put where it looks for them.
    #[cfg(feature = "cli-full")]
    Completions {
        /// The shell.
        shell: Shell,
    },
    /// The manual page, in roff.
    #[cfg(feature = "cli-full")]
    Man,
}

/// What a schema is of.
#[cfg(feature = "cli-full")]
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum SchemaOf {
    /// Of a scene.
    Scene,
    /// Of what `--json` prints: a list of answers.
    Answers,
    /// Of a line of `stream`.
    Line,
}

/// Which scene, and how the answer is written.
#[derive(Debug, Args)]
pub(crate) struct Ask {
    /// The scene; `-` for standard input.
    pub(crate) scene: PathBuf,
    /// The answers in JSON in place of words.
    #[arg(long)]
    pub(crate) json: bool,
    /// Points of soft fingertips one by one, each with its own margin.
    #[arg(long)]
    pub(crate) points: bool,
    /// How many digits numbers have.
    #[arg(long, default_value_t = 6, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(crate) digits: u8,
}

/// An amount that is sought.
#[derive(Debug, Args)]
pub(crate) struct Wanted {
    /// What is sought; without it the scene's own questions are asked.
    #[arg(value_enum)]
    pub(crate) quantity: Option<QuantityAsked>,
    #[command(flatten)]
    pub(crate) load: LoadArguments,
    /// A force that is there whatever the amount, N, where the load acts.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) base: Option<Numbers>,
    /// A force of this size and any direction beside the load, N.
    #[arg(long, allow_hyphen_values = true, value_parser = newtons, value_name = "N")]
    pub(crate) any_force: Option<f64>,
    /// Of an arm: the direction in which the force is moved out.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) along: Option<Numbers>,
    /// Of an angle in space: the axis about which the grasp is tilted.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y,Z")]
    pub(crate) axis: Option<Numbers>,
    /// Of friction: the contact that it is sought of, by name.
    #[arg(long)]
    pub(crate) contact: Option<String>,
    /// Contacts may slide, as long as the object is not lost.
    #[arg(long)]
    pub(crate) may_slide: bool,
    /// The load is put on and taken off again and again, until it comes to rest; with --may-slide it only must not walk.
    #[arg(long)]
    pub(crate) repeats: bool,
    /// Accelerations of this size, m/s², to and fro along every axis in turn, beside the weight.
    #[arg(long, allow_hyphen_values = true, value_parser = acceleration, value_name = "A", requires = "mass")]
    pub(crate) acceleration: Option<f64>,
    /// For the safe amount friction is less by so many percent.
    #[arg(long, allow_hyphen_values = true, value_parser = percent, default_value_t = 10.0, value_name = "PERCENT")]
    pub(crate) friction_less: f64,
    /// For the safe amount the squeeze is less by so many percent.
    #[arg(long, allow_hyphen_values = true, value_parser = percent, default_value_t = 5.0, value_name = "PERCENT")]
    pub(crate) squeeze_less: f64,
}

/// What is sought.
#[derive(Debug, Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum QuantityAsked {
    /// What each contact has to press with.
    Squeeze,
    /// The least coefficient of friction.
    Friction,
    /// How many times the load.
    Load,
    /// How far out the load may hang.
    Arm,
    /// How far the load may be tilted.
    Angle,
}

/// A load in place of those that the scene asks for.
#[derive(Debug, Args)]
pub(crate) struct LoadArguments {
    /// The force, N: components between commas. Without force and moment the scene's own questions are asked.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) force: Option<Numbers>,
    /// The moment, N m: one number in the plane, three in space.
    #[arg(long, allow_hyphen_values = true, value_name = "M")]
    pub(crate) moment: Option<Numbers>,
    /// Where force and weight act, m; the origin if left out.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) at: Option<Numbers>,
    /// Of several bodies a force on one of them that grows together with the load, and where it acts; once for each.
    #[arg(long, allow_hyphen_values = true, value_name = "BODY=X,Y[,Z][@X,Y[,Z]]")]
    pub(crate) together_with: Vec<BodyPush>,
    /// A mass, kg, whose weight is put on.
    #[arg(long, allow_hyphen_values = true, value_parser = kilograms, value_name = "KG")]
    pub(crate) mass: Option<f64>,
    /// Gravity, m/s²; down along the last axis with 9.81 if left out.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]", requires = "mass")]
    pub(crate) gravity: Option<Numbers>,
    /// The acceleration of the arm, m/s²: the mass pulls the other way.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]", requires = "mass")]
    pub(crate) accelerated: Option<Numbers>,
    /// A point of the axis about which the arm turns, m; the origin if left out.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]", requires = "mass")]
    pub(crate) about: Option<Numbers>,
    /// How fast the arm turns, degrees/s: one number in the plane, in space three along the axis.
    #[arg(long, allow_hyphen_values = true, value_name = "W", requires = "mass")]
    pub(crate) angular_velocity: Option<Numbers>,
    /// How its turning speeds up, degrees/s²: as many numbers.
    #[arg(long, allow_hyphen_values = true, value_name = "A", requires = "mass")]
    pub(crate) angular_acceleration: Option<Numbers>,
    /// The moment of inertia about the centre of mass, kg m²: one number in the plane, in space three, about axes along the coordinates.
    #[arg(long, allow_hyphen_values = true, value_name = "I", requires = "mass")]
    pub(crate) inertia: Option<Numbers>,
}

/// Where pictures go.
#[derive(Debug, Args)]
pub(crate) struct Output {
    /// The folder that pictures are written to; it is made if it is not there.
    #[arg(long, short, default_value = "output")]
    pub(crate) output: PathBuf,
    /// What the names of pictures begin with; the name of the scene's file if left out.
    #[arg(long)]
    pub(crate) name: Option<String>,
}
