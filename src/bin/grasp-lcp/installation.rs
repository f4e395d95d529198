//! Other output of an installed program: schemas, shell completions and the manual.

use std::io::{self, Write};

use clap::CommandFactory;
use clap_complete::Shell;
use grasp_lcp::schema::Schema;

use super::arguments::{Arguments, SchemaOf};
use super::failure::Failure;

pub(crate) fn schema(of: SchemaOf) -> Result<(), Failure> {
    let schema = match of {
        SchemaOf::Scene => Schema::Scene,
        SchemaOf::Answers => Schema::Answers,
        SchemaOf::Line => Schema::Reply,
    };
    Ok(writeln!(io::stdout(), "{:#}", schema.to_json())?)
}

pub(crate) fn completions(shell: Shell, out: &mut impl Write) -> Result<(), Failure> {
    // The generator panics on a write error. It therefore writes to memory first, where no write fails.
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "grasp-lcp", &mut text);
    Ok(out.write_all(&text)?)
}

/// Writes the manual page of the program, then the manual pages of its commands.
pub(crate) fn manual(out: &mut impl Write) -> Result<(), Failure> {
    let command = Arguments::command();
    clap_mangen::Man::new(command.clone()).render(out)?;
    for part in command.get_subcommands() {
        clap_mangen::Man::new(part.clone()).render(out)?;
    }
    Ok(())
}
