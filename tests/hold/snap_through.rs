//! A toggle snaps through long before its dead centre: as its parts turn, their arms become shorter and the resistance falls. The theory of small
//! motions resists up to five times the load.

use grasp_lcp::equilibrium::TooFar;
use grasp_lcp::planar::{Bodies, Body, Grasp, Link, Wrench};
use grasp_lcp::{Error, Settings, spatial};

const HALF: f64 = 0.1;
const STRUT: f64 = 1e5;

/// A knee at this height on two struts to the ground, which a slide guides along the vertical.
fn truss(height: f64) -> Grasp {
    Bodies::new([Body::new("knee")])
        .links([
            Link::spring([0.0, height], [-HALF, 0.0], STRUT).to_ground("knee"),
            Link::spring([0.0, height], [HALF, 0.0], STRUT).to_ground("knee"),
            Link::slide([0.0, 2.0 * height], [0.0, 1.0], 0.05).stiffness(1e9).to_ground("knee"),
        ])
        .grasp()
        .unwrap()
        .with(&any_slip())
}

/// The way along a slide counts as a slip of the part. Here it may be as long as it likes.
fn any_slip() -> Settings {
    Settings::default().with_small_motions(0.1, 1e50)
}

/// The load that pushes the knee of [`truss`] down by w: `2 k (L - l) y / l` with the height y = h - w and the lengths L and l of a strut.
fn carried(height: f64, down: f64) -> f64 {
    let (y, long) = (height - down, HALF.hypot(height));
    let now = HALF.hypot(y);
    2.0 * STRUT * (long - now) * y / now
}

/// The least abscissa in `[0, end]`, and the value there, at which a function with a single hill is highest; to 1e-9 of `end`.
fn top(of: &dyn Fn(f64) -> f64, end: f64) -> (f64, f64) {
    let (mut from, mut to) = (0.0, end);
    for _ in 0..200 {
        let (a, b) = ((2.0 * from + to) / 3.0, (from + 2.0 * to) / 3.0);
        if of(a) < of(b) { from = a } else { to = b }
    }
    (from, of(from))
}

fn down(force: f64, height: f64) -> Wrench {
    Wrench::force_at([0.0, -force], [0.0, height])
}

#[test]
fn a_shallow_truss_snaps_through_at_its_limit_load() -> Result<(), Error> {
    for height in [0.001, 0.01, 0.03] {
        let grasp = truss(height);
        let (_, limit) = top(&|w| carried(height, w), height);
        for part in [0.5, 0.999, 1.001, 3.0] {
            let verdict = grasp.hold(down(part * limit, height))?;
            assert_eq!(verdict.holds(), Some(part < 1.0), "{verdict}");
            let lost = verdict.lost.as_ref().unwrap();
            assert_eq!(lost.too_far, Some(TooFar::Buckles), "{verdict}");
            assert!((lost.factor * part - 1.0).abs() < 1e-4, "{} {verdict}", lost.factor * part);
        }
    }
    Ok(())
}

/// The verdict warns of the resistance that turning struts lose before: `w / w' - 1`, with the motions w of small and w' of finite rotations.
#[test]
fn the_lost_resistance_is_that_of_the_closed_form() -> Result<(), Error> {
    let height = 0.01;
    let (at_limit, limit) = top(&|w| carried(height, w), height);
    let small = |force: f64| force * HALF.hypot(height).powi(2) / (2.0 * STRUT * height * height);
    for part in [0.4, 0.8, 0.98] {
        let force = part * limit;
        let (mut from, mut to) = (0.0, at_limit);
        for _ in 0..100 {
            let middle = 0.5 * (from + to);
            if carried(height, middle) < force { from = middle } else { to = middle }
        }
        let left_out = truss(height).hold(down(force, height))?.left_out.unwrap();
        let expected = small(force) / from - 1.0;
        assert!((left_out - expected).abs() < 1e-5, "{part}: {left_out} {expected}");
    }
    Ok(())
}

/// Two rigid bars between three soft pins, each with half the load P in its middle. Each ground pin gives way by u, the knee by half as much on either
/// side, with the thrust k u: `P = 4 k u Y / (a + 1.5 u)`, with the height Y of the knee above the displaced ground pins.
#[test]
fn bars_on_soft_pins_snap_through_at_their_limit_load() -> Result<(), Error> {
    let (height, pin) = (0.01, 1e6);
    let bar = |name: &str, side: f64| Body::new(name).mass(1.0, [0.5 * side * HALF, 0.5 * height]);
    let hinge = |at: [f64; 2]| Link::hinge(at).stiffness(pin);
    let grasp = Bodies::new([bar("left", -1.0), bar("right", 1.0)])
        .links([
            hinge([-HALF, 0.0]).to_ground("left"),
            hinge([0.0, height]).between("left", "right"),
            hinge([HALF, 0.0]).to_ground("right"),
        ])
        .shared_by_mass()
        .grasp()?;
    let long = HALF.hypot(height);
    let carried = |u: f64| {
        let half = HALF + 1.5 * u;
        4.0 * pin * u * (long * long - half * half).max(0.0).sqrt() / half
    };
    let (_, limit) = top(&carried, (long - HALF) / 1.5);
    for part in [0.5, 1.001, 5.0] {
        let verdict = grasp.hold(Wrench::force_at([0.0, -part * limit], [0.0, 0.5 * height]))?;
        assert_eq!(verdict.holds(), Some(part < 1.0), "{verdict}");
        let lost = verdict.lost.as_ref().unwrap();
        assert!((lost.factor * part - 1.0).abs() < 1e-4, "{} {verdict}", lost.factor * part);
    }
    Ok(())
}

/// Three struts to a knee in space: `P = 3 k (L - l) y / l`.
#[test]
fn a_tripod_snaps_through_at_its_limit_load() -> Result<(), Error> {
    let height = 0.02;
    let foot = |k: f64| {
        let angle = k * core::f64::consts::TAU / 3.0;
        [HALF * angle.cos(), HALF * angle.sin(), 0.0]
    };
    let knee = [0.0, 0.0, height];
    let mut links: Vec<_> =
        [0.0, 1.0, 2.0].map(|k| spatial::Link::spring(knee, foot(k), STRUT).to_ground("knee")).into();
    let guide = spatial::Link::slide([0.0, 0.0, 2.0 * height], [0.0, 0.0, 1.0], 0.05).stiffness(1e9);
    links.push(guide.to_ground("knee"));
    let grasp = spatial::Bodies::new([spatial::Body::new("knee")]).links(links).grasp()?.with(&any_slip());
    let limit = 1.5 * top(&|w| carried(height, w), height).1;
    for part in [0.9, 1.1] {
        let verdict = grasp.hold(spatial::Wrench::force_at([0.0, 0.0, -part * limit], knee))?;
        assert_eq!(verdict.holds(), Some(part < 1.0), "{verdict}");
        let lost = verdict.lost.as_ref().unwrap();
        assert!((lost.factor * part - 1.0).abs() < 1e-4, "{} {verdict}", lost.factor * part);
    }
    Ok(())
}

/// A mast on a hinge between two cables with pretension, pushed down and a little to the side. It leans until the one cable goes slack, and the other
/// does not hold it alone. While both pull, a linear model has twice the stiffness.
#[test]
fn a_mast_falls_where_a_cable_goes_slack() -> Result<(), Error> {
    let (height, foot, stiffness, pretension) = (3.0, 2.0, 3e3, 55.0);
    let load = [0.012, -1.0];
    let cable = |x: f64| {
        let link = Link::cable([0.0, height], [x, 0.0]).stiffness(stiffness).pretension(pretension);
        link.to_ground("mast")
    };
    let hinge = Link::hinge([0.0, 0.0]).stiffness(1e10).to_ground("mast");
    let grasp = Bodies::new([Body::new("mast")]).links([hinge, cable(-foot), cable(foot)]).grasp()?;
    // The force under which the mast balances as it leans by an angle, from moments about the hinge.
    let carried = |lean: f64| {
        let tip = [height * lean.sin(), height * lean.cos()];
        let moment = |f: [f64; 2]| tip[0] * f[1] - tip[1] * f[0];
        let long = foot.hypot(height);
        let by_cables = [-foot, foot].map(|x| {
            let to = [x - tip[0], -tip[1]];
            let now = to[0].hypot(to[1]);
            let pull = (pretension + stiffness * (now - long)).max(0.0);
            moment(to.map(|x| x * pull / now))
        });
        -(by_cables[0] + by_cables[1]) / moment(load)
    };
    let limit = (1..2000).map(|k| carried(f64::from(k) * 5e-5)).fold(0.0, f64::max);
    for part in [0.9, 1.1, 1.6] {
        let force = part * limit;
        let verdict = grasp.hold(Wrench::force_at(load.map(|x| x * force), [0.0, height]))?;
        assert_eq!(verdict.holds(), Some(part < 1.0), "{verdict}");
        let lost = verdict.lost.as_ref().unwrap();
        assert!((lost.factor * part - 1.0).abs() < 1e-3, "{} {verdict}", lost.factor * part);
    }
    Ok(())
}
