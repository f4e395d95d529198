//! Residuals of pushes after friction and support loads are identified: are the residuals of pushes in one direction correlated?

use std::error::Error;

use support::measured_pushes::{LAYOUTS, SURFACES, Together, blocks, pushes};

use crate::supports::{identified, in_the_plane};

/// Residuals are clipped at this number of standard deviations, where the Huber loss becomes linear, so that outliers do not dominate.
const CUT: f64 = 2.0;

/// Sums of products of residuals within groups, and of their squares.
#[derive(Default)]
struct Common {
    products: f64,
    pairs: f64,
    squares: f64,
    all: f64,
}

impl Common {
    fn add(&mut self, left: &[f64], groups: &[usize]) {
        for (k, (x, group)) in left.iter().zip(groups).enumerate() {
            (self.squares, self.all) = (self.squares + x * x, self.all + 1.0);
            for (y, _) in left[..k].iter().zip(groups).filter(|(_, other)| *other == group) {
                (self.products, self.pairs) = (self.products + x * y, self.pairs + 1.0);
            }
        }
    }

    /// The correlation of two pushes of a group.
    fn correlation(&self) -> f64 {
        (self.products / self.pairs) / (self.squares / self.all)
    }
}

/// Prints mean residuals by side and finger, and correlations within groups.
pub(crate) fn by_direction(layouts: usize) -> Result<(), Box<dyn Error>> {
    let (blocks, pushes) = (blocks()?, pushes()?);
    println!(
        "\nWhat is left of the pushes, measured over predicted, in percent: the mean by the side that is pushed, and whether the finger slides along it one way, sticks, or slides the other way:\n"
    );
    println!("{:<19}{:>24}{:>24}{:>24}", "", "towards +x", "towards +y", "towards -x and -y");
    let groupings = [
        ("directions of 15°", Together::Direction(15.0)),
        ("directions of 30°", Together::Direction(30.0)),
        ("directions of 45°", Together::Direction(45.0)),
        ("side, finger sticks or slides", Together::SideAndFinger),
    ];
    let mut common: [Common; 4] = Default::default();
    for surface in SURFACES {
        for (layout, (name, _)) in LAYOUTS.iter().enumerate().take(layouts) {
            let own: Vec<_> = pushes.iter().filter(|p| p.surface == surface && p.layout == layout).collect();
            let found = identified(&blocks[layout], &own, &in_the_plane, None)?;
            let scatter = found.scatter.ok_or("a scatter")?;
            let left: Vec<_> =
                found.residuals.iter().map(|r| r.clamp(-CUT * scatter, CUT * scatter)).collect();
            print!("{surface:<11}{name:<8}");
            for side in 0..3 {
                let of_finger = |finger: usize| {
                    let meant = own
                        .iter()
                        .zip(&left)
                        .filter(|(push, _)| Together::SideAndFinger.group(push) == 3 * side + finger);
                    let those: Vec<_> = meant.map(|(_, x)| *x).collect();
                    if those.is_empty() {
                        return "-".to_owned();
                    }
                    format!("{:+.0}", 100.0 * those.iter().sum::<f64>() / those.len() as f64)
                };
                print!("{:>24}", [0, 1, 2].map(of_finger).join(", "));
            }
            println!();
            for ((_, together), common) in groupings.iter().zip(&mut common) {
                let groups: Vec<_> = own.iter().map(|push| together.group(push)).collect();
                common.add(&left.iter().map(|x| x / scatter).collect::<Vec<_>>(), &groups);
            }
        }
    }
    println!("\nThe correlation of what is left of two pushes of one group; independent pushes have none:\n");
    for ((name, _), common) in groupings.iter().zip(common) {
        println!("{name:<32}{:>6.2}", common.correlation());
    }
    Ok(())
}
