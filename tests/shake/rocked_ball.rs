//! A roller that is rocked to and fro on a plane under a shear force rests up to the limit `Q* = 1 - 3 w / 2 + w³ / 2`, in units of μ P. Here w is
//! the rocking distance divided by the half width of the contact.
//!
//! The contact is a row of springs under a parabolic pressure, and the computed limit converges to Q* as springs are added. A cycle shifts the
//! pressure by w to either side. A spring that loses contact forgets its shear, so only springs that are always pressed resist it.

use support::shaken::roller_rests_up_to;

#[test]
fn it_rests_below_the_limit_and_walks_above() -> Result<(), grasp_lcp::Error> {
    for w in [0.1, 0.2, 0.3_f64] {
        let limit = 1.0 - 1.5 * w + 0.5 * w.powi(3);
        let found = roller_rests_up_to(81, w)?.expect("decided");
        assert!((found - limit).abs() < 4e-3 * limit, "w = {w}: {found}, {limit}");
    }
    Ok(())
}
