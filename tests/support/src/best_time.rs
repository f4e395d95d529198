//! The shortest of several times: what a call takes when nothing else disturbs it.
//!
//! Whoever wants to know whether a report runs, and not how long it takes, says `ONE_CALL=1` in its environment: then nothing is repeated.

use std::hint::black_box;
use std::time::{Duration, Instant};

use crate::Failure;

/// Each call is repeated for so long, and its shortest time taken.
const PATIENCE: Duration = Duration::from_millis(60);
/// Longer ones at least so often, unless that takes longer than [`AT_MOST`].
const REPEATS: u32 = 3;
const AT_MOST: Duration = Duration::from_secs(1);

/// How often a call is to be repeated: as told, or not at all.
pub fn repeats(told: u32) -> u32 {
    if std::env::var_os("ONE_CALL").is_some() { 1 } else { told }
}

/// A value and the time it took, s.
pub fn once<T>(mut call: impl FnMut() -> Result<T, Failure>) -> Result<(T, f64), Failure> {
    let start = Instant::now();
    let value = black_box(call()?);
    Ok((value, start.elapsed().as_secs_f64()))
}

/// A value and the shortest of several times, s.
pub fn timed<T>(mut call: impl FnMut() -> Result<T, Failure>) -> Result<(T, f64), Failure> {
    let start = Instant::now();
    let (mut value, mut best) = once(&mut call)?;
    let (least, mut calls) = (repeats(REPEATS), 1);
    while least > 1 && (start.elapsed() < PATIENCE || (calls < least && start.elapsed() < AT_MOST)) {
        let (next, time) = once(&mut call)?;
        (value, best) = (next, best.min(time));
        calls += 1;
    }
    Ok((value, best))
}

/// The shortest of several times of what cannot fail, s.
pub fn best(mut call: impl FnMut()) -> f64 {
    let timed = timed(|| {
        call();
        Ok(())
    });
    timed.map_or(f64::NAN, |((), time)| time)
}

/// The shortest times, s, of several calls made in turns, so that whatever else the machine does slows all of them.
pub fn best_in_turns<const N: usize>(
    mut calls: [&mut dyn FnMut() -> Result<(), Failure>; N],
) -> Result<[f64; N], Failure> {
    let mut best = [f64::INFINITY; N];
    let start = Instant::now();
    loop {
        for (best, call) in best.iter_mut().zip(&mut calls) {
            *best = best.min(once(call)?.1);
        }
        if repeats(REPEATS) == 1 || start.elapsed() >= PATIENCE {
            return Ok(best);
        }
    }
}
