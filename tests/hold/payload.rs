//! The load of a payload on a moving arm agrees with the sum over its particles, each with its own acceleration.

use grasp_lcp::nalgebra::{Matrix3, Vector3};
use grasp_lcp::{Error, planar, spatial};
use support::samples::{samples, seeded};
use support::splitmix::Random;

struct Particle {
    mass: f64,
    at: Vector3<f64>,
}

fn drawn(numbers: &mut Random) -> Vector3<f64> {
    Vector3::from_fn(|_, _| numbers.signed())
}

/// Random particles; in the plane they rotate about z alone.
fn body(numbers: &mut Random, is_flat: bool) -> Vec<Particle> {
    let flat = |v: Vector3<f64>| if is_flat { Vector3::new(v.x, v.y, 0.0) } else { v };
    (0..5).map(|_| Particle { mass: 0.1 + numbers.uniform(), at: flat(drawn(numbers)) }).collect()
}

struct Arm {
    gravity: Vector3<f64>,
    acceleration: Vector3<f64>,
    about: Vector3<f64>,
    velocity: Vector3<f64>,
    faster: Vector3<f64>,
}

/// The inertial and weight force of all particles, and its moment about the origin.
fn summed(body: &[Particle], arm: &Arm) -> (Vector3<f64>, Vector3<f64>) {
    body.iter().fold((Vector3::zeros(), Vector3::zeros()), |(force, moment), particle| {
        let r = particle.at - arm.about;
        let moves = arm.acceleration + arm.faster.cross(&r) + arm.velocity.cross(&arm.velocity.cross(&r));
        let pull = (arm.gravity - moves) * particle.mass;
        (force + pull, moment + particle.at.cross(&pull))
    })
}

/// Mass, centre of mass, and inertia matrix about it.
fn whole(body: &[Particle]) -> (f64, Vector3<f64>, Matrix3<f64>) {
    let mass: f64 = body.iter().map(|particle| particle.mass).sum();
    let centre = body.iter().map(|particle| particle.at * particle.mass).sum::<Vector3<f64>>() / mass;
    let inertia = body.iter().map(|particle| {
        let r = particle.at - centre;
        (Matrix3::identity() * r.norm_squared() - r * r.transpose()) * particle.mass
    });
    (mass, centre, inertia.sum())
}

#[test]
fn in_space_as_the_sum_over_particles() -> Result<(), Error> {
    let mut numbers = seeded(7);
    for _ in 0..samples(200) {
        let body = body(&mut numbers, false);
        let [gravity, acceleration, about, velocity, faster] =
            std::array::from_fn(|_| drawn(&mut numbers) * 3.0);
        let arm = Arm { gravity, acceleration, about, velocity, faster };
        let (mass, centre, inertia) = whole(&body);
        let rows = std::array::from_fn(|i| std::array::from_fn(|j| inertia[(i, j)]));
        let motion =
            spatial::ArmMotion::turning(about, velocity, faster).gravity(gravity).accelerated(acceleration);
        let load = spatial::Payload::new(mass, centre).inertia_matrix(rows).load(&motion)?;
        let (force, moment) = summed(&body, &arm);
        let off =
            (Vector3::from(load.resultant()) - force).norm() + (Vector3::from(load.moment()) - moment).norm();
        assert!(off < 1e-12 * (1.0 + force.norm() + moment.norm()), "{off:e}");
    }
    Ok(())
}

#[test]
fn in_the_plane_as_the_sum_over_particles() -> Result<(), Error> {
    let mut numbers = seeded(8);
    for _ in 0..samples(200) {
        let body = body(&mut numbers, true);
        let flat = |v: Vector3<f64>| Vector3::new(v.x, v.y, 0.0);
        let [gravity, acceleration, about] = std::array::from_fn(|_| flat(drawn(&mut numbers)) * 3.0);
        let [velocity, faster] = std::array::from_fn(|_| Vector3::new(0.0, 0.0, 3.0 * numbers.signed()));
        let arm = Arm { gravity, acceleration, about, velocity, faster };
        let (mass, centre, inertia) = whole(&body);
        let motion = planar::ArmMotion::turning([about.x, about.y], velocity.z, faster.z)
            .gravity([gravity.x, gravity.y])
            .accelerated([acceleration.x, acceleration.y]);
        let load = planar::Payload::new(mass, [centre.x, centre.y]).inertia(inertia[(2, 2)]).load(&motion)?;
        let (force, moment) = summed(&body, &arm);
        let off = (load.resultant()[0] - force.x).abs()
            + (load.resultant()[1] - force.y).abs()
            + (load.moment() - moment.z).abs();
        assert!(off < 1e-12 * (1.0 + force.norm() + moment.norm()), "{off:e}");
    }
    Ok(())
}

/// A steady planar rotation needs no inertia, and neither does an arm that moves without rotation.
#[test]
fn inertia_is_asked_for_where_it_counts() -> Result<(), Error> {
    let flat = planar::Payload::new(1.0, [0.5, 0.0]);
    assert!(flat.load(&planar::ArmMotion::turning([0.0; 2], 3.0, 0.0)).is_ok());
    assert!(matches!(
        flat.load(&planar::ArmMotion::turning([0.0; 2], 3.0, 0.1)),
        Err(Error::Question { .. })
    ));
    let body = spatial::Payload::new(1.0, [0.5, 0.0, 0.0]);
    assert!(body.load(&spatial::ArmMotion::still().accelerated([1.0, 2.0, 3.0])).is_ok());
    let turning = spatial::ArmMotion::turning([0.0; 3], [0.0, 0.0, 3.0], [0.0; 3]);
    let refused = body.load(&turning).expect_err("it may wobble");
    assert!(matches!(refused, Error::Question { question: "payload", field: "inertia", .. }), "{refused}");
    let small = body.inertia([0.0; 3]).load(&turning)?;
    assert_eq!(small.about([0.5, 0.0, 0.0]), spatial::Wrench::force([4.5, 0.0, -9.81]));
    Ok(())
}

#[test]
fn numbers_out_of_range_are_refused() {
    let still = planar::ArmMotion::still();
    for mass in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(planar::Payload::new(mass, [0.0; 2]).load(&still), Err(Error::Argument { .. })));
    }
    let wild = planar::ArmMotion::turning([0.0; 2], f64::NAN, 0.0);
    let refused = planar::Payload::new(1.0, [0.0; 2]).load(&wild).expect_err("no number");
    let Error::Argument { what, value, .. } = refused else { panic!("{refused}") };
    assert!(what.starts_with("angular velocity") && value.is_nan(), "{what}");
    assert!(planar::Payload::new(1.0, [0.0; 2]).inertia(f64::NAN).load(&still).is_err());
}
