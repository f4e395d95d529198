//! The command `identify`: reads a table of observations, and the parameters to be estimated from them. An observation is a load under which a
//! contact, or the object, was seen to slip. A parameter is a number of the grasp, such as a coefficient of friction; in the options it is called an
//! unknown.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use grasp_lcp::identify::{Identify, Slip, Unknown, UnknownKind};
use grasp_lcp::spatial::Wrench;
use grasp_lcp::words::{Unit, printable};

use crate::arguments::Numbers;
use crate::failure::Failure;
use crate::files::{bytes, name};
use crate::loads::OptionVectors;
use crate::needs::named;
use grasp_lcp::scene::{Question, Setup};

/// The parameters to be estimated, and the table of observations.
#[derive(Debug, clap::Args)]
pub(crate) struct Identifies {
    /// A table of slips: rows of numbers separated by commas, semicolons or tabs, below a row with the names of the columns. If left out, the scene's
    /// own questions are asked.
    pub(crate) table: Option<PathBuf>,
    /// An unknown, one number for all contacts or for the named ones: friction, carried (the load of a support, N), squeeze or stiffness.
    /// If left out, one coefficient of friction of all contacts that have friction is sought.
    #[arg(long, value_name = "WHAT[=CONTACT,CONTACT]")]
    pub(crate) unknown: Vec<UnknownGiven>,
    /// A known sum of unknowns, given by their numbers from 0, with its standard deviation in percent.
    #[arg(long, value_name = "0+1=VALUE,PERCENT")]
    pub(crate) known: Vec<Sum>,
    /// Rows of the table are loads at first slip, unless the table has a column `slip`; loads at gross slip if left out.
    #[arg(long)]
    pub(crate) first: bool,
    /// The standard deviation of loads in percent, unless the table has a column for it; estimated if left out.
    #[arg(long, allow_hyphen_values = true, value_parser = crate::numbers::percent, value_name = "PERCENT")]
    pub(crate) scatter: Option<f64>,
    /// A force that acted before the load, N.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) base: Option<Numbers>,
    /// The unit of lengths in the table.
    #[arg(skip)]
    pub(crate) unit: Unit,
}

/// One parameter to be estimated: its kind, such as friction, and the names of the contacts for which it is sought. An empty list means all contacts.
#[derive(Debug, Clone)]
pub(crate) struct UnknownGiven {
    kind: UnknownKind,
    contacts: Vec<String>,
}

impl FromStr for UnknownGiven {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (kind, contacts) = text.split_once('=').map_or((text, None), |(kind, rest)| (kind, Some(rest)));
        let kind = match kind {
            "friction" => UnknownKind::Friction,
            "carried" => UnknownKind::Carried,
            "squeeze" => UnknownKind::Squeeze,
            "stiffness" => UnknownKind::Stiffness,
            _ => {
                return Err(
                    "must be friction, carried, squeeze or stiffness, such as friction=left,right".to_owned()
                );
            }
        };
        let contacts = contacts.into_iter().flat_map(|names| names.split(',')).map(str::to_owned).collect();
        Ok(Self { kind, contacts })
    }
}

/// A known sum of parameters: their numbers, the value of the sum, and its standard deviation in percent.
#[derive(Debug, Clone)]
pub(crate) struct Sum {
    unknowns: Vec<usize>,
    value: f64,
    percent: f64,
}

impl FromStr for Sum {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('=').and_then(|(unknowns, rest)| Some((unknowns, rest.split_once(',')?)));
        let sum = parts.and_then(|(unknowns, (value, percent))| {
            let unknowns = unknowns.split('+').map(|number| number.trim().parse().ok());
            Some(Self {
                unknowns: unknowns.collect::<Option<_>>()?,
                value: value.trim().parse().ok()?,
                percent: percent.trim().parse().ok()?,
            })
        });
        sum.ok_or_else(|| {
            "must be numbers of unknowns, their sum and its scatter in percent, such as 1+2=9.8,0.5"
                .to_owned()
        })
    }
}

impl OptionVectors {
    /// The question `identify` with the table of observations; `None` without a table: the caller then asks the scene's own questions. Without a
    /// table, options that need one are an error.
    pub(crate) fn identify(
        self,
        given: &Identifies,
        setup: &Setup<3>,
    ) -> Result<Option<Question<3>>, Failure> {
        let Some(path) = &given.table else {
            let others = !given.unknown.is_empty() || !given.known.is_empty() || given.first;
            let missing = "say which slips were seen: a table behind the scene".to_owned();
            let is_more = others || given.scatter.is_some() || given.base.is_some();
            return if is_more { Err(Failure::Usage(missing)) } else { Ok(None) };
        };
        let mut unknowns = Vec::new();
        for sought in &given.unknown {
            let mut contacts = Vec::new();
            for name in &sought.contacts {
                contacts.push(named("unknown", name, setup)?);
            }
            let unknown = Unknown::of(sought.kind);
            unknowns.push(if contacts.is_empty() { unknown } else { unknown.of_contacts(contacts) });
        }
        if unknowns.is_empty() {
            unknowns.push(Unknown::friction());
        }
        let mut asked = Identify::new(unknowns, self.slips(path, given)?);
        for sum in &given.known {
            asked = asked.knowing(sum.unknowns.iter().copied(), sum.value, 0.01 * sum.percent);
        }
        Ok(Some(Question::Identify(Box::new(asked))))
    }

    /// The observations of a table, one for each row.
    fn slips(self, path: &Path, given: &Identifies) -> Result<Vec<Slip<3>>, Failure> {
        let name = name(path);
        let refused =
            |line: usize, fault: String| Failure::Scene(format!("{name}: line {}, {fault}", line + 1));
        let table = bytes(path, "a table of slips, numbers separated by commas")?;
        let text = std::str::from_utf8(&table).map_err(|error| {
            let read = &table[..error.valid_up_to()];
            let line = read.split(|byte| *byte == b'\n').count() - 1;
            refused(line, "no UTF-8: the table must be saved as UTF-8".to_owned())
        })?;
        let text = text.trim_start_matches('\u{feff}');
        let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
        let columns = columns(self.axes);
        let Some((head, heads)) = lines.next() else {
            return Err(refused(
                0,
                format!("nothing given, must be names of columns: {}", columns.join(", ")),
            ));
        };
        // Spreadsheets separate columns by semicolons or tabs, too, and write text between quotation marks.
        let separator = [';', '\t'].into_iter().find(|separator| heads.contains(*separator)).unwrap_or(',');
        let cells = |row| str::split(row, separator).map(|cell| cell.trim().trim_matches('"')).collect();
        let heads: Vec<&str> = cells(heads);
        if let Some(other) = heads.iter().find(|head| !columns.contains(head)) {
            let other = printable(other);
            return Err(refused(
                head,
                format!("column `{other}`: unknown name, must be one of {}", columns.join(", ")),
            ));
        }
        if let Some(again) = (1..heads.len()).find(|k| heads[..*k].contains(&heads[*k])) {
            return Err(refused(
                head,
                format!("column `{}`: is there twice, must be there once", heads[again]),
            ));
        }
        let (mut slips, mut groups) = (Vec::new(), Vec::new());
        for (line, row) in lines {
            let cells: Vec<&str> = cells(row);
            if cells.len() != heads.len() {
                let fault = format!("{} columns given, must be {}", cells.len(), heads.len());
                return Err(refused(line, fault));
            }
            let slip = self.slip((&heads, &cells), &mut groups, given);
            slips.push(slip.map_err(|fault| match fault {
                Fault::Cell(fault) => refused(line, fault),
                Fault::Usage(failure) => failure,
            })?);
        }
        Ok(slips)
    }

    /// The observation of one row; `heads` are the names of the columns. Observations of one group, named in the column `group`, may share an error.
    /// Groups are numbered in the order in which the table first names them.
    fn slip<'a>(
        self,
        (heads, cells): (&[&str], &[&'a str]),
        groups: &mut Vec<&'a str>,
        given: &Identifies,
    ) -> Result<Slip<3>, Fault> {
        let [mut force, mut at, mut moment, mut base] = [[0.0; 3]; 4];
        let (mut first, mut squeeze) = (given.first, None);
        let (mut scatter, mut group) = (given.scatter, None);
        for (head, cell) in heads.iter().zip(cells) {
            if *head == "slip" {
                first = match *cell {
                    "first" => true,
                    "gross" => false,
                    other => {
                        return Err(Fault::Cell(format!(
                            "slip: `{}` given, must be first or gross",
                            printable(other)
                        )));
                    }
                };
                continue;
            }
            if *head == "group" {
                let known = groups.iter().position(|name| name == cell);
                group = known.or_else(|| {
                    groups.push(cell);
                    Some(groups.len() - 1)
                });
                continue;
            }
            let number = cell.parse::<f64>().ok().filter(|number| number.is_finite()).ok_or_else(|| {
                Fault::Cell(format!("{head}: `{}` given, must be a finite number", printable(cell)))
            })?;
            match *head {
                "squeeze" => squeeze = Some(number),
                "scatter_percent" => scatter = Some(number),
                "m" => moment[2] = number,
                _ => {
                    let axis = usize::from(head.ends_with('y')) + 2 * usize::from(head.ends_with('z'));
                    let row = match head.as_bytes()[0] {
                        b'f' => &mut force,
                        b'a' => &mut at,
                        b'b' => &mut base,
                        _ => &mut moment,
                    };
                    row[axis] = number;
                }
            }
        }
        let at = at.map(|x| given.unit.in_metres(x));
        let load = Wrench::force_at(force, at) + Wrench::new([0.0; 3], moment);
        let mut slip = if first { Slip::first(load) } else { Slip::gross(load) };
        if let Some(squeeze) = squeeze {
            slip = slip.squeezed(squeeze);
        }
        if let Some(group) = group {
            slip = slip.in_group(group);
        }
        if let Some(percent) = scatter {
            slip = slip.scattering_by(0.01 * percent);
        }
        if given.base.is_some() || heads.iter().any(|head| head.starts_with("base")) {
            let of_all = self.base(given.base.as_ref(), None).map_err(Fault::Usage)?;
            slip = slip.on_top_of(of_all + Wrench::force(base));
        }
        Ok(slip)
    }
}

/// The error of a row of the table of observations: a faulty cell, or a faulty option of the command line.
enum Fault {
    Cell(String),
    Usage(Failure),
}

/// The allowed names of columns, in the plane or in space.
fn columns(axes: usize) -> Vec<&'static str> {
    let of_space: &[_] = if axes == 3 {
        &["fx", "fy", "fz", "mx", "my", "mz", "at_x", "at_y", "at_z", "base_x", "base_y", "base_z"]
    } else {
        &["fx", "fy", "m", "at_x", "at_y", "base_x", "base_y"]
    };
    of_space.iter().copied().chain(["squeeze", "slip", "scatter_percent", "group"]).collect()
}
