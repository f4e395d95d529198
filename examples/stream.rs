//! One scene a line in, one answer a line out: JSON on standard input and output, in order, on all cores, in bounded memory.
//!
//! `cargo run --release --example stream < examples/scenes/stream.jsonl`
//!
//! Every line of input is a scene (module `grasp_lcp::scene`) on one line; every line of output is
//!
//! ```text
//! {"line": 3, "id": …, "answers": [ … ]}     one answer for each question, in order
//! {"line": 4, "id": …, "error": {"kind": …, "message": …, "field": …, "column": …}}
//! ```
//!
//! where the kind is "syntax" (no JSON), "scene" (no scene) or "question" (nothing that can be asked of this grasp). Both have the number of
//! the line, from 1, and the `id` of the scene if it has one. A line that cannot be answered gives an error and the rest goes
//! on; an empty line gives nothing. A summary goes to standard error. The exit code is 0 if all input was read, whatever is in
//! it: 1 if reading or writing failed, 2 for a wrong option.
//!
//! A scene of many contacts whose numbers lie far apart may take long, and the lines behind it wait: the setting `max_pivots` bounds that, with
//! the answer "undecided".

#[path = "support/scene_file.rs"]
mod scene_file;
#[path = "support/stream.rs"]
mod stream;

use std::io::{self, BufWriter};
use std::num::NonZero;
use std::process::ExitCode;
use std::time::Instant;

const HELP: &str = "usage: stream [--threads N] < scenes.jsonl > answers.jsonl

Reads one JSON scene a line from standard input and writes one JSON answer a line to standard output, in order.
  --threads N   workers, all cores unless said otherwise; the output is the same for any number
  --help        this text
The format of scenes: documentation of the module grasp_lcp::scene; examples: examples/scenes/stream.jsonl";

fn threads() -> Result<Option<usize>, String> {
    let mut arguments = std::env::args().skip(1);
    let mut threads = std::thread::available_parallelism().map_or(1, NonZero::get);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--help" => return Ok(None),
            "--threads" => {
                let given = arguments.next().ok_or("--threads: a number is missing")?;
                threads = given
                    .parse()
                    .ok()
                    .filter(|n| (1..=1024).contains(n))
                    .ok_or(format!("--threads is {given}, must be from 1 to 1024"))?;
            }
            other => return Err(format!("{other}: no such option, must be --threads N or --help")),
        }
    }
    Ok(Some(threads))
}

fn main() -> ExitCode {
    let threads = match threads() {
        Ok(Some(threads)) => threads,
        Ok(None) => {
            println!("{HELP}");
            return ExitCode::SUCCESS;
        }
        Err(message) => {
            eprintln!("{message}\n{HELP}");
            return ExitCode::from(2);
        }
    };
    let start = Instant::now();
    match stream::answer_lines(io::stdin(), BufWriter::new(io::stdout()), threads) {
        Ok(tally) => {
            let seconds = start.elapsed().as_secs_f64();
            eprintln!(
                "{} lines: {} answered, {} errors, {seconds:.3} s, {:.0} scenes/s on {threads} threads",
                tally.lines,
                tally.answered,
                tally.errors,
                tally.answered as f64 / seconds,
            );
            ExitCode::SUCCESS
        }
        // Whoever read the answers has seen enough.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
