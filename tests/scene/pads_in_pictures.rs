//! The rim of a pad in space is drawn around its points on the part, and displacements are never drawn too small.

use grasp_lcp::picture::{Page, View};
use grasp_lcp::spatial::{Contact, Equilibrium, Grasp, SoftFingertip, Wrench};

use support::svg::{Failure, circles, shapes};

const STICKING: &str = "#0072B2";
/// Width of the line around a pad in a picture, pixels.
const RIM: f64 = 1.5;

/// Two pads of 20 x 12 mm on both sides of a box, seen from the front. `strips` is the number of strips in half of each side.
fn pinch(strips: usize, stiffness: f64) -> Result<(Grasp, Equilibrium), Failure> {
    let pad = SoftFingertip::rectangle([0.02, 0.012], [strips, strips])?;
    let jaw = |name: &str, y: f64| {
        let at = Contact::new([0.0, y, 0.0], [0.0, -y, 0.0]).name(name).tangent([1.0, 0.0, 0.0]);
        at.series_stiffness(stiffness, stiffness).friction(0.8).pressed_with(20.0)
    };
    let grasp = Grasp::new([pad.contacts(&jaw("near", -0.03))?, pad.contacts(&jaw("far", 0.03))?].concat())?;
    let state = grasp.solve(Wrench::force([0.0, 0.0, -1.0]))?;
    let state = state.equilibrium().ok_or("it holds")?.clone();
    Ok((grasp, state))
}

fn still(grasp: &Grasp, state: &Equilibrium) -> Result<String, Failure> {
    Ok(Page::new(grasp, "A pinch").frame("held", state).to_svg(Some(0), View::FRONT)?)
}

/// Width and height of the smallest rectangle around these places, in pixels, without the legend.
fn extent(places: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for place in places.filter(|place| place[0] < 620.0) {
        for a in 0..2 {
            (low[a], high[a]) = (low[a].min(place[a]), high[a].max(place[a]));
        }
    }
    [high[0] - low[0], high[1] - low[1]]
}

fn rim(svg: &str) -> Result<[f64; 2], Failure> {
    let shapes = shapes(svg)?;
    let lines = shapes.iter().filter(|shape| shape.ink == STICKING && shape.width == Some(RIM));
    Ok(extent(lines.flat_map(|shape| shape.points.clone())))
}

#[test]
fn a_rim_goes_around_the_points() -> Result<(), Failure> {
    let (grasp, state) = pinch(1, 3e4)?;
    let svg = still(&grasp, &state)?;
    let (rim, dots) = (rim(&svg)?, extent(circles(&svg, STICKING)?.into_iter()));
    for a in 0..2 {
        assert!((rim[a] - dots[a]).abs() < 0.1, "{rim:?} {dots:?}");
    }
    let size = |a: usize| grasp.contacts().iter().map(|contact| contact.point()[a]).fold(0.0, f64::max);
    assert!((rim[0] / rim[1] / (size(0) / size(2)) - 1.0).abs() < 0.01, "{rim:?}");
    Ok(())
}

#[test]
fn many_points_that_stick_have_no_dots() -> Result<(), Failure> {
    let (grasp, state) = pinch(2, 3e4)?;
    assert_eq!(grasp.len(), 2 * 64);
    let svg = still(&grasp, &state)?;
    assert!(circles(&svg, STICKING)?.iter().all(|at| at[0] > 620.0), "{svg}");
    assert!(!svg.contains("point of a fingertip") && rim(&svg)?[0] > 50.0);
    Ok(())
}

/// Under the load F the box sinks by F/2k. The picture says if it draws this displacement larger than true, and does not draw it if it is too large.
#[test]
fn a_displacement_that_is_too_large_is_said() -> Result<(), Failure> {
    let pink = |svg: &str| svg.contains("#CC79A7");
    let (grasp, state) = pinch(1, 10.0)?;
    let svg = still(&grasp, &state)?;
    assert!(!pink(&svg) && svg.contains("up to 0.05 m"), "{svg}");
    let (grasp, state) = pinch(1, 100.0)?;
    let svg = still(&grasp, &state)?;
    assert!(pink(&svg) && svg.contains("drawn 2 times"), "{svg}");
    Ok(())
}
