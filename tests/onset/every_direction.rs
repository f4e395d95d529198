//! Loads of first slip for all directions of a force agree with the region of loads without sliding, which is found here from equilibria. They have
//! the symmetries of the grasp, and no equilibrium exists beyond a limit load.

use std::f64::consts::TAU;

use grasp_lcp::picture::SphereGrid;
use grasp_lcp::planar::{self, Beyond, Grasp, Leg, PathEnd, Wrench};
use grasp_lcp::spatial;
use support::jaws::around;

type Failure = Box<dyn std::error::Error>;

/// A disc held by evenly spaced fingers.
fn ring(fingers: usize) -> Result<Grasp, grasp_lcp::Error> {
    Grasp::new((0..fingers).map(|k| around::<2>(k, fingers, 1.0, [50.0, 30.0], 0.3).command([0.1, 0.0])))
}

fn angles(count: u32) -> impl Iterator<Item = f64> {
    (0..count).map(move |k| TAU * (f64::from(k) + 0.25) / f64::from(count))
}

fn pull(angle: f64) -> Wrench {
    Wrench::force([angle.cos(), angle.sin()])
}

fn onset(grasp: &Grasp, angle: f64) -> Result<f64, Failure> {
    Ok(grasp.onset(pull(angle))?.factor().ok_or("sticks without load")?)
}

/// Half planes (c, g) of forces W: nothing slides or opens while c + g·W >= 0 for all of them. They follow from the equilibria under three small
/// loads.
fn half_planes(grasp: &Grasp) -> Result<Vec<(f64, [f64; 2])>, Failure> {
    let slacks = |load: [f64; 2]| -> Result<Vec<f64>, Failure> {
        let outcome = grasp.solve(Wrench::force(load))?;
        let state = outcome.equilibrium().ok_or("holds")?;
        let rows = grasp.contacts().iter().zip(&state.contacts).flat_map(|(contact, answer)| {
            let (room, t) =
                (contact.friction_coefficient() * answer.normal_force(), answer.tangential_force());
            [room - t, room + t]
        });
        Ok(rows.collect())
    };
    let step = 1.0 / 64.0;
    let [at_rest, x, y] = [slacks([0.0, 0.0])?, slacks([step, 0.0])?, slacks([0.0, step])?];
    let row = |k: usize| (at_rest[k], [(x[k] - at_rest[k]) / step, (y[k] - at_rest[k]) / step]);
    Ok((0..at_rest.len()).map(row).collect())
}

#[test]
fn onsets_lie_on_the_polygon_of_plain_equilibria() -> Result<(), Failure> {
    for grasp in [support::paper::two_fingers()?, ring(3)?, ring(5)?] {
        let rows = half_planes(&grasp)?;
        for angle in angles(360) {
            let rate = |g: &[f64; 2]| g[0] * angle.cos() + g[1] * angle.sin();
            let reached = rows.iter().filter(|(_, g)| rate(g) < 0.0).map(|(c, g)| -c / rate(g));
            let expected = reached.fold(f64::INFINITY, f64::min);
            let found = onset(&grasp, angle)?;
            assert!((found - expected).abs() <= 1e-11 * expected, "{angle} {found} {expected}");
        }
        // The weakest direction is perpendicular to the nearest edge of the region. The force of first slip in this direction is the distance of the
        // edge.
        let distance = |(c, g): &(f64, [f64; 2])| c / g[0].hypot(g[1]);
        let nearest = rows.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).ok_or("rows")?;
        let least = distance(nearest);
        let weakest = onset(&grasp, (-nearest.1[1]).atan2(-nearest.1[0]))?;
        assert!((weakest - least).abs() <= 1e-11 * least, "{weakest} against {least}");
        for angle in angles(3600) {
            assert!(onset(&grasp, angle)? >= least * (1.0 - 1e-11));
        }
    }
    Ok(())
}

/// The end of the load path towards a large force. Checks that no equilibrium exists for larger loads if the path ends with a loss.
fn end(grasp: &Grasp, angle: f64) -> Result<PathEnd, Failure> {
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(pull(angle) * MOST)])?;
    path.by_ref().for_each(drop);
    assert!(matches!(path.beyond(), None | Some(Beyond::LimitLoad)), "{angle}: {:?}", path.beyond());
    Ok(path.end().ok_or("an end")?.clone())
}

const MOST: f64 = 4.0;

#[test]
fn the_papers_grasp_is_mirrored_and_has_its_onset_downwards() -> Result<(), Failure> {
    let grasp = support::paper::two_fingers()?;
    let down = grasp.onset(Wrench::force([0.0, -1.0]))?.factor().ok_or("slides")?;
    assert!((down - 65f64.sqrt() / 66.0).abs() < 1e-15);
    let mut limits = 0;
    for angle in angles(90) {
        let (left, right) = (onset(&grasp, angle)?, onset(&grasp, TAU / 2.0 - angle)?);
        assert!((left - right).abs() <= 1e-13 * left, "{angle} {left} {right}");
        match (end(&grasp, angle)?, end(&grasp, TAU / 2.0 - angle)?) {
            (PathEnd::Lost(left), PathEnd::Lost(right)) => {
                assert!((left.fraction - right.fraction).abs() <= 1e-13, "{angle} {left:?} {right:?}");
                limits += 1;
            }
            (PathEnd::Completed, PathEnd::Completed) => {}
            (left, right) => return Err(format!("{angle}: {left:?} {right:?}").into()),
        }
    }
    assert!((30..80).contains(&limits), "{limits}");
    Ok(())
}

#[test]
fn what_turns_into_itself_has_onsets_that_do() -> Result<(), Failure> {
    let grasp = ring(5)?;
    for angle in angles(24) {
        let (once, again) = (onset(&grasp, angle)?, onset(&grasp, angle + TAU / 5.0)?);
        assert!((once - again).abs() <= 1e-12 * once, "{angle} {once} {again}");
    }
    Ok(())
}

#[test]
fn a_limit_is_no_less_than_the_onset_and_nothing_holds_beyond() -> Result<(), Failure> {
    let grasp = support::paper::two_fingers()?;
    let mut limits = 0;
    for angle in angles(120) {
        if let PathEnd::Lost(loss) = end(&grasp, angle)? {
            let limit = MOST * loss.fraction;
            assert!(limit >= onset(&grasp, angle)? * (1.0 - 1e-12));
            let beyond = grasp.solve(pull(angle) * (limit * (1.0 + 1e-6)))?;
            assert!(matches!(beyond, planar::Outcome::NoEquilibrium(_)), "{angle}: {beyond:?}");
            limits += 1;
        }
    }
    assert!(limits > 60, "{limits}");
    Ok(())
}

#[test]
fn in_space_the_region_is_convex_and_as_symmetric_as_the_grasp() -> Result<(), Failure> {
    // Three equal fingers around z map onto each other under a third of a turn.
    let grasp = spatial::Grasp::new((0..3).map(|k| {
        let (sin, cos) = (TAU * f64::from(k) / 3.0).sin_cos();
        spatial::Contact::new([0.03 * cos, 0.03 * sin, 0.0], [-cos, -sin, 0.1])
            .tangent([0.0, 0.0, 1.0])
            .series_stiffness(1000.0, 600.0)
            .friction(0.5)
            .command([0.004, 0.0, 0.0])
    }))?;
    let onset = |d: [f64; 3]| -> Result<f64, Failure> {
        let ramp = spatial::Ramp::load(spatial::Wrench::ZERO, spatial::Wrench::force(d));
        Ok(grasp.onset(&ramp)?.factor().ok_or("sticks without load")?)
    };
    let (sin, cos) = (TAU / 3.0).sin_cos();
    let directions = SphereGrid::new(8, 19).directions();
    for (k, &a) in directions.iter().enumerate() {
        let b = directions[(37 * k + 11) % directions.len()];
        let (wa, wb) = (onset(a)?, onset(b)?);
        let turned = onset([cos * a[0] - sin * a[1], sin * a[0] + cos * a[1], a[2]])?;
        assert!((turned - wa).abs() <= 1e-11 * wa, "{a:?}: {wa} against {turned}");
        if wa.is_finite() && wb.is_finite() {
            // Half way between two loads on the boundary nothing slides, because the region is convex.
            let between: [f64; 3] = std::array::from_fn(|k| 0.5 * (wa * a[k] + wb * b[k]));
            assert!(onset(between)? >= 1.0 - 1e-11, "{a:?} {b:?}");
        }
    }
    Ok(())
}
