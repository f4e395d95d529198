//! Prints all answers, with ten digits of each number: `cargo run --package grasp-lcp-without-std`. The output with `--features std` must agree.

fn main() -> Result<(), grasp_lcp::Error> {
    for asked in grasp_lcp_without_std::ask(200)? {
        let numbers: Vec<_> = asked.numbers.iter().map(|x| format!("{x:.9e}")).collect();
        println!("{}\n{}", asked.sentence, numbers.join(" "));
    }
    Ok(())
}
