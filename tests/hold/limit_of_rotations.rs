//! Two jaws press on an object whose load stands high above them. As the object turns, load and squeeze help it on, so that it reaches a rotation at a
//! smaller load than in the theory of small motions.
//!
//! Contacts lie at `(±a, 0)`, with the stiffnesses k_n and k_t and the squeeze P. The load W acts downwards at (e, h). After the rotation θ about the
//! centre the moments balance if `W (e cos θ + h sin θ) = 2 a² sin θ (k_t cos θ + k_n (1 - cos θ)) - 2 a P sin θ`.

use grasp_lcp::equilibrium::TooFar;
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use grasp_lcp::{Error, Settings};

const ARM: f64 = 0.03;
const STIFFNESS: [f64; 2] = [3000.0, 2000.0];
const SQUEEZE: f64 = 10.0;
const POINT: [f64; 2] = [0.004, 0.05];
const LIMIT: f64 = 0.1;

fn jaws(friction: f64) -> Grasp {
    let jaw = |x: f64| {
        Contact::new([x, 0.0], [-x, 0.0])
            .series_stiffness(STIFFNESS[0], STIFFNESS[1])
            .friction(friction)
            .pressed_with(SQUEEZE)
    };
    Grasp::new([jaw(-ARM), jaw(ARM)]).unwrap()
}

fn down(force: f64) -> Wrench {
    Wrench::force_at([0.0, -force], POINT)
}

/// The load that turns the object by θ.
fn load_at(turned: f64) -> f64 {
    let (sin, cos) = turned.sin_cos();
    let springs = STIFFNESS[1] * cos + STIFFNESS[0] * (1.0 - cos);
    (2.0 * ARM * ARM * springs - 2.0 * ARM * SQUEEZE) * sin / (POINT[0] * cos + POINT[1] * sin)
}

#[test]
fn the_load_at_the_limit_is_that_of_finite_rotations() -> Result<(), Error> {
    let limit = load_at(LIMIT);
    for part in [0.5, 0.999, 1.001, 1.5] {
        let verdict = jaws(9.0).hold(down(part * limit))?;
        assert_eq!(verdict.holds(), Some(part < 1.0), "{verdict}");
        let lost = verdict.lost.as_ref().unwrap();
        assert!(matches!(lost.too_far, Some(TooFar::Turns { .. })), "{verdict}");
        assert!((lost.factor * part - 1.0).abs() < 1e-6, "{} {verdict}", lost.factor * part);
    }
    Ok(())
}

/// With less friction a contact slides before the rotation of small motions reaches its limit, but after that of finite rotations does.
#[test]
fn the_limit_is_found_before_a_slip() -> Result<(), Error> {
    let limit = load_at(LIMIT);
    let grasp = jaws(2.2);
    let slip = grasp.onset(down(1.0))?.factor().unwrap();
    let linear = 2.0 * ARM * ARM * STIFFNESS[1] * LIMIT / POINT[0];
    assert!(slip > 1.1 * limit && slip < linear, "{slip} {limit} {linear}");
    let verdict = grasp.hold(down(1.2 * slip))?;
    assert!((verdict.held_to * 1.2 * slip / limit - 1.0).abs() < 1e-6, "{verdict}");
    Ok(())
}

/// A batch says the same, of rows in which everything sticks in the theory of small motions and of rows in which a contact slides.
#[test]
fn a_batch_finds_the_same_limit() -> Result<(), Error> {
    let limit = load_at(LIMIT);
    let settings = Settings::default().with_most_load(1.0);
    for friction in [9.0, 2.2] {
        let loads = |row: usize| 0.1 * (row as f64 + 0.5) * limit;
        let row = |row: usize, contacts: &mut Vec<Contact>| {
            contacts.extend(jaws(friction).contacts().iter().cloned());
            [Wrench::ZERO, down(loads(row))]
        };
        for (number, verdict) in Grasp::hold_batch(20, &row, &settings).into_iter().enumerate() {
            let (verdict, alone) = (verdict?, jaws(friction).with(&settings).hold(down(loads(number)))?);
            assert_eq!(verdict.holds(), alone.holds(), "{friction} {number} {alone}");
            assert_eq!(
                verdict.holds(),
                Some(loads(number) < limit * (1.0 + 1e-6)),
                "{friction} {number} {alone}"
            );
        }
    }
    Ok(())
}

/// Forces take nearly all that resists, and the load hardly turns the object. It turns farther by a factor of twenty or fifty, and still holds; a little
/// more load turns it too far, which is said in the place of buckling.
#[test]
fn a_growth_of_fifty_times_is_followed() -> Result<(), Error> {
    for taken in [0.95, 0.98] {
        let squeeze = taken * ARM * STIFFNESS[1];
        let jaw = |x: f64| {
            Contact::new([x, 0.0], [-x, 0.0])
                .series_stiffness(STIFFNESS[0], STIFFNESS[1])
                .friction(9.0)
                .pressed_with(squeeze)
        };
        let grasp = Grasp::new([jaw(-ARM), jaw(ARM)])?;
        let (sin, cos) = LIMIT.sin_cos();
        let springs = STIFFNESS[1] * cos + STIFFNESS[0] * (1.0 - cos);
        let limit = (2.0 * ARM * ARM * springs - 2.0 * ARM * squeeze) * sin;
        for (part, holds) in [(0.9, true), (1.1, false)] {
            let verdict = grasp.hold(Wrench::new([0.0, 0.0], part * limit))?;
            assert_eq!(verdict.holds(), Some(holds), "{taken} {part} {verdict}");
            let lost = verdict.lost.as_ref().unwrap();
            assert!(matches!(lost.too_far, Some(TooFar::Turns { .. })), "{verdict}");
        }
    }
    Ok(())
}
