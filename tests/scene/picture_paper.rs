//! All text and lines are on the paper, and zero has no sign.

use grasp_lcp::picture::{
    Chart, Page, Polar, SphereGrid, SphereMap, Stroke, View, chart_of_turn, draw_grasp,
};
use grasp_lcp::{planar, spatial};

use support::svg::{Failure, shapes, view_box};

use crate::LONG;

/// Average width of a sans serif letter, relative to its height.
const LETTER: f64 = 0.55;

fn polar() -> Polar {
    let circle = |radius: f64| (0..36).map(|k| (f64::from(10 * k).to_radians(), radius)).collect::<Vec<_>>();
    Polar::new(LONG, "N")
        .curve(LONG, circle(2.0), Stroke::Line)
        .curve("another", circle(f64::INFINITY), Stroke::Dashed)
        .mark(vec![(0.0, 1.0)], LONG)
        .ray(0.0, "a")
        .note(LONG)
}

fn map() -> Result<SphereMap, Failure> {
    let grid = SphereGrid::new(12, 24);
    let values = grid.directions().iter().map(|d| d[0]).collect();
    Ok(SphereMap::new(LONG, "x", grid, values)?
        .mark([1.0, 0.0, 0.0], "to the right")
        .ray([-1.0, 0.0, 0.0], "to the left")
        .note(format!("{LONG}. {LONG}.")))
}

fn charts() -> Vec<Chart> {
    let loop_ = [(-1.0, -1.0), (-0.5, 0.1), (1.0, 1.0), (0.3, -0.2), (-1.0, -1.0)];
    let strokes = [
        Stroke::Line,
        Stroke::Marked,
        Stroke::Directed,
        Stroke::Dashed,
        Stroke::Circles,
        Stroke::Dots,
        Stroke::Bars,
    ];
    let of_stroke = |stroke| {
        let chart = Chart::new(LONG, "x (m)", "y (N)").series("there and back", loop_.to_vec(), stroke);
        chart
            .label(loop_[2], "1")
            .label((f64::NAN, 0.0), "nowhere")
            .mark(1.0, "the end")
            .shade_from(0.9, "beyond")
    };
    strokes.into_iter().map(of_stroke).collect()
}

fn pictures() -> Result<Vec<String>, Failure> {
    let finger = |x: f64| {
        let at = planar::Contact::new([x, 0.0], [-x, 0.0]).name("a named finger");
        at.series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0])
    };
    let flat = planar::Grasp::new([finger(-1.0), finger(1.0)])?;
    let state = flat.solve(planar::Wrench::new([0.0, -3.0], 0.0))?;
    let tip = |x: f64| {
        let at = spatial::Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0]);
        at.series_stiffness(1000.0, 600.0).friction(0.5).command([0.004, 0.0, 0.0])
    };
    let pinch = spatial::Grasp::new([tip(-0.03), tip(0.03)])?;
    let page = Page::new(&pinch, LONG).outcome(LONG, &pinch.solve(spatial::Wrench::force([0.0, 0.0, -0.5]))?);
    let turn = planar::Turn::force_at([8.0, 0.0], [0.0, 0.0]).up_to(6.0);
    let mut pictures = vec![
        draw_grasp(&flat, state.equilibrium().ok_or("it holds")?, None, LONG)?,
        page.to_svg(Some(0), View::FRONT)?,
        page.to_svg(None, View::ABOVE)?,
        polar().to_svg()?,
        map()?.to_svg()?,
        chart_of_turn(&flat, &turn, "turned")?.to_svg()?,
        Chart::sheet(&charts(), 2)?,
    ];
    for chart in charts() {
        pictures.push(chart.to_svg()?);
    }
    Ok(pictures)
}

#[test]
fn every_text_is_inside_of_the_paper() -> Result<(), Failure> {
    let mut texts = 0;
    for svg in pictures()? {
        let [wide, high] = view_box(&svg)?;
        for text in shapes(&svg)?.iter().filter(|shape| shape.tag == "text") {
            let long = LETTER * text.size * text.words.chars().count() as f64;
            let [x, y] = text.points[0];
            // Vertical text is in the middle of the left edge, so its width does not count.
            let upwards = x < 0.04 * wide && text.left == 0.5;
            let (left, right) =
                if upwards { (x, x) } else { (x - text.left * long, x + (1.0 - text.left) * long) };
            let inside = left >= 0.0 && right <= wide && y - 0.8 * text.size >= 0.0 && y <= high;
            assert!(inside, "{text:?}");
            texts += 1;
        }
    }
    assert!(texts > 300, "{texts} texts");
    Ok(())
}

#[test]
fn nothing_has_a_sign() -> Result<(), Failure> {
    for svg in pictures()? {
        for number in svg.split(|c: char| !(c.is_ascii_digit() || "-.".contains(c))) {
            let zero = number.starts_with('-') && number.parse::<f64>() == Ok(0.0);
            assert!(!zero, "{number}");
        }
    }
    Ok(())
}

#[test]
fn places_are_written_in_hundredths_of_a_pixel() -> Result<(), Failure> {
    let (polar, map) = (polar().to_svg()?, map()?.to_svg()?);
    for svg in [polar, map] {
        let places = shapes(&svg)?.into_iter().flat_map(|shape| shape.points).flatten();
        let off = places.map(|x| (100.0 * x - (100.0 * x).round()).abs()).fold(0.0, f64::max);
        assert!(off < 1e-9);
        // Curves are not rounded to whole pixels.
        assert!(shapes(&svg)?.iter().flat_map(|shape| &shape.points).any(|p| p[0].fract() != 0.0));
    }
    Ok(())
}
