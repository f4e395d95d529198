//! The measure of Ferrari and Canny agrees with the enumeration of all faces of small hulls. On the round cone, many descents on a separate support
//! function find no lower value.

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::Contact;
use grasp_lcp::nalgebra::{DMatrix, SMatrix, SVector};
use grasp_lcp::statics::{Budget, Closure, WrenchBall, WrenchScale};
use grasp_lcp::{Error, PolygonCone, PolygonFit, Settings, planar, spatial};
use support::jaws::jaw;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// A point, its normal, and friction.
type Datum<const C: usize> = (SVector<f64, C>, SVector<f64, C>, f64);

/// The wrench of a force at a point, moments about the origin.
fn wrench<const D: usize, const C: usize>(
    point: &SVector<f64, C>,
    force: &SVector<f64, C>,
) -> SVector<f64, D> {
    let planes: &[(usize, usize)] = if C == 2 { &[(0, 1)] } else { &[(1, 2), (2, 0), (0, 1)] };
    let mut wrench = SVector::<f64, D>::from_fn(|k, _| if k < C { force[k] } else { 0.0 });
    for (k, &(i, j)) in planes.iter().enumerate() {
        wrench[C + k] = point[i] * force[j] - point[j] * force[i];
    }
    wrench
}

/// Moments about the origin, divided by 1 m.
fn plain<const C: usize>() -> WrenchScale<C> {
    WrenchScale { about: [0.0; C], length: 1.0 }
}

fn drawn<const C: usize>(numbers: &mut Random, contacts: usize) -> Vec<Datum<C>> {
    let mut datum = || {
        let out = SVector::<f64, C>::from_fn(|_, _| numbers.signed()).normalize();
        let tilt = SVector::<f64, C>::from_fn(|_, _| 0.4 * numbers.signed());
        (out * (0.7 + 0.3 * numbers.uniform()), (tilt - out).normalize(), 0.2 + 0.8 * numbers.uniform())
    };
    (0..contacts).map(|_| datum()).collect()
}

fn grasp_of<const C: usize>(data: &[Datum<C>]) -> Grasp<C> {
    let contact = |(point, normal, mu): &Datum<C>| {
        Contact::new(*point, *normal).series_stiffness_axes(SVector::<f64, C>::repeat(100.0)).friction(*mu)
    };
    Grasp::new(data.iter().map(contact)).expect("valid")
}

/// The distance of the origin from the nearest face of the convex hull of the points, negative outside. Faces are the planes through D points with
/// all others on one side.
fn hull_radius<const D: usize>(points: &[SVector<f64, D>]) -> Option<f64> {
    let mut chosen: Vec<usize> = (0..D).collect();
    let mut radius = f64::INFINITY;
    loop {
        let rows = DMatrix::from_fn(D, D + 1, |k, c| if c < D { points[chosen[k]][c] } else { -1.0 });
        // The null vector of these rows is (v, c) for the plane v·p = c through all chosen points.
        let squares = (rows.transpose() * &rows).symmetric_eigen();
        let order = squares.eigenvalues.as_slice();
        let least = (0..=D).min_by(|&a, &b| order[a].total_cmp(&order[b]))?;
        let second = order
            .iter()
            .enumerate()
            .filter(|(k, _)| *k != least)
            .map(|(_, x)| *x)
            .fold(f64::INFINITY, f64::min);
        let null = squares.eigenvectors.column(least);
        let v = SVector::<f64, D>::from_fn(|k, _| null[k]);
        if second > 1e-10 && v.norm() > 1e-8 {
            let (v, c) = (v / v.norm(), null[D] / v.norm());
            let beyond = points.iter().map(|p| v.dot(p) - c);
            let (low, high) = beyond.fold((0.0_f64, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
            if high < 1e-9 {
                radius = radius.min(c);
            } else if low > -1e-9 {
                radius = radius.min(-c);
            }
        }
        let Some(k) = (0..D).rev().find(|&k| chosen[k] < points.len() - D + k) else { break };
        chosen[k] += 1;
        for j in k + 1..D {
            chosen[j] = chosen[j - 1] + 1;
        }
    }
    radius.is_finite().then_some(radius)
}

fn compare<const D: usize, const C: usize>(ball: &WrenchBall<C>, points: &[SVector<f64, D>]) -> bool {
    let known = hull_radius(points).expect("has faces").max(0.0);
    let largest = points.iter().map(SVector::norm).fold(0.0, f64::max);
    assert!(ball.at_least <= known + 1e-9 * largest, "{ball:?} {known}");
    assert!(ball.at_most >= known - 1e-9 * largest, "{ball:?} {known}");
    assert!(ball.at_most - ball.at_least <= 2e-9 * largest, "{ball:?} {known}");
    known > 0.0
}

#[test]
fn in_the_plane_against_all_faces_of_the_hull() {
    let mut numbers = seeded(51);
    let mut closed = [0; 2];
    for number in 0..samples(75) {
        let data = drawn::<2>(&mut numbers, 2 + number % 3);
        let grasp: planar::Grasp = grasp_of(&data);
        let edges = |(point, normal, mu): &Datum<2>| {
            let tangent = SVector::from([normal[1], -normal[0]]);
            [-1.0, 1.0].map(|side| wrench::<3, 2>(point, &(normal + tangent * (side * mu))))
        };
        let edges: Vec<[SVector<f64, 3>; 2]> = data.iter().map(edges).collect();
        let mut total: Vec<_> = edges.iter().flatten().copied().collect();
        total.push(SVector::zeros());
        let settings = Settings::default();
        let ball = grasp
            .with(&settings)
            .statics()
            .ferrari_canny_scaled(Budget::Total(1.0), &plain())
            .expect("valid");
        closed[0] += usize::from(compare(&ball, &total));
        // All sums that take, from each contact, no force or a force along one edge of its cone.
        let mut each = vec![SVector::zeros()];
        for edges in &edges {
            each = each.iter().flat_map(|sum| [*sum, sum + edges[0], sum + edges[1]]).collect();
        }
        if data.len() < 4 {
            let ball = grasp
                .with(&settings)
                .statics()
                .ferrari_canny_scaled(Budget::Each(1.0), &plain())
                .expect("valid");
            closed[1] += usize::from(compare(&ball, &each));
        }
    }
    println!("{closed:?}");
    assert_met(&[(closed[0], 12), (closed[1], 6)]);
}

#[test]
fn in_space_against_all_faces_of_the_hull() {
    let mut numbers = seeded(53);
    let mut closed = 0;
    let cone = PolygonCone::new(4, PolygonFit::Inscribed).expect("a square");
    let settings = Settings::default().with_cone(cone).on_the_polygon();
    for _ in 0..samples(30) {
        let data = drawn::<3>(&mut numbers, 3);
        let grasp: spatial::Grasp = grasp_of(&data);
        let mut points = vec![SVector::zeros()];
        for ((point, _, mu), frame) in data.iter().zip(grasp.frames()) {
            let frame: &SMatrix<f64, 3, 3> = frame;
            for corner in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
                points.push(wrench::<6, 3>(
                    point,
                    &(frame * SVector::from([1.0, mu * corner[0], mu * corner[1]])),
                ));
            }
        }
        let ball = grasp
            .with(&settings)
            .statics()
            .ferrari_canny_scaled(Budget::Total(1.0), &plain())
            .expect("valid");
        closed += usize::from(compare(&ball, &points));
    }
    println!("{closed}");
    assert_met(&[(closed, 4)]);
}

/// The support function of all wrenches of contact forces within a budget of 1 N, on the round cone: their largest product with v.
fn reach(data: &[Datum<3>], budget: Budget, v: &SVector<f64, 6>) -> f64 {
    let work = |(point, normal, mu): &Datum<3>| {
        let u = SVector::<f64, 3>::from_fn(|axis, _| {
            let mut force = SVector::zeros();
            force[axis] = 1.0;
            wrench::<6, 3>(point, &force).dot(v)
        });
        let along = normal.dot(&u);
        (along + mu * (u - normal * along).norm()).max(0.0)
    };
    let works = data.iter().map(work);
    match budget {
        Budget::Each(_) => works.sum(),
        Budget::Total(_) => works.fold(0.0, f64::max),
    }
}

/// Checks that random descents from many directions, with shorter steps after failures, find no lower value.
fn no_descent_finds_less(
    numbers: &mut Random,
    data: &[Datum<3>],
    budget: Budget,
    ball: &WrenchBall<3>,
    within: f64,
) {
    let random = |numbers: &mut Random| SVector::<f64, 6>::from_fn(|_, _| numbers.signed());
    for _ in 0..40 {
        let mut v = random(numbers).normalize();
        let (mut value, mut length) = (reach(data, budget, &v), 0.5);
        while length > 1e-4 {
            let next = (v + random(numbers) * length).normalize();
            let there = reach(data, budget, &next);
            if there < value {
                (v, value) = (next, there);
                length *= 1.3;
            } else {
                length *= 0.9;
            }
        }
        assert!(value > ball.at_least - within, "{value} {ball:?}");
    }
}

#[test]
fn where_symmetry_ends_the_search_both_bounds_hold() {
    // Evenly spaced fingers on a ring have many equally weak directions, and a hull with thin faces.
    let mut numbers = seeded(59);
    for fingers in [3_u32, 4, 6] {
        let finger = |k: u32| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / f64::from(fingers)).sin_cos();
            (SVector::from([cos, sin, 0.0]), SVector::from([-cos, -sin, 0.0]), 0.6)
        };
        let data: Vec<Datum<3>> = (0..fingers).map(finger).collect();
        let grasp: spatial::Grasp = grasp_of(&data);
        for budget in [Budget::Total(1.0), Budget::Each(1.0)] {
            let ball = grasp
                .with(&Settings::default())
                .statics()
                .ferrari_canny_scaled(budget, &plain())
                .expect("valid");
            println!("{fingers} {budget:?}: {} {}", ball.at_least, ball.at_most);
            assert!(ball.at_most - ball.at_least < 0.01 * ball.at_most, "{ball:?}");
            let weakest = -SVector::<f64, 6>::from_fn(|k, _| ball.weakest.to_vector()[k]);
            assert!((reach(&data, budget, &weakest) - ball.at_most).abs() < 1e-9, "{ball:?}");
            no_descent_finds_less(&mut numbers, &data, budget, &ball, 1e-9);
        }
    }
}

#[test]
fn on_the_round_cone_no_descent_finds_less() {
    let mut numbers = seeded(57);
    let mut closed = 0;
    for number in 0..samples(12) {
        let data = drawn::<3>(&mut numbers, 3 + number % 3);
        let grasp: spatial::Grasp = grasp_of(&data);
        let budget = if number % 2 == 0 { Budget::Total(1.0) } else { Budget::Each(1.0) };
        let ball =
            grasp.with(&Settings::default()).statics().ferrari_canny_scaled(budget, &plain()).expect("valid");
        let is_closed = matches!(grasp.statics().force_closure().expect("no hand"), Closure::Closed { .. });
        assert_eq!(ball.at_least > 0.0, is_closed, "{ball:?}");
        if !is_closed {
            continue;
        }
        closed += 1;
        assert!(ball.at_most - ball.at_least < 3e-9, "{ball:?}");
        let weakest = -SVector::<f64, 6>::from_fn(|k, _| ball.weakest.to_vector()[k]);
        assert!((weakest.norm() - 1.0).abs() < 1e-12);
        assert!((reach(&data, budget, &weakest) - ball.at_most).abs() < 1e-9, "{ball:?}");
        no_descent_finds_less(&mut numbers, &data, budget, &ball, 1e-9);
    }
    println!("{closed}");
    assert_met(&[(closed, 3)]);
}

#[test]
fn what_has_no_ball_has_none() -> Result<(), Error> {
    // Two fingers do not resist a rotation about their line.
    let finger = |x: f64| jaw::<3>(x, [1e3, 1e3], 0.5);
    let pinch = spatial::Grasp::new([finger(-1.0), finger(1.0)])?;
    let ball = pinch.statics().ferrari_canny(Budget::Each(1.0))?;
    assert!(ball.at_least == 0.0 && ball.at_most == 0.0);
    assert!(ball.weakest.moment()[0].abs() > 0.99, "{ball:?}");
    Ok(())
}

#[test]
fn what_is_no_budget_and_no_scale_is_refused() -> Result<(), Error> {
    let finger = |x: f64| jaw::<2>(x, [1e3, 1e3], 0.5);
    let pinch = planar::Grasp::new([finger(-1.0), finger(1.0)])?;
    let refused = pinch.statics().ferrari_canny(Budget::Each(0.0)).unwrap_err();
    assert!(matches!(refused, Error::Argument { what, value: 0.0, .. } if what.starts_with("budget")));
    let scale = WrenchScale { about: [0.0, f64::NAN], length: 1.0 };
    let refused = pinch
        .with(&Settings::default())
        .statics()
        .ferrari_canny_scaled(Budget::Each(1.0), &scale)
        .unwrap_err();
    let Error::Argument { what, value, .. } = refused else { panic!("{refused}") };
    assert!(what.ends_with("the moments") && value.is_nan(), "{what} {value}");
    let scale = WrenchScale { about: [0.0; 2], length: -1.0 };
    let refused = pinch
        .with(&Settings::default())
        .statics()
        .ferrari_canny_scaled(Budget::Each(1.0), &scale)
        .unwrap_err();
    assert!(matches!(refused, Error::Argument { what, value: -1.0, .. } if what.ends_with("wrench scale")));
    let glued = planar::Grasp::new([finger(-1.0), finger(1.0).bonded()])?;
    let refused = glued.statics().ferrari_canny(Budget::Each(1.0)).unwrap_err();
    assert!(
        matches!(&refused, Error::Unlimited { question: "ferrari_canny", contact } if contact.index == 1),
        "{refused}"
    );
    Ok(())
}
