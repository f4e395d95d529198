//! Simulated slips of grasps with known data and random scatter, and the coverage of the confidence intervals found from them.

use grasp_lcp::identify::{FitEnding, Identify, Slip, SlipKind, Unknown};
use grasp_lcp::{Error, Settings, planar, spatial};

use crate::Failure;
use crate::jaws::jaws;
use crate::samples::seeded;
use crate::splitmix::Random;

/// A grasp with known data, directions of loads that make it slip, and the unknowns to identify.
pub struct Known<const C: usize> {
    /// Name in tables.
    pub name: &'static str,
    /// The grasp with its true data.
    pub grasp: grasp_lcp::ask::Grasp<C>,
    /// The grasp from which the search starts.
    pub guess: grasp_lcp::ask::Grasp<C>,
    /// Constant load that acts in addition to the load of each slip.
    pub base: grasp_lcp::grasp::Wrench<C>,
    /// Direction of the load of each slip.
    pub loads: Vec<grasp_lcp::grasp::Wrench<C>>,
    /// Kind of slip that is observed.
    pub kind: SlipKind,
    /// The unknowns to identify.
    pub unknowns: Vec<Unknown>,
    /// True values of the unknowns.
    pub truth: Vec<f64>,
    /// Sum of all unknowns but the first, and its relative standard deviation, if the search knows it.
    pub sum: Option<(f64, f64)>,
    /// Relative standard deviation of each load.
    pub scatter: f64,
    /// Whether the search knows the scatter.
    pub is_told: bool,
    /// Errors that loads of a group share; `None` for independent loads.
    pub shared: Option<Shared>,
}

/// Errors that all loads of a group share.
#[derive(Clone)]
pub struct Shared {
    /// The group of each load.
    pub groups: Vec<usize>,
    /// Relative standard deviation of the error that a group shares.
    pub scatter: f64,
    /// Whether the search knows the groups.
    pub is_told: bool,
}

impl Shared {
    /// Number of groups.
    pub fn count(&self) -> usize {
        self.groups.iter().max().map_or(0, |last| last + 1)
    }
}

/// Counts of intervals, and of intervals that contain the true value, for each unknown.
pub struct Coverage {
    /// Number of intervals that contain the true value, for each unknown.
    pub held: Vec<usize>,
    /// Number of intervals, for each unknown.
    pub told: Vec<usize>,
}

impl Coverage {
    /// Coverage of the intervals of an unknown, in percent.
    pub fn percent(&self, unknown: usize) -> f64 {
        100.0 * self.held[unknown] as f64 / self.told[unknown] as f64
    }
}

impl<const C: usize> Known<C> {
    /// The exact loads at which the grasp slips, without scatter.
    pub fn limits(&self) -> Result<Vec<grasp_lcp::grasp::Wrench<C>>, Failure> {
        let limit = |load: &grasp_lcp::grasp::Wrench<C>| {
            let verdict = self.grasp.hold(grasp_lcp::load_path::Ramp::load(self.base, *load))?;
            let factor = match self.kind {
                SlipKind::First => verdict.first_slip.as_ref().map(|first| first.factor),
                _ => verdict.lost.as_ref().map(|lost| lost.factor),
            };
            Ok(*load * factor.ok_or_else(|| verdict.to_string())?)
        };
        self.loads.iter().map(limit).collect()
    }

    /// The question, with random slips: the logarithm of each load has a normally distributed error.
    pub fn asked(&self, limits: &[grasp_lcp::grasp::Wrench<C>], draw: &mut Random) -> Identify<C> {
        let groups = self.shared.as_ref().map_or(0, Shared::count);
        let together: Vec<f64> = (0..groups).map(|_| draw.normal()).collect();
        let slip = |(k, load): (usize, &grasp_lcp::grasp::Wrench<C>)| {
            let with_all =
                self.shared.as_ref().map_or(0.0, |shared| shared.scatter * together[shared.groups[k]]);
            let load = *load * (self.scatter * draw.normal() + with_all).exp();
            let slip = if self.kind == SlipKind::First { Slip::first(load) } else { Slip::gross(load) };
            let carried = self.sum.is_some();
            let slip = if carried { slip } else { slip.on_top_of(self.base) };
            let slip = if self.is_told { slip.scattering_by(self.scatter) } else { slip };
            let told = self.shared.iter().filter(|shared| shared.is_told);
            told.fold(slip, |slip, shared| slip.in_group(shared.groups[k]))
        };
        let slips: Vec<_> = limits.iter().enumerate().map(slip).collect();
        let asked = Identify::new(self.unknowns.iter().cloned(), slips);
        match self.sum {
            Some((sum, scatter)) => {
                asked.knowing(1..self.unknowns.len(), sum * (scatter * draw.normal()).exp(), scatter)
            }
            None => asked,
        }
    }

    /// The same slips with the same common errors, but without groups in the question.
    pub fn without_groups(mut self) -> Self {
        self.shared.iter_mut().for_each(|shared| shared.is_told = false);
        self
    }

    /// Coverage of the intervals over `draws` random sets of slips.
    pub fn coverage(&self, draws: usize) -> Result<Coverage, Failure> {
        let limits = self.limits()?;
        let mut draw = seeded(47);
        let [mut held, mut told] = [vec![0; self.unknowns.len()], vec![0; self.unknowns.len()]];
        for _ in 0..draws {
            let found = self.guess.identify(&self.asked(&limits, &mut draw))?;
            // A search that does not converge, or an unknown without an interval, makes no claim to check.
            if found.ending != FitEnding::Converged {
                continue;
            }
            for (k, (estimate, truth)) in found.estimates.iter().zip(&self.truth).enumerate() {
                if let Some([low, high]) = estimate.interval {
                    told[k] += 1;
                    held[k] += usize::from(low <= *truth && *truth <= high);
                }
            }
        }
        Ok(Coverage { held, told })
    }
}

/// An object in two jaws with a common friction coefficient, pulled out `slips` times.
pub fn pinch(slips: usize) -> Result<Known<2>, Error> {
    Ok(Known {
        name: "friction of two jaws",
        grasp: jaws([0.3; 2])?,
        guess: jaws([0.8; 2])?,
        base: planar::Wrench::ZERO,
        loads: vec![planar::Wrench::force([0.0, -1.0]); slips],
        kind: SlipKind::Gross,
        unknowns: vec![Unknown::friction()],
        truth: vec![0.3],
        sum: None,
        scatter: 0.08,
        is_told: false,
        shared: None,
    })
}

/// The pinch in `series` series of `each` slips. Each series shares an error, as on different days; it is larger than the scatter of single slips.
pub fn pinch_in_series(series: usize, each: usize) -> Result<Known<2>, Error> {
    let groups = (0..series * each).map(|k| k / each).collect();
    let shared = Some(Shared { groups, scatter: 0.07, is_told: true });
    Ok(Known { name: "friction of two jaws, in series", scatter: 0.04, shared, ..pinch(series * each)? })
}

/// First slips of two jaws with different friction: of the left jaw under loads left of the middle, else of the right jaw. The scatter is known.
pub fn first_slips() -> Result<Known<2>, Error> {
    let load = |x: f64| planar::Wrench::force_at([0.0, -1.0], [x, 0.0]);
    // Some pulls turn the object by more than 0.1 rad before it slips. The slips are those of the linear theory all the same.
    let any_turn = Settings::default().with_small_motions(1e3, 0.1);
    Ok(Known {
        name: "friction of each jaw, from first slips",
        grasp: jaws([0.3, 0.45])?.with(&any_turn),
        guess: jaws([0.7, 0.7])?.with(&any_turn),
        base: planar::Wrench::ZERO,
        loads: [-0.02, -0.018, -0.016, -0.014, -0.012, 0.02, 0.022, 0.024, 0.026, 0.028].map(load).into(),
        kind: SlipKind::First,
        unknowns: vec![Unknown::friction().of_contacts([0]), Unknown::friction().of_contacts([1])],
        truth: vec![0.3, 0.45],
        sum: None,
        scatter: 0.03,
        is_told: true,
        shared: None,
    })
}

/// The block of [`three_feet`], pushed in several directions, two to four times in each. Pushes in the same direction share an error of friction.
pub fn three_feet_by_direction(directions: usize) -> Result<Known<3>, Error> {
    let groups: Vec<usize> = (0..directions).flat_map(|k| vec![k; 2 + k % 3]).collect();
    let known = three_feet(directions)?;
    let loads = groups.iter().map(|group| known.loads[*group]).collect();
    let shared = Some(Shared { groups, scatter: 0.05, is_told: true });
    Ok(Known {
        name: "friction and loads of three feet, by direction",
        loads,
        scatter: 0.04,
        shared,
        ..known
    })
}

/// A block of 14 N on three feet, pushed in many directions. Unknown are the friction and the load of each foot.
pub fn three_feet(slips: usize) -> Result<Known<3>, Error> {
    let at = [[-0.04, -0.04], [0.04, -0.02], [-0.02, 0.08]];
    let carried = [3.0, 7.0, 4.0];
    let feet = |friction: f64| {
        let foot = |at: [f64; 2]| {
            spatial::Contact::new([at[0], at[1], 0.0], [0.0, 0.0, 1.0])
                .series_stiffness(1e6, 1e6)
                .friction(friction)
        };
        spatial::Grasp::new(at.map(foot))
    };
    let weights =
        at.iter().zip(carried).map(|(at, n)| spatial::Wrench::force_at([0.0, 0.0, -n], [at[0], at[1], 0.0]));
    let base = weights.fold(spatial::Wrench::ZERO, |sum, weight| sum + weight);
    let push = |k: usize| {
        let angle = 2.4 * k as f64;
        let arm = 0.09 * ((k % 5) as f64 - 2.0) / 2.0;
        spatial::Wrench::new([angle.cos(), angle.sin(), 0.0], [0.0, 0.0, arm])
    };
    let foot = |k: usize| Unknown::carried().of_contacts([k]);
    Ok(Known {
        name: "friction and loads of three feet",
        grasp: feet(0.4)?,
        guess: feet(0.7)?,
        base,
        loads: (0..slips).map(push).collect(),
        kind: SlipKind::Gross,
        unknowns: vec![Unknown::friction(), foot(0), foot(1), foot(2)],
        truth: vec![0.4, 3.0, 7.0, 4.0],
        sum: Some((14.0, 0.002)),
        scatter: 0.06,
        is_told: false,
        shared: None,
    })
}
