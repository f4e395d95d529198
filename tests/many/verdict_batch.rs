//! Every verdict in a batch agrees in all its columns with `Grasp::hold` of the single grasp, whichever method computes it.

use grasp_lcp::Settings;
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::hold::{LossVerb, ShortVerdict, VerdictKind};
use grasp_lcp::load_path::Ramp;
use grasp_lcp::{planar, spatial};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

type Row<const C: usize> = (Vec<Contact<C>>, [Wrench<C>; 2]);

/// Settings for verdicts that do not look beyond the whole load, like verdicts of screening.
fn up_to_the_load() -> Settings {
    Settings::default().with_most_load(1.0)
}

fn batch<const C: usize>(rows: &[Row<C>], settings: &Settings) -> Vec<Option<ShortVerdict>> {
    let row = |row: usize, contacts: &mut Vec<Contact<C>>| {
        contacts.extend(rows[row].0.iter().cloned());
        rows[row].1
    };
    Grasp::hold_batch(rows.len(), &row, settings).into_iter().map(Result::ok).collect()
}

/// Compares all columns of each row with the verdict of `Grasp::hold`, load factors up to the error of steps. Returns the number of rows for each
/// conclusion.
fn check<const C: usize>(rows: &[Row<C>], settings: &Settings) -> [usize; 7] {
    let mut count = [0; 7];
    for (number, (short, (contacts, [base, load]))) in batch(rows, settings).into_iter().zip(rows).enumerate()
    {
        let grasp = Grasp::new(contacts.iter().cloned());
        let verdict = grasp.and_then(|grasp| grasp.with(settings).hold(Ramp::load(*base, *load))).ok();
        let whole = verdict.as_ref().map(ShortVerdict::from);
        let (Some(short), Some(whole), Some(verdict)) = (short, whole, verdict) else {
            assert!(short.is_none() && whole.is_none(), "{number} {short:?} {whole:?}");
            continue;
        };
        let factors = |short: &ShortVerdict| [short.first_slip, short.everything_slides, Some(short.held_to)];
        for factors in factors(&short).into_iter().zip(factors(&whole)) {
            let close = match factors {
                (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * b,
                (a, b) => a == b,
            };
            assert!(close, "{number} {short:?} {whole:?}");
        }
        let mut same = short;
        same.first_slip = whole.first_slip;
        (same.everything_slides, same.held_to) = (whole.everything_slides, whole.held_to);
        assert_eq!(same, whole, "row {number}: {verdict}");
        // The words of the columns appear in the sentence.
        let words = verdict.to_string();
        let begins = match (short.holds(), short.motion) {
            _ if verdict.swing.is_some() => "SWINGS".to_owned(),
            (Some(true), _) => "HOLDS".to_owned(),
            (Some(false), Some(verb)) if short.how == VerdictKind::Lost => verb.to_string(),
            (Some(false), _) => "DOES NOT HOLD".to_owned(),
            (None, _) => "UNDECIDED".to_owned(),
        };
        assert!(words.starts_with(&begins), "{number} {begins} {words}");
        count[short.how as usize] += 1;
    }
    count
}

/// Fingers around a ball with inaccurate normals and random friction, squeeze and load. A few contacts have unusual data.
fn fingers<const C: usize>(random: &mut Random, count: usize) -> Row<C> {
    let mut contacts = Vec::new();
    let load_size = 10.0_f64.powf(1.0 + random.signed());
    for k in 0..count {
        let angle = std::f64::consts::TAU * k as f64 / count as f64 + 0.2 * random.signed();
        let mut point = [0.0; C];
        (point[0], point[1]) = (0.04 * angle.cos(), 0.04 * angle.sin());
        point[C - 1] += 0.01 * random.signed();
        let mut normal = point.map(|x| -x);
        normal[C - 1] += 0.01 * random.signed();
        let mut contact = Contact::new(point, normal)
            .series_stiffness(1e3, 8e2 + 4e2 * random.signed())
            .friction(0.5 + 0.4 * random.signed())
            .pressed_with(10.0 + 5.0 * random.signed());
        contact = match random.index(0, 29) {
            0 => contact.kept_closed(),
            1 => contact.bonded(),
            2 => contact.clearance(0.002),
            3 => contact.kinetic(0.05),
            4 => contact.friction(0.0),
            5 => contact.friction(f64::INFINITY),
            _ => contact,
        };
        contacts.push(contact);
    }
    let mut force = |size: f64| {
        let mut components = vec![0.0; 3 * (C - 1)];
        components[..C].fill_with(|| size * random.signed());
        Wrench::from_components(&components)
    };
    let load = force(load_size);
    let base = force(load_size);
    let base = if random.uniform() < 0.3 { base * 0.1 } else { Wrench::ZERO };
    (contacts, [base, load])
}

fn random_fingers<const C: usize>(seed: u64) {
    let mut random = seeded(seed);
    let mut all = [0; 7];
    for count in 2..=6 {
        let rows: Vec<Row<C>> = (0..samples(60)).map(|_| fingers(&mut random, count)).collect();
        let found = check(&rows, &up_to_the_load());
        (0..7).for_each(|k| all[k] += found[k]);
    }
    let [sticks, slides, _, lost, ..] = all;
    assert_met(&[(sticks, 30), (slides, 5), (lost, 30)]);
}

#[test]
fn random_fingers_in_the_plane() {
    random_fingers::<2>(31);
}

#[test]
fn random_fingers_in_space() {
    random_fingers::<3>(32);
}

/// Fingers whose contacts slide one after another before the load is lost or acts in full. The fast method whose unknowns are the slips computes most
/// of these rows.
fn sliding_fingers<const C: usize>(random: &mut Random, count: usize) -> Row<C> {
    let stiffness = 10.0_f64.powf(4.0 + random.signed());
    let mut contacts = Vec::new();
    for k in 0..count {
        let angle = std::f64::consts::TAU * k as f64 / count as f64 + 0.3 * random.signed();
        let mut point = [0.0; C];
        (point[0], point[1]) = (0.04 * angle.cos(), 0.04 * angle.sin());
        let mut normal = point.map(|x| -x);
        point[C - 1] += 0.015 * random.signed();
        normal[C - 1] += 0.01 * random.signed();
        let contact =
            Contact::new(point, normal).series_stiffness(stiffness, stiffness * random.between(0.3, 1.2));
        contacts.push(contact.friction(random.between(0.2, 0.9)).pressed_with(random.between(8.0, 12.0)));
    }
    let mut components = vec![0.0; 3 * (C - 1)];
    components[..C].fill_with(|| random.signed());
    components[C..].fill_with(|| 0.02 * random.signed());
    let load = Wrench::from_components(&components);
    let onset =
        Grasp::new(contacts.iter().cloned()).and_then(|grasp| grasp.onset(Ramp::load(Wrench::ZERO, load)));
    let factor = onset.ok().and_then(|onset| onset.factor()).unwrap_or(1.0);
    (contacts, [Wrench::ZERO, load * (factor * random.between(0.9, 3.0))])
}

fn sliding<const C: usize>(seed: u64) {
    let mut random = seeded(seed);
    let [mut held, mut lost] = [0; 2];
    for count in 2..=5 {
        let rows: Vec<Row<C>> = (0..samples(20)).map(|_| sliding_fingers(&mut random, count)).collect();
        for settings in [up_to_the_load(), Settings::default()] {
            let found = check(&rows, &settings);
            (held, lost) =
                (held + found[VerdictKind::Slides as usize], lost + found[VerdictKind::Lost as usize]);
        }
    }
    assert_met(&[(held, 30), (lost, 40)]);
}

#[test]
fn fingers_that_slide_in_the_plane() {
    sliding::<2>(35);
}

#[test]
fn fingers_that_slide_in_space() {
    sliding::<3>(36);
}

/// Symmetric, degenerate and extreme rows: ties, free motions, no load, loose objects, objects lost at rest, far motions, and numbers out of range.
#[test]
fn odd_rows() {
    let jaw = |x: f64, mu: f64, force: f64| {
        spatial::Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0])
            .series_stiffness(1e3, 8e2)
            .friction(mu)
            .pressed_with(force)
    };
    let jaws = |mu: f64, force: f64| vec![jaw(-0.03, mu, force), jaw(0.03, mu, force)];
    let tip = spatial::SoftFingertip::ring(0.005, 4).unwrap();
    let pads = |mu: f64, force: f64| {
        let both = jaws(mu, force);
        both.iter().flat_map(|jaw| tip.contacts(jaw).unwrap_or_default()).collect::<Vec<_>>()
    };
    let down = |force: f64| spatial::Wrench::force([0.0, 0.0, -force]);
    let turned = |moment: [f64; 3]| spatial::Wrench::new([0.0; 3], moment);
    let none = spatial::Wrench::ZERO;
    let mut rows: Vec<Row<3>> = Vec::new();
    for load in [down(4.0), down(10.0), down(12.0), turned([0.01, 0.0, 0.0]), turned([0.0, 0.1, 0.0]), none] {
        for base in [none, down(1.0), down(11.0)] {
            let all = [(0.5, 10.0), (0.5, 0.0), (0.0, 10.0), (f64::INFINITY, 10.0), (f64::NAN, 10.0)];
            rows.extend(all.map(|(mu, force)| (jaws(mu, force), [base, load])));
        }
    }
    for load in [down(4.0), turned([0.01, 0.0, 0.0]), none] {
        rows.extend([(0.5, 10.0), (0.5, 0.0)].map(|(mu, force)| (pads(mu, force), [none, load])));
    }
    // Soft pads, which turn far while everything sticks.
    for moment in [0.001, 0.004, 0.008] {
        rows.push((pads(5.0, 10.0), [none, turned([moment * 10.0, 0.0, 0.0])]));
    }
    let bonded =
        |x: f64| spatial::Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0]).series_stiffness(1e3, 8e2).bonded();
    rows.push((vec![bonded(-0.1), bonded(0.1)], [none, none]));
    rows.push((vec![bonded(-0.1), bonded(0.1)], [none, down(1.0)]));
    rows.push((vec![jaw(0.03, 0.5, 10.0)], [none, down(1.0)]));
    rows.push((vec![], [none, down(1.0)]));
    rows.push((jaws(0.5, 10.0), [none, down(f64::NAN)]));
    let found = check(&rows, &up_to_the_load());
    assert!(found[VerdictKind::Sticks as usize] > 10 && found[VerdictKind::Lost as usize] > 5, "{found:?}");
    assert!(found[VerdictKind::NoRest as usize] + found[VerdictKind::LostAtRest as usize] > 5, "{found:?}");
    // A batch of pads alone is screened. Where nothing presses and no load acts, the object lies loose.
    let of_pads = [(0.0, none), (0.0, down(4.0)), (10.0, none), (10.0, down(4.0))];
    let found = check(&of_pads.map(|(force, load)| (pads(0.5, force), [none, load])), &up_to_the_load());
    assert_eq!(found[VerdictKind::Loose as usize], 1, "{found:?}");
    // Verdicts beyond the whole load, and on a polygon, are not screened.
    check(&rows, &Settings::default());
    check(&rows, &up_to_the_load().on_the_polygon());
}

/// In a batch, pads of sixteen points hold 2 μ N along their faces, as by the closed form.
#[test]
fn a_parallel_jaw_with_pads_is_answered() {
    let tip = spatial::SoftFingertip::disc(0.006, 1, 8, spatial::Pressure::Uniform).unwrap();
    let rows: Vec<Row<3>> = (0..40)
        .map(|k| {
            let (mu, force) = (0.2 + 0.02 * f64::from(k), 5.0 + f64::from(k));
            let jaw = |x: f64| {
                let jaw = spatial::Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0]).series_stiffness(2e4, 1e4);
                tip.contacts(&jaw.friction(mu).pressed_with(force)).unwrap()
            };
            (
                [jaw(-0.03), jaw(0.03)].concat(),
                [Wrench::ZERO, spatial::Wrench::force([0.0, 0.0, -1.6 * mu * force])],
            )
        })
        .collect();
    for short in batch(&rows, &up_to_the_load()) {
        let short = short.unwrap();
        assert_eq!(short.how, VerdictKind::Sticks);
        assert!((short.first_slip.unwrap() - 1.25).abs() < 1e-9, "{short:?}");
    }
}

#[test]
fn threads_do_not_change_a_bit() {
    let mut random = seeded(33);
    let rows: Vec<Row<2>> = (0..1200).map(|_| fingers(&mut random, 3)).collect();
    let bits = |short: &Option<ShortVerdict>| format!("{short:?}");
    let all: Vec<_> = batch(&rows, &up_to_the_load()).iter().map(bits).collect();
    #[cfg(feature = "parallel")]
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let some: Vec<_> = pool.install(|| batch(&rows, &up_to_the_load())).iter().map(bits).collect();
        assert_eq!(some, all);
    }
    // Other rows of the batch, in another order, do not change a bit either.
    let backwards: Vec<_> = rows.iter().rev().cloned().collect();
    assert!(batch(&backwards, &up_to_the_load()).iter().rev().map(bits).eq(all));
}

#[test]
fn jaws_slip_out_of_the_plane() {
    let jaw = |x: f64| {
        planar::Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(10.0)
    };
    let row = |load: f64| (vec![jaw(-0.03), jaw(0.03)], [Wrench::ZERO, planar::Wrench::force([0.0, -load])]);
    let found = batch(&[row(8.0), row(12.0)], &up_to_the_load());
    let (held, lost) = (found[0].unwrap(), found[1].unwrap());
    assert_eq!(held.how, VerdictKind::Sticks);
    assert!((held.first_slip.unwrap() - 1.25).abs() < 1e-14);
    assert_eq!((lost.how, lost.motion), (VerdictKind::Lost, Some(LossVerb::SlipsOut)));
    assert!((lost.held_to - 10.0 / 12.0).abs() < 1e-14);
}
