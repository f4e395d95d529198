//! How far the data of a map may be off, and how much of that is kept in reserve.

use clap::Args;
use grasp_lcp::sweep::Uncertainty;

/// What is not known exactly: standard deviations, as parts of what the scene says.
#[derive(Debug, Args, Clone, Copy)]
pub(crate) struct Unsure {
    /// Friction is known to this part: one standard deviation.
    #[arg(long, default_value_t = 0.1, value_parser = part, value_name = "PART")]
    friction_off: f64,
    /// Stiffness is known to this part.
    #[arg(long, default_value_t = 0.1, value_parser = part, value_name = "PART")]
    stiffness_off: f64,
    /// The squeeze is known to this part.
    #[arg(long, default_value_t = 0.05, value_parser = part, value_name = "PART")]
    squeeze_off: f64,
    /// Standard deviations in reserve: with 3 one grasp in 740 slides below, with 2 one in 44.
    #[arg(long, default_value_t = 3.0, value_parser = deviations, value_name = "NUMBER")]
    pub(super) sigmas: f64,
}

fn part(given: &str) -> Result<f64, String> {
    let read: f64 = given.parse().map_err(|_| "must be a number".to_owned())?;
    if (0.0..=1.0).contains(&read) {
        Ok(read)
    } else {
        Err("must be from 0 to 1, a part of the datum".to_owned())
    }
}

fn deviations(given: &str) -> Result<f64, String> {
    let read: f64 = given.parse().map_err(|_| "must be a number".to_owned())?;
    if read > 0.0 && read <= 8.0 { Ok(read) } else { Err("must be above 0, at most 8".to_owned()) }
}

impl Unsure {
    pub(super) fn uncertainty(&self) -> Uncertainty {
        let off = Uncertainty::seeded(0).with_friction(self.friction_off).with_stiffness(self.stiffness_off);
        off.with_squeeze(self.squeeze_off)
    }

    /// The assumption, for tables and pictures: what is in reserve, and against what.
    pub(super) fn words(&self) -> [String; 2] {
        let percent = |part: f64| format!("±{:.4} %", 100.0 * part).replace(".0000", "");
        let [friction, stiffness, squeeze] =
            [self.friction_off, self.stiffness_off, self.squeeze_off].map(percent);
        [
            format!("{}σ in reserve: friction {friction},", self.sigmas),
            format!("stiffness {stiffness}, squeeze {squeeze} (1σ)"),
        ]
    }

    /// For machines.
    pub(super) fn written(&self) -> serde_json::Value {
        serde_json::json!({
            "friction": self.friction_off,
            "stiffness": self.stiffness_off,
            "squeeze": self.squeeze_off,
            "sigmas": self.sigmas,
        })
    }
}
