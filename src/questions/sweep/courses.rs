//! Forces of contacts that keep their states: linear in the load, with their changes by errors of the data.

use alloc::sync::Arc;

use nalgebra::{Matrix, SVector};

use super::datum::UncertainDatum;
use super::margin::{Effect, LOOKED_AT, effect};
use crate::contact::{Polygon, State};
use crate::error::Error;
use crate::grasp::{Engine, Space, Wrench};
use crate::numerics::{Size, Vector};
use crate::object::{Load, Piece, PieceState};
use crate::prelude::*;

/// Forces with data as known, and with each datum off by each amount of `LOOKED_AT`.
#[derive(Debug, Clone)]
pub(super) struct AllForces {
    space: Space,
    known: LinearForces,
    off: Vec<[LinearForces; LOOKED_AT.len()]>,
}

/// Forces of all sites, or gaps of open sites: by commands alone, and by each component of the load.
#[derive(Debug, Clone)]
struct LinearForces {
    commanded: Vec<SVector<f64, 3>>,
    by_load: Vec<Vec<SVector<f64, 3>>>,
}

/// Forces by commands or by one load: with data as known, and their changes by each datum.
#[derive(Debug, Clone)]
pub(super) struct Course {
    pub(super) known: Vec<SVector<f64, 3>>,
    /// For each datum, its effect on each site.
    pub(super) off: Vec<Vec<Effect>>,
}

impl Course {
    fn with(all: &AllForces, forces: impl Fn(&LinearForces) -> Vec<SVector<f64, 3>>) -> Self {
        let known = forces(&all.known);
        let of_datum = |values: &[LinearForces; LOOKED_AT.len()]| {
            let seen = values.each_ref().map(&forces);
            let of_site = |(i, known)| effect(seen.each_ref().map(|forces| forces[i] - known));
            known.iter().enumerate().map(of_site).collect()
        };
        let off = all.off.iter().map(of_datum).collect();
        Self { known, off }
    }

    /// Forces by commands and by forces that hold contacts.
    pub(super) fn commanded(all: &AllForces) -> Self {
        Self::with(all, |forces| forces.commanded.clone())
    }

    /// Forces by a load.
    pub(super) fn of(all: &AllForces, load: &Wrench<3>) -> Self {
        Self::with(all, |forces| {
            let mut sum = vec![SVector::zeros(); forces.commanded.len()];
            for (by, x) in
                forces.by_load.iter().zip(load.coordinates(all.space).iter()).filter(|(_, x)| **x != 0.0)
            {
                sum.iter_mut().zip(by).for_each(|(sum, by)| *sum += by * *x);
            }
            sum
        })
    }

    /// The sum of both.
    pub(super) fn and(mut self, other: &Self) -> Self {
        self.known.iter_mut().zip(&other.known).for_each(|(sum, more)| *sum += more);
        for (sum, more) in self.off.iter_mut().flatten().zip(other.off.iter().flatten()) {
            sum.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
        }
        self
    }

    /// The largest force with data as known.
    pub(super) fn largest(&self) -> f64 {
        self.known.iter().map(Matrix::norm).fold(0.0, f64::max)
    }
}

impl Engine {
    /// Forces while sites keep these states, none of which slides, with data as known and with each datum off. Also the piece of these states.
    pub(super) fn all_forces(
        &self,
        states: &[State],
        polygon: &Arc<Polygon>,
        data: &[UncertainDatum],
        sigmas: f64,
    ) -> Result<(AllForces, Piece), Error> {
        let (known, piece) = self.forces(states, polygon);
        let mut off = Vec::with_capacity(data.len());
        for datum in data {
            let of = |part: f64| Ok::<_, Error>(datum.engine(self, part * sigmas)?.forces(states, polygon).0);
            let [low, half_low, half_high, high] = LOOKED_AT;
            off.push([of(low)?, of(half_low)?, of(half_high)?, of(high)?]);
        }
        Ok((AllForces { space: self.space(), known, off }, piece))
    }

    fn forces(&self, states: &[State], polygon: &Arc<Polygon>) -> (LinearForces, Piece) {
        let drives = self.drives();
        let at_rest = vec![SVector::zeros(); drives.len()];
        let problem = self.problem(polygon.clone(), false, drives.clone(), &Load::from(&Vector::zeros()));
        let piece = Piece::new(&problem, states);
        let seen = |drives: &[SVector<f64, 3>], wrench: &Vector| {
            let PieceState { mut forces, twist } = piece.solve_roughly(drives, wrench);
            for (i, site) in self.sites().iter().enumerate().filter(|(i, _)| states[*i].is_open()) {
                forces[i] = SVector::zeros();
                forces[i][0] = -site.stretch(&drives[i], &twist)[0];
            }
            forces
        };
        let commanded = seen(&drives, &self.load_unchecked(&Wrench::ZERO));
        let by_load = (0..self.space().of_the_object())
            .map(|k| seen(&at_rest, &self.inside_unchecked(&unit(self.space(), k))))
            .collect();
        (LinearForces { commanded, by_load }, piece)
    }
}

/// One newton or newton metre of a component.
pub(super) fn unit(space: Space, component: usize) -> Wrench<3> {
    Wrench::among(space, &Vector::unit(Size::of(space.of_the_object()), component))
}
