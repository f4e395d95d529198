//! Typical pinch grasps of two or three soft fingertips, with loads that cause shear and torsion.

use grasp_lcp::Error;
use grasp_lcp::spatial::{Contact, Grasp, Pressure, SoftFingertip, Wrench};

use super::splitmix::Random;

/// Directions of two opposite fingers from the centre of the object.
pub const TWO: &[[f64; 2]] = &[[1.0, 0.0], [-1.0, 0.0]];
/// Directions of three fingers around the object.
pub const THREE: &[[f64; 2]] = &[[1.0, 0.0], [-0.5, 0.8], [-0.5, -0.8]];

/// A grasp of soft fingertips in these directions, `half` m from the centre of the object, with 2 kN/m each and a command of `press` m.
///
/// # Errors
/// Errors of invalid contacts.
pub fn pinch(
    tip: &SoftFingertip,
    places: &[[f64; 2]],
    [half, friction, press]: [f64; 3],
) -> Result<Grasp, Error> {
    let finger = |[x, y]: &[f64; 2]| {
        let part = half / x.hypot(*y);
        Contact::new([x * part, y * part, 0.0], [-x, -y, 0.0])
            .series_stiffness(2e3, 1.5e3)
            .friction(friction)
            .command([press, 0.0, 0.0])
    };
    let fingers = places.iter().map(|place| tip.contacts(&finger(place))).collect::<Result<Vec<_>, _>>()?;
    Grasp::new(fingers.concat())
}

/// A random pinch of tips with a radius of 6 mm, and a load.
///
/// The load is a weight, a weight with torsion, torsion alone, or a random force with a random moment.
///
/// # Errors
/// Never for random pinches, which are valid.
pub fn draw(random: &mut Random) -> Result<(Grasp, Wrench), Error> {
    let (points, kind) = (random.index(6, 8), random.index(0, 3));
    let tip = match random.index(0, 2) {
        0 => SoftFingertip::ring(0.006, points)?,
        1 => SoftFingertip::disc(0.006, 1, points, Pressure::Hertz)?,
        _ => SoftFingertip::disc(0.006, 2, points, Pressure::Uniform)?,
    };
    let places = if random.index(0, 4) < 3 { TWO } else { THREE };
    let grasp = pinch(
        &tip,
        places,
        [random.between(0.02, 0.05), random.between(0.3, 0.9), random.between(0.003, 0.007)],
    )?;
    let force = [0; 3].map(|_| random.between(-1.0, 1.0));
    let moment = [0; 3].map(|_| random.between(-0.02, 0.02));
    let load = match kind {
        0 => Wrench::force([0.0, 0.0, -1.0]),
        1 => Wrench::new([0.0, 0.0, -1.0], [moment[0], 0.0, 0.0]),
        2 => Wrench::new([0.0; 3], [0.02, 0.0, 0.0]),
        _ => Wrench::new(force, moment),
    };
    Ok((grasp, load))
}
