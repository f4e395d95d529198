//! Measured grips and rules of manufacturers, compared with the least squeeze that `need` finds.
//!
//! `cargo run --release -p reports --bin measured_grips`
//!
//! **Pinches.** Buchholz, Frederick and Armstrong (*An investigation of human palmar skin friction and the effects of materials, pinch force and
//! moisture*, Ergonomics 31, 1988, 317–325): seven people pinched a dynamometer between two fingers with 19.6 N or 39.2 N until it slipped out. It
//! was covered with seven materials (summary: cdc.gov, NIOSHTIC-2 no. 00180748). The coefficients, with standard deviations, are those that one of
//! the authors has published (websites.umich.edu/~tja/frictionDataMethods.html). Their means are over both forces, though friction of skin falls with
//! force, as the authors also found. The table does not say how much of the deviation this causes.
//!
//! **Makers' rules.** Robotiq (Hand-E, instruction manual, 6 *Payload and force*): W = 2 F μ / S, with S = 2.4 and μ = 0.3 in its example of silicone
//! on oily steel: 32.5 N for 130 N. IAI (RCP2 grippers, technical reference 74, *Selection guide*): the sum of all forces at least 10 to 20 times the
//! weight, from μ = 0.1 to 0.2 and a factor of 2; 30 to 50 times if it is accelerated.
//!
//! **Left out.** *A model to predict minimum required clamp pre-loads in light of fixture–workpiece compliance* (Int. J. of Machine Tools and
//! Manufacture 41, 2001). According to its summary its linear model needs 7 % more on average than was measured. No available source has the
//! geometry, loads and compliances of these tests, so none of them is computed here.

use std::error::Error;

use grasp_lcp::need::{Amount, Need};
use grasp_lcp::planar::{Contact, Grasp, Wrench};

/// Materials, dry or moist or both, with mean and standard deviation of μ. For dry paper the published deviation is 0.0.
const SKIN: [(&str, f64, f64); 10] = [
    ("sandpaper #320", 0.61, 0.10),
    ("smooth vinyl", 0.53, 0.18),
    ("textured vinyl", 0.50, 0.11),
    ("adhesive tape, dry", 0.41, 0.10),
    ("adhesive tape, moist", 0.66, 0.14),
    ("suede, dry", 0.39, 0.06),
    ("suede, moist", 0.66, 0.11),
    ("aluminium", 0.38, 0.13),
    ("paper, dry", 0.27, 0.0),
    ("paper, moist", 0.42, 0.07),
];
/// Pinch forces, N.
const PINCHES: [f64; 2] = [19.6, 39.2];
/// Standard gravity, m/s².
const G: f64 = 9.806_65;

fn main() -> Result<(), Box<dyn Error>> {
    pinches()?;
    robotiq()?;
    multiples_of_the_weight()
}

/// Two fingers that each press with `press`, N.
fn pinch(friction: f64, press: f64) -> Result<Grasp, grasp_lcp::Error> {
    let finger = |x: f64| {
        // Slips do not depend on the stiffness, but softer points would buckle under these forces.
        let finger = Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(2e4, 1.5e4);
        finger.friction(friction).pressed_with(press)
    };
    Grasp::new([finger(-0.02), finger(0.02)])
}

/// The force with which each finger must press, N: with the given friction, and with friction reduced by the fraction `less`.
fn needed(grasp: &Grasp, press: f64, load: f64, less: f64) -> Result<[f64; 2], Box<dyn Error>> {
    let need = Need::squeeze(Wrench::force([0.0, -load])).if_lower_by(less, 0.0);
    let needed = grasp.need(&need)?;
    let bound = |amount: Option<&Amount>| amount.and_then(Amount::bound).ok_or_else(|| needed.to_string());
    let amount = bound(Some(&needed.amount))?;
    let safe = if less > 0.0 { bound(needed.safe.as_ref())? } else { amount };
    Ok([press * amount, press * safe])
}

fn lost_at(grasp: &Grasp) -> Result<f64, Box<dyn Error>> {
    let verdict = grasp.hold(Wrench::force([0.0, -1.0]))?;
    Ok(verdict.lost.as_ref().ok_or_else(|| verdict.to_string())?.factor)
}

fn pinches() -> Result<(), Box<dyn Error>> {
    println!(
        "A pinch of skin on seven materials: the load at which it slips, and what each finger has to press with for half a kilogram\n"
    );
    println!(
        "{:<22}{:>14}{:>12}{:>12}{:>12}{:>14}{:>22}",
        "", "μ", "19.6 N (N)", "39.2 N (N)", "needs (N)", "μ 10 % less", "μ a deviation less"
    );
    for (material, mu, deviation) in SKIN {
        let mut slips = [0.0; 2];
        for (slip, press) in slips.iter_mut().zip(PINCHES) {
            *slip = lost_at(&pinch(mu, press)?)?;
        }
        let grasp = pinch(mu, PINCHES[0])?;
        let [least, tenth] = needed(&grasp, PINCHES[0], 0.5 * G, 0.1)?;
        let [_, low] = needed(&grasp, PINCHES[0], 0.5 * G, deviation / mu)?;
        println!(
            "{material:<22}{:>14}{:>12.1}{:>12.1}{least:>12.2}{tenth:>14.2}{low:>22.2}",
            format!("{mu:.2} ± {deviation:.2}"),
            slips[0],
            slips[1]
        );
    }
    println!(
        "\nSlips are 2 μ P, the formula by which the coefficients were measured: no prediction. The last columns are. Ten percent cover less than one standard"
    );
    println!("deviation of any of these materials but dry paper, of which none is told.\n");
    Ok(())
}

/// Computes the example of Robotiq's manual: jaws that press with 130 N, silicone on oily steel.
fn robotiq() -> Result<(), Box<dyn Error>> {
    let (force, mu, factor) = (130.0, 0.3, 2.4);
    let payload = 2.0 * force * mu / factor;
    let grasp = pinch(mu, force)?;
    let lost = lost_at(&grasp)?;
    let [least, safe] = needed(&grasp, force, payload, 0.1)?;
    println!(
        "Robotiq's rule W = 2 F μ / S, its example: F = {force} N, μ = {mu}, S = {factor}: W = {payload:.1} N"
    );
    println!("  lost at {lost:.1} N, {:.2} times that", lost / payload);
    println!(
        "  for {payload:.1} N each jaw needs {least:.1} N, {safe:.1} N if μ is 10 % less; the rule asks for {force} N"
    );
    println!(
        "  so S = {factor} covers friction that is {:.0} % less, or an acceleration of {:.1} g upwards\n",
        100.0 * (1.0 - 1.0 / factor),
        factor - 1.0
    );
    Ok(())
}

/// Rules that ignore friction: the sum of all jaw forces as a multiple of the weight.
fn multiples_of_the_weight() -> Result<(), Box<dyn Error>> {
    println!("Rules of so many times the weight: what two jaws need together, in weights\n");
    println!("{:<8}{:>10}{:>14}{:>22}{:>12}", "μ", "needs", "μ 10 % less", "2 g more, 10 % less", "IAI");
    for mu in [0.1, 0.2, 0.3, 0.5] {
        let grasp = pinch(mu, 1.0)?;
        let [least, safe] = needed(&grasp, 1.0, 1.0, 0.1)?;
        let [_, jerked] = needed(&grasp, 1.0, 3.0, 0.1)?;
        let iai = if mu <= 0.2 { format!("{:.0}", 2.0 / mu) } else { String::new() };
        println!("{mu:<8}{:>10.1}{:>14.1}{:>22.1}{iai:>12}", 2.0 * least, 2.0 * safe, 2.0 * jerked);
    }
    println!(
        "\nIAI's 10 to 20 are for μ = 0.2 to 0.1 and a factor of 2; for what accelerates it asks for 30 to 50. With μ known to 10 % what is needed at rest is"
    );
    println!(
        "1.1 times as much: the rest of a rule's factor is for acceleration, wear, and friction that nobody has measured."
    );
    Ok(())
}
