//! The search for an equilibrium tries several methods in turn, its rungs. How often does each rung decide, in which time, and which others could?
//!
//! Everyday and unusual scenes, load paths and bodies come from the generators of the tests. After each decision every rung is tried separately.
//!
//! `cargo run --release -p reports --bin rungs [scenes of each family]` (40 by default)

mod families;

use std::collections::BTreeMap;

use grasp_lcp::record::{RecordedSearch, RungResult, names, recorded};

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let each = std::env::args().nth(1).map_or(Ok(40), |text| text.parse::<usize>())?;
    let mut climbs: BTreeMap<&str, Vec<RecordedSearch>> = BTreeMap::new();
    families::ask_all(each, &mut |family, question| {
        let (answer, mut recorded) = recorded(question);
        climbs.entry(family).or_default().append(&mut recorded);
        answer.map(drop)
    })?;
    by_family(&climbs);
    let all: Vec<_> = climbs.into_values().flatten().collect();
    by_rung(&all);
    instead(&all);
    Ok(())
}

/// Prints, for each family, the number of searches that each rung decides.
fn by_family(climbs: &BTreeMap<&str, Vec<RecordedSearch>>) {
    println!("Searches that go beyond the elastic trial, by the rung that decides:\n");
    print!("{:<28}", "");
    for name in names() {
        print!("{:>12}", short(name));
    }
    println!("{:>12}", "undecided");
    for (family, climbs) in climbs {
        let count = |rung: Option<usize>| climbs.iter().filter(|climb| climb.decided == rung).count();
        print!("{family:<28}");
        for rung in 0..names().len() {
            print!("{:>12}", count(Some(rung)));
        }
        println!("{:>12}", count(None));
    }
}

/// Prints, for each rung, how often it decides, how often it would decide if it were tried alone, and its run times.
fn by_rung(climbs: &[RecordedSearch]) {
    println!(
        "\n{:<28}{:>9}{:>9}{:>9}{:>9}{:>9}{:>12}{:>12}",
        "", "decides", "finds", "proves", "could", "tried", "median µs", "longest µs"
    );
    for (rung, name) in names().into_iter().enumerate() {
        let decided = climbs.iter().filter(|climb| climb.decided == Some(rung));
        let made = |made: RungResult| climbs.iter().filter(|climb| climb.rungs[rung].0 == made).count();
        let of = |kind: RungResult| decided.clone().filter(|climb| climb.rungs[rung].0 == kind).count();
        let [found, proved] = [of(RungResult::Found), of(RungResult::Proved)];
        let tried = climbs.len() - made(RungResult::Untried);
        let mut times: Vec<_> = decided.map(|climb| 1e6 * climb.rungs[rung].1).collect();
        times.sort_by(f64::total_cmp);
        let median = times.get(times.len() / 2).copied().unwrap_or(f64::NAN);
        let longest = times.last().copied().unwrap_or(f64::NAN);
        let could = made(RungResult::Found) + made(RungResult::Proved);
        println!(
            "{name:<28}{:>9}{found:>9}{proved:>9}{could:>9}{tried:>9}{median:>12.1}{longest:>12.1}",
            found + proved
        );
    }
}

/// Prints, for each rung, which later rung would decide its searches if this rung were left out, and by which factor these searches would take
/// longer.
fn instead(climbs: &[RecordedSearch]) {
    println!("\nWithout a rung, its searches are decided by others, in more time by this factor (median):\n");
    for (rung, name) in names().into_iter().enumerate() {
        let mut others: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
        for climb in climbs.iter().filter(|climb| climb.decided == Some(rung)) {
            let decides =
                |other: &usize| matches!(climb.rungs[*other].0, RungResult::Found | RungResult::Proved);
            let other = (rung + 1..climb.rungs.len()).find(decides);
            let time = |to: usize| climb.rungs[rung + 1..=to].iter().map(|(_, time)| time).sum::<f64>();
            let factor = other.map_or(f64::NAN, |other| time(other) / climb.rungs[rung].1);
            others.entry(other.map_or("none", |other| names()[other])).or_default().push(factor);
        }
        let said = others.into_iter().map(|(other, mut factors)| {
            factors.sort_by(f64::total_cmp);
            format!("{other} {} (×{:.2})", factors.len(), factors[factors.len() / 2])
        });
        println!("{name:<28}{}", said.collect::<Vec<_>>().join(", "));
    }
}

/// A short name for the head of a column.
fn short(name: &str) -> String {
    name.split(' ').map(|word| word.chars().take(5).collect::<String>()).take(2).collect::<Vec<_>>().join(" ")
}
