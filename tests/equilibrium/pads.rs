//! What an answer reports for a soft fingertip agrees with sums over its points.

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{ContactState, Equilibrium, WholeAnswer};
use grasp_lcp::{planar, spatial};
use nalgebra::{SVector, Vector3};
use support::jaws::jaw;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// The vector extended to three components. In the plane the third component is zero.
fn wide<const C: usize>(v: &SVector<f64, C>) -> Vector3<f64> {
    Vector3::from_fn(|a, _| v.get(a).copied().unwrap_or(0.0))
}

/// Checks all pads of an equilibrium. Returns how many slide at all points, at some, and at none.
fn check<const C: usize>(grasp: &Grasp<C>, state: &Equilibrium<C>, random: &mut Random) -> [usize; 3] {
    let frames: Vec<_> = grasp.frames().copied().collect();
    let largest = state.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max);
    let mut seen = [0; 3];
    for pad in &state.pads {
        let points = &state.contacts[pad.range()];
        let at: Vec<_> = grasp.contacts()[pad.range()].iter().map(|contact| wide(&contact.point())).collect();
        let middle = at.iter().sum::<Vector3<f64>>() / at.len() as f64;
        let force = points.iter().fold(Vector3::zeros(), |sum, c| sum + wide(&c.force_world));
        let moment = points
            .iter()
            .zip(&at)
            .fold(Vector3::zeros(), |sum, (c, r)| sum + (r - middle).cross(&wide(&c.force_world)));
        let frame = frames[pad.first];
        for axis in 0..C {
            let along = wide(&frame.column(axis).into_owned());
            assert!((pad.force()[axis] - along.dot(&force)).abs() < 1e-12 * largest);
            let expected = if C == 2 { moment[2] } else { along.dot(&moment) };
            assert!((pad.moment()[axis % pad.moment().len()] - expected).abs() < 1e-13 * largest);
        }
        let sliding = points.iter().filter(|c| matches!(c.state, ContactState::Sliding { .. })).count();
        let open = points.iter().filter(|c| c.state == ContactState::Separated).count();
        assert_eq!((pad.points, pad.sliding, pad.open), (points.len(), sliding, open));
        let all_slide = sliding + open == points.len();
        assert_eq!(pad.margin == 0.0, all_slide, "{state}");
        seen[if all_slide { 0 } else { usize::from(sliding == 0) + 1 }] += 1;
        // With the same normal forces, the pad can carry an additional force of the size of the margin in any tangential direction.
        let towards =
            SVector::<f64, C>::from_fn(|a, _| if a == 0 { 0.0 } else { random.normal() }).normalize();
        let mut carried = SVector::<f64, C>::zeros();
        for point in points {
            let more = point.force + towards * point.margin;
            carried += towards * point.margin;
            let mu = grasp.contacts()[pad.first].friction_coefficient();
            let friction = more.iter().skip(1).fold(0.0, |h: f64, f| h.hypot(*f));
            assert!(friction <= mu * more[0] + 1e-12 * largest, "{friction} {more}");
        }
        assert!((carried.norm() - pad.margin).abs() < 1e-12 * largest);
    }
    let told: Vec<_> = state.whole_contacts().map(|told| matches!(told, WholeAnswer::Pad(_))).collect();
    assert_eq!(told.iter().filter(|is_pad| **is_pad).count(), state.pads.len());
    let points: usize = state.pads.iter().map(|pad| pad.points).sum();
    assert_eq!(told.len() - state.pads.len(), state.contacts.len() - points);
    seen
}

#[test]
fn in_the_plane() -> Result<(), grasp_lcp::Error> {
    let mut random = seeded(7);
    let mut seen = [0; 3];
    let pad = planar::SoftFingertip::pad(0.02, 2, planar::Pressure::Uniform)?;
    let jaw = |x: f64| jaw::<2>(x, [2e3, 1e3], 0.4).pressed_with(10.0);
    let point = planar::Contact::new([0.0, -0.04], [0.0, 1.0]).series_stiffness(2e3, 1e3).friction(0.2);
    let grasp =
        planar::Grasp::new([pad.contacts(&jaw(-0.03))?, vec![point], pad.contacts(&jaw(0.03))?].concat())?;
    for _ in 0..samples(150) {
        let [x, y, m] = std::array::from_fn(|_| 4.0 * random.normal());
        let outcome = grasp.solve(planar::Wrench::new([x, y], 0.01 * m))?;
        let Some(state) = outcome.equilibrium() else { continue };
        assert_eq!(state.pads.len(), 2);
        check(&grasp, state, &mut random).into_iter().zip(&mut seen).for_each(|(more, all)| *all += more);
    }
    assert!(seen.iter().all(|count| *count > samples(2)), "{seen:?}");
    Ok(())
}

#[test]
fn in_space() -> Result<(), grasp_lcp::Error> {
    let mut random = seeded(8);
    let mut seen = [0; 3];
    let tip = spatial::SoftFingertip::ring(0.01, 5)?;
    let jaw = |x: f64, y: f64| {
        let contact = spatial::Contact::new([x, y, 0.0], [-x, -y, 0.0]).series_stiffness(2e3, 1e3);
        contact.friction(0.4).pressed_with(10.0)
    };
    let fingers = [jaw(-0.03, 0.0), jaw(0.02, 0.02), jaw(0.02, -0.02)];
    let points = fingers.iter().map(|finger| tip.contacts(finger)).collect::<Result<Vec<_>, _>>()?.concat();
    let grasp = spatial::Grasp::new(points)?;
    for _ in 0..samples(75) {
        let [x, y, z, a, b, c] = std::array::from_fn(|_| 5.0 * random.normal());
        let load = spatial::Wrench::new([x, y, z], [0.01 * a, 0.01 * b, 0.01 * c]);
        // After the path some points have slipped, and others have not.
        let verdict = grasp.hold(load)?;
        let Some(state) = verdict.state.as_ref().or_else(|| verdict.lost.as_ref()?.state.as_ref()) else {
            continue;
        };
        check(&grasp, state, &mut random).into_iter().zip(&mut seen).for_each(|(more, all)| *all += more);
    }
    assert_met(&[(seen[1], 2), (seen[2], 2)]);
    Ok(())
}
