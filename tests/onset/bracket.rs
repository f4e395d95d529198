//! The load factors of first slip for inscribed and for circumscribed polygonal friction cones bracket the factor for the round cone. The width of
//! this bracket for a sliding foot agrees with a hand calculation.

use std::cell::Cell;
use std::f64::consts::{PI, TAU};

use grasp_lcp::equilibrium::FoundBy;
use grasp_lcp::spatial::{Contact, Grasp, Onset, Outcome, Wrench};
use grasp_lcp::{PolygonCone, PolygonFit, Settings, planar};
use proptest::prelude::*;
use support::assert_close;
use support::bracket::bracket;
use support::jaws::jaw;
use support::ramps::{Change, Tally, for_both};
use support::samples::samples;
use support::scene::Scene;

fn polygon(facets: usize, fit: PolygonFit) -> Settings {
    // States in which everything sticks are found without an enumeration of combinations of contact states.
    Settings::default().with_most_states(0).with_cone(PolygonCone::new(facets, fit).unwrap())
}

/// Whether all touching contacts stick, according to one of two rules of the solver. Both compute the equilibrium without the cones and then accept
/// or refuse it. Other rules may find an equilibrium with fewer contacts on a smaller cone, whose contacts then stick up to a larger load.
fn sticks(outcome: &Outcome) -> bool {
    let rule = outcome.equilibrium().map(|e| e.rule);
    matches!(rule, Some(FoundBy::EverythingSticks | FoundBy::EverythingTouchingSticks))
}

/// Checks that the factors of a bracket are in order up to rounding, if the contacts stick at factor zero on the smaller cone. With contacts that
/// touch without force, the solver may leave the first slip undecided; `undecided` counts these.
fn check_order(
    scene: &Scene<6, 3>,
    change: &Change<6, 3>,
    tally: &Tally,
    undecided: &Cell<usize>,
) -> Result<(), TestCaseError> {
    let (grasp, ramp) = (scene.grasp(), change.ramp(scene));
    let on_circumscribed = polygon(8, PolygonFit::Circumscribed).on_the_polygon();
    if !sticks(&grasp.with(&on_circumscribed).solve(scene.wrench()).unwrap()) {
        return Ok(());
    }
    let round = grasp.onset(&ramp).unwrap();
    for facets in [3, 8] {
        let on = |fit| grasp.with(&polygon(facets, fit).on_the_polygon()).onset(&ramp).unwrap();
        let (inside, outside) = (on(PolygonFit::Inscribed), on(PolygonFit::Circumscribed));
        let base = bracket(&grasp.with(&polygon(facets, PolygonFit::Inscribed)), scene.wrench()).unwrap();
        for (base, less, more) in [(&base.inscribed, &inside, &round), (&base.round, &round, &outside)] {
            if !sticks(base) {
                continue;
            }
            if matches!(less, Onset::Undecided(_)) || matches!(more, Onset::Undecided(_)) {
                undecided.set(undecided.get() + 1);
                continue;
            }
            tally.count(more);
            let factors = less.factor().zip(more.factor());
            let ordered = factors.is_some_and(|(less, more)| less <= more * (1.0 + 1e-12));
            prop_assert!(ordered, "{factors:?} {less:?} {more:?}");
        }
    }
    Ok(())
}

#[test]
fn polygons_bracket_the_onset() {
    let undecided = Cell::new(0);
    let tally = for_both::<6, 3>(file!(), &(1..6), |s, c, t| check_order(s, c, t, &undecided));
    tally.assert_at_least(200, 12, 200);
    println!("{} undecided", undecided.get());
    assert!(undecided.get() <= samples(4), "{} undecided", undecided.get());
}

/// Checks that the answers for all three cones are equal if everything sticks on the inscribed polygon. If everything sticks on one cone, everything
/// sticks on all larger ones.
fn check_sticking(scene: &Scene<6, 3>, _: &Change<6, 3>, tally: &Tally) -> Result<(), TestCaseError> {
    let bracket = bracket(&scene.grasp().with(&polygon(5, PolygonFit::Balanced)), scene.wrench()).unwrap();
    let [inside, round, outside] = [&bracket.inscribed, &bracket.round, &bracket.circumscribed].map(sticks);
    prop_assert!(inside <= round && round <= outside, "{inside}, {round}, {outside}");
    if inside {
        let spread = bracket.spread.expect("three equilibria");
        prop_assert!(spread == [0.0; 2], "{spread:?}");
        tally.never.set(tally.never.get() + 1);
    } else {
        tally.slides.set(tally.slides.get() + 1);
    }
    Ok(())
}

#[test]
fn where_everything_sticks_the_cone_does_not_matter() {
    for_both::<6, 3>(file!(), &(1..6), check_sticking).assert_at_least(125, 0, 125);
}

/// A foot presses with N on the floor at the origin. Its block is held by a tether of stiffness c in all directions, also at the origin, and drawn
/// sideways by a force W along e. With the friction force f the block moves by u = (W e + f) / c. On the round cone f = -μ N e by symmetry. On the
/// inscribed polygon with m corners f = -μ N d, with the corner d nearest to e. On the circumscribed one f is longer by 1/cos(π/m). This holds while
/// the slip W e + f - (c/k) |f| d, with the foot's stiffness k, deviates from d by less than π/m.
#[test]
fn the_spread_of_a_sliding_foot() {
    let (mu, normal, c, k, w) = (0.5, 20.0, 300.0, 5000.0, 200.0);
    let foot = Contact::new([0.0; 3], [0.0, 0.0, 1.0]).tangent([1.0, 0.0, 0.0]);
    let grasp = Grasp::new([
        foot.clone().series_stiffness(1e4, k).friction(mu).command([normal / 1e4, 0.0, 0.0]),
        foot.series_stiffness(c, c).bonded(),
    ])
    .unwrap();
    for angle in [0.3_f64, 1.9, 4.4] {
        // Friction acts along -e, so the nearest corner is that nearest to -e.
        let e = [angle.cos(), angle.sin()];
        let load = Wrench::force([w * e[0], w * e[1], -normal]);
        let mut before = f64::INFINITY;
        for m in [8_u32, 16, 32, 64, 128] {
            let step = TAU / f64::from(m);
            let nearest = ((angle + PI) / step).round() * step - PI;
            let (off, longer) = ((nearest - angle).abs(), 1.0 / (0.5 * step).cos());
            let f = [mu * normal, mu * normal * longer];
            for f in f {
                let side = (w * off.sin()).atan2(w * off.cos() - f * (1.0 + c / k));
                assert!(side < 0.5 * step, "{m} {angle}");
            }
            let from_round = |f: f64| {
                let along = f * off.cos() - mu * normal;
                along.hypot(f * off.sin())
            };
            let force = from_round(f[0]).max(from_round(f[1])).max(f[1] - f[0]);
            let settings = polygon(m as usize, PolygonFit::Inscribed);
            let [forces, displacements] =
                bracket(&grasp.with(&settings), load).unwrap().spread.expect("three equilibria");
            assert_close!(forces / w, force / w);
            assert_close!(displacements * c / w, force / w);
            let most = mu * normal * step;
            assert!(force <= most && most < before, "{m}: {force} beyond {most}");
            before = most;
        }
    }
}

/// The planar cone is itself a polygon. Thus the equilibria on both polygons of the bracket are the same, and their spread is 0.
#[test]
fn in_the_plane_there_is_nothing_to_bracket() {
    let finger = |side: f64| jaw::<2>(side, [100.0, 80.0], 0.5).command([0.1, 0.02 * side]);
    let grasp = planar::Grasp::new([finger(-1.0), finger(1.0)]).unwrap();
    for load in [1.0, 20.0] {
        let bracket = bracket(&grasp, planar::Wrench::force([0.0, -load])).unwrap();
        let holds = load < 10.0;
        assert_eq!(bracket.spread, holds.then_some([0.0; 2]));
        assert_eq!(bracket.round.equilibrium().is_some(), holds);
    }
}
