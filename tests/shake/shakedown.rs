//! The shakedown factor (the largest multiple of loads under which slip can cease) agrees with a closed form, and with Melan's theorem if slip does
//! not change normal forces. It is never below a factor at which a load path with closed contacts comes to rest.

use grasp_lcp::load_path::{Change, ContactChange};
use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
use grasp_lcp::{Error, Settings, spatial};
use nalgebra::{DMatrix, DVector};
use support::interior_point::{Oracle, interior_point};
use support::quadratic_program::QuadraticProgram;
use support::samples::{assert_met, samples, seeded};
use support::shaken::in_the_plane;

/// Whether the grasp comes to rest if each of the loads, multiplied by `times`, is applied and removed in turn.
fn rests(grasp: &Grasp, base: &Wrench, loads: &[Wrench], times: f64) -> Result<Option<bool>, Error> {
    let legs: Vec<_> = loads.iter().flat_map(|load| Leg::there_and_back(*load * times)).collect();
    Ok(grasp.shake(base, &legs)?.rests())
}

#[test]
fn feet_in_a_row_rest_up_to_it_and_not_beyond() -> Result<(), Error> {
    let mut random = seeded(7);
    let mut asked = 0;
    for _ in 0..samples(40) {
        let count = random.index(2, 4);
        let feet = (0..count).map(|i| {
            Contact::new([i as f64 + random.between(-0.2, 0.2), 0.0], [0.0, 1.0])
                .series_stiffness(10f64.powf(random.between(3.0, 4.0)), 10f64.powf(random.between(3.0, 4.0)))
                .friction(random.between(0.3, 0.8))
        });
        let grasp = Grasp::new(feet.collect::<Vec<_>>())?;
        let middle = 0.5 * (count - 1) as f64;
        let base = Wrench::force_at([random.between(-1.0, 1.0), -10.0], [middle, 0.0]);
        let loads = [1.0, -1.0]
            .map(|sign| Wrench::new([random.between(-0.5, 0.5), 0.0], sign * random.between(0.5, 1.0)));
        let Some(found) = grasp.statics().shakedown(base, &loads)? else { continue };
        assert!(!found.slips_change_normal_forces && found.factor > 0.0);
        // Where nothing but feet that open limits the loads, slips beyond are not excluded.
        let beyond = found.binding.iter().any(|foot| !foot.opens).then_some(false);
        assert_eq!([0.98, 1.02].map(|part| found.rests(part * found.factor)), [Some(true), beyond]);
        // The answer says that slips are too large if they exceed the limit of small motions.
        let places: Vec<f64> = grasp.contacts().iter().map(|foot| foot.point()[0]).collect();
        let centre = places.iter().sum::<f64>() / count as f64;
        let size = (places.iter().map(|x| (x - centre).powi(2)).sum::<f64>() / count as f64).sqrt();
        let most = found.slips.iter().map(nalgebra::Matrix::norm).fold(0.0, f64::max) / size;
        assert!(found.too_far.is_none(), "{most}");
        let mut settings = Settings::default();
        for (part, is_far) in [(0.99, most > 0.0), (1.01, false)] {
            settings.small_motions.slip = part * most.max(1e-9);
            let told = grasp.with(&settings).statics().shakedown(base, &loads)?.expect("as before");
            assert_eq!(told.too_far.is_some(), is_far);
            assert_eq!(told.to_string().starts_with("GOES TOO FAR with these slips: "), is_far, "{told}");
        }
        // No foot may open under the loads.
        let most = loads.map(|load| load * (1.02 * found.factor) + base);
        let closed = |load: &Wrench| -> Result<bool, Error> {
            let rigid = Grasp::new(
                grasp.contacts().iter().map(|c| c.clone().friction(f64::INFINITY)).collect::<Vec<_>>(),
            )?;
            let outcome = rigid.solve(load)?;
            Ok(outcome
                .equilibrium()
                .is_some_and(|held| held.contacts.iter().all(|c| c.normal_force() > 0.01)))
        };
        if !(closed(&most[0])? && closed(&most[1])? && closed(&base)?) {
            continue;
        }
        asked += 1;
        assert_eq!(rests(&grasp, &base, &loads, 0.98 * found.factor)?, Some(true), "{found:?}");
        assert_eq!(rests(&grasp, &base, &loads, 1.02 * found.factor)?, Some(false), "{found:?}");
        assert!(!found.binding.is_empty());
    }
    assert_met(&[(asked, 15)]);
    Ok(())
}

/// A lamp of 10 N hangs on a rope and a rail. Under twice that weight upwards the rope is slack: nothing slides, and no order of loads is excluded.
#[test]
fn a_rope_that_goes_slack_does_not_slide() -> Result<(), Error> {
    use grasp_lcp::planar::{Bodies, Body, Link};
    let lamp = Bodies::new([Body::new("lamp").load(Wrench::force([0.0, -10.0]))]).links([
        Link::cable([0.0, 0.1], [0.0, 1.0]).stiffness(1e4).name("rope").to_ground("lamp"),
        Link::slide([0.0, 0.0], [0.0, 1.0], 0.2).name("rail").to_ground("lamp"),
    ]);
    let found =
        lamp.grasp()?.statics().shakedown(Wrench::ZERO, &[Wrench::force([0.0, 20.0])])?.expect("found");
    assert!((found.factor - 0.5).abs() < 1e-9 && found.rests(1.0).is_none(), "{found:?}");
    assert!(matches!(&found.binding[..], [rope] if rope.opens && rope.contact.label == "rope"), "{found:?}");
    assert!(found.to_string().ends_with(". With more, rope goes slack"), "{found}");
    Ok(())
}

#[test]
fn no_path_rests_beyond_it_while_contacts_are_closed() -> Result<(), Error> {
    let mut random = seeded(11);
    let (mut beyond, mut coupled, mut kept) = (0, 0, [0; 3]);
    for _ in 0..samples(80) {
        let drawn = in_the_plane(&mut random)?;
        let loads = [0, 1].map(|_| {
            Wrench::new(
                [random.between(-1.0, 1.0), random.between(-1.0, 1.0)],
                0.02 * random.between(-1.0, 1.0),
            )
        });
        let rests = drawn.grasp.hold(drawn.base)?.holds() == Some(true);
        let Some(found) = drawn.grasp.statics().shakedown(drawn.base, &loads)? else {
            kept[usize::from(rests)] += 1;
            continue;
        };
        kept[2] += 1;
        if !found.factor.is_finite() {
            continue;
        }
        coupled += usize::from(found.slips_change_normal_forces);
        let legs: Vec<_> =
            loads.iter().flat_map(|load| Leg::there_and_back(*load * (1.02 * found.factor))).collect();
        let shaken = drawn.grasp.shake(drawn.base, &legs)?;
        let cycles = vec![legs; shaken.cycles.clamp(2, 300)].concat();
        let mut path = drawn.grasp.follow(drawn.base, &cycles)?;
        let is_open = path.state().is_none_or(|rest| rest.contacts.iter().any(|contact| contact.gap > 0.0));
        let is_opening = |change: &ContactChange<2>| change.what == Change::Opens;
        let opens = path.run().iter().any(|event| event.changes.iter().any(is_opening));
        if opens || is_open {
            continue;
        }
        beyond += 1;
        assert_ne!(shaken.rests(), Some(true), "{found:?}");
    }
    println!(
        "no slips found: {} that do not rest, {} that do; {} found; {beyond} asked",
        kept[0], kept[1], kept[2]
    );
    assert_met(&[(beyond, 6), (coupled, 6)]);
    Ok(())
}

#[test]
fn with_less_friction_once_they_slide_the_order_decides() -> Result<(), Error> {
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e3, 1e3).friction(0.5);
    let rocked = [1.0, -1.0].map(|moment| Wrench::new([0.0, 0.0], moment));
    let base = Wrench::new([1.5, -10.0], 0.0);
    let asked = |feet: [Contact; 2]| -> Result<_, Error> {
        let found = Grasp::new(feet)?.statics().shakedown(base, &rocked)?.expect("rests");
        Ok([0.5, 1.01].map(|part| found.rests(part * found.factor)))
    };
    assert_eq!(asked([foot(-1.0), foot(1.0)])?, [Some(true), Some(false)]);
    assert_eq!(asked([foot(-1.0).kinetic(0.4), foot(1.0)])?, [None, Some(false)]);
    Ok(())
}

#[test]
fn in_space_a_polygon_around_the_cone_bounds_it() -> Result<(), Error> {
    // Four feet carry a pull of 3 N along a corner of the polygon, and together have a friction limit of 5 N. A moment m about one axis rocks them,
    // so that they carry 2.5 ± m / 4 N each.
    let foot = |x: f64, y: f64| {
        spatial::Contact::new([x, y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(1e3, 1e3).friction(0.5)
    };
    let table = spatial::Grasp::new([foot(1.0, 1.0), foot(-1.0, 1.0), foot(1.0, -1.0), foot(-1.0, -1.0)])?;
    let base = spatial::Wrench::force([3.0, 0.0, -10.0]);
    let rocked = [1.0, -1.0].map(|moment| spatial::Wrench::new([0.0; 3], [0.0, moment, 0.0]));
    let found = table.statics().shakedown(base, &rocked)?.expect("rests without rocking");
    // Slip can distribute the pull in any way, so the feet carry up to four times μ (2.5 - λ / 4) at the load factor λ. At a corner of the
    // circumscribed octagon this limit is 1 / cos 22.5° times as large.
    let corner = (std::f64::consts::PI / 8.0).cos();
    let exact = 4.0 * (2.5 - 3.0 * corner / (4.0 * 0.5));
    assert!((found.factor - exact).abs() < 1e-9, "{} {exact}", found.factor);
    Ok(())
}

/// The shakedown factor by an interior-point method, from points, normals and springs alone.
fn by_an_interior_point(grasp: &Grasp, base: &Wrench, loads: &[Wrench]) -> Option<f64> {
    let n = grasp.len();
    let (mut g, mut k, mut a) =
        (DMatrix::zeros(3, 2 * n), DMatrix::zeros(2 * n, 2 * n), DVector::zeros(2 * n));
    for (i, (contact, frame)) in grasp.contacts().iter().zip(grasp.frames()).enumerate() {
        let p = contact.point();
        for axis in 0..2 {
            let e = frame.column(axis);
            g.column_mut(2 * i + axis).copy_from_slice(&[e[0], e[1], p[0] * e[1] - p[1] * e[0]]);
            k[(2 * i + axis, 2 * i + axis)] = contact.series_stiffness_of_axes()[axis];
            a[2 * i + axis] = contact.commanded()[axis];
        }
    }
    let t = (&g * &k * g.transpose()).try_inverse()?;
    // Balance of forces and moments with the contact map G, stiffnesses K, commands a, motion q and load W: G K (a - Gᵀq) + W = 0.
    let forces = |a: &DVector<f64>, w: &DVector<f64>| &k * (a - g.transpose() * (&t * (&g * &k * a + w)));
    let wrench = |load: &Wrench| DVector::from_column_slice(load.components());
    let none = DVector::zeros(2 * n);
    let rest = forces(&a, &wrench(base));
    let slips: Vec<_> = (0..n)
        .map(|i| {
            let mut slip = none.clone();
            slip[2 * i + 1] = -1.0 / k[(2 * i + 1, 2 * i + 1)];
            forces(&slip, &DVector::zeros(3))
        })
        .collect();
    let (mut rows, mut right) = (Vec::new(), Vec::new());
    for load in std::iter::once(None).chain(loads.iter().map(Some)) {
        let more = load.map_or_else(|| none.clone(), |load| forces(&none, &wrench(load)));
        for (i, sign) in (0..n).flat_map(|i| [(i, 1.0), (i, -1.0)]) {
            let mu = grasp.contacts()[i].friction_coefficient();
            let margin = |f: &DVector<f64>| mu * f[2 * i] - sign * f[2 * i + 1];
            rows.push(margin(&more));
            rows.extend(slips.iter().map(margin));
            right.push(-margin(&rest));
        }
    }
    let mut cost = DVector::zeros(n + 1);
    cost[0] = -1.0;
    let program = QuadraticProgram {
        g: cost,
        h: DMatrix::zeros(n + 1, n + 1),
        a: DMatrix::zeros(0, n + 1),
        c: DVector::zeros(0),
        b: DMatrix::from_row_slice(right.len(), n + 1, &rows),
        d: DVector::from_vec(right),
    };
    match interior_point(&program) {
        Oracle::Minimum(x, tolerance) if tolerance < 1e-6 => Some(x[0]),
        _ => None,
    }
}

#[test]
fn an_interior_point_method_finds_the_same() -> Result<(), Error> {
    let mut random = seeded(19);
    let (mut asked, mut silent) = (0, 0);
    while asked < samples(167) {
        let drawn = in_the_plane(&mut random)?;
        let loads = [0, 1, 2].map(|_| {
            Wrench::new(
                [random.between(-1.0, 1.0), random.between(-1.0, 1.0)],
                0.02 * random.between(-1.0, 1.0),
            )
        });
        let Some(found) = drawn.grasp.statics().shakedown(drawn.base, &loads)? else { continue };
        if !found.factor.is_finite() {
            continue;
        }
        asked += 1;
        match by_an_interior_point(&drawn.grasp, &drawn.base, &loads) {
            Some(factor) => {
                assert!((found.factor - factor).abs() <= 1e-7 * factor, "{} {factor}", found.factor);
            }
            None => silent += 1,
        }
    }
    println!("{asked} {silent}");
    assert!(silent < samples(4), "{silent}");
    Ok(())
}

/// Slips of a pinch leave no residual forces. So no order of loads is carried above the load at which a jaw slips: 2 μ N, of which each jaw carries
/// half. The residual forces of unit slips are rounding errors alone.
#[test]
fn of_a_pinch_it_is_the_static_limit() -> Result<(), Error> {
    let mut random = seeded(29);
    for _ in 0..samples(60) {
        let half = random.between(0.01, 0.1);
        let [normal, tangential] = [1e3, 1e3].map(|unit| unit * random.between(0.5, 3.0));
        let (press, friction) = (random.between(5.0, 20.0), random.between(0.2, 0.9));
        let limit = 2.0 * friction * press;
        let jaw = |x: f64| {
            Contact::new([x, 0.0], [-x, 0.0])
                .series_stiffness(normal, tangential)
                .friction(friction)
                .pressed_with(press)
        };
        let grasp = Grasp::new([jaw(-half), jaw(half)])?;
        let found = grasp.statics().shakedown(Wrench::ZERO, &[Wrench::force([0.0, -15.0])])?.expect("rests");
        assert!((15.0 * found.factor / limit - 1.0).abs() < 1e-9, "{} {limit}", 15.0 * found.factor);
        assert!(!found.slips_change_normal_forces);
        let jaw = |x: f64| {
            spatial::Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0])
                .series_stiffness(normal, tangential)
                .friction(friction)
                .pressed_with(press)
        };
        let loads = [spatial::Wrench::force([0.0, 0.0, -15.0])];
        let grasp = spatial::Grasp::new([jaw(-half), jaw(half)])?;
        let found = grasp.statics().shakedown(spatial::Wrench::ZERO, &loads)?.expect("rests");
        // The polygon around the round cone reaches out farther by a factor of up to 1 / cos(π / facets).
        let facets = grasp.settings().cone.facets() as f64;
        let excess = 15.0 * found.factor / limit * (std::f64::consts::PI / facets).cos();
        assert!(excess < 1.0 + 1e-9 && 15.0 * found.factor > limit * (1.0 - 1e-9), "{excess}");
    }
    Ok(())
}
