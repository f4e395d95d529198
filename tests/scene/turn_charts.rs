//! In charts of the friction used against the angle, curves agree with closed forms, and no line is drawn across a gap.

use grasp_lcp::picture::{Chart, Stroke, chart_of_turn};
use grasp_lcp::planar::{Contact, Grasp, Turn};

type Tested = Result<(), Box<dyn std::error::Error>>;

fn palm(name: &str, x: f64) -> Contact {
    let palm = Contact::new([x, 0.0], [-x, 0.0]).name(name).series_stiffness(1000.0, 800.0);
    palm.friction(0.5).pressed_with(10.0)
}

/// Angles in degrees, each with the friction used at this angle.
pub(crate) type Curve = Vec<(f64, f64)>;

/// The points of each series of a chart.
pub(crate) fn curves(chart: &Chart) -> Result<Vec<Curve>, Box<dyn std::error::Error>> {
    let text = format!("{chart:?}");
    let lists = text.split("points: [").skip(1).filter_map(|rest| rest.split(']').next());
    lists
        .map(|list| {
            let pairs = list.split("), ").map(|pair| pair.trim_matches(['(', ')']));
            let point = |pair: &str| {
                let (x, y) = pair.split_once(", ").ok_or("a pair")?;
                Ok((x.parse()?, y.parse()?))
            };
            pairs.map(point).collect()
        })
        .collect()
}

/// A box of 8 N whose weight starts horizontal. The palms carry F_n = 10 ∓ 4 cos θ and F_t = 4 sin θ, and none slides.
#[test]
fn the_friction_used_is_that_of_the_closed_form() -> Tested {
    let palms = Grasp::new([palm("left", -1.0), palm("right", 1.0)])?;
    let turn = Turn::force_at([8.0, 0.0], [0.0, 0.0]).up_to(6.0);
    let chart = chart_of_turn(&palms, &turn, "A box")?;
    let curves = curves(&chart)?;
    assert_eq!(curves.len(), 2);
    for (curve, side) in curves.iter().zip([-1.0, 1.0]) {
        assert!(curve.len() > 180 && (curve[curve.len() - 1].0 - 6_f64.to_degrees()).abs() < 1e-12);
        for (degrees, used) in curve {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let closed = 4.0 * sin.abs() / (0.5 * (10.0 + side * 4.0 * cos));
            assert!((used - closed).abs() < 1e-12, "{degrees}: {used} {closed}");
        }
    }
    Ok(())
}

/// A heavier box of 12 N is lost at the angle with 5 = 6 sin θ + 3 cos θ, where the friction of the left palm is exhausted.
#[test]
fn a_curve_ends_where_the_grasp_is_lost() -> Tested {
    let palms = Grasp::new([palm("left", -1.0), palm("right", 1.0)])?;
    let turn = Turn::force_at([12.0, 0.0], [0.0, 0.0]);
    let chart = chart_of_turn(&palms, &turn, "A box")?;
    let curves = curves(&chart)?;
    let (degrees, used) = *curves[0].last().ok_or("a point")?;
    let slides = (5.0 / 45_f64.sqrt()).asin() - 3_f64.atan2(6.0);
    assert!((degrees.to_radians() - slides).abs() < 1e-14 && (used - 1.0).abs() < 1e-13);
    assert!(chart.to_svg()?.contains("lost: left "));
    Ok(())
}

#[test]
fn a_line_is_not_drawn_across_a_gap() -> Tested {
    let lines = |between: f64| -> Result<usize, Box<dyn std::error::Error>> {
        let points = vec![(0.0, 0.0), (1.0, 1.0), (2.0, between), (3.0, 1.0), (4.0, 0.0)];
        let svg = Chart::new("A gap", "x", "y").series("the only one", points, Stroke::Line).to_svg()?;
        assert_eq!(svg.matches("the only one").count(), 1);
        Ok(svg.matches("<polyline").count())
    };
    assert_eq!(lines(f64::NAN)?, lines(0.5)? + 1);
    Ok(())
}
