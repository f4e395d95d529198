//! Margins of measured contact forces, and the load factor of first slip from them under a load to come, for a control loop. At first slip the first
//! contact ceases to stick. The load factor is the multiple of the load to come.

use core::fmt;

use super::answer_slots::AnswerSlots;
use super::block::{MOST_SCREENED, count, entries};
use super::cone::StickingCone;
use super::fingers::Fingers;
use super::first_exit::judge;
use super::first_slip::SlipCode;
use super::forces::AnyForces;
use super::kernels::Kernels;
use super::lanes::{Packed, dot};
use super::least_factor::LeastFactor;
use super::question::{PreparedBlock, ScreeningQuestion, WorkingForces};
use super::screened::Screened;
use super::screened_squeeze::ScreenedSqueeze;
use super::tolerances::ON_THE_EDGE;
use crate::contact::ZERO_SLACK;
use crate::error::{ContactLabel, Error, Field};
use crate::grasp::Wrench;
use crate::numerics::Vectors;

/// The answer of [`Fingers::watch`] for measured contact forces of one grasp: their margins, the load factor of first slip under an expected load,
/// and the relative increase of all commands that this load needs.
#[derive(Clone, Copy, PartialEq)]
pub struct Watched {
    margin: f64,
    tightest: usize,
    first_slip: Screened,
    extra_squeeze: ScreenedSqueeze,
}

impl Watched {
    pub(super) const UNKNOWN: Self = Self {
        margin: f64::NAN,
        tightest: 0,
        first_slip: Screened(SlipCode::UNKNOWN),
        extra_squeeze: ScreenedSqueeze::UNKNOWN,
    };

    /// The least margin over all contacts under the measured forces, N: `μ F_n - |F_t|` if the contact may slide, `F_n` if it can only open. It is
    /// negative if a measured force lies outside its cone: the contact slides already, or the measurement or its friction coefficient is wrong. It is
    /// infinite if no contact can cease to stick.
    #[must_use]
    pub fn margin(&self) -> f64 {
        self.margin
    }

    /// The contact with the least margin, counted from 0; the first contact if several have this margin.
    #[must_use]
    pub fn tightest(&self) -> usize {
        self.tightest
    }

    /// The multiple of the expected load at which the first contact ceases to stick, and that contact. If the multiple is above one, all contacts
    /// stick under the whole expected load.
    #[must_use]
    pub fn first_slip(&self) -> Screened {
        self.first_slip
    }

    /// The least relative increase of all commands, applied together with the expected load, with which every contact sticks under this load. Zero if
    /// no increase is needed. If all commands are multiplied by one plus this number, every contact sticks under the expected load.
    #[must_use]
    pub fn extra_squeeze(&self) -> ScreenedSqueeze {
        self.extra_squeeze
    }
}

impl fmt::Debug for Watched {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Watched")
            .field("margin", &self.margin)
            .field("tightest", &self.tightest)
            .field("first_slip", &self.first_slip)
            .field("extra_squeeze", &self.extra_squeeze)
            .finish()
    }
}

impl<const C: usize, const N: usize> Fingers<C, N> {
    /// Margins of contact forces measured now, and two numbers for a load that is to come in addition to the present load: the load factor of first
    /// slip, and the relative increase of all commands that the load needs. Nothing is allocated, and the number of operations is bounded for a given
    /// number of contacts, for a control loop with a deadline.
    ///
    /// Forces act on the object at the contacts, along the coordinate axes, N. They may differ from the forces that follow from the springs of the
    /// fingers, because they contain past slip and errors of the model. Only changes of forces are computed from the springs, as if every contact
    /// stuck: those due to the load to come (N and N m, moments about the origin) and those due to larger commands.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Fingers, Wrench};
    ///
    /// // Jaws that press with 10 N, μ = 0.5, and hold 6 N: each bears 3 N of the 5 N that it can.
    /// let jaw = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(10.0);
    /// let fingers = Fingers::new(&[jaw(-1.0), jaw(1.0)])?;
    /// let watched = fingers.watch(&[[10.0, 3.0], [-10.0, 3.0]], &Wrench::force([0.0, -5.0]))?;
    /// assert!((watched.margin() - 2.0).abs() < 1e-13);
    /// // Of 5 N more they hold four fifths; for all of it they must press with 11 N.
    /// assert!((watched.first_slip().factor().unwrap() - 0.8).abs() < 1e-13);
    /// assert!((watched.extra_squeeze().factor().unwrap() - 0.1).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Contact`] naming the contact whose force is not finite or larger than 1e50, [`Error::Wrench`] for such a component of the load.
    pub fn watch(&self, forces: &[[f64; C]; N], to_come: &Wrench<C>) -> Result<Watched, Error> {
        to_come.check("load to come")?;
        for (index, force) in forces.iter().enumerate() {
            if let Some(&value) = force.iter().find(|value| !value.is_finite() || value.abs() > 1e50) {
                let contact = ContactLabel { index, point: None, name: None, link: None };
                let allowed = "a number of at most 1e50 N";
                return Err(Error::Contact { contact, field: Field::Force, value, allowed });
            }
        }
        Ok((Kernels::get().watch)(&self.grasp, &Measured { forces, to_come }))
    }
}

/// Measured contact forces along the coordinate axes, N, and the load that is to come in addition to the present load.
pub(super) struct Measured<'a, const C: usize> {
    forces: &'a [[f64; C]],
    to_come: &'a Wrench<C>,
}

impl<const C: usize> Measured<'_, C> {
    /// Writes the measured forces, split into components along and across the normals, to `measured`. The rounding error of each force is taken to be
    /// at most 1e-12 of the force.
    #[inline(always)]
    fn write<X: Packed>(&self, normals: [&[X]; C], measured: &mut AnyForces<C, X>) {
        measured.clear();
        for (i, force) in self.forces.iter().enumerate().take(MOST_SCREENED) {
            let (normal, mut world) = (entries(&normals, i), [X::all(0.0); C]);
            for axis in 0..C {
                world[axis] = X::all(force[axis]);
            }
            let along = dot(&normal, &world);
            let part = &mut measured.of[i];
            part.normal = along;
            let mut size = along.abs();
            if const { C == 2 } {
                part.tangential[0] = normal[1] * world[0] - normal[0] * world[1];
                size += part.tangential[0].abs();
            } else {
                for axis in 0..C {
                    part.tangential[axis] = world[axis] - along * normal[axis];
                    size += part.tangential[axis].abs();
                }
            }
            measured.of[i].rounding = X::all(ON_THE_EDGE) * size;
        }
    }
}

impl<const C: usize> ScreeningQuestion<C> for Measured<'_, C> {
    type Answer = Watched;
    const UNKNOWN: Watched = Watched::UNKNOWN;

    #[inline(always)]
    fn ask<V: Vectors, X: Packed>(
        &self,
        prepared: &PreparedBlock<'_, V, C, X>,
        [to_come, measured, commands]: WorkingForces<'_, C, X>,
        slots: &mut AnswerSlots<'_, Watched, X>,
    ) {
        let (friction, contacts) = (prepared.block.friction(), prepared.block.contacts);
        prepared.under(self.to_come, to_come);
        self.write(prepared.block.normals(), measured);
        let first_slip = judge(prepared.vectors, &prepared.block, measured, to_come);
        let (mut margin, mut tightest) = (X::all(f64::INFINITY), X::all(0.0));
        for i in 0..count(contacts) {
            let cone = StickingCone::of(friction[i]);
            let t = cone.friction(&measured.of[i]);
            let here = cone.alpha * measured.of[i].normal - dot(&t, &t).sqrt();
            let here = cone.alpha.above(X::all(0.0), here, X::all(f64::INFINITY));
            tightest = margin.above(here, X::all(i as f64), tightest);
            margin = margin.min(here);
        }
        measured.scale_rounding(ZERO_SLACK / ON_THE_EDGE);
        to_come.add_to(contacts, measured, 1.0);
        prepared.apart([commands, measured]);
        let mut enough = LeastFactor::new();
        enough.under(prepared.vectors, 0, friction, [&*commands, &*to_come]);
        let (code, binding) = enough.least();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // it is a small whole number
        slots.each(X::each(|lane| Watched {
            margin: margin.lane(lane),
            tightest: tightest.lane(lane) as usize,
            first_slip: first_slip.as_ref()[lane],
            extra_squeeze: ScreenedSqueeze { code: code.lane(lane), binding: binding.lane(lane) },
        }));
    }
}
