//! Forces and moments from the loads of the command line.

use grasp_lcp::Error;
use grasp_lcp::scene::Setup;
use grasp_lcp::spatial::{ArmMotion, Payload, Wrench};
use grasp_lcp::squeeze::Loads;

use crate::arguments::{LoadArguments, Numbers};
use crate::failure::Failure;

/// Converts the numbers of command-line options to forces, moments and points of a scene in the plane or in space. Converted vectors have three
/// components; in the plane the third is zero.
#[derive(Clone, Copy)]
pub(crate) struct OptionVectors {
    /// The number of axes of the scene, 2 or 3.
    pub(crate) axes: usize,
    /// Gravity that pulls at masses, m/s².
    gravity: [f64; 3],
}

impl OptionVectors {
    /// The conversion of options for a scene with this number of axes, with gravity down along the last axis.
    pub(crate) fn in_space(axes: usize) -> Self {
        Self { axes, gravity: std::array::from_fn(|a| if a + 1 == axes { -9.81 } else { 0.0 }) }
    }

    /// The conversion of options for a scene. If the scene has a gravity, it also pulls at the masses of the command line.
    pub(crate) fn of(setup: &Setup<3>) -> Self {
        let own = Self::in_space(setup.axes());
        Self { gravity: setup.gravity.map_or(own.gravity, Into::into), ..own }
    }

    /// The point where a force acts; the origin if left out.
    pub(crate) fn point(self, at: Option<&Numbers>) -> Result<[f64; 3], Failure> {
        self.vector(at, "at")
    }

    fn vector(self, numbers: Option<&Numbers>, option: &str) -> Result<[f64; 3], Failure> {
        numbers.map_or(Ok([0.0; 3]), |numbers| numbers.along_axes(self.axes, option))
    }

    /// A resting arm: gravity acts, and the arm neither accelerates nor turns.
    fn still(self) -> ArmMotion {
        ArmMotion::still().gravity(self.gravity)
    }

    /// The weight of a mass (kg) as a force, N.
    pub(crate) fn weight_of(self, mass: f64) -> Result<[f64; 3], Failure> {
        Ok(Payload::new(mass, [0.0; 3]).load(&self.still())?.resultant())
    }

    /// The load of a mass on the grasp: its weight and its inertial force, which is minus mass times acceleration. A turning arm adds the inertial
    /// moment.
    pub(crate) fn pull_of_mass(self, load: &LoadArguments) -> Result<Wrench, Failure> {
        let mut arm = self.still();
        if let Some(gravity) = &load.gravity {
            arm = arm.gravity(gravity.along_axes(self.axes, "gravity")?);
        }
        if let Some(acceleration) = &load.acceleration {
            arm = arm.accelerated(acceleration.along_axes(self.axes, "acceleration")?);
        }
        let about_axes = |numbers: Option<&Numbers>, option: &str| {
            numbers.map_or(Ok([0.0; 3]), |numbers| self.about_axes(numbers, option))
        };
        let turns = load.angular_velocity.is_some() || load.angular_acceleration.is_some();
        let idle = [("about", load.about.is_some() && !turns), ("inertia", load.inertia.is_some() && !turns)];
        if let Some((option, _)) = idle.iter().find(|(_, idle)| *idle) {
            let message = format!(
                "--{option} without --angular-velocity or --angular-acceleration: it changes nothing"
            );
            return Err(Failure::Usage(message));
        }
        let velocity = about_axes(load.angular_velocity.as_ref(), "angular-velocity")?.map(f64::to_radians);
        let faster =
            about_axes(load.angular_acceleration.as_ref(), "angular-acceleration")?.map(f64::to_radians);
        let about = self.vector(load.about.as_ref(), "about")?;
        let mut body = Payload::new(load.mass.unwrap_or(0.0), self.point(load.at.as_ref())?);
        // A steady rotation about a principal axis of inertia needs no moment, so that the option `--inertia` may be left out. Principal axes are
        // taken to be along the coordinate axes.
        let is_steady = faster == [0.0; 3] && velocity.iter().filter(|rate| **rate != 0.0).count() < 2;
        if load.inertia.is_some() || is_steady {
            body = body.inertia(about_axes(load.inertia.as_ref(), "inertia")?);
        }
        body.load(&arm.and_turning(about, velocity, faster)).map_err(|error| {
            match error {
            Error::Question { .. } => Failure::Usage(
                "--inertia is missing: about the centre of mass, kg m², zero for a body that is small beside its \
                 arm"
                    .to_owned(),
            ),
            error => error.into(),
        }
        })
    }

    /// Components about x, y and z of a moment, an angular velocity or acceleration, or moments of inertia. The option has one number in the plane,
    /// about z, or three in space; any other count is an error.
    pub(crate) fn about_axes(self, numbers: &Numbers, option: &str) -> Result<[f64; 3], Failure> {
        match (self.axes, &numbers.0[..]) {
            (2, [z]) => Ok([0.0, 0.0, *z]),
            (2, all) => {
                let given = all.len();
                Err(Failure::Usage(format!("--{option}: {given} given, must be one number in the plane")))
            }
            _ => numbers.along_axes(3, option),
        }
    }

    /// The force of a load, N: `--force` plus the pull of `--mass`. It is an error if neither is given, or if an option about a turning arm is given.
    pub(crate) fn total_force(self, load: &LoadArguments) -> Result<[f64; 3], Failure> {
        let moves = [
            ("angular-velocity", &load.angular_velocity),
            ("angular-acceleration", &load.angular_acceleration),
            ("about", &load.about),
            ("inertia", &load.inertia),
        ];
        if let Some((option, _)) = moves.iter().find(|(_, given)| given.is_some()) {
            let message = format!("--{option}: has no place where an arm or an angle is sought");
            return Err(Failure::Usage(message));
        }
        let pull = if load.mass.is_some() { self.pull_of_mass(load)? } else { Wrench::ZERO };
        let force = self.vector(load.force.as_ref(), "force")?;
        if load.mass.is_none() && load.force.is_none() {
            return Err(Failure::Usage("say for which load: --mass or --force".to_owned()));
        }
        Ok(std::array::from_fn(|a| pull.components()[a] + force[a]))
    }

    /// The direction that an option gives, of any length; an error if all its numbers are zero.
    pub(crate) fn direction(self, numbers: &Numbers, option: &str) -> Result<[f64; 3], Failure> {
        let direction = numbers.along_axes(self.axes, option)?;
        if direction == [0.0; 3] {
            return Err(Failure::Usage(format!("--{option}: all zeros given, must be a direction")));
        }
        Ok(direction)
    }

    /// The load alone, or the load and in addition a force of the magnitude `any_force`, N, that acts at the point `at` in any direction.
    pub(crate) fn loads(
        self,
        load: Option<Wrench>,
        any_force: Option<f64>,
        at: Option<&Numbers>,
    ) -> Result<Loads<3>, Failure> {
        let base = load.unwrap_or(Wrench::ZERO);
        Ok(match any_force {
            Some(size) => Loads::AnyForce { base, size, point: self.point(at)? },
            None => base.into(),
        })
    }
}
