//! Both tables of the paper "Position Control for Multifingered Robot Hand", row by row: printed value, computed value,
//! and difference; misprints are marked with *.
//!
//! `cargo run --release -p reports --bin paper_tables`

use grasp_lcp::planar::{Equilibrium, Grasp, Outcome, Wrench};
use support::paper::{
    DISK_FORCES, DISK_RATIOS, TWO_FINGER_MISPRINTS, TWO_FINGER_TABLE, disk, disk_load, down, two_fingers,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    disk_tables()?;
    two_finger_table()
}

fn hold(grasp: &Grasp, load: &Wrench) -> Result<Equilibrium, Box<dyn std::error::Error>> {
    match grasp.solve(load)? {
        Outcome::Equilibrium(state) => Ok(*state),
        other => Err(format!("no equilibrium: {other:?}").into()),
    }
}

fn disk_tables() -> Result<(), Box<dyn std::error::Error>> {
    println!("Example 1: a disk held by three fingers, W = (0.1, 0.2) N, 0.3 N m");
    println!(
        "'as computed': with normals of length 1.0005, as the paper's program had them; 'unit': normalised\n"
    );
    let (computed, unit) = (disk(true)?, disk(false)?);
    let states = (hold(&computed, &disk_load())?, hold(&unit, &disk_load())?);
    let parts = (computed.statics().decompose(&states.0), unit.statics().decompose(&states.1));
    println!(
        "{:14} finger     printed (N)          as computed (N)       difference (1e-4)   unit normals (N)",
        "forces"
    );
    let mut worst = 0.0_f64;
    for (kind, printed) in &DISK_FORCES {
        for (i, print) in printed.iter().enumerate() {
            let pick = |state: &Equilibrium, part: &grasp_lcp::planar::Decomposition| match *kind {
                "contact" => state.contacts[i].force_world,
                "equilibrating" => part.equilibrating[i],
                _ => part.interaction[i],
            };
            let (a, b) = (pick(&states.0, &parts.0), pick(&states.1, &parts.1));
            let (true_value, note) = print.misprint.map_or((print.force, ""), |(note, value)| (value, note));
            let off = [a[0] - true_value[0], a[1] - true_value[1]];
            worst = worst.max(off[0].abs());
            println!(
                "{kind:14} {}   ({:8.4}, {:8.4})   ({:8.4}, {:8.4})   ({:5.1}, {:5.1})   ({:8.4}, {:8.4})  {}{note}",
                i + 1,
                print.force[0],
                print.force[1],
                a[0],
                a[1],
                1e4 * off[0],
                1e4 * off[1],
                b[0],
                b[1],
                if note.is_empty() { "" } else { "* " },
            );
        }
    }
    println!("\nratio F_t / F_n   printed   of the printed forces   as computed   unit normals");
    for (i, (ratio, contact)) in DISK_RATIOS.iter().zip(computed.contacts()).enumerate() {
        let (a, b) = (states.0.contacts[i].ratio(), states.1.contacts[i].ratio());
        // The ratio F_t/F_n of the printed force, with normal and tangent from the contact point; their length cancels.
        let (f, p) = (DISK_FORCES[0].1[i].force, contact.point());
        let of_printed = (-p[1] * f[0] + p[0] * f[1]) / -(p[0] * f[0] + p[1] * f[1]);
        println!(
            "  finger {}        {ratio:8.4}        {of_printed:8.4}            {a:8.4}       {b:8.4}",
            i + 1
        );
    }
    let sum: f64 = DISK_FORCES[0].1.iter().map(|p| p.force[1]).sum();
    let ours: f64 = states.0.contacts.iter().map(|c| c.force_world[1]).sum();
    println!("\nlargest difference in x: {worst:.1e} N (rounding of the print).");
    let dy = states.0.twist.translation()[1];
    println!(
        "* every y of the contact and interaction forces is off by the same 16e-4 N: the printed contact forces"
    );
    println!(
        "  sum to {sum:.4} N in y where the load asks for -0.2 (ours: {ours:.4}). That is dy = {dy:.5} m rounded"
    );
    println!("  to 0.0013, on springs of 50 N/m. The printed ratios are those of the printed forces.\n");
    Ok(())
}

fn two_finger_table() -> Result<(), Box<dyn std::error::Error>> {
    println!("Example 2: two fingers, load W along -y (printed | ours | difference in 1e-4 N)\n");
    println!("   W      F_1n                    F_1t                      F_2n                    F_2t");
    let grasp = two_fingers()?;
    for (index, row) in TWO_FINGER_TABLE.iter().enumerate() {
        print!("{:5.2}", row[0]);
        match grasp.solve(down() * row[0])? {
            Outcome::Equilibrium(state) => {
                for (c, printed) in state.contacts.iter().zip(row[1..].chunks(2)) {
                    for (ours, printed) in [c.normal_force(), c.tangential_force()].into_iter().zip(printed) {
                        print!("  {printed:7.4} | {ours:8.5} | {:4.1}", 1e4 * (ours - printed));
                    }
                }
            }
            _ => {
                for printed in &row[1..] {
                    print!("  {printed:7.4} |     none |     ");
                }
            }
        }
        match TWO_FINGER_MISPRINTS.iter().find(|(at, _)| *at == index) {
            Some((_, note)) => println!("  * {note}"),
            None => println!(),
        }
    }
    println!(
        "\n* the printed normals have slope 1/5; the table was made with slope 1/8, which is used here."
    );
    Ok(())
}
