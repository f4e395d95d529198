//! In random grasps an object that is reported as held has moved little. The first line of a verdict does not depend on units or on the order of
//! contacts.

use core::fmt::Write;

use grasp_lcp::hold::Verdict;
use grasp_lcp::{planar, spatial};
use support::samples::{samples, seeded};
use support::splitmix::Random;

/// The limit of small motions in the default settings.
const SMALL: f64 = 0.1;

/// Three or four contacts: fingers around an object, or feet under it. They are soft or stiff, and slightly or strongly overloaded.
struct Drawn<const C: usize> {
    points: Vec<[f64; C]>,
    normals: Vec<[f64; C]>,
    stiffness: Vec<[f64; 2]>,
    friction: Vec<f64>,
    press: Vec<f64>,
    force: [f64; C],
    at: [f64; C],
}

/// Fingers on all sides, so that the squeeze is usually balanced.
fn around(random: &mut Random) -> Drawn<2> {
    let mut drawn = drawn::<2>(random);
    let count = drawn.points.len();
    for i in 0..count {
        let angle = core::f64::consts::TAU * (i as f64 + 0.3 * random.uniform()) / count as f64;
        let lean = angle + 0.2 * (random.uniform() - 0.5);
        drawn.points[i] = [0.05 * angle.cos(), 0.04 * angle.sin()];
        drawn.normals[i] = [-lean.cos(), -lean.sin()];
        drawn.press[i] += 5.0;
    }
    drawn
}

fn drawn<const C: usize>(random: &mut Random) -> Drawn<C> {
    let count = random.index(2, 5);
    let soft = 10.0_f64.powf(random.between(2.5, 6.5));
    let mut of = Drawn {
        points: Vec::new(),
        normals: Vec::new(),
        stiffness: Vec::new(),
        friction: Vec::new(),
        press: Vec::new(),
        force: core::array::from_fn(|_| random.between(-15.0, 15.0)),
        at: core::array::from_fn(|_| random.between(-0.1, 0.1)),
    };
    for _ in 0..count {
        let point: [f64; C] = core::array::from_fn(|_| random.between(-0.05, 0.05));
        of.normals.push(core::array::from_fn(|k| random.between(-0.02, 0.02) - point[k]));
        of.points.push(point);
        of.stiffness.push([soft * random.between(0.5, 2.0), soft * random.between(0.5, 2.0)]);
        of.friction.push(if random.between(0.0, 1.0) < 0.15 { 0.0 } else { random.between(0.1, 1.2) });
        of.press.push(random.between(0.0, 30.0));
    }
    of
}

/// The verdict in the plane, with lengths and forces in other units and with contacts in the given order. Squeezes are displacements, so they are
/// converted like lengths.
fn verdict_in_the_plane(drawn: &Drawn<2>, [length, force]: [f64; 2], order: &[usize]) -> Verdict<2> {
    let contacts = order.iter().map(|&i| {
        planar::Contact::new(drawn.points[i].map(|x| x * length), drawn.normals[i])
            .name(format!("f{i}"))
            .series_stiffness(drawn.stiffness[i][0] * force / length, drawn.stiffness[i][1] * force / length)
            .friction(drawn.friction[i])
            .pressed_with(drawn.press[i] * force)
    });
    let load = planar::Wrench::force_at(drawn.force.map(|x| x * force), drawn.at.map(|x| x * length));
    planar::Grasp::new(contacts).and_then(|grasp| grasp.hold(load)).expect("valid")
}

fn verdict_in_space(drawn: &Drawn<3>, [length, force]: [f64; 2], order: &[usize]) -> Verdict<3> {
    let contacts = order.iter().map(|&i| {
        spatial::Contact::new(drawn.points[i].map(|x| x * length), drawn.normals[i])
            .name(format!("f{i}"))
            .series_stiffness(drawn.stiffness[i][0] * force / length, drawn.stiffness[i][1] * force / length)
            .friction(drawn.friction[i])
            .pressed_with(drawn.press[i] * force)
    });
    let load = spatial::Wrench::force_at(drawn.force.map(|x| x * force), drawn.at.map(|x| x * length));
    spatial::Grasp::new(contacts).and_then(|grasp| grasp.hold(load)).expect("valid")
}

/// The size of a grasp: the root mean square distance of contacts from their centroid.
fn size<const C: usize>(points: &[[f64; C]]) -> f64 {
    let count = points.len() as f64;
    let middle: [f64; C] = core::array::from_fn(|k| points.iter().map(|p| p[k]).sum::<f64>() / count);
    let square = |p: &[f64; C]| (0..C).map(|k| (p[k] - middle[k]).powi(2)).sum::<f64>();
    (points.iter().map(square).sum::<f64>() / count).sqrt()
}

/// Whether the state of a held grasp has moved farther than small motions allow, from the motions in the answer.
fn moves_far<const C: usize>(verdict: &Verdict<C>, points: &[[f64; C]]) -> bool {
    let state = verdict.state.as_ref().expect("held");
    let rotation = state.twist.components()[C..].iter().map(|x| x * x).sum::<f64>().sqrt();
    let far = SMALL * size(points) * (1.0 + 1e-9);
    let contact_moves = |contact: &grasp_lcp::equilibrium::ContactAnswer<C>| {
        let is_open = matches!(contact.state, grasp_lcp::equilibrium::ContactState::Separated);
        // The finger does not move, so the gap is the displacement of the object minus the compression of the finger.
        if is_open { contact.gap > far } else { contact.slip.norm() > far }
    };
    rotation > SMALL * (1.0 + 1e-9) || state.contacts.iter().any(contact_moves)
}

#[test]
fn what_holds_has_moved_little() {
    let mut random = seeded(62);
    let (mut held, mut too_far) = (0, 0);
    for k in 0..samples(60) {
        let [holds, far] = if k % 3 == 0 {
            let drawn = drawn::<3>(&mut random);
            let order: Vec<_> = (0..drawn.points.len()).collect();
            let verdict = verdict_in_space(&drawn, [1.0, 1.0], &order);
            let holds = verdict.holds() == Some(true);
            assert!(!(holds && moves_far(&verdict, &drawn.points)), "{verdict}");
            [holds, verdict.lost.is_some_and(|lost| lost.too_far.is_some() && lost.factor <= 1.0)]
        } else {
            let drawn = drawn::<2>(&mut random);
            let order: Vec<_> = (0..drawn.points.len()).collect();
            let verdict = verdict_in_the_plane(&drawn, [1.0, 1.0], &order);
            let holds = verdict.holds() == Some(true);
            assert!(!(holds && moves_far(&verdict, &drawn.points)), "{verdict}");
            [holds, verdict.lost.is_some_and(|lost| lost.too_far.is_some() && lost.factor <= 1.0)]
        };
        held += usize::from(holds);
        too_far += usize::from(far);
    }
    println!("{held} {too_far}");
    assert!(held > 0 && too_far > 0);
}

/// The text without its numbers, which depend on units.
fn told_without_numbers(said: &str) -> String {
    let mut told = String::new();
    for word in
        said.split_whitespace().filter(|word| !word.starts_with(|c: char| c.is_ascii_digit() || c == '('))
    {
        let _ = write!(told, "{word} ");
    }
    told
}

/// In other units only the numbers of moments and lengths change. The words of the verdict and its load factors must be the same.
#[test]
fn units_and_order_do_not_matter() {
    let mut random = seeded(26);
    let (mut asked, mut slide_at_rest) = (0, 0);
    while asked < samples(10) {
        let drawn = around(&mut random);
        let order: Vec<_> = (0..drawn.points.len()).collect();
        let other: Vec<_> = order.iter().rev().copied().collect();
        let scale = [
            2.0_f64.powi(i32::try_from(random.integer(-8, 8)).expect("small")),
            2.0_f64.powi(i32::try_from(random.integer(-8, 8)).expect("small")),
        ];
        let one = verdict_in_the_plane(&drawn, [1.0, 1.0], &order);
        // If the squeeze alone makes contacts slide, several equilibria at rest may exist, and the search finds one of them.
        if one.first_slip.as_ref().is_some_and(|first| first.factor == 0.0) {
            slide_at_rest += 1;
            continue;
        }
        asked += 1;
        let scaled = verdict_in_the_plane(&drawn, scale, &order);
        let reordered = verdict_in_the_plane(&drawn, [1.0, 1.0], &other);
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-7 * a.max(b);
        assert!(
            close(one.held_to, scaled.held_to) && close(one.held_to, reordered.held_to),
            "{one}\n{scaled}\n{reordered}"
        );
        let words = |verdict: &Verdict<2>| {
            let said = verdict.to_string();
            let first = told_without_numbers(said.split(['.', ':']).next().unwrap_or_default());
            (first, verdict.holds(), verdict.sticks())
        };
        assert_eq!(words(&one), words(&scaled), "{one}\n{scaled}");
        assert_eq!(one.holds(), reordered.holds(), "{one}\n{reordered}");
        let slid = |verdict: &Verdict<2>| {
            let first = verdict.first_slip.iter().flat_map(|first| first.slide.iter().chain(&first.open));
            let mut names: Vec<_> = first.map(|part| part.label.clone()).collect();
            names.sort();
            names
        };
        assert_eq!(slid(&one), slid(&reordered), "{one}\n{reordered}");
    }
    println!("{asked} {slide_at_rest}");
    assert!(slide_at_rest < 3 * asked);
}
