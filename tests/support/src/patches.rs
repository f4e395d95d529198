//! Scenes: fingers around a body, and patches of springs.

use grasp_lcp::{planar, spatial};

/// Fingers around a body with uneven squeeze, under a load that makes some of them slide.
pub fn fingers(count: usize) -> Result<(spatial::Grasp, spatial::Wrench), grasp_lcp::Error> {
    let contact = |i: usize| {
        let (sin, cos) = (std::f64::consts::TAU * i as f64 / count as f64).sin_cos();
        spatial::Contact::new([cos, sin, 0.2 * uneven(i)], [-cos, -sin, 0.1])
            .tangent([0.0, 0.0, 1.0])
            .series_stiffness(10.0, 8.0)
            .friction(0.3)
            .command([0.1 * (0.4 + uneven(i)), 0.02 * uneven(i + 7), 0.0])
    };
    let pull = if count == 3 { 0.33 } else { 0.27 };
    let grasp = spatial::Grasp::new((0..count).map(contact))?;
    Ok((grasp, spatial::Wrench::new([0.02, 0.03, -pull * count as f64], [0.0, 0.0, 0.02])))
}

/// A pad along x with the largest pressure in the middle, sheared until the outer two thirds slide.
pub fn planar_patch(n: usize) -> Result<(planar::Grasp, planar::Wrench), grasp_lcp::Error> {
    let press = |i: usize| {
        let x = (i as f64 + 0.5) / n as f64 * 2.0 - 1.0;
        (x, (1.0 - x * x).sqrt() * (0.95 + 0.1 * uneven(i)))
    };
    let contact = |i: usize| {
        let (x, press) = press(i);
        planar::Contact::new([x, 0.0], [0.0, 1.0])
            .series_stiffness(1.0, 0.8)
            .friction(0.3)
            .command([press, 0.0])
    };
    let grasp = planar::Grasp::new((0..n).map(contact))?;
    let pressed: f64 = (0..n).map(|i| press(i).1).sum();
    Ok((grasp, planar::Wrench::new([0.98 * 0.3 * pressed, -pressed], 0.0)))
}

/// A round pad with the largest pressure in the middle, and the sum of its normal forces.
pub fn round_pad(n: usize) -> Result<(spatial::Grasp, f64), grasp_lcp::Error> {
    let place = |i: usize| {
        let r = ((i as f64 + 0.5) / n as f64).sqrt();
        (r, i as f64 * 2.399_963_229_728_653, (1.0 - r * r).sqrt() * (0.95 + 0.1 * uneven(i)))
    };
    let contact = |i: usize| {
        let (r, angle, press) = place(i);
        let (sin, cos) = angle.sin_cos();
        spatial::Contact::new([r * cos, r * sin, 0.0], [0.0, 0.0, 1.0])
            .tangent([1.0, 0.0, 0.0])
            .series_stiffness(1.0, 0.8)
            .friction(0.3)
            .command([press, 0.0, 0.0])
    };
    let grasp = spatial::Grasp::new((0..n).map(contact))?;
    Ok((grasp, (0..n).map(|i| place(i).2).sum()))
}

/// The round pad under shear and torsion that make its outer half slide.
pub fn spatial_patch(n: usize) -> Result<(spatial::Grasp, spatial::Wrench), grasp_lcp::Error> {
    let (grasp, pressed) = round_pad(n)?;
    let load = spatial::Wrench::new([0.23 * pressed, 0.07 * pressed, -pressed], [0.0, 0.0, 0.035 * pressed]);
    Ok((grasp, load))
}

/// Element i of a fixed quasi-random sequence in [0, 1).
pub fn uneven(i: usize) -> f64 {
    (i as f64 * 0.618_033_988_749_894_9 + 0.37).fract()
}
