//! The first slip under a turning load agrees with roots of the friction margins that are counted and isolated in exact arithmetic.

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::FoundBy;
use grasp_lcp::load_path::{Onset, Turn};
use grasp_lcp::nalgebra::SMatrix;
use grasp_lcp::{Error, planar, spatial};
use support::dyadic::{Dyadic, solve};
use support::samples::{samples, seeded};
use support::splitmix::Random;

const BITS: u64 = 200;
/// Number of bisections that isolate a root; the first bisections count roots by Sturm's chain.
const HALVINGS: usize = 60;
const COUNTED: usize = 20;

fn d(x: f64) -> Dyadic {
    Dyadic::new(x)
}

const SCENES: usize = 48;

/// Data of one contact: rows of Gᵀ along its axes, stiffnesses, command along the normal, friction.
struct Spring {
    rows: Vec<Vec<Dyadic>>,
    stiffness: Vec<Dyadic>,
    command: Dyadic,
    friction: Dyadic,
}

impl Spring {
    fn new<const C: usize>(
        point: [f64; C],
        frame: &grasp_lcp::nalgebra::SMatrix<f64, C, C>,
        [k, kt, command, mu]: [f64; 4],
    ) -> Self {
        let planes: &[(usize, usize)] = if C == 2 { &[(0, 1)] } else { &[(1, 2), (2, 0), (0, 1)] };
        let row = |a: usize| {
            let axis: Vec<Dyadic> = (0..C).map(|b| d(frame[(b, a)])).collect();
            let moment = |&(i, j): &(usize, usize)| &(&d(point[i]) * &axis[j]) - &(&d(point[j]) * &axis[i]);
            axis.iter().cloned().chain(planes.iter().map(moment)).collect()
        };
        let stiffness = (0..C).map(|a| d(if a == 0 { k } else { kt })).collect();
        Self { rows: (0..C).map(row).collect(), stiffness, command: d(command), friction: d(mu) }
    }
}

/// Forces of all contacts under a load while everything sticks, exact except for the last division. Forces of the commands are included if
/// `commanded`.
fn forces(springs: &[Spring], load: &[f64], commanded: bool) -> Vec<Vec<Dyadic>> {
    let n = load.len();
    let mut matrix = vec![vec![Dyadic::zero(); n]; n];
    let mut side: Vec<Dyadic> = load.iter().map(|x| d(*x)).collect();
    for spring in springs {
        for (row, k) in spring.rows.iter().zip(&spring.stiffness) {
            for a in 0..n {
                for b in 0..n {
                    matrix[a][b] = &matrix[a][b] + &(&(&row[a] * &row[b]) * k);
                }
            }
        }
        let push = &spring.command * &spring.stiffness[0];
        for (side, g) in side.iter_mut().zip(&spring.rows[0]).filter(|_| commanded) {
            *side = &*side + &(g * &push);
        }
    }
    let q = solve(&matrix, &side, BITS).expect("regular");
    let force = |spring: &Spring| {
        let along = |a: usize| {
            let drive = if commanded && a == 0 { spring.command.clone() } else { Dyadic::zero() };
            let stretch = spring.rows[a].iter().zip(&q).fold(drive, |v, (g, q)| &v - &(g * q));
            (&stretch * &spring.stiffness[a]).rounded(BITS)
        };
        (0..spring.rows.len()).map(along).collect()
    };
    springs.iter().map(force).collect()
}

/// The coefficients of `c + a cos θ + b sin θ`.
type Linear = [Dyadic; 3];

/// The coefficients `[c, a₁, b₁, a₂, b₂]` of a trigonometric polynomial of degree two.
type Trigonometric = [Dyadic; 5];

fn square([c, a, b]: &Linear) -> Trigonometric {
    let half = |x: &Dyadic| x * &d(0.5);
    let (cc, aa, bb) = (c * c, a * a, b * b);
    [&cc + &half(&(&aa + &bb)), &d(2.0) * &(c * a), &d(2.0) * &(c * b), half(&(&aa - &bb)), a * b]
}

/// Coefficients of the polynomial in t = tan(θ/2), multiplied by (1 + t²)², constant first.
fn polynomial([c, a, b, a2, b2]: &Trigonometric) -> Vec<Dyadic> {
    let (two_b, four_b2) = (&d(2.0) * b, &d(4.0) * b2);
    vec![&(c + a) + a2, &two_b + &four_b2, &(&d(2.0) * c) - &(&d(6.0) * a2), &two_b - &four_b2, &(c - a) + a2]
}

fn a_quarter_on([c, a, b, a2, b2]: &Trigonometric) -> Trigonometric {
    [c.clone(), b.clone(), -a, -a2, -b2]
}

fn value(p: &[Dyadic], t: &Dyadic) -> Dyadic {
    p.iter().rev().fold(Dyadic::zero(), |sum, p| &(&sum * t) + p)
}

/// Sturm's chain by pseudo-remainders, which preserve signs.
fn chain(p: &[Dyadic]) -> Vec<Vec<Dyadic>> {
    let trimmed = |mut p: Vec<Dyadic>| {
        while p.last().is_some_and(Dyadic::is_zero) {
            p.pop();
        }
        p
    };
    let first = trimmed(p.to_vec());
    let derivative = (1..first.len()).map(|k| &first[k] * &d(k as f64)).collect();
    let mut chain = vec![first, trimmed(derivative)];
    loop {
        let [.., dividend, divisor] = &chain[..] else { return chain };
        if divisor.is_empty() {
            chain.pop();
            return chain;
        }
        let mut rest = dividend.clone();
        let lead = divisor.last().expect("not empty");
        while rest.len() >= divisor.len() {
            // Multiplication by the square of the leading coefficient is positive.
            let top = &rest[rest.len() - 1] * lead;
            let shift = rest.len() - divisor.len();
            let square = lead * lead;
            rest = rest.iter().map(|x| x * &square).collect();
            for (k, x) in divisor.iter().enumerate() {
                rest[shift + k] = &rest[shift + k] - &(&top * x);
            }
            rest.pop();
            rest = trimmed(rest);
        }
        let next: Vec<Dyadic> = rest.iter().map(|x| -x).collect();
        chain.push(next);
    }
}

/// Number of sign changes of the chain at t.
fn changes(chain: &[Vec<Dyadic>], t: &Dyadic) -> usize {
    let signs: Vec<bool> =
        chain.iter().map(|p| value(p, t)).filter(|x| !x.is_zero()).map(|x| x.is_negative()).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// The first root in (0, 2π] of a trigonometric polynomial, and whether a second root is close to the first.
fn first_root(f: &Trigonometric) -> Option<(f64, bool)> {
    let mut here = f.clone();
    for quarter in 0..4 {
        let chain = chain(&polynomial(&here));
        let count = |low: &Dyadic, high: &Dyadic| changes(&chain, low) - changes(&chain, high);
        let (mut low, mut high) = (Dyadic::zero(), d(1.0));
        if count(&low, &high) > 0 {
            for _ in 0..COUNTED {
                let middle = &(&low + &high) * &d(0.5);
                if count(&low, &middle) > 0 { high = middle } else { low = middle }
            }
            let close = count(&low, &high) > 1;
            let falls = !value(&chain[0], &low).is_negative();
            for _ in COUNTED..HALVINGS {
                let middle = &(&low + &high) * &d(0.5);
                if value(&chain[0], &middle).is_negative() == falls { high = middle } else { low = middle }
            }
            return Some((
                f64::from(quarter) * std::f64::consts::FRAC_PI_2 + 2.0 * high.float().atan(),
                close,
            ));
        }
        here = a_quarter_on(&here);
    }
    None
}

/// The first angle at which the margin μ² F_n² - |F_t|² of any contact vanishes (in the plane on either edge of its cone), and whether a second root
/// is close.
fn reference(springs: &[Spring], parts: [&[f64]; 3]) -> Option<(f64, bool)> {
    let [constant, cosine, sine] = [(parts[0], true), (parts[1], false), (parts[2], false)]
        .map(|(load, with)| forces(springs, load, with));
    let mut first: Option<(f64, bool)> = None;
    for (i, spring) in springs.iter().enumerate() {
        let linear = |a: usize| [&constant, &cosine, &sine].map(|part| part[i][a].clone());
        let limit = linear(0).map(|x| &x * &spring.friction);
        let margin = (1..spring.rows.len()).fold(square(&limit), |sum, a| {
            let friction = square(&linear(a));
            std::array::from_fn(|k| &sum[k] - &friction[k])
        });
        if let Some(root) = first_root(&margin)
            && first.is_none_or(|first| root.0 < first.0)
        {
            first = Some(root);
        }
    }
    first
}

/// Counts of turns for which the library and the exact roots agree.
#[derive(Debug, Default)]
struct Tally {
    onsets: usize,
    never: usize,
    near: usize,
    worst: f64,
}

/// Data of a contact: its point; both stiffnesses, the command along its normal, and friction.
type Datum<const C: usize> = ([f64; C], [f64; 4]);

impl Tally {
    /// Compares the angle of first slip under a turning load with the exact roots, if all contacts stick at the start.
    fn compare<const C: usize>(
        &mut self,
        grasp: &Grasp<C>,
        data: &[Datum<C>],
        turn: &Turn<C>,
    ) -> Result<(), Error> {
        let rest = grasp.solve(turn.load_at(0.0))?;
        if rest.equilibrium().is_none_or(|rest| rest.rule != FoundBy::EverythingSticks) {
            return Ok(());
        }
        let spring =
            |((point, data), frame): (&Datum<C>, &SMatrix<f64, C, C>)| Spring::new(*point, frame, *data);
        let springs: Vec<_> = data.iter().zip(grasp.frames()).map(spring).collect();
        let parts = turn.parts();
        match (
            grasp.onset_of_turn(turn)?.onset,
            reference(&springs, parts.each_ref().map(grasp_lcp::grasp::Wrench::components)),
        ) {
            (_, Some((_, true))) => self.near += 1,
            (Onset::Never, None) => self.never += 1,
            (Onset::At(event), Some((angle, _))) => {
                self.onsets += 1;
                self.worst = self.worst.max((event.factor - angle).abs());
            }
            (onset, known) => panic!("{onset:?}, known {known:?}"),
        }
        Ok(())
    }

    fn judge(&self) {
        println!("{self:?}");
        let some = samples(SCENES / 16);
        assert!(
            self.onsets > some && self.never > some && self.near < samples(5) && self.worst < 1e-13,
            "{self:?}"
        );
    }
}

/// Random stiffnesses, the command for 10 N, and friction. In every second scene stiffnesses differ by up to 1e8.
fn springs(number: usize, numbers: &mut Random) -> [f64; 4] {
    let decades = if number.is_multiple_of(2) { 0.3 } else { 4.0 };
    let k = 1000.0 * 10_f64.powf(decades * numbers.signed());
    [k, k * (0.5 + numbers.uniform()), 10.0 / k, 0.3 + 0.6 * numbers.uniform()]
}

#[test]
fn in_the_plane() -> Result<(), Error> {
    let mut numbers = seeded(11);
    let mut tally = Tally::default();
    for number in 0..samples(SCENES) {
        let count = 2 + number % 3;
        let (mut contacts, mut data) = (Vec::new(), Vec::new());
        for k in 0..count {
            let angle = std::f64::consts::TAU * (k as f64 + 0.3 * numbers.signed()) / count as f64;
            let point = [angle.cos(), angle.sin()];
            let normal = [-point[0] + 0.2 * numbers.signed(), -point[1] + 0.2 * numbers.signed()];
            let [k, kt, command, mu] = springs(number, &mut numbers);
            let contact = planar::Contact::new(point, normal).series_stiffness(k, kt).friction(mu);
            contacts.push(contact.command([command, 0.0]));
            data.push((point, [k, kt, command, mu]));
        }
        let weight = 16.0 * numbers.uniform();
        let turn = planar::Turn::tilting([0.0, -weight], [0.3 * numbers.signed(), 0.3 * numbers.signed()])
            .beside(planar::Wrench::force([0.5 * numbers.signed(), 0.0]));
        tally.compare(&planar::Grasp::new(contacts)?, &data, &turn)?;
    }
    tally.judge();
    Ok(())
}

#[test]
fn on_the_round_cone() -> Result<(), Error> {
    let mut numbers = seeded(12);
    let mut tally = Tally::default();
    for number in 0..samples(SCENES) {
        let count = 3 + number % 3;
        let (mut contacts, mut data) = (Vec::new(), Vec::new());
        for k in 0..count {
            let angle = std::f64::consts::TAU * (k as f64 + 0.3 * numbers.signed()) / count as f64;
            let point = [angle.cos(), angle.sin(), 0.3 * numbers.signed()];
            let bent: [f64; 3] = numbers.vector();
            let normal: [f64; 3] = std::array::from_fn(|a| 0.2 * bent[a] - point[a]);
            let [k, kt, command, mu] = springs(number, &mut numbers);
            let contact = spatial::Contact::new(point, normal).series_stiffness(k, kt).friction(mu);
            contacts.push(contact.command([command, 0.0, 0.0]));
            data.push((point, [k, kt, command, mu]));
        }
        let weight = 24.0 * numbers.uniform();
        let centre = numbers.vector().map(|x| 0.2 * x);
        let turn = spatial::Turn::tilting([0.0, 0.0, -weight], centre, numbers.vector())?
            .beside(spatial::Wrench::force(numbers.vector().map(|x| 0.5 * x)));
        tally.compare(&spatial::Grasp::new(contacts)?, &data, &turn)?;
    }
    tally.judge();
    Ok(())
}
