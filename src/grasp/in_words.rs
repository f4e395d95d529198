//! Loads and rigid motions in words: "(0, -4.905) N and 0.2 N m", "turns 1.9° about +z through (0, 0.03, 0) m, moves 2.8 mm along +z".

use nalgebra::SVector;

use super::axis::Rotation;
use super::motion::Motion;
use super::wrench::{Twist, Wrench};
use crate::words::Words;

/// Turning that shifts points by less than this part of what all of them move by is told beside that; else the object turns about an axis.
const SEEN: f64 = 0.05;
/// Turning or moving by less than this part of the other one is rounding.
const ROUNDING: f64 = 1e-9;
/// The same where nothing but the motion is known, m, and among forces and moments.
const LITTLE_ROUNDING: f64 = 1e-13;
/// Points that move by less, m, stay where they are for whoever reads it: less than a nucleus is wide.
const NOWHERE: f64 = 1e-15;

impl Words {
    /// A force and a moment about the origin: "(0, -4.905) N and 0.2 N m".
    #[must_use]
    pub fn load<const C: usize>(self, load: &Wrench<C>) -> String {
        let largest = load.components().iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let clean = |x: &f64| if x.abs() <= LITTLE_ROUNDING * largest { 0.0 } else { *x };
        let components: Vec<_> = load.components().iter().map(clean).collect();
        let (force, moment) = components.split_at(C);
        let is_there = |part: &[f64]| part.iter().any(|x| *x != 0.0);
        let moment_words = || match moment {
            [moment] => format!("{} N m", self.number(*moment)),
            moment => format!("{} N m", self.numbers(moment)),
        };
        match (is_there(force), is_there(moment)) {
            (false, false) => "no load".to_owned(),
            (true, false) => format!("{} N", self.numbers(force)),
            (false, true) => moment_words(),
            (true, true) => format!("{} N and {}", self.numbers(force), moment_words()),
        }
    }

    /// What the object does as it moves by a small motion that takes some of its points along by `moved`, m: "turns 1.9° about …, moves 2.8 mm", or
    /// the other way round where it hardly turns.
    #[must_use]
    pub fn motion<const C: usize>(self, twist: &Twist<C>, moved: &[SVector<f64, C>]) -> String {
        let (along, omega) = twist.parts();
        let mean = moved.iter().sum::<SVector<f64, C>>() / moved.len().max(1) as f64;
        let mean = if moved.is_empty() { along } else { mean };
        let spread = moved.iter().map(|u| (u - mean).norm()).fold(0.0, f64::max);
        let turns = omega.size() > 0.0 && (moved.is_empty() || spread > NOWHERE.max(ROUNDING * mean.norm()));
        let moves = |by: &SVector<f64, C>| {
            if by.norm() <= NOWHERE {
                return "stays where it is".to_owned();
            }
            format!("moves {} along {}", self.length(by.norm()), self.along(&by.normalize()))
        };
        if !turns {
            return moves(&mean);
        }
        let seen = if moved.is_empty() { along.norm() <= omega.size() } else { spread > SEEN * mean.norm() };
        if !seen {
            return format!("{}, turns {}", moves(&mean), self.about(&omega));
        }
        // What turning moves points by, as a scale for what is rounding.
        let arm = if spread > 0.0 { spread / omega.size() } else { 1.0 };
        let through = omega.way_to_axis(&along).map(|x| if x.abs() <= ROUNDING * arm { 0.0 } else { x });
        let turning = format!("turns {}{} m", self.about(&omega), self.point::<C>(&through));
        let pitch = omega.along_axis(&along);
        if pitch.norm() <= ROUNDING * spread.max(mean.norm()) {
            return turning;
        }
        format!("{turning}, {}", moves(&pitch))
    }

    /// A motion of which only the direction is meant: "turning about +z through (0, 0.03, 0) m".
    #[must_use]
    pub fn direction_of<const C: usize>(self, motion: &Motion<C>) -> String {
        let (along, omega) = motion.object.parts();
        let object = if omega.size() <= ROUNDING * along.norm() {
            if along.norm() > 0.0 {
                format!("moving along {}", self.along(&along.normalize()))
            } else {
                "moving nothing but the hand".to_owned()
            }
        } else {
            let through = omega.way_to_axis(&along).map(|x| if x.abs() <= LITTLE_ROUNDING { 0.0 } else { x });
            let pitch = omega.along_axis(&along);
            let axis = if C == 2 {
                "turning".to_owned()
            } else {
                format!("turning about {}", self.along(&omega.axis()))
            };
            let turning = format!("{axis}{} m", self.point::<C>(&through));
            if pitch.norm() <= ROUNDING * along.norm() {
                turning
            } else {
                let a_degree = self.length(pitch.norm() / omega.size().to_degrees());
                format!("{turning} and moving {a_degree} along {} a degree", self.along(&pitch.normalize()))
            }
        };
        let moves = motion.joints.iter().any(|x| *x != 0.0);
        if moves {
            format!("{object}, with joints by {} rad or m", self.numbers(&motion.joints))
        } else {
            object
        }
    }

    /// How far and which way: "1.9° about +z", in the plane "1.9° clockwise".
    fn about<const C: usize>(self, omega: &Rotation<C>) -> String {
        let angle = self.angle(omega.size());
        match omega {
            Rotation::Plane(turn) if *turn < 0.0 => format!("{angle} clockwise"),
            Rotation::Plane(_) => format!("{angle} anticlockwise"),
            Rotation::Space(_) => format!("{angle} about {}", self.along(&omega.axis())),
        }
    }

    /// " about (0, 0.03)", in space " through (0, 0.03, 0)".
    fn point<const C: usize>(self, through: &SVector<f64, C>) -> String {
        let at = self.numbers(through.as_slice());
        if C == 2 { format!(" about {at}") } else { format!(" through {at}") }
    }
}
