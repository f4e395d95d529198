//! The program `grasp-lcp`. It answers the questions of a scene and draws pictures of the answers. It maps the force that a grasp holds in every
//! direction. It also answers a stream of scenes, one a line.

#[macro_use]
mod printing;

mod arguments;
mod asking;
mod command_question;
mod drawing;
mod failure;
mod files;
mod followed;
#[cfg(feature = "mesh")]
mod grip;
mod identifies;
mod in_units;
#[cfg(feature = "cli-full")]
mod installation;
mod load_arguments;
mod loads;
mod map;
mod needs;
mod new;
mod numbers;
mod own_masses;
mod progress_line;
mod report;
mod scene_loads;
mod shakes;
mod table;
mod values;
mod words;

use std::ffi::OsString;
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, Parser};
use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::Ramp;
use grasp_lcp::scene::Question;
use grasp_lcp::stream::{StreamOptions, answer_lines};

use arguments::{Arguments, Command};
use failure::Failure;
use files::Pictures;
use loads::OptionVectors;
#[cfg(feature = "mesh")]
use new::Template;

fn main() -> ExitCode {
    match asked().and_then(|code| io::stdout().flush().map(|()| code).map_err(Failure::from)) {
        Ok(code) => code,
        Err(failure) => {
            failure.tell();
            ExitCode::from(failure.code())
        }
    }
}

/// Does what the command line asks, or prints its usage.
fn asked() -> Result<ExitCode, Failure> {
    match parse_arguments() {
        Ok(arguments) => run(arguments.command),
        Err(help) => {
            let help = with_owners_of_flag(help);
            help.print()?;
            Ok(ExitCode::from(u8::try_from(help.exit_code()).unwrap_or(2)))
        }
    }
}

/// Parses the command line. The file name of the scene may stand anywhere among the arguments. If parsing fails, the argument that ends in `.json`,
/// or `-`, is moved behind the command.
fn parse_arguments() -> Result<Arguments, clap::Error> {
    let mut words: Vec<_> = std::env::args_os().collect();
    let parsed = Arguments::try_parse_from(&words);
    // `identify` takes two files, a scene and a table of measurements. If they are swapped, parsing succeeds; the scene is then moved to its place as
    // well.
    if parsed.as_ref().is_ok_and(|arguments| !matches!(arguments.command, Command::Identify { .. })) {
        return parsed;
    }
    let is_scene =
        |word: &OsString| word == "-" || Path::new(word).extension().is_some_and(|end| end == "json");
    let Some(place) = words.iter().position(is_scene).filter(|place| *place > 0 && words.len() > 2) else {
        return parsed;
    };
    let scene = words.remove(place);
    words.insert(2, scene);
    Arguments::try_parse_from(&words).or(parsed)
}

/// The error about a flag that the subcommand does not have. Its tip names the subcommands that have the flag.
fn with_owners_of_flag(mut error: clap::Error) -> clap::Error {
    let Some(ContextValue::String(flag)) =
        error.get(ContextKind::InvalidArg).filter(|_| error.kind() == ErrorKind::UnknownArgument)
    else {
        return error;
    };
    let (flag, long) = (flag.clone(), flag.trim_start_matches('-'));
    let mut owners = Vec::new();
    for command in Arguments::command().get_subcommands() {
        if command.get_arguments().any(|argument| argument.get_long() == Some(long)) {
            owners.push(format!("`{}`", command.get_name()));
        }
    }
    // The parser's own tip is to write the flag behind `--`. The flag would then be read as the name of a scene.
    error.remove(ContextKind::Suggested);
    if !owners.is_empty() {
        let tip = format!("`{flag}` belongs to {}", owners.join(", "));
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip.into()]));
    }
    error
}

fn run(mut command: Command) -> Result<ExitCode, Failure> {
    if let Some(ask) = command.asks() {
        let ask = ask.clone();
        return asking::ask(&ask, command);
    }
    match command {
        #[cfg(feature = "mesh")]
        Command::New { of: Template::Grip, grip } => return grip.run(),
        Command::New { of, .. } => {
            #[cfg(feature = "mesh")]
            new::refuse_options_of_grip()?;
            io::stdout().write_all(of.text().as_bytes())?;
        }
        Command::Scene => io::stdout().write_all(arguments::FIELDS.as_bytes())?,
        Command::Values => values::print(&mut io::stdout().lock())?,
        Command::Map { scene, mut at, base, unit, data_deviations, json, progress, output } => {
            let pictures = Pictures::new(&output, &scene);
            let mut of_map = files::read(&scene)?;
            files::warn(&scene, &of_map)?;
            if let Some(at) = &mut at {
                at.bring_to_metres(unit.unwrap_or(of_map.unit));
            }
            if base.is_some() {
                let base = OptionVectors::of(&of_map.setup).base(base.as_ref(), at.as_ref())?;
                of_map.setup.questions = vec![Question::onset(Ramp::load(base, Wrench::ZERO))];
            }
            let asked = (&data_deviations, map::MapProgress { lines: progress });
            map::map(&of_map, at.as_ref(), asked, (!json).then_some(&pictures))?;
        }
        Command::Draw { scene, output } => {
            let drawn = files::read(&scene)?;
            files::warn(&scene, &drawn)?;
            drawing::draw(&drawn, &Pictures::new(&output, &scene))?;
        }
        Command::Stream { threads, brief, most_points, most_states, most_steps } => {
            let mut options = StreamOptions::default();
            options.threads = threads.map_or(options.threads, usize::from);
            (options.brief, options.most_points) = (brief, most_points);
            (options.most_states, options.most_steps) = (most_states, most_steps);
            stream(&options)?;
        }
        #[cfg(feature = "cli-full")]
        Command::Schema { of } => installation::schema(of)?,
        #[cfg(feature = "cli-full")]
        Command::Completions { shell } => installation::completions(shell, &mut io::stdout().lock())?,
        #[cfg(feature = "cli-full")]
        Command::Man => installation::manual(&mut io::stdout().lock())?,
        _ => {}
    }
    Ok(ExitCode::SUCCESS)
}

fn stream(options: &StreamOptions) -> Result<(), Failure> {
    let start = Instant::now();
    let tally = answer_lines(io::stdin(), BufWriter::new(io::stdout()), options)?;
    let seconds = start.elapsed().as_secs_f64();
    eprintln!(
        "{} lines: {} answered, {} errors, {seconds:.3} s, {:.0} scenes/s on {} threads",
        tally.lines,
        tally.answered,
        tally.errors,
        tally.answered as f64 / seconds,
        options.threads
    );
    Ok(())
}
