//! A workspace returns the answers of `Grasp::onset` to the last bit, whatever was asked before. If a single contact slides first, it allocates no
//! memory.

use allocation_counter::measure;
use grasp_lcp::ask::Grasp;
use grasp_lcp::ask::OnsetWorkspace;
use grasp_lcp::load_path::Ramp;
use grasp_lcp::planar::hand::{Finger, Hand, Joint};
use grasp_lcp::{Settings, planar};
use std::cell::RefCell;
use support::jaws::jaw;
use support::ramps::ramps;
use support::random::{Spread, for_all};
use support::samples::assert_met;

/// Random grasps and ramps, some with free motions, closing contacts, or without an equilibrium at factor zero.
fn questions<const D: usize, const C: usize>(cases: usize) -> Vec<(Grasp<C>, Ramp<C>)> {
    let list = RefCell::new(Vec::new());
    for spread in [Spread::Narrow, Spread::Wide] {
        for_all(file!(), cases, &ramps::<D, C>(1..6, spread), |(scene, change)| {
            list.borrow_mut().push((scene.grasp(), change.ramp(&scene)));
            Ok(())
        });
    }
    list.into_inner()
}

fn tells_the_same<const D: usize, const C: usize>(settings: Settings) {
    let mut workspace = OnsetWorkspace::<C>::new(settings);
    let mut events = 0;
    for (grasp, ramp) in questions::<D, C>(100) {
        let told = workspace.onset(&grasp, &ramp).expect("valid");
        // Debug prints floats so that they read back to the same bits.
        let expected = grasp.with(&settings).onset(&ramp).expect("valid");
        assert_eq!(format!("{told:?}"), format!("{expected:?}"));
        events += usize::from(told.event().is_some());
    }
    println!("{events} events");
    assert_met(&[(events, 15)]);
}

#[test]
fn in_the_plane() {
    tells_the_same::<3, 2>(Settings::default());
}

#[test]
fn in_space() {
    tells_the_same::<6, 3>(Settings::default());
    tells_the_same::<6, 3>(Settings::default().on_the_polygon());
}

/// The number of questions that allocate nothing when they are asked a second time. In all of them a single contact slides first.
fn without_allocation<const D: usize, const C: usize>() -> usize {
    let mut workspace = OnsetWorkspace::<C>::default();
    let mut count = 0;
    for (grasp, ramp) in &questions::<D, C>(75) {
        // The first call factorises, and enlarges the lists of the workspace if the grasp is larger than earlier ones.
        assert!(workspace.onset(grasp, ramp).is_ok());
        let counted = measure(|| assert!(workspace.onset(grasp, ramp).is_ok()));
        if counted.count_total == 0 {
            count += 1;
            let event = grasp.onset(ramp).expect("valid").event().cloned();
            assert!(event.is_some_and(|event| event.factor > 0.0 && event.leaving.len() == 1));
        }
    }
    count
}

#[test]
fn where_one_contact_leaves_nothing_is_allocated() {
    let [plane, space] = [without_allocation::<3, 2>(), without_allocation::<6, 3>()];
    println!("{plane} and {space}");
    assert_met(&[(plane, 20), (space, 7)]);
}

#[test]
fn nor_for_a_hand() {
    let finger = |x: f64, friction: f64| {
        let pad = planar::Contact::new([x, 0.0], [-x, 0.1])
            .series_stiffness(2e3, 1.5e3)
            .friction(friction)
            .pressed_with(3.0);
        Finger::new([Joint::revolute([1.3 * x, -1.0]).stiffness(30.0)]).contact(pad)
    };
    let grasp = Hand::new([finger(-1.0, 0.6), finger(1.0, 0.5)]).grasp().expect("well posed");
    let ramp = Ramp::load(planar::Wrench::ZERO, planar::Wrench::force([0.0, -1.0]));
    let mut workspace = OnsetWorkspace::default();
    let event = workspace.onset(&grasp, &ramp).expect("valid").event().cloned().expect("slides");
    assert!(event.leaving.len() == 1 && event.leaving[0].contact.index == 1);
    let counted = measure(|| assert!(workspace.onset(&grasp, &ramp).is_ok()));
    assert_eq!(counted.count_total, 0);
}

/// Invalid input is refused, and an error does not affect the next question.
#[test]
fn an_error_leaves_it_as_good_as_new() {
    let jaw = |x: f64, friction: f64| jaw::<2>(x, [1e3, 8e2], friction).pressed_with(10.0);
    let grasp = planar::Grasp::new([jaw(-1.0, 0.5), jaw(1.0, 0.4)]).expect("valid");
    let pull = planar::Ramp::load(planar::Wrench::ZERO, planar::Wrench::force([0.0, -1.0]));
    let mut workspace = planar::OnsetWorkspace::default();
    assert!(workspace.onset(&grasp, &pull.clone().with_commands([[0.0; 2]; 3])).is_err());
    let factor = |onset: &planar::Onset| onset.factor().expect("slides");
    assert!((factor(workspace.onset(&grasp, &pull).expect("valid")) - 8.0).abs() < 1e-14);
    assert!(
        workspace
            .onset(&grasp, &planar::Ramp::load(planar::Wrench::force([f64::NAN, 0.0]), planar::Wrench::ZERO))
            .is_err()
    );
    assert!((factor(workspace.onset(&grasp, &pull).expect("valid")) - 8.0).abs() < 1e-14);
}
