//! Derivatives with respect to joint data agree with small changes of the data.

use grasp_lcp::Limit;
use grasp_lcp::load_path::{DepartingPart, Parameter};
use grasp_lcp::planar::Contact;
use grasp_lcp::planar::hand::{DriveState, Finger, Hand, HandPart, Joint, Tendon};
use grasp_lcp::planar::{Grasp, Ramp, Wrench};

/// Data of two joints and a tendon: command, stiffness and limit of each.
type Data = [[f64; 3]; 3];

const DATA: Data = [[0.10, 0.16, 0.09], [90.0, 70.0, 9e2], [3.0, 40.0, 80.0]];

fn grasp(data: &Data, limit: fn(f64) -> Limit) -> Grasp {
    let [commands, stiffness, limits] = data;
    let joint = |k: usize, point: [f64; 2]| {
        Joint::revolute(point).stiffness(stiffness[k]).command(commands[k]).limit(limit(limits[k]))
    };
    let pad = |x: f64| Contact::new([x, 0.1 * x], [-x, 0.1]).series_stiffness(4e3, 3e3).friction(0.6);
    // A positive rotation presses the right finger inwards.
    let right = Finger::new([joint(0, [1.3, -1.0]), joint(1, [1.1, -0.4])]).contact(pad(1.0));
    let left = Finger::fixed(pad(-1.0).command([0.01, 0.0]));
    let tendon =
        Tendon::new([0.3, 0.2]).stiffness(stiffness[2]).pull(commands[2]).limit(Limit::Saturates(limits[2]));
    Hand::new([right, left]).tendon(tendon).grasp().expect("well posed")
}

/// Forces and joint displacements.
fn answer(grasp: &Grasp, load: &Wrench) -> Vec<f64> {
    let outcome = grasp.solve(load).expect("a load");
    let held = outcome.equilibrium().expect("holds");
    let forces = held.contacts.iter().flat_map(|c| [c.force[0], c.force[1]]);
    forces.chain(held.joints.iter().map(|j| j.displacement)).collect()
}

#[test]
fn derivatives_are_those_of_small_changes() {
    let load = Wrench::new([0.5, -1.0], 0.1);
    for limit in [Limit::Saturates as fn(f64) -> Limit, Limit::Slips] {
        let base = grasp(&DATA, limit);
        let outcome = base.solve(load).expect("a load");
        let held = outcome.equilibrium().expect("holds");
        // The drive of the first joint yields. The second joint and the tendon hold.
        let states: Vec<_> = held.joints.iter().map(|j| j.state).collect();
        assert_eq!(states, [DriveState::Yields, DriveState::Holds]);
        assert_eq!(held.tendons[0].state, DriveState::Holds);
        for (kind, row) in DATA.iter().enumerate() {
            for (joint, value) in row.iter().enumerate() {
                let step = 1e-6 * value;
                let moved = |sign: f64| {
                    let mut data = DATA;
                    data[kind][joint] += sign * step;
                    answer(&grasp(&data, limit), &load)
                };
                let (there, back) = (moved(1.0), moved(-1.0));
                let by = match kind {
                    0 => Parameter::JointCommand { joint },
                    1 => Parameter::JointStiffness { joint },
                    _ => Parameter::JointLimit { joint },
                };
                let derivative = base.sensitivity().of(held, by).expect("regular");
                let forces = derivative.forces.iter().flat_map(|f| [f[0], f[1]]);
                let told: Vec<f64> = forces.chain(derivative.joints[..2].iter().copied()).collect();
                for (k, told) in told.iter().enumerate() {
                    let measured = (there[k] - back[k]) / (2.0 * step);
                    let size = (there[k].abs() + back[k].abs()) / value;
                    assert!((told - measured).abs() < 1e-7 * size + 1e-12, "{by:?} {k}: {told} {measured}");
                }
            }
        }
    }
}

#[test]
fn onset_gradients_are_those_of_small_changes_too() {
    let mut data = DATA;
    // Without a yielding joint at rest, the joint is the first event of the ramp.
    data[2][0] = 14.3;
    let ramp = Ramp::load(Wrench::ZERO, Wrench::force([1.0, 0.0]));
    let onset = |data: &Data| grasp(data, Limit::Slips).onset(&ramp).expect("a ramp");
    let event = onset(&data);
    let event = event.event().expect("leaves");
    let hand = grasp(&data, Limit::Slips);
    let margins = hand.sensitivity().onset(event).expect("sticks before");
    assert_eq!(margins.leavers()[0], DepartingPart::Drive(HandPart::Joint(0)));
    for kind in 0..3 {
        for joint in 0..3 {
            let step = 1e-6 * data[kind][joint];
            let moved = |sign: f64| {
                let mut data = data;
                data[kind][joint] += sign * step;
                onset(&data).factor().expect("leaves")
            };
            let measured = (moved(1.0) - moved(-1.0)) / (2.0 * step);
            let by = [
                Parameter::JointCommand { joint },
                Parameter::JointStiffness { joint },
                Parameter::JointLimit { joint },
            ];
            let told = margins.by(by[kind]).expect("a datum")[0];
            let size = event.factor / data[kind][joint];
            assert!((told - measured).abs() < 1e-7 * size, "{kind} {told} {measured}");
        }
    }
}

/// The hand with the frame of one contact rotated. Its joints move the contact point as before.
fn tilted(phi: f64) -> Grasp {
    let (sin, cos) = phi.sin_cos();
    let jaw = |x: f64, normal: [f64; 2]| {
        let pad = Contact::new([x, 0.1 * x], normal).series_stiffness(4e3, 3e3).friction(0.6);
        let joint = Joint::revolute([1.3 * x, -1.0]).stiffness(90.0).command(0.1 * x);
        Finger::new([joint]).contact(pad.command([0.01, 0.002]))
    };
    // t = (n_y, -n_x) of the right finger is (0, 1).
    Hand::new([jaw(1.0, [-cos, sin]), jaw(-1.0, [1.0, 0.0])]).grasp().expect("well posed")
}

#[test]
fn normals_of_a_hand_tilt_with_their_frames() {
    let load = Wrench::new([0.2, -0.5], 0.05);
    let answer = |phi: f64| {
        let outcome = tilted(phi).solve(load).expect("a load");
        let held = outcome.equilibrium().expect("holds");
        let forces: Vec<f64> = held.contacts.iter().flat_map(|c| [c.force[0], c.force[1]]).collect();
        [forces, held.joints.iter().map(|j| j.displacement).collect()].concat()
    };
    let base = tilted(0.0);
    let outcome = base.solve(load).expect("a load");
    let held = outcome.equilibrium().expect("holds");
    let derivative =
        base.sensitivity().of(held, Parameter::Normal { contact: 0, axis: 1 }).expect("a regular piece");
    let forces = derivative.forces.iter().flat_map(|f| [f[0], f[1]]);
    let told: Vec<f64> = forces.chain(derivative.joints[..2].iter().copied()).collect();
    let (there, back) = (answer(1e-6), answer(-1e-6));
    for (k, told) in told.iter().enumerate() {
        let measured = (there[k] - back[k]) / 2e-6;
        assert!((told - measured).abs() < 1e-6 * (1.0 + measured.abs()), "{k}: {told} {measured}");
    }
    assert!(base.sensitivity().of(held, Parameter::Point { contact: 0, axis: 0 }).is_none());
}

/// Derivatives and samples agree for uncertain joint springs. Uncertain positions are refused.
#[test]
fn onsets_of_a_hand_spread_with_its_springs() {
    use grasp_lcp::Error;
    use grasp_lcp::sweep::Uncertainty;
    let grasp = tilted(0.1);
    let ramp = Ramp::load(Wrench::ZERO, Wrench::force([0.3, -1.0]));
    let off = Uncertainty::seeded(4).with_stiffness(0.01).with_normal(0.005);
    let onset = grasp.onset(&ramp).expect("a ramp");
    let margins = grasp.sensitivity().onset(onset.event().expect("leaves")).expect("sticks before");
    let by = |parameter| margins.by(parameter).expect("a datum")[0];
    let squares = [0, 1].map(|contact| {
        let stiffness = [4e3, 3e3].into_iter().enumerate();
        let softer: f64 = stiffness.map(|(axis, k)| k * by(Parameter::Stiffness { contact, axis })).sum();
        let joint = 90.0 * by(Parameter::JointStiffness { joint: contact });
        let tilted = by(Parameter::Normal { contact, axis: 1 });
        (0.01 * softer).powi(2) + (0.01 * joint).powi(2) + (0.005 * tilted).powi(2)
    });
    let known = squares.iter().sum::<f64>().sqrt();
    let count = 4000;
    let factors: Vec<f64> = grasp
        .onset_of_samples(&ramp, &off, count)
        .into_iter()
        .map(|onset| onset.expect("a sample").factor().expect("leaves"))
        .collect();
    let mean = factors.iter().sum::<f64>() / count as f64;
    let deviation = (factors.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / count as f64).sqrt();
    assert!((deviation / known - 1.0).abs() < 0.05, "{deviation} {known}");
    let off = off.with_position(1e-3);
    let refused = grasp.sample(&off, 0).unwrap_err();
    assert_eq!(refused, Error::NotForHands { question: "sample with uncertain positions" });
}
