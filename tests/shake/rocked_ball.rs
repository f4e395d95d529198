//! A roller that is rocked to and fro on a plane under a shear: it rests up to `Q* = 1 - 3 w / 2 + w³ / 2` of μ P, w the rocking over the half width of the contact.
//!
//! Springs under a parabola, as many as there are: what is held at rest grows to that limit as they are refined. A cycle shifts the pressure by w to
//! either side; a spring that is out of touch forgets its shear, so that only those always pressed hold it.

use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};

/// Whether a roller on so many springs comes to rest under this part of μ P, rocked by `w` half widths.
fn rests(springs: i32, w: f64, part: f64) -> Result<Option<bool>, grasp_lcp::Error> {
    // The half width is one; what is pressed in there, 1 mm.
    let (k, depth, mu) = (1e3, 1e-3, 0.4);
    let h = 2.8 / f64::from(springs);
    let spring = |i: i32| {
        let x = h * (f64::from(i) - 0.5 * f64::from(springs - 1));
        Contact::new([x, 0.0], [0.0, 1.0])
            .series_stiffness(k * h, k * h)
            .friction(mu)
            .command([-depth * x * x, 0.0])
    };
    let roller = Grasp::new((0..springs).map(spring))?;
    let pressed = k * depth * 4.0 / 3.0;
    let base = Wrench::new([part * mu * pressed, -pressed], 0.0);
    let cycle = [w, -w].map(|w| Leg::there_and_back(Wrench::new([0.0, 0.0], w * pressed))).concat();
    Ok(roller.shake(&base, &cycle)?.rests())
}

#[test]
fn it_rests_below_the_limit_and_walks_above() -> Result<(), grasp_lcp::Error> {
    for w in [0.1, 0.2, 0.3_f64] {
        let limit = 1.0 - 1.5 * w + 0.5 * w.powi(3);
        let (mut below, mut above) = (0.5 * limit, 1.2 * limit);
        for _ in 0..9 {
            let middle = 0.5 * (below + above);
            match rests(81, w, middle)? {
                Some(true) => below = middle,
                Some(false) => above = middle,
                None => panic!("undecided at {middle}"),
            }
        }
        println!("w = {w}: rests up to {below:.4}, exactly {limit:.4}: {:.3} of it", below / limit);
        assert!(below > 0.96 * limit && above < 1.04 * limit, "w = {w}: {below} to {above}, {limit}");
    }
    Ok(())
}
