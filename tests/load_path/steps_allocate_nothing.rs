//! A path of many contacts in steps allocates no memory from the second round of its program on.

use allocation_counter::measure;
use grasp_lcp::spatial;

#[test]
fn steps_of_many_contacts_allocate_nothing() {
    let spring = |i: usize| {
        let (area, (sin, cos)) = ((i as f64 + 0.5) / 200.0, (2.399_963_229_728_653 * i as f64).sin_cos());
        spatial::Contact::new([area.sqrt() * cos, area.sqrt() * sin, 0.0], [0.0, 0.0, 1.0])
            .series_stiffness(1.0, 0.8)
            .friction(0.3)
            .command([1.0 - area, 0.0, 0.0])
    };
    let disc = spatial::Grasp::new((0..200).map(spring)).expect("a disc");
    let pressed: f64 = (0..200).map(|i| 1.0 - (f64::from(i) + 0.5) / 200.0).sum();
    let pull = |[x, turn]: [f64; 2]| {
        spatial::Wrench::new([x * 0.3 * pressed, 0.0, -pressed], [0.0, 0.0, turn * 0.3 * pressed])
    };
    let cycle = [[0.5, 0.2], [-0.3, 0.2], [0.0, 0.0]].map(|part| spatial::Leg::load_to(pull(part)));
    let mut path = disc.follow_in_steps(pull([0.0; 2]), &cycle, 1e-3).expect("a program");
    path.by_ref().for_each(drop);
    let mut steps = 0;
    for round in 0..4 {
        let counted = measure(|| {
            path.continue_with(&cycle).expect("more of it");
            steps += path.by_ref().count();
        });
        assert!(round == 0 || counted.count_total == 0, "{counted:?} in round {round}");
    }
    assert!(path.end().is_some_and(|end| matches!(end, spatial::PathEnd::Completed)));
    assert!(steps > 100, "{steps}");
}
