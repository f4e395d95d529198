//! Force closure agrees with a theorem in the plane and with a second-order cone program in space. Form closure agrees with closed forms.

use grasp_lcp::ask::Grasp;
use grasp_lcp::nalgebra::{DMatrix, SVector};
use grasp_lcp::statics::Closure;
use grasp_lcp::{Error, planar, spatial};
use support::closure_margin::closure_margin;
use support::jaws::jaw;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// The wrench of a force at a point.
fn wrench<const C: usize>(point: [f64; C], force: &SVector<f64, C>) -> Vec<f64> {
    let planes: &[(usize, usize)] = if C == 2 { &[(0, 1)] } else { &[(1, 2), (2, 0), (0, 1)] };
    let moment = |&(i, j): &(usize, usize)| point[i] * force[j] - point[j] * force[i];
    force.iter().copied().chain(planes.iter().map(moment)).collect()
}

/// Checks the forces or the motion that an answer gives as its proof. Returns whether the answer says that the grasp is force-closed, if it decides
/// this.
fn is_closed<const C: usize>(grasp: &Grasp<C>, points: &[[f64; C]], mu: &[f64]) -> Option<bool> {
    match grasp.statics().force_closure().expect("no hand") {
        Closure::Closed { internal, .. } => {
            let mut sum = [0.0; 6];
            for (((force, frame), point), mu) in internal.iter().zip(grasp.frames()).zip(points).zip(mu) {
                for (sum, x) in sum.iter_mut().zip(wrench(*point, &(frame * force))) {
                    *sum += x;
                }
                let friction = force.rows(1, C - 1).norm();
                assert!(friction < mu * force[0] * (1.0 - 1e-9), "inside: {force:?}");
            }
            assert!(sum.iter().all(|x| x.abs() < 1e-14), "{sum:?}");
            Some(true)
        }
        Closure::Open { motion, .. } => {
            for ((frame, point), mu) in grasp.frames().zip(points).zip(mu) {
                // The work of a unit force along each axis of the contact, for the given motion.
                let local = SVector::<f64, C>::from_fn(|axis, _| {
                    let unit = wrench(*point, &frame.column(axis).into_owned());
                    unit.iter().zip(motion.components().iter()).map(|(w, v)| w * v).sum()
                });
                assert!(local[0] - mu * local.rows(1, C - 1).norm() > -1e-9, "works against {local:?}");
            }
            Some(false)
        }
        _ => None,
    }
}

#[test]
fn two_fingers_in_the_plane_by_the_line_between_them() {
    // V.-D. Nguyen, Constructing force-closure grasps, 1988: the line between the contacts lies inside both cones, and they face each other.
    let mut numbers = seeded(31);
    let (mut counts, mut told) = ([0; 2], 0);
    for _ in 0..samples(4000) {
        let point = |numbers: &mut Random| [numbers.signed(), numbers.signed()];
        let (a, b) = (point(&mut numbers), point(&mut numbers));
        let along = SVector::<f64, 2>::new(b[0] - a[0], b[1] - a[1]).normalize();
        let mut normal = |towards: SVector<f64, 2>| {
            (towards + 0.8 * SVector::<f64, 2>::new(numbers.signed(), numbers.signed())).normalize()
        };
        let (na, nb) = (normal(along), normal(-along));
        let mu = 0.2 + 0.5 * numbers.uniform();
        let contact = |p: [f64; 2], n: SVector<f64, 2>| {
            planar::Contact::new(p, n).series_stiffness(100.0, 50.0).friction(mu)
        };
        let grasp = planar::Grasp::new([contact(a, na), contact(b, nb)]).expect("two fingers");
        let cosine = 1.0 / mu.hypot(1.0);
        let (x, y) = (along.dot(&na), -along.dot(&nb));
        // The line between both contacts is inside both cones, or inside both opposite cones.
        let known = (x > cosine && y > cosine) || (x < -cosine && y < -cosine);
        let clear = (x.abs() - cosine).abs() > 1e-6 && (y.abs() - cosine).abs() > 1e-6;
        let Some(closed) = is_closed(&grasp, &[a, b], &[mu, mu]) else { continue };
        told += 1;
        if clear {
            assert_eq!(closed, known, "{a:?} {na:?} {b:?} {nb:?} {mu}");
            counts[usize::from(closed)] += 1;
        }
    }
    assert_met(&[(told, 3990), (counts[0], 1000), (counts[1], 500)]);
}

#[test]
fn on_the_round_cone_by_an_interior_point_method() {
    let mut numbers = seeded(32);
    let (mut counts, mut unclear) = ([0; 2], 0);
    for number in 0..samples(500) {
        let count = 3 + number % 3;
        let (mut contacts, mut points, mut friction) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..count {
            let outward = numbers.vector();
            let size = outward.iter().map(|x| x * x).sum::<f64>().sqrt();
            let point = outward.map(|x| x / size);
            let bent: [f64; 3] = numbers.vector();
            let normal: [f64; 3] = std::array::from_fn(|a| 0.5 * bent[a] - point[a]);
            let mu = 0.2 + 0.6 * numbers.uniform();
            contacts.push(spatial::Contact::new(point, normal).series_stiffness(1e3, 7e2).friction(mu));
            points.push(point);
            friction.push(mu);
        }
        let grasp = spatial::Grasp::new(contacts).expect("well posed");
        let map = |(point, frame): (&[f64; 3], &grasp_lcp::nalgebra::SMatrix<f64, 3, 3>)| {
            let columns = (0..3).flat_map(|a| wrench(*point, &frame.column(a).into_owned()));
            DMatrix::from_vec(6, 3, columns.collect())
        };
        let maps = points.iter().zip(grasp.frames()).map(map);
        let contacts: Vec<_> = maps.zip(friction.iter().copied()).collect();
        let margin = closure_margin(&contacts);
        let Some(closed) = is_closed(&grasp, &points, &friction) else {
            assert!(margin.is_none_or(|margin| margin.abs() < 1e-4), "{number}: {margin:?}");
            continue;
        };
        match margin {
            Some(margin) if margin.abs() > 1e-6 => {
                assert_eq!(closed, margin > 0.0, "{number}: {margin}");
                counts[usize::from(closed)] += 1;
            }
            // The interior-point method found the largest t to be zero: only zero forces balance.
            Some(_) if !closed => counts[0] += 1,
            _ => unclear += 1,
        }
    }
    assert_met(&[(counts[0], 100), (counts[1], 100)]);
    assert!(unclear < samples(5), "{counts:?} {unclear}");
}

#[test]
fn without_friction_it_takes_four_normals_in_the_plane() -> Result<(), Error> {
    // Without friction, a square with contacts at the middles of its sides can turn about its centre.
    let square = |off: f64| {
        let side =
            |p: [f64; 2], n: [f64; 2]| planar::Contact::new(p, n).series_stiffness(100.0, 50.0).friction(0.3);
        planar::Grasp::new([
            side([-1.0, off], [1.0, 0.0]),
            side([1.0, -off], [-1.0, 0.0]),
            side([off, 1.0], [0.0, -1.0]),
            side([-off, -1.0], [0.0, 1.0]),
        ])
    };
    assert!(matches!(square(0.0)?.statics().form_closure()?, Closure::Open { .. }));
    assert!(matches!(square(0.0)?.statics().force_closure()?, Closure::Closed { .. }));
    // If the four normal forces all have moments of the same sign, the square turns the opposite way.
    let Closure::Open { motion, .. } = square(0.3)?.statics().form_closure()? else { panic!("it turns") };
    assert!(motion.rotation().abs() > 0.1);
    // Two of these four normal forces have positive moments, and two have negative ones.
    let side = |p: [f64; 2], n: [f64; 2]| planar::Contact::new(p, n).series_stiffness(100.0, 50.0);
    let held = planar::Grasp::new([
        side([-1.0, 0.3], [1.0, 0.0]),
        side([1.0, -0.3], [-1.0, 0.0]),
        side([-0.3, 1.0], [0.0, -1.0]),
        side([0.3, -1.0], [0.0, 1.0]),
    ])?;
    let Closure::Closed { internal, .. } = held.statics().form_closure()? else { panic!("it is held") };
    assert!(internal.iter().all(|force| force[0] > 0.1 && force[1] == 0.0), "{internal:?}");
    // Without friction, form closure and force closure are the same.
    assert!(matches!(held.statics().force_closure()?, Closure::Closed { .. }));
    Ok(())
}

#[test]
fn a_pinch_in_space_turns_about_its_line() -> Result<(), Error> {
    let finger = |x: f64| jaw::<3>(x, [1e3, 1e3], 0.5);
    let Closure::Open { motion, .. } =
        spatial::Grasp::new([finger(-1.0), finger(1.0)])?.statics().force_closure()?
    else {
        panic!("it turns")
    };
    assert!((motion.rotation()[0].abs() - 1.0).abs() < 1e-12, "{motion:?}");
    Ok(())
}

#[test]
fn springs_play_no_part() -> Result<(), Error> {
    // Stiffnesses of 1e30 and 1e-30 do not change force closure.
    let finger = |angle: f64, k: f64| {
        let point = [angle.cos(), angle.sin(), 0.0];
        spatial::Contact::new(point, point.map(|x| -x)).series_stiffness(k, k).friction(0.6)
    };
    let closure = |k: [f64; 3]| {
        spatial::Grasp::new([finger(0.2, k[0]), finger(2.3, k[1]), finger(4.4, k[2])])?
            .statics()
            .force_closure()
    };
    let Closure::Closed { internal, .. } = closure([1.0; 3])? else { panic!("it is closed") };
    let Closure::Closed { internal: other, .. } = closure([1e-30, 1.0, 1e30])? else {
        panic!("it is closed")
    };
    assert!(internal.iter().zip(&other).all(|(a, b)| (a - b).norm() < 1e-14));
    Ok(())
}
