//! Options that say how uncertain friction, stiffness and clamping force are. A map shows the force at first slip for every direction. With these
//! options it also shows a smaller force, under which these data may deviate by a given number of standard deviations before a contact slides.

use clap::Args;
use grasp_lcp::sweep::Uncertainty;
use grasp_lcp::words::Words;

use crate::numbers::{deviations, percent};

/// Standard deviations of uncertain data, in percent of the scene's values.
#[derive(Debug, Args, Clone, Copy)]
pub(crate) struct DataDeviations {
    /// One standard deviation of friction, percent.
    #[arg(long, allow_hyphen_values = true, value_parser = percent, default_value_t = 10.0, value_name = "PERCENT")]
    friction_off: f64,
    /// One standard deviation of stiffness, percent.
    #[arg(long, allow_hyphen_values = true, value_parser = percent, default_value_t = 10.0, value_name = "PERCENT")]
    stiffness_off: f64,
    /// One standard deviation of what presses (clamping forces, commands, tensions, vacuums), percent.
    #[arg(long, allow_hyphen_values = true, value_parser = percent, default_value_t = 5.0, value_name = "PERCENT")]
    squeeze_off: f64,
    /// Reserve of each force of the map, in standard deviations of the data: with 3 one grasp in 740 slides under less than this force, with 2 one in
    /// 44. Every coefficient of friction and everything that presses is multiplied by a factor of its own. So is the stiffness of every contact,
    /// along all its axes alike. Factors are log-normal: twice and half are equally likely
    #[arg(long, allow_hyphen_values = true, value_parser = deviations, default_value_t = 3.0, value_name = "NUMBER")]
    pub(super) sigmas: f64,
}

impl DataDeviations {
    /// Relative standard deviations of friction, stiffness and clamping force.
    fn parts(&self) -> [f64; 3] {
        [self.friction_off, self.stiffness_off, self.squeeze_off].map(|percent| 0.01 * percent)
    }

    pub(super) fn uncertainty(&self) -> Uncertainty {
        let [friction, stiffness, squeeze] = self.parts();
        Uncertainty::seeded(0).with_friction(friction).with_stiffness(stiffness).with_squeeze(squeeze)
    }

    /// Two lines of text for tables and pictures. They have the number of standard deviations by which data may deviate before a contact slides. They
    /// also have the standard deviations of friction, stiffness and clamping force.
    pub(super) fn words(&self) -> [String; 2] {
        let words = Words::default();
        let number = |x: f64| words.number(x);
        let [friction, stiffness, squeeze] = [self.friction_off, self.stiffness_off, self.squeeze_off]
            .map(|percent| format!("±{} %", number(percent)));
        [
            format!("{}σ in reserve: friction {friction},", number(self.sigmas)),
            format!("stiffness {stiffness}, squeeze {squeeze} (1σ, log-normal)"),
        ]
    }

    /// A JSON object with the relative standard deviations of friction, stiffness and clamping force. Its field `sigmas` is the number of standard
    /// deviations by which these data may deviate before a contact slides.
    pub(super) fn written(&self) -> serde_json::Value {
        let [friction, stiffness, squeeze] = self.parts();
        serde_json::json!({ "friction": friction, "stiffness": stiffness, "squeeze": squeeze, "sigmas": self.sigmas })
    }
}
