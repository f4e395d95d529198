//! Loads and rigid motions in sentences: "(0, -4.905) N and 0.2 N m", "turns 1.9° about +z through (0, 0.03, 0) m, moves 2.8 mm along +z".

use nalgebra::SVector;

use super::axis::Rotation;
use super::bodies::BodyMotion;
use super::face::{Face, all_inside, inside};
use super::motion::Motion;
use super::tolerances::{LITTLE_ROUNDING, SEEN_MOTION};
use super::wrench::{Twist, Wrench};
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{IntoList, Space, dot, largest, mapped, summed};
use crate::prelude::*;
use crate::words::{Words, listed, printable};

impl<const C: usize> Wrench<C> {
    /// Magnitude and unit of a load that is a single force along some line, or a pure moment; `None` for other loads.
    pub(crate) fn measure(&self) -> Option<(f64, &'static str)> {
        let spatial = self.into_inside();
        let (force, moment) = spatial.components().split_at(3);
        let norm = |x: &[f64]| summed(x, &|x| x * x).sqrt();
        let (force_size, moment_size) = (norm(force), norm(moment));
        if force_size == 0.0 {
            return (moment_size > 0.0).then_some((moment_size, "N m"));
        }
        let twisted = dot(force, moment).abs();
        // A load is a single force along some line if its moment m is normal to its force f. It counts as normal if `|f·m|/(|f||m|)` is at most
        // `SOLVED_ROUNDING` (1e-12).
        (twisted <= SOLVED_ROUNDING * force_size * moment_size).then_some((force_size, "N"))
    }
}

impl Words {
    /// A force and a moment about the origin: "(0, -4.905) N and 0.2 N m".
    #[must_use]
    pub fn load<const C: usize>(self, load: &Wrench<C>) -> String {
        let space = self.space::<C>();
        self.load_of(space.axes(), &load.into_inside().coordinates(space).as_slice()[..space.of_the_object()])
    }

    /// A force (N) and a moment (N m) in words, from their components; the first `axes` components are the force.
    pub(crate) fn load_of(self, axes: usize, components: &[f64]) -> String {
        let largest = largest(components, &|x| x.abs());
        let clean = |x: &f64| if x.abs() <= LITTLE_ROUNDING * largest { 0.0 } else { *x };
        let components: Vec<_> = mapped(components, &clean);
        let (force, moment) = components.split_at(axes);
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

    /// Words for a small motion of the object: "turns 1.9° about …, moves 2.8 mm". `moved` holds the displacements, m, of some points of the object;
    /// their differences show how far rotation moves the points. If the object hardly turns, the sentence begins with the translation.
    #[must_use]
    pub fn motion<const C: usize>(self, twist: &Twist<C>, moved: &[SVector<f64, C>]) -> String {
        let (words, twist) = (self.in_space(self.space::<C>()), twist.into_inside());
        if moved.is_empty() {
            return words.motion_text(&twist, None);
        }
        let moved = all_inside(moved);
        let mean = moved.iter().sum::<SVector<f64, 3>>() / moved.len() as f64;
        words.motion_text(&twist, Some((mean, largest(&moved, &|u| (u - mean).norm()))))
    }

    /// Words for a small motion of one of several bodies: the name of the body, then the sentence of [`Self::motion`].
    #[must_use]
    pub fn body_motion<const C: usize>(self, motion: &BodyMotion<C>) -> String {
        let (words, motion) = (self.in_space(self.space::<C>()), inside(motion));
        let text = words.motion_text(&motion.twist, Some((motion.middle_moves(), motion.turning_moves())));
        format!("{} {text}", printable(&motion.body))
    }

    /// The sentence of [`Self::motion`] for a small motion `twist`. `points` are the mean displacement of points of the object and the largest
    /// deviation from this mean, m; `None` if no points are known.
    fn motion_text(self, twist: &Twist<3>, points: Option<(SVector<f64, 3>, f64)>) -> String {
        let (along, omega) = twist.parts_in(self.space::<3>());
        let (mean, spread) = points.unwrap_or((along, 0.0));
        // The object turns if rotation moves its points by more than the fraction `NEGLIGIBLE` (1e-9) of their mean displacement. Rotation must also
        // move them by more than the length `nowhere`, m, which is smaller than an atomic nucleus.
        let nowhere: f64 = 1e-15;
        let turns =
            omega.size() > 0.0 && (points.is_none() || spread > nowhere.max(NEGLIGIBLE * mean.norm()));
        let moves = |by: &SVector<f64, 3>| {
            if by.norm() <= nowhere {
                return "stays where it is".to_owned();
            }
            format!("moves {} along {}", self.length(by.norm()), self.along(&by.normalize()))
        };
        if !turns {
            return moves(&mean);
        }
        let turns_visibly =
            if points.is_none() { along.norm() <= omega.size() } else { spread > SEEN_MOTION * mean.norm() };
        if !turns_visibly {
            return format!("{}, turns {}", moves(&mean), self.axis_text(&omega));
        }
        // Estimated distance of the points from the axis, m. The rounding error of the position of the axis is proportional to this distance.
        let arm = if spread > 0.0 { spread / omega.size() } else { 1.0 };
        let through = omega.way_to_axis(&along).map(|x| if x.abs() <= NEGLIGIBLE * arm { 0.0 } else { x });
        let turning = format!("turns {}{}", self.axis_text(&omega), self.point(&through));
        let pitch = omega.along_axis(&along);
        if pitch.norm() <= NEGLIGIBLE * spread.max(mean.norm()) {
            return turning;
        }
        format!("{turning}, {}", moves(&pitch))
    }

    /// Words for the direction of a motion: "turning about +z through (0, 0.03, 0) m".
    #[must_use]
    pub fn direction_of<const C: usize>(self, motion: &Motion<C>) -> String {
        let (words, motion) = (self.in_space(self.space::<C>()), inside(motion));
        if !motion.bodies.is_empty() {
            return words.directions_of(&motion.bodies);
        }
        let object = words.direction(&motion.object);
        let moves = motion.joints.iter().any(|x| *x != 0.0);
        if moves { format!("{object}, the hand with it") } else { object }
    }

    /// Directions of the bodies that move: "wedge moving along −x, block moving along +y".
    fn directions_of(self, bodies: &[BodyMotion<3>]) -> String {
        // If all contact points of every body lie on its axis of rotation, no contact point moves. Bodies are then compared by their angles of
        // rotation.
        let still = largest(bodies, &BodyMotion::speed) == 0.0;
        let speed =
            |motion: &BodyMotion<3>| if still { motion.twist.parts().1.size() } else { motion.speed() };
        let fastest = largest(bodies, &speed);
        let moves = bodies.iter().filter(|motion| speed(motion) > SEEN_MOTION * fastest);
        let texts =
            |motion: &BodyMotion<3>| (printable(&motion.body).into_owned(), self.direction(&motion.twist));
        let texts: Vec<_> = moves.map(texts).list();
        let Some((_, first)) = texts.first() else { return "moving nothing but the hand".to_owned() };
        // More than three bodies with the same motion share one description; up to three are described one by one.
        if texts.len() > 3 && texts.iter().all(|(_, way)| way == first) {
            let names: Vec<_> = mapped(&texts, &|(name, _)| name);
            return format!("{}, all {first}", listed(&names));
        }
        listed(&texts.iter().map(|(name, way)| format!("{name} {way}")).list())
    }

    fn direction(self, twist: &Twist<3>) -> String {
        let (along, omega) = twist.parts_in(self.space::<3>());
        if omega.size() <= NEGLIGIBLE * along.norm() {
            if along.norm() > 0.0 {
                format!("moving along {}", self.along(&along.normalize()))
            } else {
                "moving nothing but the hand".to_owned()
            }
        } else {
            let through = omega.way_to_axis(&along).map(|x| if x.abs() <= LITTLE_ROUNDING { 0.0 } else { x });
            let pitch = omega.along_axis(&along);
            let axis = match omega {
                Rotation::Plane(_) => "turning".to_owned(),
                Rotation::Space(_) => format!("turning about {}", self.along(&omega.axis())),
            };
            let turning = format!("{axis}{}", self.point(&through));
            if pitch.norm() <= NEGLIGIBLE * along.norm() {
                turning
            } else {
                let a_degree = self.length(pitch.norm() / omega.size().to_degrees());
                format!("{turning} and moving {a_degree} along {} a degree", self.along(&pitch.normalize()))
            }
        }
    }

    /// Angle and sense of a rotation: "1.9° about +z" in space, "1.9° clockwise" in the plane.
    fn axis_text(self, omega: &Rotation) -> String {
        let angle = self.angle(omega.size());
        match omega {
            Rotation::Plane(turn) if *turn < 0.0 => format!("{angle} clockwise"),
            Rotation::Plane(_) => format!("{angle} anticlockwise"),
            Rotation::Space(_) => format!("{angle} about {}", self.along(&omega.axis())),
        }
    }

    /// Position of the axis: " about (0, 0.03) m" in the plane, " through (0, 0.03, 0) m" in space.
    fn point(self, through: &SVector<f64, 3>) -> String {
        let what = if self.space::<3>() == Space::Planar { "about" } else { "through" };
        format!(" {what} {}", self.place(through))
    }
}
