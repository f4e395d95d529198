//! Lower bound of the run time of some work on this machine.
//!
//! Work moves bytes and does arithmetic. Each takes at least as long as in a loop that does nothing else, and the longer of the two times is the lower
//! bound. Bytes are those of data and answers, each counted once. Operations are the additions, multiplications, divisions and roots of the
//! formulas. Comparisons, selections and integer operations are not counted, and a division counts like a product, so that the true limit is higher.

use std::hint::black_box;

use rayon::prelude::*;

use support::best_time::best;

/// Bytes and operations of some work.
pub struct Needs {
    /// Bytes of data and answers.
    pub bytes: f64,
    /// Bytes of all data that the work touches before it returns to the first; their number decides which level of memory holds them.
    pub among: f64,
    /// Operations in floating point.
    pub operations: f64,
    pub cores: Cores,
}

#[derive(Clone, Copy)]
pub enum Cores {
    One,
    All,
}

/// The least time for some work.
#[derive(Clone, Copy)]
pub struct Limit {
    /// Time, s.
    pub time: f64,
    /// Which of both determines the bound, memory or arithmetic.
    pub by: &'static str,
}

impl Limit {
    /// Measures this machine, and returns the least time of the work.
    pub fn of(needs: &Needs) -> Self {
        let memory = needs.bytes / bandwidth(needs.among, needs.cores);
        let arithmetic = needs.operations / peak(needs.cores);
        if memory > arithmetic {
            Self { time: memory, by: "memory" }
        } else {
            Self { time: arithmetic, by: "arithmetic" }
        }
    }
}

/// Prints the measured speeds from which limits are made.
pub fn print_machine() {
    for (cores, name) in [(Cores::One, "one core"), (Cores::All, "all cores")] {
        let [near, far] = [1e6, 1e8].map(|among| 1e-9 * bandwidth(among, cores));
        let peak = 1e-9 * peak(cores);
        println!(
            "this machine, {name}: {peak:.0}e9 products and sums a second, {near:.0} GB/s read from 1 MB, {far:.0} GB/s from 100 MB"
        );
    }
}

/// Bytes per second if `among` bytes are read again and again. For all cores the result is at least that of one core, on which small work stays.
fn bandwidth(among: f64, cores: Cores) -> f64 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a length
    let array = vec![1.0_f64; (among / 8.0).max(1024.0) as usize];
    let mut time = best(|| _ = black_box(sum(black_box(&array))));
    if matches!(cores, Cores::All) {
        let part = array.len().div_ceil(4 * rayon::current_num_threads());
        time = time.min(best(|| _ = black_box(black_box(&array).par_chunks(part).map(sum).sum::<f64>())));
    }
    8.0 * array.len() as f64 / time
}

/// Sums 32 separate parts, so that no addition waits for another.
fn sum(array: &[f64]) -> f64 {
    let mut sums = [0.0; 32];
    wide(|| {
        for chunk in array.as_chunks::<32>().0 {
            for (sum, x) in sums.iter_mut().zip(chunk) {
                *sum += x;
            }
        }
    });
    sums.iter().sum()
}

/// Multiplications and additions per second: polynomials of degree four at many independent places in the nearest memory.
fn peak(cores: Cores) -> f64 {
    const PLACES: usize = 512;
    const ROUNDS: usize = 2000;
    let work = || {
        let places: [f64; PLACES] = black_box(std::array::from_fn(|k| 1e-3 * k as f64));
        let coefficients = black_box([0.5, 0.25]);
        let mut values = [0.0; PLACES];
        for _ in 0..ROUNDS {
            polynomials(&places, &mut values, coefficients);
            black_box(&mut values);
        }
    };
    let each = (8 * PLACES * ROUNDS) as f64;
    match cores {
        Cores::One => each / best(work),
        Cores::All => {
            let threads = rayon::current_num_threads();
            each * threads as f64 / best(|| (0..threads).into_par_iter().for_each(|_| work()))
        }
    }
}

#[inline(never)]
fn polynomials<const N: usize>(places: &[f64; N], values: &mut [f64; N], [a, b]: [f64; 2]) {
    wide(|| {
        for (value, x) in values.iter_mut().zip(places) {
            *value = (((a * x + b) * x + a) * x + b) * x + a;
        }
    });
}

/// Runs a loop that is compiled for the vector registers that the crate uses.
#[cfg(feature = "simd")]
fn wide(work: impl FnOnce()) {
    struct Wide<W>(W);
    impl<W: FnOnce()> pulp::NullaryFnOnce for Wide<W> {
        type Output = ();
        #[inline(always)]
        fn call(self) {
            (self.0)();
        }
    }
    pulp::Arch::new().dispatch(Wide(work));
}

#[cfg(not(feature = "simd"))]
fn wide(work: impl FnOnce()) {
    work();
}
