//! Run time of gradients relative to that of values.

use grasp_lcp::screening::ScreenedGradients;
use grasp_lcp::spatial::{Batch, Fingers, Pull, Wrench};
use grasp_lcp::sweep::{onset_gradients_of_batch, onsets_of_batch};
use nalgebra::Vector3;
use support::best_time::best_in_turns;

use super::{CHUNK, Cloud, Random, finger, sample, weight};

/// Number of chunks of grasps that are timed: enough to occupy all threads evenly, few enough that memory bandwidth has no effect.
const CHUNKS: usize = 16;

/// Prints the throughput of gradients of grasps on a cloud, also as a ratio to that of factors.
pub(crate) fn print_cost(cloud: &Cloud) -> Result<(), Box<dyn std::error::Error>> {
    let mut random = Random(1);
    let mut batch = Batch::<3>::with_capacity(CHUNKS * CHUNK);
    for _ in 0..CHUNKS * CHUNK {
        batch.push(&Fingers::new(&sample(cloud, &mut random).map(|i| finger(&cloud[i])))?);
    }
    let pull = [Pull::new(&Wrench::ZERO, &weight(-Vector3::z()))?];
    let (mut onsets, mut gradients) = (Vec::new(), ScreenedGradients::new());
    let [values, slopes] = best_in_turns([
        &mut || {
            onsets_of_batch(&batch, &pull, &mut onsets);
            Ok(())
        },
        &mut || {
            onset_gradients_of_batch(&batch, &pull, &mut gradients);
            Ok(())
        },
    ])?;
    let rate = |seconds: f64| batch.len() as f64 / seconds * 1e-6;
    println!(
        "  one load: {:.1} million onsets a second, {:.2} million of them with all {} derivatives: {:.2} times the price",
        rate(values),
        rate(slopes),
        ScreenedGradients::<3>::width(3) - 4,
        slopes / values
    );
    Ok(())
}
