//! Friction and the load of each support, from the pushes of one surface and one layout.

use std::error::Error;

use grasp_lcp::identify::{Identified, Identify, Slip, Unknown};
use grasp_lcp::nalgebra::Vector2;
use grasp_lcp::spatial::{Grasp, Wrench};
use support::measured_pushes::{
    LAYOUTS, Push, SURFACES, Together, WEIGHT, blocks, normal_forces, pushes, supports,
};

/// Groupings of pushes that are compared; the estimates with the first one are printed.
const GROUPINGS: [(Option<Together>, &str); 5] = [
    (Some(Together::Direction(30.0)), "directions of 30°"),
    (None, "each for itself"),
    (Some(Together::Direction(15.0)), "directions of 15°"),
    (Some(Together::Direction(45.0)), "directions of 45°"),
    (Some(Together::SideAndFinger), "side, finger sticks or slides"),
];

/// Identifies friction and the three support loads from pushes; `load` and `together` give the load and the group of each.
pub(crate) fn identified(
    block: &Grasp,
    own: &[&Push],
    load: &dyn Fn(&Push) -> Wrench,
    together: Option<Together>,
) -> Result<Identified, grasp_lcp::Error> {
    let slip = |push: &&Push| {
        let slip = Slip::gross(load(push));
        together.into_iter().fold(slip, |slip, together| slip.in_group(together.group(push)))
    };
    let carried = (0..3).map(|k| Unknown::carried().of_contacts([k]).starting_at(WEIGHT / 3.0));
    let unknowns = std::iter::once(Unknown::friction().starting_at(0.3)).chain(carried);
    block.identify(&Identify::new(unknowns, own.iter().map(slip)).knowing(1..4, WEIGHT, 1e-3))
}

/// A push in the plane of the supports.
pub(crate) fn in_the_plane(push: &Push) -> Wrench {
    Wrench::new([push.load.x, push.load.y, 0.0], [0.0, 0.0, push.load.z])
}

/// Numbers of support loads: of all that the pushes determine, of those within two standard errors of the load by statics, and of those whose
/// interval contains the load by statics.
#[derive(Default)]
pub(crate) struct Within {
    pub(crate) all: usize,
    pub(crate) two_errors: usize,
    pub(crate) interval: usize,
    /// Standard errors relative to the standard errors from ungrouped slips; degrees of freedom.
    wider: Vec<f64>,
    degrees: Vec<f64>,
}

impl Within {
    /// Counts the loads of a layout, and compares their standard errors with the standard errors from ungrouped slips, `beside`.
    pub(crate) fn count(&mut self, found: &Identified, layout: usize, beside: &Identified) {
        let loads = found.estimates[1..].iter().zip(&beside.estimates[1..]);
        for ((load, plain), truth) in loads.zip(normal_forces(&supports(layout))) {
            let (Some(error), Some([low, high])) = (load.standard_error, load.interval) else { continue };
            self.all += 1;
            self.two_errors += usize::from((load.value - truth).abs() <= 2.0 * error);
            self.interval += usize::from(low <= truth && truth <= high);
            self.wider.extend(plain.standard_error.map(|plain| error / plain));
            self.degrees.extend(load.degrees_of_freedom);
        }
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Prints the results of all surfaces, with this number of layouts of each.
pub(crate) fn of_pushes(layouts: usize) -> Result<(), Box<dyn Error>> {
    let (blocks, pushes) = (blocks()?, pushes()?);
    println!(
        "\nLoads of supports in N, from 50 measured pushes each, the block weighed, pushes in one direction of 30° as a group; so many standard errors from what statics says:\n"
    );
    println!(
        "{:<11}{:<8}{:>16}   {:<28}{:<28}{:<28}{:>9}{:>14}",
        "", "", "friction", "first", "second", "third", "scatter", "centre (mm)"
    );
    let mut within: [Within; GROUPINGS.len()] = Default::default();
    for surface in SURFACES {
        for (layout, block) in blocks.iter().enumerate().take(layouts) {
            let own: Vec<_> = pushes.iter().filter(|p| p.surface == surface && p.layout == layout).collect();
            let plain = identified(block, &own, &in_the_plane, None)?;
            for (k, ((together, _), within)) in GROUPINGS.iter().zip(&mut within).enumerate() {
                let grouped = together.map(|together| identified(block, &own, &in_the_plane, Some(together)));
                let grouped = grouped.transpose()?;
                let found = grouped.as_ref().unwrap_or(&plain);
                within.count(found, layout, &plain);
                if k == 0 {
                    told(surface, layout, found);
                }
            }
        }
    }
    println!("\nThe centre is that of mass, which these loads balance, from where it was said to be.\n");
    println!(
        "{:<32}{:>14}{:>14}{:>16}{:>20}",
        "pushes taken together", "within 2 σ", "in their 95 %", "σ, times plain", "degrees of freedom"
    );
    for ((_, name), within) in GROUPINGS.iter().zip(within) {
        println!(
            "{name:<32}{:>8} of {:<3}{:>8} of {:<3}{:>16.2}{:>20.1}",
            within.two_errors,
            within.all,
            within.interval,
            within.all,
            median(within.wider),
            median(within.degrees)
        );
    }
    Ok(())
}

fn told(surface: &str, layout: usize, found: &Identified) {
    let mut loads = Vec::new();
    for (load, truth) in found.estimates[1..].iter().zip(normal_forces(&supports(layout))) {
        loads.push(match load.standard_error {
            Some(error) => {
                format!("{:.2} ± {error:.2} of {truth:.2} ({:+.1})", load.value, (load.value - truth) / error)
            }
            None => format!("not fixed, of {truth:.2}"),
        });
    }
    let mu = &found.estimates[0];
    let friction =
        mu.standard_error.map_or("not fixed".to_owned(), |error| format!("{:.4} ± {error:.4}", mu.value));
    let scatter = found.scatter.map_or(String::new(), |scatter| format!("{:.1} %", 100.0 * scatter));
    // The loads balance the weight at its centre.
    let moments = supports(layout).into_iter().zip(&found.estimates[1..]);
    let centre: Vector2<f64> = moments.map(|(at, load)| at * (1e3 * load.value / WEIGHT)).sum();
    println!(
        "{surface:<11}{:<8}{friction:>16}   {:<28}{:<28}{:<28}{scatter:>9}{:>8.1}, {:.1}",
        LAYOUTS[layout].0, loads[0], loads[1], loads[2], centre.x, centre.y
    );
    for combination in &found.free {
        println!("{:19}{}", "", combination.says);
    }
}
