//! The second grasp of the paper "Position Control for Multifingered Robot Hand" under a growing load, by complementarity and by the paper's
//! quadratic program. Both agree while everything sticks; beyond the first slip the minimum of the program is no equilibrium.
//!
//! `cargo run --release -p reports --bin compare_with_energy_qp`

use grasp_lcp::Settings;
use grasp_lcp::energy::Agreement;
use grasp_lcp::picture::{Chart, Stroke};
use grasp_lcp::planar::{Grasp, Ramp, Wrench};
use support::interior_point::{Oracle, interior_point};
use support::minimum_power::minimum_power;
use support::paper::{TWO_FINGER_TABLE, down, printed_contacts, two_fingers, two_fingers_on_rests};
use support::printed_program::PrintedProgram;

type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

fn main() -> Result<()> {
    let grasp = two_fingers()?;
    let onset = grasp.onset(down())?.factor().ok_or("has an onset")?;
    along_the_load(&grasp, onset)?;
    power()?;
    picture(&grasp, onset)
}

fn along_the_load(grasp: &Grasp, onset: f64) -> Result<()> {
    let settings = Settings::default();
    println!("Finger 1 of the paper's second example under a growing load W along -y (N)\n");
    println!("          complementarity       quadratic program     difference   the program");
    println!("   W        F_n       F_t         F_n       F_t      (relative)   misses W by     verdict");
    let (mut printed_off, mut interior_off) = (0.0_f64, 0.0_f64);
    for row in TWO_FINGER_TABLE {
        let load = down() * row[0];
        let comparison = grasp.energy().compare(load)?;
        let minimum = comparison.minimum.minimum().ok_or("the program has a minimum")?;
        print!("{:5.2}", row[0]);
        match comparison.equilibrium.equilibrium() {
            Some(state) => print!("   {:.6} {:9.6}", state.contacts[0].force[0], state.contacts[0].force[1]),
            None => print!("   no equilibrium    "),
        }
        let force = minimum.contacts[0].force;
        print!("    {:.6} {:9.6}", force[0], force[1]);
        match comparison.difference {
            Some(difference) => print!("     {:7.0e}   ", difference.relative()),
            None => print!("        -      "),
        }
        println!("   {:.6}       {}", minimum.out_of_balance().0, comparison);

        // The quadratic program as printed in the paper, with all displacements as unknowns, solved by Lemke's method and by an interior-point
        // method.
        let printed = PrintedProgram::of(grasp, &printed_contacts(grasp), &load, &settings.cone);
        let lemke = printed.program.solve()?.ok_or("no minimum")?;
        let Oracle::Minimum(interior, _) = interior_point(&printed.program) else {
            return Err("the interior-point method finds no minimum".into());
        };
        for (i, c) in minimum.contacts.iter().enumerate() {
            printed_off = printed_off.max((printed.force(&lemke.x, i) - c.force).norm());
            interior_off = interior_off.max((printed.force(&interior, i) - c.force).norm());
        }
    }
    println!(
        "\nThe program as printed (15 unknowns), largest difference of a force: {printed_off:.0e} N by Lemke's"
    );
    println!(
        "method on its optimality conditions, below {:.0e} N by an interior-point method",
        ceil(interior_off)
    );
    let ends = grasp.with(&settings).energy().agreement(Ramp::load(Wrench::ZERO, down()))?;
    let Agreement::UpTo { factor, .. } = ends else { return Err("the agreement ends".into()) };
    println!("\nfirst friction constraint binds at W = {factor:.15}");
    println!("onset of sliding, found directly   W* = {onset:.15}");
    Ok(())
}

/// Rounds a difference up to a power of ten, since digits below the tolerance of an iterative method have no meaning.
fn ceil(x: f64) -> f64 {
    10f64.powf(x.log10().ceil())
}

/// Compares the friction forces of the minimum power principle with those of Coulomb's law. Two fingers slide over an object that settles on soft
/// rests. The principle needs the normal forces as data.
fn power() -> Result<()> {
    println!(
        "\nMinimum power principle, normal forces given: two sliding fingers and soft rests, W = 0.5 N\n"
    );
    println!(
        "  normals    F_n of finger 1 (N)      the principle's F_t is off (N)     its cost, F_n varied,"
    );
    println!("             sticking    Coulomb       first       rounds to 1e-12        has the slope (N)");
    for (slope, name) in [(0.0, "level"), (0.125, "slope 1/8")] {
        let grasp = two_fingers_on_rests(slope)?;
        let load = down() * 0.5;
        let outcome = grasp.solve(load)?;
        let coulomb = outcome.equilibrium().ok_or("holds")?;
        let stuck = Grasp::new(grasp.contacts().iter().enumerate().map(|(i, c)| {
            let c = c.clone();
            if i < 2 { c.friction(f64::INFINITY) } else { c }
        }))?;
        let sticking = stuck.solve(load)?;
        let sticking = sticking.equilibrium().ok_or("holds")?;
        let mut normal: Vec<f64> = sticking.contacts.iter().map(|c| c.force[0]).collect();
        let before = normal[0];
        let (mut first, mut rounds) = (None, 0);
        for round in 1..200 {
            let answer = minimum_power(&grasp, &load, &normal).ok_or("a minimum")?;
            let off = answer
                .forces
                .iter()
                .zip(&coulomb.contacts)
                .map(|(f, c)| (f[1] - c.force[1]).abs())
                .fold(0.0, f64::max);
            first.get_or_insert(off);
            rounds = round;
            if off <= 1e-12 {
                break;
            }
            normal = answer.forces.iter().map(|f| f[0]).collect();
        }
        // The derivative of the friction cost Σ μ F_n |s| with respect to the height y of the object, at Coulomb's equilibrium with the slips s. A
        // cost whose normal forces F_n vary with y would add this force to the balance.
        let added: f64 = grasp
            .contacts()
            .iter()
            .zip(grasp.frames())
            .zip(&coulomb.contacts)
            .map(|((contact, frame), c)| {
                let k = contact.series_stiffness_of_axes()[0];
                -contact.friction_coefficient() * k * frame[(1, 0)] * c.slip[1].abs()
            })
            .sum();
        println!(
            "  {name:9}  {before:.6}   {:.6}      {:.1e}     {rounds:3}                    {added:+.4}",
            coulomb.contacts[0].force[0],
            first.unwrap_or(f64::NAN)
        );
    }
    println!(
        "\n  Level fingers press equally wherever the object goes: the principle is Coulomb's law. On sloping"
    );
    println!("  ones it is so only with the normal forces of the answer, which have to be known before.");
    Ok(())
}

/// Draws the forces of the fingers against the load that they must balance.
fn picture(grasp: &Grasp, onset: f64) -> Result<()> {
    let (mut coulomb, mut program, mut missing) = (vec![], vec![], vec![]);
    for step in 0..=32 {
        let w = if step == 32 { onset } else { 0.005 * f64::from(step) };
        let comparison = grasp.energy().compare(down() * w)?;
        if let Some(state) = comparison.equilibrium.equilibrium() {
            coulomb.push((w, state.contacts.iter().map(|c| c.force_world[1]).sum::<f64>()));
        }
        if let Some(minimum) = comparison.minimum.minimum() {
            program.push((w, minimum.contacts.iter().map(|c| c.force_world[1]).sum::<f64>()));
            missing.push((w, minimum.out_of_balance().0));
        }
    }
    for series in [&mut coulomb, &mut program, &mut missing] {
        series.sort_by(|a: &(f64, f64), b| a.0.total_cmp(&b.0));
    }
    let chart = Chart::new(
        "The paper's second grasp: what the fingers carry of the load",
        "load W (N)",
        "upward force of both fingers (N)",
    )
    .series("Coulomb, complementarity", coulomb, Stroke::Line)
    .series("minimum energy, quadratic program", program, Stroke::Dashed)
    .series("missing to equilibrium in the program", missing, Stroke::Line)
    .mark(onset, "W* = √65/66")
    .shade_from(onset, "no equilibrium");
    println!();
    support::save("compare_with_energy_qp.svg", &chart.to_svg()?)?;
    Ok(())
}
