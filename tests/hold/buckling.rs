//! Contact forces turn with the bodies on which they act, which the theory of small motions neglects. If this effect buckles a grasp, the verdict
//! gives the load at which it does, and warns before.

use grasp_lcp::equilibrium::TooFar;
use grasp_lcp::hold::{LossVerb, ShortVerdict, Verdict};
use grasp_lcp::planar::{Bodies, Body, Contact, Grasp, Leg, Link, Ramp, Wrench};
use grasp_lcp::{Error, Settings, spatial};

const LENGTH: f64 = 0.1;
const SIDEWAYS: f64 = 1e3;
/// Stiffness of the links and the guide, N/m. The closed form is for rigid links; its error falls as 1/STIFF, to 3e-6 here. With a larger stiffness
/// rounding prevails.
const STIFF: f64 = 1e10;

/// Two links of [`LENGTH`] in line, which a ram pushes. Two springs without preload hold the knee sideways.
fn knee() -> Grasp {
    let beside = |name: &str, side: f64| {
        let finger = Contact::new([LENGTH, 0.01 * side], [0.0, -side]).series_stiffness(SIDEWAYS, SIDEWAYS);
        finger.friction(0.0).pressed_with(1e-6).on("first").name(name)
    };
    Bodies::new([Body::new("first"), Body::new("second"), Body::new("ram")])
        .contacts([beside("above", 1.0), beside("below", -1.0)])
        .links([
            Link::hinge([0.0, 0.0]).stiffness(STIFF).to_ground("first"),
            Link::hinge([LENGTH, 0.0]).stiffness(STIFF).between("first", "second"),
            Link::hinge([2.0 * LENGTH, 0.0]).stiffness(STIFF).between("second", "ram"),
            Link::slide([0.22, 0.0], [1.0, 0.0], 0.03).stiffness(STIFF).to_ground("ram"),
        ])
        .loaded("ram")
        .grasp()
        .unwrap()
}

/// A push of the ram with this force, N.
fn push(force: f64) -> Wrench {
    Wrench::force_at([-force, 0.0], [2.0 * LENGTH, 0.0])
}

fn pushed(force: f64) -> Verdict<2> {
    knee().hold(push(force)).unwrap()
}

/// The reason [`TooFar`] why motions are not small, from four questions: an equilibrium, the first slip, a path to this load, and a repeated load.
fn too_far(grasp: &Grasp, load: Wrench) -> Result<[Option<TooFar>; 4], Error> {
    let state = grasp.solve(load)?.equilibrium().and_then(|state| state.too_far.clone());
    let onset = grasp.onset(load)?;
    let first = onset.event().and_then(|event| grasp.state_at_onset(event)?.too_far);
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_by(load)])?;
    path.run();
    let shaken = grasp.shake(Wrench::ZERO, &Leg::there_and_back(load))?;
    Ok([state, first, path.end_of_theory().map(|end| end.what), shaken.too_far])
}

/// The linear model holds any force. If the knee moves sideways by w, both links turn by w/L. The springs resist with 2k w, and the compressed links
/// take away 2P w/L: the knee buckles at `P = k L`.
#[test]
fn compressed_links_in_line_buckle() {
    let critical = SIDEWAYS * LENGTH;
    assert_eq!(pushed(0.45 * critical).left_out, None);
    for part in [0.45, 0.55, 0.9, 1.1, 5.0] {
        let verdict = pushed(part * critical);
        if let Some(left) = verdict.left_out {
            assert!((left + part).abs() < 1e-5 * part && part < 1.0, "{left} {part}");
        }
        let lost = verdict.lost.as_ref().unwrap();
        assert_eq!(lost.too_far, Some(TooFar::Buckles), "{verdict}");
        assert!((lost.factor * part - 1.0).abs() < 1e-5, "{verdict}");
        assert_eq!(verdict.holds(), Some(part < 1.0), "{verdict}");
        assert_eq!(verdict.to_string().starts_with("BUCKLES at "), part > 1.0, "{verdict}");
        let (grasp, load) = (knee(), push(part * critical));
        let is_far = (part > 1.0).then_some(TooFar::Buckles);
        let [state, _, path, shaken] = too_far(&grasp, load).unwrap();
        assert_eq!([state, path, shaken], [(); 3].map(|()| is_far.clone()), "{part}");
    }
}

/// Two fingers at ±a press a bar with N. It resists rotation with `2 k a²`, and the forces take away `2 N a`: the bar buckles at rest beyond `N = k
/// a`. In space nothing resists a rotation about the line through the fingers. If only the line of action of a load is known, not its point, the
/// verdict warns.
#[test]
fn a_bar_pressed_too_hard_buckles_at_rest() -> Result<(), Error> {
    let (stiffness, half) = (2e3, 0.05);
    let critical = stiffness * half;
    for part in [0.9, 0.999, 1.001, 2.0] {
        let settle = |sentence: String, holds: Option<bool>, motion: Option<LossVerb>| {
            let buckles = part > 1.0;
            assert_eq!(holds, Some(!buckles), "{sentence}");
            assert_eq!(sentence.starts_with("BUCKLES at rest already"), buckles, "{sentence}");
            assert_eq!(motion == Some(LossVerb::Buckles), buckles, "{motion:?}");
        };
        let bar = [-half, half].map(|x| {
            let finger = Contact::new([x, 0.0], [-x.signum(), 0.0]).series_stiffness(1e5, stiffness);
            finger.friction(0.5).pressed_with(part * critical)
        });
        let load = Wrench::force_at([0.0, -1.0], [0.0, 0.0]);
        let row = |_: usize, contacts: &mut Vec<Contact>| {
            contacts.extend(bar.clone());
            [Wrench::ZERO, load]
        };
        // A brief verdict is on the whole load, beyond the first slip.
        let brief = Grasp::hold_batch(1, &row, &Settings::default()).remove(0)?;
        // Followed to the whole load alone, under which everything sticks.
        let to_there = Grasp::hold_batch(1, &row, &Settings::default().with_most_load(1.0)).remove(0)?;
        assert_eq!(to_there.motion == Some(LossVerb::Buckles), part > 1.0, "{to_there:?}");
        let grasp = Grasp::new(bar.clone())?;
        let verdict = grasp.hold(load)?;
        settle(verdict.to_string(), verdict.holds(), brief.motion);
        let is_far = (part > 1.0).then_some(TooFar::Buckles);
        assert_eq!(too_far(&grasp, load)?, [(); 4].map(|()| is_far.clone()));
        // At rest no load acts, so that nothing need be known of the point at which a force acts later.
        for load in [Wrench::force([0.0, -1.0]), Wrench::new([0.0; 2], 1e-6)] {
            let [.., path, _] = too_far(&grasp, load)?;
            assert_eq!(path, is_far);
            let verdict = grasp.hold(load)?;
            settle(verdict.to_string(), verdict.holds(), ShortVerdict::from(&verdict).motion);
        }
        let bar = [-half, half].map(|x| {
            let finger = spatial::Contact::new([x, 0.0, 0.0], [-x.signum(), 0.0, 0.0]);
            finger.series_stiffness(1e5, stiffness).friction(0.5).pressed_with(part * critical)
        });
        let verdict =
            spatial::Grasp::new(bar)?.hold(spatial::Wrench::force_at([0.0, 0.0, -1.0], [0.0; 3]))?;
        settle(verdict.to_string(), verdict.holds(), ShortVerdict::from(&verdict).motion);
    }
    Ok(())
}

/// Forces at rest that take 1.2 times what resists, and a weight F at rest. Hung at the depth h it adds F h, which steadies the bar beyond `F h = 0.4 k
/// a²`. If only its line is known, the bar may buckle, and the verdict claims neither that it holds nor that it is lost.
#[test]
fn a_weight_at_rest_steadies_only_where_it_is_known_to_hang() -> Result<(), Error> {
    let (stiffness, half) = (2e3, 0.05);
    let bar = [-half, half].map(|x| {
        let finger = Contact::new([x, 0.0], [-x.signum(), 0.0]).series_stiffness(1e5, stiffness);
        finger.friction(0.5).pressed_with(1.2 * stiffness * half)
    });
    let grasp = Grasp::new(bar)?;
    let (weight, load) = ([0.0, -20.0], Wrench::force_at([0.0, -1.0], [0.0; 2]));
    let hung = |depth: f64| grasp.hold(Ramp::load(Wrench::force_at(weight, [0.0, -depth]), load));
    let needed = 0.4 * stiffness * half * half / 20.0;
    assert_eq!([0.99, 1.01].map(|part| hung(part * needed).unwrap().holds()), [Some(false), Some(true)]);
    let unknown = grasp.hold(Ramp::load(Wrench::new(weight, 1e-6), load))?;
    assert_eq!((unknown.holds(), unknown.sticks()), (None, None), "{unknown}");
    assert!(unknown.to_string().starts_with("BUCKLES unless the load acts where it steadies"), "{unknown}");
    Ok(())
}

/// Fingers squeeze from 8 N to 25 N, past the force `k a` at which the bar buckles. A load of which only the line is known, on a later leg, does not hide
/// this.
#[test]
fn a_squeeze_that_grows_buckles_on_its_leg() -> Result<(), Error> {
    let (stiffness, half, normal) = (500.0, 0.04, 5e4);
    let bar = [-half, half].map(|x| {
        let finger = Contact::new([x, 0.0], [-x.signum(), 0.0]).series_stiffness(normal, stiffness);
        finger.friction(0.5).pressed_with(8.0)
    });
    let grasp = Grasp::new(bar)?;
    let squeezed = Leg::commands_to(vec![[25.0 / normal, 0.0]; 2]);
    for more in [vec![], vec![Leg::load_to(Wrench::force([0.0, -1.0]))]] {
        let legs = [vec![squeezed.clone()], more].concat();
        let mut path = grasp.follow(Wrench::ZERO, &legs)?;
        path.run();
        let end = path.end_of_theory().expect("it buckles");
        assert_eq!((end.leg, end.what), (0, TooFar::Buckles));
        assert!((8.0 + 17.0 * end.fraction - stiffness * half).abs() < 1e-6, "{}", end.fraction);
    }
    Ok(())
}

/// A tall body that buckles beside idle ones, each on two feet of its own. However many stand there, it buckles; beyond forty bodies it is not asked.
#[test]
fn idle_bodies_hide_nothing() -> Result<(), Error> {
    let (stiffness, half, height) = (2e3, 0.05, 0.4);
    let critical = 2.0 * stiffness * half * half / height;
    let feet = |name: &str, x: f64| {
        [-half, half].map(|side| {
            let foot = Contact::new([x + side, 0.0], [0.0, 1.0]).series_stiffness(stiffness, stiffness);
            foot.friction(0.5).on(name)
        })
    };
    for (idle, is_asked) in [(0, true), (11, true), (39, true), (40, false)] {
        let names: Vec<String> = (1..=idle).map(|k| format!("idle {k}")).collect();
        let tall = Body::new("tall").load(Wrench::force_at([0.0, -1.2 * critical], [0.0, height]));
        let beside = names
            .iter()
            .zip(1..)
            .map(|(name, k)| Body::new(name).load(Wrench::force_at([0.0, -1.0], [f64::from(k), 0.0])));
        let on_feet = names.iter().zip(1..).flat_map(|(name, k)| feet(name, f64::from(k)));
        let grasp = Bodies::new([tall].into_iter().chain(beside))
            .contacts(feet("tall", 0.0).into_iter().chain(on_feet))
            .loaded("tall")
            .grasp()?;
        let verdict = grasp.hold(Wrench::force_at([0.01, 0.0], [0.0, 0.0]))?;
        assert_eq!(verdict.to_string().starts_with("BUCKLES at rest already"), is_asked, "{idle} {verdict}");
    }
    Ok(())
}

/// A tall weight W at the height h on two soft feet at ±a: the feet resist tilting with 2 k a², and the weight takes away W h of it.
#[test]
fn a_tall_weight_on_soft_feet() {
    let (stiffness, half, height) = (2e3, 0.05, 0.4);
    let foot =
        |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(stiffness, stiffness).friction(0.5);
    let grasp = Grasp::new([foot(-half), foot(half)]).unwrap();
    let critical = 2.0 * stiffness * half * half / height;
    for part in [0.25, 0.4, 0.6, 1.5] {
        let verdict = grasp.hold(Wrench::force_at([0.0, -part * critical], [0.0, height])).unwrap();
        let taken = (part > 0.5 && part < 1.0).then_some(part);
        assert!(
            verdict.left_out.map(|left| -left).zip(taken).is_none_or(|(is, must)| (is - must).abs() < 1e-8),
            "{verdict}"
        );
        assert_eq!(verdict.left_out.is_some(), taken.is_some(), "{verdict}");
        // At the height of the feet, where the origin lies, the weight takes nothing away.
        assert_eq!(grasp.hold(Wrench::force([0.0, -part * critical])).unwrap().left_out, None);
    }
}

/// A compressed spring of length L between two parts. The one is guided along a line and held across it with k; the other is a rod of length r on a
/// pin, held with K across its end. With the thrust N, displacements a and b have the energy `½ k a² + ½ K b² - ½ N ((a - b)² / L + b² / r)`, so that
/// the parts buckle where its determinant is zero. Which of the two parts the spring is named on first does not matter.
#[test]
fn a_compressed_spring_between_two_bodies_turns_with_its_ends() -> Result<(), Error> {
    let (long, rod, across, at_rod): (f64, f64, f64, f64) = (0.05, 0.08, 2e3, 3e3);
    let touch = |x: f64, stiffness: f64, part: &str| {
        let of = |side: f64, name: &str| {
            let finger = Contact::new([x, 0.01 * side], [0.0, -side]).series_stiffness(stiffness, stiffness);
            finger.friction(0.0).pressed_with(1e-6).on(part).name(format!("{part} {name}"))
        };
        [of(1.0, "above"), of(-1.0, "below")]
    };
    // The determinant (k - N/L) (K - N/L - N/r) - (N/L)² is a quadratic in N.
    let (square, linear) = (1.0 / (long * rod), -(at_rod + across) / long - across / rod);
    let thrust = (-linear - (linear * linear - 4.0 * square * across * at_rod).sqrt()) / (2.0 * square);
    for is_first in [true, false] {
        let ends = ([0.0, 0.0], [long, 0.0]);
        let (ends, parts) =
            if is_first { (ends, ["ram", "rod"]) } else { ((ends.1, ends.0), ["rod", "ram"]) };
        let grasp = Bodies::new([Body::new("ram"), Body::new("rod")])
            .contacts(touch(0.0, 0.5 * across, "ram").into_iter().chain(touch(long, 0.5 * at_rod, "rod")))
            .links([
                Link::spring(ends.0, ends.1, STIFF).between(parts[0], parts[1]),
                Link::hinge([long + rod, 0.0]).stiffness(STIFF).to_ground("rod"),
            ])
            .loaded("ram")
            .grasp()?;
        let held = grasp.hold(Wrench::force_at([2.0 * thrust, 0.0], [0.0, 0.0]))?;
        let lost = held.lost.as_ref().unwrap();
        assert_eq!(lost.too_far, Some(TooFar::Buckles), "{held}");
        assert!((2.0 * lost.factor - 1.0).abs() < 1e-4, "{} {held}", 2.0 * lost.factor);
    }
    Ok(())
}
