//! Sentences about a motion give the right axis. The motions are made here from known axes.

use grasp_lcp::words::Words;
use grasp_lcp::{planar, spatial};
use nalgebra::{Vector2, Vector3};
use support::samples::{samples, seeded};

/// The numbers of a sentence, in order.
fn numbers(told: &str) -> Vec<f64> {
    let parts = told.split(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-' | 'e')));
    parts.filter_map(|part| part.parse().ok()).collect()
}

#[test]
fn known_motions() {
    let words = Words::default();
    let turn = |at: [f64; 2], angle: f64| planar::Twist::new([angle * at[1], -angle * at[0]], angle);
    let moved = |twist: &planar::Twist| {
        [[0.05, 0.0], [-0.05, 0.01]].map(|point: [f64; 2]| Vector2::from(twist.displacement_at(point)))
    };
    for (twist, told) in [
        (turn([0.03, -0.01], 0.5_f64.to_radians()), "turns 0.5° anticlockwise about (0.03, -0.01) m"),
        (turn([0.03, -0.01], -0.5_f64.to_radians()), "turns 0.5° clockwise about (0.03, -0.01) m"),
        (planar::Twist::new([0.0, -0.0028], 0.0), "moves 2.8 mm along −y"),
        (planar::Twist::new([0.3, 0.4], 0.0), "moves 0.5 m along (0.6, 0.8)"),
    ] {
        assert_eq!(words.motion(&twist, &moved(&twist)), told);
    }
    let still = planar::Twist::ZERO;
    assert!(words.motion(&still, &moved(&still)).starts_with("stays"));
    let about_y = spatial::Twist::new([0.0006, 0.0028, -0.001], [0.0, 0.03, 0.0]);
    let moved =
        [[0.05, 0.0, 0.0], [-0.05, 0.0, 0.01]].map(|p: [f64; 3]| Vector3::from(about_y.displacement_at(p)));
    // The point of the axis nearest to the origin is ω × u / |ω|² with u = (0.0006, ·, -0.001) m: x = 0.03 · -0.001 / 0.0009, z = -0.03 · 0.0006 /
    // 0.0009.
    let told = words.motion(&about_y, &moved);
    let parts: Vec<&str> = told.split(" through ").flat_map(|part| part.split(" m, ")).collect();
    assert_eq!(parts, ["turns 1.71887° about +y", "(-0.0333333, 0, -0.02)", "moves 2.8 mm along +y"]);
}

/// A rotation about a distant axis is reported as the motion of the contacts, followed by the angle.
#[test]
fn what_hardly_turns_moves() {
    let far = planar::Twist::new([0.0, -1e-3], 1e-6);
    let moved = [[0.05, 0.0], [-0.05, 0.0]].map(|p: [f64; 2]| Vector2::from(far.displacement_at(p)));
    let told = Words::default().motion(&far, &moved);
    assert_eq!(told.split_once(", "), Some(("moves 1 mm along −y", "turns 5.72958e-5° anticlockwise")));
}

#[test]
fn axes_of_random_screws() {
    let mut random = seeded(3);
    for _ in 0..samples(125) {
        let mut vector = |size: f64| Vector3::from_fn(|_, _| size * random.normal());
        let (axis, through) = (vector(1.0).normalize(), vector(0.05));
        let (angle, pitch) = (0.01 + vector(0.1).norm(), vector(1e-3)[0].abs());
        let omega = axis * angle;
        let along = through.cross(&omega) + axis * pitch;
        let twist = spatial::Twist::new([along[0], along[1], along[2]], [omega[0], omega[1], omega[2]]);
        let points = [[0.05, 0.0, 0.0], [-0.05, 0.01, 0.0], [0.0, 0.0, 0.05]];
        let moved = points.map(|p: [f64; 3]| Vector3::from(twist.displacement_at(p)));
        let told = Words::with_digits(12).motion(&twist, &moved);
        assert!(told.starts_with("turns "), "{told}");
        let n = numbers(&told);
        assert!((n[0].to_radians() - angle).abs() < 1e-9, "{told}");
        assert!((Vector3::new(n[1], n[2], n[3]) - axis).norm() < 1e-9, "{told}");
        let off = Vector3::new(n[4], n[5], n[6]) - through;
        assert!(off.cross(&axis).norm() < 1e-9, "{told}");
        assert!((1e-3 * n[7] - pitch).abs() < 1e-9, "{told}");
    }
}

#[test]
fn numbers_have_the_digits_that_are_asked_for() {
    let mut random = seeded(4);
    for _ in 0..samples(5000) {
        let x = random.normal() * 10.0_f64.powi(i32::try_from(random.integer(-30, 30)).expect("small"));
        for digits in [1, 3, 6, 12, 17] {
            let told = Words::with_digits(digits).number(x);
            let back: f64 = told.parse().expect("a number");
            assert!(
                (back - x).abs()
                    <= 0.5001 * 10.0_f64.powi(1 - i32::try_from(digits).expect("small")) * x.abs(),
                "{told}"
            );
            let count = told.split('e').next().unwrap_or("").chars().filter(char::is_ascii_digit);
            let mantissa: String = count.skip_while(|c| *c == '0').collect();
            assert!(mantissa.len() <= digits.max(9), "{told}");
        }
        assert_eq!(Words::with_digits(17).number(x).parse(), Ok(x));
    }
    let words = Words::default();
    assert_eq!([0.0, -0.0, f64::INFINITY].map(|x| words.number(x)), ["0", "0", "∞"]);
    assert_eq!(words.numbers(&[1.0, -1e-17, -0.0]), "(1, 0, 0)");
}
