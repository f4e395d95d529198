//! Polar pictures and maps of the sphere show true areas, and return an error if something cannot be drawn.

use grasp_lcp::picture::{Polar, SphereGrid, SphereMap, Stroke};

use support::svg::{Failure, paths};

/// Areas of all regions of an SVG in square pixels.
fn areas(svg: &str) -> Result<Vec<f64>, Failure> {
    let twice = |corners: &Vec<[f64; 2]>| -> f64 {
        let cross = |k: usize| {
            let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
            a[0] * b[1] - a[1] * b[0]
        };
        (0..corners.len()).map(cross).sum()
    };
    Ok(paths(svg)?.iter().map(|loops| 0.5 * loops.iter().map(twice).sum::<f64>().abs()).collect())
}

#[test]
fn directions_are_all_over_the_sphere() {
    let directions = SphereGrid::new(6, 10).directions();
    assert_eq!(directions.len(), 2 + 11 * 10);
    assert_eq!((directions[0], directions[111]), ([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]));
    for d in directions {
        assert!((d.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-15);
    }
}

#[test]
fn a_cap_takes_the_area_of_its_solid_angle() -> Result<(), Failure> {
    let grid = SphereGrid::new(40, 96);
    // The map shows the sphere as two discs. The axis of the caps lies in the plane of the rims, so each disc has half of each cap.
    let values: Vec<f64> = grid.directions().iter().map(|d| 0.6 * d[0] + 0.8 * d[1]).collect();
    let areas = areas(&SphereMap::new("caps", "x", grid, values)?.to_svg()?)?;
    let disc = areas.iter().copied().fold(0.0, f64::max);
    for k in 1..10 {
        let level = -1.0 + 0.2 * f64::from(k);
        let cap = disc * (1.0 - level) / 2.0;
        let on_both = areas.iter().filter(|area| (**area - cap).abs() < 0.003 * disc).count();
        assert_eq!(on_both, 2, "level {level}");
    }
    Ok(())
}

#[test]
fn values_without_number_get_their_own_colour() -> Result<(), Failure> {
    let grid = SphereGrid::new(20, 48);
    let values = grid.directions().into_iter().map(|d| match d[2] {
        z if z > 0.8 => f64::INFINITY,
        z if z < -0.8 => f64::NAN,
        z => 3.0 + z,
    });
    let map = SphereMap::new("caps", "z", grid, values.collect())?.meanings("never slides", "not known");
    let svg = map.to_svg()?;
    assert!(svg.contains("never slides") && svg.contains("not known"));
    Ok(())
}

#[test]
fn what_cannot_be_drawn_is_an_error() -> Result<(), Failure> {
    let grid = SphereGrid::new(4, 8);
    let count = grid.directions().len();
    assert!(SphereMap::new("few", "N", grid, vec![1.0; count - 1]).is_err());
    assert!(SphereMap::new("none", "N", grid, vec![f64::INFINITY; count]).is_err());
    let map = SphereMap::new("flat", "N", grid, vec![1.0; count])?;
    assert!(map.clone().to_svg().is_ok());
    assert!(map.mark([0.0; 3], "nowhere").to_svg().is_err());

    assert!(Polar::new("empty", "N").to_svg().is_err());
    let circle = |radius: f64| (0..36).map(|k| (f64::from(10 * k).to_radians(), radius)).collect::<Vec<_>>();
    assert!(Polar::new("never", "N").curve("a", circle(f64::INFINITY), Stroke::Line).to_svg().is_err());
    let polar = Polar::new("two", "N").curve("a", circle(2.0), Stroke::Line);
    assert!(polar.clone().curve("b", circle(f64::INFINITY), Stroke::Dashed).to_svg().is_ok());
    assert!(polar.rim(f64::NAN).to_svg().is_err());
    Ok(())
}
