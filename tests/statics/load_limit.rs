//! Limit loads agree with a second-order cone program, and the returned forces and motions prove both bounds.

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::nalgebra::{DMatrix, DVector, SVector};
use grasp_lcp::statics::{Budget, LoadLimit};
use grasp_lcp::{Error, planar, spatial};
use support::jaws::jaw;
use support::limit_analysis::{Bound, load_limit};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

type Datum<const C: usize> = (SVector<f64, C>, SVector<f64, C>, f64);

fn wrench<const C: usize>(point: &SVector<f64, C>, force: &SVector<f64, C>) -> Vec<f64> {
    let planes: &[(usize, usize)] = if C == 2 { &[(0, 1)] } else { &[(1, 2), (2, 0), (0, 1)] };
    let moment = |&(i, j): &(usize, usize)| point[i] * force[j] - point[j] * force[i];
    force.iter().copied().chain(planes.iter().map(moment)).collect()
}

fn drawn<const C: usize>(numbers: &mut Random, contacts: usize) -> Vec<Datum<C>> {
    let mut datum = || {
        let out = SVector::<f64, C>::from_fn(|_, _| numbers.signed()).normalize();
        let tilt = SVector::<f64, C>::from_fn(|_, _| 0.4 * numbers.signed());
        // Lengths are in millimetres, because units do not matter.
        (out * (700.0 + 300.0 * numbers.uniform()), (tilt - out).normalize(), 0.2 + 0.8 * numbers.uniform())
    };
    (0..contacts).map(|_| datum()).collect()
}

#[derive(Debug, Default)]
struct Tally {
    factors: usize,
    no_base: usize,
    unknown: usize,
    worst: f64,
}

impl Tally {
    fn compare<const D: usize, const C: usize>(&mut self, numbers: &mut Random, contacts: usize) {
        let data = drawn::<C>(numbers, contacts);
        let contact = |(point, normal, mu): &Datum<C>| {
            Contact::new(*point, *normal)
                .series_stiffness_axes(SVector::<f64, C>::repeat(100.0))
                .friction(*mu)
        };
        let grasp = Grasp::<C>::new(data.iter().map(contact)).expect("valid");
        let mut load = |size: f64| {
            SVector::<f64, D>::from_fn(|k, _| numbers.signed() * size * if k < C { 1.0 } else { 700.0 })
        };
        let (base, rate) = (load(0.3), load(1.0));
        let (budget, bound) = if contacts.is_multiple_of(2) {
            (Budget::Each(2.0), Bound::Each(2.0))
        } else {
            (Budget::Total(4.0), Bound::Total(4.0))
        };
        let map = |((point, _, mu), frame): (&Datum<C>, _)| {
            let frame: &nalgebra::SMatrix<f64, C, C> = frame;
            let columns: Vec<f64> =
                (0..C).flat_map(|axis| wrench(point, &frame.column(axis).into_owned())).collect();
            // Moments are divided by 1 m for the interior-point method.
            let mut map = DMatrix::from_column_slice(columns.len() / C, C, &columns);
            map.rows_mut(C, columns.len() / C - C).scale_mut(1e-3);
            (map, *mu)
        };
        let maps: Vec<_> = data.iter().zip(grasp.frames()).map(map).collect();
        let scaled =
            |load: &SVector<f64, D>| DVector::from_fn(D, |k, _| if k < C { load[k] } else { load[k] * 1e-3 });
        // The largest multiple of the base load that the contacts balance. If it is less than one, the base load itself is not balanced.
        let times = load_limit(&maps, &DVector::zeros(D), &scaled(&base), bound).unwrap();
        let known = load_limit(&maps, &scaled(&base), &scaled(&rate), bound).filter(|_| times > 1.0);
        let [base, rate] = [base, rate].map(|w| Wrench::from_components(w.as_slice()));
        match (grasp.statics().load_limit(base, rate, budget).expect("valid"), known) {
            (LoadLimit::Factor { at_least, at_most, forces, motion, .. }, Some(known)) => {
                self.factors += 1;
                self.worst = self.worst.max((at_most - known).abs() / known.abs().max(1.0));
                assert!(at_most - at_least <= 1e-9 * at_most.max(1.0), "{at_least} {known}");
                let balanced = base + rate * at_least;
                proves_from_below(&data, &grasp, budget, &balanced, &forces);
                let work = |load: &Wrench<C>| {
                    SVector::<f64, D>::from_column_slice(load.components())
                        .dot(&SVector::<f64, D>::from_column_slice(motion.components()))
                };
                let against =
                    reach(&data, &grasp, budget, &SVector::<f64, D>::from_column_slice(motion.components()));
                // Beyond `at_most` the work of the load exceeds the largest work of contact forces.
                let excess = work(&base) + at_most * work(&rate) - against;
                assert!(work(&rate) > 0.0 && excess.abs() <= 1e-9 * against.max(work(&rate)), "{excess:e}");
            }
            (LoadLimit::NoBase { motion, .. }, None) => {
                self.no_base += 1;
                let against =
                    reach(&data, &grasp, budget, &SVector::<f64, D>::from_column_slice(motion.components()));
                assert!(
                    SVector::<f64, D>::from_column_slice(base.components())
                        .dot(&SVector::<f64, D>::from_column_slice(motion.components()))
                        > against
                );
            }
            (LoadLimit::Factor { at_least, .. }, None) => {
                // The interior-point method says that the base load is not balanced, within its tolerance.
                self.unknown += 1;
                assert!(at_least < 1e-2 && (times - 1.0).abs() < 1e-2, "{at_least} {times}");
            }
            (limit, known) => panic!("{limit:?} {known:?}"),
        }
    }
}

/// Checks that forces balance a load, in their cones and within the budget.
fn proves_from_below<const C: usize>(
    data: &[Datum<C>],
    grasp: &Grasp<C>,
    budget: Budget,
    load: &Wrench<C>,
    forces: &[SVector<f64, C>],
) {
    let mut sum: Vec<f64> = load.components().to_vec();
    let mut normal = Vec::new();
    for (((point, _, mu), frame), force) in data.iter().zip(grasp.frames()).zip(forces) {
        for (sum, x) in sum.iter_mut().zip(wrench(point, &(frame * force))) {
            *sum += x;
        }
        assert!(force.rows(1, C - 1).norm() <= mu * force[0] + 1e-11, "{force:?}");
        normal.push(force[0]);
    }
    for (k, left) in sum.iter().enumerate() {
        assert!(left.abs() < if k < C { 1e-10 } else { 1e-7 }, "{sum:?}");
    }
    match budget {
        Budget::Each(most) => assert!(normal.iter().all(|x| *x <= most + 1e-10), "{normal:?}"),
        Budget::Total(most) => assert!(normal.iter().sum::<f64>() <= most + 1e-10, "{normal:?}"),
    }
}

/// The largest work of forces within the budget against a motion.
fn reach<const D: usize, const C: usize>(
    data: &[Datum<C>],
    grasp: &Grasp<C>,
    budget: Budget,
    motion: &SVector<f64, D>,
) -> f64 {
    let works = data.iter().zip(grasp.frames()).map(|((point, _, mu), frame)| {
        let u = SVector::<f64, C>::from_fn(|axis, _| {
            let wrench = wrench(point, &frame.column(axis).into_owned());
            -wrench.iter().zip(motion.iter()).map(|(w, v)| w * v).sum::<f64>()
        });
        (u[0] + mu * u.rows(1, C - 1).norm()).max(0.0)
    });
    match budget {
        Budget::Each(most) => most * works.sum::<f64>(),
        Budget::Total(most) => most * works.fold(0.0, f64::max),
    }
}

#[test]
fn against_a_second_order_cone_program() {
    let mut numbers = seeded(61);
    let (mut plane, mut space) = (Tally::default(), Tally::default());
    for number in 0..samples(200) {
        plane.compare::<3, 2>(&mut numbers, 2 + number % 4);
        space.compare::<6, 3>(&mut numbers, 3 + number % 4);
    }
    println!("{plane:?} {space:?}");
    for tally in [plane, space] {
        assert_met(&[(tally.no_base, 50)]);
        assert!(tally.factors > samples(30) && tally.unknown < samples(3), "{tally:?}");
        assert!(tally.worst < 1e-6, "{tally:?}");
    }
}

#[test]
fn a_pinch_carries_what_turns_about_its_line_not_at_all() -> Result<(), Error> {
    let finger = |x: f64| jaw::<3>(x, [1e3, 1e3], 0.5);
    let pinch = spatial::Grasp::new([finger(-1.0), finger(1.0)])?;
    let weight = spatial::Wrench::force([0.0, 0.0, -1.0]);
    let LoadLimit::Factor { at_least, at_most, .. } =
        pinch.statics().load_limit(spatial::Wrench::ZERO, weight, Budget::Each(10.0))?
    else {
        panic!("unloaded")
    };
    assert!((at_least - 10.0).abs() < 1e-8 && (at_most - 10.0).abs() < 1e-12, "{at_least}..{at_most}");
    let twist = spatial::Wrench::new([0.0; 3], [1.0, 0.0, 0.0]);
    let LoadLimit::Factor { at_most, motion, .. } =
        pinch.statics().load_limit(weight, twist, Budget::Each(10.0))?
    else {
        panic!("weight is carried")
    };
    assert!(at_most == 0.0 && motion.to_vector()[3].abs() > 0.99, "{motion:?}");
    assert!(matches!(
        pinch.statics().load_limit(twist, weight, Budget::Each(10.0))?,
        LoadLimit::NoBase { .. }
    ));
    assert_eq!(pinch.statics().budget_needed(twist, Budget::Each(1.0))?, [f64::INFINITY; 2]);
    Ok(())
}

#[test]
fn a_direction_of_nothing_is_refused() -> Result<(), Error> {
    let finger = |x: f64| jaw::<2>(x, [1e3, 1e3], 0.5);
    let pinch = planar::Grasp::new([finger(-1.0), finger(1.0)])?;
    let refused = pinch
        .statics()
        .load_limit(planar::Wrench::ZERO, planar::Wrench::ZERO, Budget::Each(1.0))
        .unwrap_err();
    assert!(matches!(refused, Error::Argument { what, value: 0.0, .. } if what.ends_with("load direction")));
    Ok(())
}
