//! The library finds equilibria in space on the round friction cone.
//!
//! The scenes are made backwards. A twist of the object is chosen, and a separate return map (by bisection) gives the contact forces by Coulomb's
//! law. The load is then what balances them, so that an equilibrium exists. The library must find one or answer "undecided", and whatever it finds
//! must satisfy the law. If friction is so weak that the equilibrium is unique, it must not depend on the tangents, the order of contacts, the frame,
//! or a contact split in two.

use std::cell::Cell;

use grasp_lcp::Settings;
use grasp_lcp::equilibrium::{Cone, ContactState, Equilibrium, FoundBy, Outcome};
use grasp_lcp::spatial::{Contact, Grasp, Wrench};
use nalgebra::SVector;
use proptest::prelude::*;
use support::random::{Spread, for_all, scene};
use support::samples::{assert_met, samples};
use support::scene::{Datum, Scene, displacement, wrench};
use support::transform::Transform;

/// The contact force by Coulomb's law for a spring stretch v. The friction force is `S v` with S = (K⁻¹ + λ)⁻¹; bisection finds λ from its size.
fn coulomb(datum: &Datum<3>, stretch: &SVector<f64, 3>) -> SVector<f64, 3> {
    let mut force = datum.stiffness.component_mul(stretch);
    if force[0] <= 0.0 {
        return SVector::zeros();
    }
    let limit = datum.friction * force[0];
    let at = |lambda: f64| [1, 2].map(|a| force[a] / (1.0 + lambda * datum.stiffness[a]));
    let size = |lambda: f64| at(lambda)[0].hypot(at(lambda)[1]);
    if size(0.0) > limit {
        let (mut below, mut above) = (0.0, 1.0 / datum.stiffness.min());
        while size(above) > limit {
            above *= 2.0;
        }
        for _ in 0..200 {
            let middle = 0.5 * (below + above);
            *(if size(middle) > limit { &mut below } else { &mut above }) = middle;
        }
        [force[1], force[2]] = at(above);
    }
    force
}

/// The scene with the load that balances its contact forces at a twist.
fn balanced(mut scene: Scene<6, 3>, twist: &SVector<f64, 6>) -> Scene<6, 3> {
    scene.load = scene.contacts.iter().fold(SVector::zeros(), |load, datum| {
        let frame = datum.frame();
        let stretch = datum.drive() - frame.tr_mul(&displacement(&datum.point, twist));
        load - wrench::<6, 3>(&datum.point, &(frame * coulomb(datum, &stretch)))
    });
    scene
}

/// Random solvable scenes with coefficients of friction multiplied by a factor, and one tangential stiffness or two.
fn solvable(
    counts: std::ops::Range<usize>,
    motion: f64,
    friction: f64,
    even_tangents: bool,
) -> impl Strategy<Value = Scene<6, 3>> {
    let twist = prop::collection::vec(-motion..motion, 6).prop_map(SVector::from_vec);
    (scene::<6, 3>(counts, Spread::Narrow, 0.2), twist).prop_map(move |(mut scene, twist)| {
        for datum in &mut scene.contacts {
            datum.friction *= friction;
            if even_tangents {
                datum.stiffness[2] = datum.stiffness[1];
            }
        }
        balanced(scene, &twist)
    })
}

fn solve(scene: &Scene<6, 3>) -> Outcome<3> {
    scene.grasp().solve(scene.wrench()).expect("a finite load")
}

fn slides(e: &Equilibrium<3>) -> bool {
    e.contacts.iter().any(|c| matches!(c.state, ContactState::Sliding { .. }))
}

#[test]
fn solvable_scenes_are_solved() {
    const CASES: usize = 500;
    let (sliding, unresolved, worst) = (Cell::new(0), Cell::new(0), Cell::new(0.0_f64));
    for_all(file!(), CASES, &solvable(3..21, 0.3, 1.0, false), |scene| {
        match solve(&scene) {
            Outcome::Equilibrium(e) => {
                prop_assert_eq!(e.cone, Cone::Round);
                let violation = scene.violation(&e, 8);
                prop_assert!(violation <= 1e-12, "{violation:e} in {e:?}");
                prop_assert!(e.residuals.worst() <= 1e-12);
                worst.set(worst.get().max(violation));
                sliding.set(sliding.get() + usize::from(slides(&e)));
                // Only solutions proposed by Lemke's method start from a polygon.
                let proposed = matches!(e.rule, FoundBy::KinematicForm | FoundBy::ForceForm);
                prop_assert!(e.change_from_polygon.is_some() || !proposed || !slides(&e));
            }
            Outcome::NoEquilibrium(proof) => prop_assert!(false, "wrong proof: {proof:?}"),
            _ => unresolved.set(unresolved.get() + 1),
        }
        Ok(())
    });
    println!("{} slide, {} unresolved, worst violation {:e}", sliding.get(), unresolved.get(), worst.get());
    assert_met(&[(sliding.get(), CASES / 2)]);
    assert!(1000 * unresolved.get() <= samples(CASES), "{} unresolved", unresolved.get());
}

/// Checks that images of a scene have the same forces. With weak friction the equilibrium is unique and insensitive.
fn unchanged(image: impl Fn(&Scene<6, 3>) -> Vec<SVector<f64, 3>>, cases: usize) {
    unchanged_of(&solvable(4..9, 0.2, 0.3, false), image, cases);
}

fn unchanged_of(
    scenes: &impl Strategy<Value = Scene<6, 3>>,
    image: impl Fn(&Scene<6, 3>) -> Vec<SVector<f64, 3>>,
    cases: usize,
) {
    let compared = Cell::new(0);
    for_all(file!(), cases, scenes, |scene| {
        let Outcome::Equilibrium(e) = solve(&scene) else { return Ok(()) };
        if !slides(&e) {
            return Ok(());
        }
        let size = e.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max);
        for (c, f) in e.contacts.iter().zip(image(&scene)) {
            let apart = (c.force_world - f).norm() / size;
            prop_assert!(apart <= 1e-12, "{apart:e}: {} and {f}", c.force_world);
        }
        compared.set(compared.get() + 1);
        Ok(())
    });
    assert_met(&[(compared.get(), cases / 4)]);
}

fn forces(scene: &Scene<6, 3>) -> Vec<SVector<f64, 3>> {
    let outcome = solve(scene);
    outcome.equilibrium().map_or(vec![SVector::repeat(f64::NAN); scene.contacts.len()], |e| {
        e.contacts.iter().map(|c| c.force_world).collect()
    })
}

/// The tangents are rotated by a quarter turn with their stiffnesses exchanged, or by any angle if both stiffnesses are equal.
#[test]
fn the_tangents_do_not_matter() {
    unchanged(
        |scene| {
            let mut turned = scene.clone();
            for datum in &mut turned.contacts {
                datum.tangent = datum.frame().column(2).into_owned();
                datum.stiffness.swap_rows(1, 2);
                let [along, across] = [datum.command[2], -datum.command[1]];
                (datum.command[1], datum.command[2]) = (along, across);
            }
            forces(&turned)
        },
        300,
    );
    unchanged_of(
        &solvable(4..9, 0.2, 0.3, true),
        |scene| {
            let mut turned = scene.clone();
            for (k, datum) in turned.contacts.iter_mut().enumerate() {
                let (sin, cos) = (0.3 + 0.7 * k as f64).sin_cos();
                datum.tangent = datum.frame() * SVector::from([0.0, cos, sin]);
                let [along, across] = [datum.command[1], datum.command[2]];
                datum.command[1] = cos * along + sin * across;
                datum.command[2] = cos * across - sin * along;
            }
            forces(&turned)
        },
        300,
    );
}

#[test]
fn the_order_does_not_matter() {
    unchanged(
        |scene| {
            let mut reversed = scene.clone();
            reversed.contacts.reverse();
            let mut found = forces(&reversed);
            found.reverse();
            found
        },
        300,
    );
}

#[test]
fn the_frame_does_not_matter() {
    let transform = Transform::<3>::turned([0.4, 1.1, 2.3]);
    unchanged(
        |scene| {
            let found = forces(&transform.scene(scene));
            found.iter().map(|f| transform.force_back(f)).collect()
        },
        300,
    );
    let transform = Transform::<3>::moved(SVector::from([0.7, -1.3, 2.1]));
    unchanged(|scene| forces(&transform.scene(scene)), 300);
}

/// If a contact is split into two of half the stiffness, each carries half the force.
#[test]
fn a_contact_may_be_split() {
    unchanged(
        |scene| {
            let mut split = scene.clone();
            let half = Datum { stiffness: split.contacts[0].stiffness * 0.5, ..split.contacts[0] };
            split.contacts[0] = half;
            split.contacts.push(half);
            let mut found = forces(&split);
            let other = found.pop().expect("a contact was added");
            found[0] += other;
            found
        },
        300,
    );
}

/// A body of 12 N on three feet of 4 N, pulled by 4.8 N towards the middle of a facet. The round cones carry 2 + 2 + 1 N and hold the body
/// with the weakest foot sliding. The inscribed octagons carry 5 cos(π/8) = 4.62 N and do not hold it.
#[test]
fn the_list_of_equilibria_has_what_only_the_round_cone_holds() -> Result<(), grasp_lcp::Error> {
    let foot = |x: f64, mu: f64| {
        Contact::new([x, 0.0, 0.0], [0.0, 0.0, 1.0])
            .series_stiffness(100.0, 100.0)
            .friction(mu)
            .tangent([1.0, 0.0, 0.0])
            .command([0.04, 0.0, 0.0])
    };
    let grasp = Grasp::new([foot(-1.0, 0.5), foot(1.0, 0.5), foot(0.0, 0.25)])?;
    let (sin, cos) = std::f64::consts::FRAC_PI_8.sin_cos();
    let load = Wrench::force([4.8 * cos, 4.8 * sin, -12.0]);
    assert!(grasp.with(&Settings::default().on_the_polygon()).equilibria(load)?.is_empty());
    let all = grasp.equilibria(load)?;
    assert_eq!(all.len(), 1);
    let friction = [0, 1, 2].map(|i| all[0].contacts[i].friction_force());
    for (found, expected) in friction.into_iter().zip([1.9, 1.9, 1.0]) {
        assert!((found - expected).abs() < 1e-13, "{found} {expected}");
    }
    assert!(matches!(all[0].contacts[2].state, ContactState::Sliding { .. }));
    Ok(())
}
