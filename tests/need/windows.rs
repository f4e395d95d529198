//! If only squeezes within certain intervals hold the load, the answer gives these intervals. The limits are known by hand: a motor reaches its force
//! limit while another finger still pushes the object away.

use grasp_lcp::need::{Amount, AmountWindow, Need};
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use grasp_lcp::scene::Scene;

type Tested = Result<(), Box<dyn std::error::Error>>;

/// At the squeeze s a jaw presses with 4 s newtons against a wall; its motor limits this force to 6 N. A finger pushes from above with s newtons, and
/// μ = 0.5. So a weight W is held if `W + s <= min(4 s, 6)`. `more` adds contacts whose commands also grow with s.
fn pushed_from_above(given: f64, more: &str) -> Result<Grasp, Box<dyn std::error::Error>> {
    let text = format!(
        r#"{{ "format": "grasp-lcp/1", "planar": {{
            "fingers": [{{
                "joints": [{{ "name": "motor", "prismatic": [1, 0], "stiffness": 1000, "command": {}, "limit": {{ "saturates": 6 }} }}],
                "contacts": [{{ "name": "left", "point": [-0.03, 0], "normal": [1, 0], "stiffness": 1e4, "friction": 0.5 }}]
            }}],
            "contacts": [
                {{ "name": "right", "point": [0.03, 0], "normal": [-1, 0], "stiffness": 1e4, "friction": 0.5 }},
                {{ "name": "pusher", "point": [0, 0.02], "normal": [0, -1], "stiffness": 1e4, "force": {given} }}{more}
            ]
        }} }}"#,
        0.0048 * given
    );
    Ok(Scene::from_json(text.as_bytes())?.planar().ok_or("a planar scene")?.grasp()?)
}

fn is(found: f64, squeeze: f64, given: f64) {
    assert!((found * given / squeeze - 1.0).abs() < 1e-10, "{found} {given} {squeeze}");
}

#[test]
fn a_window_is_found_from_wherever_the_search_begins() -> Tested {
    for given in [0.1, 0.4, 1.0, 1.55, 4.0, 16.0, 300.0] {
        let grasp = pushed_from_above(given, "")?;
        // For the last two weights the intervals of sufficient squeezes are far narrower than a factor of two.
        for weight in [3.0, 4.4, 4.4999] {
            for demanded in [Need::to_stick, Need::to_hold] {
                let need = demanded(Need::squeeze(Wrench::force([0.0, -weight]))).if_lower_by(0.0, 0.0);
                let needed = grasp.need(&need)?;
                let Amount::Bound { sufficient, until: Some(end), changes, elsewhere, .. } = &needed.amount
                else {
                    panic!("{given} {weight}: {needed}")
                };
                is(*sufficient, weight / 3.0, given);
                is(end.sufficient, 6.0 - weight, given);
                assert_eq!(end.at_their_limit, ["motor"], "{needed}");
                assert!(*changes == 2 && elsewhere.is_empty(), "{needed}");
            }
        }
    }
    Ok(())
}

#[test]
fn both_ends_say_what_presses_there() -> Tested {
    let need = |weight: f64| Need::squeeze(Wrench::force([0.0, -weight])).to_stick().if_lower_by(0.0, 0.0);
    let needed = pushed_from_above(4.0, "")?.need(&need(3.0))?;
    let Amount::Bound { presses, otherwise, until: Some(end), tried: Some(tried), .. } = &needed.amount
    else {
        panic!("{needed}")
    };
    for (presses, expected) in [(presses, [4.0, 1.0, 4.0]), (&end.presses, [6.0, 3.0, 6.0])] {
        let names: Vec<_> = presses.iter().map(|press| press.part.label.as_str()).collect();
        assert_eq!(names, ["right", "pusher", "left"]);
        assert!(
            presses.iter().zip(expected).all(|(press, force)| (press.force - force).abs() < 1e-9),
            "{needed}"
        );
    }
    assert!(otherwise.contains("right and left") && end.otherwise.contains("right and left"), "{needed}");
    assert!(tried.count == 13 && tried.from < 0.25 && tried.to < 0.75, "{needed}");
    // At no squeeze does friction carry the load of 5 N and the push. At the best squeeze the jaws press with 4 N.
    let needed = pushed_from_above(4.0, "")?.need(&need(5.0))?;
    let Amount::None { best, otherwise, .. } = &needed.amount else { panic!("{needed}") };
    assert!((best * 4.0 - 1.0).abs() < 1e-6, "{needed}");
    assert!(otherwise.starts_with("SLIPS OUT"), "{otherwise}");
    Ok(())
}

/// A squeeze that is safe if only half of it arrives can be too large if all of it arrives.
#[test]
fn what_is_safe_may_not_do_as_given() -> Tested {
    let half = Need::squeeze(Wrench::force([0.0, -4.2])).to_stick().if_lower_by(0.0, 0.5);
    let needed = pushed_from_above(1.0, "")?.need(&half)?;
    let Some(Amount::Bound { sufficient, .. }) = &needed.safe else { panic!("{needed}") };
    is(*sufficient, 2.8, 1.0);
    assert!(needed.to_string().contains("(which does not"), "{needed}");
    Ok(())
}

/// Two more jaws close later, with the depth `e = 0.0004 s - 0.0022` in metres, and add force after the motor has reached its limit. With friction
/// 0.5 all jaws hold `6 + 1e4 (e - 2e-4)` newtons together. This equals the push s plus the weight of 3 N again at s = 7.
#[test]
fn a_second_window_is_told_beside_the_first() -> Tested {
    let need = Need::squeeze(Wrench::force([0.0, -3.0])).to_hold().if_lower_by(0.0, 0.0);
    let late = |given: f64, x: f64| {
        format!(
            r#", {{ "point": [{x}, 0], "normal": [{}, 0], "stiffness": 1e4, "friction": 0.5, "clearance": 0.0022, "command": [{}, 0] }}"#,
            -x.signum(),
            4e-4 * given
        )
    };
    let grasp = |given: f64| pushed_from_above(given, &(late(given, -0.03) + &late(given, 0.03)));
    for given in [1.0, 0.5, 10.0] {
        let needed = grasp(given)?.need(&need)?;
        let Amount::Bound { sufficient, until: Some(end), elsewhere, .. } = &needed.amount else {
            panic!("{needed}")
        };
        is(*sufficient, 1.0, given);
        is(end.sufficient, 3.0, given);
        let [AmountWindow { from: Some(from), to: None, .. }] = elsewhere[..] else { panic!("{needed}") };
        assert!((from * given / 7.0 - 1.0).abs() < 1e-4, "{needed}");
    }
    Ok(())
}

/// The left jaw moves 20 mm for each unit of squeeze. At a squeeze of one it presses with 10 N and drags the part 10 mm along under a pad, farther
/// than small motions allow. So this squeeze is too large. After the pad has opened, friction of both jaws carries a weight of 1 N from a tenth of
/// this squeeze on.
#[test]
fn less_does_where_the_squeeze_given_moves_too_far() -> Tested {
    let jaw = |side: f64, come: f64| {
        Contact::new([0.03 * side, 0.0], [-side, 0.0])
            .series_stiffness(1e3, 1e5)
            .friction(0.5)
            .command([come, 0.0])
    };
    let pad = Contact::new([0.0, 0.03], [0.0, -1.0]).series_stiffness(1e3, 1e3).friction(0.1);
    let grasp = Grasp::new([jaw(-1.0, 0.02), jaw(1.0, 0.0), pad.command([1e-6, 0.0])])?;
    let needed = grasp.need(&Need::squeeze(Wrench::force([0.0, -1.0])).if_lower_by(0.0, 0.0))?;
    let Amount::Bound { sufficient, until: Some(end), .. } = &needed.amount else { panic!("{needed}") };
    is(*sufficient, 0.1, 1.0);
    // Small motions are limited to a tenth of the grasp's size, the root mean square distance of contacts from their centroid.
    let farthest = 0.1 * 0.0008_f64.sqrt();
    assert!((end.sufficient - farthest / 0.01).abs() < 1e-4, "{needed}");
    Ok(())
}
