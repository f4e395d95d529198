//! Typical values of friction and stiffness, each with its source.

use std::io::{self, Write};

const VALUES_HEAD: &str = "\
What is not known is best measured: tilt the object on the pad until it slides, at the angle θ: μ = tan θ. Where that cannot be done, these are ordinary
values to begin with; dust, moisture and age change friction by more than any table tells. `need` says how much friction it takes.";

const VALUES_FOOT: &str = "\
Springs in series add their compliances, 1/k: of pad, finger and mechanism the softest counts. Of a bellows or a clamp it is force over stroke
in its data sheet.";

/// Prints every value as a range with its unit and the material or part that has it. A number refers to the list of sources at the
/// end.
pub(crate) fn print(out: &mut dyn Write) -> io::Result<()> {
    let lines = || {
        include_str!("values.tsv")
            .lines()
            .filter(|line| !line.starts_with('#'))
            .map(|line| line.split('\t').collect::<Vec<_>>())
    };
    let sources: Vec<_> = lines().filter(|line| line[0] == "source").collect();
    writeln!(out, "{VALUES_HEAD}")?;
    let titles = [
        ("friction", "Coefficient of friction, static"),
        ("kinetic", "Friction once it slides (kinetic_friction), as a part of that at rest"),
        ("stiffness", "Stiffness"),
    ];
    for (quantity, title) in titles {
        writeln!(out, "\n{title}")?;
        for line in lines().filter(|line| line[0] == quantity) {
            let [what, from, to, unit, source] = line[1..] else { continue };
            let range = if from == to { from.to_owned() } else { format!("{from} to {to}") };
            let number = sources.iter().position(|known| known[1] == source).map_or(0, |at| at + 1);
            let range = format!("{range} {unit}");
            writeln!(out, "  {:20} {what} [{number}]", range.trim_end())?;
        }
    }
    writeln!(out, "\n{VALUES_FOOT}\n")?;
    for (number, source) in sources.iter().enumerate() {
        writeln!(out, "[{}] {}", number + 1, source[2])?;
    }
    Ok(())
}
