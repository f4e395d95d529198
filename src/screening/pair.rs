//! Two contacts in the plane: forces in closed form, in compliances.
//!
//! The way from contact 1 to contact 2 is p, with `p_1 = p` and `p_2 = -p`; `p_i⊥` is a quarter
//! turn further and m the midpoint. The compliances are `C_i = K_i⁻¹` in coordinate axes. Balance
//! of forces and moments leaves one unknown λ, the force along the line through both:
//!
//! ```text
//! F_i = λ p_i + s p_i⊥ - W_f / 2,   s = (W_m - m × W_f) / |p|²
//! ```
//!
//! The object does not change its length, which fixes λ:
//!
//! ```text
//! Σ p_i·(a_i - C_i F_i) = 0
//! ```
//!
//! The factor of λ there is a sum of positive terms: no stiffness cancels, whatever the ratios.

use super::block::{Block, Parted, Sizes};
use super::factors::NOTHING;
use super::forces::{Forces, ON_THE_EDGE};
use super::lanes::Lanes;
use crate::contact::ZERO_SLACK as ROUNDING;

/// Turns stiffnesses into compliances.
///
/// A contact without friction has an infinite compliance along its tangent: the condition on λ
/// reads `F_t = 0` there, and all its other terms vanish. Two such contacts do not hold anything
/// together. Nor does one whose normal points along the line: the object turns about the other
/// contact. The compliances of both are then not numbers.
pub(super) fn to_compliances<const C: usize, const N: usize>(
    scene: &mut Block<C, N, 1>,
    parted: &mut Parted<N, 1>,
) {
    let slippery = scene.springs[1].map(|k| k.0[0] == 0.0);
    let [x, y] = [0, 1].map(|axis| scene.point[axis][1].0[0] - scene.point[axis][0].0[0]);
    let along = |i: usize| {
        let t = scene.normal[1][i].0[0] * x - scene.normal[0][i].0[0] * y;
        t * t <= NOTHING * (x * x + y * y)
    };
    let count = (0..2).map(|i| if slippery[i] { 1 + usize::from(along(i)) } else { 0 }).sum();
    for i in 0..N {
        let [normal, tangential] = [scene.springs[0][i], scene.springs[1][i]];
        let compliances = match count {
            0 => [Lanes::all(1.0) / normal, Lanes::all(1.0) / tangential],
            1 => [Lanes::ZERO, Lanes::all(f64::from(u8::from(slippery[i])))],
            _ => [Lanes::all(f64::NAN); 2],
        };
        for (axis, compliance) in compliances.into_iter().enumerate() {
            scene.springs[axis][i] = compliance;
        }
        if count > 0 {
            scene.pressed[i] = Lanes::ZERO;
            scene.sheared[0][i] = Lanes::ZERO;
            *parted = Parted::EMPTY;
        }
    }
    scene.sizes = sizes(scene);
}

/// The sizes of a pair of contacts with compliances.
fn sizes<const C: usize, const N: usize>(scene: &Block<C, N, 1>) -> Sizes<1> {
    let pair = Pair::new(scene);
    let one = Lanes::all(1.0);
    let [x, y] = [0, 1].map(|axis| scene.point[axis][1] - scene.point[axis][0]);
    let length = x.abs() + y.abs();
    let mut gives = Lanes::ZERO;
    for i in 0..2 {
        gives += pair.u[i].abs() + pair.v[i].abs();
    }
    let commands = pair.size_of(length, &scene.pressed, &scene.sheared[0]);
    let scale = length * pair.one_over_give;
    let gives = one + scale * gives;
    let moment = length * pair.one_over_square * gives;
    let [x, y] = pair.midpoint;
    Sizes { commands, moment, force: moment * (x.abs() + y.abs()) + gives }
}

/// Two contacts and the line through them. Arrays run over the contacts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair<const L: usize> {
    normal: [[Lanes<L>; 2]; 2],
    midpoint: [Lanes<L>; 2],
    /// Entries of `p_i` along normals and tangents.
    n: [Lanes<L>; 2],
    t: [Lanes<L>; 2],
    /// Those of `C_i p_i`.
    u: [Lanes<L>; 2],
    v: [Lanes<L>; 2],
    one_over_give: Lanes<L>,
    one_over_square: Lanes<L>,
    /// How much the line would have to give if s were one, and what the fingers take from it by
    /// going where they are told.
    sheared: Lanes<L>,
    commanded: Lanes<L>,
    sizes: Sizes<L>,
}

impl<const L: usize> Pair<L> {
    #[inline(always)]
    pub(super) fn new<const C: usize, const N: usize>(block: &Block<C, N, L>) -> Self {
        let zero = [Lanes::ZERO; 2];
        let [px, py] = [block.point[0], block.point[1]];
        let x = [px[1] - px[0], px[0] - px[1]];
        let y = [py[1] - py[0], py[0] - py[1]];
        let half = Lanes::all(0.5);
        let midpoint = [half * (px[0] + px[1]), half * (py[0] + py[1])];
        let (mut normal, mut n, mut t, mut u, mut v) = ([zero; 2], zero, zero, zero, zero);
        let (mut give, mut sheared, mut commanded) = (zero, zero, zero);
        for i in 0..2 {
            normal[0][i] = block.normal[0][i];
            normal[1][i] = block.normal[1][i];
            n[i] = normal[0][i] * x[i] + normal[1][i] * y[i];
            t[i] = normal[1][i] * x[i] - normal[0][i] * y[i];
            u[i] = block.springs[0][i] * n[i];
            v[i] = block.springs[1][i] * t[i];
            give[i] = u[i] * n[i] + v[i] * t[i];
            sheared[i] = u[i] * t[i] - v[i] * n[i];
            commanded[i] = taken(i, &block.pressed, &block.sheared[0], (n[i], t[i]));
        }
        let one_over_give = Lanes::all(1.0) / (give[0] + give[1]);
        let one_over_square = Lanes::all(1.0) / (x[0] * x[0] + y[0] * y[0]);
        Self {
            normal,
            midpoint,
            n,
            t,
            u,
            v,
            one_over_give,
            one_over_square,
            sheared: sheared[0] + sheared[1],
            commanded: commanded[0] + commanded[1],
            sizes: block.sizes,
        }
    }

    /// Forces that a load alone brings about.
    #[inline(always)]
    pub(super) fn load<const D: usize, const C: usize, const N: usize>(
        &self,
        load: &[Lanes<L>; D],
    ) -> Forces<C, N, L> {
        let zero = [Lanes::ZERO; 2];
        let s = (load[2] - (self.midpoint[0] * load[1] - self.midpoint[1] * load[0])) * self.one_over_square;
        // Minus half of the load.
        let (x, y) = (Lanes::all(-0.5) * load[0], Lanes::all(-0.5) * load[1]);
        let (mut halves, mut given) = ([zero; 2], zero);
        for i in 0..2 {
            halves[0][i] = self.normal[0][i] * x + self.normal[1][i] * y;
            halves[1][i] = self.normal[1][i] * x - self.normal[0][i] * y;
            given[i] = self.u[i] * halves[0][i] + self.v[i] * halves[1][i];
        }
        let lambda = -((s * self.sheared + (given[0] + given[1])) * self.one_over_give);
        let size = self.sizes.moment * load[2].abs() + self.sizes.force * (load[0].abs() + load[1].abs());
        let mut forces = Forces::none();
        for i in 0..2 {
            forces.normal[i] = lambda * self.n[i] + (s * self.t[i] + halves[0][i]);
            forces.tangential[0][i] = lambda * self.t[i] + (halves[1][i] - s * self.n[i]);
            forces.rounding[i] = Lanes::all(ROUNDING) * size;
        }
        forces
    }

    /// Forces that the commands of the fingers alone bring about: along the line through both.
    #[inline(always)]
    pub(super) fn squeeze<const C: usize, const N: usize>(&self) -> Forces<C, N, L> {
        self.squeezed(self.commanded, self.sizes.commands)
    }

    /// The same of other commands than those of the block.
    #[inline(always)]
    pub(super) fn squeeze_by<const C: usize, const N: usize>(
        &self,
        block: &Block<C, N, L>,
        (pressed, sheared): (&[Lanes<L>; N], &[Lanes<L>; N]),
    ) -> Forces<C, N, L> {
        let [x, y] = [0, 1].map(|axis| block.point[axis][1] - block.point[axis][0]);
        let taken = |i: usize| taken(i, pressed, sheared, (self.n[i], self.t[i]));
        self.squeezed(taken(0) + taken(1), self.size_of(x.abs() + y.abs(), pressed, sheared))
    }

    /// What the rounding of forces by commands is measured against.
    #[inline(always)]
    fn size_of<const N: usize>(
        &self,
        length: Lanes<L>,
        pressed: &[Lanes<L>; N],
        sheared: &[Lanes<L>; N],
    ) -> Lanes<L> {
        let mut commands = Lanes::ZERO;
        for i in 0..2 {
            commands += pressed[i].abs() + sheared[i].abs();
        }
        length * (length * self.one_over_give) * commands
    }

    #[inline(always)]
    fn squeezed<const C: usize, const N: usize>(
        &self,
        commanded: Lanes<L>,
        size: Lanes<L>,
    ) -> Forces<C, N, L> {
        let lambda = commanded * self.one_over_give;
        let mut forces = Forces::none();
        for i in 0..2 {
            forces.normal[i] = lambda * self.n[i];
            forces.tangential[0][i] = lambda * self.t[i];
            forces.rounding[i] = Lanes::all(ON_THE_EDGE) * size;
        }
        forces
    }
}

/// What a finger takes from the line through both by going where it is told.
#[inline(always)]
fn taken<const N: usize, const L: usize>(
    i: usize,
    pressed: &[Lanes<L>; N],
    sheared: &[Lanes<L>; N],
    (n, t): (Lanes<L>, Lanes<L>),
) -> Lanes<L> {
    pressed[i] * n + sheared[i] * t
}
