//! The shortest of several run times, which is the time of a call without disturbance by other processes.
//!
//! With `ONE_CALL=1` in the environment no call is repeated. That is enough to check that a report runs.

use std::hint::black_box;
use std::time::{Duration, Instant};

use crate::Failure;

/// Each call is repeated for this time.
const PATIENCE: Duration = Duration::from_millis(60);
/// The least number of calls, also of slow ones, unless they take longer than [`AT_MOST`].
const REPEATS: u32 = 3;
const AT_MOST: Duration = Duration::from_secs(1);

/// The number of calls: the given one, or 1 with `ONE_CALL` in the environment.
pub fn repeats(told: u32) -> u32 {
    if std::env::var_os("ONE_CALL").is_some() { 1 } else { told }
}

/// The value of a call and its run time, s.
pub fn once<T>(mut call: impl FnMut() -> Result<T, Failure>) -> Result<(T, f64), Failure> {
    let start = Instant::now();
    let value = black_box(call()?);
    Ok((value, start.elapsed().as_secs_f64()))
}

/// The value of a call and its shortest run time, s.
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

/// The shortest run time of a call that cannot fail, s.
pub fn best(mut call: impl FnMut()) -> f64 {
    let timed = timed(|| {
        call();
        Ok(())
    });
    timed.map_or(f64::NAN, |((), time)| time)
}

/// The shortest run times of several calls, s. The calls are made in turns, so that other load of the machine slows all of them alike.
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
