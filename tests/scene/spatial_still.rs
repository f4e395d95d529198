//! In pictures of spatial grasps points are at their projections, everything is inside, and nearer things hide farther things. Names are text only.

use std::f64::consts::FRAC_PI_2;

use grasp_lcp::picture::{Page, View};
use grasp_lcp::spatial::{Contact, Equilibrium, Grasp, Outcome, Wrench};

use support::svg::{Failure, circles, shapes, view_box};

/// Region for points on the paper, and its middle, pixels.
const ROOM: (f64, f64) = (564.0, 484.0);
const MIDDLE: (f64, f64) = (312.0, 304.0);
/// Height of a line of text below the title, pixels.
const LABEL: f64 = 20.0;
/// Left end of the legend, pixels.
const LEGEND: f64 = 624.0;
/// Length of a finger, relative to the largest extent.
const FINGER: f64 = 0.12;
/// Tolerance: coordinates are written in hundredths of a pixel.
const NEAR: f64 = 0.0051;

const SLIDING: &str = "#D55E00";
const STICKING: &str = "#0072B2";
const GREY: &str = "#6E6E6E";

fn finger(point: [f64; 3], towards: [f64; 3]) -> Contact {
    let normal = [0, 1, 2].map(|k| towards[k] - point[k]);
    Contact::new(point, normal).series_stiffness(1000.0, 600.0).friction(0.5).command([0.004, 0.0, 0.0])
}

fn pinch() -> Result<Grasp, grasp_lcp::Error> {
    Grasp::new([finger([-0.03, 0.0, 0.0], [0.0; 3]), finger([0.03, 0.0, 0.0], [0.0; 3])])
}

/// The vector rotated by quarter turns about z.
fn turned(quarters: u32, v: [f64; 3]) -> [f64; 3] {
    (0..quarters).fold(v, |v, _| [-v[1], v[0], v[2]])
}

/// A grasp of a jar without symmetry.
fn jar(quarters: u32) -> Result<Grasp, grasp_lcp::Error> {
    let turn = |v| turned(quarters, v);
    let spots = [[-0.031, 0.002, 0.004], [0.017, 0.026, 0.011], [0.014, -0.029, -0.013]];
    Grasp::new(spots.map(|spot| finger(turn(spot), turn([0.0, 0.001, 0.002])).tangent(turn([0.1, 0.2, 1.0]))))
}

/// An equilibrium in which one contact slides.
fn slid(grasp: &Grasp, quarters: u32) -> Result<Equilibrium, Failure> {
    let turn = |v| turned(quarters, v);
    match grasp.solve(Wrench::force_at(turn([0.5, 0.4, -3.7]), turn([0.01, 0.02, 0.0])))? {
        Outcome::Equilibrium(state) => Ok(*state),
        other => Err(format!("{other:?}").into()),
    }
}

/// The page of the grasp, with the outlines of both ends of the jar.
fn page(grasp: &Grasp, quarters: u32) -> Page {
    let turn = |v| turned(quarters, v);
    let edge = |z: f64| [[-0.03, -0.01, z], [0.0, 0.03, z], [0.03, -0.02, z]].map(turn);
    Page::new(grasp, "A jar")
        .outline(edge(0.05))
        .outline(edge(-0.04))
        .fixture([[0.0, 0.0, -0.04], [0.0, 0.0, 0.05]])
}

#[test]
fn from_the_front_the_thumb_is_on_the_left() -> Result<(), Failure> {
    let grasp = pinch()?;
    let page = Page::new(&grasp, "A pinch");
    // The contacts and the lines of their fingers fill the width of the region.
    let scale = ROOM.0 / (0.06 * (1.0 + 2.0 * FINGER));
    let hundredths = |x: f64| (100.0 * x).round() / 100.0;
    let places = [-0.03, 0.03].map(|x| [MIDDLE.0 + scale * x, MIDDLE.1].map(hundredths));
    assert_eq!(circles(&page.to_svg(None, View::FRONT)?, GREY)?, places);
    // From the side both contacts are at the same point of the picture.
    let middle = [MIDDLE.0, MIDDLE.1];
    assert_eq!(circles(&page.to_svg(None, View::RIGHT)?, GREY)?, [middle, middle]);
    Ok(())
}

#[test]
fn forces_and_cones_have_their_lengths() -> Result<(), Failure> {
    let grasp = pinch()?;
    let page = Page::new(&grasp, "A pinch").outcome("no load", &grasp.solve(Wrench::ZERO)?);
    let svg = page.to_svg(Some(0), View::FRONT)?;
    // The grasp turns freely about an axis, which is drawn 1.5 times as long as the grasp is wide and fills the region.
    assert!(svg.contains("turns freely"));
    let scale = ROOM.0 / (1.5 * 0.06);
    let (x, y) = (MIDDLE.0, (MIDDLE.1 + LABEL));
    // Both forces of 4 N are the largest, so their arrows are 0.4 times the width of the grasp. They point along the normals, and cones are 1.15
    // times as long.
    let long = 0.4 * 0.06;
    let (end, wide) = (0.03 - 1.15 * long, 0.5 * 1.15 * long);
    let shapes = shapes(&svg)?;
    let is_there = |place: [f64; 2]| {
        let near = |point: &[f64; 2]| [0, 1].iter().all(|k| (point[*k] - place[*k]).abs() <= NEAR);
        let mut blue = shapes.iter().filter(|shape| shape.tag == "polygon" && shape.ink == STICKING);
        blue.any(|shape| shape.points.iter().any(near))
    };
    for side in [-1.0, 1.0] {
        assert!(is_there([x + side * scale * (0.03 - long), y]), "tip of a force");
        for up in [-1.0, 1.0] {
            assert!(is_there([x + side * scale * end, y + up * scale * wide]), "rim of a cone");
        }
    }
    // The arrow for 2 N in the legend is half as long as the arrow of a force of 4 N.
    let half = [LEGEND + scale * long / 2.0, 0.0];
    let mut grey = shapes.iter().filter(|shape| shape.tag == "polygon" && shape.ink == GREY);
    assert!(grey.any(|arrow| (arrow.points[0][0] - half[0]).abs() <= NEAR), "the scale");
    assert!(shapes.iter().any(|shape| shape.words == "2 N"));
    Ok(())
}

#[test]
fn points_lie_where_the_projection_says() -> Result<(), Failure> {
    let grasp = jar(0)?;
    for (yaw, pitch) in [(-0.6_f64, 0.45_f64), (2.0, -0.3), (0.4, 1.3)] {
        let on_paper = |p: [f64; 3]| {
            // Components of a point to the right, and horizontally away from the eye.
            let across = yaw.cos() * p[0] + yaw.sin() * p[1];
            let back = yaw.cos() * p[1] - yaw.sin() * p[0];
            [across, -(pitch.cos() * p[2] + pitch.sin() * back)]
        };
        let span = 0.026 + 0.029;
        let mut places = Vec::new();
        for (contact, frame) in grasp.contacts().iter().zip(grasp.frames()) {
            let tail = contact.point() - frame.column(0) * (FINGER * span);
            places.extend([contact.point(), tail].map(|point| on_paper(point.into())));
        }
        let [low, high] = [f64::min as fn(f64, f64) -> f64, f64::max]
            .map(|pick| [0, 1].map(|k| places.iter().map(|p| p[k]).reduce(pick).unwrap_or(f64::NAN)));
        let scale = (ROOM.0 / (high[0] - low[0])).min(ROOM.1 / (high[1] - low[1]));
        let view = View::default().with_yaw(yaw).with_pitch(pitch);
        let drawn = circles(&Page::new(&grasp, "A jar").to_svg(None, view)?, GREY)?;
        assert_eq!(drawn.len(), 3);
        for contact in places.chunks(2) {
            let x = MIDDLE.0 + scale * (contact[0][0] - f64::midpoint(low[0], high[0]));
            let y = MIDDLE.1 + scale * (contact[0][1] - f64::midpoint(low[1], high[1]));
            let near = |at: &[f64; 2]| (at[0] - x).abs() <= NEAR && (at[1] - y).abs() <= NEAR;
            assert!(drawn.iter().any(near), "{x} {y} {drawn:?}");
        }
    }
    Ok(())
}

#[test]
fn what_is_near_hides_what_is_far() -> Result<(), Failure> {
    for near_first in [true, false] {
        let [near, far] = [finger([0.0, -0.03, 0.01], [0.0; 3]), finger([0.02, 0.03, 0.0], [0.0; 3])];
        let grasp = Grasp::new(if near_first { [near, far] } else { [far, near] })?;
        let middles = circles(&Page::new(&grasp, "x").to_svg(None, View::FRONT)?, GREY)?;
        assert!(middles[0][0] > middles[1][0]);
    }
    Ok(())
}

#[test]
fn everything_is_inside_from_every_side() -> Result<(), Failure> {
    let grasp = jar(0)?;
    let steep = Grasp::new(grasp.contacts().iter().map(|c| c.clone().friction(40.0)).collect::<Vec<_>>())?;
    for grasp in [grasp, steep] {
        let far = grasp.solve(Wrench::force_at([0.0, 0.0, -0.1], [0.2, 0.0, 0.0]))?;
        let page = page(&grasp, 0).frame("slides", &slid(&grasp, 0)?).outcome("far", &far);
        for k in 0..12_u32 {
            let view = View::default().with_yaw(0.7 * f64::from(k)).with_pitch(0.3 * f64::from(k) - 1.5);
            for answer in [None, Some(0), Some(1)] {
                let svg = page.to_svg(answer, view)?;
                assert!(!svg.contains("NaN") && !svg.contains("inf"));
                assert_eq!(svg, page.to_svg(answer, view)?);
                let [wide, high] = view_box(&svg)?;
                for [x, y] in shapes(&svg)?.iter().flat_map(|shape| &shape.points) {
                    assert!((0.0..=wide).contains(x) && (0.0..=high).contains(y), "({x}, {y})");
                }
            }
        }
    }
    Ok(())
}

#[test]
fn a_grasp_and_an_eye_that_turn_together_see_the_same() -> Result<(), Failure> {
    let look = |quarters: u32| -> Result<_, Failure> {
        let grasp = jar(quarters)?;
        let state = slid(&grasp, quarters)?;
        let view = View::default().with_yaw(0.3 + f64::from(quarters) * FRAC_PI_2).with_pitch(0.5);
        let svg = page(&grasp, quarters).frame("slides", &state).to_svg(Some(0), view)?;
        // The coordinate axes in the corner, drawn last as three lines and letters, do rotate.
        let mut shapes = shapes(&svg)?;
        let axes = shapes.split_off(shapes.len() - 6);
        assert_eq!(axes.iter().filter(|shape| shape.tag == "polyline").count(), 3);
        Ok(shapes)
    };
    let straight = look(0)?;
    for quarters in 1..4 {
        let turned = look(quarters)?;
        assert_eq!(turned.len(), straight.len());
        for (a, b) in turned.iter().zip(&straight) {
            assert_eq!((&a.tag, &a.ink, a.points.len()), (&b.tag, &b.ink, b.points.len()));
            for (p, q) in a.points.iter().zip(&b.points) {
                assert!(
                    (p[0] - q[0]).abs() <= 2.0 * NEAR && (p[1] - q[1]).abs() <= 2.0 * NEAR,
                    "{a:?} {b:?}"
                );
            }
        }
    }
    Ok(())
}

#[test]
fn contacts_have_the_colours_of_what_they_do() -> Result<(), Failure> {
    let grasp = jar(0)?;
    let state = slid(&grasp, 0)?;
    let sliding = state.contacts.iter().filter(|c| c.margin.abs() < 1e-9).count();
    assert!(sliding > 0 && sliding < 3, "{state:?}");
    let svg = page(&grasp, 0).frame("slides", &state).to_svg(Some(0), View::default())?;
    // The legend has one more circle of each colour.
    assert_eq!(circles(&svg, SLIDING)?.len(), sliding + 1);
    assert_eq!(circles(&svg, STICKING)?.len(), 3 - sliding + 1);
    assert!(svg.contains("slip of the") && !svg.contains("no contact resists"));
    // A moment about the line of a pinch is not resisted. The picture of this outcome has no forces and says why.
    let pinch = pinch()?;
    let none =
        Page::new(&pinch, "x").outcome("turned", &pinch.solve(Wrench::new([0.0; 3], [0.1, 0.0, 0.0]))?);
    let svg = none.to_svg(Some(0), View::default())?;
    assert!(svg.contains("no equilibrium exists: "));
    assert_eq!((circles(&svg, GREY)?.len(), circles(&svg, STICKING)?.len()), (2, 0));
    Ok(())
}

#[test]
fn names_are_text_and_nothing_else() -> Result<(), Failure> {
    let nasty = "</text><script>alert(\"1 & 'x'\")</script>\u{1}";
    let named = |name: &str| -> Result<String, Failure> {
        let contacts: Vec<_> = jar(0)?.contacts().iter().map(|c| c.clone().name(name)).collect();
        // Motions are not limited, so that the picture has no caution about large motions, which would also contain a name.
        let grasp = Grasp::new(contacts)?;
        let grasp = grasp.with(&grasp.settings().with_small_motions(1e3, 1e3));
        let page = Page::new(&grasp, name).frame(name, &slid(&grasp, 0)?);
        Ok(page.to_svg(Some(0), View::default())?)
    };
    let (plain, svg) = (named("thumb")?, named(nasty)?);
    for tag in ["<text", "</text", "<polygon", "<circle"] {
        assert_eq!(svg.matches(tag).count(), plain.matches(tag).count(), "{tag}");
    }
    assert!(!svg.contains("<script") && !svg.contains('\u{1}'));
    // The name occurs five times: in the title, in the label, and at three contacts.
    assert_eq!(svg.matches("&lt;script&gt;").count(), 5);
    Ok(())
}

#[test]
fn what_cannot_be_drawn_is_an_error() -> Result<(), Failure> {
    let grasp = jar(0)?;
    let state = slid(&grasp, 0)?;
    let says = |page: Page, answer: Option<usize>, view: View, words: &str| {
        let drawn = page.to_svg(answer, view);
        assert!(drawn.as_ref().is_err_and(|error| error.to_string().contains(words)), "{words}: {drawn:?}");
    };
    let fine = View::default();
    let with_state = page(&grasp, 0).frame("slides", &state);
    says(with_state.clone(), Some(1), fine, "answer 1");
    says(page(&grasp, 0), Some(0), fine, "answer 0");
    for view in [fine.with_yaw(f64::NAN), fine.with_pitch(f64::INFINITY)] {
        says(with_state.clone(), Some(0), view, "view");
    }
    for corner in [[f64::NAN, 0.0, 0.0], [0.0, f64::INFINITY, 0.0]] {
        says(page(&grasp, 0).fixture([corner]), None, fine, "outline");
    }
    // The given numbers are finite, but numbers derived from them are not.
    says(page(&grasp, 0).outline([[1e308, 0.0, 0.0], [-1e308, 0.0, 0.0]]), None, fine, "too large");
    let other = Grasp::new(grasp.contacts()[..2].to_vec())?;
    says(Page::new(&other, "x").frame("a", &state), None, fine, "3 contacts");
    let mut broken = state;
    broken.contacts[0].force_world[1] = f64::NEG_INFINITY;
    says(page(&grasp, 0).frame("broken", &broken), Some(0), fine, "broken");
    Ok(())
}
