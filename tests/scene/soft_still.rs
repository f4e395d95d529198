//! In a picture a soft fingertip has one force and one cone, at its centre of pressure, and a dot for each point.

use grasp_lcp::picture::{Page, View, draw_grasp};
use grasp_lcp::spatial::{Contact, ContactAnswer, Equilibrium, Grasp, Pressure, SoftFingertip, Wrench};
use grasp_lcp::{planar, spatial};

use support::svg::{Failure, Shape, circles, shapes};

const STICKING: &str = "#0072B2";
/// Width of the arrow of a force, pixels.
const FORCE: f64 = 3.0;
/// Number of points of each fingertip, and number of fingertips.
const POINTS: usize = 16;
const TIPS: usize = 2;

fn finger(name: &str, x: f64) -> Contact {
    let at = Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0]).name(name).tangent([0.0, 0.0, 1.0]);
    at.series_stiffness(3000.0, 2000.0).friction(0.8).command([0.002, 0.0, 0.0])
}

fn pinch() -> Result<(Grasp, Equilibrium), Failure> {
    let tip = SoftFingertip::disc(0.01, 2, 4, Pressure::Uniform)?;
    let grasp =
        Grasp::new([tip.contacts(&finger("thumb", -0.03))?, tip.contacts(&finger("index", 0.03))?].concat())?;
    assert_eq!(grasp.len(), TIPS * POINTS);
    // The weight acts beside the line of the pinch, so that the pressure is uneven.
    let state = grasp.solve(Wrench::force_at([0.0, 0.0, -1.0], [0.02, 0.0, 0.0]))?;
    let state = state.equilibrium().ok_or("it holds")?.clone();
    assert!(state.contacts.iter().all(|c| matches!(c.state, spatial::ContactState::Sticking)));
    Ok((grasp, state))
}

fn thick(shapes: &[Shape], ink: &str) -> Vec<[f64; 2]> {
    let is = |shape: &&Shape| shape.tag == "polyline" && shape.ink == ink && shape.width == Some(FORCE);
    shapes.iter().filter(is).map(|shape| shape.points[0]).collect()
}

#[test]
fn a_fingertip_has_one_force_at_its_centre_of_pressure() -> Result<(), Failure> {
    let (grasp, state) = pinch()?;
    let svg = Page::new(&grasp, "A pinch").frame("held", &state).to_svg(Some(0), View::FRONT)?;
    let shapes = shapes(&svg)?;
    // The legend contains one more thick arrow, which does not count.
    let mut starts = thick(&shapes, STICKING);
    starts.retain(|at| at[0] < 620.0);
    assert_eq!(starts.len(), TIPS);
    let mut dots = circles(&svg, STICKING)?;
    dots.retain(|at| at[0] < 620.0);
    assert_eq!(dots.len(), TIPS * POINTS);
    // Scale in pixels per metre, from the two outermost points of the disc seen from the side.
    let heights = |side: f64| {
        let of_tip = dots.iter().filter(move |at| (at[0] > 316.0) == (side > 0.0)).map(|at| at[1]);
        of_tip.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)))
    };
    for (tip, side) in [(0, -1.0), (1, 1.0)] {
        let range = tip * POINTS..(tip + 1) * POINTS;
        let points: Vec<_> =
            grasp.contacts()[range.clone()].iter().map(|contact| contact.point()[2]).collect();
        let [low, high] =
            [f64::min as fn(f64, f64) -> f64, f64::max].map(|pick| points.iter().copied().reduce(pick));
        let (low, high) = (low.ok_or("points")?, high.ok_or("points")?);
        let pressed: Vec<_> = state.contacts[range].iter().map(ContactAnswer::normal_force).collect();
        let moment: f64 = points.iter().zip(&pressed).map(|(z, f)| z * f).sum();
        let centre = moment / pressed.iter().sum::<f64>();
        assert!(centre.abs() > 5e-5, "{centre}");
        let (top, bottom) = heights(side);
        let on_paper = bottom - (centre - low) / (high - low) * (bottom - top);
        let nearest = starts.iter().map(|at| (at[1] - on_paper).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 0.03, "{on_paper} {starts:?}");
    }
    // The picture has the names of fingertips, not of their points.
    assert!(shapes.iter().any(|shape| shape.words == "thumb") && !svg.contains("thumb 0"));
    Ok(())
}

#[test]
fn points_are_one_fingertip_under_any_name_and_without_one() -> Result<(), Failure> {
    let (grasp, state) = pinch()?;
    let renamed = grasp.contacts().iter().enumerate().map(|(i, c)| c.clone().name(format!("p{i}")));
    let tip = SoftFingertip::disc(0.01, 2, 4, Pressure::Uniform)?;
    let nameless = |x: f64| {
        let at = Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0]).tangent([0.0, 0.0, 1.0]);
        tip.contacts(&at.series_stiffness(3000.0, 2000.0).friction(0.8).command([0.002, 0.0, 0.0]))
    };
    for contacts in [renamed.collect::<Vec<_>>(), [nameless(-0.03)?, nameless(0.03)?].concat()] {
        let grasp = Grasp::new(contacts)?;
        let svg = Page::new(&grasp, "A pinch").frame("held", &state).to_svg(Some(0), View::FRONT)?;
        let mut starts = thick(&shapes(&svg)?, STICKING);
        starts.retain(|at| at[0] < 620.0);
        assert_eq!(starts.len(), TIPS);
    }
    Ok(())
}

#[test]
fn the_same_points_one_by_one_are_so_many_contacts() -> Result<(), Failure> {
    let (grasp, state) = pinch()?;
    let alone = |c: &Contact| {
        let at = Contact::new(c.point(), [-c.point()[0], 0.0, 0.0]).tangent([0.0, 0.0, 1.0]);
        at.series_stiffness(3000.0, 2000.0).friction(0.8).command([0.002, 0.0, 0.0])
    };
    let grasp = Grasp::new(grasp.contacts().iter().map(alone).collect::<Vec<_>>())?;
    let svg = Page::new(&grasp, "A pinch").frame("held", &state).to_svg(Some(0), View::FRONT)?;
    let mut starts = thick(&shapes(&svg)?, STICKING);
    starts.retain(|at| at[0] < 620.0);
    assert_eq!(starts.len(), TIPS * POINTS);
    Ok(())
}

#[test]
fn a_planar_fingertip_has_one_force() -> Result<(), Failure> {
    let finger = |name: &str, x: f64| {
        let at = planar::Contact::new([x, 0.0], [-x, 0.0]).name(name).series_stiffness(3000.0, 2000.0);
        at.friction(0.8).command([0.002, 0.0])
    };
    let tip = planar::SoftFingertip::pad(0.02, 5, Pressure::Uniform)?;
    let grasp = planar::Grasp::new(
        [tip.contacts(&finger("thumb", -0.03))?, tip.contacts(&finger("index", 0.03))?].concat(),
    )?;
    let state = grasp.solve(planar::Wrench::force([0.0, -1.0]))?;
    let state = state.equilibrium().ok_or("it holds")?;
    let svg = draw_grasp(&grasp, state, None, "A pinch")?;
    assert_eq!(thick(&shapes(&svg)?, STICKING).len(), TIPS);
    assert_eq!(circles(&svg, STICKING)?.len(), grasp.len());
    // Each fingertip carries half of the weight.
    let total: f64 = state.contacts[..grasp.len() / TIPS].iter().map(|c| c.force_world[1]).sum();
    assert!((total - 0.5).abs() < 1e-9);
    Ok(())
}
