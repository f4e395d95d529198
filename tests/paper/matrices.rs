//! The paper's matrices for its two-finger example are reproduced entry by entry. The last diagonal entry of H, misprinted in the paper, is
//! corrected, and the missing A is added.

use grasp_lcp::grasp::Hold;
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use grasp_lcp::{Error, PolygonCone, spatial};
use nalgebra::{DMatrix, DVector, SVector};
use support::printed_program::{Equality, Inequality, PrintedContact, PrintedProgram};

/// Stiffnesses k_nb, k_tb (body, normal and tangential) and k_nf, k_tf (finger). All differ, so that every matrix entry shows which one it contains.
const SPRINGS: [f64; 4] = [10.0, 8.0, 6.0, 4.0];
const MU: f64 = 0.25;
const COMMANDS: [[f64; 2]; 2] = [[0.1, -0.0125], [0.2, 0.025]];

fn grasp(springs: [f64; 4]) -> Grasp {
    let [nb, tb, nf, tf] = springs;
    Grasp::new([-1.0, 1.0].into_iter().zip(COMMANDS).map(|(side, command): (f64, _)| {
        Contact::new([4.0 * side, 1.8], [-8.0 * side, -1.0])
            .body_stiffness(nb, tb)
            .finger_stiffness(nf, tf)
            .friction(MU)
            .command(command)
    }))
    .unwrap()
}

/// The matrices of the paper's quadratic program for this grasp.
fn program(load: &Wrench) -> PrintedProgram<2> {
    let [nb, tb, nf, tf] = SPRINGS;
    let contact = PrintedContact::of(SVector::from([nb, tb]), SVector::from([nf, tf]));
    PrintedProgram::of(&grasp(SPRINGS), &[contact; 2], load, &PolygonCone::default())
}

fn rows<const N: usize>(list: &[[f64; N]]) -> DMatrix<f64> {
    DMatrix::from_fn(list.len(), N, |i, j| list[i][j])
}

fn put(into: &mut DMatrix<f64>, at: (usize, usize), block: &DMatrix<f64>) {
    into.view_mut(at, block.shape()).copy_from(block);
}

#[test]
fn two_fingers_as_printed() {
    let [nb, tb, nf, tf] = SPRINGS;
    let (alpha, beta, gamma) = (nf / nb, tf / tb, tb / nb);
    let load = Wrench::new([0.3, -0.7], 0.2);
    let qp = program(&load);
    let program = &qp.program;

    let [[q17, q18], [q27, q28]] = COMMANDS;
    let g = [
        [0.0, 0.0, 0.0, 0.0, -nf * q17, -tf * q18].as_slice(),
        &[0.0, 0.0, 0.0, 0.0, -nf * q27, -tf * q28],
        &[-0.3, 0.7, -0.2],
    ]
    .concat();
    assert_eq!(program.g, DVector::from_vec(g));

    let h1 = rows(&[
        [nb, 0.0, -nb, 0.0, 0.0, 0.0],
        [0.0, tb, 0.0, -tb, 0.0, 0.0],
        [-nb, 0.0, nb, 0.0, 0.0, 0.0],
        [0.0, -tb, 0.0, tb, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, nf, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, tf], // printed k_nf
    ]);
    let mut h = DMatrix::zeros(15, 15);
    put(&mut h, (0, 0), &h1);
    put(&mut h, (6, 6), &h1);
    assert_eq!(program.h, h);

    let b1 = rows(&[
        [-1.0, 0.0, 1.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0, -1.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, -1.0, 0.0],
        [-MU, gamma, MU, -gamma, 0.0, 0.0],
        [-MU, -gamma, MU, gamma, 0.0, 0.0],
    ]);
    let mut b = DMatrix::zeros(10, 15);
    put(&mut b, (0, 0), &b1);
    put(&mut b, (5, 6), &b1);
    assert_eq!(program.b, b);
    assert_eq!(program.d, DVector::from_vec(vec![0.0, 0.0, -q17, 0.0, 0.0, 0.0, 0.0, -q27, 0.0, 0.0]));

    // C as printed. A is not printed; the order of its rows follows from C.
    let c = vec![alpha * q17, beta * q18, 0.0, alpha * q27, beta * q28, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert_eq!(program.c, DVector::from_vec(c));
    let a1 = rows(&[
        [-1.0, 0.0, 1.0, 0.0, alpha, 0.0],
        [0.0, -1.0, 0.0, 1.0, 0.0, beta],
        [0.0, 0.0, 0.0, 1.0, 0.0, -1.0],
    ]);
    let mut a = DMatrix::zeros(10, 15);
    put(&mut a, (0, 0), &a1);
    put(&mut a, (3, 6), &a1);
    let root = 65f64.sqrt();
    for (i, side) in [-1.0, 1.0].into_iter().enumerate() {
        let (n, r) = ([-8.0 * side / root, -1.0 / root], [4.0 * side, 1.8]);
        let t = [n[1], -n[0]];
        for (axis, e) in [n, t].into_iter().enumerate() {
            let row = 6 + 2 * i + axis;
            a[(row, 6 * i + axis)] = 1.0;
            // The displacement u_c of the object at the contact: (dx - δz r_y, dy + δz r_x).
            a[(row, 12)] = -e[0];
            a[(row, 13)] = -e[1];
            a[(row, 14)] = e[0] * r[1] - e[1] * r[0];
        }
    }
    assert_eq!(program.a.shape(), a.shape());
    assert!((&program.a - &a).amax() < 1e-15, "{}", &program.a - &a);
    assert_eq!(program.a.view((0, 0), (6, 15)), a.view((0, 0), (6, 15)));

    let says = |k: usize| qp.equalities[k];
    assert_eq!(says(0), Equality::SpringContinuity { contact: 0, axis: 0 });
    assert_eq!(says(5), Equality::Sticking { contact: 1, axis: 1 });
    assert_eq!(says(9), Equality::BodyMotion { contact: 1, axis: 1 });
    assert_eq!(qp.inequalities[1], Inequality::NoPenetration { contact: 0 });
    assert_eq!(qp.inequalities[9], Inequality::Friction { contact: 1, facet: 1 });
}

/// The cost of unit stretches is the energy of the springs. This decides that the misprinted entry must be k_tf and not k_nf. The example of the
/// paper does not decide it, because all its stiffnesses are 10.
#[test]
fn the_cost_is_the_energy_of_the_springs() {
    let load = Wrench::new([0.3, -0.7], 0.2);
    let qp = program(&load);
    let x = DVector::from_fn(15, |i, _| ((i * i + 3) as f64 * 0.7).sin());
    let mut energy = -load.to_vector().dot(&SVector::from_column_slice(qp.twist(&x)));
    for (i, command) in COMMANDS.into_iter().enumerate() {
        let u = qp.displacements(&x, i);
        for a in 0..2 {
            let (body, finger) = (SPRINGS[a], SPRINGS[2 + a]);
            energy += 0.5 * body * (u.body_surface[a] - u.body_core[a]).powi(2);
            energy += 0.5 * finger * (command[a] - u.finger_surface[a]).powi(2);
        }
    }
    assert!((qp.program.value(&x) + qp.constant - energy).abs() < 1e-13);
}

/// The program exists for any number of contacts, in space with a polygonal cone. Contacts with fewer conditions have fewer rows.
#[test]
fn shapes_in_space_and_of_other_contacts() {
    let contact = |x: f64| {
        spatial::Contact::new([x, 0.3, 0.1], [-x, 0.0, 0.0])
            .body_stiffness(10.0, 8.0)
            .finger_stiffness(6.0, 4.0)
            .command([0.1, 0.0, 0.0])
            .clearance(0.01)
            .friction(0.5)
    };
    let contacts = [
        contact(1.0),
        contact(-1.0).friction(0.0),
        contact(2.0).friction(f64::INFINITY),
        contact(-2.0).kept_closed(),
        contact(3.0).bonded(),
    ];
    let grasp = spatial::Grasp::new(contacts).unwrap();
    let springs = PrintedContact::of(SVector::from([10.0, 8.0, 8.0]), SVector::from([6.0, 4.0, 4.0]));
    let holds = [Hold::Unilateral, Hold::Unilateral, Hold::Unilateral, Hold::KeptClosed, Hold::Bonded];
    let printed = holds.map(|hold| PrintedContact { clearance: 0.01, hold, ..springs });
    let qp = PrintedProgram::of(&grasp, &printed, &spatial::Wrench::ZERO, &PolygonCone::default());
    let program = &qp.program;
    assert_eq!(program.g.len(), 5 * 9 + 6);
    let count = |contact: usize, of: &dyn Fn(&Equality) -> Option<usize>| {
        qp.equalities.iter().filter(|e| of(e) == Some(contact)).count()
    };
    let sticking =
        |e: &Equality| if let Equality::Sticking { contact, .. } = e { Some(*contact) } else { None };
    let closed = |e: &Equality| if let Equality::Closed { contact } = e { Some(*contact) } else { None };
    assert_eq!((0..5).map(|i| count(i, &sticking)).collect::<Vec<_>>(), [2, 0, 2, 2, 2]);
    assert_eq!((0..5).map(|i| count(i, &closed)).collect::<Vec<_>>(), [0, 0, 0, 1, 1]);
    let inequalities = |contact: usize| {
        let of = |e: &&Inequality| match e {
            Inequality::BodyPushes { contact: c }
            | Inequality::NoPenetration { contact: c }
            | Inequality::FingerPushes { contact: c }
            | Inequality::Friction { contact: c, .. } => *c == contact,
        };
        qp.inequalities.iter().filter(of).count()
    };
    assert_eq!((0..5).map(inequalities).collect::<Vec<_>>(), [11, 3, 3, 8, 0]);
    // The clearance is the allowed approach of the surfaces.
    let gap = qp.inequalities.iter().position(|e| *e == Inequality::NoPenetration { contact: 0 }).unwrap();
    assert_eq!(program.d[gap], -0.01);
    // In the row of a facet, μ F_n - h·F_t is divided by k_nb, with the force of the body's springs.
    let facet =
        qp.inequalities.iter().position(|e| *e == Inequality::Friction { contact: 0, facet: 3 }).unwrap();
    let mut x = DVector::zeros(51);
    for a in 0..3 {
        x[3 + a] = [0.5, 0.2, -0.4][a];
    }
    let force = qp.force(&x, 0);
    assert_eq!(force.as_slice(), [5.0, 1.6, -3.2]);
    let half = std::f64::consts::PI / 8.0;
    let along = (5.0 * half).cos() * force[1] + (5.0 * half).sin() * force[2];
    let slack = (0.5 * force[0] - along / half.cos()) / 10.0;
    assert!(((&program.b * &x)[facet] - slack).abs() < 1e-15);
}

#[test]
fn loads_that_are_no_numbers_are_refused() {
    let bad = Wrench::new([f64::NAN, 0.0], 0.0);
    assert!(matches!(grasp(SPRINGS).energy().compare(bad), Err(Error::Wrench { component: 0, .. })));
}
