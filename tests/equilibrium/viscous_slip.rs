//! If several equilibria exist, the returned equilibrium is reached from the sticking state under viscous slip.

use std::f64::consts::TAU;

use grasp_lcp::spatial::{Contact, Grasp, Wrench};
use nalgebra::{Matrix3, Matrix3x6, Matrix6, Vector3, Vector6};
use support::Failure;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// A finger. Its stiffness along the normal and along both tangents is in N/m, its command along the normal in m.
#[derive(Debug)]
struct Finger {
    point: Vector3<f64>,
    normal: Vector3<f64>,
    friction: f64,
    stiffness: [f64; 2],
    command: f64,
}

impl Finger {
    fn draw(random: &mut Random, place: f64) -> Self {
        let angle = TAU * (place + random.between(-0.07, 0.07));
        let ((sin, cos), up) = (angle.sin_cos(), random.between(-0.5, 0.5));
        let tilted = |random: &mut Random| random.between(-0.4, 0.4);
        let normal = Vector3::new(-cos + tilted(random), -sin + tilted(random), tilted(random));
        Self {
            point: Vector3::new(cos, sin, up),
            normal: normal.normalize(),
            friction: random.between(0.2, 0.6),
            stiffness: [random.between(0.5, 4.0), random.between(0.5, 4.0)],
            command: random.between(0.01, 0.02),
        }
    }

    fn contact(&self) -> Contact {
        let [along, across] = self.stiffness;
        Contact::new(self.point, self.normal)
            .series_stiffness(along, across)
            .friction(self.friction)
            .command([self.command, 0.0, 0.0])
    }

    fn springs(&self) -> Matrix3<f64> {
        let (along, [kn, kt]) = (self.normal * self.normal.transpose(), self.stiffness);
        along * kn + (Matrix3::identity() - along) * kt
    }

    /// The matrix that maps the twist of the object to the displacement of the contact point.
    fn map(&self) -> Matrix3x6<f64> {
        let mut map = Matrix3x6::zeros();
        map.fixed_columns_mut::<3>(0).copy_from(&Matrix3::identity());
        map.fixed_columns_mut::<3>(3).copy_from(&-self.point.cross_matrix());
        map
    }
}

/// Force of a finger on the object, coordinate axes, if the contact point of the object has moved by `moved`.
fn force(finger: &Finger, moved: Vector3<f64>) -> Vector3<f64> {
    let stretch = finger.normal * finger.command - moved;
    let pressed = (finger.stiffness[0] * stretch.dot(&finger.normal)).max(0.0);
    let elastic = (stretch - finger.normal * stretch.dot(&finger.normal)) * finger.stiffness[1];
    let limit = finger.friction * pressed;
    let part = if elastic.norm() > limit { limit / elastic.norm() } else { 1.0 };
    finger.normal * pressed + elastic * part
}

/// Contact forces after viscous relaxation. Each step goes half way to the balance of the sticking grasp. `None` if this does not converge.
fn relaxed(fingers: &[Finger], load: Vector6<f64>) -> Option<Vec<Vector3<f64>>> {
    let maps: Vec<_> = fingers.iter().map(Finger::map).collect();
    let springs: Vec<_> = fingers.iter().map(Finger::springs).collect();
    let stiffness: Matrix6<f64> = maps.iter().zip(&springs).map(|(map, k)| map.transpose() * k * map).sum();
    let factors = stiffness.cholesky()?;
    let commanded = |i: usize| maps[i].transpose() * springs[i] * fingers[i].normal * fingers[i].command;
    let mut twist = factors.solve(&((0..fingers.len()).map(commanded).sum::<Vector6<f64>>() + load));
    for _ in 0..3_000 {
        let forces: Vec<_> =
            fingers.iter().zip(&maps).map(|(finger, map)| force(finger, map * twist)).collect();
        let left: Vector6<f64> = maps.iter().zip(&forces).map(|(map, force)| map.transpose() * force).sum();
        let step = factors.solve(&(left + load)) * 0.5;
        twist += step;
        if step.norm() < 1e-13 {
            return Some(forces);
        }
    }
    None
}

#[test]
fn an_equilibrium_is_the_one_to_which_the_stuck_grasp_relaxes() -> Result<(), Failure> {
    let mut random = seeded(41);
    let (mut sliding, mut several) = (0, 0);
    for _ in 0..samples(60) {
        let count = 3 + random.index(0, 2);
        let fingers: Vec<_> =
            (0..count).map(|i| Finger::draw(&mut random, i as f64 / count as f64)).collect();
        let force: [f64; 3] = std::array::from_fn(|_| random.between(-0.004, 0.004));
        let load = Wrench::force(force);
        let Some(expected) = relaxed(&fingers, Vector6::from_fn(|k, _| load.components()[k])) else {
            continue;
        };
        let grasp = Grasp::new(fingers.iter().map(Finger::contact))?;
        let outcome = grasp.solve(load)?;
        let found = outcome.equilibrium().ok_or("no equilibrium")?;
        let largest = expected.iter().map(Vector3::norm).fold(0.0, f64::max);
        for (contact, force) in found.contacts.iter().zip(&expected) {
            let off = (contact.force_world - force).norm();
            assert!(off < 1e-8 * largest, "{fingers:?} {force:?}: {off:e} of {largest:e} {found:?}");
        }
        if found.contacts.iter().any(|contact| contact.slip.norm() > 0.0) {
            sliding += 1;
            several += usize::from(count == 3 && several < 3 && grasp.equilibria(load)?.len() > 1);
        }
    }
    assert_met(&[(sliding, samples(15)), (several, 2)]);
    Ok(())
}
