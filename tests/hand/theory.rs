//! Theorems on coupled compliance hold for hands, and counterexamples show where they end.

use grasp_lcp::PolygonCone;
use grasp_lcp::equilibrium::FoundBy;
use grasp_lcp::nalgebra::{DMatrix, DVector};
use grasp_lcp::planar::Contact;
use grasp_lcp::planar::hand::{Finger, Hand};
use grasp_lcp::planar::{Grasp, Wrench};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// A random positive definite compliance matrix.
fn compliance(size: usize, numbers: &mut Random) -> DMatrix<f64> {
    let root = DMatrix::from_fn(size, size, |_, _| numbers.signed());
    &root * root.transpose() + DMatrix::identity(size, size) * 0.2
}

/// One contact on a fixed body.
fn one(c: [f64; 3], mu: f64, command: [f64; 2]) -> Grasp {
    let contact = Contact::new([0.0, 0.0], [1.0, 0.0]).friction(mu).command(command);
    let finger = Finger::compliant([contact], DMatrix::from_row_slice(2, 2, &[c[0], c[1], c[1], c[2]]));
    let bond = |x: f64| Finger::fixed(Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e9, 1e9).bonded());
    Hand::new([finger, bond(-1.0), bond(1.0)]).grasp().expect("well posed")
}

/// Klarbring's condition: for μ |c_nt| < c_nn every command has one solution, otherwise some commands have up to three.
#[test]
fn one_contact_on_a_fixed_body_has_one_answer_or_up_to_three() {
    for (c, mu, unique) in [
        ([1.0, 0.6, 1.0], 1.6, true),
        ([1.0, 0.6, 1.0], 2.5, false),
        ([2.0, -1.5, 3.0], 1.3, true),
        ([2.0, -1.5, 3.0], 2.0, false),
    ] {
        let mut most = 0;
        for k in 0..360 {
            let angle = f64::from(k) * std::f64::consts::TAU / 360.0 + 0.003;
            let all = one(c, mu, [angle.cos(), angle.sin()]).equilibria(Wrench::ZERO).expect("few states");
            assert!(!all.is_empty());
            most = most.max(all.len());
        }
        assert_eq!(most, if unique { 1 } else { 3 }, "{c:?} {mu}");
    }
}

/// For a free body the condition at every contact does not imply uniqueness. Sticking forces are unique all the same.
#[test]
fn on_a_free_body_several_answers_but_one_that_sticks() {
    let mut numbers = seeded(3);
    let (mut several, mut stuck) = (0, 0);
    for _ in 0..samples(400) {
        let mut finger = |x: f64| {
            let matrix = compliance(2, &mut numbers);
            // 1 % below the bound for one contact on a fixed body, and at most 1.5.
            let mu = (0.99 * matrix[(0, 0)] / matrix[(0, 1)].abs()).min(1.5);
            let contact = Contact::new([x, 0.3 * numbers.signed()], [-x, 0.8 * numbers.signed()])
                .friction(mu)
                .command([0.5 + numbers.uniform(), numbers.signed()]);
            Finger::compliant([contact], matrix)
        };
        let grasp: Grasp = Hand::new([finger(-1.0), finger(1.0)]).grasp().expect("well posed");
        let load = Wrench::new([0.2 * numbers.signed(), 0.2 * numbers.signed()], 0.1 * numbers.signed());
        let all = grasp.equilibria(load).expect("few states");
        several += usize::from(all.len() > 1);
        let sticking = all
            .iter()
            .filter(|e| e.contacts.iter().all(|c| c.state == grasp_lcp::planar::ContactState::Sticking))
            .count();
        assert!(sticking <= 1);
        stuck += sticking;
        let first = grasp.solve(load).expect("a load").equilibrium().map(|e| e.rule);
        assert!(sticking == 0 || first == Some(FoundBy::EverythingSticks), "{first:?}");
    }
    assert_met(&[(several, 5), (stuck, 20)]);
}

/// In the force form `zᵀMz >= 0` for z >= 0, for every coupling.
#[test]
fn the_force_form_stays_copositive() {
    let mut numbers = seeded(11);
    let mut forms = 0;
    for _ in 0..samples(30) {
        let contacts = [[-1.0, 0.2], [1.0, -0.1], [0.3, 1.0]].map(|[x, y]| {
            Contact::new([x, y], [-x, -y]).friction(0.2 + numbers.uniform()).command([1.0, numbers.signed()])
        });
        let grasp: Grasp = Hand::new([Finger::compliant(contacts, compliance(6, &mut numbers))])
            .grasp()
            .expect("well posed");
        let Some(form) =
            grasp.force_form(Wrench::force([0.1, -0.2]), &PolygonCone::default()).expect("a load")
        else {
            continue;
        };
        forms += 1;
        let m = form.lcp.matrix();
        for _ in 0..200 {
            let z =
                DVector::from_fn(
                    m.nrows(),
                    |_, _| if numbers.uniform() < 0.5 { 0.0 } else { numbers.uniform() },
                );
            let value = z.dot(&(m * &z));
            assert!(value >= -1e-12 * m.amax() * z.norm_squared(), "{value}");
        }
    }
    assert!(forms > 0);
}

/// A squeeze alone may have no equilibrium with contact, although the same squeeze with a weight has one.
#[test]
fn held_loads_need_not_include_zero() {
    let mut numbers = seeded(5);
    let mut found = 0;
    for _ in 0..samples(200) {
        let mut finger = |x: f64| {
            let contact = Contact::new([x, 0.0], [-x, 0.9 + 0.2 * numbers.signed()])
                .friction(0.5)
                .command([1.0, numbers.signed()]);
            Finger::compliant([contact], compliance(2, &mut numbers))
        };
        let grasp: Grasp = Hand::new([finger(-1.0), finger(1.0)]).grasp().expect("well posed");
        let holds = |load: f64| {
            let outcome = grasp.solve(Wrench::force([0.0, load])).expect("a load");
            outcome.equilibrium().is_some_and(|e| e.contacts.iter().any(|c| c.normal_force() > 1e-3))
        };
        // Both normals point up. Under a weight the object rests on the fingers; without it the fingers push it away.
        found += usize::from(!holds(0.0) && [0.3, 0.6, 1.0, 1.5].iter().any(|w| holds(-w)));
    }
    assert_met(&[(found, 20)]);
}
