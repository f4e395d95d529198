//! A state on a path reports the same free motions as the solved equilibrium at its load, if both are the same equilibrium. Two point contacts in
//! space leave a rotation about their line free.

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::Leg;
use grasp_lcp::{planar, spatial};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

fn direction<const C: usize>(random: &mut Random) -> [f64; C] {
    let v: [f64; C] = std::array::from_fn(|_| random.normal());
    let size = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / size)
}

/// Two opposed fingers, and further fingers that touch, press slightly, or are open.
fn fingers<const C: usize>(random: &mut Random) -> Vec<Contact<C>> {
    let out = direction::<C>(random);
    let mut contacts = Vec::new();
    for i in 0..random.index(2, 4) {
        let out = match i {
            0 => out,
            1 => out.map(|x| -x),
            _ => direction(random),
        };
        let press = if i < 2 { 10.0 } else { [0.0, 1.0][random.index(0, 1)] };
        let stiffness = [500.0, 1000.0, 2000.0][random.index(0, 2)];
        let contact = Contact::new(out, out.map(|x| -x))
            .series_stiffness(stiffness, stiffness)
            .friction([0.0, 0.3, 0.5][if i < 2 { 2 } else { random.index(0, 2) }])
            .command(std::array::from_fn(|axis| if axis == 0 { press / stiffness } else { 0.0 }));
        contacts.push(contact);
    }
    contacts
}

fn is_one<const C: usize>(a: &Equilibrium<C>, b: &Equilibrium<C>) -> bool {
    let largest = a.largest_force();
    a.contacts.iter().zip(&b.contacts).all(|(a, b)| (a.force - b.force).norm() <= 1e-7 * largest)
}

/// Compares states on a path to a load with solved equilibria at the same loads. Counts states equal to a solution, and how many of these states have
/// a free motion.
fn compared<const C: usize>(contacts: Vec<Contact<C>>, load: Wrench<C>, counts: &mut [usize; 2]) {
    let grasp = Grasp::new(contacts).unwrap();
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_by(load)]).unwrap();
    path.run();
    let (_, end) = path.place();
    for fraction in (0..=8).map(|k| f64::from(k) / 8.0 * end) {
        let Some(state) = path.state_at(0, fraction) else { continue };
        let outcome = grasp.solve(load * fraction).unwrap();
        let Some(solved) = outcome.equilibrium().filter(|solved| is_one(solved, &state)) else { continue };
        counts[0] += 1;
        counts[1] += usize::from(!solved.free_motions.is_empty());
        let both = [&state, solved].map(|told| told.free_motions.len());
        assert_eq!(both[0], both[1], "{fraction}\n{state}\n{solved}\n{:?}", grasp.contacts());
    }
}

#[test]
fn free_motions_in_space_are_told_as_by_a_solution() {
    let mut counts = [0; 2];
    let mut random = seeded(5);
    for _ in 0..samples(150) {
        let contacts = fingers::<3>(&mut random);
        let load = spatial::Wrench::force(direction::<3>(&mut random).map(|x| 8.0 * x));
        compared(contacts, load, &mut counts);
    }
    println!("{counts:?}");
    assert_met(&[(counts[1], 150)]);
}

#[test]
fn free_motions_in_the_plane_are_told_as_by_a_solution() {
    let mut counts = [0; 2];
    let mut random = seeded(6);
    for _ in 0..samples(300) {
        let contacts = fingers::<2>(&mut random);
        let load = planar::Wrench::force(direction::<2>(&mut random).map(|x| 8.0 * x));
        compared(contacts, load, &mut counts);
    }
    println!("{counts:?}");
    assert_met(&[(counts[0], 300)]);
}
