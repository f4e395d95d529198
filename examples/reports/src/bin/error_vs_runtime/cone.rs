//! The friction cone in space: polygons with ever more facets, and the round cone itself.
//!
//! The sliding state is constructed: the object is displaced by a twist, every contact has the force of Coulomb's law for this displacement, and the
//! load balances these forces. So the exact forces are known in advance.

use grasp_lcp::spatial::{ContactAnswer, ContactState, Equilibrium, Grasp, Outcome, Ramp, Twist, Wrench};
use grasp_lcp::{PolygonCone, PolygonFit, Settings};
use nalgebra::{Vector3, Vector6};

use crate::onset::pinch;
use crate::report::{Panel, Report};
use support::Failure;
use support::best_time::timed;
use support::loaded::three_fingers;

const FACETS: [usize; 7] = [4, 8, 16, 32, 64, 128, 256];
const FITS: [(&str, PolygonFit); 3] = [
    ("inscribed polygon", PolygonFit::Inscribed),
    ("circumscribed polygon", PolygonFit::Circumscribed),
    ("balanced polygon", PolygonFit::Balanced),
];
/// Displacement of the object, m and rad: two of the three fingers slide. With a displacement that is a ninth larger, the load has another
/// equilibrium, in which all fingers slide.
const TWIST: [f64; 6] = [0.00216, 0.00036, -0.00792, 0.243, -0.00315, 0.063];
/// Number of fingers that slide.
const SLIDE: usize = 2;

/// Settings for a polygon, without the enumeration of contact states, which would add to the time.
fn on(facets: usize, fit: PolygonFit) -> Result<Settings, Failure> {
    Ok(Settings::default().with_most_states(0).with_cone(PolygonCone::new(facets, fit)?))
}

pub fn measure(report: &mut Report) -> Result<(), Failure> {
    report.push(onset()?);
    report.push(sliding()?);
    Ok(())
}

fn onset() -> Result<Panel, Failure> {
    let (contacts, direction, exact) = pinch();
    let (grasp, ramp) = (Grasp::new(contacts)?, Ramp::load(Wrench::ZERO, direction));
    let mut panel = Panel::new(
        "cone",
        "Onset of three fingers: facets and the round cone",
        "relative error of the onset",
    );
    for (name, fit) in FITS {
        for facets in FACETS {
            let settings = on(facets, fit)?;
            let (factor, time) = timed(|| {
                Ok(grasp.with(&settings.on_the_polygon()).onset(&ramp)?.factor().ok_or("a sticking base")?)
            })?;
            panel.add(name, facets.to_string(), (factor / exact - 1.0).abs(), time);
        }
    }
    let settings = on(8, PolygonFit::Inscribed)?;
    let (factor, time) =
        timed(|| Ok(grasp.with(&settings).onset(&ramp)?.factor().ok_or("a sticking base")?))?;
    panel.add("round cone, and 8 facets beside it", "", (factor / exact - 1.0).abs(), time);
    Ok(panel)
}

fn sliding() -> Result<Panel, Failure> {
    let grasp = Grasp::new(three_fingers().contacts)?;
    let (load, forces) = balanced(&grasp, &Twist::from_vector(TWIST));
    let mut panel = Panel::new(
        "cone",
        "Three fingers far beyond it: facets and the round cone",
        "error of a contact force / largest force",
    );
    let off = |answer: &Equilibrium| {
        let size = forces.iter().map(Vector3::norm).fold(0.0, f64::max);
        let differences = answer.contacts.iter().zip(&forces).map(|(c, f)| (c.force_world - f).norm());
        differences.fold(0.0, f64::max) / size
    };
    for (name, fit) in FITS {
        for facets in FACETS {
            let settings = on(facets, fit)?.on_the_polygon();
            let (outcome, time) = timed(|| Ok(grasp.with(&settings).solve(load)?))?;
            let error = outcome.equilibrium().map_or(f64::NAN, off);
            if let Outcome::Undecided(why) = &outcome {
                panel.notes.push(format!("{name}, {facets} facets: {:?}", why.doubt));
            }
            panel.add(name, facets.to_string(), error, time);
        }
    }
    for facets in [8, 16, 32] {
        let settings = on(facets, PolygonFit::Inscribed)?;
        let (outcome, time) = timed(|| Ok(grasp.with(&settings).solve(load)?))?;
        let answer = outcome.equilibrium().ok_or("the scene was made to have one")?;
        if facets == 8 {
            let slide = |c: &&ContactAnswer| matches!(c.state, ContactState::Sliding { .. });
            let count = answer.contacts.iter().filter(slide).count();
            if count != SLIDE {
                return Err(format!("another equilibrium: {count} of 3 fingers slide").into());
            }
            panel.notes.push(format!("{count} of 3 fingers slide"));
        }
        panel.add("round cone, proposed on facets", facets.to_string(), off(answer), time);
    }
    Ok(panel)
}

/// The load that balances the contact forces after the object has moved by a twist, and these forces along the coordinate axes.
fn balanced(grasp: &Grasp, twist: &Twist) -> (Wrench, Vec<Vector3<f64>>) {
    let mut load = Vector6::zeros();
    let mut forces = Vec::new();
    for (contact, frame) in grasp.contacts().iter().zip(grasp.frames()) {
        let k = contact.series_stiffness_of_axes();
        let moved = Vector3::from(twist.displacement_at(contact.point()));
        let mut force = k.component_mul(&(contact.commanded() - frame.tr_mul(&moved)));
        if force[0] <= 0.0 {
            force = Vector3::zeros();
        }
        // Both tangential stiffnesses are equal, so that the friction force is reduced to its limit without a change of direction.
        let (limit, friction) = (contact.friction_coefficient() * force[0], force.yz().norm());
        if friction > limit {
            (force[1], force[2]) = (force[1] * (limit / friction), force[2] * (limit / friction));
        }
        let force = frame * force;
        let moment = contact.point().cross(&force);
        load -= Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
        forces.push(force);
    }
    (Wrench::from_vector(load), forces)
}
