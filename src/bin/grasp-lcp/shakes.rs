//! Repeated loads of the command line.

use grasp_lcp::spatial::Wrench;

use crate::arguments::Numbers;
use crate::failure::Failure;
use crate::loads::OptionVectors;
use crate::own_masses::{accelerated, refuse_mass};
use grasp_lcp::scene::{Question, Setup};

/// The loads that are applied and removed in turn, and the constant load.
#[derive(Debug, clap::Args)]
pub(crate) struct Shakes {
    /// A force that is applied and removed again, N; several forces are applied one after the other.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) force: Vec<Numbers>,
    /// The mass of the object, kg; its weight (with the scene's gravity, or 9.81 m/s² down along the last axis) acts all the time.
    #[arg(long, allow_hyphen_values = true, value_parser = crate::numbers::kilograms, value_name = "KG")]
    pub(crate) mass: Option<f64>,
    /// The acceleration, m/s², to and fro: one number for every axis in turn, or a vector for its direction. The load is the inertial force of the
    /// mass or, without --mass, of all bodies on which the scene's gravity acts.
    #[arg(long, allow_hyphen_values = true, value_name = "A or X,Y[,Z]")]
    pub(crate) acceleration: Option<Numbers>,
    /// The forces repeat in any order: up to which multiple of them could the grasp come to rest (shakedown)?
    #[arg(long)]
    pub(crate) any_order: bool,
    /// A force that acts all the time, N.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) base: Option<Numbers>,
    /// The point where forces and weight act, m; the origin if left out.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) at: Option<Numbers>,
}

impl OptionVectors {
    /// The question whether the grasp survives the repeated loads. `None` if the command line gives no force or acceleration to repeat: the caller
    /// then asks the scene's own questions. If another option is given without a repeated load, this is an error.
    pub(crate) fn shake(self, shakes: &Shakes, setup: &mut Setup<3>) -> Result<Option<Question<3>>, Failure> {
        refuse_mass(setup, shakes.mass)?;
        let at = shakes.at.as_ref();
        let mut base = self.base(shakes.base.as_ref(), at)?;
        let mut loads = Vec::new();
        for force in &shakes.force {
            loads.push(self.push(force, "force", at)?);
        }
        if let Some(mass) = shakes.mass {
            base = base + Wrench::force_at(self.weight_of(mass)?, self.point(at)?);
            if let Some(acceleration) = &shakes.acceleration {
                loads.extend(self.to_and_fro(mass, acceleration, self.point(at)?)?);
            }
        } else if let Some(acceleration) = &shakes.acceleration {
            let (mass, centre) = accelerated(setup, "acceleration")?;
            if shakes.base.is_some() || !shakes.force.is_empty() || at.is_some() {
                let message = "--acceleration: accelerates the bodies by their own masses, must stand without --force, --base and --at: what is always there is the `load` of a body";
                return Err(Failure::Usage(message.to_owned()));
            }
            loads.extend(self.to_and_fro(mass, acceleration, centre)?);
        }
        if loads.is_empty() {
            let given = shakes.any_order || shakes.mass.is_some() || shakes.base.is_some() || at.is_some();
            let missing = "say what repeats: --force, or --mass and --acceleration".to_owned();
            return if given { Err(Failure::Usage(missing)) } else { Ok(None) };
        }
        Ok(Some(if shakes.any_order {
            Question::Shakedown { base, loads }
        } else {
            Question::Shake { base, loads, legs: Vec::new() }
        }))
    }

    /// The inertial forces of a mass that is accelerated to and fro, in both senses. If `acceleration` is one number, the mass is accelerated along
    /// every axis in turn.
    pub(crate) fn to_and_fro(
        self,
        mass: f64,
        acceleration: &Numbers,
        at: [f64; 3],
    ) -> Result<Vec<Wrench>, Failure> {
        let ways: Vec<[f64; 3]> = match acceleration.0[..] {
            [size] if size > 0.0 => (0..self.axes)
                .map(|axis| std::array::from_fn(|a| if a == axis { size } else { 0.0 }))
                .collect(),
            [_] => {
                let message = "--acceleration: must be a number of m/s², more than 0, such as 19.62";
                return Err(Failure::Usage(message.to_owned()));
            }
            _ => vec![self.direction(acceleration, "acceleration")?],
        };
        let pull = |way: [f64; 3], sign: f64| Wrench::force_at(way.map(|a| sign * mass * a), at);
        Ok(ways.into_iter().flat_map(|way| [pull(way, 1.0), pull(way, -1.0)]).collect())
    }
}
