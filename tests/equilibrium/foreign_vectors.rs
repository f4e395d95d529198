//! Points and vectors of other libraries are accepted directly, and answers convert back to them.

use glam::{DVec2, DVec3};
use grasp_lcp::Error;
use grasp_lcp::{planar, spatial};
use nalgebra::{Point2, Point3, Vector2, Vector3};

/// The contact forces of a pinch under its own weight. `v` converts arrays to vectors of another library.
fn in_space<V: Into<[f64; 3]>>(v: impl Fn([f64; 3]) -> V) -> Result<Vec<DVec3>, Error> {
    let finger = |x: f64| {
        spatial::Contact::new(v([x, 0.01, 0.0]), v([-x, 0.0, 0.002]))
            .tangent(v([0.0, 0.0, 1.0]))
            .series_stiffness_axes(v([900.0, 500.0, 700.0]))
            .friction(0.6)
            .command(v([0.005, 0.0002, 0.0005]))
    };
    let grasp = spatial::Grasp::new([finger(-0.03), finger(0.03)])?;
    let load = spatial::Wrench::force_at(v([0.0, 0.3, -1.0]), v([0.0, 0.01, 0.0]));
    let outcome = grasp.solve(load)?;
    let held = outcome.equilibrium().expect("within friction");
    Ok(held.contacts.iter().map(|contact| DVec3::from_array(contact.force_world.into())).collect())
}

fn in_the_plane<V: Into<[f64; 2]>>(v: impl Fn([f64; 2]) -> V) -> Result<Vec<DVec2>, Error> {
    let finger = |x: f64| {
        planar::Contact::new(v([x, 0.01]), v([-x, 0.002]))
            .series_stiffness_axes(v([900.0, 500.0]))
            .friction(0.6)
            .command(v([0.005, 0.0002]))
    };
    let grasp = planar::Grasp::new([finger(-0.03), finger(0.03)])?;
    let outcome = grasp.solve(planar::Wrench::force_at(v([0.3, -1.0]), v([0.0, 0.01])))?;
    let held = outcome.equilibrium().expect("within friction");
    Ok(held.contacts.iter().map(|contact| DVec2::from_array(contact.force_world.into())).collect())
}

#[test]
fn vectors_of_every_library_say_the_same_in_space() -> Result<(), Error> {
    let arrays = in_space(|v| v)?;
    assert!((arrays[0] + arrays[1] - DVec3::new(0.0, -0.3, 1.0)).length() < 1e-14);
    assert_eq!(in_space(Vector3::from)?, arrays);
    assert_eq!(in_space(Point3::from)?, arrays);
    assert_eq!(in_space(DVec3::from_array)?, arrays);
    assert_eq!(in_space(mint::Vector3::from)?, arrays);
    assert_eq!(in_space(mint::Point3::from)?, arrays);
    assert_eq!(in_space(|[x, y, z]| (x, y, z))?, arrays);
    Ok(())
}

#[test]
fn vectors_of_every_library_say_the_same_in_the_plane() -> Result<(), Error> {
    let arrays = in_the_plane(|v| v)?;
    assert!((arrays[0] + arrays[1] - DVec2::new(-0.3, 1.0)).length() < 1e-14);
    assert_eq!(in_the_plane(Vector2::from)?, arrays);
    assert_eq!(in_the_plane(Point2::from)?, arrays);
    assert_eq!(in_the_plane(DVec2::from_array)?, arrays);
    assert_eq!(in_the_plane(mint::Vector2::from)?, arrays);
    assert_eq!(in_the_plane(mint::Point2::from)?, arrays);
    Ok(())
}
