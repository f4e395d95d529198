//! What a workspace finds is an equilibrium: the one of `Grasp::solve`, or another one that satisfies every condition recomputed
//! from the data, and the same by Newton's method and by Lemke's where there is only one.

use grasp_lcp::Settings;
use grasp_lcp::ask::Grasp;
use grasp_lcp::ask::{Search, Workspace};
use grasp_lcp::equilibrium::FoundBy;
use grasp_lcp::grasp::Wrench;
use grasp_lcp::{planar, spatial};
use nalgebra::SVector;
use std::cell::RefCell;
use std::f64::consts::TAU;
use support::random::{Spread, for_all, scene};
use support::samples::{assert_met, samples};

/// Forces agree to this part of the largest, as far as the equilibrium is unique.
const AGREEMENT: f64 = 1e-9;

/// What a workspace promises.
const ACCURATE: f64 = 1e-10;

/// The largest difference of the forces over the largest force.
fn difference<const C: usize>(a: &[SVector<f64, C>], b: &[SVector<f64, C>]) -> f64 {
    let size = b.iter().map(nalgebra::Matrix::norm).fold(f64::MIN_POSITIVE, f64::max);
    a.iter().zip(b).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max) / size
}

/// How many of the answers have the forces of `Grasp::solve` on the same cone, other ones, none there; and the same twist, too.
fn compare<const D: usize, const C: usize>(
    workspace: Workspace<C>,
    count: std::ops::Range<usize>,
    cases: usize,
) -> [usize; 4] {
    let tally = RefCell::new([0; 4]);
    let settings =
        if workspace.is_round() { Settings::default() } else { Settings::default().on_the_polygon() };
    let workspace = RefCell::new(workspace);
    for_all(file!(), cases, &scene::<D, C>(count, Spread::Narrow, 0.3), |scene| {
        let (grasp, load) = (scene.grasp(), scene.wrench());
        let outcome = grasp.with(&settings).solve(load).expect("finite");
        let mut workspace = workspace.borrow_mut();
        let Search::Found(view) = workspace.solve(&grasp, &load).expect("finite") else { return Ok(()) };
        let [same, other, alone, moves] = &mut *tally.borrow_mut();
        let Some(equilibrium) = outcome.equilibrium() else {
            *alone += 1;
            return Ok(());
        };
        let forces: Vec<_> = equilibrium.contacts.iter().map(|c| c.force).collect();
        if difference(&view.forces().collect::<Vec<_>>(), &forces) < AGREEMENT {
            *same += 1;
            let (a, b) = (view.twist(), equilibrium.twist);
            let apart = (SVector::<f64, D>::from_column_slice(a.components())
                - SVector::<f64, D>::from_column_slice(b.components()))
            .norm();
            // Forces that vanish leave the object room to move.
            *moves += usize::from(
                apart < 1e-7 * SVector::<f64, D>::from_column_slice(b.components()).norm().max(1e-3),
            );
        } else {
            *other += 1;
        }
        // Balance and cones of the workspace's own forces.
        let mut sum = SVector::<f64, D>::from_column_slice(load.components());
        // Where nothing carries anything, forces are the rounding of what the springs could do.
        let mut size =
            sum.norm() + 1e-4 * scene.contacts.iter().map(|d| d.softest() * d.command.norm()).sum::<f64>();
        size += view.forces().map(|force| force.norm()).sum::<f64>();
        for ((datum, force), contact) in scene.contacts.iter().zip(view.forces()).zip(grasp.contacts()) {
            let world = datum.frame() * force;
            sum += support::scene::wrench::<D, C>(&datum.point, &world);
            let friction = force.rows_range(1..).norm();
            assert!(force[0] >= -ACCURATE * size);
            assert!(friction <= contact.friction_coefficient() * force[0] + ACCURATE * size);
        }
        assert!(sum.norm() <= ACCURATE * size.max(f64::MIN_POSITIVE), "{} of {size}", sum.norm());
        Ok(())
    });
    tally.into_inner()
}

#[test]
fn few_contacts() {
    let [same, other, alone, moves] = compare::<3, 2>(Workspace::default(), 2..9, 250);
    assert_met(&[(same, 225)]);
    assert!(other < samples(8) && alone == 0 && moves * 10 > same * 9);
    let [same, other, alone, moves] = compare::<6, 3>(Workspace::default(), 3..9, 150);
    assert_met(&[(same, 100)]);
    assert!(other < samples(15) && alone == 0 && moves * 10 > same * 9);
}

#[test]
fn many_contacts() {
    let [same, other, alone, moves] = compare::<3, 2>(Workspace::default(), 32..80, 100);
    assert_met(&[(same, 90)]);
    assert!(other == 0 && alone == 0 && moves == same);
    let [same, other, alone, moves] = compare::<6, 3>(Workspace::default(), 32..60, 60);
    assert_met(&[(same, 50)]);
    assert!(other == 0 && alone == 0 && moves == same);
}

#[test]
fn on_the_round_cone() {
    let tally = compare::<6, 3>(Workspace::on_the_round_cone(), 3..9, 200);
    println!("{tally:?}");
    let [same, other, alone, moves] = tally;
    assert_met(&[(same, 183)]);
    assert!(other < samples(10) && alone == 0 && moves * 10 > same * 9);
    let [same, other, alone, moves] = compare::<6, 3>(Workspace::on_the_round_cone(), 32..60, 20);
    assert_met(&[(same, 16)]);
    assert!(other == 0 && alone == 0 && moves == same);
}

/// A contact that slides pulls the body along its friction, which no facet turns.
#[test]
fn sliding_on_the_round_cone() {
    // A block of 10 N on a foot, among three soft guides about it that hold it sideways alike.
    let foot = spatial::Contact::new([0.0; 3], [0.0, 0.0, 1.0]).series_stiffness(1e3, 8e2).friction(0.5);
    let guide = |third: f64| {
        let (sin, cos) = (third * TAU / 3.0).sin_cos();
        spatial::Contact::new([cos, sin, 0.0], [0.0, 0.0, 1.0]).series_stiffness(1e-3, 50.0).bonded()
    };
    let grasp = spatial::Grasp::new([foot, guide(0.0), guide(1.0), guide(2.0)]).expect("valid");
    let mut workspace = Workspace::on_the_round_cone();
    for angle in (0..64).map(|k| f64::from(k) * 0.1) {
        let load = spatial::Wrench::force([8.0 * angle.cos(), 8.0 * angle.sin(), -10.0]);
        let Ok(Search::Found(found)) = workspace.solve(&grasp, &load) else { panic!("holds") };
        let force = found.forces().next().expect("a contact");
        let friction = grasp.frames().next().expect("the foot") * SVector::from([0.0, force[1], force[2]]);
        let along = SVector::from([angle.cos(), angle.sin(), 0.0]);
        assert!((friction + along * (0.5 * force[0])).norm() < 1e-9, "{friction}");
        assert!(found.jumps().count() == 1 && found.residual() < 1e-13);
    }
}

/// All normals alike: the pressure is known, hence the equilibrium is the only one.
fn newton_and_lemke<const C: usize>(grasp: &Grasp<C>, load: &Wrench<C>) {
    let mut workspace = Workspace::default();
    let Ok(Search::Found(view)) = workspace.solve(grasp, load) else { panic!("holds") };
    assert!(view.newton_steps().is_some() && view.residual() < 1e-12);
    let newton = view.forces().collect::<Vec<_>>();
    let Ok(Search::Found(view)) = workspace.solve_along_one_path(grasp, load) else { panic!("holds") };
    assert!(view.newton_steps().is_none() && view.residual() < 1e-10);
    assert!(view.pivots() > grasp.len() / 4);
    assert!(difference(&view.forces().collect::<Vec<_>>(), &newton) < AGREEMENT);
    let outcome = grasp.with(&Settings::default().on_the_polygon()).solve(load).expect("finite");
    let equilibrium = outcome.equilibrium().expect("holds");
    assert_eq!(equilibrium.rule, FoundBy::Newton);
    assert!(equilibrium.residuals.worst() < 1e-10);
    let forces: Vec<_> = equilibrium.contacts.iter().map(|c| c.force).collect();
    assert!(difference(&forces, &newton) < AGREEMENT);
}

#[test]
fn a_patch_in_the_plane() {
    for n in [40, 1000, 20_000] {
        let place = |i: usize| (i as f64 + 0.5) / n as f64 * 2.0 - 1.0;
        let press = |i: usize| 1.0 - place(i).powi(2) + 0.1 * (7.3 * i as f64).sin().abs();
        let contact = |i| {
            planar::Contact::new([place(i), 0.0], [0.0, 1.0])
                .series_stiffness(1.0, 0.8)
                .friction(0.3)
                .command([press(i), 0.0])
        };
        let total: f64 = (0..n).map(press).sum();
        let grasp = planar::Grasp::new((0..n).map(contact)).expect("valid");
        newton_and_lemke(&grasp, &planar::Wrench::new([0.28 * total, -total], 0.0));
    }
}

#[test]
fn a_patch_in_space() {
    for n in [60, 2000] {
        let place = |i: usize| (((i as f64 + 0.5) / n as f64).sqrt(), i as f64 * 2.399_963_229_728_653);
        let press = |i: usize| 1.05 - place(i).0.powi(2) + 0.1 * (7.3 * i as f64).sin().abs();
        let contact = |i| {
            let (r, angle) = place(i);
            spatial::Contact::new([r * angle.cos(), r * angle.sin(), 0.0], [0.0, 0.0, 1.0])
                .tangent([1.0, 0.0, 0.0])
                .series_stiffness_axes([1.0, 0.8, 0.5])
                .friction(0.3)
                .command([press(i), 0.0, 0.0])
        };
        let total: f64 = (0..n).map(press).sum();
        let grasp = spatial::Grasp::new((0..n).map(contact)).expect("valid");
        let load = spatial::Wrench::new([0.2 * total, 0.06 * total, -total], [0.0, 0.0, 0.05 * total]);
        newton_and_lemke(&grasp, &load);
    }
}

/// Equal contacts slide together: as many variables tie as there are contacts.
#[test]
fn contacts_all_alike() {
    let contact = |i: usize| {
        planar::Contact::new([(i as f64 - 499.5) / 500.0, 0.0], [0.0, 1.0])
            .series_stiffness(1.0, 0.8)
            .friction(0.3)
            .command([1.0, if i.is_multiple_of(2) { 0.0 } else { 0.5 }])
    };
    let grasp = planar::Grasp::new((0..1000).map(contact)).expect("valid");
    newton_and_lemke(&grasp, &planar::Wrench::new([150.0, -1000.0], 0.0));
}

/// Beyond what friction can hold the answer is a proof, at any number of contacts.
#[test]
fn an_overloaded_patch() {
    for n in [300, 3000] {
        let contact = |i: usize| {
            planar::Contact::new([(i as f64 + 0.5) / n as f64 * 2.0 - 1.0, 0.0], [0.0, 1.0])
                .series_stiffness(1.0, 0.8)
                .friction(0.3)
                .command([1.0 + 0.1 * (7.3 * i as f64).sin(), 0.0])
        };
        let grasp = planar::Grasp::new((0..n).map(contact)).expect("valid");
        let press = n as f64;
        let held = grasp.solve(planar::Wrench::new([0.29 * press, -press], 0.0)).expect("finite");
        assert!(held.equilibrium().is_some());
        let outcome = grasp.solve(planar::Wrench::new([0.31 * press, -press], 0.0)).expect("finite");
        let planar::Outcome::NoEquilibrium(none) = outcome else { panic!("{outcome:?}") };
        assert!(matches!(none.proof, planar::Proof::SeparatingMotion { .. }));
        let mut workspace = Workspace::default();
        let load = planar::Wrench::new([0.31 * press, -press], 0.0);
        assert!(matches!(workspace.solve(&grasp, &load), Ok(Search::NotFound { .. })));
    }
}
