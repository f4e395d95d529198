//! Answers are the same to the last bit for any number of threads, and without threads.

use grasp_lcp::Settings;
use grasp_lcp::spatial::{Contact, Grasp, Ramp, Turn, Wrench};
use grasp_lcp::sweep::map_in_order;

fn grasp() -> Grasp {
    let finger = |i: u8| {
        let angle = f64::from(i) * 1.3;
        let (sin, cos) = angle.sin_cos();
        Contact::new([cos, sin, 0.2 * angle.sin()], [-cos, -sin, 0.1])
            .series_stiffness(100.0 + 20.0 * angle, 70.0)
            .friction(0.5)
            .command([0.01 + 0.002 * sin, 0.0, 0.0])
    };
    Grasp::new((0..5).map(finger)).unwrap()
}

fn ramps() -> Vec<Ramp> {
    (0..200)
        .map(|i| {
            let a = f64::from(i) * 0.7;
            Ramp::load(
                Wrench::ZERO,
                Wrench::new([a.sin(), a.cos(), (1.7 * a).sin()], [0.0, 0.1, 0.2 * a.cos()]),
            )
        })
        .collect()
}

#[test]
fn onsets_do_not_depend_on_who_computes_them() {
    let (grasp, ramps, settings) = (grasp(), ramps(), Settings::default());
    let one_by_one: Vec<String> =
        ramps.iter().map(|ramp| format!("{:?}", grasp.with(&settings).onset(ramp).unwrap())).collect();
    let swept = || {
        map_in_order(&ramps, |ramp| format!("{:?}", grasp.with(&settings).onset(ramp).unwrap())).into_iter()
    };
    assert!(one_by_one.iter().any(|o| o.starts_with("At")));
    // Debug prints floats so that they read back to the same bits.
    assert!(swept().eq(one_by_one.iter().cloned()));
    #[cfg(feature = "parallel")]
    for threads in [1, 2, 3, 7] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let swept: Vec<String> = pool.install(|| swept().collect());
        assert_eq!(swept, one_by_one, "{threads} threads");
    }
}

#[test]
fn onsets_of_turns_do_not_depend_on_who_computes_them() {
    let (grasp, settings) = (grasp(), Settings::default());
    let turn = |i: u8| {
        let a = 0.7 * f64::from(i);
        let constant = Wrench::new([0.05 * a.sin(), 0.0, -0.1], [0.0, 0.01 * a.cos(), 0.0]);
        let (cosine, sine) = (Wrench::force([0.2, 0.1 * a.cos(), 0.0]), Wrench::force([0.0, 0.0, 3.0]));
        Turn::new(constant, cosine, sine)
    };
    let turns: Vec<_> = (0..200).map(turn).collect();
    let one_by_one: Vec<String> = turns
        .iter()
        .map(|turn| format!("{:?}", grasp.with(&settings).onset_of_turn(turn).unwrap()))
        .collect();
    assert!(one_by_one.iter().any(|o| o.contains("onset: At")));
    let swept = || {
        map_in_order(&turns, |turn| format!("{:?}", grasp.with(&settings).onset_of_turn(turn).unwrap()))
            .into_iter()
    };
    assert!(swept().eq(one_by_one.iter().cloned()));
    #[cfg(feature = "parallel")]
    for threads in [1, 2, 3, 7] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let swept: Vec<String> = pool.install(|| swept().collect());
        assert_eq!(swept, one_by_one, "{threads} threads");
    }
}

#[test]
fn answers_come_in_the_order_of_the_questions() {
    let grasp = grasp();
    let loads: Vec<_> = (0..50).map(|i| Wrench::force([0.0, 0.0, -0.01 * f64::from(i)])).collect();
    let answers = map_in_order(&loads, |load| grasp.solve(load));
    for (load, answer) in loads.iter().zip(answers) {
        assert_eq!(answer.unwrap().equilibrium().expect("holds").load, *load);
    }
}

/// Sums over thousands of contacts are added in pairs, so that their bits do not depend on the number of threads.
#[test]
fn paths_in_steps_do_not_depend_on_who_computes_them() {
    use grasp_lcp::planar;
    let n = 9000;
    let spring = |i: i32| {
        let x = f64::from(2 * i + 1) / f64::from(n) - 1.0;
        planar::Contact::new([x, 0.01 * (90.0 * x).sin()], [0.1 * (70.0 * x).sin(), 1.0])
            .series_stiffness(1.0 + x * x, 0.8)
            .friction(0.3)
            .command([1.0 - x * x, 0.0])
    };
    let grasp = planar::Grasp::new((0..n).map(spring)).unwrap();
    let press = f64::from(n) * 0.8;
    let legs = [planar::Leg::load_by(planar::Wrench::new([0.1 * press, 0.0], 0.0))];
    let followed = || {
        let mut path = grasp.follow_in_steps(planar::Wrench::new([0.0, -press], 0.0), &legs, 1e-2).unwrap();
        let steps: Vec<_> = path.by_ref().collect();
        assert!(steps.last().is_some_and(|step| step.sliding > 100), "{steps:?}");
        format!("{steps:?} {:?}", path.state())
    };
    let here = followed();
    #[cfg(feature = "parallel")]
    for threads in [1, 2, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        assert!(pool.install(followed) == here, "{threads} threads");
    }
    #[cfg(not(feature = "parallel"))]
    assert!(followed() == here);
}
