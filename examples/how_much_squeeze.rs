//! How hard must fingers press so that nothing slides, whatever the load does?
//!
//! `cargo run --profile quick -p grasp-lcp --example how_much_squeeze`

use grasp_lcp::planar::{Contact, Grasp, LeastSqueeze, Loads, Turn, WeakestDirection, Wrench};

fn main() -> Result<(), grasp_lcp::Error> {
    // The thumb presses with 1 N, so that the factor of the squeeze is its force in newtons.
    let finger = |x: f64, y: f64, side: f64, share: f64| {
        Contact::new([x, y], [-side, 0.0]).series_stiffness(2e3, 1.5e3).friction(0.5).pressed_with(share)
    };
    let fingers =
        [finger(-0.04, 0.02, -1.0, 0.5), finger(-0.04, -0.02, -1.0, 0.5), finger(0.04, 0.0, 1.0, 1.0)];
    let grasp = Grasp::new(fingers)?;
    let (weight, centre) = ([0.0, -4.9], [0.0, 0.005]);

    let carried = Loads::Each(vec![Wrench::force_at(weight, centre)]);
    let turned_over = Loads::Turn(Turn::tilting(weight, centre));
    let pushed = Loads::AnyForce { base: Wrench::force_at(weight, centre), size: 2.0, point: centre };
    for (what, loads) in [("carried", carried), ("turned over", turned_over), ("pushed with 2 N", pushed)] {
        match grasp.least_squeeze(&loads)? {
            LeastSqueeze::Factor { factor, .. } => {
                println!("{what}: the thumb must press with {factor:.6} N");
            }
            other => println!("{what}: {other:?}"),
        }
    }

    // If the thumb presses with 20 N, which is the least force, in addition to the weight, that makes a finger slide?
    let strong =
        Grasp::new(grasp.contacts().iter().cloned().zip([10.0, 10.0, 20.0]).map(|(c, n)| c.pressed_with(n)))?;
    let base = Wrench::force_at(weight, centre);
    if let WeakestDirection::Force { size, direction: [x, y], .. } = strong.weakest_direction(base, centre)? {
        println!("with 20 N the weakest push is {size:.6} N along ({x:.4}, {y:.4})");
    }
    Ok(())
}
