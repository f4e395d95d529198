//! Frictional contact problems (W, q, μ): the round cone compared with polygons, hard families, and files of Siconos.
//!
//! | command | prints |
//! |---|---|
//! | `cargo run --release -p reports --bin friction_problems` | error of polygons in Coulomb's law, and their time; unsolved problems with unequal masses |
//! | `… -- --each 10000` | the same with 10 000 problems of each family |
//! | `… -- FILE…` | residual and time for files of Siconos; files that begin with `G` include masses |
//! | `SICONOS="/usr/bin/python3 python/examples/siconos_times.py" … -- FILE…` | the same, and results of Siconos itself in the same run |

mod families;
mod files;
mod polygons;

use std::time::Instant;

fn main() -> Result<(), support::Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match &arguments[..] {
        [] => {
            polygons::print();
            families::print(2000);
        }
        [flag, each] if flag == "--each" => families::print(each.parse()?),
        names => files::print(names)?,
    }
    Ok(())
}

/// Time of some work in milliseconds, and its result.
fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let out = work();
    (start.elapsed().as_secs_f64() * 1e3, out)
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
