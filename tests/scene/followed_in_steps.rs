//! With the field `in_steps` a scene asks for a load path in steps of bounded error. The answer has steps in place of events, and ends at the closed
//! forms.

use grasp_lcp::scene::{Answer, PathAnswer, PathOutcome, Scene};
use serde_json::{Value, json};

type Tested = Result<(), Box<dyn std::error::Error>>;

/// Normal force on the fingertip, N, its friction, and its tangential stiffness, N/m.
const PRESS: f64 = 10.0;
const MU: f64 = 0.5;
const SHEAR: f64 = 2000.0;
/// Error of the forces, relative to the largest force.
const ERROR: f64 = 1e-4;

/// A scene with an object on one soft fingertip, and a load path with these legs.
fn scene(place: &str, normal: &[u8], soft: &Value, force: &[f64], legs: &Value, error: f64) -> String {
    let contact = json!({
        "name": "tip", "point": vec![0; normal.len()], "normal": normal,
        "series_stiffness": [3000, SHEAR], "friction": MU, "soft": soft
    });
    let follow = json!({ "start": { "force": force }, "legs": legs, "in_steps": error });
    json!({ "format": "grasp-lcp/1", place: { "contacts": [contact], "questions": [{ "follow": follow }] } })
        .to_string()
}

/// The answer about the path, after it was written as JSON and read again.
fn followed<const C: usize>(answers: &[Answer<C>]) -> Result<PathAnswer<C>, Box<dyn std::error::Error>> {
    let [Answer::Follow(path)] = answers else { return Err("one path".into()) };
    assert_eq!(*path, serde_json::from_value(serde_json::to_value(path)?)?);
    Ok(path.clone())
}

/// Each spring at the radius r has the same share s of the normal force P and of the stiffness k, and slides from `r θ = μP/k` on. The moment is
/// `M(θ) = Σ s r min(k r θ, μP)`. It follows Masing's rule when it is reversed.
#[test]
fn a_twisted_fingertip_slides_ring_by_ring() -> Tested {
    let soft = json!({ "disc": { "radius": 0.006, "annuli": 10, "points": 6, "pressure": "hertz" } });
    let to = |moment: f64| json!({ "load_to": { "force": [0, 0, -PRESS], "moment": [0, 0, moment] } });
    let moments = [0.015, -0.006];
    let legs = json!(moments.map(to));
    let read: Scene =
        serde_json::from_str(&scene("spatial", &[0, 0, 1], &soft, &[0.0, 0.0, -PRESS], &legs, ERROR))?;
    let Some(setup) = read.spatial() else { return Err("in space".into()) };
    let grasp = setup.grasp()?;
    assert_eq!(grasp.len(), 120);
    let path = followed(&setup.answers()?)?;
    let PathOutcome::Completed { state: Some(state) } = &path.end else { return Err("held".into()) };
    assert!(path.events.is_empty() && path.energies.is_empty());
    let last = path.steps.last().ok_or("steps")?;
    assert!((last.leg, last.fraction, last.open) == (1, 1.0, 0) && path.step_error < 2.0 * ERROR);
    let slid = path.steps.iter().filter(|step| step.leg == 0).map(|step| step.sliding).max();
    assert!(slid.is_some_and(|slid| (20..120).contains(&slid)), "{slid:?}");

    let springs: Vec<_> = grasp.contacts().iter().zip(&state.contacts).collect();
    let moment = |turn: f64| -> f64 {
        let of = |(spring, told): &(&grasp_lcp::spatial::Contact, &grasp_lcp::spatial::ContactAnswer)| {
            let (r, share) = (spring.point().norm(), told.normal_force() / PRESS);
            share * r * (SHEAR * r * turn).min(MU * PRESS)
        };
        springs.iter().map(of).sum()
    };
    // The rotation at the end of the first leg, by bisection.
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if moment(middle) < moments[0] { low = middle } else { high = middle }
    }
    let turn = state.twist.rotation()[2];
    let off = moments[0] - 2.0 * moment(0.5 * (low - turn)) - moments[1];
    let arms: f64 = springs.iter().map(|(spring, _)| spring.point().norm()).sum();
    assert!(off.abs() < ERROR * state.largest_force() * arms, "{off:e} N m at {turn}");
    Ok(())
}

/// All strips of a pad slide at once, at `Q = μP`.
#[test]
fn a_sheared_pad_is_lost_at_its_limit() -> Tested {
    let soft = json!({ "pad": { "width": 0.01, "strips": 50, "pressure": "parabolic" } });
    let legs = json!([{ "load_by": { "force": [1.25 * MU * PRESS, 0] } }]);
    let read: Scene = serde_json::from_str(&scene("planar", &[0, 1], &soft, &[0.0, -PRESS], &legs, ERROR))?;
    let Some(setup) = read.planar() else { return Err("in the plane".into()) };
    let path = followed(&setup.answers()?)?;
    let PathOutcome::Lost { loss, .. } = &path.end else { return Err("lost".into()) };
    assert!((loss.fraction - 0.8).abs() < 1e-10 && loss.contacts.len() == setup.grasp()?.len(), "{loss:?}");
    assert!(loss.contacts.iter().all(|contact| contact.name.as_deref() == Some("tip")));
    Ok(())
}

#[test]
fn an_error_out_of_range_is_refused() {
    let refused = |error: f64| {
        let text =
            scene("planar", &[0, 1], &json!({ "pair": { "width": 0.01 } }), &[0.0, -1.0], &json!([]), error);
        serde_json::from_str::<Scene>(&text).unwrap_err().to_string()
    };
    for error in [0.0, 2.0] {
        let says = refused(error);
        assert!(says.contains(&format!("]: in_steps is {error}, ")), "{says}");
    }
}
