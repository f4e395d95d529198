//! The loads that contacts from a collision library hold.
//!
//! `cargo run --release -p collision-contacts`
//!
//! parry finds points, normals and depths between fingertips and a mug, from which a grasp is made. The depth of a tip in the mug is
//! the command of its finger, counted from the first touch; a distance is a clearance. grasp-lcp accepts the vectors of glam that
//! parry uses. To check the answer, the mug is moved as predicted, and parry measures the depths of the tips again. They must equal
//! the deflections of the springs.

mod hand;
mod picture;

use glamx::{DPose3, DVec3};
use grasp_lcp::Error;
use grasp_lcp::spatial::{Contact, ContactState, Departure, Equilibrium, Grasp, Ramp, Wrench};
use hand::{Fingertip, fingertips, mug};
use parry3d_f64::query;
use parry3d_f64::shape::{Compound, Shape};

/// Normal stiffness of a finger with its pad, N/m.
const NORMAL: f64 = 2500.0;
/// Tangential stiffness of a finger with its pad, N/m.
const TANGENTIAL: f64 = 1500.0;
/// Friction coefficient between pad and glaze.
const FRICTION: f64 = 0.6;
/// Weight of the mug with coffee: kg times m/s².
const WEIGHT: f64 = 0.45 * 9.81;
/// Largest distance, m, at which a tip becomes a contact.
const REACH: f64 = 5e-4;

type Failure = Box<dyn std::error::Error>;

/// The contact of one tip according to the collision library: the point on the mug, the normal into the mug, and the depth, m (negative for a
/// distance). `None` beyond [`REACH`].
fn touch(
    tip: &Fingertip,
    hand: &DPose3,
    mug: &Compound,
    at: &DPose3,
) -> Result<Option<(DVec3, DVec3, f64)>, Failure> {
    let found = query::contact(&(hand * tip.pose), &*tip.shape, at, mug, REACH)
        .map_err(|_| "no contacts between such shapes")?;
    Ok(found.map(|contact| (contact.point2, contact.normal1, -contact.dist)))
}

/// The contacts of a hand in this pose, with the names of their fingers.
fn contacts(hand: &DPose3, mug: &Compound) -> Result<Vec<Contact>, Failure> {
    let mut contacts = Vec::new();
    for tip in fingertips() {
        if let Some((point, normal, depth)) = touch(&tip, hand, mug, &DPose3::identity())? {
            let contact = Contact::new(point, normal)
                .name(tip.name)
                .series_stiffness(NORMAL, TANGENTIAL)
                .friction(FRICTION)
                .command([depth.max(0.0), 0.0, 0.0])
                .clearance((-depth).max(0.0));
            contacts.push(contact);
        }
    }
    Ok(contacts)
}

/// A force of 1 N in this direction at the centre of mass.
fn pull(direction: DVec3, centre: DVec3) -> Wrench {
    Wrench::force_at(direction, centre)
}

fn main() -> Result<(), Failure> {
    let mug = mug();
    let centre = mug.mass_properties(1.0).local_com;
    let here = DPose3::identity();
    let contacts = contacts(&here, &mug)?;

    println!("What parry finds (mm)");
    for contact in &contacts {
        let (p, a) = (DVec3::from_array(contact.point().into()), contact.commanded()[0]);
        let name = contact.label_text(0);
        println!(
            "  {name:8} at ({:6.2}, {:6.2}, {:6.2}), {:.2} deep",
            1e3 * p.x,
            1e3 * p.y,
            1e3 * p.z,
            1e3 * a
        );
    }
    let grasp = Grasp::new(contacts)?;

    let outcome = grasp.solve(pull(-DVec3::Z, centre) * WEIGHT)?;
    let held = outcome.equilibrium().ok_or("the mug is not held")?;
    report(&grasp, held, &mug)?;
    directions(&grasp, centre)?;
    moved_hands(&mug, centre)?;
    let onset = grasp.onset(pull(-DVec3::Z, centre))?;
    let slides = onset.event().and_then(|event| {
        Some((format!("first slides, at {:.3} N", event.factor), grasp.state_at_onset(event)?))
    });
    let mut answers = vec![("held upright", held)];
    answers.extend(slides.as_ref().map(|(label, state)| (label.as_str(), state)));
    picture::save(&grasp, &answers, &mug)
}

/// Prints contact forces, and compares the deflections of the springs with depths that parry finds at the predicted pose of the mug.
fn report(grasp: &Grasp, held: &Equilibrium, mug: &Compound) -> Result<(), Failure> {
    let motion = DPose3::from(held.twist.exp());
    let (moved, (_, angle)) = (motion.translation * 1e3, motion.rotation.to_axis_angle());
    println!(
        "\nHeld upright: the mug moves by ({:.3}, {:.3}, {:.3}) mm and turns by {:.3} degrees",
        moved.x,
        moved.y,
        moved.z,
        angle.to_degrees()
    );
    println!("  finger     force (N)                friction used   depth F/k (mm)   found by parry");
    let (here, tips) = (DPose3::identity(), fingertips());
    for (contact, answer) in grasp.contacts().iter().zip(&held.contacts) {
        let name = contact.label_text(0);
        let tip = tips.iter().find(|tip| tip.name == name).ok_or("a finger of the hand")?;
        let force = DVec3::from_array(answer.force_world.into());
        let predicted = answer.normal_force() / NORMAL - answer.gap;
        let depth = touch(tip, &here, mug, &motion)?.map(|(_, _, depth)| 1e3 * depth);
        let found = depth.map_or_else(|| "out of reach".into(), |depth| format!("{depth:.4}"));
        println!(
            "  {name:8} ({:6.3}, {:6.3}, {:6.3})      {:.3} of {FRICTION}     {:9.4}       {found:>9}",
            force.x,
            force.y,
            force.z,
            answer.friction_used(),
            1e3 * predicted
        );
    }
    Ok(())
}

/// Prints the force at first slip and the limit load of pulls in several directions.
fn directions(grasp: &Grasp, centre: DVec3) -> Result<(), Error> {
    println!("\nPulled at its centre of mass  stops sticking at (N)  holds up to (N)");
    let ways = [
        ("down", -DVec3::Z),
        ("up", DVec3::Z),
        ("towards the handle", DVec3::X),
        ("towards the thumb", -DVec3::X),
        ("sideways", DVec3::Y),
    ];
    for (way, direction) in ways {
        let ramp = Ramp::load(Wrench::ZERO, pull(direction, centre));
        let onset = grasp.onset(&ramp)?;
        let separated = |event, i: usize| {
            let state = grasp.state_at_onset(event);
            state.is_some_and(|state| state.contacts[i].state == ContactState::Separated)
        };
        let first = onset.event().map_or_else(String::new, |event| {
            let first = &event.leaving[0];
            let how = match first.how {
                // A tip that was separated before the event comes into contact and slides at once.
                Departure::Slides { .. } if separated(event, first.contact.index) => "touches",
                how => how.verb(),
            };
            format!("{:7.3}  {} {how}", event.factor, first.contact.text())
        });
        let lost = grasp.hold(ramp)?.lost;
        let limit = lost.map_or_else(|| "more than 100".into(), |lost| format!("{:7.3}", lost.factor));
        println!("  {way:26}  {first:22} {limit}");
    }
    Ok(())
}

/// Prints the first slip for other poses of the hand. parry finds new contacts for each, because the hand touches other places of the mug.
fn moved_hands(mug: &Compound, centre: DVec3) -> Result<(), Failure> {
    println!("\nThe hand elsewhere            tips within reach   first slides under the weight");
    let hands = [
        ("as above", DPose3::identity()),
        ("25 mm higher", DPose3::translation(0.0, 0.0, 0.025)),
        ("39 mm higher, past the rim", DPose3::translation(0.0, 0.0, 0.039)),
        ("turned by 30° to the handle", DPose3::rotation(DVec3::Z * 30.0_f64.to_radians())),
        ("turned by 50° to the handle", DPose3::rotation(DVec3::Z * 50.0_f64.to_radians())),
        ("0.5 mm towards the handle", DPose3::translation(5e-4, 0.0, 0.0)),
    ];
    for (place, hand) in hands {
        let contacts = contacts(&hand, mug)?;
        let tips = contacts.len();
        let reserve = match Grasp::new(contacts) {
            Ok(grasp) => match grasp.onset(pull(-DVec3::Z, centre) * WEIGHT)?.factor() {
                Some(factor) => format!("at {factor:.3} times"),
                None => "slides by the squeeze alone".into(),
            },
            Err(Error::EmptyGrasp) => "nothing is touched".into(),
            Err(error) => return Err(error.into()),
        };
        println!("  {place:30} {tips}              {reserve}");
    }
    Ok(())
}
