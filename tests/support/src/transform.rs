//! Images of a scene: rotated, mirrored, shifted, or in other units.

use nalgebra::{SMatrix, SVector};

use super::scene::{Datum, Scene};

/// `x -> length (R x + shift)` for points, `f -> force R f` for forces, with R orthogonal.
#[derive(Debug, Clone, Copy)]
pub struct Transform<const C: usize> {
    rotation: SMatrix<f64, C, C>,
    shift: SVector<f64, C>,
    length: f64,
    force: f64,
}

/// The rotation of coordinate planes (i, i + 1) by these angles, one after the other.
pub fn rotation<const C: usize>(angles: [f64; 3]) -> SMatrix<f64, C, C> {
    let mut rotation = SMatrix::<f64, C, C>::identity();
    for (i, angle) in angles.into_iter().enumerate().take(if C == 2 { 1 } else { 3 }) {
        let (j, (sin, cos)) = ((i + 1) % C, angle.sin_cos());
        let mut turn = SMatrix::<f64, C, C>::identity();
        (turn[(i, i)], turn[(i, j)], turn[(j, i)], turn[(j, j)]) = (cos, -sin, sin, cos);
        rotation = turn * rotation;
    }
    rotation
}

impl<const C: usize> Transform<C> {
    fn identity() -> Self {
        Self { rotation: SMatrix::identity(), shift: SVector::zeros(), length: 1.0, force: 1.0 }
    }

    /// The rotation of coordinate planes (i, i + 1) by these angles, one after the other.
    pub fn turned(angles: [f64; 3]) -> Self {
        Self { rotation: rotation(angles), ..Self::identity() }
    }

    /// The reflection of the first axis.
    pub fn mirrored() -> Self {
        let mut rotation = SMatrix::identity();
        rotation[(0, 0)] = -1.0;
        Self { rotation, ..Self::identity() }
    }

    /// The translation by a shift.
    pub fn moved(shift: SVector<f64, C>) -> Self {
        Self { shift, ..Self::identity() }
    }

    /// The change of units that multiplies numbers of lengths by `length` and of forces by `force`.
    pub fn in_units(length: f64, force: f64) -> Self {
        Self { length, force, ..Self::identity() }
    }

    fn turns_over(&self) -> bool {
        let r = &self.rotation;
        let determinant = if C == 2 {
            r[(0, 0)] * r[(1, 1)] - r[(0, 1)] * r[(1, 0)]
        } else {
            (0..C)
                .map(|k| {
                    r[(0, k)]
                        * (r[(1, (k + 1) % C)] * r[(2, (k + 2) % C)]
                            - r[(1, (k + 2) % C)] * r[(2, (k + 1) % C)])
                })
                .sum()
        };
        determinant < 0.0
    }

    fn force(&self, f: &SVector<f64, C>) -> SVector<f64, C> {
        self.rotation * f * self.force
    }

    /// A force of the image, transformed back to the original scene.
    pub fn force_back(&self, f: &SVector<f64, C>) -> SVector<f64, C> {
        self.rotation.tr_mul(f) / self.force
    }

    /// A displacement of the image, transformed back to the original scene.
    pub fn displacement_back(&self, u: &SVector<f64, C>) -> SVector<f64, C> {
        self.rotation.tr_mul(u) / self.length
    }

    fn wrench<const D: usize>(&self, w: &SVector<f64, D>) -> SVector<f64, D> {
        let force = self.force(&SVector::from_fn(|a, _| w[a]));
        let side = if self.turns_over() { -1.0 } else { 1.0 } * self.force * self.length;
        let turned = |k: usize| {
            if C == 2 { w[2] } else { (0..3).map(|a| self.rotation[(k, a)] * w[3 + a]).sum() }
        };
        let arm = self.shift * self.length;
        let carried = super::scene::wrench::<D, C>(&arm, &force);
        SVector::from_fn(|k, _| if k < C { force[k] } else { side * turned(k - C) + carried[k] })
    }

    /// A displacement in the contact frame of the image. A mirrored frame has its last tangent reversed, to stay right-handed.
    fn command(&self, mut command: SVector<f64, C>) -> SVector<f64, C> {
        if self.turns_over() {
            command[C - 1] = -command[C - 1];
        }
        command * self.length
    }

    fn datum(&self, datum: &Datum<C>) -> Datum<C> {
        Datum {
            point: (self.rotation * datum.point + self.shift) * self.length,
            normal: self.rotation * datum.normal,
            tangent: self.rotation * datum.tangent,
            stiffness: datum.stiffness * (self.force / self.length),
            friction: datum.friction,
            command: self.command(datum.command),
            clearance: datum.clearance * self.length,
        }
    }

    /// The image of a scene.
    pub fn scene<const D: usize>(&self, scene: &Scene<D, C>) -> Scene<D, C> {
        Scene {
            contacts: scene.contacts.iter().map(|datum| self.datum(datum)).collect(),
            load: self.wrench(&scene.load),
        }
    }

    /// The images of a load direction and of command changes.
    pub fn ramp<const D: usize>(
        &self,
        direction: &SVector<f64, D>,
        change: &[SVector<f64, C>],
    ) -> (SVector<f64, D>, Vec<SVector<f64, C>>) {
        (self.wrench(direction), change.iter().map(|da| self.command(*da)).collect())
    }
}
