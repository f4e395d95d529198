//! Derivatives of events and bounds against differences of their values, at places drawn anywhere.

use nalgebra::DVector;

use super::ascent::Climb;
use super::events::events;
use super::goal::ImproveGoal;
use super::loaded::Loaded;
use super::placing::{Choice, DesignVariable, Placing};
use super::question::Improve;
use super::surface::Surface;
use crate::ask::Grasp;
use crate::grasp::Contact;
use crate::numerics::Draw;
use crate::prelude::*;
use crate::squeeze::Loads;
use crate::{planar, spatial};

const H: f64 = 1e-5;
const FAR: f64 = 1e3;

/// Events and bounds in one list, and their gradients.
fn values<const C: usize>(
    climb: &Climb<'_, C>,
    placing: &Placing<C>,
) -> Option<(Vec<f64>, Vec<DVector<f64>>)> {
    // One that was pressed less hard, as it pressed too hard, is another grasp.
    let held = climb.held(placing.clone()).expect("asked well").filter(|held| held.placing == *placing)?;
    let derivatives = held.sticking.derivatives(climb.choice, &held.placing).expect("balanced");
    let contacts = climb.choice.contacts(&held.placing);
    let most = vec![Some(100.0); contacts.len()];
    let (events, bounds) = events(&contacts, climb.loaded.asked, &most, &held.sticking, &derivatives);
    let of_bounds = bounds.into_iter().map(|bound| (bound.left, bound.gradient));
    Some(events.into_iter().map(|event| (event.value, event.gradient)).chain(of_bounds).unzip())
}

fn compare<const C: usize>(grasp: &Grasp<C>, question: &Improve<C>, seed: u64) -> usize {
    let loaded = Loaded::of(question);
    let (choice, given) = Choice::of(grasp, question).expect("on its surfaces");
    let climb = Climb { choice: &choice, loaded: &loaded, grasp };
    let mut compared = 0;
    for number in 0..60 {
        let drawn = choice.drawn(&given, &mut Draw::new([seed, number, 7]));
        // Squeezed less than they may, so that none is made less.
        let drawn =
            choice.moved(&drawn, &choice.variables.iter().map(DesignVariable::relaxed).collect::<Vec<_>>());
        let Some((here, gradients)) = values(&climb, &drawn) else { continue };
        for j in 0..choice.variables.len() {
            let step = |h: f64| {
                let step: Vec<f64> =
                    (0..choice.variables.len()).map(|k| if k == j { h } else { 0.0 }).collect();
                values(&climb, &choice.moved(&drawn, &step)).map(|(values, _)| values)
            };
            let [Some(up), Some(down), Some(far_up), Some(far_down)] =
                [step(H), step(-H), step(2.0 * H), step(-2.0 * H)]
            else {
                continue;
            };
            if up.len() != here.len() || far_up.len() != here.len() || down.len() != here.len() {
                continue;
            }
            if far_down.len() != here.len() {
                continue;
            }
            for k in 0..here.len() {
                let difference = (8.0 * (up[k] - down[k]) - (far_up[k] - far_down[k])) / (12.0 * H);
                // What slides at thousands of times the loads bends too much for differences, and never comes first.
                if here[k].abs() > FAR {
                    continue;
                }
                let size = gradients[k].amax().max(here[k].abs()).max(1.0);
                assert!(
                    (gradients[k][j] - difference).abs() < 1e-7 * size,
                    "{k} {j}: {} {difference}",
                    gradients[k][j]
                );
                compared += 1;
            }
        }
    }
    compared
}

#[test]
fn in_the_plane() {
    let blob = [[0.05, 0.0], [0.02, 0.04], [-0.04, 0.03], [-0.05, -0.02], [0.01, -0.04]];
    let at = |k: usize| Surface::spline(blob, true).place_of(blob[k], [-blob[k][0], -blob[k][1]]);
    let finger = |k: usize| {
        let (point, normal) = at(k);
        let contact = Contact::new(point, normal).series_stiffness(1e3, 7e2).friction(0.8);
        contact.command([0.01, 1e-3])
    };
    let grasp = Grasp::new([finger(0), finger(2), finger(4)]).expect("three fingers");
    let loads = Loads::Each(vec![planar::Wrench::force([0.3, -1.0]), planar::Wrench::new([0.5, 0.0], 0.01)]);
    let any = Loads::AnyForce { base: planar::Wrench::ZERO, size: 2.0, point: [0.01, 0.0] };
    for loads in [loads, any] {
        let question =
            Improve::new(loads).on_top_of(planar::Wrench::force([0.1, 0.2])).pressing_at_most(12.0);
        let question = (0..3).fold(question, |q, k| q.along(k, Surface::spline(blob, true)));
        for goal in [ImproveGoal::FirstSlip, ImproveGoal::Reserve] {
            assert!(compare(&grasp, &question.clone().with_goal(goal), 1) > 500);
        }
    }
}

#[test]
fn in_space() {
    let finger = |angle: f64, height: f64, radius: f64| {
        let (sin, cos) = angle.sin_cos();
        let contact = Contact::new([radius * cos, radius * sin, height], [-cos, -sin, 0.0]);
        contact.series_stiffness(1e3, 8e2).friction(0.8).command([0.009, 5e-4, 0.0])
    };
    let grasp = Grasp::new([finger(0.2, 0.01, 0.05), finger(2.0, 0.0, 0.06), finger(4.5, 0.01, 0.05)])
        .expect("three");
    let can = || Surface::cylinder([0.0, 0.0, -0.03], [0.0, 0.0, 0.03], 0.05);
    let loads = Loads::Each(vec![
        spatial::Wrench::force([0.1, 0.2, -1.0]),
        spatial::Wrench::new([0.5, 0.0, 0.3], [0.0, 0.0, 0.01]),
    ]);
    let any = Loads::AnyForce { base: spatial::Wrench::ZERO, size: 2.0, point: [0.01, 0.0, 0.0] };
    for loads in [loads, any] {
        let question =
            Improve::new(loads).on_top_of(spatial::Wrench::force([0.1, 0.2, 0.0])).pressing_at_most(12.0);
        let ball = Surface::sphere([0.0; 3], 0.06);
        let question = question.along(0, can()).along(1, ball).along(2, can());
        for goal in [ImproveGoal::FirstSlip, ImproveGoal::Reserve] {
            assert!(compare(&grasp, &question.clone().with_goal(goal), 2) > 500);
        }
    }
}
