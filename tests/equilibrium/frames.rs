//! If scene and question are given in other coordinates, the answer is the same in these coordinates. The rigid motion of a twist is the screw
//! motion.

use std::f64::consts::PI;

use grasp_lcp::Error;
use grasp_lcp::planar;
use grasp_lcp::spatial::{Contact, Grasp, Twist, Wrench};
use nalgebra::{Isometry2, Isometry3, Matrix3, Matrix4, Point2, Point3, SMatrix, SVector, Vector2, Vector3};
use proptest::prelude::*;
use support::samples::config;

/// Random frames, about 1 m away and in any orientation.
fn pose() -> impl Strategy<Value = Isometry3<f64>> {
    (numbers::<3>(1.0), numbers::<3>(PI)).prop_map(|(p, r)| Isometry3::new(p, r))
}

fn numbers<const N: usize>(size: f64) -> impl Strategy<Value = SVector<f64, N>> {
    prop::collection::vec(-size..size, N).prop_map(SVector::from_vec)
}

/// Three pressing fingers around a bottle. Their springs differ along all axes, so that the tangents matter.
fn fingers() -> [Contact; 3] {
    [0.0, 2.0, 4.2].map(|angle: f64| {
        let (sin, cos) = angle.sin_cos();
        Contact::new([0.03 * cos, 0.03 * sin, 0.01 * sin], [-cos, -sin, 0.1])
            .series_stiffness_axes([900.0, 500.0, 700.0])
            .friction(0.5)
            .command([0.004, 0.0002, 0.0005])
    })
}

fn turned(v: [f64; 3], pose: &Isometry3<f64>) -> Vector3<f64> {
    pose.rotation * Vector3::from(v)
}

/// `(u, θ)` as the 4 x 4 matrix whose exponential moves points.
fn matrix(twist: &Twist) -> Matrix4<f64> {
    let mut m = Matrix4::zeros();
    m.fixed_view_mut::<3, 3>(0, 0).copy_from(&Vector3::from(twist.rotation()).cross_matrix());
    m.fixed_view_mut::<3, 1>(0, 3).copy_from(&Vector3::from(twist.translation()));
    m
}

fn size<const R: usize, const C: usize>(m: SMatrix<f64, R, C>) -> f64 {
    m.amax()
}

proptest! {
    #![proptest_config(config(256))]

    /// The force at a point and the motion of a point transform correctly between frames.
    #[test]
    fn wrenches_and_twists_are_carried(pose in pose(), f in numbers::<3>(5.0), r in numbers::<3>(1.0), q in numbers::<6>(1.0)) {
        let place = pose * Point3::from(r);
        let wrench = Wrench::force_at(f, r).transformed(&pose);
        prop_assert!(size(wrench.to_vector() - Wrench::force_at(pose.rotation * f, place).to_vector()) < 1e-14 * 30.0);

        let twist = Twist::from_vector(q);
        let moved = Vector3::from(twist.transformed(&pose).displacement_at(place));
        prop_assert!(size(moved - turned(twist.displacement_at(r), &pose)) < 1e-14);
    }

    /// Work does not depend on the frame nor on the reference point.
    #[test]
    fn work_is_invariant(pose in pose(), w in numbers::<6>(5.0), q in numbers::<6>(1.0), at in numbers::<3>(1.0)) {
        let (wrench, twist) = (Wrench::from_vector(w), Twist::from_vector(q));
        let work = w.dot(&q);
        let seen = wrench.transformed(&pose).to_vector().dot(&twist.transformed(&pose).to_vector());
        prop_assert!((seen - work).abs() < 1e-13);
        prop_assert!((wrench.about(at).to_vector().dot(&twist.about(at).to_vector()) - work).abs() < 1e-13);
        // A force has no moment about a point on its line of action.
        let force = [w[0], w[1], w[2]];
        prop_assert!(Vector3::from(Wrench::force_at(force, at).about(at).moment()).amax() < 1e-14);
        prop_assert!(size(Vector3::from(twist.about(at).translation()) - Vector3::from(twist.displacement_at(at))) == 0.0);
    }

    /// If the grasp is transformed, answers in contact frames stay the same, and answers in coordinate axes rotate.
    #[test]
    fn a_transformed_grasp_gives_the_transformed_answer(pose in pose()) {
        let (here, there) = (grasp(fingers())?, grasp(fingers().map(|finger| finger.transformed(&pose)))?);
        let load = Wrench::force_at([0.3, -0.2, -0.4], [0.01, 0.0, 0.02]);
        let (a, b) = (here.solve(load).expect("a load"), there.solve(load.transformed(&pose)).expect("a load"));
        let (a, b) = (a.equilibrium().expect("within friction"), b.equilibrium().expect("within friction"));
        for (a, b) in a.contacts.iter().zip(&b.contacts) {
            prop_assert!(size(a.force - b.force) < 1e-12);
            prop_assert!(size(pose.rotation * a.force_world - b.force_world) < 1e-12);
        }
        prop_assert!(size(a.twist.transformed(&pose).to_vector() - b.twist.to_vector()) < 1e-13);
        let onset = |grasp: &Grasp, load: Wrench| grasp.onset(load).expect("a load").factor();
        let (a, b) = (onset(&here, load).expect("slides"), onset(&there, load.transformed(&pose)).expect("slides"));
        prop_assert!((a - b).abs() < 1e-11 * a, "{a} {b}");
    }

    /// The rigid motion is nalgebra's matrix exponential, which does not use screws.
    #[test]
    fn exp_is_the_exponential_of_the_matrix(u in numbers::<3>(1.0), r in numbers::<3>(3.0), small in 0_i32..12) {
        let twist = Twist::new(u, r * 0.1_f64.powi(small));
        prop_assert!(size(twist.exp().to_homogeneous() - matrix(&twist).exp()) < 1e-13);
    }

    /// The exponential is independent of the frame. A rotation about the origin followed by the translation would not be.
    #[test]
    fn exp_does_not_depend_on_the_frame(pose in pose(), q in numbers::<6>(1.5)) {
        let twist = Twist::from_vector(q);
        let seen = twist.transformed(&pose).exp();
        prop_assert!(size(seen.to_homogeneous() - (pose * twist.exp() * pose.inverse()).to_homogeneous()) < 1e-14);
    }

    /// `log` is the inverse of `exp` for rotations of less than half a turn.
    #[test]
    fn log_undoes_exp(u in numbers::<3>(1.0), r in numbers::<3>(1.8), small in 0_i32..12) {
        let twist = Twist::new(u, r * 0.1_f64.powi(small));
        prop_assert!(size(Twist::log(&twist.exp()).to_vector() - twist.to_vector()) < 1e-13);
        let flat = planar::Twist::new([u[0], u[1]], r[2] * 0.1_f64.powi(small));
        prop_assert!(size(planar::Twist::log(&flat.exp()).to_vector() - flat.to_vector()) < 1e-14);
    }

    /// Planar motions agree with spatial motions in the plane.
    #[test]
    fn the_plane_moves_like_space(p in numbers::<2>(1.0), angle in -PI..PI, a in numbers::<3>(1.0), at in numbers::<2>(1.0)) {
        let (pose, same) = (Isometry2::new(p, angle), Isometry3::new(p.push(0.0), Vector3::z() * angle));
        let flat = |v: SVector<f64, 6>| Vector3::new(v[0], v[1], v[5]);
        let wrench = planar::Wrench::from_vector(a);
        let in_space = Wrench::new([a[0], a[1], 0.0], [0.0, 0.0, a[2]]);
        prop_assert!(size(wrench.transformed(&pose).to_vector() - flat(in_space.transformed(&same).to_vector())) < 1e-15);
        prop_assert!(size(wrench.about(at).to_vector() - flat(in_space.about(at.push(0.0)).to_vector())) < 1e-15);
        let twist = planar::Twist::from_vector(a);
        let in_space = Twist::new([a[0], a[1], 0.0], [0.0, 0.0, a[2]]);
        prop_assert!(size(twist.transformed(&pose).to_vector() - flat(in_space.transformed(&same).to_vector())) < 1e-15);
        let moved = twist.exp() * Point2::from(at) - (in_space.exp() * Point3::from(at.push(0.0))).xy();
        prop_assert!(size(moved) < 1e-14);
    }

    /// If all fingers follow one rigid motion of the hand, the object follows too, and no force changes.
    #[test]
    fn a_moved_hand_moves_the_object(q in numbers::<6>(1e-3)) {
        let grasp = grasp(fingers())?;
        let hand = Twist::from_vector(q);
        let commands: Vec<_> = grasp.contacts().iter().zip(grasp.frames())
            .map(|(finger, frame)| finger.commanded() + frame.tr_mul(&Vector3::from(hand.displacement_at(finger.point()))))
            .collect();
        let moved = grasp.clone().with_commands(commands).expect("one a contact");
        let load = Wrench::force([0.1, 0.0, -0.2]);
        let (a, b) = (grasp.solve(load).expect("a load"), moved.solve(load).expect("a load"));
        let (a, b) = (a.equilibrium().expect("holds"), b.equilibrium().expect("holds"));
        prop_assert!(size((b.twist - a.twist).to_vector() - q) < 1e-13);
        for (a, b) in a.contacts.iter().zip(&b.contacts) {
            prop_assert!(size(a.force - b.force) < 1e-11);
        }
    }
}

fn grasp(fingers: [Contact; 3]) -> Result<Grasp, TestCaseError> {
    Grasp::new(fingers).map_err(|error| TestCaseError::fail(error.to_string()))
}

#[test]
fn a_pivot_stays_where_it_is_however_far_away() {
    let pivot = [1e3, -2e3, 5e2];
    let turn = Twist::new([0.0; 3], [0.2, -0.1, 0.3]).about([-pivot[0], -pivot[1], -pivot[2]]);
    let moved = turn.exp() * Point3::from(pivot) - Point3::from(pivot);
    assert!(moved.norm() < 1e-11, "{moved}");
    // A rotation about the origin with the same translation misses the pivot by half the square of the angle times the distance.
    let naive = Isometry3::new(turn.translation().into(), turn.rotation().into());
    assert!((naive * Point3::from(pivot) - Point3::from(pivot)).norm() > 50.0);
}

#[test]
fn a_motion_without_rotation_is_a_translation() {
    assert_eq!(Twist::new([1.0, 2.0, 3.0], [0.0; 3]).exp(), Isometry3::translation(1.0, 2.0, 3.0));
    assert_eq!(Twist::log(&Isometry3::translation(1.0, 2.0, 3.0)), Twist::new([1.0, 2.0, 3.0], [0.0; 3]));
    assert_eq!(planar::Twist::new([1.0, 2.0], 0.0).exp(), Isometry2::translation(1.0, 2.0));
    assert_eq!(Twist::ZERO.exp(), Isometry3::identity());
}

/// A tangent rotates with its contact, and so does the sign of a planar tangent given by a hint. An invalid contact stays invalid.
#[test]
fn tangents_turn_along() -> Result<(), Error> {
    let quarter = Isometry2::new(Vector2::new(1.0, 2.0), PI / 2.0);
    for hint in [[1.0, 0.3], [-1.0, 0.3]] {
        let contact =
            || planar::Contact::new([0.0, 0.0], [0.0, 1.0]).tangent(hint).series_stiffness(1.0, 1.0);
        let frames = planar::Grasp::new([contact(), contact().transformed(&quarter)])?;
        let mut frames = frames.frames();
        let (a, b) = (frames.next().expect("two"), frames.next().expect("two"));
        assert!(size(quarter.rotation.to_rotation_matrix() * a - b) < 1e-15, "{a}{b}");
    }
    let nowhere = Contact::new([0.0; 3], [0.0; 3]).series_stiffness(1.0, 1.0);
    let refused = Grasp::new([nowhere.transformed(&Isometry3::identity())]).expect_err("no normal");
    assert!(matches!(refused, Error::Contact { field: grasp_lcp::Field::Normal, .. }));
    Ok(())
}

/// In space a contact frame is a rotation, in the plane a reflection.
#[test]
fn a_contact_frame_is_a_rotation_in_space() -> Result<(), Error> {
    for frame in Grasp::new(fingers())?.frames() {
        assert!((frame.determinant() - 1.0).abs() < 1e-15);
        assert!(size(frame.tr_mul(frame) - Matrix3::identity()) < 1e-15);
    }
    let planar =
        planar::Grasp::new([planar::Contact::new([0.0, 0.0], [1.0, 2.0]).series_stiffness(1.0, 1.0)])?;
    assert!(planar.frames().all(|frame| (frame.determinant() + 1.0).abs() < 1e-15));
    Ok(())
}

/// Everything that converts into an array is accepted.
#[test]
fn points_and_vectors_of_any_kind() {
    let contact = Contact::new([1.0, 2.0, 3.0], [0.0, 0.0, 1.0]);
    assert_eq!(contact, Contact::new(Point3::new(1.0, 2.0, 3.0), Vector3::z()));
    assert_eq!(contact, Contact::new((1.0, 2.0, 3.0), Vector3::z_axis().into_inner()));
    assert_eq!(
        contact,
        Contact::new(Matrix3::new_scaling(1.0).column(2) + Vector3::new(1.0, 2.0, 2.0), (0.0, 0.0, 1.0))
    );
    assert_eq!(Wrench::force_at([1.0, 0.0, 0.0], Point3::new(0.0, 2.0, 0.0)).moment(), [0.0, 0.0, -2.0]);
}
