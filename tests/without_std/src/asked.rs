//! Questions about each grasp: first slip, equilibrium, verdict on the load, and a watch over forces.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use grasp_lcp::Error;
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::screening::Fingers;

use crate::scenes::Numbers;

/// Answers about one grasp.
#[derive(Debug)]
pub struct Asked {
    /// Of the first slip: the load factor. Of the equilibrium: slips (m) and forces (N). Of the watch over forces: margin (N), load factor of the
    /// first slip, and extra squeeze.
    pub numbers: Vec<f64>,
    /// The verdict on the load, as a sentence.
    pub sentence: String,
}

/// Answers about `grasps` grasps in the plane and as many in space.
///
/// # Errors
/// Never: all numbers are within the allowed ranges.
pub fn ask(grasps: usize) -> Result<Vec<Asked>, Error> {
    let mut numbers = Numbers(1);
    let mut all = Vec::new();
    for _ in 0..grasps {
        let (fingers, load) = numbers.planar();
        all.push(answers(fingers.clone(), &Fingers::<2, 3>::new(&fingers)?, load)?);
        let (fingers, load) = numbers.spatial();
        all.push(answers(fingers.clone(), &Fingers::<3, 3>::new(&fingers)?, load)?);
    }
    Ok(all)
}

fn answers<const C: usize>(
    contacts: [Contact<C>; 3],
    fingers: &Fingers<C, 3>,
    load: Wrench<C>,
) -> Result<Asked, Error> {
    let grasp = Grasp::new(contacts)?;
    let mut numbers = Vec::new();
    numbers.extend(grasp.onset(load)?.factor());
    if let Some(equilibrium) = grasp.solve(load)?.equilibrium() {
        let mut forces = [[0.0; C]; 3];
        for (force, contact) in forces.iter_mut().zip(&equilibrium.contacts) {
            *force = contact.force_world.into();
            numbers.extend(&contact.slip);
        }
        numbers.extend(forces.as_flattened());
        let watched = fingers.watch(&forces, &load)?;
        numbers.push(watched.margin());
        numbers.extend(watched.first_slip().factor());
        numbers.extend(watched.extra_squeeze().factor());
    }
    Ok(Asked { numbers, sentence: grasp.hold(load)?.to_string() })
}
