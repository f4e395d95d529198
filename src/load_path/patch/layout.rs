//! From the question to contacts in energy coordinates, and from leg to leg.

use nalgebra::SVector;

use super::PatchPath;
use super::balance::Sums;
use super::local::Local;
use crate::contact::Mode;
use crate::grasp::Site;
use crate::load_path::event::PathEnd;
use crate::numerics::Orthogonal;
use crate::numerics::{SUMMED_IN_TURN, both};
use crate::object::Facet;
use crate::object::Problem;

/// A load that does this little work on a unit free motion, relative to its size, does none.
const NO_WORK: f64 = 1e-13;
/// How often what rounding leaves of balance is removed from the trial state,
const PASSES: usize = 4;
/// unless what it leaves is less than this part of its springs' forces.
const BALANCED: f64 = 1e-15;

/// The common factor of the springs of all contacts, `K^{1/2}Gᵀ = QR`.
#[derive(Debug, Clone)]
pub(super) struct Springs<const D: usize> {
    pub(super) factor: Orthogonal<D>,
    /// Motions that no contact resists.
    pub(super) free: Vec<SVector<f64, D>>,
}

impl<const D: usize> Springs<D> {
    pub(super) fn new<const C: usize>(sites: &[Site<D, C>]) -> Self {
        let count = sites.iter().map(|site| site.springs.axes()).sum();
        let mut rows = Vec::with_capacity(count);
        for site in sites {
            rows.extend(
                (0..site.springs.axes()).map(|axis| site.map.column(axis) * site.springs.root_along(axis)),
            );
        }
        let factor = Orthogonal::new(rows);
        Self { free: factor.null_space(), factor }
    }

    /// The motion on which a load works though nothing resists it.
    pub(super) fn worked_on(&self, wrench: &SVector<f64, D>) -> Option<SVector<f64, D>> {
        let along = self.free.iter().fold(SVector::zeros(), |sum, v| sum + v * v.dot(wrench));
        (along.norm() > NO_WORK * wrench.norm()).then(|| along.normalize())
    }
}

/// Contacts in energy coordinates, everything sticking, and the list of their facets.
pub(super) fn lay_out<const D: usize, const C: usize>(
    problem: &Problem<'_, D, C>,
    springs: &Springs<D>,
    weight: f64,
) -> (Vec<Local<D, C>>, Vec<SVector<f64, C>>) {
    let mut locals: Vec<Local<D, C>> = Vec::with_capacity(problem.len());
    let mut facets: Vec<SVector<f64, C>> = Vec::new();
    let scale = 1.0 / weight.sqrt();
    let mut spring = 0;
    for (contact, law) in problem.locals().enumerate() {
        let mut local = Local::<D, C> {
            seen: nalgebra::SMatrix::zeros(),
            trial: SVector::zeros(),
            rate: SVector::zeros(),
            memory: SVector::zeros(),
            width: 0.0,
            facets: 0,
            facet_count: 0,
            gap: law.may_open(),
            code: Mode::Rolling,
            stamp: 0,
            waits: false,
        };
        for axis in 0..law.springs.axes() {
            for k in 0..D {
                local.seen[(axis, k)] = springs.factor.row(spring)[k] * scale;
            }
            spring += 1;
        }
        local.width = local.seen.norm();
        let alike = locals.last().filter(|_| law.has_the_facets_of(&problem.local(contact - 1)));
        if let Some(last) = alike {
            (local.facets, local.facet_count) = (last.facets, last.facet_count);
        } else {
            // There are fewer than 2^32 numbers in memory.
            local.facets = u32::try_from(facets.len()).unwrap_or(u32::MAX);
            for h in law.facets() {
                facets.push(Facet::new(&law, h).row);
                local.facet_count += 1;
            }
        }
        locals.push(local);
    }
    (locals, facets)
}

/// `Σ Qᵀx` and `Σ x²` for x = x⁰ and x⁰'.
struct Pushed<const D: usize> {
    along: [SVector<f64, D>; 2],
    square: [f64; 2],
}

/// Does something to each contact from number `first` on and sums up. Sums are made of halves, so that their rounding grows with the
/// logarithm of their length, and are the same for any number of threads.
fn each_in_turn<const D: usize, const C: usize>(
    locals: &mut [Local<D, C>],
    first: usize,
    change: &(impl Fn(usize, &mut Local<D, C>) + Sync),
) -> Pushed<D> {
    if locals.len() > SUMMED_IN_TURN {
        let (count, middle) = (locals.len(), locals.len() / 2);
        let (near, far) = locals.split_at_mut(middle);
        let (a, b) =
            both(count, || each_in_turn(near, first, change), || each_in_turn(far, first + middle, change));
        let plus = |k: usize| (a.along[k] + b.along[k], a.square[k] + b.square[k]);
        let [base, rate] = [plus(0), plus(1)];
        return Pushed { along: [base.0, rate.0], square: [base.1, rate.1] };
    }
    let mut sum = Pushed { along: [SVector::zeros(); 2], square: [0.0; 2] };
    for (i, local) in (first..).zip(locals) {
        change(i, local);
        for (k, x) in [&local.trial, &local.rate].into_iter().enumerate() {
            sum.along[k] += local.seen.tr_mul(x);
            sum.square[k] += x.norm_squared();
        }
    }
    sum
}

impl<const D: usize, const C: usize> PatchPath<'_, D, C> {
    /// The elastic trial state at the beginning of the present leg, and where it goes.
    pub(super) fn lay_trial(&mut self) {
        let (grasp, program) = (self.grasp, &self.program);
        let [from, to] = program.load.map(|w| grasp.inside_unchecked(&w));
        let [before, after] = &program.commands;
        let drive = |i: usize, local: &mut Local<D, C>| {
            let (site, mut a) = (&grasp.sites()[i], before[i]);
            a[0] -= grasp.contacts()[i].clearance;
            let change = after[i] - before[i];
            for axis in 0..site.springs.axes() {
                let root = site.springs.root_along(axis);
                (local.trial[axis], local.rate[axis]) = (root * a[axis], root * change[axis]);
            }
        };
        let scale = self.weight.sqrt();
        let factor = &self.springs.factor;
        let loads = [from, to - from].map(|load| factor.load_coordinates(&load));
        let mut pushed = each_in_turn(&mut self.locals, 0, &drive);
        (self.travelled, self.travel_rate) = (SVector::zeros(), SVector::zeros());
        // Once to solve, and again to remove what rounding left of it: more than once where stiffnesses lie far apart.
        for _ in 0..PASSES {
            let steps = [0, 1].map(|k| pushed.along[k] * scale + loads[k]);
            let left = [0, 1].map(|k| steps[k].norm() <= BALANCED * pushed.square[k].sqrt());
            if left == [true; 2] {
                break;
            }
            self.travelled += steps[0];
            self.travel_rate += steps[1];
            let [base, rate] = steps.map(|step| step * scale);
            pushed = each_in_turn(&mut self.locals, 0, &|_, local: &mut Local<D, C>| {
                local.trial -= local.seen * base;
                local.rate -= local.seen * rate;
            });
        }
        // Where the trial state does not change, nothing does.
        let mean = (pushed.square[1] / grasp.len() as f64).sqrt();
        self.pace = if mean > 0.0 { mean } else { 1.0 };
        self.tau = 0.0;
    }

    /// The sums afresh.
    pub(super) fn renew(&mut self) {
        self.sums = Sums::of(&self.locals, &self.facets, self.weight, self.springs.factor.rank());
        self.age = 0;
        self.looked_at += self.locals.len();
    }

    /// Sets out on the present leg, or completes the path.
    pub(super) fn begin_leg(&mut self) {
        if !self.program.begin_leg() {
            self.end = Some(PathEnd::Completed);
            return;
        }
        self.lay_trial();
        self.set_out();
    }

    /// The same from where the trial state of the leg is known.
    pub(super) fn set_out(&mut self) {
        let [from, to] = self.program.load.map(|w| self.grasp.inside_unchecked(&w));
        if let Some(v) = self.springs.worked_on(&(to - from)) {
            let motion = self.grasp.outside(&v);
            self.end = Some(PathEnd::GivesWay { leg: self.program.leg, fraction: 0.0, motion });
            return;
        }
        self.renew();
        self.factors = self.sums.factors();
        self.settle_at(0.0);
        let mut stands = std::mem::take(&mut self.stands);
        stands.clear();
        stands.extend((0..self.locals.len()).map(|i| self.stand_of(i)).filter(|stand| !stand.is_nowhere()));
        self.stands = stands;
        self.sets_out = true;
        self.at_node = true;
    }
}
