//! A load is always visible in pictures: at any size and place, from any viewpoint, and if it is only a moment.

use grasp_lcp::picture::{Page, PlanarPicture, View, draw_grasp};
use grasp_lcp::{planar, spatial};
use support::svg::{Failure, Shape, outside, shapes};

const LOAD: &str = "#000000";
/// Least length of an arrow with its head, pixels.
const LEAST: f64 = 17.9;
/// Left end of the legend, pixels.
const LEGEND: f64 = 620.0;

fn jaws() -> Result<planar::Grasp, grasp_lcp::Error> {
    let jaw = |x: f64| {
        let at = planar::Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(2000.0, 1500.0);
        at.friction(0.5).pressed_with(8.0)
    };
    planar::Grasp::new([jaw(-0.04), jaw(0.04)])
}

fn fingers() -> Result<spatial::Grasp, grasp_lcp::Error> {
    let finger = |degrees: f64, height: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let at = spatial::Contact::new([0.03 * cos, 0.03 * sin, height], [-cos, -sin, 0.0]);
        at.series_stiffness(1000.0, 600.0).friction(0.5).command([0.004, 0.0, 0.0])
    };
    spatial::Grasp::new([finger(180.0, 0.0), finger(60.0, 0.01), finger(-60.0, -0.01)])
}

/// Length of each load arrow of this line width, from its tail to the tip of its head.
fn arrows(shapes: &[Shape], width: f64) -> Vec<f64> {
    let is = |shape: &&Shape| shape.tag == "polyline" && shape.ink == LOAD && shape.width == Some(width);
    let tips: Vec<_> = shapes
        .iter()
        .filter(|shape| shape.tag == "polygon" && shape.ink == LOAD)
        .map(|head| head.points[0])
        .collect();
    let lines = shapes.iter().filter(is).map(|line| line.points[0]).filter(|tail| tail[0] < LEGEND);
    let away = |tail: [f64; 2]| {
        let distances = tips.iter().map(|tip| (tip[0] - tail[0]).hypot(tip[1] - tail[1]));
        distances.fold(f64::INFINITY, f64::min)
    };
    lines.map(away).collect()
}

fn says(shapes: &[Shape], words: &str) -> bool {
    // The label of a load arrow that is not to scale ends with a remark. So `words` that end with "not" need only be the beginning of a label.
    shapes
        .iter()
        .any(|shape| shape.words == words || words.ends_with("not") && shape.words.starts_with(words))
}

#[test]
fn a_planar_force_of_any_size_has_an_arrow() -> Result<(), Failure> {
    let grasp = jaws()?;
    for (newtons, words) in [
        (1e-100, "load 1e−100 N, not"),
        (1e-9, "load 1e−9 N, not"),
        (1e-3, "load 0.001 N, not"),
        (4.0, "load 4 N"),
    ] {
        let state =
            grasp.solve(planar::Wrench::force([0.0, -newtons]))?.equilibrium().cloned().ok_or("it holds")?;
        let svg = draw_grasp(&grasp, &state, None, "A load")?;
        let shapes = shapes(&svg)?;
        let arrows = arrows(&shapes, 3.0);
        assert!(arrows.len() == 1 && arrows[0] >= LEAST, "{newtons}: {arrows:?}");
        assert!(says(&shapes, words), "{newtons}");
    }
    Ok(())
}

#[test]
fn a_load_that_nothing_holds_has_an_arrow() -> Result<(), Failure> {
    let grasp = jaws()?;
    for (load, words) in [
        (planar::Wrench::force([0.0, -1e9]), "load 1e9 N"),
        (planar::Wrench::force_at([0.0, -1e9], [1e3, 0.0]), "moment −1e12 N m"),
    ] {
        assert!(grasp.solve(load)?.equilibrium().is_none());
        let svg = PlanarPicture::new(&grasp, "Too much").load(load).to_svg()?;
        let shapes = shapes(&svg)?;
        assert!(arrows(&shapes, 3.0).iter().all(|long| *long >= LEAST) && says(&shapes, words), "{words}");
        assert_eq!(arrows(&shapes, 3.0).len(), 1);
        assert!(outside(&svg)?.is_none());
    }
    Ok(())
}

#[test]
fn a_spatial_force_of_any_size_and_place_has_an_arrow_beside_a_grasp_that_is_seen() -> Result<(), Failure> {
    let grasp = fingers()?;
    for (newtons, arm) in [(1e-9, 0.0), (1e-3, 0.0), (0.5, 0.0), (1e-3, 0.05), (1e-5, 20.0), (1e-9, 1e5)] {
        let load = spatial::Wrench::force_at([0.0, 0.0, -newtons], [arm, 0.0, 0.0]);
        let page = Page::new(&grasp, "A load").outcome("held", &grasp.solve(load)?);
        let svg = page.to_svg(Some(0), View::default())?;
        let shapes = shapes(&svg)?;
        let arrows = arrows(&shapes, 3.0);
        assert!(arrows.len() == 1 && arrows[0] >= 0.8 * LEAST, "{newtons} {arm} {arrows:?}");
        // Fingers remain visible in the picture if the load acts far away.
        let fingers = shapes.iter().filter(|shape| shape.ink == "#6E6E6E" && shape.width == Some(5.0));
        let long = fingers
            .map(|line| (line.points[0][0] - line.points[1][0]).hypot(line.points[0][1] - line.points[1][1]));
        assert!(long.fold(0.0, f64::max) > 15.0, "{newtons} at {arm}");
        assert!(outside(&svg)?.is_none());
    }
    Ok(())
}

#[test]
fn a_moment_alone_has_an_arrow() -> Result<(), Failure> {
    let grasp = fingers()?;
    for moment in [1e-9, 1e-4] {
        let load = spatial::Wrench::new([0.0; 3], [moment, 0.0, 0.0]);
        let page = Page::new(&grasp, "A moment").outcome("held", &grasp.solve(load)?);
        let shapes = shapes(&page.to_svg(Some(0), View::FRONT)?)?;
        let arrows = arrows(&shapes, 2.0);
        assert!(arrows.len() == 1 && arrows[0] >= LEAST - 9.0, "{moment}: {arrows:?}");
        assert!(shapes.iter().any(|shape| shape.words.starts_with("load")));
    }
    Ok(())
}

#[test]
fn a_load_that_points_to_the_eye_is_a_circle_with_a_dot_or_a_cross() -> Result<(), Failure> {
    let grasp = fingers()?;
    let View { yaw, pitch, .. } = View::default();
    let eye = [yaw.sin() * pitch.cos(), -yaw.cos() * pitch.cos(), pitch.sin()];
    for (side, lines) in [(0.3, 0), (-0.3, 2)] {
        let load = spatial::Wrench::force(eye.map(|x| side * x));
        let page = Page::new(&grasp, "To the eye").outcome("held", &grasp.solve(load)?);
        let shapes = shapes(&page.to_svg(Some(0), View::default())?)?;
        let black = |tag: &str| {
            let of = |shape: &&Shape| shape.tag == tag && shape.ink == LOAD && shape.points[0][0] < LEGEND;
            shapes.iter().filter(of).count()
        };
        // A load towards the eye is a ring with a dot. A load away from the eye is a ring with two strokes.
        assert_eq!((black("circle"), black("polyline")), (if lines == 0 { 2 } else { 1 }, lines), "{side}");
    }
    Ok(())
}

#[test]
fn where_there_is_no_equilibrium_the_load_is_drawn_all_the_same() -> Result<(), Failure> {
    let grasp = fingers()?;
    let load = spatial::Wrench::force([0.0, 0.0, -1e9]);
    let page = Page::new(&grasp, "Too much").outcome("lost", &grasp.solve(load)?).under(load);
    let svg = page.to_svg(Some(0), View::default())?;
    assert_eq!(arrows(&shapes(&svg)?, 3.0).len(), 1);
    let html = page.to_html()?;
    assert!(html.contains("\"otherwise\":\"load 1e9 N, not"));
    Ok(())
}
