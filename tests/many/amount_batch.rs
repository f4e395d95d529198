//! Needed amounts in a batch agree with `Grasp::need` of each grasp, and with closed forms.

use grasp_lcp::Settings;
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::need::{Demand, Need, Quantity, ShortAmount};
use grasp_lcp::planar;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

type Row = (Vec<Contact<2>>, [Wrench<2>; 2]);

fn batch(rows: &[Row], asked: (Quantity, Demand)) -> Vec<Option<ShortAmount>> {
    let row = |row: usize, contacts: &mut Vec<Contact<2>>| {
        contacts.extend(rows[row].0.iter().cloned());
        rows[row].1
    };
    Grasp::need_batch(rows.len(), &row, asked, &Settings::default()).into_iter().map(Result::ok).collect()
}

fn jaw(x: f64, mu: f64) -> planar::Contact {
    planar::Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e4, 8e3).friction(mu).pressed_with(10.0)
}

const ALL: [(Quantity, Demand); 4] = [
    (Quantity::Squeeze, Demand::Held),
    (Quantity::Squeeze, Demand::Sticks),
    (Quantity::Load, Demand::Held),
    (Quantity::Load, Demand::Sticks),
];

/// Two jaws hold 2 μ N for every tangential direction of the load. This gives the largest load and the least squeeze.
#[test]
fn jaws_need_what_the_closed_form_says() {
    let rows: Vec<Row> = (1..30)
        .map(|k| {
            let (mu, load) = (0.1 + 0.02 * f64::from(k), 0.7 * f64::from(k));
            (vec![jaw(-0.03, mu), jaw(0.03, mu)], [Wrench::ZERO, planar::Wrench::force([0.0, -load])])
        })
        .collect();
    for asked in ALL {
        for (found, (k, _)) in batch(&rows, asked).into_iter().zip((1..30).zip(&rows)) {
            let carried = 20.0 * (0.1 + 0.02 * f64::from(k)) / (0.7 * f64::from(k));
            let exact = if asked.0 == Quantity::Squeeze { 1.0 / carried } else { carried };
            let found = found.unwrap().bound().unwrap();
            assert!((found / exact - 1.0).abs() < 1e-9, "{asked:?} {k} {found} {exact}");
        }
    }
}

/// Three planar fingers with random forces and moments, some with a load at rest, a clearance or kinetic friction.
fn fingers(random: &mut Random) -> Row {
    let mut contacts = Vec::new();
    for k in 0..3 {
        let angle = 2.0 * f64::from(k) + 0.3 * random.signed();
        let (sin, cos) = angle.sin_cos();
        let contact = planar::Contact::new([0.04 * cos, 0.04 * sin], [-cos, -sin])
            .series_stiffness(2e4, 1e4)
            .friction(random.between(0.2, 0.9))
            .pressed_with(random.between(5.0, 15.0));
        contacts.push(match random.index(0, 12) {
            0 => contact.clearance(1e-5),
            1 => contact.kinetic(0.15),
            _ => contact,
        });
    }
    let size = 8.0;
    let load = planar::Wrench::new([size * random.signed(), size * random.signed()], 0.05 * random.signed());
    let base = if random.uniform() < 0.2 { load * -0.1 } else { Wrench::ZERO };
    (contacts, [base, load])
}

#[test]
fn amounts_are_those_of_single_grasps() {
    let mut random = seeded(34);
    let rows: Vec<Row> = (0..samples(12)).map(|_| fingers(&mut random)).collect();
    let (mut bounds, mut others) = (0, 0);
    for asked in ALL {
        for (number, (found, (contacts, [base, load]))) in
            batch(&rows, asked).into_iter().zip(&rows).enumerate()
        {
            let need = if asked.0 == Quantity::Squeeze { Need::squeeze(*load) } else { Need::load(*load) };
            let need = if asked.1 == Demand::Sticks { need.to_stick() } else { need.to_hold() };
            let need = need.on_top_of(*base);
            let whole = Grasp::new(contacts.iter().cloned()).unwrap().need(&need).unwrap().amount;
            let (found, whole) = (found.unwrap(), ShortAmount::from(&whole));
            if let (Some(a), Some(b)) = (found.bound(), whole.bound()) {
                assert!((a / b - 1.0).abs() < 1e-8, "{asked:?} row {number}: {a} {b}");
                bounds += 1;
            } else {
                assert_eq!(found, whole, "{asked:?} row {number}");
                others += 1;
            }
        }
    }
    println!("{bounds} {others}");
    assert_met(&[(bounds, 20)]);
}

/// Rows with a base load, with malformed contacts or with other questions are computed by the general method. An error belongs to its own row.
#[test]
fn errors_are_of_their_row() {
    let good = || vec![jaw(-0.03, 0.5), jaw(0.03, 0.5)];
    let load = planar::Wrench::force([0.0, -1.0]);
    let rows = vec![
        (good(), [Wrench::ZERO, load]),
        (vec![jaw(-0.03, f64::NAN), jaw(0.03, 0.5)], [Wrench::ZERO, load]),
        (good(), [Wrench::ZERO, planar::Wrench::force([f64::NAN, 0.0])]),
        (good(), [Wrench::ZERO, load]),
    ];
    for asked in ALL {
        let found = batch(&rows, asked);
        assert_eq!(
            found.iter().map(Option::is_some).collect::<Vec<_>>(),
            [true, false, false, true],
            "{asked:?}"
        );
        assert_eq!(found[0], found[3]);
    }
    assert!(batch(&rows, (Quantity::Friction, Demand::Held)).iter().all(Option::is_none));
}

/// A bar resists turning with 2 k a² = 10 N m, of which fingers that press with N take 2 N a: before the load acts, it buckles from 100 N on. To hold
/// the weight W, the fingers need N = W / 2 μ = 10 W.
#[test]
fn squeezes_that_buckle_the_grasp_are_none() {
    let (half, stiffness, mu) = (0.05, 2e3, 0.05);
    let finger = |x: f64| {
        let finger = planar::Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e5, stiffness);
        finger.friction(mu).pressed_with(20.0)
    };
    let weights = [5.0, 9.9, 10.1, 20.0];
    let load = |weight: f64| planar::Wrench::force_at([0.0, -weight], [0.0, -0.1]);
    let rows: Vec<Row> =
        weights.iter().map(|w| (vec![finger(-half), finger(half)], [Wrench::ZERO, load(*w)])).collect();
    for (found, weight) in batch(&rows, (Quantity::Squeeze, Demand::Held)).into_iter().zip(weights) {
        let press = weight / (2.0 * mu);
        let buckles = press * half > stiffness * half * half;
        match found {
            Some(ShortAmount::Bound(times)) if !buckles => {
                assert!((20.0 * times / press - 1.0).abs() < 1e-6, "{weight} {times}");
            }
            found => assert_eq!((found, buckles), (Some(ShortAmount::None), true), "{weight}"),
        }
    }
}
