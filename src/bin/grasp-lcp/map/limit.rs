//! The end of the load path in one direction of a map. Along this path a force in this direction grows from zero in addition to the base load, which
//! is constant. First slip is the event at which the first contact ceases to stick.

use grasp_lcp::Error;
use grasp_lcp::equilibrium::TooFar;
use grasp_lcp::load_path::{Beyond, Leg, LossKind, PathEnd};
use grasp_lcp::words::Words;
use grasp_lcp::{ask::Grasp, grasp::Wrench};

/// How a load path ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum LimitEnd {
    /// No equilibrium exists beyond the end of the path, which is a limit load.
    Limit,
    /// The path does not continue beyond its end, but other equilibria exist there: the grasp may snap to one of them.
    Snap,
    /// The path does not continue beyond its end; whether other equilibria exist there is not known.
    Ends,
    /// A suction cup is open all around, or a contact with infinite friction loses its normal force.
    LetsGo,
    /// No contact resists the load any further.
    GivesWay,
    /// Rotations or slips of the path exceed the limits of the model, which holds for small motions.
    TooFar,
    /// The grasp buckles.
    Buckles,
    /// Nothing resists a rotation along which forces drive the object on.
    TurnsOver,
    /// Air flows into a suction cup where its lip opens.
    Leaks,
    /// An equilibrium exists along the whole path, up to the largest force to which paths are followed.
    Held,
    /// Rounding errors stopped the path, or the path has no start.
    Unknown,
}

impl LimitEnd {
    pub(crate) const ALL: [Self; 11] = [
        Self::Limit,
        Self::Snap,
        Self::Ends,
        Self::LetsGo,
        Self::GivesWay,
        Self::TooFar,
        Self::Buckles,
        Self::TurnsOver,
        Self::Leaks,
        Self::Held,
        Self::Unknown,
    ];

    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Limit => "limit load",
            Self::Snap => "snap",
            Self::Ends => "this equilibrium ends",
            Self::LetsGo => "a contact lets go",
            Self::GivesWay => "nothing resists",
            Self::TooFar => "motions are no longer small",
            Self::Buckles => "buckles",
            Self::TurnsOver => "turns over",
            Self::Leaks => "a suction cup leaks",
            Self::Held => "held",
            Self::Unknown => "not known",
        }
    }
}

/// The end of a load path: the force that is reached, and the reason why the path ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LimitForce {
    /// The force at the end, N; infinite if the whole path is held, NaN if the end is not known.
    pub(crate) force: f64,
    pub(crate) end: LimitEnd,
}

/// Load paths are followed up to this multiple of the largest force at first slip. Curves of a map in the plane are drawn up to three times this
/// force.
pub(crate) const FOLLOWED_TO: f64 = 5.0;

/// Allowed error of one integration step of a load path, relative to the largest contact force. Steps are needed where sliding directions turn. An
/// error of this magnitude is invisible in a picture. A smaller error needs smaller steps, which take most of the time of a map.
pub(crate) const STEP_ERROR: f64 = 1e-6;

/// Follows the load path from `base` to `base + most * direction`, and returns its end.
pub(crate) fn last<const C: usize>(
    grasp: &Grasp<C>,
    base: Wrench<C>,
    direction: Wrench<C>,
    most: f64,
) -> Result<LimitForce, Error> {
    let grasp = grasp.with(&grasp.settings().with_step_error(STEP_ERROR));
    let mut path = grasp.follow(base, &[Leg::load_by(direction * most)])?;
    path.run_while_small();
    let too_far = path.end_of_theory();
    let (end, fraction) = match (path.end(), &too_far) {
        (end, Some(far)) if end.and_then(PathEnd::fraction).is_none_or(|end| far.fraction < end) => {
            let end = match far.what {
                TooFar::Buckles => LimitEnd::Buckles,
                TooFar::TurnsOver => LimitEnd::TurnsOver,
                TooFar::Leaks { .. } => LimitEnd::Leaks,
                _ => LimitEnd::TooFar,
            };
            (end, far.fraction)
        }
        (Some(PathEnd::Completed), _) => (LimitEnd::Held, f64::INFINITY),
        (Some(PathEnd::Lost(loss)), _) if loss.kind == LossKind::GivesWay => {
            (LimitEnd::GivesWay, loss.fraction)
        }
        (Some(PathEnd::Lost(loss)), _) if loss.kind == LossKind::LetsGo => (LimitEnd::LetsGo, loss.fraction),
        (Some(PathEnd::Lost(loss)), _) => {
            let end = match path.beyond() {
                Some(Beyond::LimitLoad) => LimitEnd::Limit,
                Some(Beyond::Snap) => LimitEnd::Snap,
                _ => LimitEnd::Ends,
            };
            (end, loss.fraction)
        }
        _ => (LimitEnd::Unknown, f64::NAN),
    };
    Ok(LimitForce { force: fraction * most, end })
}

impl LimitForce {
    /// The force at the end of the load path as text, N. Load paths are followed up to the force `most`, N.
    pub(crate) fn words(&self, most: f64) -> String {
        let number = |x: f64| Words::default().number(x);
        match self.end {
            LimitEnd::Held => format!("{} and on", number(most)),
            LimitEnd::Unknown => "–".to_owned(),
            _ => number(self.force),
        }
    }
}

/// The number of load paths for each way in which paths end, as text, such as "limit load 40, snap 2".
pub(crate) fn count(lasts: &[LimitForce]) -> String {
    let parts = LimitEnd::ALL.into_iter().filter_map(|end| {
        let count = lasts.iter().filter(|last| last.end == end).count();
        (count > 0).then(|| format!("{} {count}", end.word()))
    });
    parts.collect::<Vec<_>>().join(", ")
}
