//! Every equilibrium of several bodies satisfies the balance of each body and the law of each contact.

use grasp_lcp::Settings;
use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::grasp::Wrench;
use nalgebra::SVector;
use proptest::prelude::*;

use support::samples::config;
use support::stacks::{Stack, stack};

/// The answer for a stack, and its load.
fn asked<const D: usize, const C: usize>(
    stack: &Stack<D, C>,
    loaded: usize,
) -> Result<(Grasp<C>, SVector<f64, D>), TestCaseError> {
    let grasp = stack.grasp(loaded);
    let mut push = SVector::<f64, D>::zeros();
    (push[0], push[C - 1]) = (1.5, -1.0);
    let load = Wrench::from_components(push.as_slice());
    // Proofs for piles of many bodies without equilibrium may need too many states; load paths decide these piles below. Equilibria are found
    // quickly.
    let briefly = grasp.with(&Settings::default().with_most_states(2_000));
    if let Outcome::Equilibrium(state) = briefly.solve(load).expect("well posed") {
        let violation = stack.violation(&state, loaded, &push);
        prop_assert!(violation < 1e-12, "solve: {violation:e}");
    }
    Ok((grasp, push))
}

/// Checks the answer and the verdict on a load: the verdict is always decided.
fn satisfies<const D: usize, const C: usize>(
    stack: &Stack<D, C>,
    loaded: usize,
) -> Result<(), TestCaseError> {
    let (grasp, push) = asked(stack, loaded)?;
    let load = Wrench::from_components(push.as_slice());
    let verdict = grasp.hold(load).expect("well posed");
    prop_assert!(verdict.holds().is_some(), "{verdict}");
    if let Some(lost) = &verdict.lost
        && let Some(state) = &lost.state
        && lost.factor > 0.0
    {
        prop_assert_eq!(state.bodies.len(), stack.loads.len());
        // With the slips before the loss, friction forces do not follow from displacements alone. Therefore only the balance of each body is checked.
        let at = push * lost.factor;
        let mut sums = stack.loads.clone();
        sums[loaded] += at;
        for (touch, told) in stack.touches.iter().zip(&state.contacts) {
            let on_body =
                support::scene::wrench::<D, C>(&touch.datum.point, &(touch.datum.frame() * told.force));
            sums[touch.on] += on_body;
            if let Some(against) = touch.against {
                sums[against] -= on_body;
            }
        }
        let size = state.contacts.iter().fold(at.norm(), |most, told| most.max(told.force.norm()));
        for (body, sum) in sums.iter().enumerate() {
            prop_assert!(
                sum.norm() < 1e-12 * size * (1.0 + stack.loads.len() as f64),
                "body {body}: {}",
                sum.norm()
            );
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(config(25))]

    #[test]
    fn two_planar_bodies(stack in stack::<3, 2>(2), loaded in 0..2usize) {
        satisfies(&stack, loaded)?;
    }

    #[test]
    fn three_planar_bodies(stack in stack::<3, 2>(3), loaded in 0..3usize) {
        satisfies(&stack, loaded)?;
    }

    #[test]
    fn four_planar_bodies(stack in stack::<3, 2>(4), loaded in 0..4usize) {
        satisfies(&stack, loaded)?;
    }

    #[test]
    fn two_spatial_bodies(stack in stack::<6, 3>(2), loaded in 0..2usize) {
        satisfies(&stack, loaded)?;
    }

    #[test]
    fn four_spatial_bodies(stack in stack::<6, 3>(4), loaded in 0..4usize) {
        asked(&stack, loaded)?;
    }
}
