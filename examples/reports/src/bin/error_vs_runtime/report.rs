//! Output of the measurements: a table on the terminal and as comma-separated values, charts of error against run time, and a page with both.

use std::fmt::Write;

use grasp_lcp::picture::{Chart, Stroke};

use support::Failure;

/// Height at which an error of exactly zero is drawn, since it has no logarithm.
const NOTHING: f64 = 1e-17;

const HEAD: &str = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Error against run time</title>\n\
    <style>body{font-family:sans-serif;max-width:75em;margin:auto}svg{max-width:100%;height:auto}td,th{text-align:left;padding:0 1em 0 0}</style>\n\
    </head>\n<body>\n<h1>Error against run time</h1>\n<p>Errors are against closed forms, exact rational arithmetic or an integration to 1e-13. \
    Times are the shortest of many of one call.</p>\n";

/// All measurements, part by part.
#[derive(Default)]
pub struct Report {
    panels: Vec<Panel>,
}

/// One question, answered in several ways: one chart.
pub struct Panel {
    /// The part of the report to which the panel belongs.
    pub part: &'static str,
    pub title: &'static str,
    /// The quantity whose error is given, and what it is divided by.
    pub error: &'static str,
    pub lines: Vec<Line>,
    /// Printed below the table.
    pub notes: Vec<String>,
}

/// The measurements of one method.
pub struct Line {
    pub method: String,
    pub points: Vec<Point>,
}

/// The measurement of a method with one setting.
pub struct Point {
    /// Number of steps or facets, or the tolerance; empty for a method without a setting.
    pub setting: String,
    pub error: f64,
    /// Seconds.
    pub time: f64,
}

impl Panel {
    pub fn new(part: &'static str, title: &'static str, error: &'static str) -> Self {
        Self { part, title, error, lines: Vec::new(), notes: Vec::new() }
    }

    pub fn add(&mut self, method: &str, setting: impl Into<String>, error: f64, time: f64) {
        let point = Point { setting: setting.into(), error, time };
        match self.lines.iter_mut().find(|line| line.method == method) {
            Some(line) => line.points.push(point),
            None => self.lines.push(Line { method: method.into(), points: vec![point] }),
        }
    }

    /// The last measurement of a method.
    pub fn last(&self, method: &str) -> Option<&Point> {
        self.lines.iter().find(|line| line.method == method)?.points.last()
    }

    fn print(&self) {
        println!("\n{}", self.title);
        println!("  {:44} {:>9} {:>10} {:>12}", "method", "setting", "error", "time (µs)");
        for line in &self.lines {
            for (k, point) in line.points.iter().enumerate() {
                let method = if k == 0 { &line.method } else { "" };
                let error =
                    if point.error.is_nan() { "no answer".into() } else { format!("{:.1e}", point.error) };
                println!("  {method:44} {:>9} {error:>10} {:>12.2}", point.setting, 1e6 * point.time);
            }
        }
        println!("  error: {}", self.error);
        for note in &self.notes {
            println!("  {note}");
        }
    }

    fn write_table(&self, page: &mut String) -> std::fmt::Result {
        let head = "<tr><th>method<th>setting<th>error<th>time, µs</tr>";
        writeln!(page, "<details><summary>{}</summary>\n<table>\n{head}", self.title)?;
        for line in &self.lines {
            for p in &line.points {
                let error = if p.error.is_nan() { "no answer".into() } else { format!("{:.1e}", p.error) };
                let Point { setting, time, .. } = p;
                let method = &line.method;
                writeln!(page, "<tr><td>{method}<td>{setting}<td>{error}<td>{:.2}</tr>", 1e6 * time)?;
            }
        }
        writeln!(page, "</table>\n<p>Error: {}. {}</p></details>", self.error, self.notes.join("; "))
    }

    fn chart(&self) -> Chart {
        // NaN, a missing answer, must stay NaN so that it is not drawn; f64::max would replace it.
        let height = |error: f64| if error == 0.0 { NOTHING } else { error };
        let zero = self.lines.iter().flat_map(|line| &line.points).any(|point| point.error == 0.0);
        let error = if zero { format!("{} (0 drawn at 10⁻¹⁷)", self.error) } else { self.error.into() };
        let scaled =
            self.lines.iter().flat_map(|line| &line.points).any(|point| point.setting.ends_with('*'));
        let time = if scaled { "run time (s), * scaled from a thousand steps" } else { "run time (s)" };
        self.lines.iter().fold(Chart::new(self.title, time, error).log_log(), |chart, line| {
            let points: Vec<_> = line.points.iter().map(|p| (p.time, height(p.error))).collect();
            let name = match &line.points[..] {
                [first, .., last] => format!("{}, {} … {}", line.method, first.setting, last.setting),
                _ => line.method.clone(),
            };
            // A line needs at least two points.
            let drawn = line.points.iter().filter(|point| point.error.is_finite()).count();
            chart.series(name, points, if drawn > 1 { Stroke::Marked } else { Stroke::Circles })
        })
    }
}

impl Report {
    /// Prints a panel, and keeps it for the files that [`Self::save`] writes.
    pub fn push(&mut self, panel: Panel) {
        panel.print();
        self.panels.push(panel);
    }

    /// Writes the table, a sheet of charts for each part, and a page that shows both.
    pub fn save(&self, name: &str) -> Result<(), Failure> {
        let mut table = String::from("part,question,method,setting,error,time_s\n");
        for panel in &self.panels {
            for line in &panel.lines {
                for p in &line.points {
                    let words = [panel.part, panel.title, &line.method, &p.setting].map(quoted).join(",");
                    writeln!(table, "{words},{:e},{:e}", p.error, p.time)?;
                }
            }
        }
        println!();
        support::save(&format!("{name}.csv"), &table)?;
        let mut page = String::from(HEAD);
        for part in self.panels.chunk_by(|a, b| a.part == b.part) {
            let charts: Vec<_> = part.iter().map(Panel::chart).collect();
            let sheet = Chart::sheet(&charts, charts.len())?;
            support::save(&format!("{name}_{}.svg", part[0].part), &sheet)?;
            write!(page, "<section>\n{sheet}\n")?;
            part.iter().try_for_each(|panel| panel.write_table(&mut page))?;
            page += "</section>\n";
        }
        page += "</body>\n</html>\n";
        support::save(&format!("{name}.html"), &page)?;
        Ok(())
    }
}

fn quoted(text: &str) -> String {
    format!("\"{text}\"")
}
