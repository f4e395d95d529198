//! Solves problems from files of Siconos, alone or compared with Siconos.

use super::timed;
use grasp_lcp::friction::{FrictionProblem, Solution};
use grasp_lcp::lcp::Outcome;
use std::path::Path;
use std::process::Command;
use support::siconos::ReadProblem;

pub(super) fn print(names: &[String]) -> Result<(), support::Failure> {
    let siconos = std::env::var("SICONOS").ok();
    println!("{:<46}{:>9}{:>10}{:>12}  what is known", "", "contacts", "residual", "ms");
    for name in names {
        let path = Path::new(name);
        let file = path.file_name().map_or_else(String::new, |file| file.to_string_lossy().into_owned());
        let text = String::from_utf8_lossy(&std::fs::read(path)?).into_owned();
        let read = if file.to_uppercase().starts_with('G') {
            // Some of these files contain the condensed problem (W, q, μ) instead of masses.
            ReadProblem::from_siconos_global(&text)
                .or_else(|error| ReadProblem::from_siconos(&text).map_err(|_| error))
        } else {
            ReadProblem::from_siconos(&text)
        };
        match read {
            Ok(ReadProblem::Planar(problem)) => row(&file, &problem),
            Ok(ReadProblem::Spatial(problem)) => row(&file, &problem),
            Err(error) => println!("{file:<46}{error}"),
        }
        if let Some(siconos) = &siconos {
            beside(siconos, path)?;
        }
    }
    Ok(())
}

fn row<const C: usize>(file: &str, problem: &FrictionProblem<C>) {
    let (time, outcome) = timed(|| problem.solve());
    let residual = outcome.solution().map_or(f64::NAN, |Solution { residuals, .. }| residuals.max());
    let known = match &outcome {
        Outcome::Solved(solution) => solution.to_string(),
        other => other.to_string(),
    };
    println!("{file:<46}{:>9}{residual:>10.1e}{time:>12.2}  {known}", problem.len());
}

/// Prints the output of the command for a file: lines with Siconos' solver, relative error and run time, s.
fn beside(command: &str, path: &Path) -> Result<(), support::Failure> {
    let mut words = command.split_whitespace();
    let program = words.next().ok_or("SICONOS is empty, but must be a command")?;
    let output = Command::new(program).args(words).arg(path).output()?;
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        if let [solver, error, seconds] = line.split(';').collect::<Vec<_>>()[..] {
            let ms = seconds.parse::<f64>()? * 1e3;
            println!("    {:<42}{:>9}{error:>10}{ms:>12.2}", format!("Siconos {solver}"), "");
        }
    }
    Ok(())
}
