//! The onset of sliding of small grasps, while a load grows or turns, and the least squeeze: one at a time, in batches, and the first also without
//! this crate.

use std::hint::black_box;

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::Ramp;
use grasp_lcp::screening::{Batch, Fingers, LoadCases, Pull};
use grasp_lcp::squeeze::Loads;
use grasp_lcp::sweep::onsets_of_batch;
use grasp_lcp::{planar, spatial};

use crate::Outcome;
use crate::limits::{Cores, Limit, Needs};
use support::best_time::best;

use crate::report::{Beside, row};
use crate::today::bisected_onset;
use support::patches::uneven;

/// Number of grasps in a family, so small that their data fit into the processor's caches.
const GRASPS: usize = 4000;

pub fn rows() -> Outcome {
    family::<2, 2>("a planar pair", pair, &planar::Wrench::new([0.2, -1.0], 0.1))?;
    family::<2, 3>("3 contacts in the plane", ring_in_the_plane, &planar::Wrench::new([0.2, -1.0], 0.1))?;
    let pull = spatial::Wrench::new([0.2, 0.1, -1.0], [0.05, 0.1, 0.02]);
    family::<3, 3>("3 contacts in space", ring, &pull)?;
    family::<3, 4>("4 contacts in space", ring, &pull)?;
    family::<3, 5>("5 contacts in space", ring, &pull)
}

fn family<const C: usize, const N: usize>(
    name: &str,
    contacts: impl Fn(usize) -> [Contact<C>; N],
    direction: &Wrench<C>,
) -> Outcome {
    let scenes: Vec<_> = (0..GRASPS).map(contacts).collect();
    let pull = Pull::new(&Wrench::ZERO, direction)?;
    let fingers: Vec<_> = scenes.iter().map(Fingers::<C, N>::new).collect::<Result<_, _>>()?;
    let mut batch = Batch::with_capacity(GRASPS);
    for grasp in &fingers {
        batch.push(grasp);
    }

    let each = 1.0 / GRASPS as f64;
    let ready = each
        * best(|| {
            for scene in &scenes {
                black_box(Fingers::<C, N>::new(black_box(scene)).is_ok());
            }
        });
    let alone = each
        * best(|| {
            for grasp in &fingers {
                black_box(black_box(grasp).onset(&pull));
            }
        });
    let mut answers = Vec::new();
    let together = each * best(|| batch.onsets_into(black_box(&[pull]), &mut answers));
    let mut all = Vec::new();
    let mut many = Batch::with_capacity(10 * GRASPS);
    for grasp in (0..10).flat_map(|_| &fingers) {
        many.push(grasp);
    }
    let on_all_cores = each / 10.0
        * best(|| {
            onsets_of_batch(&many, black_box(&[pull]), &mut all);
        });

    let loads = [pull; 16];
    let of_many_loads = each / 160.0
        * best(|| {
            onsets_of_batch(&many, black_box(&loads), &mut all);
        });

    let ramp = Ramp::load(Wrench::ZERO, *direction);
    // Only grasps whose contacts all stick without a load have an onset.
    let sticking = scenes.iter().zip(&answers).filter_map(|(scene, answer)| Some((scene, answer.factor()?)));
    let few: Vec<_> = sticking.take(100).collect();
    let grasps: Vec<_> =
        few.iter().map(|(scene, _)| Grasp::new(scene.iter().cloned())).collect::<Result<_, _>>()?;
    let mut off = 0.0_f64;
    let whole = best(|| {
        for (grasp, (_, factor)) in grasps.iter().zip(&few) {
            if let Ok(onset) = grasp.onset(&ramp) {
                off = onset.factor().map_or(f64::NAN, |exact| off.max((factor / exact - 1.0).abs()));
            }
        }
    }) / few.len() as f64;
    let mut found = 0.0;
    let today = best(|| found = bisected_onset(&grasps[0], direction));
    let bisected = (found / few[0].1 - 1.0).abs();

    row(&format!("making ready {name}, with its validation"), ready, Beside::NOTHING, "");
    let beside = Beside { in_general: whole, today, ..Beside::NOTHING };
    row(
        &format!("onset of {name}, one at a time"),
        alone,
        beside,
        &format!("off Grasp::onset by {off:.0e}, the bisection by {bisected:.0e}"),
    );
    let batch_row = |how: &str, time: f64, needs: &Needs| {
        let beside = Beside { limit: Limit::of(needs), ..beside };
        row(
            &format!("onset of {name}, {how}"),
            time,
            beside,
            &format!("{:.1} million a second", 1e-6 / time),
        );
    };
    batch_row("batch on one thread", together, &needs::<C, N>(1.0, GRASPS, Cores::One));
    batch_row("batch on all cores", on_all_cores, &needs::<C, N>(1.0, 10 * GRASPS, Cores::All));
    let of_many = needs::<C, N>(16.0, 10 * GRASPS, Cores::All);
    batch_row("batch of 16 loads each, all cores", of_many_loads, &of_many);
    squeezes(name, (&fingers, &batch), &grasps, direction)
}

/// Bytes and operations for the onset under one of several loads, in a batch of `grasps` grasps. Operations are counted in the formulas of the module
/// `screening`: those that prepare a grasp, and those for a load that starts at zero.
fn needs<const C: usize, const N: usize>(loads: f64, grasps: usize, cores: Cores) -> Needs {
    let n = N as f64;
    let (ready, load) = match (C, N) {
        (2, 2) => (57.0, 94.0),
        (2, _) => (90.0 * n + 66.0, 55.0 * n + 49.0),
        (_, 3) => (255.0, 457.0),
        _ => (197.0 * n + 212.0, 140.0 * n + 117.0),
    };
    let data = 8.0 * (n * (3.0 * C as f64 + 4.0) + 3.0);
    let answer = 16.0;
    Needs {
        bytes: data / loads + answer,
        among: grasps as f64 * (data + loads * answer),
        operations: ready / loads + load,
        cores,
    }
}

/// Prints run times of the least squeeze under two loads.
fn squeezes<const C: usize, const N: usize>(
    name: &str,
    (fingers, batch): (&[Fingers<C, N>], &Batch<C, N>),
    grasps: &[Grasp<C>],
    direction: &Wrench<C>,
) -> Outcome {
    let loads = vec![*direction * 8.0, *direction * -2.0];
    let cases = [LoadCases::new(&loads)?];
    let loads = Loads::Each(loads);
    let mut answers = Vec::new();
    let together = best(|| batch.least_squeezes_into(black_box(&cases), &mut answers)) / GRASPS as f64;
    let alone = best(|| {
        for grasp in fingers {
            black_box(black_box(grasp).least_squeeze(&cases[0]));
        }
    }) / GRASPS as f64;
    let whole = best(|| {
        for grasp in grasps {
            black_box(grasp.least_squeeze(black_box(&loads)).is_ok());
        }
    }) / grasps.len() as f64;
    let known = answers.iter().filter(|answer| answer.factor().is_some()).count();
    let remark = format!("a factor for {:.0} %", 100.0 * known as f64 / GRASPS as f64);
    let beside = Beside { in_general: whole, ..Beside::NOTHING };
    row(&format!("least squeeze for two loads, {name}, one at a time"), alone, beside, &remark);
    row(&format!("least squeeze for two loads, {name}, batch on one thread"), together, beside, &remark);
    Ok(())
}

/// Two jaws that press unevenly on a body that is not quite square.
fn pair(i: usize) -> [planar::Contact; 2] {
    [-1.0, 1.0].map(|side| {
        let u = |k: usize| uneven(7 * i + k + usize::from(side > 0.0)) - 0.5;
        planar::Contact::new([side, 0.3 * u(1)], [-side, 0.3 * u(2)])
            .series_stiffness(900.0 * (1.0 + u(3)), 600.0 * (1.0 + u(4)))
            .friction(0.6 + 0.4 * u(5))
            .command([0.01, 0.001 * u(6)])
    })
}

fn ring_in_the_plane<const N: usize>(i: usize) -> [planar::Contact; N] {
    std::array::from_fn(|finger| {
        let u = |k: usize| uneven(11 * i + 7 * finger + k) - 0.5;
        let (sin, cos) = (std::f64::consts::TAU * (finger as f64 + 0.2 * u(1)) / N as f64).sin_cos();
        planar::Contact::new([cos, sin], [-cos + 0.2 * u(2), -sin + 0.2 * u(3)])
            .series_stiffness(900.0 * (1.0 + u(4)), 600.0 * (1.0 + u(5)))
            .friction(0.8 + 0.4 * u(6))
            .command([0.01, 0.0])
    })
}

fn ring<const N: usize>(i: usize) -> [spatial::Contact; N] {
    std::array::from_fn(|finger| {
        let u = |k: usize| uneven(13 * i + 9 * finger + k) - 0.5;
        let (sin, cos) = (std::f64::consts::TAU * (finger as f64 + 0.2 * u(1)) / N as f64).sin_cos();
        spatial::Contact::new([cos, sin, 0.3 * u(2)], [-cos + 0.2 * u(3), -sin + 0.2 * u(4), 0.2 * u(5)])
            .series_stiffness(900.0 * (1.0 + u(6)), 600.0 * (1.0 + u(7)))
            .friction(0.8 + 0.4 * u(8))
            .command([0.01, 0.0, 0.0])
    })
}
