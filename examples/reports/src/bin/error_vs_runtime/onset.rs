//! The onset of sliding: found directly, by stepping the load, and by bisection.
//!
//! Stepping and bisection solve the quadratic program of the paper (see `paper-notes.md`), in its reduced form, for one load after the other. They
//! check whether one of its friction rows is active. In the plane an active row means that a contact slides. In space the program has facets, so
//! that it finds the onset on a polygon.

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::Ramp;
use grasp_lcp::screening::{Fingers, Pull};
use grasp_lcp::{PolygonCone, PolygonFit, spatial};

use crate::report::{Panel, Report};
use support::Failure;
use support::best_time::timed;
use support::interior_point::{Oracle, interior_point_and_multipliers};
use support::paper::{down, two_fingers};
use support::reduced_program::ReducedProgram;

/// Tolerance of the interior-point method. Slack and multiplier of each friction row of the program are positive; near the onset both are about
/// the square root of this tolerance.
const TOLERANCE: f64 = 1e-12;
const TOLERANCES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
const STEPS: [u32; 6] = [10, 100, 1000, 10_000, 100_000, 1_000_000];

/// If there are more steps than this, only the last [`LAST_STEPS`] steps before the onset are computed.
const MOST_STEPS: u32 = 100_000;
/// Number of last steps before the onset that are computed.
const LAST_STEPS: f64 = 1000.0;

/// Number of skipped steps: all but the last [`LAST_STEPS`] before the fraction `part` of the load.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between 0 and a million
fn steps_below(part: f64, steps: u32) -> u32 {
    (part * f64::from(steps) - LAST_STEPS).max(0.0) as u32
}

/// Method that solves the quadratic program.
#[derive(Clone, Copy, PartialEq)]
enum Solver {
    /// Lemke's method on the optimality conditions, as in the crate.
    Lemke,
    /// The interior-point method of Clarabel.
    InteriorPoint,
}

impl Solver {
    fn name(self) -> &'static str {
        match self {
            Self::Lemke => "QP by Lemke",
            Self::InteriorPoint => "QP by Clarabel",
        }
    }
}

/// A grasp, and the load that grows from zero at factor 0 to `direction` at factor 1.
struct Question<'a, const C: usize> {
    grasp: &'a Grasp<C>,
    direction: Wrench<C>,
    cone: PolygonCone,
    /// Stepping and bisection search between factor 0 and this factor.
    most: f64,
}

impl<const C: usize> Question<'_, C> {
    /// Whether no friction row of the quadratic program is active at a load factor, which means that everything sticks.
    fn sticks(&self, factor: f64, solver: Solver) -> Result<bool, Failure> {
        let load = self.direction * factor;
        let reduced = ReducedProgram::new(self.grasp, &load, &self.cone);
        let mut rows = reduced.friction.iter().enumerate().filter_map(|(i, of)| Some((i, (*of)?)));
        if solver == Solver::Lemke {
            let Some(minimum) = reduced.program.solve()? else { return Ok(false) };
            return Ok(rows.all(|(i, _)| minimum.multipliers[i] == 0.0));
        }
        let (Oracle::Minimum(x, _), multipliers) =
            interior_point_and_multipliers(&reduced.program, TOLERANCE)
        else {
            return Ok(false);
        };
        // A multiplier is a displacement, m. Multiplied by the stiffness of the contact it can be compared with the slack, N.
        let slack = &reduced.program.b * x - &reduced.program.d;
        let stiffness = |contact: usize| {
            let contact = &self.grasp.contacts()[contact];
            let k = contact.series_stiffness_of_axes();
            contact.friction_coefficient().powi(2) * k[0] + k[1]
        };
        Ok(rows.all(|(i, contact)| slack[i] > multipliers[i] * stiffness(contact)))
    }

    /// The onset as the middle between the last load step at which everything sticks and the next step; all steps are equally long. Also returns
    /// the number of the last step computed.
    fn stepped(&self, steps: u32, first: u32, solver: Solver) -> Result<(f64, u32), Failure> {
        let at = |step: u32| self.most * f64::from(step) / f64::from(steps);
        for step in first..=steps {
            if !self.sticks(at(step), solver)? {
                return Ok((0.5 * (at(step - 1) + at(step)), step));
            }
        }
        Err("no onset".into())
    }

    fn steps(&self, panel: &mut Panel, exact: f64, solver: Solver) -> Result<(), Failure> {
        let mut last = 0.0;
        for steps in STEPS {
            let from_scratch = steps <= MOST_STEPS;
            let skipped = if from_scratch { 0 } else { steps_below(last / self.most, steps) };
            let ((factor, end), time) = timed(|| self.stepped(steps, skipped + 1, solver))?;
            let whole = time * f64::from(end) / f64::from(end - skipped);
            let setting = format!("{:.0e}{}", f64::from(steps), if from_scratch { "" } else { "*" });
            panel.add(&format!("steps of the load, {}", solver.name()), setting, off(factor, exact), whole);
            last = factor;
        }
        Ok(())
    }

    /// Bisects until the interval's length, relative to its upper end, is at most `tolerance`.
    fn bisected(&self, tolerance: f64, solver: Solver) -> Result<f64, Failure> {
        let (mut below, mut above) = (0.0, self.most);
        while above - below > tolerance * above {
            let middle = 0.5 * (below + above);
            *(if self.sticks(middle, solver)? { &mut below } else { &mut above }) = middle;
        }
        Ok(0.5 * (below + above))
    }

    fn direct(&self, panel: &mut Panel, exact: f64) -> Result<(), Failure> {
        let ramp = Ramp::load(Wrench::ZERO, self.direction);
        for (name, beyond) in [(ALONE, false), (DIRECT, true)] {
            let (factor, time) = timed(|| {
                let onset = self.grasp.onset(&ramp)?;
                if let Some(event) = onset.event().filter(|_| beyond) {
                    std::hint::black_box(self.grasp.beyond(event));
                }
                Ok(onset.factor().ok_or("a sticking base")?)
            })?;
            panel.add(name, "", off(factor, exact), time);
        }
        Ok(())
    }

    fn bisections(&self, panel: &mut Panel, name: &str, exact: f64, solver: Solver) -> Result<(), Failure> {
        for tolerance in TOLERANCES {
            let (factor, time) = timed(|| self.bisected(tolerance, solver))?;
            panel.add(name, format!("{tolerance:.0e}"), off(factor, exact), time);
        }
        Ok(())
    }
}

const SCREENED: &str = "direct, screening, contacts made ready";
const ALONE: &str = "direct, onset alone";
const DIRECT: &str = "direct, and what comes beyond it";

fn off(factor: f64, exact: f64) -> f64 {
    (factor / exact - 1.0).abs()
}

pub fn measure(report: &mut Report) -> Result<(), Failure> {
    report.push(in_the_plane()?);
    report.push(in_space()?);
    Ok(())
}

/// The paper's two fingers, which begin to slide under the load W* = √65/66 N.
fn in_the_plane() -> Result<Panel, Failure> {
    let (grasp, exact) = (two_fingers()?, 65_f64.sqrt() / 66.0);
    let question = Question { grasp: &grasp, direction: down(), cone: PolygonCone::default(), most: 1.0 };
    let mut panel =
        Panel::new("onset", "Onset of the paper's two fingers, W* = √65/66 N", "relative error of the onset");
    let contacts: &[_; 2] = grasp.contacts().try_into()?;
    screened(&mut panel, contacts, &down(), exact)?;
    question.direct(&mut panel, exact)?;
    for solver in [Solver::Lemke, Solver::InteriorPoint] {
        question.bisections(&mut panel, &format!("bisection, {}", solver.name()), exact, solver)?;
    }
    for solver in [Solver::Lemke, Solver::InteriorPoint] {
        question.steps(&mut panel, exact, solver)?;
    }
    panel.notes.push(
        "* Steps know nothing of each other. The last thousand before the onset are made, and their time is scaled to all."
            .into(),
    );
    ratios(&mut panel, &["QP by Clarabel", "QP by Lemke"])?;
    Ok(panel)
}

fn screened<const C: usize, const N: usize>(
    panel: &mut Panel,
    contacts: &[grasp_lcp::grasp::Contact<C>; N],
    direction: &Wrench<C>,
    exact: f64,
) -> Result<(), Failure> {
    const CALLS: u32 = 1000;
    let (fingers, pull) = (Fingers::<C, N>::new(contacts)?, Pull::new(&Wrench::ZERO, direction)?);
    // A single call is shorter than reading the clock, so that many are timed together.
    let (factor, time) = timed(|| {
        let mut factor = None;
        for _ in 0..CALLS {
            factor = std::hint::black_box(std::hint::black_box(&fingers).onset(&pull)).factor();
        }
        Ok(factor.ok_or("a sticking base")?)
    })?;
    panel.add(SCREENED, "", off(factor, exact), time / f64::from(CALLS));
    Ok(())
}

/// Three fingers at 120° with the normal stiffness k and the command a press with N = k a each. They share an axial load w and a moment m about
/// the axis evenly. With the contacts at the radius R, the onset factor τ satisfies τ hypot(w/3, m/3R) = μ N.
fn in_space() -> Result<Panel, Failure> {
    let (contacts, direction, exact) = pinch();
    let grasp = spatial::Grasp::new(contacts.clone())?;
    let mut panel = Panel::new(
        "onset",
        "Onset of three fingers in space, μN / hypot(w/3, m/3R)",
        "relative error of the onset",
    );
    screened(&mut panel, &contacts, &direction, exact)?;
    let on = |facets: usize| -> Result<_, Failure> {
        let cone = PolygonCone::new(facets, PolygonFit::Inscribed)?;
        Ok(Question { grasp: &grasp, direction, cone, most: 8.0 })
    };
    on(8)?.direct(&mut panel, exact)?;
    for (facets, solver) in [(8, Solver::Lemke), (8, Solver::InteriorPoint), (64, Solver::Lemke)] {
        let name = format!("bisection, {}, {facets} facets", solver.name());
        on(facets)?.bisections(&mut panel, &name, exact, solver)?;
    }
    ratios(&mut panel, &["QP by Clarabel, 8 facets", "QP by Lemke, 8 facets"])?;
    Ok(panel)
}

/// Adds notes: the time of bisection to the smallest tolerance relative to that of the direct methods.
fn ratios(panel: &mut Panel, solvers: &[&str; 2]) -> Result<(), Failure> {
    for direct in [SCREENED, ALONE, DIRECT] {
        for solver in solvers {
            let slow = panel.last(&format!("bisection, {solver}")).ok_or("measured")?;
            let ratio = slow.time / panel.last(direct).ok_or("measured")?.time;
            let ratio = if ratio < 10.0 { format!("{ratio:.1}") } else { format!("{ratio:.0}") };
            panel.notes.push(format!("bisection to 1e-12, {solver}: {ratio} times the time of: {direct}"));
        }
    }
    Ok(())
}

/// Contacts, the load at factor 1 and the exact onset of the symmetric three-finger grasp.
pub fn pinch() -> ([spatial::Contact; 3], spatial::Wrench, f64) {
    let (k, kt, mu, a, radius, w, m) = (300.0, 120.0, 0.5, 0.01, 0.8, 0.7, 0.9);
    let finger = |i: u8| {
        let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 3.0).sin_cos();
        spatial::Contact::new([radius * cos, radius * sin, 0.0], [-cos, -sin, 0.0])
            .tangent([0.0, 0.0, 1.0])
            .series_stiffness(k, kt)
            .friction(mu)
            .command([a, 0.0, 0.0])
    };
    let direction = spatial::Wrench::new([0.0, 0.0, -w], [0.0, 0.0, m]);
    let exact = mu * k * a / (w / 3.0_f64).hypot(m / (3.0 * radius));
    ([0, 1, 2].map(finger), direction, exact)
}
