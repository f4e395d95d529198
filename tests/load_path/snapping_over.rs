//! A path that ends at a fold or a corner snaps over to the equilibrium at which viscous contacts come to rest.

use std::f64::consts::TAU;

use grasp_lcp::planar::{Contact, Grasp, Wrench};
use nalgebra::{Matrix2, Matrix2x3, Matrix3, Vector2, Vector3};
use support::Failure;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// A finger at a point of unit distance. Stiffness along the normal and the tangent in N/m, command along the normal in m.
#[derive(Debug)]
struct Finger {
    point: Vector2<f64>,
    normal: Vector2<f64>,
    friction: f64,
    stiffness: [f64; 2],
    command: f64,
}

impl Finger {
    fn draw(random: &mut Random, place: f64) -> Self {
        let angle = TAU * (place + random.between(-0.1, 0.1));
        let inwards = angle + TAU / 2.0 + random.between(-0.8, 0.8);
        let normal = [1.0, 10.0, 100.0][random.index(0, 2)] * 1e3;
        Self {
            point: Vector2::new(angle.cos(), angle.sin()),
            normal: Vector2::new(inwards.cos(), inwards.sin()),
            friction: random.between(0.3, 1.2),
            stiffness: [normal, normal * random.between(0.5, 1.0)],
            command: random.between(0.0, 50.0) / normal,
        }
    }

    fn contact(&self) -> Contact {
        let [along, across] = self.stiffness;
        Contact::new(self.point, self.normal)
            .series_stiffness(along, across)
            .friction(self.friction)
            .command([self.command, 0.0])
    }

    fn tangent(&self) -> Vector2<f64> {
        Vector2::new(-self.normal.y, self.normal.x)
    }

    /// The matrix that maps the twist of the object to the displacement of the contact point.
    fn map(&self) -> Matrix2x3<f64> {
        Matrix2x3::new(1.0, 0.0, -self.point.y, 0.0, 1.0, self.point.x)
    }

    fn springs(&self) -> Matrix2<f64> {
        let [along, across] = self.stiffness;
        self.normal * self.normal.transpose() * along + self.tangent() * self.tangent().transpose() * across
    }

    /// The force of the finger on the object after its contact point has moved by `moved`. The accumulated slip of the finger along its tangent,
    /// `slip`, is updated.
    fn force(&self, moved: Vector2<f64>, slip: &mut f64) -> Vector2<f64> {
        let [along, across] = self.stiffness;
        let press = (along * (self.command - self.normal.dot(&moved))).max(0.0);
        let stretch = -self.tangent().dot(&moved);
        let most = self.friction * press;
        let friction = (across * (stretch - *slip)).clamp(-most, most);
        *slip = stretch - friction / across;
        self.normal * press + self.tangent() * friction
    }
}

/// The twist at which viscous fingers rest under a load that has grown slowly.
fn crept(fingers: &[Finger], load: Vector3<f64>) -> Vector3<f64> {
    let damping: Matrix3<f64> = fingers.iter().map(|f| f.map().transpose() * f.springs() * f.map()).sum();
    let inverse = damping.try_inverse().expect("is regular");
    let (mut twist, mut slips) = (Vector3::zeros(), vec![0.0; fingers.len()]);
    let steps = 100_000;
    for step in 0..3 * steps {
        let part = (f64::from(step - steps / 2) / f64::from(steps)).clamp(0.0, 1.0);
        let mut left = load * part;
        for (finger, slip) in fingers.iter().zip(&mut slips) {
            left += finger.map().transpose() * finger.force(finger.map() * twist, slip);
        }
        twist += inverse * left * 0.5;
    }
    twist
}

#[test]
fn it_comes_to_rest_where_viscous_contacts_do() -> Result<(), Failure> {
    let (mut random, mut met) = (seeded(0x5a), 0);
    for _ in 0..samples(800) {
        let fingers: Vec<_> = (0..3).map(|k| Finger::draw(&mut random, f64::from(k) / 3.0)).collect();
        let grasp = Grasp::new(fingers.iter().map(Finger::contact))?;
        let ([x, y], angle) = ([0, 1].map(|_| random.between(-0.3, 0.3)), random.between(0.0, TAU));
        let load = Wrench::force_at([30.0 * angle.cos(), 30.0 * angle.sin()], [x, y]);
        let verdict = grasp.hold(load)?;
        // Only scenes whose first slip comes after the start are used. A finger that slides at rest would start from another position.
        let starts = verdict.first_slip.as_ref().is_some_and(|first| first.factor > 1e-3);
        let (Some(state), true) =
            (&verdict.state, starts && verdict.caught.iter().any(|caught| caught.snaps))
        else {
            continue;
        };
        met += 1;
        if met > samples(6) {
            break;
        }
        let other = crept(&fingers, Vector3::from_column_slice(load.components()));
        let here = Vector3::from_column_slice(state.twist.components());
        let apart = (here - other).norm();
        assert!(apart <= 0.02 * other.norm(), "{fingers:?} {load:?}: {here:?} {other:?}");
    }
    assert_met(&[(met, samples(6))]);
    Ok(())
}
