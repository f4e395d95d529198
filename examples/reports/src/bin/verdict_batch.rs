//! How many verdicts, onsets of pads and needed amounts do batches compute a second, and do they equal those of single grasps?
//!
//! `cargo run --release -p reports --bin verdict_batch [how many] [how many needed amounts are compared]`
//!
//! Three fingers on a bottle and parallel jaws with pads of sixteen points, under loads from light to too heavy. Rates are those of
//! all cores, the best of several runs. For at most 10 000 rows of each batch the outcome is compared with that of the single grasp, and the factors,
//! which must agree within 1e-9; so are three needed amounts, each of which takes some ten milliseconds.

use grasp_lcp::Settings;
use grasp_lcp::hold::{ShortVerdict, VerdictKind};
use grasp_lcp::need::{Demand, Quantity, ShortAmount};
use grasp_lcp::spatial::{Contact, Grasp, Need, PointBatch, Pressure, Pull, Ramp, SoftFingertip, Wrench};
use support::Failure;
use support::best_time::timed;

type Row<'a> = &'a (dyn Fn(usize, &mut Vec<Contact>) -> [Wrench; 2] + Sync);

fn main() -> Result<(), Failure> {
    let number =
        |place, default| std::env::args().nth(place).map_or(Ok(default), |count| count.parse::<usize>());
    let (count, compared) = (number(1, 100_000)?, number(2, 3)?);
    println!(
        "family                load       rows     verdicts a second   sticks   other   compared   differ"
    );
    for load in [0.3, 1.0, 2.0] {
        report("triples in space", load, &|row, contacts| triple(row, load, contacts), count)?;
    }
    // Where contacts slide, each row takes longer, so that there are fewer rows.
    report("triples in space", 3.0, &|row, contacts| triple(row, 3.0, contacts), count / 10)?;
    report("triples in space", 10.0, &|row, contacts| triple(row, 10.0, contacts), count / 20)?;
    let tip = SoftFingertip::disc(0.006, 1, 8, Pressure::Uniform)?;
    for load in [0.2, 0.4] {
        report("jaws with pads of 16", load, &|row, contacts| jaws(&tip, row, load, contacts), count / 10)?;
    }
    report("jaws with pads of 16", 0.8, &|row, contacts| jaws(&tip, row, 0.8, contacts), count / 1000)?;
    pads(&tip, count / 10)?;
    for (demand, count) in [(Demand::Held, count / 10), (Demand::Sticks, count)] {
        for quantity in [Quantity::Squeeze, Quantity::Load] {
            amounts((quantity, demand), [count, compared])?;
        }
    }
    Ok(())
}

/// Three fingers around a bottle.
fn triple(row: usize, load: f64, contacts: &mut Vec<Contact>) -> [Wrench; 2] {
    let z = |datum: usize| 0.02 * (number(row, datum) - 0.5);
    let y = |datum: usize| 0.03 + 0.01 * number(row, datum);
    let friction = 0.3 + 0.4 * number(row, 0);
    for p in [[-0.04, 0.0, z(1)], [0.02, y(2), z(3)], [0.02, -y(4), z(5)]] {
        let finger = Contact::new(p, [-p[0], -p[1], 0.0]).series_stiffness(9e2, 6e2);
        contacts.push(finger.friction(friction).command([0.006, 0.0, 0.0]));
    }
    [Wrench::ZERO, Wrench::force([0.1, 0.2, -1.0]) * load]
}

/// Two jaws with the pads `tip`; the weight acts beside the line through both jaws.
fn jaws(tip: &SoftFingertip, row: usize, load: f64, contacts: &mut Vec<Contact>) -> [Wrench; 2] {
    for (x, datum) in [(-0.03, 0), (0.03, 1)] {
        let jaw = Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0]).series_stiffness(2e4, 1e4);
        let jaw = jaw.friction(0.3 + 0.4 * number(row, 2)).pressed_with(10.0 + 0.1 * number(row, datum));
        contacts.extend(tip.contacts(&jaw).unwrap_or_default());
    }
    let down = -10.0 * load;
    [Wrench::ZERO, Wrench::new([0.0, 0.0, down], [0.0, 0.003 * down * number(row, 3), 0.0])]
}

/// A reproducible number between 0 and 1 for each quantity of each row.
fn number(row: usize, datum: usize) -> f64 {
    ((row as f64 + 1.0) * 0.618_033_988_749_894_9 + datum as f64 * 0.137).fract()
}

fn report(family: &str, load: f64, row: Row<'_>, count: usize) -> Result<(), Failure> {
    let settings = Settings::default().with_most_load(1.0);
    let (verdicts, seconds) = timed(|| Ok(Grasp::hold_batch(count, row, &settings)))?;
    let verdicts: Vec<ShortVerdict> = verdicts.into_iter().collect::<Result<_, _>>()?;
    let sticks = verdicts.iter().filter(|verdict| verdict.how == VerdictKind::Sticks).count();
    let (compared, mut differ) = (count.min(10_000), 0);
    for (number, short) in verdicts.iter().enumerate().take(compared) {
        let mut contacts = Vec::new();
        let [base, load] = row(number, &mut contacts);
        let whole = ShortVerdict::from(&Grasp::new(contacts)?.with(&settings).hold(Ramp::load(base, load))?);
        let factors = |short: &ShortVerdict| [short.first_slip, short.everything_slides, Some(short.held_to)];
        let close = factors(short).into_iter().zip(factors(&whole)).all(|factors| match factors {
            (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * b,
            (a, b) => a == b,
        });
        let words = |short: &ShortVerdict| (short.how, short.motion, short.doubt);
        differ += usize::from(!close || words(short) != words(&whole));
    }
    let pace = count as f64 / seconds;
    let other = count - sticks;
    println!("{family:20} {load:5} {count:10} {pace:21.0} {sticks:8} {other:7} {compared:10} {differ:8}");
    Ok(())
}

/// Times onsets of grasps with pads on one thread: with the preparation of the batch, and without it.
fn pads(tip: &SoftFingertip, count: usize) -> Result<(), Failure> {
    let made = || {
        let (mut batch, mut pulls, mut points) =
            (PointBatch::with_capacity(32, count), Vec::new(), Vec::new());
        for row in 0..count {
            points.clear();
            let [base, load] = jaws(tip, row, 0.4, &mut points);
            if batch.push(&points) {
                pulls.push(Pull::new(&base, &load)?);
            }
        }
        Ok((batch, pulls))
    };
    let ((batch, pulls), making) = timed(made)?;
    let (onsets, asking) = timed(|| Ok(batch.own_onsets(pulls.clone())))?;
    let mut off = 0.0_f64;
    for row in 0..count.min(1000) {
        let mut points = Vec::new();
        let [base, load] = jaws(tip, row, 0.4, &mut points);
        let whole = Grasp::new(points)?.onset(Ramp::load(base, load))?.factor().unwrap_or(f64::NAN);
        off = off.max((onsets[row].factor().unwrap_or(f64::NAN) / whole - 1.0).abs());
    }
    println!(
        "\nonsets of jaws with pads of 16, one thread: {:.0} a second, {:.0} with the making; largest difference {off:.0e}\n",
        count as f64 / asking,
        count as f64 / (asking + making)
    );
    Ok(())
}

/// Prints how many needed amounts, such as least squeezes, a batch of three-finger grasps computes in a second.
fn amounts(asked: (Quantity, Demand), [count, compared]: [usize; 2]) -> Result<(), Failure> {
    let row = |row: usize, contacts: &mut Vec<Contact>| triple(row, 1.0, contacts);
    let settings = Settings::default();
    let (found, seconds) = timed(|| Ok(Grasp::need_batch(count, &row, asked, &settings)))?;
    let pace = count as f64 / seconds;
    let (mut off, mut differ) = (0.0_f64, 0);
    for (number, short) in Grasp::need_batch(compared, &row, asked, &settings).into_iter().enumerate() {
        let mut contacts = Vec::new();
        let [_, load] = row(number, &mut contacts);
        let need = if asked.0 == Quantity::Squeeze { Need::squeeze(load) } else { Need::load(load) };
        let need = if asked.1 == Demand::Sticks { need.to_stick() } else { need.to_hold() };
        let whole = ShortAmount::from(&Grasp::new(contacts)?.need(&need.with_scan(0))?.amount);
        match (short?, whole) {
            (ShortAmount::Bound(a), ShortAmount::Bound(b)) => off = off.max((a / b - 1.0).abs()),
            (short, whole) => differ += usize::from(short != whole),
        }
    }
    println!(
        "{:?} for {:?}: {pace:.0} amounts a second of {}; {compared} compared, {differ} of another kind, largest difference {off:.0e}",
        asked.0,
        asked.1,
        found.len()
    );
    Ok(())
}
