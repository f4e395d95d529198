//! Every kind of answer also says what the safety factor that was asked for changes.

use grasp_lcp::Error;
use grasp_lcp::need::{Amount, Need};
use grasp_lcp::planar::{Bodies, Body, Contact, Grasp, Turn, Wrench};
use grasp_lcp::scene::Scene;

type Tested = Result<(), Box<dyn std::error::Error>>;

/// Two jaws of 8 N, μ = 0.5, which hold up to 8 N.
fn jaws() -> Result<Grasp, Error> {
    let jaw = |x: f64| {
        Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(2e3, 1.5e3).friction(0.5).pressed_with(8.0)
    };
    Grasp::new([jaw(-0.04).name("left"), jaw(0.04).name("right")])
}

/// At the angle θ a weight W presses less on one jaw, by `W sin θ / 2`, and both jaws carry the same friction. So the jaws hold if `W (cos θ + sin θ
/// / 2) <= 8 N`. The weight of 0.5 kg is held at every angle. Twice this weight is held at no angle.
#[test]
fn beside_any_amount() -> Tested {
    let turn = Turn::tilting([0.0, -4.905], [0.0, 0.0]);
    let told = |safety: f64| jaws()?.need(&Need::angle(turn).with_safety(safety));
    let needed = told(2.0)?;
    assert!(matches!(needed.amount, Amount::Any { .. }) && matches!(needed.safe, Some(Amount::None { .. })));
    assert!(needed.to_string().contains("; if the load is 2 times as large: no amount does"), "{needed}");
    let needed = told(1.6)?;
    let angle = needed.safe.as_ref().and_then(Amount::bound).expect("a bound");
    assert!((1.6 * 4.905 * (angle.cos() + 0.5 * angle.sin()) - 8.0).abs() < 1e-8, "{needed}");
    assert!(needed.to_string().contains("; if the load is 1.6 times as large: 2.31343°"), "{needed}");
    assert!(!told(1.4)?.to_string().contains("if the load"));
    Ok(())
}

/// The same fingers, of which each force may be 5 % less than set. The least force is then larger by 1/0.95. The greatest stays, since forces as set push
/// the part out as before.
#[test]
fn no_larger_than_as_given() -> Tested {
    let (sin, cos) = 20.0_f64.to_radians().sin_cos();
    let finger = |x: f64| {
        let normal = [-x.signum() * cos, sin];
        Contact::new([x, 0.0], normal).series_stiffness(1e5, 1e5).friction(0.3).force(20.0)
    };
    let grasp = Grasp::new([finger(-0.03), finger(0.03)])?;
    let need = Need::squeeze(Wrench::force([0.0, -1.0])).on_top_of(Wrench::force([0.0, -10.0]));
    let needed = grasp.need(&need.if_lower_by(0.0, 0.05))?;
    let ends = |amount: Option<&Amount>| match amount {
        Some(Amount::Bound { sufficient, until: Some(end), .. }) => [*sufficient, end.sufficient],
        _ => panic!("{needed}"),
    };
    let ([least, most], safe) = (ends(Some(&needed.amount)), ends(needed.safe.as_ref()));
    assert!((safe[0] * 0.95 / least - 1.0).abs() < 1e-6 && (safe[1] / most - 1.0).abs() < 1e-6, "{needed}");
    Ok(())
}

/// Two fingers press with a constant force on sides that taper by a = 20° and so push the part out. Forces from `5.5 / (sin a + μ cos a)` to `5 /
/// (sin a − μ cos a)` newtons hold a weight of 10 N, with a load of 1 N added. With less friction, both ends use the lower μ.
#[test]
fn at_both_ends() -> Tested {
    let (sin, cos) = 20.0_f64.to_radians().sin_cos();
    let finger = |name: &str, x: f64| {
        let along = -x.signum() * cos;
        format!(
            r#"{{"name": "{name}", "point": [{x}, 0], "normal": [{along}, {sin}], "stiffness": 1e5, "friction": 0.3, "force": 20}}"#
        )
    };
    let contacts = [finger("l", -0.03), finger("r", 0.03)].join(", ");
    let text = format!(r#"{{"format": "grasp-lcp/1", "planar": {{"contacts": [{contacts}]}}}}"#);
    let grasp = Scene::from_json(text.as_bytes())?.planar().expect("a planar scene").grasp()?;
    let need = Need::squeeze(Wrench::force([0.0, -1.0]))
        .on_top_of(Wrench::force([0.0, -10.0]))
        .if_lower_by(0.2, 0.0);
    let needed = grasp.need(&need)?;
    for (amount, friction) in [(Some(&needed.amount), 0.3), (needed.safe.as_ref(), 0.24)] {
        let Some(Amount::Bound { sufficient, until: Some(until), .. }) = amount else { panic!("{needed}") };
        let [least, most] = [5.5 / (sin + friction * cos), 5.0 / (sin - friction * cos)];
        assert!(
            (20.0 * sufficient - least).abs() < 1e-5 * least
                && (20.0 * until.sufficient - most).abs() < 1e-5 * most,
            "{needed}"
        );
    }
    assert!(needed.to_string().contains("if friction is 20 % less: 9.69084 N to 42.9206 N"), "{needed}");
    Ok(())
}

/// The weight of a body is a load at rest, which the safety factor does not multiply.
#[test]
fn not_of_the_load_at_rest() -> Tested {
    let jaw = |x: f64| {
        Contact::new([x, 0.0], [-x, 0.0])
            .series_stiffness(2e3, 1.5e3)
            .friction(0.5)
            .pressed_with(8.0)
            .on("box")
    };
    let grasp = Bodies::new([Body::new("box").mass(0.5, [0.0, 0.0])])
        .contacts([jaw(-0.04).name("left"), jaw(0.04).name("right")])
        .gravity([0.0, -9.81])
        .grasp()?;
    let alone = grasp.need(&Need::squeeze(Wrench::ZERO).with_safety(2.0));
    assert!(matches!(alone, Err(Error::Question { field: "safety", .. })), "{alone:?}");
    let needed = grasp.need(&Need::squeeze(Wrench::force([0.0, -1.0])).with_safety(2.0))?;
    assert!(
        needed.to_string().contains("; if the load beyond that at rest is 2 times as large: 6.905 N"),
        "{needed}"
    );
    Ok(())
}

/// One of two commands is scaled alone. Both jaws press with the mean of their commands, so the answer names the command to enter.
#[test]
fn a_command_is_named() -> Tested {
    let needed = jaws()?.need(&Need::force("left", Wrench::force([0.0, -4.905])))?;
    assert!(
        needed.to_string().starts_with("NEEDS 1.81 N of `pressed_with` at left so that it holds"),
        "{needed}"
    );
    Ok(())
}
