//! The paper's quadratic program reproduces the paper's tables, including the rows with loads above W*, at which the grasp begins to slide. The
//! comparison reports that the forces of those rows do not balance the load.

use grasp_lcp::Settings;
use grasp_lcp::energy::{Agreement, ComparisonVerdict};
use grasp_lcp::load_path::Ramp;
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use nalgebra::SVector;
use support::paper::{
    DISK_FORCES, DISK_RATIOS, TWO_FINGER_MISPRINTS, TWO_FINGER_TABLE, disk, disk_load, down,
    printed_contacts, two_fingers,
};
use support::printed_program::PrintedProgram;
use support::reduced_program::ReducedProgram;

/// One unit of the last printed digit, because some numbers are truncated.
const LAST_DIGIT: f64 = 1.0001e-4;

/// Contact forces from all three forms of the paper's quadratic program.
fn by_every_form(grasp: &Grasp, load: &Wrench) -> [Vec<SVector<f64, 2>>; 3] {
    let settings = Settings::default();
    let accurate = grasp.with(&settings).energy().minimum(load).unwrap();
    let accurate = accurate.minimum().expect("a minimum").contacts.iter().map(|c| c.force).collect();
    let printed = PrintedProgram::of(grasp, &printed_contacts(grasp), load, &settings.cone);
    let Some(qp) = printed.program.solve().unwrap() else { panic!("a minimum") };
    let as_printed = (0..grasp.len()).map(|i| printed.force(&qp.x, i)).collect();
    let commands: Vec<_> = grasp.contacts().iter().map(Contact::commanded).collect();
    let reduced = ReducedProgram::of(grasp, &commands, load, &settings.cone, false);
    let Some(qp) = reduced.program.solve().unwrap() else { panic!("a minimum") };
    let twist = SVector::<f64, 3>::from_column_slice(qp.x.as_slice());
    let from_twist = grasp.contacts().iter().zip(grasp.frames()).map(|(c, frame)| {
        let p = c.point();
        let u = SVector::from([twist[0] - twist[2] * p[1], twist[1] + twist[2] * p[0]]);
        c.series_stiffness_of_axes().component_mul(&(c.commanded() - frame.tr_mul(&u)))
    });
    [accurate, as_printed, from_twist.collect()]
}

#[test]
fn every_row_of_the_second_table() {
    let grasp = two_fingers().unwrap();
    for (index, row) in TWO_FINGER_TABLE.iter().enumerate() {
        for forces in by_every_form(&grasp, &(down() * row[0])) {
            for (column, print) in row[1..].iter().enumerate() {
                let misprint = column == 2 && index == TWO_FINGER_MISPRINTS[0].0;
                let print = if misprint { 0.4988 } else { *print };
                let ours = forces[column / 2][column % 2];
                assert!((ours - print).abs() < LAST_DIGIT, "{index} {ours} {print}");
            }
        }
    }
}

/// For loads W above the load W* of first slip, the program returns the forces at W*, 65/132 and 65/528. They miss equilibrium by W - W* along the
/// load.
#[test]
fn beyond_the_onset_the_rows_are_out_of_equilibrium() {
    let grasp = two_fingers().unwrap();
    let onset = 65f64.sqrt() / 66.0;
    for w in [0.13, 0.14, 0.5, 3.0] {
        let comparison = grasp.energy().compare(down() * w).unwrap();
        let minimum = comparison.minimum.minimum().unwrap();
        for c in &minimum.contacts {
            assert!((c.force[0] - 65.0 / 132.0).abs() < 1e-14, "{}", c.force[0]);
            assert!((c.force[1].abs() - 65.0 / 528.0).abs() < 1e-14);
            assert_eq!(c.gap, 0.0);
        }
        let missing = minimum.imbalance.to_vector();
        assert!(
            (missing[1] + (w - onset)).abs() < 1e-14 && missing[0].abs() < 1e-15 && missing[2].abs() < 1e-13
        );
        let ComparisonVerdict::NoEquilibrium { force, moment } = comparison.verdict else {
            panic!("{:?}", comparison.verdict)
        };
        assert!((force - (w - onset)).abs() < 1e-14 && moment < 1e-13);
        assert!(comparison.difference.is_none());
        let binding: Vec<_> = minimum.binding.iter().map(|b| (b.contact, b.facet)).collect();
        assert_eq!(binding, [(0, Some(1)), (1, Some(0))]);
        assert!(minimum.binding.iter().all(|b| b.multiplier > 0.0));
        // The residual from the multipliers equals the residual from the forces.
        let sum: SVector<f64, 2> = minimum.contacts.iter().map(|c| c.force_world).sum();
        assert!((sum[1] - w - missing[1]).abs() < 1e-14);
    }
    let text = grasp.energy().compare(down() * 0.14).unwrap().to_string();
    assert!(text.ends_with("misses the load by 0.0178446 N"), "{text}");
}

#[test]
fn up_to_the_onset_both_agree() {
    let grasp = two_fingers().unwrap();
    let onset = 65f64.sqrt() / 66.0;
    for w in [0.0, 0.05, 0.12, onset * (1.0 - 1e-9), onset] {
        let comparison = grasp.energy().compare(down() * w).unwrap();
        assert_eq!(comparison.verdict, ComparisonVerdict::Agree, "W = {w}");
        assert!(comparison.difference.unwrap().relative() < 1e-14);
    }
    let ramp = Ramp::load(Wrench::ZERO, down());
    let ends = grasp.energy().agreement(&ramp).unwrap();
    let Agreement::UpTo { factor, binding } = ends else { panic!("{ends:?}") };
    assert!((factor - onset).abs() <= 2e-16, "{factor} {onset}");
    assert_eq!(binding, [(0, Some(1)), (1, Some(0))]);
}

/// The disk, with the correction for the rounded dy of the paper, as in `tests/paper/grasp.rs`.
#[test]
fn the_first_table() {
    let grasp = disk(true).unwrap();
    let comparison = grasp.energy().compare(disk_load()).unwrap();
    assert_eq!(comparison.verdict, ComparisonVerdict::Agree);
    let minimum = comparison.minimum.minimum().unwrap();
    let missing = 50.0 * (minimum.twist.translation()[1] - 0.0013);
    for forces in by_every_form(&grasp, &disk_load()) {
        for ((force, frame), (printed, ratio)) in
            forces.iter().zip(grasp.frames()).zip(DISK_FORCES[0].1.iter().zip(DISK_RATIOS))
        {
            let world = frame * force;
            assert!((world[0] - printed.force[0]).abs() < 2e-4, "{} {}", world[0], printed.force[0]);
            assert!((world[1] + missing - printed.force[1]).abs() < 2e-4);
            assert!((force[1] / force[0] - ratio).abs() < 4e-4);
        }
    }
    // Section 5.2: equilibrating and interaction forces of the same answer.
    let state = comparison.equilibrium.equilibrium().unwrap();
    let parts = grasp.statics().decompose(state);
    for (i, part) in parts.equilibrating.iter().enumerate() {
        let print = DISK_FORCES[1].1[i].misprint.map_or(DISK_FORCES[1].1[i].force, |(_, value)| value);
        assert!((part[0] - print[0]).abs() < 2e-4 && (part[1] - print[1]).abs() < 2e-4);
    }
}
