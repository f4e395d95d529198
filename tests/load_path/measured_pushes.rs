//! For each of 400 measured pushes of a block on three supports, the limit load of a load path gives the coefficient of friction. It agrees with the
//! coefficient that another method found.

use support::Failure;
use support::measured_pushes::{blocks, limit, normal_forces, pushes, supports};

#[test]
fn each_push_tells_the_coefficient_found_elsewhere() -> Result<(), Failure> {
    let (blocks, pushes) = (blocks()?, pushes()?);
    assert_eq!(pushes.len(), 400);
    for (number, push) in pushes.iter().enumerate() {
        let told = 1.0 / limit(&blocks, push)?.factor;
        // The other method used loads of the supports that were rounded to 0.01 N, with a sum of 14.88 N.
        assert!((told / push.friction - 1.0).abs() <= 3e-4, "{number}: {told} {}", push.friction);
    }
    Ok(())
}

/// The loads of the supports as stated by the experimenters, N.
#[test]
fn supports_carry_what_is_stated() {
    let stated = [[2.12, 6.38, 6.38], [4.96; 3], [4.96; 3], [3.72, 7.44, 3.72]];
    for (layout, stated) in stated.iter().enumerate() {
        let found = normal_forces(&supports(layout));
        assert!(found.iter().zip(stated).all(|(a, b)| (a - b).abs() < 0.01), "{found:?} {stated:?}");
    }
}
