//! Suspicious numbers in a scene: friction in percent, lengths in mm, masses in g, angles in degrees, normals that point outwards, and contacts that
//! are given twice. The base load of a question acts before its other loads. An outline is a closed line, which bounds an object in the plane. A link
//! (a hinge, spring or cable, for example) joins two bodies, or a body and the ground.

use core::f64::consts::TAU;

use nalgebra::SVector;

use super::fingertip::Fingertip;
use super::question::Question;
use super::setup::Setup;
use super::warning::Warning;
use crate::ask::Grasp;
use crate::grasp::{ATMOSPHERE, Hold, Wrench};
use crate::load_path::{Leg, Turn};
use crate::need::pressure_of_cup;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, Reals, Space, chosen, every_index, largest, mapped, picked};
use crate::statics::Closure;

impl Setup<3> {
    /// Warnings about implausible data of contacts, such as friction, stiffness, force and position. Loads of questions are not considered.
    pub(super) fn odd_contacts(&self, grasp: &Grasp<3>) -> Vec<Warning> {
        let mut warnings = Vec::new();
        let entries: Vec<_> = self.entries().list();
        let name = |i: usize| entries[i].contact.label_text(i);
        let names = |contacts: &[usize]| mapped(contacts, &|i| name(*i));
        let mu = |i: usize| entries[i].contact.friction_coefficient();
        // The coefficient of soft rubber on dry concrete is about 1.2, the coefficient of tyres of racing cars is less than 2. A coefficient above 2
        // is therefore suspicious.
        let much = |i: &usize| mu(*i) > 2.0 && mu(*i).is_finite();
        let contacts: Vec<_> = chosen(entries.len(), &much);
        if let Some(first) = contacts.first() {
            let (friction, names) = (mu(*first), names(&contacts));
            warnings.push(Warning::MuchFriction { contacts, names, friction });
        }
        // Force closure is not computed for a grasp with joints or with contacts that are pressed with a constant force; such a grasp gets no
        // warning.
        let open = || matches!(grasp.statics().force_closure(), Ok(closure) if !matches!(closure, Closure::Closed { .. }));
        if self.has_no_friction(&entries) && open() {
            warnings.push(Warning::NoFriction);
        }
        let size = spread(&mapped(&entries, &|entry| entry.contact.point));
        // Gripped objects are hardly larger than ten metres.
        if size > 10.0 {
            warnings.push(Warning::ManyMetres {
                what: "the contacts are apart by up to".to_owned(),
                length: size,
                beside: None,
            });
        }
        let stiffness = |i: usize| largest(entries[i].contact.series_stiffness_of_axes().as_slice(), &|k| *k);
        let softest = (0..entries.len()).map(stiffness).least();
        let force = |i: usize| entries[i].contact.press.or(entries[i].contact.force).unwrap_or(0.0);
        // Contacts of steel have 1e8 to 1e9 N/m; 1e11 N/m is implausible. So is a contact ten million times as stiff as the softest one, because the
        // softest contact then carries no noticeable share of the load.
        let is_stiff = |i: &usize| stiffness(*i).is_finite() && stiffness(*i) >= 1e11_f64.min(1e7 * softest);
        // The largest hydraulic presses exert less than 1e9 N.
        let is_strong = |i: &usize| force(*i) >= 1e9;
        for (is_stiffness, those) in
            [(true, chosen(entries.len(), &is_stiff)), (false, chosen(entries.len(), &is_strong))]
        {
            if let Some(first) = those.first() {
                let value = if is_stiffness { stiffness(*first) } else { force(*first) };
                warnings.push(Warning::OutOfProportion {
                    names: names(&those),
                    contacts: those,
                    is_stiffness,
                    value,
                });
            }
        }
        let vacuum = |i: usize| {
            let points = &grasp.contacts()[grasp.engine.wholes()[i].range.clone()];
            pressure_of_cup(points).unwrap_or(0.0)
        };
        // The atmospheric pressure may be given rounded; a deviation of one part in a thousand is allowed.
        let contacts: Vec<_> = chosen(entries.len(), &|i| vacuum(*i) > 1.001 * ATMOSPHERE);
        if let Some(first) = contacts.first() {
            let (names, pressure) = (names(&contacts), vacuum(*first));
            warnings.push(Warning::BeyondVacuum { contacts, names, pressure });
        }
        warnings.extend(self.outwards(&entries));
        let mut is_wide = false;
        for (i, (entry, contact)) in entries.iter().zip(grasp.engine.wholes().iter()).enumerate() {
            let points: Vec<_> = mapped(&grasp.contacts()[contact.range.clone()], &|c| c.point);
            let wide = spread(&points);
            // A patch is the area over which the points of a soft fingertip or pad are spread. It may be wider than the distance of the contacts, as
            // on stacked pallets or sheets. A patch is suspicious if it is wider than 2 m and wider than ten times the distance of the contacts. An
            // example is a pad of a few mm whose width was read in m. A patch that is the only contact is hardly wider than ten metres.
            let most = if size > 0.0 { f64::max(2.0, 10.0 * size) } else { 10.0 };
            if wide > most && !is_wide {
                is_wide = true;
                let what = format!("the patch of {} is as wide as", name(i));
                let beside = Some(size).filter(|size| *size > 0.0);
                warnings.push(Warning::ManyMetres { what, length: wide, beside });
            }
            let is_there = |j: &usize| is_in_place_of(entries[*j], entry, size);
            if let Some(twice) = (0..i).find(is_there) {
                let contacts = vec![twice, i];
                let opposite = entries[twice].contact.normal.dot(&entry.contact.normal) < 0.0;
                warnings.push(Warning::OnePlace { names: names(&contacts), contacts, opposite });
            }
        }
        for (contact, entry) in self.entries().enumerate() {
            let (point, normal) = (entry.contact.point(), entry.contact.normal);
            // In space an outline does not bound the object, and is only drawn.
            if self.space == Space::Planar && points_out(self.outline_around(entry), &point, &normal) {
                warnings.push(Warning::PointsOut { contact, name: entry.contact.label_text(contact) });
            }
        }
        warnings
    }

    /// The outline of the body that a contact's normal points into.
    fn outline_around(&self, entry: &Fingertip<3>) -> &[SVector<f64, 3>] {
        let Some(on) = &entry.contact.on else { return &self.outline };
        self.bodies.iter().find(|body| body.name == *on).map_or(&[], |body| &body.outline)
    }

    /// Warnings about loads that act far outside of the grasp (see [`far_load`]). Also about loads that exceed a hundred times the load that friction
    /// under the pressing forces can carry.
    pub(super) fn odd_loads(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        let (mut pressed, mut carried) = (0.0, 0.0);
        for entry in self.entries() {
            let force = entry.contact.press.or(entry.contact.force).unwrap_or(0.0);
            // Even with little friction, the normal forces of other contacts may carry the load. The estimate of the carried load therefore assumes a
            // friction coefficient of at least 0.3.
            (pressed, carried) =
                (pressed + force, carried + force * entry.contact.friction_coefficient().max(0.3));
        }
        let force = |load: &Wrench<3>| load.force_part();
        let mut heaviest = 0.0_f64;
        for question in &self.questions {
            // The load of a question `onset` is its field `direction` times the load factor; the magnitude of this vector therefore has no meaning.
            if !matches!(question, Question::Onset { .. }) {
                heaviest = heaviest.max(largest(&applied_loads(question), &|load| force(load).norm()));
            }
        }
        // Grippers are designed for loads that friction can carry; a hundred times the load that friction can carry is probably a mistake.
        if carried > 0.0 && heaviest > 100.0 * carried {
            warnings.push(Warning::HeavyLoad { force: heaviest, pressed });
        }
        let angle = largest(&self.questions, &turned);
        // A load that turns comes back to its beginning after one turn. An angle of more than two turns was therefore probably given in degrees.
        if angle > 2.0 * TAU {
            warnings.push(Warning::ManyTurns { angle });
        }
        let (centre, size) = self.middle();
        if size == 0.0 || !self.bodies.is_empty() {
            return warnings;
        }
        let arm = |load: &Wrench<3>| {
            let force = force(load);
            let about = *load - Wrench::force_through(&centre, &force);
            let moment = about.components()[3..].iter().fold(0.0, |h: f64, m| h.hypot(*m));
            // A pure moment acts at no point; its moment arm counts as zero.
            if force.norm() > 0.0 { moment / force.norm() } else { 0.0 }
        };
        let mut far = 0.0_f64;
        for question in &self.questions {
            far = far.max(largest(&applied_loads(question), &arm));
        }
        warnings.extend(far_load(far, size));
        warnings
    }

    /// The mean of the contact points, m, and the size of the grasp: the largest distance of a contact from the first contact, m.
    pub(super) fn middle(&self) -> (SVector<f64, 3>, f64) {
        let points: Vec<_> = self.entries().map(|entry| entry.contact.point).list();
        let count = points.len() as f64;
        let centre = points.iter().fold(SVector::<f64, 3>::zeros(), |sum, point| sum + point / count);
        (centre, spread(&points))
    }

    /// A warning if several contacts all press away from their common centre, so that their normals may have the wrong sign. A scene with an outline
    /// or with bodies gets no warning: there the contacts may be fingers that press outwards in a hole.
    fn outwards(&self, entries: &[&Fingertip<3>]) -> Option<Warning> {
        let count = entries.len() as f64;
        let centre =
            entries.iter().fold(SVector::<f64, 3>::zeros(), |sum, entry| sum + entry.contact.point / count);
        let is_so = |entry: &&Fingertip<3>| {
            let (way, normal) = (entry.contact.point - centre, entry.contact.normal);
            // A normal points outwards if it makes less than 60° with the direction from the centre to the contact.
            entry.contact.press.is_some() && way.dot(&normal) > 0.5 * way.norm() * normal.norm()
        };
        let shown = self.outline.len() > 2 || !self.bodies.is_empty();
        if shown || entries.len() < 2 || !entries.iter().all(is_so) {
            return None;
        }
        let contacts: Vec<_> = (0..entries.len()).list();
        let names = mapped(&contacts, &|i| entries[*i].contact.label_text(*i));
        Some(Warning::Outwards { contacts, names })
    }

    /// Whether all contacts are unilateral, without friction and without suction, and nothing else holds the object.
    fn has_no_friction(&self, entries: &[&Fingertip<3>]) -> bool {
        let is_bare = |entry: &&Fingertip<3>| {
            let contact = &entry.contact;
            let presses_alone =
                contact.hold == Hold::Unilateral && contact.suction == 0.0 && entry.cup.is_none();
            presses_alone && contact.friction_coefficient() == 0.0
        };
        self.links.is_empty() && self.bodies.is_empty() && entries.iter().all(is_bare)
    }

    /// A warning if each pair of normals encloses less than 90°, which means that no contact can press against another. `None` for a single contact,
    /// and with links or bodies.
    pub(super) fn same_side(&self) -> Option<Warning> {
        let entries: Vec<_> = self.entries().list();
        if entries.len() < 2 || !self.links.is_empty() || !self.bodies.is_empty() {
            return None;
        }
        let along = |i: usize, j: usize| entries[i].contact.normal.dot(&entries[j].contact.normal) > 0.0;
        let is_so = every_index(entries.len(), &|i| every_index(i, &|j| along(i, j)));
        let contacts: Vec<_> = (0..entries.len()).list();
        let names = mapped(&contacts, &|i| entries[*i].contact.label_text(*i));
        is_so.then_some(Warning::SameSide { contacts, names })
    }
}

/// A warning about a load that acts at `distance`, m, from a grasp of the size `size`, m. `None` unless the distance exceeds both 1 m and a hundred
/// times the size.
pub(super) fn far_load(distance: f64, size: f64) -> Option<Warning> {
    let what = "a load acts at a distance of".to_owned();
    let is_far = size > 0.0 && distance > 1.0 && distance > 100.0 * size;
    is_far.then_some(Warning::ManyMetres { what, length: distance, beside: Some(size) })
}

/// The loads that a question applies in addition to its base load; turning loads are not among them.
pub(super) fn applied_loads(question: &Question<3>) -> Vec<Wrench<3>> {
    match question {
        Question::Hold { load, .. } | Question::Solve { load, .. } | Question::Compare { load, .. } => {
            vec![*load]
        }
        Question::Need(asked) => asked.wrenches().copied().list(),
        Question::Improve(asked) => asked.load.iter().chain(&asked.loads).copied().list(),
        Question::Onset { direction, .. } => vec![*direction],
        Question::OnsetOfTurn(_) => Vec::new(),
        Question::Follow { legs, .. } => picked(legs, &Leg::straight_load),
        Question::Shake { loads, .. } | Question::Shakedown { loads, .. } => loads.clone(),
        Question::Identify(asked) => picked(&asked.slips, &|slip| slip.load),
    }
}

/// The angle by which the load of a question turns, rad; 0 if it does not turn.
fn turned(question: &Question<3>) -> f64 {
    match question {
        Question::OnsetOfTurn(turn) => turn.angle(),
        Question::Need(asked) => asked.turn.as_ref().map_or(0.0, Turn::angle),
        Question::Follow { legs, .. } => largest(legs, &Leg::turned_by),
        Question::Identify(asked) => {
            largest(&asked.slips, &|slip| slip.turn.as_ref().map_or(0.0, Turn::angle))
        }
        _ => 0.0,
    }
}

/// The largest distance from the first point, m. No two points have more than twice this distance from each other.
fn spread(points: &[SVector<f64, 3>]) -> f64 {
    largest(points, &|point| (point - points[0]).norm())
}

/// Whether two contacts between the same bodies coincide, up to a negligible fraction of the `size` of the grasp, m, and have parallel normals.
fn is_in_place_of(one: &Fingertip<3>, other: &Fingertip<3>, size: f64) -> bool {
    let (a, b) = (&one.contact, &other.contact);
    let parallel = a.normal.dot(&b.normal).abs() >= (1.0 - NEGLIGIBLE) * a.normal.norm() * b.normal.norm();
    let near = (a.point - b.point).norm() <= NEGLIGIBLE * size;
    (&a.on, &a.against) == (&b.on, &b.against) && near && parallel
}

/// Whether a step from `point` along `normal` leads out of a closed outline in the plane, and a step against it leads in.
fn points_out(outline: &[SVector<f64, 3>], point: &SVector<f64, 3>, normal: &SVector<f64, 3>) -> bool {
    if outline.len() < 3 {
        return false;
    }
    let size = largest(outline, &|corner| (corner - outline[0]).norm());
    // A step of a thousandth of the outline's size.
    let step = normal.normalize() * (1e-3 * size);
    is_inside(outline, &(point - step)) && !is_inside(outline, &(point + step))
}

/// Whether a point lies inside a closed line in the plane. This is so if a ray from the point along x crosses the line an odd number of times.
fn is_inside(outline: &[SVector<f64, 3>], point: &SVector<f64, 3>) -> bool {
    let crossed = chosen(outline.len(), &|k| {
        let (a, b) = (&outline[*k], &outline[(k + 1) % outline.len()]);
        let part = (point[1] - a[1]) / (b[1] - a[1]);
        (a[1] > point[1]) != (b[1] > point[1]) && point[0] < a[0] + part * (b[0] - a[0])
    });
    crossed.len() % 2 == 1
}
